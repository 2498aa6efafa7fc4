// The path tracer against the tracer, against itself watched, in float, and by each strategy alone.

#include "support/catch.h"
#include "support/effort.h"
#include "trace/paths.h"

#include <set>

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Lights of all kinds, an object that shines, all lobes.
Scene all_scene() {
  Scene scene = busy_scene();
  for (Object& one : scene.objects)
    if (one.name == "Mirror") one.material.gloss = 4;
  scene.lights.push_back({"Ball", Rgbd(0.6), SphereLight{{-2, 0, 3}, 0.5, 1, {}}});
  scene.lights.push_back({"Panel", Rgbd(0.5), RectangleLight{{0, -3, 2}, {1, 0, 0}, {0, 1, 0}, 1, {}}});
  scene.lights.push_back({"Spot", Rgbd(0.8), SpotLight{{-4, 2, 3}, {0, 0, 0}, 40, 30, {}}});
  Material glow = black();
  glow.emission = Rgbd(4, 3, 2);
  scene.objects.push_back(object("Bulb", Sphere<double>{{-0.5, 1, 2}, 0.3}, glow));
  scene.objects.push_back(
      object("Tile", Polygon<double>{{{-3, -2, 2.5}, {-2, -2, 2.5}, {-2, -1, 2.5}, {-3, -1, 2.5}}, {}}, glow));
  return scene;
}

// E. Veach's plates: four strips of growing roughness below four balls of growing size and equal power.
Scene plates() {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.camera.eye = {-6, 0, 2.2};
  scene.camera.look_at = {0, 0, 0.3};  // the balls themselves, above, are not in the picture
  scene.camera.screen = {1, 0.85, 21};
  double y = -1.5;
  for (const double radius : {0.08, 0.2, 0.45, 0.9}) {
    Material light = black();
    light.emission = Rgbd(0.5 / (radius * radius));
    scene.objects.push_back(object("Ball", Sphere<double>{{2, y, 2.6}, radius}, light));
    y += radius < 0.3 ? 0.8 : 1.3;
  }
  double x = -2, height = 0;
  for (const double gloss : {1.0, 3.0, 8.0, 25.0}) {
    Material plate = matte(0.05);
    plate.reflection = Rgbd(0.8);
    plate.gloss = gloss;
    scene.objects.push_back(
        object("Plate",
               Polygon<double>{
                   {{x, -3, height}, {x + 0.9, -3, height + 0.25}, {x + 0.9, 3, height + 0.25}, {x, 3, height}}, {}},
               plate));
    x += 0.95, height += 0.42;
  }
  return scene;
}

// Whether two pictures of the same mean are told apart by more than chance.
void agree(const Estimates& a, const Estimates& b) {
  double squares = 0, difference = 0, variance = 0;
  int judged = 0;
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double spread = a.error(i) * a.error(i) + b.error(i) * b.error(i);
    difference += a.mean[i].x - b.mean[i].x;
    variance += spread;
    if (!(spread > 0)) {
      CHECK(a.mean[i].x == Approx(b.mean[i].x).epsilon(1e-9));
      continue;
    }
    squares += std::pow(a.mean[i].x - b.mean[i].x, 2) / spread;
    ++judged;
  }
  REQUIRE(judged > 20);
  CHECK(std::abs(difference) <= 4 * std::sqrt(variance));
  CHECK(squares / judged < 1 + 6 * std::sqrt(2.0 / judged) + 0.1);
}

}  // namespace

TEMPLATE_TEST_CASE("watched and unwatched paths give the same bits and the same counts", "", float, double) {
  using T = TestType;
  std::size_t number = 0;
  for (const Sampler sampler : {Sampler::random, Sampler::jittered, Sampler::sobol}) {
    ++number;
    for (const PathSettings& settings :
         {PathSettings{}, PathSettings{3, 1, PathStrategy::lights}, PathSettings{0, 2, PathStrategy::directions}}) {
      if (left_out(number++, 3)) continue;  // each sampler has one of them
      Scene scene = all_scene();
      scene.render.sampler = sampler;
      Recording recording;
      const auto plain = path_picture<T>(scene, 31, 23, settings, {3, 7});
      const auto watched = path_picture<T>(scene, 31, 23, settings, {3, 7}, &recording);
      CHECK(same_bits(plain, watched));
      CHECK(same_counts(plain.statistics, watched.statistics));
      CHECK(plain.statistics.not_finite == 0);
      CHECK(recording.events.size() > plain.pixels.size() * 10);
    }
  }
}

TEST_CASE("what is told adds up: rays, endings, and the light of each pixel") {
  Recording recording;
  const auto traced = path_picture<double>(all_scene(), 41, 31, {5, 2, PathStrategy::both}, {2, 3}, &recording);
  const Statistics& statistics = traced.statistics;
  std::array<std::uint64_t, ray_kind_count> formed{};
  std::array<std::uint64_t, ending_count> ended{};
  std::set<Line> lines;
  Rgbd sum(0.0);
  std::uint64_t pixels = 0;
  for (const Event& event : recording.events) {
    lines.insert(event.line);
    if (const auto* ray = std::get_if<RayFormed>(&event.detail)) ++formed[static_cast<std::size_t>(ray->kind)];
    if (const auto* ray = std::get_if<RayNotFormed>(&event.detail)) ++ended[static_cast<std::size_t>(ray->why)];
    if (const auto* found = std::get_if<Found>(&event.detail)) ++ended[static_cast<std::size_t>(found->ending)];
    if (const auto* survival = std::get_if<SurvivalDecided>(&event.detail))
      if (survival->why) ++ended[static_cast<std::size_t>(*survival->why)];
    if (const auto* light = std::get_if<LightAdded>(&event.detail)) sum += light->added;
    if (const auto* emission = std::get_if<EmissionAdded>(&event.detail)) sum += emission->added;
    if (const auto* background = std::get_if<BackgroundAdded>(&event.detail)) sum += background->added;
    if (const auto* put = std::get_if<PixelPut>(&event.detail)) {
      ++pixels;
      if (length(put->shade - sum) > 1e-12 * (1 + length(sum))) FAIL("a pixel of another sum");
      sum = Rgbd(0.0);
    }
  }
  CHECK(pixels == 41 * 31 * 2);
  CHECK(lines.size() == path_line_count);
  for (std::size_t i = 0; i < formed.size(); ++i) CHECK(formed[i] == statistics.rays[i]);
  for (std::size_t i = 0; i < ended.size(); ++i) CHECK(ended[i] == statistics.ended[i]);
  std::uint64_t rays = 0;
  for (const std::uint64_t count : statistics.rays) rays += count;
  CHECK(rays == statistics.ends(Ending::hit) + statistics.ends(Ending::missed) + statistics.ends(Ending::blocked) +
                    statistics.ends(Ending::reached_light));
  for (const Ending used : {Ending::path_length, Ending::threshold, Ending::facing_away, Ending::outside_cone})
    CHECK(statistics.ends(used) > 0);
}

TEST_CASE("both strategies' weights, as told, complement each other", "[odds]") {
  Recording recording;
  static_cast<void>(path_picture<double>(all_scene(), 41, 31, {}, {16, 3}, &recording));
  int lights = 0, emissions = 0;
  for (const LightAdded& light : recording.all<LightAdded>()) {
    if (light.light >= 0) {
      CHECK(light.weight == 1);
      continue;
    }
    ++lights;
    const double other = power_heuristic(light.direction_pdf, light.light_pdf);
    CHECK(light.weight + other == Approx(1).epsilon(1e-12));
  }
  for (const EmissionAdded& emission : recording.all<EmissionAdded>()) {
    if (emission.light_pdf == 0) {
      CHECK(emission.weight == 1);
      continue;
    }
    ++emissions;
    CHECK(emission.direction_pdf > 0);
    const double other = power_heuristic(emission.light_pdf, emission.direction_pdf);
    CHECK(emission.weight + other == Approx(1).epsilon(1e-12));
  }
  CHECK(lights > 500);
  CHECK(emissions > 100);
}

TEST_CASE("all strategies have the same mean; both together vary least where each alone fails") {
  const Scene scene = plates();
  const auto by = [&](PathStrategy strategy, std::uint64_t seed) {
    return path_estimates(scene, 28, 14, 64, {2, never, strategy}, seed);
  };
  REQUIRE(path_picture<double>(scene, 28, 14, {1, never, PathStrategy::both}).pixels ==
          std::vector(28 * 14, Rgbd(0.0)));
  const Estimates both = by(PathStrategy::both, 1), lights = by(PathStrategy::lights, 2),
                  directions = by(PathStrategy::directions, 3);
  // Rare bright samples make small samples lie, so means are compared over the whole picture.
  const auto mean = [](const Estimates& estimates) {
    double sum = 0, variance = 0;
    for (std::size_t i = 0; i < estimates.mean.size(); ++i)
      sum += estimates.mean[i].x, variance += estimates.error(i) * estimates.error(i);
    return std::pair{sum, std::sqrt(variance)};
  };
  for (const Estimates* alone : {&lights, &directions})
    CHECK(std::abs(mean(both).first - mean(*alone).first) <= 4 * std::hypot(mean(both).second, mean(*alone).second));
  CHECK(both.total_variance() < 0.5 * lights.total_variance());
  CHECK(both.total_variance() < 0.5 * directions.total_variance());
}

TEST_CASE("light of lamps alone is the tracer's, to the last digits") {
  // Paths of two rays are SHADE without its mirrors; ambient stands for what paths find themselves.
  Scene scene = busy_scene();
  scene.lights.push_back({"Spot", Rgbd(0.8), SpotLight{{-4, 2, 3}, {0, 0, 0}, 40, 30, {}}});
  scene.ambient = scene.background = Rgbd(0.0);
  for (Object& one : scene.objects) one.material.emission = Rgbd(0.0);
  scene.limits.depth = 1;
  scene.render.integrator = Integrator::whitted;
  const auto shaded = picture<double>(scene, 63, 45);
  const auto path = path_picture<double>(scene, 63, 45, {2, never, PathStrategy::both});
  double worst = 0;
  for (std::size_t i = 0; i < shaded.pixels.size(); ++i)
    worst = std::max(worst, length(shaded.pixels[i] - path.pixels[i]) / (1 + length(shaded.pixels[i])));
  CHECK(worst < 1e-13);
  CHECK(path.statistics.ends(Ending::reached_light) == shaded.statistics.ends(Ending::reached_light));
}

TEST_CASE("paths and distributed rays agree on the direct light of area lights") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.camera.eye = {-5, 0, 3};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 1.2, 21};
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matte(0.7)),
                   object("Ball", Sphere<double>{{0, 0.4, 0.7}, 0.6}, matte(0.5))};
  scene.lights = {{"Ball light", Rgbd(2.0), SphereLight{{-1, 2, 3}, 0.8, 1, {0, 0, 0.2}}},
                  {"Panel", Rgbd(1.0), RectangleLight{{-1, -3, 3}, {2, 0, 0}, {0, 1, 1}, 1, {0.5, 0.1, 0}}}};
  for (Sampler sampler : {Sampler::random, Sampler::jittered, Sampler::sobol}) {
    scene.render.sampler = sampler;
    Scene distributed = scene;
    distributed.render.integrator = Integrator::distributed;
    distributed.limits.depth = 1;
    const Estimates rays = estimates_by(distributed, 15, 11, 64, 5, [](const auto&... a) { return trace(a...); });
    const Estimates paths = path_estimates(scene, 15, 11, 64, {2, never, PathStrategy::both}, 9);
    agree(rays, paths);
  }
}

TEST_CASE("mirrors and glass: the mean of paths is what the whole ray tree brings") {
  Scene scene = busy_scene();
  scene.lights.clear();
  scene.render.sampler = Sampler::random;
  scene.ambient = Rgbd(0.0);
  for (Object& one : scene.objects) {
    one.material.diffuse = one.material.specular = Rgbd(0.0);
    one.material.checker.reset();
    one.material.absorption = one.material.transmits() ? Rgbd(0.1, 0.2, 0.3) : Rgbd(0.0);
  }
  scene.limits.depth = 12;
  Scene whole = scene;
  whole.render.integrator = Integrator::whitted;
  const auto tree = picture<double>(whole, 15, 11);
  // One direction a pixel: its samples are seeds.
  std::vector<Rgbd> mean(tree.pixels.size(), Rgbd(0.0));
  std::vector<double> squares(tree.pixels.size());
  constexpr int seeds = 400;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const auto path = path_picture<double>(scene, 15, 11, {12, never, PathStrategy::both}, {1, seed});
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += path.pixels[i] / static_cast<double>(seeds), squares[i] += path.pixels[i].x * path.pixels[i].x / seeds;
  }
  int judged = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double error = std::sqrt(std::max(squares[i] - mean[i].x * mean[i].x, 0.0) / seeds);
    if (std::abs(mean[i].x - tree.pixels[i].x) > 5 * error + 1e-9)
      FAIL("pixel " << i << ": " << mean[i].x << " +- " << error << " for " << tree.pixels[i].x);
    judged += error > 0;
  }
  CHECK(judged > 10);
}

TEST_CASE("a path is as long as it may be, and says when it may not") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.objects = {object("Room", Box<double>{{-1, -1, -1}, {1, 1, 1}}, matte(0.9, 1))};
  scene.lights = {lamp({0.1, 0.2, 0.3})};
  for (const int longest : {1, 2, 3, 7}) {
    const auto traced = path_picture<double>(looking(scene, {-0.5, 0, 0}, {1, 0, 0}), 9, 7, {longest, never, {}});
    const std::uint64_t pixels = 63, length = static_cast<std::uint64_t>(longest);
    CHECK(traced.statistics.formed(RayKind::primary) == pixels);
    CHECK(traced.statistics.formed(RayKind::reflect) == pixels * (length - 1));
    // A point drawn on the very wall stands edge on.
    CHECK(traced.statistics.formed(RayKind::shadow) + traced.statistics.ends(Ending::facing_away) ==
          pixels * 2 * (length - 1));
    // The next ray, and one to the lamp and one to the wall.
    CHECK(traced.statistics.ends(Ending::path_length) == pixels * 3);
    CHECK(traced.statistics.ends(Ending::threshold) == 0);
  }
}

TEST_CASE("ambient light, depth, threshold and fixed normals are the tracer's alone") {
  const Scene scene = all_scene();
  const auto paths = [](const Scene& of) { return path_picture<double>(of, 31, 23, {}, {2, 7}); };
  const auto plain = paths(scene);
  const auto same = [&](const Scene& other) { return same_bits(plain, paths(other)); };
  Scene other = scene;
  other.ambient = Rgbd(9.0);
  for (Object& one : other.objects) one.material.ambient = Rgbd(0.5);
  CHECK(same(other));
  other = scene;
  other.limits = {1, 0.9};
  CHECK(same(other));
  other = scene;
  for (Object& one : other.objects) one.material.normal = ShadingNormal::fixed;
  CHECK(same(other));
  other.objects[0].material.diffuse *= 0.5;
  CHECK_FALSE(same(other));
}

TEST_CASE("what needs no draw draws nothing") {
  Scene scene = busy_scene();
  scene.lights.clear();
  for (Object& one : scene.objects) {
    // One lobe each, and sharp.
    one.material.diffuse = one.material.specular = one.material.transmission = Rgbd(0.0);
    one.material.reflection = Rgbd(0.9);
  }
  const auto mirrors = path_picture<double>(scene, 21, 15, {0, never, {}});
  CHECK(mirrors.statistics.formed(RayKind::reflect) > 0);
  CHECK(mirrors.statistics.random_draws() == 0);
  for (Object& one : scene.objects) one.material.reflection = Rgbd(0.0), one.material.diffuse = Rgbd(0.5);
  scene.lights = {lamp({-3, 3, 2})};
  const auto seen = path_picture<double>(scene, 21, 15, {1, never, PathStrategy::both});
  CHECK(seen.statistics.random_draws() == 0);
  // A direction each time that a matte surface sends the path on, and nothing else.
  const auto sent_on = path_picture<double>(scene, 21, 15, {4, never, PathStrategy::both});
  CHECK(sent_on.statistics.formed(RayKind::shadow) > 0);
  CHECK(sent_on.statistics.random_draws() == 2 * sent_on.statistics.formed(RayKind::reflect));
  CHECK(sent_on.statistics.drawn(Effect::indirect_light) == sent_on.statistics.random_draws());
}

TEST_CASE("float paths are double paths, but for rounding") {
  Scene scene = plates();
  scene.render.sampler = Sampler::sobol;
  const auto wide = path_picture<double>(scene, 31, 23, {3, never, PathStrategy::both}, {1, 3});
  const auto narrow = path_picture<float>(scene, 31, 23, {3, never, PathStrategy::both}, {1, 3});
  int apart = 0;
  for (std::size_t i = 0; i < wide.pixels.size(); ++i)
    apart += length(wide.pixels[i] - Rgbd(narrow.pixels[i])) > 1e-3 * (0.1 + length(wide.pixels[i]));
  CHECK(apart < static_cast<int>(wide.pixels.size()) / 50);
}

TEST_CASE("paths draw for the effects that the scene calls for, and for no other") {
  const auto drawn = [](const Scene& given, int samples) {
    const Scene scene = by_path(given, Sampler::jittered);
    const auto traced = path_picture<double>(scene, 31, 23, path_settings_of(scene), {samples, 3});
    const Effects effects = effects_of(scene, samples);
    using enum Effect;
    for (const Effect effect : {gloss, translucency, penumbra, depth_of_field, antialiasing, indirect_light}) {
      INFO(name_of(effect) << ": " << effects[effect].why);
      CHECK((traced.statistics.drawn(effect) > 0) == effects.used(effect));
    }
    CHECK((traced.statistics.formed(RayKind::shadow) > 0) == effects.used(shadows));
    return traced.statistics.random_draws();
  };
  Scene scene = all_scene();
  CHECK(drawn(scene, 2) > 0);
  scene.camera.aperture = 0.1;
  scene.objects[2].material.translucency = 5;
  CHECK(drawn(scene, 1) > 0);
  scene.camera.aperture = 0;
  scene.render.path_length = 1;
  for (Object& one : scene.objects) one.material.gloss = one.material.translucency = 0;
  scene.lights.clear();
  for (Object& one : scene.objects) one.material.emission = Rgbd(0.0);
  CHECK(drawn(scene, 1) == 0);
  // Black things that shine: seen, and nothing more.
  for (Object& one : scene.objects) {
    one.material = black();
    one.material.emission = Rgbd(1.0);
  }
  scene.objects.resize(1);
  scene.render.path_length.reset();
  scene.objects[0].material.emission = Rgbd(0.0);
  CHECK(drawn(scene, 1) == 0);
}
