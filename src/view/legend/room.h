#pragma once
// The legend: what the kinds of rays look like, and which rays are shown.

#include "trace/event.h"
#include "view/fields.h"
#include "view/room.h"

#include <array>
#include <cstddef>

namespace raywalk {

/// The rays of the pixels before the current one: all shown, faded where they are those of more than few_pixels, or
/// hidden.
enum class Earlier { shown, faded, hidden };
template <>
inline constexpr Word<Earlier> words_of<Earlier>[] = {
    {Earlier::shown, "shown"}, {Earlier::faded, "faded"}, {Earlier::hidden, "hidden"}};
inline constexpr int few_pixels = 3;

}  // namespace raywalk

namespace raywalk::action {

struct ShowEarlier {
  static constexpr std::string_view word = "earlier";
  Earlier how;
  static void fields(auto& f, auto& a) { f(a.how); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(auto& state) const { state.legend.earlier = how; }
};
struct ShowRays {
  static constexpr std::string_view word = "rays";
  RayKind kind;
  bool shown;
  static void fields(auto& f, auto& a) { f(a.kind), f(a.shown, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(auto& state) const { state.legend.hidden[static_cast<std::size_t>(kind)] = !shown; }
};

}  // namespace raywalk::action

namespace raywalk {

/// The legend.
struct LegendRoom {
  using Actions = Types<action::ShowEarlier, action::ShowRays>;
  static constexpr Tab tab{"legend"};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();

  Earlier earlier = Earlier::faded;
  std::array<bool, std::size(words_of<RayKind>)> hidden{};  ///< by kind

  [[nodiscard]] bool shows(RayKind kind) const { return !hidden[static_cast<std::size_t>(kind)]; }
};

}  // namespace raywalk
