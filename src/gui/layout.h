#pragma once

#include "view/appearance/room.h"

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

/// The rectangles of the panes. They do not overlap and are within the window, however small; a pane may be empty.
struct Layout {
  Rect bar;     ///< menus and modes, along the top
  Rect lesson;  ///< left of the plan, while lessons are shown
  Rect plan;
  Rect effects;    ///< below the plan, while they are shown: switches for effects
  Rect band;       ///< below the plan, while it is shown: SCREEN's cells
  Rect strip;      ///< below the plan: objects to add, or the kinds of rays
  Rect corner;     ///< at its right end: the button for the focus
  Rect transport;  ///< the step's sentence, buttons and scrub bar
  Rect side;       ///< the code, or the properties of the selection
  Rect tabs;       ///< 3-D image, ray tree, stack, legend: below the code
  Rect choice;     ///< which of them is shown: above them, and there too while they have the plan's place
  Rect help;       ///< in the plan's place and the strip's, while help is shown
  Rect folded;     ///< in place of both, while the plan is in focus
  Rect divider;    ///< between code and tabs where one is below the other, and the height of both can be chosen
  Rect fronts;     ///< in a shared column: what chooses the one of lesson, side and tabs below; else empty
};

struct LayoutWishes {
  float width = 1280, height = 720;  ///< of the window
  float unit = 1;                    ///< units per unit at scale 1
  float transport = 0;               ///< height wanted by the transport
  float code = 0;                    ///< height wanted by the code
  float code_width = 0;              ///< width wanted by the code
  float lesson = 0;                  ///< width wanted by the lesson; 0: none is shown
  float bar_width = 0;               ///< width wanted by menus and buttons in one line
  float strip = 0;                   ///< height wanted by the kinds of rays, if more than the usual one
  float band = 0;                    ///< height wanted by the band; 0: it is not shown
  float effects = 0;                 ///< height wanted by the switches for effects; 0: they are not shown
  float effects_row = 1;             ///< of that, a row: none is cut, and one is always seen
  float choice = 0;                  ///< height wanted by the choice of tabs
  bool focus = false;                ///< code and tabs are folded to an edge
  Front front = Front::code;         ///< in one column; not the lesson unless it is shown
  bool bare = false;                 ///< neither bar nor strip nor tabs
  bool touch = false;                ///< pressed by fingers
  bool help = false;                 ///< the help text is shown
  bool exchanged = false;            ///< what stands in the tabs and the plan change places
  bool enlarged = false;             ///< the open lesson is about what stands in the tabs
  bool large_tab = false;            ///< what stands in the tabs wants much room
  float code_part = 0;               ///< of the height of code and tabs beside the plan; 0: what the code wants
};

/// The width of an edge to which panes are folded, in units at scale 1.
inline constexpr float folded_width = 22;
/// Below this height, in units at scale 1, buttons that also have a key or a menu entry are hidden.
inline constexpr float low_window = 430;
/// How high is what a finger presses, in units at scale 1: 44 pixels of a telephone of 390, and 40 of one of 360 or on
/// its side.
inline constexpr float finger_height = 46, low_finger_height = 40;
/// Taller than wide: code and tabs are below the walk, beside each other or, in a narrow window, one at a time.
[[nodiscard]] bool is_upright(float width, float height);
/// Upright and too narrow for two columns, as a telephone is: lesson, code and tabs stand below the walk one at a time,
/// and what is pressed is as high as a finger needs.
[[nodiscard]] bool is_one_column(const LayoutWishes& wishes);
/// The least height of what is pressed, on a telephone upright or on its side; else 0: as its words need.
[[nodiscard]] float finger_of(const LayoutWishes& wishes);
/// In a window too small for everything all is drawn smaller, by this factor: 1 if not needed. `lesson`: one stands
/// beside the plan.
[[nodiscard]] float shrink_to_fit(float width, float height, float unit, bool lesson = false);

[[nodiscard]] Layout lay_out(const LayoutWishes& wishes);

}  // namespace raywalk
