#pragma once

namespace raywalk {

/// In ImGui's units, origin in the window's top left corner.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const Rect&, const Rect&) = default;

  [[nodiscard]] float right() const { return x + width; }
  [[nodiscard]] float bottom() const { return y + height; }
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  [[nodiscard]] bool contains(float px, float py) const { return px >= x && px < right() && py >= y && py < bottom(); }
};

/// Where the panes stand. None overlaps another and none is outside the window, however small that is; a pane may be
/// empty.
struct Layout {
  Rect bar;     ///< menus and modes, along the top
  Rect lesson;  ///< left of the plan, while lessons are shown
  Rect plan;
  Rect strip;      ///< below the plan: what can be added to the scene, or the kinds of rays
  Rect transport;  ///< the step's sentence, buttons and scrub bar
  Rect side;       ///< the code, or the properties of what is selected
  Rect tabs;       ///< 3-D image, ray tree, stack, legend: below the code
};

struct LayoutWishes {
  float width = 1280, height = 720;  ///< of the window
  float unit = 1;                    ///< units per unit at scale 1
  float transport = 0;               ///< height that the transport asks for
  float code = 0;                    ///< height that the code asks for
  float code_width = 0;              ///< width that the code asks for
  float lesson = 0;                  ///< width that the lesson asks for; 0: none is shown
};

/// Below this many units at scale 1 buttons that have a key or a menu entry too give way to the plan.
inline constexpr float low_window = 430;
/// What has room for everything, in units at scale 1. In a smaller window all is drawn smaller.
inline constexpr float least_width = 640, least_height = 360;
/// The same with a lesson beside the plan.
inline constexpr float least_width_with_lesson = 900;
/// How much smaller: 1 where nothing need be.
[[nodiscard]] float shrink_to_fit(float width, float height, float unit, float least = least_width);

[[nodiscard]] Layout lay_out(const LayoutWishes& wishes);

}  // namespace raywalk
