#pragma once
// The pointer on the plan, in pixels of the viewport; pointing at things in other panels; what part of the plan is
// visible.

#include "view/fields.h"
#include "view/state.h"

#include <optional>

namespace raywalk {

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
/// Arrow keys: one fine or coarse step, x right, y up; an undo entry.
struct Nudge {
  static constexpr std::string_view word = "nudge";
  Vec2d direction;
  bool coarse = false;
  static void fields(auto& f, auto& a) { f(a.direction), f(a.coarse, Flag{"coarse"}); }
  void apply(State& state) const;
};

using OfPlan = Types<ResizePlan, PointerMoved, PointerPressed, PointerReleased, PointerLeft, CancelDrag, Zoom, Pan,
                     FitView, HoverRay, HoverLine, Select, Nudge>;

}  // namespace action
}  // namespace raywalk
