#pragma once
// The plan: the scene seen from above, with the walk so far.

#include "view/drawing/display_list.h"
#include "view/state.h"

namespace raywalk {

/// Scene units to pixels and back; y is flipped.
[[nodiscard]] Vec2d to_pixels(const PlanCamera& camera, const Viewport& viewport, const Vec2d& point);
[[nodiscard]] Vec2d to_scene(const PlanCamera& camera, const Viewport& viewport, const Vec2d& pixels);

/// How deep the ring of a sky and the curve beside it reach into the pane from its border, in units at scale 1.
inline constexpr double sky_depth = 39;

/// The camera that shows everything in the plan, with a margin. `unit`: pixels per unit at scale 1, for the margin that
/// symbols and names need.
[[nodiscard]] PlanCamera fit(const Scene& scene, const Viewport& viewport, double unit = 1);
/// For a state's scene, pane and scale.
[[nodiscard]] PlanCamera fitted(const State& state);
/// Whether the plan shows any of a target, which must exist: of a body its box counts, of all else its place.
[[nodiscard]] bool is_in_view(const State& state, const Target& target);

/// The drawing of the pane. Move mode has handles, trace mode the rays formed so far.
[[nodiscard]] DisplayList plan_view(const State& state, const Viewport& viewport);
[[nodiscard]] inline DisplayList plan_view(const State& state) { return plan_view(state, state.plan.viewport); }

/// What is under a point of the pane: the topmost handle or symbol that plan_view draws there, else the nearest ray
/// within reach, else the topmost body.
[[nodiscard]] Target pick(const State& state, const Viewport& viewport, const Vec2d& at);
[[nodiscard]] inline Target pick(const State& state, const Vec2d& at) { return pick(state, state.plan.viewport, at); }
/// The object or light there, ignoring rays; nothing if there is none.
[[nodiscard]] Target body_at(const State& state, const Vec2d& at);

/// The tooltip of a thing, in a few words; empty for nothing. In move mode it also says what dragging does.
[[nodiscard]] std::string target_text(const State& state, const Target& target);

/// Lengths of symbols, lines and letters, in pixels of a state's scale and theme.
struct Sizes {
  explicit Sizes(const State& state);
  double unit;    ///< one pixel at scale 1 in the dark theme
  double text;    ///< height of labels
  double line;    ///< usual outline
  double handle;  ///< radius of a handle
  double reach;   ///< how near the pointer has to be
  double finger;  ///< the same for a fingertip and a small thing's middle
};

}  // namespace raywalk
