#pragma once
// The band: SCREEN's cells once more, large and numbered.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk::action {

struct ShowBand {
  static constexpr std::string_view word = "band";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// SCREEN's cells below the plan.
struct BandRoom {
  using Actions = Types<action::ShowBand>;
  static Commands commands();

  bool shown = false;
};

}  // namespace raywalk
