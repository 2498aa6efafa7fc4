#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

namespace {

// Lengths at scale 1.
constexpr float least_radius = 8, max_radius = 14, least_column = 22, max_column = 140, least_level = 30,
                max_level = 96;

Vec2d to_view(ImVec2 p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

// Black or white, whichever has more contrast with `ground`.
Colour contrasting(Colour ground) {
  const double brightness = 0.299 * ground.r + 0.587 * ground.g + 0.114 * ground.b;
  return brightness > 140 ? Colour{0, 0, 0} : Colour{255, 255, 255};
}

void draw_link(const Ui& ui, const TreeNode& node, ImVec2 from, ImVec2 to) {
  const RayStyle& style = ray_style(ui.state.appearance.theme, node.kind);
  LineItem line;
  line.from = to_view(from);
  line.to = to_view(to);
  const bool lit = node.current || node.hovered;
  line.stroke = {node.future ? ui.colours.grid : style.colour, static_cast<double>(ui.px(lit ? 3.2f : 2)), style.dash,
                 0};
  for (double& part : line.stroke.dash.lengths) part *= static_cast<double>(ui.unit);
  paint_line(*ImGui::GetWindowDrawList(), line);
}

void draw_text(const Ui& ui, ImFont* font, ImVec2 middle, Colour colour, const std::string& text, float max_width,
               Colour ground = {0, 0, 0, 0}) {
  if (text.empty()) return;
  push_font(font);
  const std::string what = shortened(text, max_width);
  const ImVec2 extent = ImGui::CalcTextSize(what.c_str());
  const float width = extent.x, left = middle.x - width / 2;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (ground.a > 0) {
    draw.AddRectFilled({left - ui.px(3), middle.y - extent.y / 2}, {left + width + ui.px(3), middle.y + extent.y / 2},
                       to_imgui(ground), ui.px(3));
  }
  draw.AddText({std::round(left), std::round(middle.y - extent.y / 2)}, to_imgui(colour), what.c_str());
  pop_font();
}

// Distances between neighbours and the size of a node, in units.
struct Spacing {
  float column, level, radius;
};

// A disc in the returned colour, ringed in the colour of the ray's kind; a stub is a square, a future ray an outline.
void draw_node(const Ui& ui, const TreeNode& node, ImVec2 at, const Spacing& spacing) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float r = spacing.radius;
  const ImU32 ring = to_imgui(node.future ? ui.colours.dim_text.with_alpha(130) : node.colour);
  if (node.current || node.hovered)
    draw.AddCircleFilled(at, r + ui.px(5),
                         to_imgui((node.current ? ui.colours.selected : ui.colours.hovered).with_alpha(150)));
  const Colour ground = node.returned ? node.shade : ui.colours.panel;
  if (node.formed) {
    draw.AddCircleFilled(at, r, to_imgui(ground));
    draw.AddCircle(at, r, ring, 0, ui.px(node.future ? 1.2f : 3));
  } else {
    const float half = r * 0.8f;
    draw.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, to_imgui(ui.colours.panel));
    draw.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, ring, ui.px(2), 0,
                 ui.px(node.future ? 1.2f : 2.4f));
  }
  draw_text(ui, r < ui.px(12) ? ui.fonts.small : ui.fonts.strong, at,
            node.returned ? contrasting(ground) : ui.colours.text, node.symbol, 2 * r);
}

// The middle of a label of this size by the node at `at`: below it, unless that covers more nodes, or more of the
// pane's border, than a place on another side. `seen`: the visible part of the tree.
ImVec2 label_place(const Ui& ui, ImVec2 at, ImVec2 half, float r, const Rect& seen, const std::vector<ImVec2>& nodes) {
  const float beside = r + ui.px(8) + half.x, below = r + ui.px(12);
  ImVec2 best = at;
  float least = -1;
  for (const ImVec2 way : {ImVec2{0, below}, {beside, 0}, {-beside, 0}, {0, -below}}) {
    ImVec2 middle{at.x + way.x, at.y + way.y};
    if (way.x == 0) middle.x = std::clamp(middle.x, seen.x + half.x, std::max(seen.x + half.x, seen.right() - half.x));
    const float beyond = std::max({seen.x - middle.x + half.x, middle.x + half.x - seen.right(), 0.0f}) +
                         std::max({seen.y - middle.y + half.y, middle.y + half.y - seen.bottom(), 0.0f});
    float covered = 2 * beyond;
    for (const ImVec2& node : nodes)
      covered += std::max(half.x + r - std::abs(node.x - middle.x), 0.0f) > 0
                     ? std::max(half.y + r - std::abs(node.y - middle.y), 0.0f)
                     : 0;
    if (least >= 0 && covered >= least) continue;
    best = middle;
    least = covered;
  }
  return best;
}

// What it hit, below it, if there is room; always for the current one.
void draw_label(const Ui& ui, const TreeNode& node, ImVec2 at, const Spacing& spacing, const Rect& seen,
                const std::vector<ImVec2>& nodes) {
  const float r = spacing.radius, column = spacing.column;
  if (node.future || node.label.empty()) return;
  const bool whole = node.current || node.hovered;
  if (!whole && (column < ui.px(64) || spacing.level < ui.px(58))) return;
  const float room = whole ? std::min(ui.px(320), seen.width - ui.px(8)) : column - ui.px(6);
  ImVec2 middle{at.x, at.y + r + ui.px(12)};
  if (whole) {
    push_font(ui.fonts.small);
    const ImVec2 extent = ImGui::CalcTextSize(node.label.c_str());
    pop_font();
    middle = label_place(ui, at, {std::min(extent.x, room) / 2 + ui.px(4), extent.y / 2}, r, seen, nodes);
  }
  draw_text(ui, ui.fonts.small, middle, ui.colours.dim_text, node.label, room, ui.colours.panel.with_alpha(200));
}

}  // namespace

int ray_tree(const Ui& ui, const Rect& where, int& centred_on) {
  const TreePanel tree = tree_panel(ui.state);
  if (tree.nodes.empty()) {
    paragraph(ui.colours.dim_text, ui.say("tree.empty"));
    return -1;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4{0, 0, 0, 0});
  const bool visible = ImGui::BeginChild("tree", size(where), false, ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  int pointed_at = -1;
  if (visible) {
    const auto columns = static_cast<float>(std::max(tree.columns, 1.0));
    const auto levels = static_cast<float>(std::max(tree.levels, 1));
    const float inset = ui.px(10);
    // The lowest nodes have their labels below them.
    const float below = line_height(ui.fonts, *ui.fonts.small) + ui.px(4);
    // Either scroll bar takes room from the other direction. A unit less than available: rounding could otherwise cause
    // scroll bars.
    const float bar = ImGui::GetStyle().ScrollbarSize;
    Rect seen = where;
    if (ui.px(least_level) * levels + below > where.height) seen.width -= bar;
    const float column =
        std::clamp((seen.width - ui.px(1) - 2 * inset) / columns, ui.px(least_column), ui.px(max_column));
    const float width = column * columns + 2 * inset;
    if (width > seen.width) seen.height -= bar;
    const float level = std::clamp((seen.height - ui.px(1) - below) / levels, ui.px(least_level), ui.px(max_level));
    const float radius = std::clamp(0.36f * std::min(column, level), ui.px(least_radius), ui.px(max_radius));
    const float height = level * levels + below;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float indent = std::max((seen.width - width) / 2, 0.0f) + inset + column / 2;
    const auto place = [&](const TreeNode& node) {
      return ImVec2{origin.x + indent + static_cast<float>(node.x) * column,
                    origin.y + radius + ui.px(7) + static_cast<float>(node.y) * level};
    };
    for (const TreeNode& node : tree.nodes) {
      if (node.parent >= 0) draw_link(ui, node, place(tree.nodes[static_cast<std::size_t>(node.parent)]), place(node));
    }
    const float r = radius + ui.px(3);
    for (const TreeNode& node : tree.nodes) {
      const ImVec2 at = place(node);
      const std::string name = "node-" + std::to_string(node.ray);
      ImGui::SetCursorScreenPos({at.x - r, at.y - r});
      if (ImGui::InvisibleButton(name.c_str(), {2 * r, 2 * r}) && !node.future) ui.act(action::JumpToRay{node.ray});
      if (ImGui::IsItemHovered()) {
        pointed_at = node.ray;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        tooltip_now(ui, node_text(ui.state, node));
      }
      ui.publish(name);
      draw_node(ui, node, at, {column, level, radius});
      if (node.current && centred_on != node.ray) {
        centred_on = node.ray;
        // With its label, below it.
        ImGui::SetScrollX(std::max(at.x - origin.x - seen.width / 2, 0.0f));
        ImGui::SetScrollY(std::max(at.y + below / 2 - origin.y - seen.height / 2, 0.0f));
      }
    }
    std::vector<ImVec2> places;
    for (const TreeNode& node : tree.nodes) places.push_back(place(node));
    for (std::size_t i = 0; i < places.size(); ++i)
      draw_label(ui, tree.nodes[i], places[i], {column, level, radius}, seen, places);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({width, height});
  }
  ImGui::EndChild();
  return pointed_at;
}

void TreeRoom::draw_tab(const Ui& ui, const Rect& where, TabContext& context) {
  context.pointed_at = ray_tree(ui, where, context.memory.of<CentredOn>().ray);
}

Commands TreeRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-tree", .keys = {"R"}, .section = Section::tabs, .line = "keys.tabs", .chosen = shows_tab<TreeRoom>,
       .run = open_tab<TreeRoom>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
