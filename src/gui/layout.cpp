#include "gui/layout.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// What is left of `space` for a part that asks for `wish`.
float take(float space, float wish) { return std::clamp(std::round(wish), 0.0f, std::max(space, 0.0f)); }

}  // namespace

Layout lay_out(const LayoutWishes& wishes) {
  const float unit = wishes.unit, width = std::max(wishes.width, 0.0f), height = std::max(wishes.height, 0.0f);
  Layout layout;
  layout.bar = {0, 0, width, take(height, 44 * unit)};
  const float top = layout.bar.bottom(), below = height - top;

  // The code gets its longest line; the plan, a third of the window at least.
  const float side = take(width * 2 / 3, std::max(wishes.code_width, std::min(width * 0.33f, 620 * unit)));
  const float left = width - side;
  layout.palette = {0, top, left, wishes.palette ? take(below, 46 * unit) : 0};
  const float transport = take((below - layout.palette.height) * 0.6f, wishes.transport);
  layout.plan = {0, layout.palette.bottom(), left, std::max(height - layout.palette.bottom() - transport, 0.0f)};
  layout.transport = {0, layout.plan.bottom(), left, transport};

  // The tabs need room for a picture; what the code does not need is theirs.
  const float code = std::min(wishes.code, std::max(below * 0.5f, below - 260 * unit));
  layout.side = {left, top, side, take(below, code)};
  layout.tabs = {left, layout.side.bottom(), side, std::max(height - layout.side.bottom(), 0.0f)};
  return layout;
}

}  // namespace raywalk
