// What tests of properties share.
#pragma once

#include <string>
#include <string_view>

#include "gui/bench.h"
#include "support/languages.h"
#include "view/text/text.h"

namespace raywalk::test {

/// Move mode with this thing selected.
inline State selected(Target target) {
  State state = classic();
  update(state, action::SetMode{Mode::move});
  update(state, action::Select{target});
  return state;
}

inline std::string field(std::string_view label, const char* rest = "") {
  return "property/" + std::string(text(label, in_english)) + rest;
}

/// Double-clicks a number and types another one.
inline void type_into(Bench& bench, const std::string& item, const std::string& number) {
  bench.double_click(item);
  bench.type(number);
  bench.enter();
}

inline const Sphere<double>& sphere(const Bench& bench) {
  return std::get<Sphere<double>>(bench.state.scene().objects[0].shape);
}

}  // namespace raywalk::test
