// Maps of parameters and masks: what is the same all over has the bits of a material without maps, and what changes
// from point to point is what the images say, for every integrator.

#include "trace/maps.h"
#include "support/catch.h"
#include "support/effort.h"
#include "trace/paths.h"
#include "trace/photon_scenes.h"
#include "trace/sampled.h"

#include <algorithm>

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr Integrator all_integrators[] = {Integrator::cast, Integrator::whitted, Integrator::distributed,
                                          Integrator::path, Integrator::photons, Integrator::radiosity};

// A room of everything that maps change: matt, shiny, rough, metal, glass of both kinds, lobes, light.
Scene mapped_room() {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.render.photons.count = 2000;
  scene.render.radiosity.patch = 1.0;
  scene.background = {0.1, 0.2, 0.3};
  scene.ambient = Rgbd(0.3);
  Material floor = matt(0.5), wall = matt(0.6), metal = black(), frosted = black(), clear = black(), brushed = black();
  floor.ambient = Rgbd(0.2);
  floor.checker = Checker{{0.9, 0.8, 0.7}, {0.2, 0.3, 0.4}, 0.7};
  floor.diffuse_roughness = 0.7;
  wall.specular = {0.2, 0.3, 0.1};
  wall.shininess = 25;
  metal.reflection = {0.9, 0.8, 0.7};
  metal.mirror = MirrorKind::copper;
  metal.roughness = 0.3;
  frosted.transmission = {0.9, 0.95, 0.9};
  frosted.reflection = Rgbd(0.05);
  frosted.dielectric = true;
  frosted.roughness = 0.2;
  clear.transmission = {0.6, 0.7, 0.7};
  clear.reflection = Rgbd(0.2);
  clear.translucency = 4;
  brushed.reflection = Rgbd(0.6);
  brushed.gloss = 6;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, floor),
                   object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, wall),
                   object("Metal", Sphere<double>{{0, 1.2, 0.6}, 0.6}, metal),
                   object("Frosted", Sphere<double>{{0, 0, 0.5}, 0.5}, frosted),
                   object("Clear", Sphere<double>{{0.2, -1, 0.5}, 0.45}, clear),
                   object("Brushed", Box<double>{{0.5, -2.2, 0}, {1, -1.6, 1}}, brushed),
                   object("Glow", Box<double>{{-0.5, -0.2, 2}, {0, 0.3, 2.2}}, matt(0.1, 2))};
  scene.lights = {lamp({-2, 2, 3}, 0.6)};
  scene = looking(scene, {-4, 0, 1}, {0, 0, 0.6});
  scene.camera.screen = {1, 1, 8};
  scene.limits.depth = 4;
  return scene;
}

std::vector<ParameterMap> all_maps(const std::shared_ptr<const Image>& pixels, bool second = false) {
  std::vector<ParameterMap> maps;
  for (const MappedParameter of : values_of<MappedParameter>) {
    const bool of_first_alone =
        of == MappedParameter::transmission || of == MappedParameter::gloss || of == MappedParameter::translucency;
    if (!second || !of_first_alone) maps.push_back({{"map.png", 0.7, 0.4, pixels}, of, MapChannel::green});
  }
  return maps;
}

}  // namespace

TEMPLATE_TEST_CASE("maps that are white all over keep every bit, for every integrator", "", float, double) {
  using T = TestType;
  const Scene plain = mapped_room();
  Scene white = plain;
  for (Object& each : white.objects) each.material.maps = all_maps(uniform(Rgbd(1.0)));
  for (const Integrator integrator : all_integrators) {
    CAPTURE(name_of(integrator));
    const auto one = drawn_by<T>(plain, integrator), other = drawn_by<T>(white, integrator);
    CHECK(same_bits(one, other));
    CHECK(same_counts(one.statistics, other.statistics));
  }
}

TEST_CASE("a map that is the same all over is the factor of its parameter") {
  // Of powers of two: products are exact.
  const Scene plain = mapped_room();
  for (const MappedParameter of : values_of<MappedParameter>) {
    CAPTURE(name_of(of));
    Scene mapped = plain, constant = plain;
    for (Object& each : mapped.objects)
      each.material.maps = {{{"map.png", 1, 1, uniform({0.25, 0.5, 0.75})}, of, MapChannel::green}};
    for (Object& each : constant.objects) multiply(each.material, of, {0.25, 0.5, 0.75}, 0.5);
    for (const Integrator integrator : {Integrator::whitted, Integrator::distributed, Integrator::path}) {
      // Emitters are chosen by what they emit at most.
      if (of == MappedParameter::emission && integrator == Integrator::path) continue;
      CAPTURE(name_of(integrator));
      const auto one = drawn_by<double>(constant, integrator), other = drawn_by<double>(mapped, integrator);
      // Of matt surfaces there are 1024 roughnesses; all else is exact.
      if (of == MappedParameter::diffuse_roughness)
        CHECK(max_difference(one, other) < 2e-3);
      else
        CHECK(same_bits(one, other));
      const bool has_none = of == MappedParameter::ambient && integrator == Integrator::path;
      if (integrator != Integrator::whitted && !has_none)
        CHECK(max_difference(one, drawn_by<double>(plain, integrator)) > 1e-6);
    }
  }
}

TEMPLATE_TEST_CASE("a mask of 0 is the first material, of 1 the second, to the last bit", "", float, double) {
  using T = TestType;
  Scene plain = mapped_room();
  plain.objects.pop_back();  // emitters are chosen by what either of the two emits
  SecondMaterial second;
  second.ambient = Rgbd(0.1);
  second.diffuse = {0.3, 0.1, 0.2};
  second.diffuse_roughness = 0.4;
  second.specular = Rgbd(0.2);
  second.shininess = 12;
  for (const bool is_second : {false, true}) {
    Scene masked = plain, whole = plain;
    for (std::size_t i = 0; i < plain.objects.size(); ++i) {
      Material& material = masked.objects[i].material;
      material.mask = Mask{{"mask.png", 1, 1, uniform({is_second ? 1.0 : 0.0, 0.5, 0.5})}, {}, MapChannel::red, second};
      const bool lobes = material.gloss > 0 || material.translucency > 0;
      if (!material.transmits()) material.mask->second.reflection = Rgbd(0.4);
      if (!material.transmits() && !lobes) material.mask->second.roughness = 0.5;
      REQUIRE(why_not_mapped(material).empty());
      // What transmits is a body still.
      if (is_second && !material.transmits()) whole.objects[i].material = second_of(material);
    }
    for (const Integrator integrator : all_integrators) {
      CAPTURE(is_second, name_of(integrator));
      if (is_second) {
        masked.objects.resize(3);
        whole.objects.resize(3);
      }
      CHECK(same_bits(drawn_by<T>(whole, integrator), drawn_by<T>(masked, integrator)));
    }
  }
}

TEST_CASE("between 0 and 1 a mask interpolates, and a checker has one of the two in each square") {
  Scene scene;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(0.8))};
  scene.objects[0].material.specular = Rgbd(0.1);
  scene.lights = {lamp({0, 0, 2})};
  Mask mask{{"mask.png", 1, 1, uniform(Rgbd(0.25))}, {}, MapChannel::red, {}};
  mask.second.diffuse = Rgbd(0.2);
  mask.second.specular = Rgbd(0.5);
  mask.second.shininess = 10;
  scene.objects[0].material.mask = mask;
  const Vec3d eye(1, 0.5, 2), at(0.3, 0.2, 0);
  const Vec3d l = normalize(Vec3d(0, 0, 2) - at), h = normalize(l + normalize(eye - at));
  CHECK(shade_along(scene, eye, at).x == Approx(0.65 * l.z + 0.2 * std::pow(h.z, 25)).epsilon(1e-9));
  Scene first = scene, second = scene;
  first.objects[0].material.mask.reset();
  second.objects[0].material = second_of(scene.objects[0].material);
  scene.objects[0].material.mask->file.clear(), scene.objects[0].material.mask->pixels.reset();
  scene.objects[0].material.mask->squares = 0.5;
  CHECK(shade_along(scene, eye, {0.3, 0.2, 0}) == shade_along(first, eye, {0.3, 0.2, 0}));
  CHECK(shade_along(scene, eye, {0.7, 0.2, 0}) == shade_along(second, eye, {0.7, 0.2, 0}));
  CHECK(shade_along(scene, eye, {0.7, 0.7, 0}) == shade_along(first, eye, {0.7, 0.7, 0}));
}

TEST_CASE("paths and distributed rays agree on what maps make of metal and glass", "[odds]") {
  const auto ramp = pixels_of(4, 1, {Rgbd(0.05), Rgbd(0.3), Rgbd(0.6), Rgbd(1.0)});
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.sky = Sky{GradientSky{{0.2, 0.4, 0.9}, {1.0, 0.6, 0.1}}, {0.3, 0, 1}};
  Material metal = black(), glass = black();
  metal.reflection = {0.9, 0.8, 0.7};
  metal.mirror = MirrorKind::gold;
  metal.roughness = 0.7;
  metal.maps = {{{"ramp.png", 2, 2, ramp}, MappedParameter::roughness, MapChannel::red},
                {{"ramp.png", 1, 1, ramp}, MappedParameter::reflection, MapChannel::red}};
  metal.bump_map = BumpMap{{"ramp.png", 1.3, 1.3, ramp}, 0.1, MapChannel::red};
  glass.transmission = Rgbd(1.0);
  glass.dielectric = true;
  glass.roughness = 0.5;
  glass.maps = {metal.maps[0]};
  for (const Material& material : {metal, glass}) {
    // Seen from above: one hit, and for glass the way down into a black pit.
    scene.objects = {object("Slab", Plane<double>{{0, 0, 0}, {0, 0, 1}}, material),
                     object("Pit", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matt(0, 0.5))};
    for (const double x : {0.1, 0.45, 0.8, 1.3}) {
      CAPTURE(material.transmits(), x);
      Scene rays = scene;
      rays.render.integrator = Integrator::distributed;
      rays.limits.depth = 4;
      const Sampled seen = sample(rays, {-2, 0.4, 2}, {x, 0.4, 0}, 6000);
      const Estimate paths = light_along(scene, {-2, 0.4, 2}, {x, 0.4, 0}, 6000, {4, never, PathStrategy::both});
      CHECK(std::abs(seen.mean - paths.mean.x) < seen.tolerance() + 4.5 * paths.error + 1e-3);
      CHECK(paths.error < 0.02);
    }
  }
}

TEST_CASE("a map of what is emitted shows alike to paths by light and by chance, to photons, and on patches",
          "[odds]") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  const auto panes = pixels_of(2, 2, {Rgbd(0.0), Rgbd(1.0), Rgbd(0.25), Rgbd(0.0)});
  Material lantern = matt(0, 3);
  lantern.maps = {{{"panes.png", 0.7, 1, panes}, MappedParameter::emission, MapChannel::red}};
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(0.7)),
                   object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, matt(0.5)),
                   object("Lantern", Box<double>{{0, -0.5, 0.3}, {0.7, 0.4, 1.3}}, lantern)};
  scene = looking(scene, {-4, 0, 1}, {0, 0, 0.8});
  scene.camera.screen = {1, 1, 8};
  for (const Vec3d& at : {Vec3d(-1, 0, 0), Vec3d(2, -1, 0.5), Vec3d(0.3, 1.5, 0)}) {
    const auto seen = [&](PathStrategy strategy, std::uint64_t seed) {
      return light_along(scene, {-4, 0, 1}, at, 8000, {3, never, strategy}, seed);
    };
    const Estimate lights = seen(PathStrategy::lights, 1), chance = seen(PathStrategy::directions, 2);
    CHECK(std::abs(lights.mean.x - chance.mean.x) < 4.5 * (lights.error + chance.error));
    CHECK(lights.error < 0.05 * lights.mean.x);
  }
  check_against_paths(by_photons(scene, 100000, 60),
                      path_estimates(scene, 10, 10, 400, {12, never, PathStrategy::both}), 0.05);
}

TEMPLATE_TEST_CASE("watched or not, by any accelerator, mapped surfaces have the same bits and are finite", "", float,
                   double) {
  using T = TestType;
  if (left_out(std::is_same_v<T, double>, 2)) return;
  Scene scene = mapped_room();
  const auto pixels = pixels_of(3, 2, {{0.1, 0.9, 0.4}, Rgbd(1.0), Rgbd(0.0), Rgbd(0.6), {0.3, 0.3, 1.0}, Rgbd(0.8)});
  for (Object& each : scene.objects) {
    each.material.maps = all_maps(pixels);
    each.material.normal_map = NormalMap{{"map.png", 0.5, 0.3, pixels}, 1};
    each.material.bump_map = BumpMap{{"map.png", 0.4, 0.6, pixels}, 0.1, MapChannel::blue};
    each.material.mask = Mask{{"map.png", 0.9, 0.9, pixels}, {}, MapChannel::red, {}};
  }
  for (const Integrator integrator : all_integrators) {
    CAPTURE(name_of(integrator));
    const auto plain = drawn_by<T>(scene, integrator);
    Recording recording;
    const auto watched = drawn_by<T>(scene, integrator, &recording);
    CHECK(same_bits(plain, watched));
    CHECK(same_counts(plain.statistics, watched.statistics));
    CHECK(plain.statistics.not_finite == 0);
    scene.render.integrator = integrator;
    for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::grid, AcceleratorKind::kdtree})
      CHECK(same_bits(plain, drawn_in<T>(scene, World<T>(scene, kind))));
  }
}
