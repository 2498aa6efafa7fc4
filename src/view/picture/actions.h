#pragma once
// Actions on the settings of the 3-D picture.

#include "view/fields.h"
#include "view/state.h"

namespace raywalk::action {

struct SetImageSettings {
  static constexpr std::string_view word = "image-settings";
  ImageSettings settings;
  static void fields(auto& f, auto& a) {
    auto& s = a.settings;
    f(s.accelerator), f(s.single_precision, float_or_double), f(s.samples), f(s.walk_samples), f(s.heat);
    f(s.integrator);
  }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

using OfPicture = Types<SetImageSettings>;

}  // namespace raywalk::action
