#include "gui/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

// The part of `space` for a pane that wants `wish`.
float take(float space, float wish) { return std::clamp(std::round(wish), 0.0f, std::max(space, 0.0f)); }

constexpr float tight_code = 0.88f;   ///< the code's lines can stand closer, for the others' sake
constexpr float three_columns = 900;  ///< the least width of lesson, plan and code beside each other, at scale 1

constexpr float lowest_tabs = 130;  ///< with a picture that can still be seen, at scale 1
constexpr float grip = 8;           ///< what can be gripped between two panes, at scale 1

float hairline(const LayoutWishes& wishes) { return std::max(std::round(wishes.unit), 1.0f); }  // between neighbours

// As a telephone on its side.
bool is_on_its_side(const LayoutWishes& wishes) {
  return !is_upright(wishes.width, wishes.height) && wishes.height < low_window * wishes.unit &&
         wishes.width < three_columns * wishes.unit;
}

// Lesson, plan, strip and transport between `top` and `bottom` and left of `right`, the lesson at the left.
void lay_out_walk(const LayoutWishes& wishes, float lesson, float top, float bottom, float right, Layout& layout) {
  const float line = hairline(wishes), below = std::max(bottom - top, 0.0f);
  const float edge = lesson > 0 ? lesson + line : 0.0f, width = std::max(right - edge, 0.0f);
  layout.lesson = {0, top, lesson, lesson > 0 ? below : 0.0f};
  const float transport = take(below * 0.6f, wishes.transport);
  layout.transport = {edge, bottom - transport, width, transport};
  // From below, each in what the ones below it leave.
  float end = std::max(layout.transport.y - line, top);
  const auto above = [&](float part, float wish) {
    const float height = take(std::min((below - transport) * part, end - top), wish);
    end -= height;
    return Rect{edge, end, width, height};
  };
  const float usual =
      is_one_column(wishes)
          ? finger_of(wishes)
          : std::max((wishes.height < low_window * wishes.unit ? 36 : 42) * wishes.unit, finger_of(wishes));
  layout.strip = above(0.3f, wishes.bare ? 0 : std::max(wishes.strip, usual));
  const float corner = take(width * 0.2f, std::min(layout.strip.height, usual));
  layout.strip.width -= corner;
  layout.corner = {layout.strip.right(), layout.strip.y, corner, layout.strip.height};
  // What effects and the band leave of the plan can still be seen.
  const float least_plan = (finger_of(wishes) > 0 ? 0.36f : 0.42f) * (below - transport);
  const auto beside_plan = [&](float wish) { return std::max(std::min(wish, end - top - least_plan), 0.0f); };
  layout.band = above(0.25f, beside_plan(wishes.band));
  const float row = wishes.effects_row, room = std::min(beside_plan(wishes.effects), (below - transport) / 2);
  const float rows = std::max(std::floor(room / row + 0.01f), 1.0f);
  layout.effects = above(0.5f, wishes.effects > 0 ? rows * row : 0);
  layout.plan = {edge, top, width, end - top};
}

// Of code, tabs and lesson the one that is in front, below the choice of it, in `where`.
void lay_out_front(const LayoutWishes& wishes, const Rect& where, Layout& layout) {
  const float wish = std::max(38 * wishes.unit, finger_of(wishes) + 2 * wishes.unit);
  const float choice = wishes.bare && wishes.lesson <= 0 ? 0 : take(where.height * 0.3f, wish);
  layout.fronts = {where.x, where.y, where.width, choice};
  Rect& front = wishes.front == Front::code ? layout.side : wishes.front == Front::tabs ? layout.tabs : layout.lesson;
  front = {where.x, where.y + choice, where.width, where.height - choice};
}

Layout lay_out_upright(const LayoutWishes& wishes) {
  const float unit = wishes.unit, width = std::max(wishes.width, 0.0f), height = std::max(wishes.height, 0.0f);
  const float line = hairline(wishes);
  const bool one_column = is_one_column(wishes);
  Layout layout;
  // In two lines, where one has no room for all.
  const float bar = one_column ? 2 * (finger_height + 2) : wishes.bar_width > width ? 76 : 44;
  if (!wishes.bare) layout.bar = {0, 0, width, take(height, bar * unit)};
  const float top = wishes.bare ? 0 : std::min(layout.bar.bottom() + line, height), below = height - top;
  // In focus a question stands below the walk, where there is room for it; in one column so does any lesson.
  const bool asks = wishes.focus && !one_column && wishes.lesson > 2 * folded_width * unit;
  const bool folds = wishes.focus && !asks && !(one_column && wishes.front == Front::lesson);
  // Where effects or the band are shown too, the code scrolls rather than that the plan is a slit.
  constexpr float least_plan = 220;
  const float walk = wishes.transport + std::max(wishes.strip, 42 * unit) + wishes.band + wishes.effects;
  const float code = std::min(std::max(tight_code * wishes.code, below * 0.4f), below - walk - least_plan * unit);
  const float low = folds        ? take(below / 8, folded_width * unit)
                    : asks       ? take(below, below * 0.4f)
                    : one_column ? take(below, below * (wishes.front == Front::lesson ? 0.48f : 0.42f))
                                 : take(below * 0.5f, std::max(code, below * 0.3f));
  const float lesson = wishes.lesson > 0 && !one_column && !asks ? take(width * 0.5f - line, wishes.lesson) : 0.0f;
  lay_out_walk(wishes, lesson, top, std::max(height - low - line, top), width, layout);
  const Rect lower{0, height - low, width, low};
  if (folds) {
    layout.folded = lower;
    return layout;
  }
  if (asks) {
    layout.lesson = lower;
    return layout;
  }
  if (one_column) {
    lay_out_front(wishes, lower, layout);
    return layout;
  }
  layout.side = {0, lower.y, wishes.bare ? width : take(width, wishes.code_width), low};
  const float tabs = std::min(layout.side.width + line, width);
  layout.tabs = {tabs, lower.y, width - tabs, low};
  return layout;
}

// Beside the plan: a column of code and tabs, of which one is below the other.
Layout lay_out_wide(const LayoutWishes& wishes) {
  const float unit = wishes.unit, width = std::max(wishes.width, 0.0f), height = std::max(wishes.height, 0.0f);
  const float line = hairline(wishes);
  Layout layout;
  if (!wishes.bare)
    layout.bar = {0, 0, width,
                  take(height, std::max((height < low_window * unit ? 38 : 44) * unit, finger_of(wishes) + 2 * unit))};
  const float top = wishes.bare ? 0 : std::min(layout.bar.bottom() + line, height), below = height - top;

  // The code fits its longest line; the plan gets at least a third of the window.
  const float side = wishes.focus
                         ? take(width / 8, folded_width * unit)
                         : take(width * 2 / 3, std::max(wishes.code_width, std::min(width * 0.33f, 640 * unit)));
  // Without room for a third column, nor for the tabs below the code.
  const bool shares = !wishes.focus && is_on_its_side(wishes);
  const float lesson = wishes.lesson > 0 && !shares ? take((width - side) * 0.5f - line, wishes.lesson) : 0.0f;
  lay_out_walk(wishes, lesson, top, height, std::max(width - side - line, 0.0f), layout);
  if (shares) {
    lay_out_front(wishes, {width - side, top, side, below}, layout);
    return layout;
  }
  if (wishes.focus) {
    layout.folded = {width - side, top, side, height - top};
    return layout;
  }

  // The tabs need room for a picture, and get what the code does not need.
  const float least_tabs = std::clamp(below * 0.32f, 170 * unit, 250 * unit);
  const float tabs = std::clamp(below - tight_code * wishes.code, least_tabs, std::max(below * 0.36f, least_tabs));
  const float code = wishes.bare            ? below
                     : wishes.code_part > 0 ? take(below - lowest_tabs * unit, wishes.code_part * below)
                                            : take(below, std::min(wishes.code, std::max(below * 0.5f, below - tabs)));
  layout.side = {width - side, top, side, code};
  const float tabs_top = std::min(layout.side.bottom() + line, height);
  layout.tabs = {width - side, tabs_top, side, height - tabs_top};
  if (!wishes.bare) layout.divider = {width - side, tabs_top - line / 2 - grip / 2 * unit, side, grip * unit};
  return layout;
}

// Which tab is shown, above it.
void set_choice(const LayoutWishes& wishes, Layout& layout) {
  if (layout.tabs.empty()) return;
  const float height = take(layout.tabs.height * 0.5f, wishes.choice);
  layout.choice = {layout.tabs.x, layout.tabs.y, layout.tabs.width, height};
  layout.tabs.y += height;
  layout.tabs.height -= height;
}

// In one column the lesson stands where the tabs would: what it is about has the plan's place.
void show_beside_lesson(Layout& layout) {
  layout.tabs = {layout.plan.x, layout.plan.y, layout.plan.width, layout.strip.bottom() - layout.plan.y};
  layout.plan = layout.strip = {layout.tabs.x, layout.tabs.bottom(), layout.tabs.width, 0};
}

// What stands in the tabs has the plan's room too.
void fill_with_tabs(float height, Layout& layout) {
  layout.transport.y = layout.plan.y;
  layout.plan = layout.strip = {layout.plan.x, layout.plan.y, layout.plan.width, 0};
  layout.fronts.y = layout.transport.bottom();
  layout.tabs.y = layout.fronts.bottom();
  layout.tabs.height = height - layout.tabs.y;
}

// A telephone has no room for the code beside the help text.
void fill_with_help(float height, Layout& layout) {
  layout.transport.y = height - layout.transport.height;
  layout.help.height = layout.transport.y - layout.help.y;
  layout.fronts = layout.side = layout.tabs = layout.lesson = {};
}

}  // namespace

bool is_upright(float width, float height) { return height > 1.15f * width; }

bool is_one_column(const LayoutWishes& wishes) {
  constexpr float least_tabs = 220, least_two = 540;  // widths, in units at scale 1
  const float least = wishes.code_width + hairline(wishes) + least_tabs * wishes.unit;
  return is_upright(wishes.width, wishes.height) && wishes.width < std::max(least, least_two * wishes.unit);
}

float finger_of(const LayoutWishes& wishes) {
  if (is_one_column(wishes)) return finger_height * wishes.unit;
  return wishes.touch && is_on_its_side(wishes) ? low_finger_height * wishes.unit : 0;
}

float shrink_to_fit(float width, float height, float unit, bool lesson) {
  // The least of a window, in units at scale 1.
  struct Least {
    float width, height;
  };
  const bool beside = lesson && height >= low_window * unit;
  const Least least = is_upright(width, height) ? Least{400, 600} : Least{beside ? three_columns : 640, 360};
  const float part = std::min(width / (least.width * unit), height / (least.height * unit));
  // In steps, because each needs new fonts. Anything smaller is illegible.
  constexpr float steps = 32, smallest = 0.3f;
  return std::clamp(std::floor(part * steps) / steps, smallest, 1.0f);
}

Layout lay_out(const LayoutWishes& wishes) {
  const bool upright = is_upright(wishes.width, wishes.height);
  Layout layout = upright ? lay_out_upright(wishes) : lay_out_wide(wishes);
  const bool one_column = !layout.fronts.empty();
  if (wishes.help) {
    layout.help = {layout.plan.x, layout.plan.y, layout.plan.width, layout.strip.bottom() - layout.plan.y};
    if (upright && one_column) fill_with_help(wishes.height, layout);
    return layout;
  }
  if (wishes.focus) {  // what has the plan's place keeps it
    if (wishes.exchanged) layout.tabs = std::exchange(layout.plan, {});
    set_choice(wishes, layout);
    return layout;
  }
  const bool fills = upright && one_column && wishes.large_tab && !wishes.exchanged;
  if (fills && !layout.tabs.empty() && wishes.front == Front::tabs && wishes.band == 0 && wishes.effects == 0)
    fill_with_tabs(wishes.height, layout);
  // The choice stays under the hand that exchanges the two.
  set_choice(wishes, layout);
  if (wishes.exchanged && !layout.tabs.empty()) std::swap(layout.plan, layout.tabs);
  if (one_column && wishes.front == Front::lesson && wishes.enlarged) show_beside_lesson(layout);
  return layout;
}

}  // namespace raywalk
