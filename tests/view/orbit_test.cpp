#include "view/space/orbit.h"
#include "fixtures.h"

#include <cmath>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr double pi = 3.14159265358979323846;

Camera level_camera() {
  Camera camera;
  camera.eye = {-4, 1, 0.5};
  camera.look_at = {1, 1, 0.5};
  return camera;
}

void check_near(const Vec3d& a, const Vec3d& b) {
  for (int axis = 0; axis < 3; ++axis) CHECK(a[axis] == Approx(b[axis]).epsilon(0).margin(1e-12));
}

}  // namespace

TEST_CASE("a camera turned, moved or brought nearer by nothing is the same, bit for bit") {
  for (const std::string& path : shipped_scenes()) {
    const Scene scene = read_document(path).scene;
    const Vec3d pivot = pivot_of(scene, scene.camera);
    CHECK(orbited(scene.camera, pivot, {0, 0}) == scene.camera);
    CHECK(shifted(scene.camera, pivot, {0, 0}) == scene.camera);
    CHECK(approached(scene.camera, pivot, 1) == scene.camera);
  }
}

TEST_CASE("a camera goes around its pivot at the same distance, and comes back") {
  const Camera camera = level_camera();
  const Vec3d pivot(2, 1, 0.5);
  for (const Vec2d& angles : {Vec2d(0.7, 0.3), Vec2d(-2.5, 0.9), Vec2d(3, -1)}) {
    const Camera turned = orbited(camera, pivot, angles);
    CHECK(length(turned.eye - pivot) == Approx(6));
    check_near(turned.look_at, pivot);
    const Camera back = orbited(orbited(turned, pivot, {0, -angles.y}), pivot, {-angles.x, 0});
    check_near(back.eye, camera.eye);
  }
  check_near(orbited(camera, pivot, {2 * pi, 0}).eye, camera.eye);
}

TEST_CASE("what is seen follows the hand: right and down as it is dragged") {
  const Camera camera = level_camera();
  const Vec3d pivot(2, 1, 0.5);
  // Seen along +x with z up, the left is +y. What is nearer than the pivot moves with the hand.
  CHECK(orbited(camera, pivot, {pi / 2, 0}).eye.y == Approx(1 + 6));
  CHECK(orbited(camera, pivot, {0, 0.5}).eye.z == Approx(0.5 + 6 * std::sin(0.5)));
  const Viewport square{400, 400};
  const Vec3d nearer(0, 1, 0.5);
  const auto before = Projection(camera, square).point(nearer);
  const auto turned = Projection(orbited(camera, pivot, {0.2, 0}), square).point(nearer);
  const auto raised = Projection(orbited(camera, pivot, {0, 0.2}), square).point(nearer);
  REQUIRE((before && turned && raised));
  CHECK(turned->x > before->x + 5);
  CHECK(raised->y > before->y + 5);
}

TEST_CASE("the eye never stands straight above or below what it looks at") {
  Camera camera = level_camera();
  const Vec3d pivot(2, 1, 0.5);
  for (int i = 0; i < 100; ++i) camera = orbited(camera, pivot, {0.1, 0.2});
  const Vec3d view = normalize(camera.look_at - camera.eye);
  CHECK(length(cross(view, camera.up)) > 0.05);
  for (int i = 0; i < 100; ++i) camera = orbited(camera, pivot, {0.1, -0.2});
  CHECK(camera.eye.z < pivot.z);
  CHECK(length(cross(normalize(camera.look_at - camera.eye), camera.up)) > 0.05);
}

TEST_CASE("shifting moves the pivot by that part of the picture") {
  const Camera camera = level_camera();
  const Vec3d pivot(2, 1, 0.5);
  const Viewport square{400, 400};
  const auto at = Projection(shifted(camera, pivot, {0.25, -0.125}), square).point(pivot);
  REQUIRE(at);
  CHECK(at->x == Approx(200 + 100));
  CHECK(at->y == Approx(200 - 50));
}

TEST_CASE("coming nearer makes the pivot's surroundings larger by the factor") {
  const Camera camera = level_camera();
  const Vec3d pivot(2, 1, 0.5);
  const Viewport square{400, 400};
  const double before = Projection(camera, square).pixels_per_unit(pivot);
  CHECK(Projection(approached(camera, pivot, 2), square).pixels_per_unit(pivot) == Approx(2 * before));
  check_near(approached(approached(camera, pivot, 3), pivot, 1.0 / 3).eye, camera.eye);
}

TEST_CASE("a projection puts the look-at in the middle and the ends of SCREEN at the sides") {
  const Camera camera = level_camera();  // SCREEN: 1 wide at distance 1
  const Projection seen(camera, {400, 400});
  const auto middle = seen.point(camera.look_at), left = seen.point(camera.eye + Vec3d(1, 0.5, 0)),
             top = seen.point(camera.eye + Vec3d(1, 0, 0.5));
  REQUIRE((middle && left && top));
  CHECK(length(*middle - Vec2d(200, 200)) < 1e-9);
  CHECK(length(*left - Vec2d(0, 200)) < 1e-9);
  CHECK(length(*top - Vec2d(200, 0)) < 1e-9);
  CHECK_FALSE(seen.point(camera.eye - Vec3d(1, 0, 0)));
  CHECK_FALSE(seen.segment({-5, 0, 0}, {-6, 0, 0}));
  // Of a line that comes from behind the eye the part ahead is seen, in its direction.
  const auto part = seen.segment({-5, 1, 0}, {6, 1, 0});
  REQUIRE(part);
  CHECK((*part)[0].y > (*part)[1].y);
  CHECK((*part)[1].x == Approx(200));
}

TEST_CASE("the line view begins with the whole of each shipped scene in the pane") {
  const Viewport pane{860, 480};
  for (const std::string& path : shipped_scenes()) {
    CAPTURE(path);
    const Scene scene = read_document(path).scene;
    const Projection seen(overlooking(scene, pane), pane);
    Vec2d least(1e9), most(-1e9);  // of everything that has an end
    const auto eye = seen.point(scene.camera.eye);
    REQUIRE(eye);
    for (const Object& object : scene.objects) {
      const Bounds<double> box = bounds(object.shape);
      if (!box.bounded()) continue;
      const auto at = seen.point(affine_of(object.transform).point(box.min + (box.max - box.min) / 2.0));
      REQUIRE(at);
      CHECK((at->x > 0 && at->x < pane.width && at->y > 0 && at->y < pane.height));
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3d own{(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                        (corner & 4) != 0 ? box.max.z : box.min.z};
        const auto spot = seen.point(affine_of(object.transform).point(own));
        REQUIRE(spot);
        least = {std::min(least.x, spot->x), std::min(least.y, spot->y)};
        most = {std::max(most.x, spot->x), std::max(most.y, spot->y)};
      }
    }
    least = {std::min(least.x, eye->x), std::min(least.y, eye->y)};
    most = {std::max(most.x, eye->x), std::max(most.y, eye->y)};
    CHECK((eye->x > 0 && eye->x < pane.width && eye->y > 0 && eye->y < pane.height));
    for (const Light& light : scene.lights)
      if (const auto middle = middle_of(light))
        if (const auto at = seen.point(*middle);
            at && at->x > 0 && at->x < pane.width && at->y > 0 && at->y < pane.height) {
          least = {std::min(least.x, at->x), std::min(least.y, at->y)};
          most = {std::max(most.x, at->x), std::max(most.y, at->y)};
        }
    // All of it, and as large as the pane lets it be.
    CHECK((least.x > 0 && most.x < pane.width && least.y > 0 && most.y < pane.height));
    CHECK(std::max((most.x - least.x) / pane.width, (most.y - least.y) / pane.height) > 0.6);
  }
}
