#include "gui/broken_lines.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/tree_labels.h"
#include "gui/widgets.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

// Lengths at scale 1.
constexpr float least_radius = 7, max_radius = 14, least_column = 20, max_column = 140, least_level = 25,
                max_level = 96, halo = 5, label_pad = 3;

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

void draw_text(ImFont* font, ImVec2 middle, Colour colour, const std::string& text, float max_width) {
  if (text.empty()) return;
  push_font(font);
  const std::string what = shortened(text, max_width);
  const ImVec2 extent = ImGui::CalcTextSize(what.c_str());
  ImGui::GetWindowDrawList()->AddText({std::round(middle.x - extent.x / 2), std::round(middle.y - extent.y / 2)},
                                      to_imgui(colour), what.c_str());
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
    draw.AddCircleFilled(at, r + ui.px(halo),
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
  draw_text(r < ui.px(12) ? ui.fonts.small : ui.fonts.strong, at, node.returned ? contrasting(ground) : ui.colours.text,
            node.symbol, 2 * r);
}

// A label, in lines of its own, and where it stands.
struct TreeLabel {
  std::string text;
  Rect where;
};

struct TreeLabels {
  std::vector<TreeLabel> by_nodes;
  std::string caption;  ///< of the current node or one pointed at: what has no room beside it
};

// What nodes hit: below them, in at most two lines, where the tree has room for that; always of the current one and of
// one pointed at. None covers another, nor a node.
TreeLabels labels_of(const Ui& ui, const TreePanel& tree, const std::vector<ImVec2>& places, const Spacing& spacing,
                     const Rect& seen) {
  push_font(ui.fonts.small);
  const float line = ImGui::GetFontSize(), column = spacing.column - ui.px(6);
  const TreeLabelRoom room{seen, places, spacing.radius, ui.px(4)};
  TreeLabelRoom round_halo{seen, places, spacing.radius, ui.px(halo), ui.px(label_pad)};
  const TreeLabelRoom bare_nodes{seen, places, spacing.radius - ui.px(1)};  // their rings have a background
  std::vector<std::pair<ImVec2, ImVec2>> links;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const int parent = tree.nodes[i].parent; parent >= 0)
      links.emplace_back(places[static_cast<std::size_t>(parent)], places[i]);
  round_halo.links = links;
  const auto extent_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()); };
  // Each line as wide as a column.
  const auto in_lines = [&](const std::string& text, int most) {
    std::string lines, rest = broken_lines(text, column);
    for (int i = 1; !rest.empty(); ++i) {
      const std::size_t end = rest.find('\n');
      if (end == std::string::npos || i == most) {
        std::replace(rest.begin(), rest.end(), '\n', ' ');
        return lines + shortened(rest, column);
      }
      lines += shortened(rest.substr(0, end), column) + "\n";
      rest.erase(0, end + 1);
    }
    return lines;
  };
  TreeLabels all;
  std::vector<TreeLabel>& labels = all.by_nodes;
  // With the room that their plates take.
  const float apart = ui.px(2 * label_pad) - 1;
  const auto is_free = [&](const Rect& where) {
    const Rect wide{where.x - apart, where.y, where.width + 2 * apart, where.height};
    return std::none_of(labels.begin(), labels.end(),
                        [&](const TreeLabel& each) { return labels_cross(each.where, wide); });
  };
  const auto has_label = [](const TreeNode& node) { return !node.future && !node.label.empty(); };
  const auto is_whole = [](const TreeNode& node) { return node.current || node.hovered; };
  // A line that is pointed at may light several nodes: then the labels that there is room for, the current one's first.
  std::vector<std::size_t> lit;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (has_label(tree.nodes[i]) && is_whole(tree.nodes[i])) lit.push_back(i);
  const auto current = std::find_if(lit.begin(), lit.end(), [&](std::size_t i) { return tree.nodes[i].current; });
  if (current != lit.end()) std::rotate(lit.begin(), current, current + 1);
  constexpr std::size_t most = 40;  // no pane has room for so many, and of a wide tree thousands may be lit
  lit.resize(std::min(lit.size(), most));
  for (const std::size_t i : lit) {
    const TreeNode& node = tree.nodes[i];
    // In one line, or where that covers more, or beside others, in two; in three where that alone covers nothing.
    const std::string one = shortened(node.label, std::min(ui.px(320), seen.width - ui.px(8)));
    const float half = std::max(ui.px(60), 0.6f * extent_of(one).x);
    const std::string two = broken_lines(node.label, std::min(std::max(column, ui.px(60)), half));
    const std::string three = broken_lines(node.label, 0.45f * extent_of(one).x);
    const auto place_of = [&](const std::string& text) { return label_place(places[i], extent_of(text), round_halo); };
    const Rect in_one = place_of(one), in_two = place_of(two), in_three = place_of(three);
    const auto beside = [&](std::size_t other) {
      const ImVec2 a = places[i], b = places[other];
      return other != i && has_label(tree.nodes[other]) && std::abs(a.y - b.y) < 1 &&
             std::abs(a.x - b.x) < (column + in_one.width) / 2;
    };
    std::size_t other = 0;
    while (other < places.size() && !beside(other)) ++other;
    const auto lines_of = [](const std::string& text) { return 1 + std::count(text.begin(), text.end(), '\n'); };
    // What does not stand there is worse than what stands over a link.
    const bool is_cut = one != node.label;
    const float over = covered_by_label(in_one, round_halo) + (is_cut ? 2 * line : 0),
                under = covered_by_label(in_two, round_halo), in_column = covered_by_label(in_three, round_halo);
    const bool breaks = lines_of(two) == 2 && (other < places.size() ? under <= over : under < over);
    const float least = breaks ? under : over;
    const bool breaks_twice = lines_of(three) == 3 && least > 0 && (in_column == 0 || (is_cut && in_column < least));
    TreeLabel label = breaks_twice ? TreeLabel{three, in_three}
                      : breaks     ? TreeLabel{two, in_two}
                                   : TreeLabel{one, in_one};
    const bool has_room =
        is_free(label.where) && is_seen(label.where, round_halo) && !covers_node(label.where, bare_nodes);
    if (has_room)
      labels.push_back(std::move(label));
    else if (all.caption.empty() || node.hovered)
      all.caption = node.symbol + "   " + node.label;
  }
  const float space = spacing.level - 2 * spacing.radius - 2 * room.gap;
  for (std::size_t i = 0; i < places.size() && spacing.column >= ui.px(64) && spacing.level >= ui.px(58); ++i) {
    const TreeNode& node = tree.nodes[i];
    if (!has_label(node) || is_whole(node)) continue;
    const float below = seen.bottom() - places[i].y - spacing.radius - room.gap;
    const std::string text = in_lines(node.label, std::min(space, below) >= 2 * line ? 2 : 1);
    const ImVec2 extent = extent_of(text);
    const Rect where{places[i].x - extent.x / 2, places[i].y + spacing.radius + room.gap, extent.x, extent.y};
    if (is_free(where)) labels.push_back({text, where});
  }
  pop_font();
  return all;
}

// Each line in the middle of the label's place.
void draw_label(const Ui& ui, const TreeLabel& label) {
  push_font(ui.fonts.small);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float pad = ui.px(label_pad), middle = label.where.x + label.where.width / 2;
  draw.AddRectFilled({label.where.x - pad, label.where.y}, {label.where.right() + pad, label.where.bottom()},
                     to_imgui(ui.colours.panel.with_alpha(230)), pad);
  float y = label.where.y;
  for (std::size_t at = 0; at <= label.text.size();) {
    const std::size_t end = std::min(label.text.find('\n', at), label.text.size());
    const std::string text = label.text.substr(at, end - at);
    draw.AddText({std::round(middle - ImGui::CalcTextSize(text.c_str()).x / 2), std::round(y)},
                 to_imgui(ui.colours.dim_text), text.c_str());
    y += ImGui::GetFontSize();
    at = end + 1;
  }
  pop_font();
}

// Along the bottom of what is seen, over links and nodes that are partly out of sight there.
void draw_caption(const Ui& ui, const std::string& caption, const Rect& seen) {
  if (caption.empty()) return;
  push_font(ui.fonts.small);
  const float height = ImGui::GetFontSize() + ui.px(4);
  const std::string what = shortened(caption, seen.width - ui.px(8));
  const ImVec2 extent = ImGui::CalcTextSize(what.c_str());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({seen.x, seen.bottom() - height}, {seen.right(), seen.bottom()}, to_imgui(ui.colours.panel));
  draw.AddText({std::round(seen.x + (seen.width - extent.x) / 2), std::round(seen.bottom() - height + ui.px(2))},
               to_imgui(ui.colours.text), what.c_str());
  pop_font();
}

}  // namespace

int ray_tree(const Ui& ui, const Rect& where, int& centred_on) {
  const TreePanel tree = tree_panel(ui.state);
  if (tree.nodes.empty()) {
    paragraph(ui.colours.dim_text, tree.empty);
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
    // Scrolled by whole levels: the one under way in the middle, none cut at the top.
    const float fit = std::max(std::floor((seen.height - ui.px(1) - below) / level), 1.0f);
    const float height = std::max((levels - fit) * level + seen.height - ui.px(1), level * levels + below);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float indent = std::max((seen.width - width) / 2, 0.0f) + inset + column / 2;
    const auto place = [&](const TreeNode& node) {
      return ImVec2{origin.x + indent + static_cast<float>(node.x) * column,
                    origin.y + radius + ui.px(7) + static_cast<float>(node.y) * level};
    };
    for (const TreeNode& node : tree.nodes) {
      if (node.parent >= 0) draw_link(ui, node, place(tree.nodes[static_cast<std::size_t>(node.parent)]), place(node));
    }
    // A finger reaches farther, but not into the next one.
    const float r = std::max(radius + ui.px(3), std::min({ui.finger, column, level}) / 2);
    for (const TreeNode& node : tree.nodes) {
      const ImVec2 at = place(node);
      const std::string name = "node-" + std::to_string(node.ray);
      ImGui::SetCursorScreenPos({at.x - r, at.y - r});
      if (ImGui::InvisibleButton(name.c_str(), {2 * r, 2 * r})) ui.act(action::JumpToRay{node.ray});
      if (ImGui::IsItemHovered()) {
        pointed_at = node.ray;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        tooltip_now(ui, node_text(ui.state, node));
      }
      ui.publish(name);
      draw_node(ui, node, at, {column, level, radius});
      if (node.current && centred_on != node.ray) {
        centred_on = node.ray;
        ImGui::SetScrollX(std::max(at.x - origin.x - seen.width / 2, 0.0f));
        const float row = static_cast<float>(node.y);
        ImGui::SetScrollY(level * std::clamp(row - std::floor(fit / 2), 0.0f, std::max(levels - fit, 0.0f)));
      }
    }
    std::vector<ImVec2> places;
    for (const TreeNode& node : tree.nodes) places.push_back(place(node));
    const TreeLabels labels = labels_of(ui, tree, places, {column, level, radius}, seen);
    for (const TreeLabel& label : labels.by_nodes) draw_label(ui, label);
    draw_caption(ui, labels.caption, seen);
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
