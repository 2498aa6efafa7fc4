#pragma once
// What all rooms do with the walk: record it, go to a position.

#include "view/state.h"

#include <optional>
#include <vector>

namespace raywalk {

/// Records the strip of the scene, and keeps the position: the same line of the same pixel, if it still exists.
void record_again(State& state);
/// One pixel of the walk, `column` of the strip or the picture's pixel, with other limits than the scene's.
[[nodiscard]] Timeline record_under(const State& state, int column, int samples, const TraceLimits& limits);
/// The walk as record_again records it, without becoming the state's, and without its cache of worlds.
[[nodiscard]] Timeline record_alone(const State& state);
/// A recording of this length takes some tens of milliseconds and less than 200 MB.
inline constexpr double max_events = 400'000;

/// The number of recorded samples of that pixel (an index in Timeline::pixels()).
[[nodiscard]] int samples_of_pixel(const Timeline& timeline, int pixel);

/// Updates WalkRoom::ghosts for the current pixel.
void follow_with_ghosts(State& state);

/// The displayed values of the cells of the strip that the plan shows, by column; absent: not computed yet.
[[nodiscard]] std::vector<std::optional<Rgbd>> shades_shown(const State& state);

/// Where else than at lines the walk stops, as it was chosen.
[[nodiscard]] action::StopAt stops_chosen(const State& state);
inline constexpr int deepest_stop = 99;  ///< that is offered

/// Steps per second after holding STEP for this long.
[[nodiscard]] double hold_rate(double seconds);
/// The breakpoints, without that at an object which the scene does not have.
[[nodiscard]] Breakpoints breakpoints_here(const State& state);
/// The active breakpoints: none if the open lesson has disabled them.
[[nodiscard]] Breakpoints breakpoints_in_force(const State& state);

void go_to(State& state, int position);
/// The position after one step of `grain`.
[[nodiscard]] int stepped(const Timeline& timeline, int position, Grain grain, bool forward);
void walk_strip(State& state);
/// At an end of the walk of a picture's pixel: the pixel after or before it, row by row.
[[nodiscard]] std::optional<action::WalkPixel> neighbour(const State& state, bool forward);

}  // namespace raywalk
