#pragma once
// The Microscope panel.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk::action {

struct Magnify {
  static constexpr std::string_view word = "magnify";
  /// Of the way from the whole scene, 0, to single numbers of the precision, 1; powers of ten in equal steps. Clamped.
  double part;
  static void fields(auto& f, auto& a) { f(a.part); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// A hit at any magnification.
struct MicroscopeRoom {
  using Actions = Types<action::Magnify>;
  static constexpr Tab tab{"microscope", true, true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();

  double magnified = 0;  ///< see action::Magnify
};

}  // namespace raywalk
