#include "gui/widgets.h"

#include "gui/broken_lines.h"
#include "gui/painter.h"
#include "view/plan/pictogram.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

struct Metrics {
  ImVec2 text;
  float icon = 0, gap = 0;
  [[nodiscard]] float width() const { return icon + gap + text.x; }
};

Metrics measure(const Ui& ui, const std::string& label, const ButtonLook& look) {
  push_font(look.font != nullptr ? look.font : ui.fonts.text);
  Metrics m;
  if (look.label) m.text = ImGui::CalcTextSize(label.c_str());
  if (look.icon != Icon::none) m.icon = ImGui::GetFontSize() * 0.8f;
  if (look.pictogram) m.icon = ImGui::GetFontSize() * (look.label ? 1.3f : 1.75f);
  if (m.icon > 0 && look.label) m.gap = ImGui::GetFontSize() * 0.45f;
  pop_font();
  return m;
}

Colour ground_of(const Shades& shades, Look look, bool is_chosen, bool hovered, bool held) {
  const auto of = [&](Colour rest, Colour hover, Colour hold) { return held ? hold : hovered ? hover : rest; };
  if (look == Look::primary || is_chosen) return of(shades.accent, shades.accent_hovered, shades.accent_held);
  if (look == Look::plain) return of(shades.raised, shades.raised_hovered, shades.raised_held);
  return of(shades.raised.with_alpha(0), shades.raised_hovered, shades.raised_held);
}

std::string hint_of(const Command& command, Language language) {
  const std::string key = command_key(command, language);
  const std::string hint = capitalised(command_hint(command, language));
  return key.empty() ? hint : hint + "  (" + key + ")";
}

}  // namespace

void push_font(ImFont* font) { ImGui::PushFont(font); }
void pop_font() { ImGui::PopFont(); }

std::string shortened(const std::string& text, float max_width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= max_width) return text;
  std::string kept = text;
  while (!kept.empty()) {
    // Removes the whole last character: its last byte and the UTF-8 bytes before it.
    while (kept.size() > 1 && (static_cast<unsigned char>(kept.back()) & 0xC0U) == 0x80U) kept.pop_back();
    kept.pop_back();
    while (!kept.empty() && kept.back() == ' ') kept.pop_back();
    const std::string with_ellipsis = kept + "\u2026";
    if (ImGui::CalcTextSize(with_ellipsis.c_str()).x <= max_width) return with_ellipsis;
  }
  return {};
}

void label(Colour colour, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui4(colour));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void paragraph(Colour colour, std::string_view text) {
  label(colour, broken_lines(std::string(text), ImGui::GetContentRegionAvail().x));
}

void fill_triangle(ImDrawList& draw, ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour) {
  const bool clockwise = (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);  // y points down
  draw.AddTriangleFilled(a, clockwise ? b : c, clockwise ? c : b, colour);
}

void draw_icon(ImDrawList& draw, Icon icon, ImVec2 centre, float edge, ImU32 colour) {
  const float r = edge / 2, thick = std::max(edge * 0.14f, 1.5f);
  const auto at = [&](float x, float y) { return ImVec2{centre.x + x * r, centre.y + y * r}; };
  const auto triangle = [&](float tip, float base) {
    fill_triangle(draw, at(tip, 0), at(base, -0.85f), at(base, 0.85f), colour);
  };
  const auto bar = [&](float x) { draw.AddRectFilled(at(x - 0.13f, -0.85f), at(x + 0.13f, 0.85f), colour); };
  // Three quarters of a circle that begin with an arrowhead, at the left for side 1.
  const auto turn = [&](float side) {
    constexpr float pi = 3.14159265f;
    const ImVec2 middle = at(0, 0.1f);
    const float radius = 0.68f * r, begin = side > 0 ? -0.75f * pi : -0.25f * pi;
    draw.PathArcTo(middle, radius, begin, begin + side * 1.35f * pi, 28);
    draw.PathStroke(colour, 0, thick);
    const float head = 0.5f * r;
    const ImVec2 start{middle.x + radius * std::cos(begin), middle.y + radius * std::sin(begin)};
    fill_triangle(draw, {start.x - side * head * 0.9f, start.y + head * 0.55f},
                  {start.x - side * head * 0.55f, start.y - head},
                  {start.x + side * head * 0.75f, start.y + head * 0.35f}, colour);
  };
  switch (icon) {
    case Icon::none:
      break;
    case Icon::step:
      bar(-0.75f);
      triangle(1, -0.35f);
      break;
    case Icon::back:
      bar(0.75f);
      triangle(-1, 0.35f);
      break;
    case Icon::play:
      triangle(0.95f, -0.65f);
      break;
    case Icon::pause:
      draw.AddRectFilled(at(-0.7f, -0.85f), at(-0.2f, 0.85f), colour);
      draw.AddRectFilled(at(0.2f, -0.85f), at(0.7f, 0.85f), colour);
      break;
    case Icon::clear:
    case Icon::close:
      draw.AddLine(at(-0.65f, -0.65f), at(0.65f, 0.65f), colour, thick);
      draw.AddLine(at(-0.65f, 0.65f), at(0.65f, -0.65f), colour, thick);
      break;
    case Icon::first:
      bar(-0.8f);
      fill_triangle(draw, at(-0.6f, 0), at(0.2f, -0.8f), at(0.2f, 0.8f), colour);
      fill_triangle(draw, at(0.2f, 0), at(1, -0.8f), at(1, 0.8f), colour);
      break;
    case Icon::last:
      bar(0.8f);
      fill_triangle(draw, at(0.6f, 0), at(-0.2f, -0.8f), at(-0.2f, 0.8f), colour);
      fill_triangle(draw, at(-0.2f, 0), at(-1, -0.8f), at(-1, 0.8f), colour);
      break;
    case Icon::undo:
      turn(1);
      break;
    case Icon::redo:
      turn(-1);
      break;
    case Icon::plus:
      draw.AddLine(at(0, -0.8f), at(0, 0.8f), colour, thick);
      draw.AddLine(at(-0.8f, 0), at(0.8f, 0), colour, thick);
      break;
    case Icon::minus:
      draw.AddLine(at(-0.8f, 0), at(0.8f, 0), colour, thick);
      break;
    case Icon::exchange:
      draw.AddLine(at(-0.9f, -0.4f), at(0.7f, -0.4f), colour, thick);
      fill_triangle(draw, at(1, -0.4f), at(0.4f, -0.9f), at(0.4f, 0.1f), colour);
      draw.AddLine(at(0.9f, 0.5f), at(-0.7f, 0.5f), colour, thick);
      fill_triangle(draw, at(-1, 0.5f), at(-0.4f, 0), at(-0.4f, 1), colour);
      break;
    case Icon::focus:
      for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
          draw.AddLine(at(0.85f * x, 0.85f * y), at(0.25f * x, 0.85f * y), colour, thick);
          draw.AddLine(at(0.85f * x, 0.85f * y), at(0.85f * x, 0.25f * y), colour, thick);
        }
      break;
    case Icon::pen:
      draw.AddLine(at(-0.4f, 0.4f), at(0.75f, -0.75f), colour, 2.4f * thick);
      fill_triangle(draw, at(-0.95f, 0.95f), at(-0.72f, 0.22f), at(-0.22f, 0.72f), colour);
      break;
    case Icon::arrow:
      draw.AddLine(at(-0.8f, 0.8f), at(0.5f, -0.5f), colour, thick);
      fill_triangle(draw, at(0.9f, -0.9f), at(0.05f, -0.7f), at(0.7f, -0.05f), colour);
      break;
    case Icon::letter:
      draw.AddLine(at(-0.8f, -0.75f), at(0.8f, -0.75f), colour, 1.3f * thick);
      draw.AddLine(at(0, -0.75f), at(0, 0.9f), colour, 1.3f * thick);
      break;
    case Icon::ruler:
      draw.AddRect(at(-1, -0.45f), at(1, 0.5f), colour, 0, 0, 0.8f * thick);
      for (const float x : {-0.5f, 0.0f, 0.5f}) draw.AddLine(at(x, -0.45f), at(x, 0.1f), colour, 0.8f * thick);
      break;
    case Icon::protractor:
      draw.PathArcTo(at(0, 0.5f), 0.95f * r, -3.14159265f, 0, 24);
      draw.PathStroke(colour, ImDrawFlags_Closed, 0.8f * thick);
      draw.AddLine(at(0, 0.5f), at(0.42f, -0.22f), colour, 0.8f * thick);
      break;
    case Icon::eraser:
      draw.AddQuad(at(-0.95f, 0.35f), at(0.2f, -0.8f), at(0.9f, -0.1f), at(-0.25f, 0.9f), colour, 0.8f * thick);
      draw.AddQuadFilled(at(-0.95f, 0.35f), at(-0.4f, -0.2f), at(0.3f, 0.45f), at(-0.25f, 0.9f), colour);
      break;
    case Icon::bin:
      draw.AddLine(at(-0.85f, -0.6f), at(0.85f, -0.6f), colour, thick);
      draw.AddLine(at(-0.25f, -0.85f), at(0.25f, -0.85f), colour, thick);
      draw.AddQuad(at(-0.6f, -0.6f), at(0.6f, -0.6f), at(0.48f, 0.9f), at(-0.48f, 0.9f), colour, 0.8f * thick);
      for (const float x : {-0.18f, 0.18f}) draw.AddLine(at(x, -0.25f), at(x, 0.55f), colour, 0.8f * thick);
      break;
    case Icon::keep:  // into a tray
      draw.AddLine(at(0, -0.9f), at(0, 0.1f), colour, thick);
      fill_triangle(draw, at(0, 0.5f), at(-0.5f, -0.1f), at(0.5f, -0.1f), colour);
      draw.AddLine(at(-0.9f, 0.2f), at(-0.9f, 0.85f), colour, thick);
      draw.AddLine(at(-0.9f, 0.85f), at(0.9f, 0.85f), colour, thick);
      draw.AddLine(at(0.9f, 0.85f), at(0.9f, 0.2f), colour, thick);
      break;
    case Icon::pixel:
      for (const float y : {-1.0f, -0.3f, 0.4f})
        draw.AddRect(at(-0.35f, y), at(0.35f, y + 0.6f), colour, 0, 0, 0.8f * thick);
      draw.AddRectFilled(at(-0.35f, -0.3f), at(0.35f, 0.3f), colour);
      break;
    case Icon::globe:
      draw.AddCircle(centre, 0.95f * r, colour, 28, 0.8f * thick);
      draw.AddLine(at(-0.95f, 0), at(0.95f, 0), colour, 0.8f * thick);
      for (const float side : {-1.0f, 1.0f})  // the meridians
        draw.AddBezierCubic(at(0, -0.95f), at(side * 0.6f, -0.5f), at(side * 0.6f, 0.5f), at(0, 0.95f), colour,
                            0.8f * thick, 16);
      break;
    case Icon::up:
      draw.AddLine(at(0, -0.8f), at(0, 0.9f), colour, thick);
      draw.AddLine(at(0, -0.8f), at(-0.6f, -0.1f), colour, thick);
      draw.AddLine(at(0, -0.8f), at(0.6f, -0.1f), colour, thick);
      break;
  }
}

bool button(const Ui& ui, std::string_view name, const std::string& label, const std::string& hint, ImVec2 size,
            const ButtonLook& look, bool is_chosen, bool is_enabled) {
  const Shades shades(ui.state.appearance.theme);
  const Metrics m = measure(ui, label, look);
  if (size.x <= 0) size.x = m.width() + 2 * ui.px(12);
  if (size.y <= 0) size.y = std::max(ImGui::GetFontSize() + 2 * ui.px(7), ui.finger);
  if (!is_enabled) ImGui::BeginDisabled();
  const bool pressed = ImGui::InvisibleButton(std::string(name).c_str(), size);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const float inset = ui.unseen(size.y);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 least{low.x, low.y + inset}, most{high.x, high.y - inset};
  ImDrawList& draw = *ImGui::GetWindowDrawList();

  const auto dim = [&](Colour c) { return is_enabled ? c : c.with_alpha(static_cast<int>(c.a * 0.4)); };
  const bool filled = look.look == Look::primary || is_chosen;
  draw.AddRectFilled(least, most, to_imgui(dim(ground_of(shades, look.look, is_chosen, hovered, held))),
                     ImGui::GetStyle().FrameRounding);
  const ImU32 ink = to_imgui(dim(filled ? shades.on_accent : ui.colours.text));
  const float y = (least.y + most.y) / 2;
  float x = std::round((least.x + most.x - m.width()) / 2);
  if (look.pictogram)
    paint(draw, pictogram(*look.pictogram, ui.state.appearance.theme, m.icon),
          {x, std::round(y - m.icon / 2), m.icon, m.icon}, 1, ui.fonts);
  else if (look.icon != Icon::none)
    draw_icon(draw, look.icon, {x + m.icon / 2, y}, m.icon, ink);
  x += m.icon + m.gap;
  if (look.label) {
    push_font(look.font != nullptr ? look.font : ui.fonts.text);
    draw.PushClipRect(least, most, true);
    draw.AddText({x, std::round(y - m.text.y / 2)}, ink, label.c_str());
    draw.PopClipRect();
    pop_font();
  }
  if (!is_enabled) ImGui::EndDisabled();  // first: its tooltip is not dimmed
  tooltip(ui, name, hint);
  ui.publish(name);
  // Which should not happen in any language: words that are cut, or touch those of the next button.
  if (m.width() + (look.label ? ui.px(4) : 0) > size.x) ui.publish(std::string(name) + "/clipped");
  return pressed;
}

float button_width(const Ui& ui, const std::string& label, const ButtonLook& look) {
  return measure(ui, label, look).width() + 2 * ui.px(12);
}

float button_width(const Ui& ui, const Command& command, const ButtonLook& look) {
  return button_width(ui, command_label(command, ui.state), look);
}

void command_button(const Ui& ui, const Command& command, ImVec2 size, const ButtonLook& look, const std::string& label,
                    std::optional<bool> on) {
  const bool is_chosen = look.look == Look::choice && on.value_or(chosen(command, ui.state));
  if (button(ui, command.name, label.empty() ? command_label(command, ui.state) : label,
             hint_of(command, ui.state.appearance.language), size, look, is_chosen, enabled(command, ui.state)))
    perform(command, ui);
}

void choice(const Ui& ui, const std::vector<const Command*>& commands, float height, ImFont* font, float max_width) {
  const Shades shades(ui.state.appearance.theme);
  const ButtonLook look{.look = Look::choice, .icon = Icon::none, .font = font, .label = true};
  bool in_short = false;
  const auto word = [&](const Command& each) { return command_label(each, ui.state, in_short); };
  const auto widths = [&] {
    float sum = 0;
    for (const Command* each : commands) sum += button_width(ui, word(*each), look);
    return sum;
  };
  float width = widths();
  if (width > max_width) {
    in_short = true;
    width = widths();
  }
  // Still too wide: each loses the same amount of padding, and words that would touch are smaller.
  const float less = std::max(width - max_width, 0.0f) / static_cast<float>(commands.size());
  if (less > ui.px(20) && font != ui.fonts.small) return choice(ui, commands, height, ui.fonts.small, max_width);
  width = std::min(width, max_width);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const float inset = ui.unseen(height);
  ImGui::GetWindowDrawList()->AddRectFilled({least.x, least.y + inset}, {least.x + width, least.y + height - inset},
                                            to_imgui(shades.raised), ImGui::GetStyle().FrameRounding);
  float x = least.x;
  for (const Command* each : commands) {
    const float own = std::max(button_width(ui, word(*each), look) - less, 1.0f);
    ImGui::SetCursorScreenPos({x, least.y});
    command_button(ui, *each, {own, height}, look, word(*each));
    x += own;
  }
}

namespace {

// Buttons of a choice in several lines, each with its width.
struct ChoiceLines {
  std::vector<std::vector<std::pair<const Command*, float>>> lines;
  bool in_short = false;
  float line_height = 0;
  [[nodiscard]] float height() const { return line_height * static_cast<float>(lines.size()); }
};

// None if the choice fits into one line, which is as high as asked for; several are lower.
std::optional<ChoiceLines> choice_lines(const Ui& ui, const std::vector<const Command*>& commands, float line_height,
                                        const ButtonLook& look, float width) {
  // The padding that short words can lose on either side.
  const float spare = 2 * ui.px(7) * static_cast<float>(commands.size());
  const auto sum = [&](bool in_short) {
    float all = 0;
    for (const Command* each : commands) all += button_width(ui, command_label(*each, ui.state, in_short), look);
    return all;
  };
  if (sum(true) - spare <= width) return std::nullopt;
  const auto broken = [&](bool in_short, float room) {
    decltype(ChoiceLines::lines) lines(1);
    float used = 0;
    for (const Command* each : commands) {
      const float own = button_width(ui, command_label(*each, ui.state, in_short), look) - 2 * ui.px(5);
      if (used > 0 && used + own > room) {
        lines.emplace_back();
        used = 0;
      }
      lines.back().emplace_back(each, own);
      used += own;
    }
    return lines;
  };
  const bool in_short = broken(true, width).size() < broken(false, width).size();
  // As many lines, and none much shorter than the others.
  auto lines = broken(in_short, width);
  for (float room = width - ui.px(8); room > width / 2; room -= ui.px(8)) {
    auto even = broken(in_short, room);
    if (even.size() > lines.size()) break;
    lines = std::move(even);
  }
  return ChoiceLines{std::move(lines), in_short, std::max(line_height * 0.8f, ui.finger)};
}

ButtonLook look_of_choice(ImFont* font) {
  return {.look = Look::choice, .icon = Icon::none, .font = font, .label = true};
}

}  // namespace

float choice_height(const Ui& ui, const std::vector<const Command*>& commands, float line_height, ImFont* font,
                    float width) {
  const auto lines = choice_lines(ui, commands, line_height, look_of_choice(font), width);
  return lines ? lines->height() : line_height;
}

void choice_in_lines(const Ui& ui, const std::vector<const Command*>& commands, float line_height, ImFont* font,
                     float width) {
  const ButtonLook look = look_of_choice(font);
  const auto broken = choice_lines(ui, commands, line_height, look, width);
  if (!broken) return choice(ui, commands, line_height, font, width);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const float height = broken->height(), low = broken->line_height, inset = ui.unseen(low);
  ImGui::GetWindowDrawList()->AddRectFilled({least.x, least.y + inset}, {least.x + width, least.y + height - inset},
                                            to_imgui(Shades(ui.state.appearance.theme).raised),
                                            ImGui::GetStyle().FrameRounding);
  float y = least.y;
  for (const auto& line : broken->lines) {
    float taken = 0, x = least.x;
    for (const auto& [each, own] : line) taken += own;
    const float more = std::max(width - taken, 0.0f) / static_cast<float>(line.size());
    for (const auto& [each, own] : line) {
      ImGui::SetCursorScreenPos({x, y});
      command_button(ui, *each, {own + more, low}, look, command_label(*each, ui.state, broken->in_short));
      x += own + more;
    }
    y += low;
  }
}

std::optional<float> slider(const Ui& ui, const char* name, ImVec2 extent, float fraction, const std::string& inside) {
  const Shades shades(ui.state.appearance.theme);
  const ImVec2 least = ImGui::GetCursorScreenPos(), most{least.x + extent.x, least.y + extent.y};
  ImGui::InvisibleButton(name, {std::max(extent.x, 1.0f), std::max(extent.y, 1.0f)});
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ui.publish(name);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float x = least.x + std::clamp(fraction, 0.0f, 1.0f) * extent.x;
  if (inside.empty()) {
    const float y = (least.y + most.y) / 2, thick = ui.px(3), knob = std::min(ui.px(lit ? 9 : 8), extent.y / 2);
    draw.AddRectFilled({least.x, y - thick}, {most.x, y + thick}, to_imgui(shades.raised_hovered), thick);
    draw.AddRectFilled({least.x, y - thick}, {x, y + thick}, to_imgui(shades.accent), thick);
    draw.AddCircleFilled({x, y}, knob, to_imgui(lit ? shades.accent_hovered : shades.accent));
  } else {
    const float rounding = ImGui::GetStyle().FrameRounding;
    draw.AddRectFilled(least, most, to_imgui(lit ? shades.raised_hovered : shades.raised), rounding);
    draw.PushClipRect(least, {x, most.y}, true);
    draw.AddRectFilled(least, most, to_imgui(shades.accent.with_alpha(130)), rounding);
    draw.PopClipRect();
    const ImVec2 text = ImGui::CalcTextSize(inside.c_str());
    draw.AddText({std::round((least.x + most.x - text.x) / 2), std::round((least.y + most.y - text.y) / 2)},
                 to_imgui(ui.colours.text), inside.c_str());
  }
  if (!ImGui::IsItemActive() || extent.x < 1) return std::nullopt;
  return std::clamp((ImGui::GetIO().MousePos.x - least.x) / extent.x, 0.0f, 1.0f);
}

void ButtonRow::add(const Command& command, const std::string& label) {
  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui_.fonts.small, .label = true};
  const std::string words = label.empty() ? command_label(command, ui_.state) : label;
  const float width = std::min(button_width(ui_, words, look), where_.width);
  place(width);
  command_button(ui_, command, {width, height_}, look, words);
}

void ButtonRow::place(float width) {
  if (x_ > where_.x && x_ + width > where_.right()) x_ = where_.x, y_ += height_ + ui_.px(4);
  ImGui::SetCursorScreenPos({x_, where_.y + y_});
  x_ += width + ui_.px(4);
}

void menu_item(const Ui& ui, const Command& command) {
  const std::string key = command_key(command, ui.state.appearance.language);
  if (ImGui::MenuItem(command_label(command, ui.state).c_str(), key.c_str(), chosen(command, ui.state),
                      enabled(command, ui.state)))
    perform(command, ui);
  ui.publish("menu/" + std::string(command.name));
}

}  // namespace raywalk
