#pragma once
// Live rays: in Move, what the rays of a pixel or of the whole strip do while the scene is changed.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk {

enum class LiveRays { off, pixel, strip };
template <>
inline constexpr Word<LiveRays> words_of<LiveRays>[] = {
    {LiveRays::off, "off"}, {LiveRays::pixel, "pixel"}, {LiveRays::strip, "strip"}};

}  // namespace raywalk

namespace raywalk::action {

struct SetLiveRays {
  static constexpr std::string_view word = "live-rays";
  LiveRays rays;
  static void fields(auto& f, auto& a) { f(a.rays); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
/// The pixel whose rays follow; they are shown at once.
struct ChooseLiveCell {
  static constexpr std::string_view word = "live-cell";
  int cell;
  static void fields(auto& f, auto& a) { f(a.cell); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The rays that follow a drag. The walk is recorded again with every change anyway: they are drawn from that.
struct LiveRoom {
  using Actions = Types<action::SetLiveRays, action::ChooseLiveCell>;
  static Commands commands();
  static constexpr Layer layer = Layer::moving;
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);
  static void close(State& state);

  LiveRays rays = LiveRays::pixel;
  int cell = -1;       ///< chosen by hand; -1: the pixel of the walk, else the middle one
  bool shown = false;  ///< from the first change in Move until Move is left
};

}  // namespace raywalk
