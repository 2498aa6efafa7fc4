// (u, v) of what moves, and of triangles whose mesh has none: by value.

#include "accel/primitives.h"

#include "support/catch.h"

#include <limits>

using namespace raywalk;

namespace {

template <class T>
void expect(const Vec2<T>& uv, double u, double v) {
  const double rounding = 100 * static_cast<double>(std::numeric_limits<T>::epsilon());
  CHECK(static_cast<double>(uv.x) == Approx(u).epsilon(rounding).margin(rounding));
  CHECK(static_cast<double>(uv.y) == Approx(v).epsilon(rounding).margin(rounding));
}

/// Straight down at (x, y) at a time, from far above.
template <class T>
Vec2<T> uv_below(const Primitives<T>& primitives, int id, double x, double y, double time) {
  const Ray<T> down{Vec3<T>(Vec3d(x, y, 90)), {0, 0, -1}, {}, static_cast<T>(time)};
  const auto intersection = primitives.intersect(id, down, infinity<T>);
  REQUIRE(intersection);
  return primitives.uv_at(id, primitives.surface_at(id, down, *intersection), intersection->part, down.time);
}

}  // namespace

TEMPLATE_TEST_CASE("what is drawn on a thing moves with it", "[accel]", float, double) {
  using T = TestType;
  using V = Vec3<T>;
  Primitives<T> primitives;
  primitives.add(Box<T>{V(-1), V(3, 2, 1)});
  primitives.add(Plane<T>{V(1, 2, 0), V(0, 0, 1)});
  primitives.add(Disk<T>{V(1, 0, 0), V(0, -3, 4), 9});
  primitives.add(Cylinder<T>{V(4, 2, 1), -1, 1, true});
  primitives.add(Box<T>{V(-1), V(3, 2, 1)},
                 *object_transform<T>(rotation(Vec3d(0, 0, 1), 90.0) * scaling(Vec3d(2, 2, 1))));
  Mesh plain, drawn;
  plain.positions = {{-8, -8, 0}, {24, -8, 0}, {-8, 24, 0}};
  plain.triangles = {{0, 1, 2}};
  drawn = plain;
  drawn.uv = {{0, 0}, {32, 0}, {0, 96}};
  primitives.add(plain, Affine<double>{}, false);
  primitives.add(drawn, Affine<double>{}, false);
  primitives.move(0, primitives.size(), {{1, {0, 0, 0}}, {3, {4, -6, 2}}});
  primitives.set_shutter(0, 4);

  struct At {
    double time, x, y;
  };
  for (const At at : {At{0, 0, 0}, At{1, 0, 0}, At{2, 2, -3}, At{2.5, 3, -4.5}, At{3, 4, -6}, At{4, 4, -6}}) {
    CAPTURE(at.time);
    // Above (0.5, 1) of each as it stands at rest.
    const auto uv = [&](int id) { return uv_below(primitives, id, at.x + 0.5, at.y + 1, at.time); };
    expect(uv(0), 1.5, 2);
    expect(uv(1), -0.5, -1);
    expect(uv(2), -0.5, 1.25);  // 3 up for 4 along, so 5
    expect(uv(3), 0.5, 1);
    expect(uv(4), 1.5, 0.75);  // its own (0.5, -0.25)
    expect(uv(5), 8.5, 9);
    expect(uv(6), 8.5, 27);
  }
}

TEST_CASE("a triangle without coordinates of its own has lengths in the world", "[accel]") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.triangles = {{0, 1, 2}};
  Primitives<double> primitives;
  primitives.add(mesh, translation(Vec3d(1, 2, 3)) * scaling(Vec3d(2, 3, 1)), false);
  // A mesh beside it that has some changes nothing.
  mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
  primitives.add(mesh, Affine<double>{}, false);
  expect(uv_below(primitives, 0, 3, 8, 0), 2, 6);
  expect(uv_below(primitives, 1, 1, 2, 0), 0.25, 0.5);
}
