// The walk through CONE TRACING, and what cones make of pictures.

#include "math/random.h"
#include "scene/cone_limits.h"
#include "timeline/message.h"
#include "timeline/recorder.h"
#include "trace/scene_kernel.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "messages.h"
#include "support/catch.h"
#include "support/effort.h"
#include "width_scenes.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene cone_plain() {
  Scene scene = plain_scene(Integrator::cones);
  scene.image = {16, 12};
  return scene;
}

/// A lamp with an extent, gloss, glass and a round mirror.
Scene cone_lit() {
  Scene scene = cone_plain();
  Material matt, chrome, glass, brushed;
  matt.diffuse = {0.2, 0.7, 0.3};
  matt.specular = Rgbd(0.4);
  matt.ambient = Rgbd(0.1);
  chrome.diffuse = glass.diffuse = Rgbd(0.05);
  chrome.reflection = Rgbd(0.8);
  glass.transmission = Rgbd(0.9);
  glass.dielectric = true;
  brushed.reflection = Rgbd(0.6);
  brushed.gloss = 4;
  scene.objects = {{"Red", Prism<double>{{{-2, -0.3}, {-0.5, -1.2}, {-2, -1.7}}, 1}, shining({1, 0, 0})},
                   {"Matt", Sphere<double>{{-1.3, 1.1, 0}, 0.8}, matt},
                   {"Glass", Box<double>{{0, 0.4, -1}, {3, 3, 1}}, glass},
                   {"Chrome", Sphere<double>{{2.5, -0.8, 0}, 0.9}, chrome},
                   {"Glass ball", Sphere<double>{{-3, 0.3, 0}, 0.3}, glass},
                   {"Brushed", Prism<double>{{{-3, -3}, {2, -2.6}, {2, -3.4}}, 1}, brushed},
                   {"Back", Box<double>{{4, -9, -1}, {5, 9, 1}}, matt},
                   {"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matt}};
  scene.lights = {{"Lamp", Rgbd(0.9), SphereLight{{-3, 4, 0}, 0.5, 16, {1, 0, 0}}},
                  {"Sun", Rgbd(0.2), DirectionalLight{{-1, -0.4, 0}}}};
  return scene;
}

/// The picture's pixels, in double.
std::vector<Rgbd> cone_picture(const Scene& scene, int samples = 1, std::uint64_t* draws = nullptr) {
  const World<double> world(scene);
  const SceneKernel<double> kernel(scene, world);
  const RayGenerator<double> camera(scene, scene.image, scene.image, {samples, 0});
  std::vector<Rgbd> sums(static_cast<std::size_t>(scene.image.width * scene.image.height), Rgbd(0.0));
  PixelBlock block{0, scene.image.width, 0, scene.image.height};
  block.samples = samples;
  const Statistics statistics = kernel(camera, block, [&](const Pixel& pixel, const Rgbd& shade) {
    sums[static_cast<std::size_t>(pixel.row * scene.image.width + pixel.column)] +=
        shade / static_cast<double>(samples);
  });
  if (draws != nullptr) *draws = statistics.random_draws();
  return sums;
}

double cone_error(const std::vector<Rgbd>& a, const std::vector<Rgbd>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

TEST_CASE("a walk of cones: the shares of each add up to 1, and every step has its words") {
  const Scene scene = cone_lit();
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_cones());
  CHECK(timeline.has_width());
  CHECK(timeline.is_flat());
  CHECK_FALSE(timeline.of_beams());
  CHECK(timeline.pixels().size() == 16);
  for (int position = 1; position <= timeline.steps(); ++position) {
    CHECK_FALSE(describe(scene, timeline, position).id.empty());
    const auto* cut = std::get_if<BeamCut>(&timeline.event(position - 1).detail);
    if (cut == nullptr) continue;
    double sum = 0;
    for (const BeamPiece& piece : cut->pieces) sum += piece.coverage;
    CHECK(sum == Approx(1).epsilon(1e-12));
  }
  for (const PixelRecord& pixel : timeline.pixels()) {
    CHECK(timeline.stack(pixel.done_at).empty());
    CHECK(std::isfinite(pixel.shade.x + pixel.shade.y + pixel.shade.z));
  }
}

TEST_CASE("watching cones changes nothing, and they draw no random number") {
  const Scene scene = cone_lit();
  std::uint64_t draws = 1;
  const std::vector<Rgbd> picture = cone_picture(scene, 1, &draws);
  CHECK(draws == 0);
  for (const int column : {0, 5, 11})
    for (const int row : {2, 5, 9}) {
      const Timeline timeline = record_pixel(scene, scene.image, column, row);
      REQUIRE(timeline.of_cones());
      CHECK_FALSE(timeline.is_flat());
      CHECK(timeline.pixels()[0].shade == picture[static_cast<std::size_t>(row * scene.image.width + column)]);
    }
}

TEST_CASE("in the plan a cone sees of one object what all its rays do") {
  Scene scene = cone_plain();
  scene.objects = {{"Ball", Sphere<double>{{-1, 0.4, 0}, 0.7}, shining({1, 1, 1})}};
  scene.background = Rgbd(0.0);
  const std::vector<Rgbd> strip = shades_of_strip(scene);
  constexpr int samples = 4096, cells = 16;
  Scene rays = scene;
  rays.render.integrator = Integrator::whitted;
  const World<double> world(rays);
  const RayGenerator<double> camera(rays, {cells * samples, 1}, rays.image);
  std::vector<double> met(cells, 0);
  static_cast<void>(trace(world, camera, {0, cells * samples, 0, 1}, [&](const Pixel& pixel, const Rgbd& shade) {
    met[static_cast<std::size_t>(pixel.column / samples)] += shade.x / samples;
  }));
  int partly = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    // SCREEN is seen aslant, which the cone's own width is not.
    CHECK(strip[i].x == Approx(met[i]).margin(0.01));
    if (met[i] > 0.01 && met[i] < 0.99) ++partly;
  }
  CHECK(partly == 2);
}

TEST_CASE("flat mirrors leave what is seen in them as it is") {
  Scene scene = cone_plain();
  scene.objects = {{"Ball", Sphere<double>{{-1, 0.4, 0}, 0.7}, shining({1, 1, 1})}};
  scene.background = Rgbd(0.0);
  const std::vector<Rgbd> direct = shades_of_strip(scene);
  // The same in a mirror across the view, which turns left and right about.
  Material mirror;
  mirror.diffuse = mirror.ambient = Rgbd(0.0);
  mirror.reflection = Rgbd(1.0);
  scene.objects[0].shape = Sphere<double>{{-7, 0.4, 0}, 0.7};
  scene.objects.push_back({"Mirror", Box<double>{{-4, -9, -9}, {-3, 9, 9}}, mirror});
  const std::vector<Rgbd> mirrored = shades_of_strip(scene);
  for (std::size_t i = 0; i < direct.size(); ++i) CHECK(mirrored[i].x == Approx(direct[i].x).epsilon(0).margin(1e-12));
}

TEST_CASE("a shadow cone from a place to a lamp: what an edge leaves of it, as its middle moves across") {
  // Above a floor of the plan, a wall whose edge hides the lamp in part.
  Scene scene = cone_plain();
  Material matt;
  matt.diffuse = Rgbd(1.0);
  matt.ambient = Rgbd(0.0);
  scene.background = scene.ambient = Rgbd(0.0);
  scene.objects = {{"Ground", Box<double>{{4, -20, -1}, {5, 20, 1}}, matt},
                   {"Edge", Box<double>{{0, 3, -1}, {0.001, 30, 1}}, matt}};
  const double radius = 0.5;
  scene.lights = {{"Lamp", Rgbd(1.0), SphereLight{{-4, 3, 0}, radius, 16, {1, 0, 0}}}};
  scene.camera.screen.cells = 601;  // narrow ones: a shadow cone that starts as a point
  const Timeline timeline = record_strip(scene);
  int partly = 0;
  for (int i = 0; i < timeline.steps(); ++i) {
    const auto* found = std::get_if<Found>(&timeline.event(i).detail);
    if (found == nullptr) continue;
    const RayRecord& shadow = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(i + 1))];
    if (shadow.origin.x < 3.999) continue;
    // The lamp's part above the line from the place through the edge is hidden.
    const Vec2d to = plan(shadow.direction), l = to / length(to), across(-l.y, l.x);
    const Vec2d edge = Vec2d(0, 3) - plan(shadow.origin);
    const double share = dot(edge, l) / length(to);
    // As wide as the part at its start, as wide as the lamp at its end.
    CHECK(shadow.end_radius == radius);
    const double line = dot(edge, across) / (shadow.radius + share * (shadow.end_radius - shadow.radius));
    const double expected = std::clamp((1 - line) / 2, 0.0, 1.0);
    CHECK(found->transmittance.x == Approx(expected).margin(0.002));
    if (expected > 0.02 && expected < 0.98) ++partly;
  }
  CHECK(partly > 20);
}

TEST_CASE("in the plan a lamp nearer than it is wide lights by all of it, not by its middle") {
  Scene scene = plain_scene(GENERATE(Integrator::cones, Integrator::beams));
  Material matt;
  matt.diffuse = Rgbd(1.0);
  matt.ambient = Rgbd(0.0);
  scene.background = scene.ambient = Rgbd(0.0);
  scene.objects = {{"Ground", Box<double>{{4, -20, -1}, {5, 20, 1}}, matt}};
  scene.lights = {{"Lamp", Rgbd(1.0), RectangleLight{{3.7, -0.5, -0.05}, {0, 1, 0}, {0, 0, 0.1}, 4, {1, 0, 0}}}};
  scene.camera.screen.cells = 601;
  // The mean of the cosine over the lamp, from the place before its middle.
  CHECK(shades_of_strip(scene)[300].x == Approx(2 * 0.3 * std::asinh(0.5 / 0.3)).epsilon(0.005));
  // Its half in the wall lights nothing, and from a place aside the other one's cosines are (c - cos) / r.
  scene.lights = {{"Lamp", Rgbd(1.0), RectangleLight{{3, 1, -0.05}, {2, 0, 0}, {0, 0, 0.1}, 4, {1, 0, 0}}}};
  CHECK(shades_of_strip(scene)[300].x == Approx((std::sqrt(2) - 1) / 2).epsilon(0.01));
}

TEST_CASE("one cone a pixel is nearer to many samples than one sample is, with gloss and penumbras") {
  Scene scene = cone_lit();
  scene.image = {32, 24};
  Scene sampled = scene;
  sampled.render.integrator = Integrator::distributed;
  const std::vector<Rgbd> truth = cone_picture(sampled, sanitized ? 64 : 256), one = cone_picture(sampled, 1),
                          cones = cone_picture(scene);
  CAPTURE(cone_error(cones, truth), cone_error(one, truth), cone_error(cone_picture(scene, 4), truth));
  CHECK(cone_error(cones, truth) < 0.5 * cone_error(one, truth));
}

TEST_CASE("one cone sees in small facets what many samples do: things, and the highlight of a lamp") {
  Scene scene = cone_plain();
  scene.image = {24, 18};
  Material rough;
  rough.diffuse = rough.ambient = Rgbd(0.0);
  const auto errors = [&] {
    scene.objects = {{"Rough", Box<double>{{1, -9, -9}, {2, 9, 9}}, rough},
                     {"Bar", Prism<double>{{{-8, -1}, {-7, -1}, {-7, 1}, {-8, 1}}, 9}, shining({1, 0.8, 0.2})},
                     {"Beyond", Box<double>{{6, -1, -1}, {7, 1, 1}}, shining({0.2, 0.9, 0.4})}};
    Scene sampled = scene;
    sampled.render.integrator = Integrator::distributed;
    const std::vector<Rgbd> truth = cone_picture(sampled, sanitized ? 196 : 400);
    Scene smooth = scene;
    smooth.objects[0].material.roughness = 0;
    return std::pair(cone_error(cone_picture(scene), truth), cone_error(cone_picture(smooth), truth));
  };
  SECTION("a mirror") {
    rough.reflection = Rgbd(1.0);
    rough.roughness = 0.1;
  }
  SECTION("a metal") {
    rough.reflection = Rgbd(1.0);
    rough.mirror = MirrorKind::gold;
    rough.roughness = 0.15;
  }
  SECTION("glass") {
    rough.transmission = Rgbd(1.0);
    rough.dielectric = true;
    rough.roughness = 0.2;
    scene.background = Rgbd(0.0);  // some of which would be caught between the faces, deeper than rays go
  }
  SECTION("a mirror's lamp") {
    rough.reflection = Rgbd(1.0);
    rough.roughness = 0.3;
    scene.lights = {{"Lamp", Rgbd(0.5), PointLight{{-4, 1, 1}, {1, 0, 0}}}};
  }
  const auto [cones, taken_as_smooth] = errors();
  CAPTURE(cones, taken_as_smooth);
  CHECK(cones < 0.4 * taken_as_smooth);
}

TEST_CASE("where cones cannot be followed, rays are, with the bits that rays have") {
  Scene scene = cone_lit();
  scene.objects.push_back({"Egg", Ellipsoid<double>{}, Material{}});
  CHECK(object_against_cones(scene) == "Egg");
  CHECK_FALSE(record_strip(scene).of_cones());
  Scene rays = scene;
  rays.render.integrator = Integrator::automatic;
  CHECK(cone_picture(scene) == cone_picture(rays));
}

TEST_CASE("every line and every message of cone tracing is reached") {
  std::set<std::string_view> messages;
  std::set<Line> lines;
  Scene alone = cone_plain();
  alone.objects = {{"Green", Sphere<double>{{-1.3, 1.1, 0}, 0.8}, shining({0, 1, 0})}};
  Scene shallow = cone_lit(), faint = cone_lit(), hollow = cone_lit();
  shallow.limits.depth = 1;
  faint.limits.threshold = 0.95;
  hollow.objects[3].shape = Sphere<double>{{0, 0, 0}, 30};  // a round mirror from inside brings a cone together
  const auto walk = [&](const Scene& scene, const Timeline& timeline) {
    REQUIRE(timeline.of_cones());
    for (int position = 1; position <= timeline.steps(); ++position) {
      messages.insert(describe(scene, timeline, position).id);
      lines.insert(timeline.event(position - 1).line);
    }
  };
  for (const Scene& scene : {cone_lit(), alone, shallow, faint, hollow}) walk(scene, record_strip(scene));
  walk(cone_lit(), record_pixel(cone_lit(), {16, 12}, 3, 5));
  CHECK(lines.size() == cone_line_count);
  for (const std::string_view id : test::cone_messages) {
    INFO(id);
    CHECK(messages.count(id) == 1);
  }
}
