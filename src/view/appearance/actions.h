#pragma once
// Actions on the appearance of the window.

#include "view/fields.h"
#include "view/state.h"

#include <string>

namespace raywalk::action {

struct SetTheme {
  static constexpr std::string_view word = "theme";
  Theme theme;
  static void fields(auto& f, auto& a) { f(a.theme); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
/// Of interface, lessons and bugs.
struct SetLanguage {
  static constexpr std::string_view word = "language";
  std::string code;  ///< "pt"
  static void fields(auto& f, auto& a) { f(a.code); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
struct SetUiScale {
  static constexpr std::string_view word = "ui-scale";
  double scale;  ///< clamped
  static void fields(auto& f, auto& a) { f(a.scale); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
struct SetTab {
  static constexpr std::string_view word = "tab";
  Tab tab;
  static void fields(auto& f, auto& a) { f(a.tab); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
struct DismissNotice {
  static constexpr std::string_view word = "dismiss";
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};

using OfAppearance = Types<SetTheme, SetLanguage, SetUiScale, SetTab, DismissNotice>;

}  // namespace raywalk::action
