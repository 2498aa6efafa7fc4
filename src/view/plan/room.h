#pragma once
// The pointer on the plan, in pixels of the viewport; pointing at things in other panels; what part of the plan is
// visible.

#include "trace/pseudocode.h"
#include "view/drawing/display_list.h"
#include "view/fields.h"
#include "view/room.h"

#include <memory>
#include <optional>

namespace raywalk {

/// The pane that shows the plan, in pixels.
struct Viewport {
  double width = 640, height = 480;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// The visible part of the plan.
struct PlanCamera {
  Vec2d centre{0.0};            ///< scene units, in the middle of the pane
  double pixels_per_unit = 50;  ///< > 0
  bool fitted = true;           ///< follows the pane's size until zoomed or panned by hand
  friend bool operator==(const PlanCamera&, const PlanCamera&) = default;
};

/// The state at the start of a drag, so that a drag is a pure function of the current pointer position, independent of
/// its path.
struct Drag {
  Target target;          ///< the pressed target
  bool pans = false;      ///< moves the plan under the pointer; else the target
  Vec2d grabbed_px{0.0};  ///< where the pointer was pressed, pixels
  Vec2d grabbed{0.0};     ///< the same in scene units
  PlanCamera camera;      ///< at the start
  bool aims = false;      ///< drags the arrow of a guess
  bool inks = false;      ///< draws over the plan
  bool moved = false;     ///< beyond the jitter of a click
  /// At the start; null while nothing has moved.
  std::shared_ptr<const Scene> scene{};
};

namespace action {
enum class Button { left, middle, right };
}  // namespace action
template <>
inline constexpr Word<action::Button> words_of<action::Button>[] = {
    {action::Button::left, "left"}, {action::Button::middle, "middle"}, {action::Button::right, "right"}};

namespace action {

struct Modifiers {
  bool shift = false, control = false, alt = false;
  static void fields(auto& f, auto& m) {
    f(m.shift, Flag{"shift"}), f(m.control, Flag{"control"}), f(m.alt, Flag{"alt"});
  }
};
struct ResizePlan {
  static constexpr std::string_view word = "resize";
  Viewport viewport;
  static void fields(auto& f, auto& a) { f(a.viewport.width), f(a.viewport.height); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true, .always = true};
  void apply(State& state) const;
};
struct PointerMoved {
  static constexpr std::string_view word = "pointer";
  Vec2d at;
  Modifiers modifiers{};
  static void fields(auto& f, auto& a) { f(a.at), f(a.modifiers); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};
struct PointerPressed {
  static constexpr std::string_view word = "press";
  Vec2d at;
  Button button = Button::left;
  Modifiers modifiers{};
  bool double_click = false;
  static void fields(auto& f, auto& a) { f(a.at), f(a.button), f(a.double_click, Flag{"double"}), f(a.modifiers); }
  void apply(State& state) const;
};
struct PointerReleased {
  static constexpr std::string_view word = "release";
  Vec2d at;
  Modifiers modifiers{};
  static void fields(auto& f, auto& a) { f(a.at), f(a.modifiers); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
struct PointerLeft {
  static constexpr std::string_view word = "pointer-left";
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true, .always = true};
  void apply(State& state) const;
};
/// Undoes the drag.
struct CancelDrag {
  static constexpr std::string_view word = "cancel-drag";
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
struct Zoom {
  static constexpr std::string_view word = "zoom";
  Vec2d at;
  double factor;  ///< the point at `at` stays fixed
  static void fields(auto& f, auto& a) { f(a.at), f(a.factor, Number::positive); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
struct Pan {
  static constexpr std::string_view word = "pan";
  Vec2d by;  ///< pixels
  static void fields(auto& f, auto& a) { f(a.by); }
  void apply(State& state) const;
};
struct FitView {
  static constexpr std::string_view word = "fit";
  void apply(State& state) const;
};
struct HoverRay {
  static constexpr std::string_view word = "hover-ray";
  int ray;  ///< -1: none
  static void fields(auto& f, auto& a) { f(a.ray); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};
struct HoverLine {
  static constexpr std::string_view word = "hover-line";
  std::optional<Line> line;
  static void fields(auto& f, auto& a) { f(a.line); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};
struct Select {
  static constexpr std::string_view word = "select";
  Target target;
  static void fields(auto& f, auto& a) { f(a.target); }
  void apply(State& state) const;
};
/// What a drag from the target's own place to this one does; an undo entry.
struct Place {
  static constexpr std::string_view word = "place";
  Target target;
  Vec2d at;  ///< scene units
  static void fields(auto& f, auto& a) { f(a.target), f(a.at); }
  void apply(State& state) const;
};
/// Arrow keys: one fine or coarse step, x right, y up; an undo entry, which a key that is held down continues.
struct Nudge {
  static constexpr std::string_view word = "nudge";
  Vec2d direction;
  bool coarse = false;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.direction), f(a.coarse, Flag{"coarse"}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};

}  // namespace action

/// What part of the plan is visible, and what is pointed at, in it or elsewhere.
struct PlanRoom {
  using Actions = Types<action::ResizePlan, action::PointerMoved, action::PointerPressed, action::PointerReleased,
                        action::PointerLeft, action::CancelDrag, action::Zoom, action::Pan, action::FitView,
                        action::HoverRay, action::HoverLine, action::Select, action::Place, action::Nudge>;
  static Commands commands();

  Viewport viewport;
  PlanCamera camera;
  Target selected;
  Target hovered;                    ///< under the pointer in the plan
  int hovered_ray = -1;              ///< hovered in plan or tree; highlighted in plan, tree and code
  std::optional<Line> hovered_line;  ///< hovered in the code; highlights its ray in plan and tree
  std::optional<Vec2d> pointer;      ///< pixels of the plan; none if it is elsewhere
  std::optional<Drag> drag;
};

}  // namespace raywalk
