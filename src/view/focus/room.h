#pragma once
// Focus: the plan alone, with the question of a lesson beside it, and with the ray in question enlarged.

#include "view/fields.h"
#include "view/plan/room.h"
#include "view/room.h"

#include <optional>

namespace raywalk::action {

struct SetFocus {
  static constexpr std::string_view word = "focus";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The plan has the room of the code, the tabs and the words of a lesson, which are folded to an edge.
struct FocusRoom {
  using Actions = Types<action::SetFocus>;
  static Commands commands();
  static void follow(State& state, const Before& before);
  static void close(State& state);

  /// The plan while it is zoomed to a ray.
  struct Zoomed {
    PlanCamera own;     ///< restored at the end
    Viewport viewport;  ///< that it is zoomed for
    int step = 0;       ///< of the lesson
  };

  bool on = false;
  bool tab = false;  ///< the open tab has the plan's place until its key is pressed again
  std::optional<Zoomed> zoomed;

  [[nodiscard]] bool shows_tab() const { return on && tab; }
};

}  // namespace raywalk
