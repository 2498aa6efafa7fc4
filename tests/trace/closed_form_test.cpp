// Distributed effects against formulas: what they converge to is known exactly.

#include <cmath>
#include <numbers>

#include "support/catch.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Solid angle of the rectangle 0..a x 0..b at height h over its corner's foot.
double corner_solid_angle(double a, double b, double h) {
  return std::atan2(a * b, h * std::sqrt(a * a + b * b + h * h));
}

/// What stands before one half of a disk of radius 1 when the edge is at x: the share beyond it.
double beyond(double x) {
  if (x >= 1) return 0;
  if (x <= -1) return 1;
  return 0.5 - (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
}

}  // namespace

TEST_CASE("a rectangle of point lights parallel to a floor gives its solid angle over its area") {
  // Each point gives cos / r^2 there, which is what the rectangle's own elements show of themselves.
  const double a = 1.5, b = 0.8, h = 2;
  const Light light{"Panel", Rgbd(3.0), RectangleLight{{0.2, 0.1, h}, {a, 0, 0}, {0, b, 0}, 1, {0, 0, 1}}};
  const auto at = [&](double x, double y) { return corner_solid_angle(x, y, h); };
  const double solid_angle = at(0.2 + a, 0.1 + b) - at(0.2, 0.1 + b) - at(0.2 + a, 0.1) + at(0.2, 0.1);
  const double exact = 3 * solid_angle / (a * b);
  Scene scene = lit_floor(light);
  SECTION("a regular grid converges with the square of its step") {
    scene.render.integrator = Integrator::whitted;
    double last = 0;
    for (const int n : {2, 4, 8, 16}) {
      scene.render.light_grid = n;
      const double error = std::abs(shade_along(scene, {0, -1, 1}, {0, 0, 0}).x - exact);
      if (n > 2) CHECK(last / error == Approx(4).epsilon(0.05));
      last = error;
    }
    CHECK(last < 2e-4 * exact);
  }
  SECTION("samples are right in the mean, however they are placed") {
    scene.render.integrator = Integrator::distributed;
    for (const Sampler sampler : {Sampler::random, Sampler::jittered, Sampler::sobol})
      for (const int n : {1, 3}) {
        CAPTURE(name_of(sampler), n);
        scene.render.sampler = sampler;
        scene.render.light_grid = n;
        const Sampled sampled = sample(scene, {0, -1, 1}, {0, 0, 0}, 4096);
        CHECK(std::abs(sampled.mean - exact) < sampled.tolerance());
        CHECK(sampled.tolerance() < 0.02 * exact);
        CHECK(sampled.statistics.formed(RayKind::shadow) == static_cast<std::uint64_t>(4096 * n * n));
        CHECK(sampled.statistics.drawn(Effect::penumbra) == static_cast<std::uint64_t>(4096 * n * n * 2));
      }
  }
}

TEST_CASE("a sphere of point lights shines like its middle where light weakens with the square") {
  // Not so the cosine, unless the sphere stands straight above; over all its points it averages to the middle's, too:
  // both together are the field of a charged shell (Newton's theorem).
  const Light bulb{"Bulb", Rgbd(2.0), SphereLight{{0.7, 0.4, 2}, 0.9, 1, {0, 0, 1}}};
  Scene scene = lit_floor(bulb);
  const double distance = std::sqrt(0.7 * 0.7 + 0.4 * 0.4 + 4), exact = 2 * 2 / std::pow(distance, 3);
  const Sampled sampled = sample(scene, {0, -1, 1}, {0, 0, 0}, 16384);
  CHECK(std::abs(sampled.mean - exact) < sampled.tolerance());
  CHECK(sampled.tolerance() < 0.03 * exact);
  scene.lights[0].kind = SphereLight{{0.7, 0.4, 2}, 0, 5, {0, 0, 1}};
  CHECK(sample(scene, {0, -1, 1}, {0, 0, 0}, 2).mean == Approx(exact).epsilon(1e-8));
}

TEST_CASE("the penumbra of a rectangle light behind a straight edge is a linear ramp") {
  // A wall of height h covers x < 0; light spans -a..a in x at height H. From x the edge hides light left of
  // x + (0 - x) H / h.
  const double a = 0.5, light_height = 4, edge_height = 1;
  Scene scene =
      lit_floor({"Panel", Rgbd(1.0), RectangleLight{{-a, -0.2, light_height}, {2 * a, 0, 0}, {0, 0.4, 0}, 1, {}}});
  scene.objects.push_back(object("Cover", Box<double>{{-90, -50, edge_height}, {0, 50, edge_height + 1e-6}}, black()));
  scene.render.integrator = Integrator::whitted;
  constexpr int n = 64;
  scene.render.light_grid = n;
  int partial = 0;
  for (const double x : {-0.3, -0.15, -0.1, -0.05, 0.0, 0.04, 0.09, 0.13, 0.16, 0.2, 0.4}) {
    const Statistics statistics = picture<double>(looking(scene, {x + 0.5, -1e-4, 0.4}, {x, 0, 0}), 1, 1).statistics;
    const double lit = static_cast<double>(statistics.ends(Ending::reached_light)) / (n * n);
    const double edge = x * (1 - light_height / edge_height);
    const double exact = std::clamp((a - edge) / (2 * a), 0.0, 1.0);
    CAPTURE(x, lit, exact);
    CHECK(std::abs(lit - exact) <= 0.5 / n + 1e-9);  // the grid counts whole columns
    partial += exact > 0 && exact < 1;
  }
  CHECK(partial >= 6);
}

TEST_CASE("a lens blurs an edge as the area of its disk beyond it") {
  // Left of the edge a glowing wall at distance d; the lens is focused at f. Through the point s of the plane at
  // distance 1, the ray from the lens point l meets the wall at s d + l (1 - d / f).
  const double radius = 0.3, focus = 5, distance = 2;
  Scene scene;
  scene.camera.aperture = radius;
  scene.camera.focus = focus;
  scene.camera.up = {0, 0, 1};
  scene.objects = {object(
      "Wall", Polygon<double>{{{distance, 0, -50}, {distance, 50, -50}, {distance, 50, 50}, {distance, 0, 50}}, {}},
      glowing(1))};
  const double blur = radius * (1 - distance / focus);
  for (const double offset : {-0.2, -0.15, -0.05, 0.0, 0.08, 0.14, 0.2}) {
    const double s = offset / distance;  // to the left of the view is +y
    Scene aimed = scene;
    aimed.camera.eye = Vec3d(0.0);
    aimed.camera.look_at = Vec3d(1, 0, 0);
    // The edge is moved rather than the view, so that the plane in focus stays where it is.
    auto& corners = std::get<Polygon<double>>(aimed.objects[0].shape).outline;
    corners[0].y = corners[3].y = -s * distance;
    const double exact = beyond(-offset / blur);
    const auto mean_of = [&](Sampler sampler, int samples) {
      aimed.render.sampler = sampler;
      aimed.camera.screen = {1, 1e-9, 1};
      return sample(aimed, {0, 0, 0}, {1, 0, 0}, samples);
    };
    CAPTURE(offset, exact);
    const Sampled random = mean_of(Sampler::random, 4000);
    CHECK(std::abs(random.mean - exact) <= random.tolerance() + 1e-9);
    // Well spread samples miss the disk's part by no more than the cells that the edge cuts.
    CHECK(std::abs(mean_of(Sampler::jittered, 4096).mean - exact) < 0.006);
    CHECK(std::abs(mean_of(Sampler::sobol, 4096).mean - exact) < 0.006);
  }
  // What is in focus stays sharp.
  auto& corners = std::get<Polygon<double>>(scene.objects[0].shape).outline;
  for (Vec3d& corner : corners) corner.x = focus;
  corners[0].y = corners[3].y = 1e-6;
  CHECK(sample(scene, {0, 0, 0}, {1, 0, 0}, 100).mean == 0);
  corners[0].y = corners[3].y = -1e-6;
  CHECK(sample(scene, {0, 0, 0}, {1, 0, 0}, 100).mean == 1);
}

TEST_CASE("a glossy mirror gathers its cone, every direction alike") {
  // A mirror looked at straight on, and a glowing disk around its normal that fills part of the cone.
  const double half_angle = 20;
  Scene scene;
  Material rough = black();
  rough.reflection = Rgbd(0.8);
  rough.gloss = half_angle;
  scene.objects = {object("Mirror", Plane<double>{{0, 0, 0}, {1, 0, 0}}, rough),
                   object("Glow", Disk<double>{{10, 0, 0}, {1, 0, 0}, 1}, glowing(1))};
  for (const double angle : {0.0, 5.0, 12.0, 19.9, 25.0}) {
    std::get<Disk<double>>(scene.objects[1].shape).radius = angle > 0 ? 10 * std::tan(angle * degree) : 1e-9;
    const double share = std::min((1 - std::cos(angle * degree)) / (1 - std::cos(half_angle * degree)), 1.0);
    CAPTURE(angle, share);
    const Sampled random = [&] {
      scene.render.sampler = Sampler::random;
      return sample(scene, {5, 0, 0}, {0, 0, 0}, 4000);
    }();
    CHECK(std::abs(random.mean - 0.8 * share) <= random.tolerance() + 1e-9);
    scene.render.sampler = Sampler::jittered;
    CHECK(std::abs(sample(scene, {5, 0, 0}, {0, 0, 0}, 4096).mean - 0.8 * share) < 0.8 * 0.008);
  }
}

TEST_CASE("a translucent sheet spreads what it transmits, and a lobe never leaves its side") {
  Scene scene;
  scene.background = Rgbd(0.25);
  Material frosted = black();
  frosted.transmission = Rgbd(1.0);
  frosted.ior = 1;
  frosted.translucency = 90;  // all of the half space behind
  scene.objects = {object("Sheet", Disk<double>{{0, 0, 0}, {1, 0, 0}, 50}, frosted),
                   object("Front", Plane<double>{{9, 0, 0}, {1, 0, 0}}, glowing(8))};
  // Sheets as thin as this are entered and never left; what is behind is background alone, what is before it glows.
  const Sampled through = sample(scene, {5, 0, 0}, {0, 0.5, 0.2}, 500);
  CHECK(through.mean == 0.25);
  CHECK(through.variance == 0);
  Material rough = black();
  rough.reflection = Rgbd(1.0);
  rough.gloss = 90;
  scene.objects[0].material = rough;
  // Seen aslant half of the cone would lie behind the mirror: it is folded back, no light is lost.
  scene.objects[1] = object("Around", Sphere<double>{{0, 0, 0}, 40}, glowing(2));
  const Sampled mirrored = sample(scene, {5, 0, 0}, {0, 4.9, 0}, 500);
  CHECK(mirrored.mean == 2);
  CHECK(mirrored.variance == 0);
}

TEST_CASE("a spot shines in full within its inner cone, then less, then not at all") {
  const SpotLight spot{{0, 0, 2}, {0, 0, 0}, 60, 30, {}};
  Scene scene = lit_floor({"Spot", Rgbd(1.0), spot});
  const auto at = [&](double angle) {
    const double x = 2 * std::tan(angle * degree);
    const Vec3d target(x, 0, 0);
    const double cosine = std::cos(angle * degree);  // of the floor; the light does not weaken with distance
    return shade_along(scene, target + Vec3d(0, -1, 1), target).x / cosine;
  };
  CHECK(at(0) == Approx(1).epsilon(1e-12));
  CHECK(at(14.9) == Approx(1).epsilon(1e-12));
  const double middle = (std::cos(15 * degree) + std::cos(30 * degree)) / 2;
  CHECK(at(std::acos(middle) / degree) == Approx(0.5).epsilon(1e-9));
  const double quarter = 0.25 * std::cos(15 * degree) + 0.75 * std::cos(30 * degree);
  CHECK(at(std::acos(quarter) / degree) == Approx(0.25 * 0.25 * 2.5).epsilon(1e-9));
  CHECK(at(30.1) == 0);
  // No shadow ray is formed where the spot does not shine.
  const Statistics outside = picture<double>(looking(scene, {5, -1, 1}, {5, 0, 0}), 1, 1).statistics;
  CHECK(outside.ends(Ending::outside_cone) == 1);
  CHECK(outside.formed(RayKind::shadow) == 0);
  std::get<SpotLight>(scene.lights[0].kind).inner_angle = 60;  // a sharp edge
  CHECK(at(29.9) == Approx(1).epsilon(1e-12));
  CHECK(at(30.1) == 0);
}

TEST_CASE("a texture lies on the surface in its own units, smooth between the middles of its pixels") {
  Scene scene;
  Material material = black();
  material.ambient = Rgbd(1.0);
  const auto pixels = std::make_shared<Image>(
      Image{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}});  // red, green over blue, white
  material.texture = ImageTexture{"four.png", 2, 4, pixels};
  scene.objects = {object("Wall", Plane<double>{{0, 0, 0}, {0, 0, 1}}, material)};
  const auto at = [&](double u, double v) { return shade_along(scene, {u, v, 3}, {u, v, 0}); };
  const auto near = [](const Rgbd& a, const Rgbd& b) {
    return max_component(a - b) < 1e-6 && max_component(b - a) < 1e-6;
  };
  // A plane with its normal up has u along x and v along y.
  CHECK(near(at(0.5, 1), {0, 0, 1}));
  CHECK(near(at(1.5, 1), {1, 1, 1}));
  CHECK(near(at(0.5, 3), {1, 0, 0}));
  CHECK(near(at(1.5, 3), {0, 1, 0}));
  CHECK(near(at(1, 3), {0.5, 0.5, 0}));
  CHECK(near(at(0.5, 2), {0.5, 0, 0.5}));
  CHECK(near(at(0.75, 1), {0.25, 0.25, 1}));
  CHECK(near(at(0, 1), {0.5, 0.5, 1}));  // over the seam: half white, half blue
  CHECK(near(at(-1.5, -7), {0, 0, 1}));  // repeated
  CHECK(near(at(0.5 + 2000, 1 - 4000), {0, 0, 1}));
  scene.objects[0].material.texture->wrap = ImageWrap::clamp;
  CHECK(near(at(0.75, 1), {0.25, 0.25, 1}));
  CHECK(near(at(0, 1), {0, 0, 1}));
  CHECK(near(at(-1000, 3), {1, 0, 0}));
  CHECK(near(at(1.5, 4000), {0, 1, 0}));
  CHECK(near(at(7, -9), {1, 1, 1}));
  scene.objects[0].material.texture->wrap = ImageWrap::mirror;
  CHECK(near(at(0.75, 1), {0.25, 0.25, 1}));
  CHECK(near(at(-0.75, 1), {0.25, 0.25, 1}));
  CHECK(near(at(2.5, 1), {1, 1, 1}));
  CHECK(near(at(3.5 + 4000, 5), {1, 0, 0}));
  scene.objects[0].material.texture->wrap = ImageWrap::repeat;
  scene.objects[0].material.diffuse = Rgbd(1.0);
  scene.objects[0].material.ambient = Rgbd(0.0);
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};
  CHECK(near(at(1.5, 3), {0, 1, 0}));  // diffuse light too
  scene.objects[0].material.texture->pixels.reset();
  CHECK(near(at(1.5, 3), {1, 1, 1}));  // not loaded: white
}
