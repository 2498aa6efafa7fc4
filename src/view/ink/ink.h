#pragma once
// Marks of ink: where they are put, what they look like and what they say.

#include "view/plan/painter.h"
#include "view/state.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The colour of ink in a theme.
[[nodiscard]] Colour ink_colour(InkColour colour, Theme theme);

[[nodiscard]] std::string_view text(InkColour colour, Language language);

/// The places of an arrow, a ruler or a protractor, in the order in which they are drawn; none of other marks.
[[nodiscard]] std::vector<Vec2d*> places_of(InkMark& mark);

// snap.cpp

/// Where the next place of `begun` (or the first one of a new mark) lies for a pointer at `at`: on the grid (Control),
/// at an angle of whole 15 degrees (Shift), else on something near that can be measured from: EYE, a light, a centre, a
/// corner, an end of a ray that is drawn. An arm of a protractor also takes the direction of a ray or of a normal at
/// its vertex.
struct Snapped {
  Vec2d at;
  bool onto = false;  ///< something of the scene
};
[[nodiscard]] Snapped snapped(const State& state, const InkRoom::Begun* begun, const Vec2d& at,
                              const action::Modifiers& modifiers);

// strokes.cpp

/// The points of a stroke without those that lie within `tolerance` of the line that is left.
[[nodiscard]] std::vector<Vec2d> simplified(const std::vector<Vec2d>& points, double tolerance);
/// A smooth line through all points, in steps of about `step`.
[[nodiscard]] std::vector<Vec2d> smooth(const std::vector<Vec2d>& points, double step);
/// Rounded to as few decimals as keep it within `error`.
[[nodiscard]] Vec2d rounded(const Vec2d& at, double error);

// ink_view.cpp

void draw_mark(Painter& painter, const InkMark& mark);
/// The mark under a point of the pane, the topmost one; -1 if there is none.
[[nodiscard]] int mark_at(const State& state, const Vec2d& pixels);
/// What a ruler or a protractor reads: "3.42", "37.5°"; the words of a text; else nothing.
[[nodiscard]] std::string reading_of(const InkMark& mark, Language language);

}  // namespace raywalk
