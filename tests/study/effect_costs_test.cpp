#include "study/effect_costs.h"

#include <cmath>

#include "render/render.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::study;

namespace {

// A mirror, glass, a checkered floor and a lamp with an extent.
Scene scene_of_all() {
  Scene scene;
  Material mirror, glass, floor;
  mirror.reflection = Rgbd(0.8);
  glass.transmission = Rgbd(0.9), glass.reflection = Rgbd(0.1), glass.dielectric = true;
  floor.checker = Checker{Rgbd(1.0), Rgbd(0.2), 0.7};
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, floor},
                   {"Mirror", Sphere<double>{{0, 1.1, 0}, 1}, mirror},
                   {"Glass", Sphere<double>{{0, -1.1, 0}, 1}, glass}};
  scene.lights = {{"Panel", Rgbd(1.0), RectangleLight{{-1, -1, 4}, {2, 0, 0}, {0, 2, 0}, 3, {}}}};
  scene.camera.eye = {-6, 0, 1};
  scene.camera.look_at = {0, 0, 0};
  scene.image = {40, 30};
  return scene;
}

const EffectCost* cost_of_effect(const SceneCost& cost, Effect effect) {
  for (const EffectCost& e : cost.effects)
    if (e.effect == effect) return &e;
  return nullptr;
}

Film<double> pictured(const Scene& scene) {
  RenderSettings settings{ImageSize{40, 30}, {scene.render.samples, 0}};
  return render(scene, settings)->film_of<double>();
}

}  // namespace

TEST_CASE("a scene without an effect does not call for it, and still for all others") {
  Scene scene = scene_of_all();
  scene.objects[1].material.gloss = 3;
  scene.objects[2].material.translucency = 3;
  scene.camera.aperture = 0.1;
  scene.objects[1].motion = {{0, Vec3d(0.0)}, {1, Vec3d(0.2, 0, 0)}};
  scene.render.samples = 4;
  const Effects all = effects_of(scene, 4);
  int tried = 0;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    const auto changed = without(scene, effect);
    CAPTURE(name_of(effect));
    CHECK(changed.has_value() == (effect != Effect::shadows));
    if (!changed || !all.used(effect)) continue;
    ++tried;
    const Effects left = effects_of(*changed, changed->render.samples);
    // Glass without reflection still reflects all of what cannot leave it.
    CHECK(left.used(effect) == (effect == Effect::reflection));
    for (const Effect other : {Effect::penumbra, Effect::depth_of_field, Effect::motion_blur, Effect::textures})
      if (other != effect) CHECK(left.used(other));
  }
  CHECK(tried == 9);  // all but shadows and indirect light
}

TEST_CASE("materials inside groups and files lose an effect too") {
  Scene scene = scene_of_all();
  Group group{"Balls", {scene.objects[1]}};
  group.objects[0].name = "Inner";
  scene.groups = {group};
  scene.objects = {scene.objects[0],
                   {"Copy", Instance{"Balls", std::make_shared<const GroupContent>(group)}, Material{}}};
  CHECK(effects_of(scene).used(Effect::reflection));
  const auto dull = without(scene, Effect::reflection);
  CHECK_FALSE(effects_of(*dull).used(Effect::reflection));
  CHECK(pictured(*dull).pixels() != pictured(scene).pixels());
}

TEST_CASE("costs count what is gone without an effect") {
  const auto cost = scene_cost(scene_of_all(), 1200, 3);
  REQUIRE(cost);
  CHECK(cost->size == ImageSize{40, 30});
  REQUIRE(cost->effects.size() == 4);
  for (const Effect effect : {Effect::reflection, Effect::refraction, Effect::penumbra, Effect::textures})
    CHECK(cost_of_effect(*cost, effect) != nullptr);
  // Nine shadow rays in place of one.
  const EffectCost& penumbra = *cost_of_effect(*cost, Effect::penumbra);
  CHECK(penumbra.rays_share > 0.6);
  CHECK(penumbra.rays_share < 8.0 / 9);
  CHECK(cost_of_effect(*cost, Effect::textures)->saved.rays == 0);
  for (const EffectCost& e : cost->effects) {
    CHECK(e.rays_share == static_cast<double>(e.saved.rays) / static_cast<double>(cost->whole.rays));
    CHECK(e.seconds_low <= e.seconds_share);
    CHECK(e.seconds_share <= e.seconds_high);
  }
  for (std::size_t i = 1; i < 4; ++i) CHECK(cost->effects[i - 1].saved.rays >= cost->effects[i].saved.rays);
  CHECK(cost->shadow_rays < cost->whole.rays);
  REQUIRE(cost->everything);
  CHECK(cost->everything->rays > 3 * cost->whole.rays);
  // Counts are the same each time.
  const auto again = scene_cost(scene_of_all(), 1200, 3);
  CHECK(again->whole.rays == cost->whole.rays);
  CHECK(again->everything->rays == cost->everything->rays);
}

TEST_CASE("what a scene does not call for costs it nothing, and is not listed") {
  Scene scene = scene_of_all();
  scene.objects.resize(1);
  scene.objects[0].material.checker.reset();
  scene.lights[0].kind = PointLight{{0, 0, 4}, {}};
  const auto cost = scene_cost(scene, 1200, 3);
  REQUIRE(cost);
  CHECK(cost->effects.empty());
  REQUIRE(cost->everything);
  CHECK(cost->everything->rays > 8 * cost->whole.rays);
}

TEST_CASE("where every effect would have no end of rays, only those of the scene are measured") {
  Scene scene = scene_of_all();
  scene.limits.depth = deepest_everything + 1;
  const auto cost = scene_cost(scene, 1200, 1);
  REQUIRE(cost);
  CHECK_FALSE(cost->everything);
  CHECK(cost->effects.size() == scene_cost(scene_of_all(), 1200, 1)->effects.size());
}

TEST_CASE("everything regardless shows the same picture") {
  Scene scene = scene_of_all();
  scene.lights[0].kind = PointLight{{0, 0, 4}, {}};
  const Scene all = with_everything(scene, 4);
  const Effects effects = effects_of(all);
  for (const Effect effect : {Effect::reflection, Effect::refraction, Effect::gloss, Effect::translucency,
                              Effect::penumbra, Effect::depth_of_field, Effect::motion_blur})
    CHECK(effects.used(effect));
  const Film<double> a = pictured(scene), b = pictured(all);
  int different = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    if (length(a.pixels()[i] - b.pixels()[i]) > 1e-3) ++different;
  CHECK(different < 12);  // of 1200: where a ray passes an edge by a hair
}

TEST_CASE("a survey tells what it knows after each round, and ends where all at once ends") {
  CostSurvey survey(scene_of_all(), 1200, 2);
  CHECK_FALSE(survey.result());
  double done = 0;
  int pictures = 1;
  for (; survey.work(); ++pictures) {
    CHECK(survey.done() > done);
    done = survey.done();
    // The whole, four effects, and everything; the first round warms up.
    CHECK(survey.result().has_value() == (pictures >= 12));
    if (const auto known = survey.result()) CHECK(known->repetitions == 1);
  }
  CHECK(pictures == 18);
  CHECK(survey.done() == 1);
  CHECK_FALSE(survey.work());
  const auto end = survey.result(), at_once = scene_cost(scene_of_all(), 1200, 2);
  REQUIRE(end);
  CHECK(end->repetitions == 2);
  CHECK(end->whole.rays == at_once->whole.rays);
  REQUIRE(end->effects.size() == at_once->effects.size());
  for (std::size_t i = 0; i < end->effects.size(); ++i)
    CHECK(end->effects[i].saved.rays == at_once->effects[i].saved.rays);
}

TEST_CASE("a measurement can be stopped") {
  Stopper stopper;
  stopper.raised = true;
  CHECK_FALSE(scene_cost(scene_of_all(), 1200, 3, {}, Stop(stopper)));
}
