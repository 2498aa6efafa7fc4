#include "view/legend/legend.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

namespace {

constexpr int hidden_alpha = 70;  // alpha of what is hidden

float legend_button_height(const Ui& ui) { return ui.high(30); }

std::string command_name(RayKind kind) { return "rays-" + std::string(name_of(kind)); }

// A sample of a ray of this kind, with its arrowhead, from (x, y) to the right.
void sample(const Ui& ui, const LegendRow& row, float x, float y, float length) {
  LineItem line;
  line.from = {x, y};
  line.to = {x + length, y};
  const Colour colour = ui.state.legend.shows(row.kind) ? row.style.colour : row.style.colour.with_alpha(hidden_alpha);
  line.stroke = {colour, static_cast<double>(ui.px(2.2f)), row.style.dash, 0};
  for (double& part : line.stroke.dash.lengths) part *= static_cast<double>(ui.unit);
  line.arrow = static_cast<double>(std::min(ui.px(10), length / 3));
  paint_line(*ImGui::GetWindowDrawList(), line);
}

// A row hides and shows its rays: a click anywhere in `where`.
void row_button(const Ui& ui, const LegendRow& row, const Rect& where) {
  const Command& shows = command(command_name(row.kind));
  const std::string name = "legend/" + std::string(name_of(row.kind));
  ImGui::SetCursorScreenPos(corner(where));
  if (ImGui::InvisibleButton(name.c_str(), size(where))) perform(shows, ui);
  ui.publish(name);
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  tooltip(ui, name, ui.say(ui.state.legend.shows(row.kind) ? "legend.hide" : "legend.show"));
}

}  // namespace

void LegendRoom::draw_tab(const Ui& ui, const Rect& where, TabContext&) {
  const Legend content = legend(ui.state);
  const float column = ui.px(78);
  // Before its choice if both fit into a line.
  push_font(ui.fonts.small);
  const std::string earlier = ui.say("legend.earlier");
  const float words = ImGui::CalcTextSize(earlier.c_str()).x + ui.px(12), room = where.width - ui.px(24);
  float buttons = 0;
  for (const Command* each : commands_in(Section::earlier))
    buttons += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small});
  const bool in_line = words + buttons <= room;
  const ImVec2 begun = ImGui::GetCursorScreenPos();
  if (in_line) ImGui::SetCursorScreenPos({begun.x, begun.y + (legend_button_height(ui) - ImGui::GetFontSize()) / 2});
  label(ui.colours.text, earlier);
  if (in_line) ImGui::SetCursorScreenPos({begun.x + words, begun.y});
  pop_font();
  choice(ui, commands_in(Section::earlier), legend_button_height(ui), ui.fonts.small, in_line ? room - words : room);
  ImGui::Spacing();
  for (const LegendRow& row : content.rays) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    sample(ui, row, at.x, at.y + ImGui::GetFontSize() / 2, ui.px(56));
    ImGui::SetCursorScreenPos({at.x + column, at.y});
    ImGui::PushTextWrapPos(where.width - ui.px(12));
    push_font(ui.fonts.strong);
    const bool shown = ui.state.legend.shows(row.kind);
    label(shown ? ui.colours.text : ui.colours.dim_text, row.name);
    pop_font();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + column);
    push_font(ui.fonts.small);
    label(ui.colours.dim_text, shown ? row.meaning : ui.say("legend.hidden"));
    pop_font();
    ImGui::PopTextWrapPos();
    const ImVec2 below = ImGui::GetCursorScreenPos();
    row_button(ui, row, {at.x, at.y, where.width - ui.px(12), std::max(below.y - at.y, 1.0f)});
    ImGui::SetCursorScreenPos(below);
  }
  ImGui::Spacing();
  for (const LegendSign& sign : content.signs) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    push_font(ui.fonts.strong);
    label(ui.colours.text, sign.symbol);
    pop_font();
    ImGui::SetCursorScreenPos({at.x + column, at.y});
    ImGui::PushTextWrapPos(where.width - ui.px(12));
    push_font(ui.fonts.small);
    label(ui.colours.dim_text, sign.meaning);
    pop_font();
    ImGui::PopTextWrapPos();
  }
}

namespace {

// How the kinds of rays stand in a strip of some width: spread, but not too far; in a narrow one tight, with short
// names and in two or three lines.
class LegendLines {
 public:
  LegendLines(const Ui& ui, const Legend& content, float width) : rays(content.rays), ui_(ui) {
    push_font(ui.fonts.small);
    look.font = ui.fonts.small;
    // The first that fits, else the last.
    static constexpr std::array<Attempt, 6> attempts{{{false, Button::in_full, 1},
                                                      {false, Button::in_short, 1},
                                                      {true, Button::in_short, 1},
                                                      {true, Button::in_short, 2},
                                                      {true, Button::icon, 2},
                                                      {true, Button::icon, 3}}};
    for (const auto& [short_names, button_is, count] : attempts) {
      name = short_names ? &LegendRow::short_name : &LegendRow::name;
      lines = count;
      in_line = (rays.size() + lines - 1) / lines;
      look.icon = button_is == Button::icon ? Icon::pixel : Icon::none;
      look.label = button_is != Button::icon;
      words = command_label(command("only-pixel"), ui.state, button_is != Button::in_full);
      button = look.label ? button_width(ui, words, look) : legend_button_height(ui);
      if (fits(width - button - ui.px(left + 4 + 8), width < ui.px(640))) break;
    }
    pop_font();
  }

  [[nodiscard]] float line() const { return line_height(ui_.fonts, *ui_.fonts.small) + ui_.px(2); }

  static constexpr float left = 14;  // the margin, at scale 1
  const std::vector<LegendRow>& rays;
  std::string LegendRow::* name = nullptr;
  std::size_t lines = 1, in_line = 1;
  float sample = 0, gap = 0, between = 0;
  float aligned = 0;  // the width of each name, in two or three lines with room for that; else 0
  // "Only this pixel", at the right.
  ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = nullptr};
  std::string words;
  float button = 0;

 private:
  enum class Button { in_full, in_short, icon };
  struct Attempt {
    bool short_names;
    Button button;
    std::size_t lines;
  };

  // Samples as long as there is room for.
  bool fits(float room, bool narrow) {
    const float least = ui_.px(lines > 1 ? 20 : narrow ? 26 : 34), tight = ui_.px(lines > 1 ? 4 : 8);
    gap = ui_.px(lines > 1 ? 5 : 7);
    float widest = 0, longest = 0;
    for (std::size_t i = 0; i < rays.size(); i += in_line) {
      float sum = 0;
      for (std::size_t k = i; k < std::min(i + in_line, rays.size()); ++k) {
        const float own = ImGui::CalcTextSize((rays[k].*name).c_str()).x;
        widest = std::max(widest, own);
        sum += own;
      }
      longest = std::max(longest, sum);
    }
    const auto each = static_cast<float>(in_line);
    const float others = each * (least + gap + tight);
    aligned = lines > 1 && each * widest + others <= room ? widest : 0;
    if (aligned > 0) longest = each * widest;
    sample = std::clamp((room - longest) / each - gap - tight, ui_.px(8), ui_.px(34));
    between = std::clamp((room - longest) / each - gap - sample, ui_.px(2), ui_.px(22));
    return longest + others <= room;
  }

  const Ui& ui_;
};

}  // namespace

float legend_height(const Ui& ui, float width) {
  const Legend content = legend(ui.state);
  const LegendLines lines(ui, content, width);
  return lines.lines > 2 ? 3 * lines.line() + ui.px(6) : 0;
}

void legend_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "legend", where, ui.colours.plan, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const Legend content = legend(ui.state);
  const LegendLines lines(ui, content, where.width);
  push_font(ui.fonts.small);
  const float height = line_height(ui.fonts, *ui.fonts.small);
  const float most = where.height / static_cast<float>(lines.lines);
  const float line = ui.finger > 0 ? most : std::min(lines.line(), most);
  float y = std::round(where.y + (where.height - line * static_cast<float>(lines.lines)) / 2 + (line - height) / 2);
  float x = where.x + ui.px(LegendLines::left);
  for (std::size_t i = 0; i < lines.rays.size(); ++i) {
    const LegendRow& row = lines.rays[i];
    if (i > 0 && i % lines.in_line == 0) {
      x = where.x + ui.px(LegendLines::left);
      y = std::round(y + line);
    }
    const std::string& name = row.*lines.name;
    const float left = x, words = ImGui::CalcTextSize(name.c_str()).x;
    sample(ui, row, x, y + height / 2, lines.sample);
    x += lines.sample + lines.gap;
    const bool shown = ui.state.legend.shows(row.kind);
    const ImU32 ink = to_imgui(shown ? ui.colours.dim_text : ui.colours.dim_text.with_alpha(2 * hidden_alpha));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText({std::round(x), y}, ink, name.c_str());
    // Struck through, so that a kind that is hidden is not only fainter.
    if (!shown) draw.AddLine({left, y + height / 2}, {x + words, y + height / 2}, ink, ui.px(1.5f));
    row_button(ui, row, {left, y - (line - height) / 2, x + words - left, line});
    x += std::max(lines.aligned, words) + lines.between;
  }
  const float button_height = std::min(legend_button_height(ui), where.height);
  const Command& only = command("only-pixel");
  ButtonLook look = lines.look;
  if (chosen(only, ui.state)) look.look = Look::choice;
  ImGui::SetCursorScreenPos({where.right() - lines.button - ui.px(4), where.y + (where.height - button_height) / 2});
  command_button(ui, only, {lines.button, button_height}, look, lines.words);
  pop_font();
}

namespace {

template <RayKind kind>
bool shows_rays(const State& state) {
  return state.legend.shows(kind);
}
template <RayKind kind>
void toggle_rays(const Ui& ui) {
  ui.act(action::ShowRays{kind, !ui.state.legend.shows(kind)});
}
template <Earlier how>
bool shows_earlier(const State& state) {
  return state.legend.earlier == how;
}

}  // namespace

Commands LegendRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-legend", .keys = {"L"}, .section = Section::tabs, .line = "keys.tabs",
       .chosen = shows_tab<LegendRoom>, .run = open_tab<LegendRoom>},
      {.name = "rays-primary", .keys = {"Alt+1"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::primary>, .run = toggle_rays<RayKind::primary>},
      {.name = "rays-shadow", .keys = {"Alt+2"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::shadow>, .run = toggle_rays<RayKind::shadow>},
      {.name = "rays-reflect", .keys = {"Alt+3"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::reflect>, .run = toggle_rays<RayKind::reflect>},
      {.name = "rays-refract", .keys = {"Alt+4"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::refract>, .run = toggle_rays<RayKind::refract>},
      {.name = "rays-photon", .keys = {"Alt+8"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::photon>, .run = toggle_rays<RayKind::photon>},
      {.name = "rays-beam", .keys = {"Alt+9"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::beam>, .run = toggle_rays<RayKind::beam>},
      {.name = "only-pixel", .keys = {"Shift+L"}, .section = Section::rays, .chosen = shows_earlier<Earlier::hidden>,
       .run = [](const Ui& ui) {
         ui.act(action::ShowEarlier{shows_earlier<Earlier::hidden>(ui.state) ? Earlier::faded : Earlier::hidden});
       }},
      {.name = "earlier-shown", .keys = {"Alt+5"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::shown>, .run = act<action::ShowEarlier, Earlier::shown>},
      {.name = "earlier-faded", .keys = {"Alt+6"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::faded>, .run = act<action::ShowEarlier, Earlier::faded>},
      {.name = "earlier-hidden", .keys = {"Alt+7"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::hidden>, .run = act<action::ShowEarlier, Earlier::hidden>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
