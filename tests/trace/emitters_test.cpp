// Objects as lights: what is drawn meets the light where it should, its density is the one that a ray which meets the
// light by chance would be told, and the mean of 1 / density is the solid angle that the light fills.

#include "trace/emitters.h"

#include "math/sampler.h"
#include "math/sampling.h"
#include "trace/drawn.h"
#include "trace/pictures.h"

#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene lit_by(Shape<double> shape, std::vector<TransformStep> transform = {}) {
  Material material = black();
  material.emission = Rgbd(2.0);
  Scene scene;
  scene.objects = {object("Light", std::move(shape), material)};
  scene.objects[0].transform = std::move(transform);
  return scene;
}

struct Counted {
  double by_light = 0, by_direction = 0;  // solid angle of the light, estimated from each side
  int met = 0, wrong = 0, unseen = 0;
};

// Draws on the light, and in all directions within an angle of the origin, from a point.
Counted count(const Scene& scene, const Vec3d& point, double angle = pi_v<double>, std::uint32_t n = 1 << 15) {
  const World<double> world(scene);
  const Emitters<double> lights(world);
  REQUIRE_FALSE(lights.empty());
  TestCounts tests;
  Counted counted;
  const Basis<double> around(normalize(-point));
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto pdf_at = [&](const Ray<double>& ray, const Hit<double>& hit) {
      const auto met =
          world.accelerator.primitives().surface_at(hit.primitive, ray, Intersection<double>{hit.t, hit.part});
      return lights.pdf(point, hit.primitive, hit.part, met.position, met.normal);
    };
    if (const auto sample = lights.sample(point, drawn(i, 4).x, drawn(i, 0))) {
      const Ray<double> ray{point, sample->to_light};
      const auto hit = world.accelerator.closest(ray, infinity<double>, tests);
      if (hit && hit->primitive == sample->primitive && hit->part == sample->part) {
        counted.by_light += 1 / sample->pdf / n;
        // What is met is the point drawn, and its density is the one it was drawn with.
        if (std::abs(hit->t - 1) > 1e-6 || std::abs(pdf_at(ray, *hit) / sample->pdf - 1) > 1e-5) ++counted.wrong;
      } else {
        ++counted.unseen;
      }
    }
    const Ray<double> ray{point, around.to_world(sample_uniform_cone(drawn(i, 2), one_minus_cos_of(angle)))};
    if (const auto hit = world.accelerator.closest(ray, infinity<double>, tests)) {
      counted.by_direction += 1 / uniform_cone_pdf(one_minus_cos_of(angle)) / n;
      ++counted.met;
      if (!(pdf_at(ray, *hit) > 0)) ++counted.wrong;
    }
  }
  return counted;
}

}  // namespace

TEST_CASE("each shape is drawn by the density that it tells, and fills the solid angle that it fills", "[odds]") {
  const std::vector<TransformStep> turned{{Scale{{2, 2, 2}}}, {Rotate{{1, 2, 3}, 40}}, {Translate{{0.3, -0.2, 0.4}}}};
  const std::vector<TransformStep> sheared{
      {Scale{{2, 0.5, 1}}}, {Shear{0.4, 0, 0, 0.2, 0, 0}}, {Rotate{{0, 1, 1}, 70}}};
  struct Case {
    const char* name;
    Shape<double> shape;
    bool round;  // only a similarity keeps it what it is
  };
  const std::vector<Case> cases{
      {"sphere", Sphere<double>{{0, 0, 0}, 0.8}, true},
      {"disk", Disk<double>{{0, 0, 0}, {1, 1, -2}, 0.9}, false},
      {"triangle", Triangle<double>{{-1, 0, 0}, {1, 0.2, 0.3}, {0, 1, -0.4}}, false},
      {"rectangle", Polygon<double>{{{-1, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0}, {-1, 0.5, 0}}, {}}, false},
      {"parallelogram", Polygon<double>{{{-1, -0.5, 0}, {1, -0.5, 0}, {1.5, 0.5, 0}, {-0.5, 0.5, 0}}, {}}, false},
      {"pentagon", Polygon<double>{{{-1, -0.5, 0}, {1, -0.5, 0}, {1.2, 0.3, 0}, {0, 1, 0}, {-1.2, 0.3, 0}}, {}}, false},
      {"box", Box<double>{{-0.5, -0.4, -0.3}, {0.6, 0.5, 0.4}}, false},
      {"prism", Prism<double>{{{-0.7, -0.6}, {0.8, -0.5}, {0.6, 0.7}, {-0.3, 0.8}}, 0.9}, false}};
  std::size_t turn = 0;
  for (const Case& one : cases)
    for (const int mapped : {0, 1, 2}) {
      if (mapped == 2 && one.round) continue;
      INFO(one.name << ", map " << mapped);
      const Scene scene = lit_by(one.shape, mapped == 0   ? std::vector<TransformStep>{}
                                            : mapped == 1 ? turned
                                                          : sheared);
      for (const Vec3d& point : {Vec3d(1.5, 2, 2.5), Vec3d(-0.4, 2.6, -3)}) {
        if (left_to_all(turn++, 3)) continue;
        const Counted counted = count(scene, point, 0.9);
        CHECK(counted.wrong == 0);
        CHECK(counted.met > 50);
        CHECK(counted.by_light == Approx(counted.by_direction).epsilon(0.005 + 2 / std::sqrt(counted.met)));
      }
    }
}

TEST_CASE("from inside, the light is all around", "[odds]") {
  for (const Shape<double>& shape :
       {Shape<double>(Sphere<double>{{0, 0, 0}, 2}), Shape<double>(Box<double>{{-2, -3, -1}, {1, 2, 3}}),
        Shape<double>(Prism<double>{{{-2, -2}, {2, -1}, {0, 3}}, 3})}) {
    const Counted counted = count(lit_by(shape), {0.2, -0.3, 0.4});
    CHECK(counted.wrong == 0);
    CHECK(counted.unseen == 0);
    CHECK(counted.by_direction == Approx(4 * pi_v<double>).epsilon(1e-12));
    CHECK(counted.by_light == Approx(4 * pi_v<double>).epsilon(0.01));
  }
}

TEST_CASE("lights are picked by area times radiance, and together they are one density") {
  Scene scene = lit_by(Sphere<double>{{3, 0, 0}, 0.5});
  Material bright = black(), dark = black();
  bright.emission = Rgbd(7, 5, 3);
  scene.objects.push_back(
      object("Panel", Polygon<double>{{{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}}, {}}, bright));
  scene.objects.push_back(object("Black", Sphere<double>{{0, 0, 9}, 1}, dark));
  scene.objects.push_back(object("Lid", Triangle<double>{{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, bright));
  const World<double> world(scene);
  const Emitters<double> lights(world);
  std::vector<int> picked(4);
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const auto sample = lights.sample({0, 0, 0}, (i + 0.5) / n, Vec2d(0.3, 0.6));
    REQUIRE(sample);
    ++picked[static_cast<std::size_t>(sample->primitive)];
  }
  const double sphere = 4 * pi_v<double> * 0.25 * 6, panel = 4 * 15, lid = 2 * 15, sum = sphere + panel + lid;
  CHECK(picked[0] == Approx(n * sphere / sum).margin(2));
  CHECK(picked[1] == Approx(n * panel / sum).margin(2));
  CHECK(picked[2] == 0);
  CHECK(picked[3] == Approx(n * lid / sum).margin(2));
  CHECK(lights.several());
}

TEST_CASE("what cannot be drawn is left to chance and says so") {
  const Material glow = [] {
    Material material = black();
    material.emission = Rgbd(1.0);
    return material;
  }();
  Scene scene;
  scene.objects = {
      object("Plane", Plane<double>{{0, 0, -1}, {0, 0, 1}}, glow),
      object("Star", Polygon<double>{{{0, 3, 2}, {-1.8, -2.4, 2}, {2.9, 0.9, 2}, {-2.9, 0.9, 2}, {1.8, -2.4, 2}}, {}},
             glow),
      object("Concave", Polygon<double>{{{0, 0, 2}, {2, 0, 2}, {0.5, 0.5, 2}, {0, 2, 2}}, {}}, glow),
      object("Egg", Sphere<double>{{5, 0, 0}, 1}, glow)};
  scene.objects[3].transform = {{Scale{{1, 2, 1}}}};
  const World<double> world(scene);
  const Emitters<double> lights(world);
  CHECK(lights.empty());
  for (int id = 0; id < 4; ++id) CHECK(lights.pdf({0, 0, 0}, id, 0, {0, 0, 2}, {0, 0, 1}) == 0);
  CHECK(Emitters<float>(World<float>(scene)).empty());
  // A prism that is not convex lends its sides alone.
  Scene bent;
  bent.objects = {object("Bent", Prism<double>{{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, 1}, glow)};
  const World<double> bent_world(bent);
  const Emitters<double> sides(bent_world);
  CHECK(sides.pdf({1, -2, 0}, 0, 0, {1, 0, 0}, {0, -1, 0}) > 0);
  CHECK(sides.pdf({0, 0, 4}, 0, 4, {0.2, 0.2, 0.5}, {0, 0, 1}) == 0);
  // The point drawn may be hidden behind another face of the light, or anything else.
  CHECK(count(bent, {3, 3, 0.1}, pi_v<double>, 1 << 12).unseen > 100);
}

TEST_CASE("float draws what double draws") {
  const Scene scene = lit_by(Sphere<double>{{3, 1, -2}, 0.5});
  const World<double> wide(scene);
  const World<float> narrow(scene);
  const Emitters<double> a(wide);
  const Emitters<float> b(narrow);
  for (std::uint32_t i = 0; i < 500; ++i) {
    const auto x = a.sample({0, 0, 0}, 0.5, drawn(i));
    const auto y = b.sample({0, 0, 0}, 0.5f, Vec2<float>(drawn(i)));
    REQUIRE(x);
    REQUIRE(y);
    if (length(x->to_light - Vec3d(y->to_light)) > 1e-5) FAIL("another way");
    if (std::abs(x->pdf / static_cast<double>(y->pdf) - 1) > 1e-5) FAIL("another density");
  }
}

TEST_CASE("a light that moves is left to chance") {
  Scene scene = lit_by(Sphere<double>{{3, 1, -2}, 0.5});
  CHECK_FALSE(Emitters<double>(World<double>(scene)).empty());
  scene.objects[0].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  CHECK(Emitters<double>(World<double>(scene)).empty());
}
