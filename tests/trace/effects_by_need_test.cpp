// Invariant 4 for each effect and each pair of them: what is not called for fires no ray and draws no number, what is
// enabled but inert gives the bits of what is disabled, the kernel of all effects gives the bits of the one that was
// inferred, and an effect that is switched on leaves every pixel alone whose ray tree holds nothing of it.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "support/catch.h"
#include "trace/kernel_of.h"
#include "trace/pictures.h"
#include "trace/scene_kernel.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr int width = 27, height = 19;

/// Matte things on a floor, seen by a pinhole: it calls for no effect but shadows, once its lamp shines.
Scene plain_scene() {
  Scene scene;
  scene.background = {0.1, 0.2, 0.4};
  scene.camera.eye = {-6, 0, 0.5};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 1.2, 21};
  scene.limits.depth = 4;
  Material matte;
  matte.ambient = Rgbd(0.2);
  matte.diffuse = {0.6, 0.3, 0.2};
  matte.specular = Rgbd(0.3);
  scene.objects = {object("One", Sphere<double>{{0.5, 1.2, 0}, 0.8}, matte),
                   object("Two", Sphere<double>{{1, -0.4, 0.2}, 0.7}, matte),
                   object("Three", Sphere<double>{{-1, -1.4, 0}, 0.6}, matte),
                   object("Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matte)};
  for (std::size_t i = 0; i < scene.objects.size(); ++i)  // mirrors can tell them apart, also where no lamp shines
    scene.objects[i].material.ambient = Rgbd(0.1 + 0.2 * static_cast<double>(i));
  scene.lights = {{"Lamp", Rgbd(0.0), PointLight{{-3, 3, 2}, {}}}};
  return scene;
}

struct Switch {
  Effect effect;
  std::set<Effect> calls_for;         ///< what a scene with it uses
  std::function<void(Scene&)> on;     ///< calls for it
  std::function<void(Scene&)> inert;  ///< enables it so that it does nothing
  int samples = 1;
};

/// All that the tracer knows, but for what comes from the samples of a pixel alone.
std::vector<Switch> switches() {
  using enum Effect;
  const auto shine = [](Scene& scene) { scene.lights[0].strength = Rgbd(1.0); };
  const auto dull = [](Scene&) {};
  return {
      {shadows, {shadows}, shine, [](Scene& s) { s.lights.push_back({"Dark", Rgbd(0.0), PointLight{}}); }},
      {reflection,
       {reflection},
       [](Scene& s) { s.objects[0].material.reflection = Rgbd(0.5); },
       [](Scene& s) { s.objects[3].material.dielectric = true; }},
      {refraction,
       {reflection, refraction},
       [](Scene& s) {
         s.objects[1].material.transmission = Rgbd(0.6);
         s.objects[1].material.dielectric = true;
       },
       [](Scene& s) {
         s.objects[3].material.ior = 1.7;
         s.objects[3].material.absorption = Rgbd(2.0);  // with nothing transmitted nothing is absorbed
       }},
      {gloss,
       {reflection, gloss},
       [](Scene& s) {
         s.objects[0].material.reflection = Rgbd(0.5);
         s.objects[0].material.gloss = 20;
       },
       [](Scene& s) { s.objects[3].material.gloss = 20; }},
      {translucency,
       {reflection, refraction, translucency},
       [](Scene& s) {
         s.objects[1].material.transmission = Rgbd(0.6);
         s.objects[1].material.dielectric = true;
         s.objects[1].material.translucency = 20;
       },
       [](Scene& s) { s.objects[3].material.translucency = 20; }},
      {penumbra,
       {shadows, penumbra},
       [](Scene& s) { s.lights.push_back({"Bulb", Rgbd(0.7), SphereLight{{-2, -3, 2}, 0.6, 2, {}}}); },
       [](Scene& s) { s.lights[0].kind = SphereLight{std::get<PointLight>(s.lights[0].kind).position, 0, 3, {}}; }},
      {depth_of_field,
       {depth_of_field},
       [](Scene& s) { s.camera.aperture = 0.2; },
       [](Scene& s) { s.camera.focus = 3; }},
      {motion_blur,
       {motion_blur},
       [](Scene& s) { s.objects[2].motion = {{0, {0, 0, 0}}, {0.5, {0, 0.3, 0.2}}, {1, {0.2, 0.8, 0}}}; },
       // One key, and one that moves before the shutter opens and after it has closed.
       [](Scene& s) {
         s.objects[3].motion = {{0.4, {0, 0, 0}}};
         s.objects[0].motion = {{-2, {1, 0, 0}}, {-1, {0, 0, 0}}, {1, {0, 0, 0}}, {2, {0, 5, 0}}};
       }},
      {antialiasing, {antialiasing}, dull, dull, 4},
      {textures,
       {textures},
       [](Scene& s) {
         std::optional<Checker>& checker = s.objects[2].material.checker;
         if (!checker) checker = Checker{Rgbd(0.9), Rgbd(0.3), 0.2};
       },
       dull},
      {filtering,
       {filtering, textures},
       [](Scene& s) { s.objects[2].material.checker = Checker{Rgbd(0.9), Rgbd(0.3), 0.2, CheckerFilter::closed}; },
       dull},
      {microfacets,
       {reflection, microfacets},
       [](Scene& s) {
         s.objects[2].material.reflection = Rgbd(0.5);
         s.objects[2].material.roughness = 0.3;
         s.objects[2].material.mirror = MirrorKind::gold;
       },
       [](Scene& s) { s.objects[3].material.roughness = 0.3, s.objects[3].material.mirror = MirrorKind::gold; }},
      {maps,
       {maps},
       [](Scene& s) {
         const Image shares{2, 1, {Rgb<float>(0.3F), Rgb<float>(0.9F)}};
         s.objects[2].material.maps = {
             {{"shares.png", 0.3, 0.3, std::make_shared<const Image>(shares)}, MappedParameter::ambient}};
       },
       dull},
      {sky, {sky}, [](Scene& s) { s.sky = Sky{GradientSky{}}; }, dull},
  };
}

std::set<Effect> used_by(const Scene& scene, int samples) {
  const Effects effects = effects_of(scene, samples);
  std::set<Effect> used;
  for (int i = 0; i < effect_count; ++i)
    if (effects.used(static_cast<Effect>(i))) used.insert(static_cast<Effect>(i));
  return used;
}

bool draws_numbers(Effect effect) {
  using enum Effect;
  return std::set{gloss, translucency, penumbra, depth_of_field, motion_blur, antialiasing, indirect_light, microfacets}
             .count(effect) > 0;
}

/// No ray and no number of an effect that is not used.
void check_only(const std::set<Effect>& used, const Statistics& statistics) {
  using enum Effect;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    INFO(name_of(effect));
    CHECK((statistics.drawn(effect) > 0) == (used.count(effect) > 0 && draws_numbers(effect)));
  }
  CHECK((statistics.formed(RayKind::shadow) > 0) == (used.count(shadows) > 0));
  CHECK((statistics.ends(Ending::facing_away) > 0) == (used.count(shadows) > 0));
  CHECK((statistics.formed(RayKind::reflect) > 0) == (used.count(reflection) > 0));
  CHECK((statistics.formed(RayKind::refract) > 0) == (used.count(refraction) > 0));
}

template <class T>
bool same(const Picture<T>& a, const Picture<T>& b) {
  return a.pixels == b.pixels && a.statistics.rays == b.statistics.rays && a.statistics.ended == b.statistics.ended &&
         a.statistics.draws == b.statistics.draws && a.statistics.tests.primitives == b.statistics.tests.primitives;
}

template <class T>
Picture<T> by_all_effects(const Scene& scene, Sampling sampling) {
  return picture_by<T>(scene, width, height, sampling,
                       [](const auto&... a) { return detail::run_kernel<T, all_hit_effects>(a...); });
}

}  // namespace

TEMPLATE_TEST_CASE("each pair of effects costs what it calls for and nothing else", "", float, double) {
  using T = TestType;
  const std::vector<Switch> all = switches();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {  // i == j: one by itself
      const Switch &a = all[i], &b = all[j];
      INFO(name_of(a.effect) << " and " << name_of(b.effect));
      Scene scene = plain_scene();
      a.on(scene);
      if (j != i) b.on(scene);
      const Sampling sampling{std::max(a.samples, b.samples), 5};
      std::set<Effect> expected = a.calls_for;
      expected.insert(b.calls_for.begin(), b.calls_for.end());
      CHECK(used_by(scene, sampling.per_pixel) == expected);

      const auto fitting = picture<T>(scene, width, height, sampling);
      check_only(expected, fitting.statistics);
      CHECK(same(fitting, by_all_effects<T>(scene, sampling)));

      Scene idle = scene;
      for (const Switch& other : all)
        if (expected.count(other.effect) == 0) other.inert(idle);
      CHECK(used_by(idle, sampling.per_pixel) == expected);
      CHECK(same(fitting, picture<T>(idle, width, height, sampling)));
      CHECK(same(fitting, by_all_effects<T>(idle, sampling)));
    }
}

TEMPLATE_TEST_CASE("so does each pair of effects by paths, beside indirect light", "", float, double) {
  using T = TestType;
  const auto by_paths = [](const Scene& scene, const Sampling& sampling) {
    return picture_by<T>(scene, width, height, sampling,
                         [&](const World<T>& world, const auto&... a) { return SceneKernel<T>(scene, world)(a...); });
  };
  Scene paths = plain_scene();
  paths.render.integrator = Integrator::path;
  paths.render.path_length = 4;
  const std::vector<Switch> all = switches();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {
      const Switch &a = all[i], &b = all[j];
      INFO(name_of(a.effect) << " and " << name_of(b.effect));
      Scene scene = paths;
      a.on(scene);
      if (j != i) b.on(scene);
      const Sampling sampling{std::max(a.samples, b.samples), 5};
      std::set<Effect> expected = a.calls_for;
      expected.insert(b.calls_for.begin(), b.calls_for.end());
      expected.insert(Effect::indirect_light);
      if (expected.count(Effect::sky) > 0) expected.insert(Effect::shadows);  // paths aim at it
      CHECK(used_by(scene, sampling.per_pixel) == expected);
      const auto traced = by_paths(scene, sampling);
      for (int each = 0; each < effect_count; ++each) {
        const auto effect = static_cast<Effect>(each);
        INFO(name_of(effect));
        const bool draws = draws_numbers(effect) || effect == Effect::sky;
        CHECK((traced.statistics.drawn(effect) > 0) == (expected.count(effect) > 0 && draws));
      }
      CHECK((traced.statistics.formed(RayKind::shadow) > 0) == (expected.count(Effect::shadows) > 0));
      CHECK((traced.statistics.formed(RayKind::refract) > 0) == (expected.count(Effect::refraction) > 0));
      Scene idle = scene;
      for (const Switch& other : all)
        if (expected.count(other.effect) == 0) other.inert(idle);
      CHECK(used_by(idle, sampling.per_pixel) == expected);
      CHECK(same(traced, by_paths(idle, sampling)));
    }
}

TEST_CASE("an effect that is switched on leaves alone what holds nothing of it") {
  const std::vector<Switch> all = switches();
  for (const Switch& with : all)
    for (const Switch& and_with : all) {
      const Effect effect = and_with.effect;
      // Every pixel draws for these; of what moves, a time that meets nothing of it changes nothing all the same.
      if (effect == Effect::depth_of_field || effect == Effect::antialiasing) continue;
      INFO(name_of(effect) << " beside " << name_of(with.effect));
      Scene before = plain_scene();
      with.on(before);
      Scene after = before;
      and_with.on(after);
      const Sampling sampling{with.samples, 5};
      const RayGenerator<double> camera(before, {width, height}, {width, height}, sampling);
      const RayGenerator<double> camera_after(after, {width, height}, {width, height}, sampling);
      const World<double> world(before), world_after(after);
      int spared = 0, changed = 0, wrong = 0;
      for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
          // One sample by itself: what it draws and fires is then its own.
          Rgbd old(0.0), now(0.0);
          const PixelBlock block{column, column + 1, row, row + 1, sampling.per_pixel - 1};
          Recording recording_before, recording;
          static_cast<void>(trace_watched(
              world, camera, block, [&](const Pixel&, const Rgbd& shade) { old = shade; }, recording_before));
          const Statistics statistics = trace_watched(
              world_after, camera_after, block, [&](const Pixel&, const Rgbd& shade) { now = shade; }, recording);
          bool meets = statistics.drawn(effect) > 0;
          if (effect == Effect::motion_blur) meets = recording_before.meets(2);
          for (const Event& event : recording.events) {
            const auto* decided = std::get_if<Decided>(&event.detail);
            const auto* found = std::get_if<Found>(&event.detail);
            const bool lit = event.line == Line::form_shadow_ray;
            meets = meets || (effect == Effect::shadows && lit) ||
                    (decided && decided->holds && effect == Effect::reflection && event.line == Line::if_reflective) ||
                    (decided && (decided->holds || decided->why) && event.line == Line::if_transparent &&
                     (effect == Effect::refraction || effect == Effect::translucency)) ||
                    (decided && decided->holds && (effect == Effect::gloss || effect == Effect::microfacets) &&
                     event.line == Line::if_reflective) ||
                    (found && found->object == 2 &&
                     (effect == Effect::textures || effect == Effect::filtering || effect == Effect::maps ||
                      effect == Effect::motion_blur)) ||
                    (found && found->ending == Ending::missed && effect == Effect::sky);
          }
          if (!meets) ++spared, wrong += old != now;
          changed += old != now;
        }
      CHECK(wrong == 0);
      CHECK(spared > 20);
      if (with.calls_for.count(effect) == 0) CHECK(changed > 0);
    }
}

TEST_CASE("cast and whitted leave out what they do not follow, and draw nothing") {
  using enum Effect;
  Scene scene = plain_scene();
  for (const Switch& each : switches()) each.on(scene);
  scene.render.light_grid = 3;
  const auto traced = [&](Integrator integrator, int samples) {
    scene.render.integrator = integrator;
    const auto fitting = picture<double>(scene, width, height, {samples, 5});
    check_only(used_by(scene, samples), fitting.statistics);
    CHECK(same(fitting, by_all_effects<double>(scene, {samples, 5})));
    return fitting;
  };
  const auto whole = traced(Integrator::distributed, 3);
  CHECK(used_by(scene, 3) == std::set{shadows, reflection, refraction, gloss, translucency, penumbra, depth_of_field,
                                      motion_blur, antialiasing, textures, sky, filtering, microfacets, maps});
  CHECK(whole.statistics.random_draws() > 0);
  scene.render.integrator = Integrator::automatic;
  CHECK(integrator_of(scene) == Integrator::distributed);
  CHECK(integrator_of(plain_scene()) == Integrator::whitted);
  CHECK(integrator_of(plain_scene(), 2) == Integrator::distributed);

  scene.render.integrator = Integrator::whitted;
  const std::set<Effect> fixed{shadows, reflection, refraction, penumbra, textures, sky, filtering, microfacets, maps};
  CHECK(used_by(scene, 1) == fixed);
  const auto sharp = picture<double>(scene, width, height, {3, 5});
  CHECK(sharp.statistics.random_draws() == 0);
  CHECK(sharp.statistics.formed(RayKind::refract) > 0);
  // Nothing is drawn: neither seed nor sampler can show.
  scene.render.sampler = Sampler::sobol;
  CHECK(same(sharp, picture<double>(scene, width, height, {3, 99})));
  scene.render.light_grid = 1;  // the middle of each light
  CHECK(used_by(scene, 1) == std::set{shadows, reflection, refraction, textures, sky, filtering, microfacets, maps});

  scene.render.integrator = Integrator::cast;
  CHECK(used_by(scene, 1) == std::set{shadows, textures, sky, filtering, maps});
  const auto cast = picture<double>(scene, width, height);
  CHECK(cast.statistics.formed(RayKind::reflect) == 0);
  CHECK(cast.statistics.formed(RayKind::refract) == 0);
  CHECK(cast.statistics.formed(RayKind::shadow) > 0);
  CHECK(cast.statistics.ends(Ending::total_internal_reflection) == 0);
}

TEMPLATE_TEST_CASE("automatic gives the bits of the integrator that it stands for", "", float, double) {
  using T = TestType;
  Scene scene = plain_scene();
  scene.lights[0].strength = Rgbd(1.0);
  scene.objects[0].material.reflection = Rgbd(0.5);
  const auto automatic = picture<T>(scene, width, height);
  for (const Integrator same_bits : {Integrator::whitted, Integrator::distributed}) {
    scene.render.integrator = same_bits;
    CHECK(same(automatic, picture<T>(scene, width, height)));
  }
}
