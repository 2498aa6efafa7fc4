// Actions on the 3-D picture and the line view, and the choice of the walked pixel.

#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/painter.h"
#include "view/space/lines_view.h"
#include "view/space/orbit.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace raywalk {

namespace {

/// Sets a camera turned by hand; ignored if not finite.
void set_camera(State& state, SpaceView view, const Camera& camera) {
  state.space.turned_last = view;
  if (!is_finite(camera.eye) || !is_finite(camera.look_at) || camera.eye == camera.look_at) return;
  switch (view) {
    case SpaceView::image:
      if (camera == image_camera(state)) return;
      state.picture.camera = camera;
      ++state.picture.revision;
      return;
    case SpaceView::lines:
      state.space.lines_camera = camera;
      return;
  }
}

Camera camera_of(const State& state, SpaceView view) {
  switch (view) {
    case SpaceView::image:
      return image_camera(state);
    case SpaceView::lines:
      return lines_camera(state, state.plan.viewport);
  }
  return {};
}

/// A view's pivot: once turned, the camera keeps looking at it.
Vec3d pivot(const State& state, SpaceView view, const Camera& camera) {
  const bool is_scenes_own = view == SpaceView::image && !state.picture.camera;
  return is_scenes_own ? pivot_of(state.scene(), camera) : camera.look_at;
}

void walk_something(State& state, std::optional<PixelWalk> walk) {
  state.walk.playing = false;
  if (!state.walk.pixel) state.walk.strip_position = state.walk.position;
  state.walk.pixel = std::move(walk);
  state.walk.position = 0;
  record_again(state);
}

}  // namespace

void action::WalkPixel::apply(State& state) const {
  constexpr int most = 1 << 16;
  if (size.width < 1 || size.height < 1 || size.width > most || size.height > most) return;
  if (column < 0 || row < 0 || column >= size.width || row >= size.height) return;
  const int cells = state.scene().camera.screen.cells;
  // The row of the strip, as wide as a cell.
  const int near = std::max(size.width / std::max(cells, 1) / 2, 1);
  if (state.walk.planar && !state.picture.camera && std::abs(2 * row + 1 - size.height) / 2 < near)
    return update(state, JumpToCell{column * cells / size.width});
  walk_something(state, PixelWalk{size, column, row, state.picture.camera});
  state.space.lines_wanted.reset();
  go_to(state, state.walk.timeline->steps());
}

void walk_strip(State& state) {
  if (!state.walk.pixel) return;
  walk_something(state, std::nullopt);
  state.walk.position = std::min(state.walk.strip_position, state.walk.timeline->steps());
  state.space.lines_wanted.reset();
}

void action::WalkStrip::apply(State& state) const { walk_strip(state); }

void action::Orbit::apply(State& state) const {
  const Camera camera = camera_of(state, view);
  const Vec2d by{std::clamp(angles.x, -10.0, 10.0), std::clamp(angles.y, -10.0, 10.0)};
  set_camera(state, view, orbited(camera, pivot(state, view, camera), by));
}

void action::Shift::apply(State& state) const {
  const Camera camera = camera_of(state, view);
  const Vec2d by{std::clamp(parts.x, -10.0, 10.0), std::clamp(parts.y, -10.0, 10.0)};
  Camera centred = camera;
  centred.look_at = pivot(state, view, camera);
  set_camera(state, view, shifted(centred, centred.look_at, by));
}

void action::Approach::apply(State& state) const {
  const Camera camera = camera_of(state, view);
  set_camera(state, view, approached(camera, pivot(state, view, camera), std::clamp(factor, 0.01, 100.0)));
}

void action::ResetView::apply(State& state) const {
  state.space.turned_last = view;
  switch (view) {
    case SpaceView::image:
      if (state.picture.camera) ++state.picture.revision;
      state.picture.camera.reset();
      return;
    case SpaceView::lines:
      state.space.lines_camera.reset();
      return;
  }
}

void SpaceRoom::draw_in_plan(Painter& painter) {
  if (!painter.state.walk.pixel) return;
  const double unit = painter.sizes.unit, width = painter.viewport.width, height = painter.viewport.height;
  std::vector<Vec2d> places;
  for (const double row : {16.0, 40.0, 64.0})
    for (const double y : {height - row * unit, row * unit})
      for (const double x : {0.5, 0.35, 0.65, 0.25, 0.75}) places.emplace_back(x * width, y);
  const auto said = [&](std::string_view id) {
    return painter.note_off_bodies(places, std::string(text(id, painter.state.appearance.language)));
  };
  if (!said("plan.off_plane")) said("plan.off_plane_short");
}

void action::ShowLines::apply(State& state) const {
  state.space.lines_wanted = shown;
  if (shown) state.walk.mode = Mode::trace;
}

void action::UseImageCamera::apply(State& state) const {
  if (!state.picture.camera)
    return inform(state, std::string(text("notice.camera_is_the_scenes", state.appearance.language)));
  Scene next = state.scene();
  next.camera = *state.picture.camera;
  if (!commit_if_valid(state, std::move(next), -1, -1)) return;
  ResetView{SpaceView::image}.apply(state);
  inform(state, std::string(text("notice.camera_taken", state.appearance.language)));
}

void action::ShowTreeBeside::apply(State& state) const { state.picture.tree_beside = shown; }

void action::SetImageSettings::apply(State& state) const {
  ImageSettings next = settings;
  next.samples = std::clamp(next.samples, 1, max_image_samples);
  next.walk_samples = std::clamp(next.walk_samples, 1, max_walk_samples);
  if (next == state.picture.settings) return;
  const auto of_walk = [](const ImageSettings& s) {
    return std::tie(s.single_precision, s.integrator, s.walk_samples);
  };
  const bool other_walk = of_walk(next) != of_walk(state.picture.settings);
  state.picture.settings = next;
  ++state.picture.revision;
  if (other_walk) record_again(state);
}

}  // namespace raywalk
