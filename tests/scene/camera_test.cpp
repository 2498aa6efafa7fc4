#include "scene/camera.h"
#include "support/catch.h"

using namespace raywalk;

TEST_CASE("the extent of the picture comes from the screen or from the angle") {
  Camera camera;
  camera.screen = {2, 3.0, 21};
  CHECK(camera.half_extent() == 0.75);
  CHECK(camera.extent_axis() == FovAxis::x);
  CHECK(camera.screen_width() == 3);

  camera.screen.width = std::nullopt;
  camera.fov = FieldOfView{90, FovAxis::x};
  CHECK(camera.half_extent() == Approx(1));
  CHECK(camera.screen_width() == Approx(4));
  camera.fov = FieldOfView{60, FovAxis::y};
  CHECK(camera.half_extent() == Approx(0.5773502691896258));
  CHECK(camera.extent_axis() == FovAxis::y);
}
