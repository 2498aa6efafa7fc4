// The lobe in the plan: where a rough mirror sends light, from the hit that the walk is at.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fixtures.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/languages.h"
#include "trace/map_images.h"
#include "view/plan/painter.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State metals(Integrator integrator) {
  auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/metals.toml");
  REQUIRE(read);
  read->scene.render.integrator = integrator;
  read->scene.render.samples = 1;
  State state = state_of(read->scene);
  state.plan.viewport = {900, 620};
  update(state, action::SetMode{Mode::trace});
  return state;
}

// The position after the first hit of an object by a primary ray.
int hit_of(const State& state, const std::string& name) {
  for (const RayRecord& ray : state.walk.timeline->rays())
    if (ray.kind == RayKind::primary && ray.object >= 0 &&
        state.scene().objects[static_cast<std::size_t>(ray.object)].name == name)
      return ray.found_at;
  return -1;
}

// The curve that begins at the current hit.
std::optional<PolygonItem> lobe(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))];
  const Vec2d hit = to_pixels(state.plan.camera, state.plan.viewport, Vec2d(ray.end.x, ray.end.y));
  for (const DisplayItem& item : plan_view(state))
    if (const auto* polygon = std::get_if<PolygonItem>(&item.shape))
      if (polygon->points.size() > 50 && length(polygon->points[0] - hit) < 1e-6) return *polygon;
  return {};
}

// At the hit of a ball that is of this material.
State hit_with(const Material& material, Integrator integrator) {
  Scene scene = metals(integrator).scene();
  for (Object& each : scene.objects)
    if (each.name == "Rough Gold") each.material = material;
  State state = state_of(scene);
  state.plan.viewport = {900, 620};
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{hit_of(state, "Rough Gold")});
  return state;
}

// The place of the curve that lies farthest from the hit, where it begins.
Vec2d tip_of(const PolygonItem& curve) {
  const Vec2d hit = curve.points[0];
  return *std::max_element(curve.points.begin(), curve.points.end(),
                           [&](const Vec2d& a, const Vec2d& b) { return length(a - hit) < length(b - hit); });
}

// The largest angle to its tip of a place that lies at least half as far out.
double width_of(const PolygonItem& curve) {
  const Vec2d hit = curve.points[0], tip = tip_of(curve) - hit;
  double widest = 0;
  for (const Vec2d& at : curve.points) {
    const double far = length(at - hit);
    if (far >= length(tip) / 2)
      widest = std::max(widest, std::acos(std::clamp(dot(at - hit, tip) / (far * length(tip)), -1.0, 1.0)));
  }
  return widest;
}

}  // namespace

TEST_CASE("the lobe of a rough mirror points where light is mirrored to, and is wider the rougher") {
  for (const Integrator integrator : {Integrator::path, Integrator::distributed, Integrator::whitted}) {
    State state = metals(integrator);
    double before = 0;
    for (const std::string name : {"Rough Gold", "Rougher Gold"}) {
      CAPTURE(name);
      const int position = hit_of(state, name);
      REQUIRE(position > 0);
      update(state, action::Jump{position});
      const auto curve = lobe(state);
      REQUIRE(curve);
      const Timeline& timeline = *state.walk.timeline;
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(position))];
      const Vec3d mirrored = ray.direction - 2 * dot(ray.direction, ray.normal) * ray.normal;
      const Vec2d hit = curve->points[0], along(mirrored.x, -mirrored.y);
      const Vec2d tip = tip_of(*curve);
      const double farthest = length(tip - hit), half_as_far = width_of(*curve);
      CHECK(farthest > 30);
      CHECK(farthest < 200);
      // Rough mirrors send most of it a little flatter than a smooth one.
      CHECK(dot(tip - hit, along) / farthest > 0.8);
      CHECK(half_as_far > before);
      before = half_as_far;
    }
    const int smooth = hit_of(state, "Smooth Gold");
    REQUIRE(smooth > 0);
    update(state, action::Jump{smooth});
    CHECK_FALSE(lobe(state));
  }
}

TEST_CASE("the lobe of rough glass is on both sides, that of a rough matt surface leans to where light comes from") {
  // How far the curve goes on the side of the normal, and beyond.
  const auto reaches = [](const State& state) {
    const auto curve = lobe(state);
    REQUIRE(curve);
    const Timeline& timeline = *state.walk.timeline;
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))];
    double before = 0, beyond = 0;
    for (const Vec2d& at : curve->points) {
      const Vec2d from = at - curve->points[0];
      const double up = from.x * ray.normal.x - from.y * ray.normal.y;
      before = std::max(before, up), beyond = std::max(beyond, -up);
    }
    return std::pair(before, beyond);
  };
  Material glass;
  glass.diffuse = Rgbd(0.0), glass.transmission = Rgbd(1.0);
  glass.dielectric = true;
  glass.roughness = 0.3;
  const auto through = reaches(hit_with(glass, Integrator::path));
  CHECK(through.second > 30);
  CHECK(through.first > 0);
  CHECK(through.first < through.second / 2);
  const auto shown = reaches(hit_with(glass, Integrator::whitted));
  CHECK(shown.first > 20);
  CHECK(shown.second < 1e-6);

  Material dust;
  CHECK_FALSE(lobe(hit_with(dust, Integrator::path)));
  dust.diffuse_roughness = 1;
  for (const Integrator integrator : {Integrator::path, Integrator::whitted, Integrator::cast}) {
    const State state = hit_with(dust, integrator);
    const auto matt = reaches(state);
    CHECK(matt.first > 20);
    CHECK(matt.second < 1e-6);
    const Timeline& timeline = *state.walk.timeline;
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))];
    const Vec2d aside(-ray.normal.y, -ray.normal.x);
    const Vec2d back(-ray.direction.x, ray.direction.y);
    const auto curve = lobe(state);
    REQUIRE(curve);
    double there = 0, away = 0;
    for (const Vec2d& at : curve->points) {
      const double along = dot(at - curve->points[0], aside) * (dot(back, aside) > 0 ? 1 : -1);
      there = std::max(there, along), away = std::max(away, -along);
    }
    CHECK(there >= away);
  }
}

TEST_CASE("a map makes the lobe what it makes of the surface there") {
  Material plain;
  plain.diffuse = plain.specular = plain.ambient = Rgbd(0.0);
  plain.reflection = Rgbd(0.9);
  plain.roughness = 0.2;
  const auto width_with = [](const Material& material) {
    const auto curve = lobe(hit_with(material, Integrator::path));
    REQUIRE(curve);
    return width_of(*curve);
  };
  const double alone = width_with(plain);
  const auto mapped_to = [&](double level) {
    Material mapped = plain;
    mapped.roughness = 0.4;
    ParameterMap map;
    map.of = MappedParameter::roughness;
    map.file = "even.png";
    map.pixels = uniform(Rgbd(level));
    mapped.maps = {map};
    return width_with(mapped);
  };
  // 0.4 times a half is 0.2 again.
  CHECK(mapped_to(0.5) == Approx(alone).epsilon(0.05));
  CHECK(mapped_to(1) > 1.3 * alone);
}

TEST_CASE("rough glass inside of a body bends light as it does there") {
  Material glass, water;
  for (Material* each : {&glass, &water}) {
    each->diffuse = each->specular = each->ambient = Rgbd(0.0);
    each->transmission = Rgbd(1.0);
    each->dielectric = true;
  }
  glass.ior = 1.5, glass.roughness = 0.1;
  water.ior = 1.5;
  const auto curve_at_ball = [&](bool in_water) {
    Scene scene = metals(Integrator::path).scene();
    scene.objects.clear();
    scene.objects.push_back({"Ball", Sphere<double>{{0, 0.6, 0}, 1}, glass});
    if (in_water) scene.objects.push_back({"Water", Sphere<double>{{0, 0, 0}, 100}, water});
    scene.camera.eye = {-4, 0, 0};
    scene.camera.look_at = {0, 0, 0};
    State state = state_of(scene);
    state.plan.viewport = {900, 620};
    update(state, action::SetMode{Mode::trace});
    const int at = hit_of(state, "Ball");
    REQUIRE(at > 0);
    update(state, action::Jump{at});
    return lobe(state);
  };
  CHECK(curve_at_ball(false));
  // Of the same index, it bends nothing: nothing is rough there.
  CHECK_FALSE(curve_at_ball(true));
}

TEST_CASE("there is no lobe where nothing is reflected, nor while the scene is changed") {
  State cast = metals(Integrator::cast);
  update(cast, action::Jump{hit_of(cast, "Rough Gold")});
  CHECK_FALSE(lobe(cast));
  State state = metals(Integrator::path);
  update(state, action::Jump{hit_of(state, "Rough Gold")});
  CHECK(lobe(state));
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(lobe(state));
}

TEST_CASE("the lobe and its words stay within the sky's ring, and the words off the bodies' outlines") {
  for (const Language language : all_languages())
    for (const Viewport pane : {Viewport{857, 476}, Viewport{550, 240}}) {
      State state = metals(Integrator::path);
      state.plan.viewport = pane;
      state.appearance.language = language;
      update(state, action::FitView{});
      // The ring's inner edge: four pixels from the pane's, nine wide.
      const auto within = [&](const Vec2d& at) {
        const double x = (at.x - pane.width / 2) / (pane.width / 2 - 13);
        const double y = (at.y - pane.height / 2) / (pane.height / 2 - 13);
        return x * x * x * x + y * y * y * y < 1;
      };
      int said = 0, lobes = 0;
      for (const RayRecord& ray : state.walk.timeline->rays()) {
        if (ray.kind != RayKind::primary || ray.object < 0) continue;
        update(state, action::Jump{ray.found_at});
        const auto curve = lobe(state);
        if (!curve) continue;
        ++lobes;
        INFO(language.code() << ", pixel " << ray.pixel << ", " << pane.width << " wide");
        CHECK(std::all_of(curve->points.begin(), curve->points.end(), within));
        const DisplayList list = plan_view(state);
        for (const DisplayItem& item : list) {
          const auto* words = std::get_if<TextItem>(&item.shape);
          if (words == nullptr ||
              (words->text != text("plan.lobe", language) && words->text != text("plan.lobe_short", language)))
            continue;
          ++said;
          const Vec2d half(width_of(words->text, words->size) / 2, words->size / 2);
          for (const double x : {-half.x, half.x})
            for (const double y : {-half.y, half.y}) CHECK(within(words->at + Vec2d(x, y)));
          for (const DisplayItem& other : list)
            if (const auto* ball = std::get_if<CircleItem>(&other.shape);
                ball != nullptr && other.target.kind == TargetKind::object) {
              const Vec2d nearest(std::clamp(ball->centre.x, words->at.x - half.x, words->at.x + half.x),
                                  std::clamp(ball->centre.y, words->at.y - half.y, words->at.y + half.y));
              CHECK(length(nearest - ball->centre) >= ball->radius);
            }
        }
      }
      CHECK(lobes > 5);
      // In a small pane there is no room beside a lobe in a corner.
      CHECK(said >= lobes - (pane.width < 600 ? 1 : 0));
    }
}

TEST_CASE("without random numbers the lobe is said to be that of the highlights") {
  State state = metals(Integrator::whitted);
  update(state, action::Jump{hit_of(state, "Rough Gold")});
  const auto says = [&](std::string_view id) {
    const DisplayList list = plan_view(state);
    return std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
      const auto* words = std::get_if<TextItem>(&item.shape);
      return words != nullptr && words->text == text(id, state.appearance.language);
    });
  };
  CHECK(says("plan.lobe_highlight"));
  CHECK_FALSE(says("plan.lobe"));
}
