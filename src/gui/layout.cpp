#include "gui/layout.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// The part of `space` for a pane that wants `wish`.
float take(float space, float wish) { return std::clamp(std::round(wish), 0.0f, std::max(space, 0.0f)); }

}  // namespace

float shrink_to_fit(float width, float height, float unit, float least) {
  const float part = std::min(width / (least * unit), height / (least_height * unit));
  // In steps, because each needs new fonts. Anything smaller is illegible.
  constexpr float steps = 32, smallest = 0.3f;
  return std::clamp(std::floor(part * steps) / steps, smallest, 1.0f);
}

Layout lay_out(const LayoutWishes& wishes) {
  const float unit = wishes.unit, width = std::max(wishes.width, 0.0f), height = std::max(wishes.height, 0.0f);
  const float hairline = std::max(std::round(unit), 1.0f);  // between neighbours
  const bool low = height < low_window * unit;
  Layout layout;
  layout.bar = {0, 0, width, take(height, (low ? 38 : 44) * unit)};
  const float top = std::min(layout.bar.bottom() + hairline, height), below = height - top;

  // The code fits its longest line; the plan gets at least a third of the window.
  const float side = wishes.focus
                         ? take(width / 8, folded_width * unit)
                         : take(width * 2 / 3, std::max(wishes.code_width, std::min(width * 0.33f, 560 * unit)));
  const float lesson = wishes.lesson > 0 ? take((width - side) * 0.5f - hairline, wishes.lesson) : 0.0f;
  const float edge = lesson > 0 ? lesson + hairline : 0.0f;
  layout.lesson = {0, top, lesson, lesson > 0 ? height - top : 0.0f};
  const float left = std::max(width - side - hairline - edge, 0.0f);
  const float transport = take(below * 0.6f, wishes.transport);
  layout.transport = {edge, height - transport, left, transport};
  const float strip = take((below - transport) * 0.3f, (low ? 36 : 42) * unit);
  const float corner = take(left * 0.2f, strip);
  layout.strip = {edge, std::max(layout.transport.y - hairline - strip, top), left - corner, strip};
  layout.corner = {layout.strip.right(), layout.strip.y, corner, strip};
  const float band = take((below - transport) * 0.25f, wishes.band);
  layout.band = {edge, std::max(layout.strip.y - band, top), left, band};
  const float effects = take((below - transport) * 0.25f, wishes.effects);
  layout.effects = {edge, std::max(layout.band.y - effects, top), left, effects};
  layout.plan = {edge, top, left, layout.effects.y - top};
  if (wishes.focus) {
    layout.folded = {width - side, top, side, height - top};
    return layout;
  }

  // The tabs need room for a picture, and get what the code does not need.
  const float least_tabs = std::clamp(below * 0.32f, 170 * unit, 250 * unit);
  const float code = take(below, std::min(wishes.code, std::max(below * 0.5f, below - least_tabs)));
  layout.side = {width - side, top, side, code};
  const float tabs_top = std::min(layout.side.bottom() + hairline, height);
  layout.tabs = {width - side, tabs_top, side, height - tabs_top};
  return layout;
}

}  // namespace raywalk
