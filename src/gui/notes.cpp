#include "gui/notes.h"

#include "gui/broken_lines.h"
#include "gui/style.h"
#include "gui/ui.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>

namespace raywalk {

namespace {

// Draws, or only measures, one text below the other.
class Column {
 public:
  Column(ImDrawList* draw, float x, float y, float width, float scale)
      : draw_(draw), x_(x), y_(y), width_(width), scale_(scale) {}
  void add(const Fonts& fonts, ImFont* font, Colour colour, const std::string& text, float gap) {
    const float size = line_height(fonts, *font) * scale_;
    const std::string lines = in_lines(
        text, [&](const std::string& line) { return font->CalcTextSizeA(size, FLT_MAX, 0, line.c_str()).x <= width_; });
    if (draw_ != nullptr) draw_->AddText(font, size, {x_, y_}, to_imgui(colour), lines.c_str());
    y_ += font->CalcTextSizeA(size, FLT_MAX, 0, lines.c_str()).y + gap * scale_ * line_height(fonts, *fonts.text);
  }
  [[nodiscard]] float bottom() const { return y_; }

 private:
  ImDrawList* draw_;  // null: measures
  float x_, y_, width_, scale_;
};

float draw_parts(const NotesPanel& panel, const Fonts& fonts, const Palette& colours, Column column) {
  column.add(fonts, fonts.title, colours.text, panel.heading, 0.5f);
  for (const NotesPanel::Part& part : panel.parts) {
    column.add(fonts, fonts.small, colours.dim_text, part.title, 0.1f);
    column.add(fonts, part.later ? fonts.small : fonts.text, part.later ? colours.dim_text : colours.text, part.text,
               0.6f);
  }
  return column.bottom();
}

}  // namespace

std::string elapsed_text(double seconds) {
  const int whole = static_cast<int>(std::max(seconds, 0.0));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

float draw_notes(const NotesPanel& panel, const Fonts& fonts, Theme theme, const std::string& clock, float grown) {
  const Palette& colours = palette(theme);
  const ImVec2 extent = ImGui::GetIO().DisplaySize;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const float title = line_height(fonts, *fonts.title) / grown, small = line_height(fonts, *fonts.small) / grown;
  const float margin = title;
  draw.AddRectFilled({0, 0}, extent, to_imgui(colours.panel));
  // The clock at the right, the lesson at the left, its plan below it.
  const float clock_width = fonts.title->CalcTextSizeA(title, FLT_MAX, 0, clock.c_str()).x;
  draw.AddText(fonts.title, title, {extent.x - margin - clock_width, margin / 2}, to_imgui(colours.text),
               clock.c_str());
  draw.AddText(fonts.small, small, {margin, margin / 2}, to_imgui(colours.dim_text), panel.lesson.c_str());
  draw.AddText(fonts.small, small, {margin, margin / 2 + small}, to_imgui(colours.dim_text), panel.time.c_str());
  const float top = margin / 2 + std::max(title, 2 * small) + margin / 2;
  draw.AddLine({0, top}, {extent.x, top}, to_imgui(Shades(theme).line));
  const float width = std::max(extent.x - 2 * margin, 1.0f);
  constexpr float largest = 1.6f, smallest = 0.4f, step = 0.95f;
  float scale = largest / grown;
  while (scale > smallest / grown &&
         draw_parts(panel, fonts, colours, Column(nullptr, margin, top + margin / 2, width, scale)) > extent.y)
    scale *= step;
  // Nearly as large as the fonts' own size: at that, for it is sharp.
  constexpr float near = 1.06f;
  const float drawn = scale >= 1 && scale <= near ? 1 : scale;
  draw_parts(panel, fonts, colours, Column(&draw, margin, top + margin / 2, width, drawn));
  return scale * grown;
}

}  // namespace raywalk
