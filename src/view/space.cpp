// Actions on the 3-D picture and the line view, and the choice of the walked pixel.

#include "view/lines_view.h"
#include "view/orbit.h"
#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>
#include <tuple>

namespace raywalk::detail {

namespace {

/// Sets a camera turned by hand; ignored if not finite.
void set_camera(State& state, SpaceView view, const Camera& camera) {
  state.turned_last = view;
  if (!is_finite(camera.eye) || !is_finite(camera.look_at) || camera.eye == camera.look_at) return;
  switch (view) {
    case SpaceView::image:
      if (camera == image_camera(state)) return;
      state.image_camera = camera;
      ++state.image_revision;
      return;
    case SpaceView::lines:
      state.lines_camera = camera;
      return;
  }
}

Camera camera_of(const State& state, SpaceView view) {
  switch (view) {
    case SpaceView::image:
      return image_camera(state);
    case SpaceView::lines:
      return lines_camera(state, state.viewport);
  }
  return {};
}

/// A view's pivot: once turned, the camera keeps looking at it.
Vec3d pivot(const State& state, SpaceView view, const Camera& camera) {
  const bool is_scenes_own = view == SpaceView::image && !state.image_camera;
  return is_scenes_own ? pivot_of(state.scene(), camera) : camera.look_at;
}

void walk_something(State& state, std::optional<PixelWalk> walk) {
  state.playing = false;
  state.walk = std::move(walk);
  state.position = 0;
  record_again(state);
}

}  // namespace

void walk_pixel(State& state, const action::WalkPixel& wanted) {
  const ImageSize size = wanted.size;
  constexpr int most = 1 << 16;
  if (size.width < 1 || size.height < 1 || size.width > most || size.height > most) return;
  if (wanted.column < 0 || wanted.row < 0 || wanted.column >= size.width || wanted.row >= size.height) return;
  const int cells = state.scene().camera.screen.cells;
  // The row of the strip, as wide as a cell.
  const int near = std::max(size.width / std::max(cells, 1) / 2, 1);
  if (state.planar && !state.image_camera && std::abs(2 * wanted.row + 1 - size.height) / 2 < near)
    return update(state, action::JumpToCell{wanted.column * cells / size.width});
  walk_something(state, PixelWalk{size, wanted.column, wanted.row, state.image_camera});
  state.lines_wanted.reset();
  state.tab = Tab::tree;
  go_to(state, state.timeline->steps());
}

void walk_strip(State& state) {
  if (!state.walk) return;
  walk_something(state, std::nullopt);
  state.lines_wanted.reset();
}

void orbit(State& state, const action::Orbit& by) {
  const Camera camera = camera_of(state, by.view);
  const Vec2d angles{std::clamp(by.angles.x, -10.0, 10.0), std::clamp(by.angles.y, -10.0, 10.0)};
  set_camera(state, by.view, orbited(camera, pivot(state, by.view, camera), angles));
}

void shift(State& state, const action::Shift& by) {
  const Camera camera = camera_of(state, by.view);
  const Vec2d parts{std::clamp(by.parts.x, -10.0, 10.0), std::clamp(by.parts.y, -10.0, 10.0)};
  Camera centred = camera;
  centred.look_at = pivot(state, by.view, camera);
  set_camera(state, by.view, shifted(centred, centred.look_at, parts));
}

void approach(State& state, const action::Approach& by) {
  const Camera camera = camera_of(state, by.view);
  set_camera(state, by.view, approached(camera, pivot(state, by.view, camera), std::clamp(by.factor, 0.01, 100.0)));
}

void reset_view(State& state, SpaceView view) {
  state.turned_last = view;
  switch (view) {
    case SpaceView::image:
      if (state.image_camera) ++state.image_revision;
      state.image_camera.reset();
      return;
    case SpaceView::lines:
      state.lines_camera.reset();
      return;
  }
}

void use_image_camera(State& state) {
  if (!state.image_camera) return inform(state, std::string(text("notice.camera_is_the_scenes", state.language)));
  Scene next = state.scene();
  next.camera = *state.image_camera;
  if (!commit_if_valid(state, std::move(next), -1, -1)) return;
  reset_view(state, SpaceView::image);
  inform(state, std::string(text("notice.camera_taken", state.language)));
}

void set_image_settings(State& state, ImageSettings settings) {
  settings.samples = std::clamp(settings.samples, 1, max_image_samples);
  settings.walk_samples = std::clamp(settings.walk_samples, 1, max_walk_samples);
  if (settings == state.image) return;
  const auto of_walk = [](const ImageSettings& s) {
    return std::tie(s.single_precision, s.integrator, s.walk_samples);
  };
  const bool other_walk = of_walk(settings) != of_walk(state.image);
  state.image = settings;
  ++state.image_revision;
  if (other_walk) record_again(state);
}

}  // namespace raywalk::detail
