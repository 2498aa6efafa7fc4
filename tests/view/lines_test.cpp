// The line view: scenes of very many objects, and the names of few.
#include "view/space/lines_view.h"

#include "fixtures.h"
#include "view/space/lines_crowd.h"
#include "view/space/orbit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Small balls all through a large one around the origin, seen from far away, and a great ball last of all.
Scene crowd(int count) {
  Scene scene;
  scene.camera.eye = Vec3d(-20, 0, 0);
  scene.camera.look_at = Vec3d(0.0);
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{Vec3d(-5, 5, 5), {}}});
  for (int i = 0; i + 1 < count; ++i) {
    // Points of a spiral on spheres of all sizes.
    const double z = 1 - 2 * (i + 0.5) / count, angle = 2.399963 * i, r = 4 * std::cbrt(std::fmod(0.618034 * i, 1.0));
    const double level = std::sqrt(1 - z * z);
    const Vec3d at = r * Vec3d(level * std::cos(angle), level * std::sin(angle), z);
    scene.objects.push_back({"Ball " + std::to_string(i), Sphere<double>{at, 0.05}, Material{}});
  }
  scene.objects.push_back({"Great", Sphere<double>{Vec3d(0.0), 1}, Material{}});
  return scene;
}

State lines_of(const Scene& scene) {
  State state = state_of(scene);
  update(state, action::SetMode{Mode::trace});
  return state;
}

std::set<int> drawn_objects(const DisplayList& list) {
  std::set<int> found;
  for (const DisplayItem& item : list)
    if (item.target.kind == TargetKind::object) found.insert(item.target.index);
  return found;
}

}  // namespace

TEST_CASE("of very many objects 1,500 are drawn, the largest among them, and the view says so") {
  State state = lines_of(crowd(2000));
  const DisplayList list = lines_view(state, state.plan.viewport);
  CHECK(is_finite(list));
  const std::set<int> drawn = drawn_objects(list);
  CHECK(drawn.size() == 1500);
  CHECK(drawn.count(1999) == 1);
  // From all over the scene: of each hundred about three quarters.
  for (int hundred = 0; hundred < 20; ++hundred) {
    const auto count = std::distance(drawn.lower_bound(100 * hundred), drawn.lower_bound(100 * hundred + 100));
    CHECK(count > 50);
    CHECK(count < 95);
  }
  CHECK(list.size() < 10'000);
  CHECK(text_with(list, "1,500 of 2,000 objects") != nullptr);
  update(state, action::SetLanguage{"pt"});
  CHECK(text_with(lines_view(state, state.plan.viewport), "1.500 de 2.000 objetos") != nullptr);
  CHECK(text_with(lines_view(lines_of(crowd(1500)), state.plan.viewport), "1,500") == nullptr);
}

TEST_CASE("of very many objects those that rays have met are drawn in full") {
  State state = lines_of(crowd(4000));
  update(state, action::WalkPixel{200, 150, {401, 301}});
  REQUIRE_FALSE(state.walk.timeline->rays().empty());
  const int met = state.walk.timeline->rays().front().object;
  REQUIRE(met >= 0);
  const DisplayList list = lines_view(state, state.plan.viewport);
  CHECK(drawn_objects(list).size() == 1500);
  CHECK(items_of(list, {TargetKind::object, met}).size() > 40);  // circles of lines, where others have one rim
}

TEST_CASE("what is drawn of very many objects is chosen once, and anew when the scene has changed") {
  State state = lines_of(crowd(2000));
  const auto first = crowd_of(state);
  REQUIRE(first);
  CHECK(crowd_of(state) == first);
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  CHECK(crowd_of(state) != first);
  CHECK(crowd_of(lines_of(crowd(1500))) == nullptr);
}

TEST_CASE("a scene of very many objects stands in the middle of the pane, as large as fits") {
  const Viewport pane{860, 480};
  for (const int count : {1000, 10'000}) {
    const Scene scene = crowd(count);
    const Projection seen(overlooking(scene, pane), pane);
    Vec2d least(1e9), most(-1e9);
    const auto include = [&](const Vec3d& point) {
      const auto at = seen.point(point);
      REQUIRE(at);
      least = {std::min(least.x, at->x), std::min(least.y, at->y)};
      most = {std::max(most.x, at->x), std::max(most.y, at->y)};
    };
    include(scene.camera.eye);
    for (const Object& object : scene.objects) include(std::get<Sphere<double>>(object.shape).centre);
    INFO(count << ": " << least.x << " to " << most.x << ", " << least.y << " to " << most.y);
    CHECK((least.x > 0 && most.x < pane.width && least.y > 0 && most.y < pane.height));
    CHECK(std::abs((least.x + most.x) / 2 - pane.width / 2) < 0.05 * pane.width);
    CHECK(std::max((most.x - least.x) / pane.width, (most.y - least.y) / pane.height) > 0.7);
  }
}

TEST_CASE("in a small pane the names of EYE and the lights are whole, or left out") {
  int named = 0, eyes = 0;
  for (const std::string& path : shipped_scenes()) {
    State state = make_state(read_document(path));
    for (const Viewport& pane : {Viewport{420, 210}, Viewport{300, 120}, Viewport{240, 290}}) {
      update(state, action::ResizePlan{pane});
      const DisplayList list = lines_view(state, pane);
      const auto is_whole = [&](const std::string& words) {
        const TextItem* name = text_with(list, words);
        if (name == nullptr) return false;
        INFO(path << ", " << pane.width << " wide: " << name->text);
        const double width = 0.72 * text_width(name->text, name->size);  // text_width() is generous
        const double left = name->at.x - (name->anchor == TextAnchor::middle ? width / 2
                                          : name->anchor == TextAnchor::end  ? width
                                                                             : 0);
        CHECK(left >= 0);
        CHECK(left + width <= pane.width);
        CHECK(name->at.y - 0.38 * name->size >= 0);
        CHECK(name->at.y + 0.38 * name->size <= pane.height);
        return true;
      };
      for (const Light& light : state.scene().lights) named += is_whole(light.name);
      eyes += is_whole("EYE");
    }
  }
  CHECK(named > 50);
  CHECK(eyes > 50);
}

TEST_CASE("where nothing is finite, EYE, SCREEN and the floor that it looks at are in view") {
  for (const std::string scene : {"overcast", "wall"}) {
    State state = make_state(read_document(RAYWALK_SOURCE_DIR "/lessons/17-skies-and-metals/" + scene + ".toml"));
    for (const Viewport& pane : {Viewport{526, 497}, Viewport{345, 316}, Viewport{411, 155}}) {
      update(state, action::ResizePlan{pane});
      const Projection seen(lines_camera(state, pane), pane);
      const Camera& camera = state.scene().camera;
      for (const Vec3d& point : {camera.eye, camera.look_at, (camera.eye + camera.look_at) / 2.0}) {
        const auto at = seen.point(point);
        CAPTURE(scene, pane.width, point.x, point.y, point.z);
        REQUIRE(at);
        CHECK((at->x > 0 && at->x < pane.width && at->y > 0 && at->y < pane.height));
      }
      int lines_of_floor = 0;
      for (const DisplayItem& item : lines_view(state, pane))
        lines_of_floor += item.target == Target{TargetKind::object, 0};
      CHECK(lines_of_floor > 8);
    }
  }
}

TEST_CASE("in space a wall's name does not stand on what lies before it") {
  for (const std::string& path : shipped_scenes()) {
    if (!path.ends_with("/cornell.toml")) continue;
    State state = make_state(read_document(path));
    update(state, action::ResizePlan{{858, 480}});
    const DisplayList list = lines_view(state, state.plan.viewport);
    for (const char* name : {"Floor", "Ball", "Block", "Red wall", "Green wall", "Back wall"}) {
      INFO(name);
      CHECK(text_with(list, name) != nullptr);
    }
    const Projection seen(lines_camera(state, state.plan.viewport), state.plan.viewport);
    const Object& ball = state.scene().objects[static_cast<std::size_t>(index_of_object(state.scene(), "Ball"))];
    const auto& sphere = std::get<Sphere<double>>(ball.shape);
    const auto middle = seen.point(sphere.centre);
    REQUIRE(middle);
    const double radius = sphere.radius * seen.pixels_per_unit(sphere.centre);
    const TextItem* floor = text_with(list, "Floor");
    REQUIRE(floor != nullptr);
    CHECK(length(floor->at - *middle) > radius);
    CHECK(length(text_with(list, "Ball")->at - *middle) < radius);
    return;
  }
  FAIL("no cornell.toml");
}

TEST_CASE("a light out of sight, and a sun, has an arrow at the border, towards where it stands") {
  Scene scene = crowd(2);
  scene.lights = {{"Far", Rgbd(1.0), PointLight{Vec3d(0, 400, 0), {}}},
                  {"Near", Rgbd(1.0), PointLight{Vec3d(0, 0, 3), {}}},
                  {"Sun", Rgbd(1.0), DirectionalLight{Vec3d(0, -1, 0.2)}}};
  const Viewport pane{800, 500};
  State state = lines_of(scene);
  update(state, action::ResizePlan{pane});
  const DisplayList list = lines_view(state, pane);
  const Projection seen(lines_camera(state, pane), pane);
  const auto arrow_of = [&](int light) -> const LineItem* {
    for (const DisplayItem& item : list)
      if (const auto* line = std::get_if<LineItem>(&item.shape);
          line != nullptr && item.target == Target{TargetKind::light, light} && line->arrow > 0)
        return line;
    return nullptr;
  };
  CHECK(arrow_of(1) == nullptr);
  const Vec2d centre(400, 250);
  const std::pair<int, Vec3d> hidden[]{{0, Vec3d(0, 400, 0)}, {2, Vec3d(0, -1e4, 2e3)}};
  for (const auto& [light, place] : hidden) {
    const LineItem* arrow = arrow_of(light);
    INFO(state.scene().lights[static_cast<std::size_t>(light)].name);
    REQUIRE(arrow != nullptr);
    const auto at = seen.point(place);
    const Vec2d way = at ? *at - centre : seen.towards(place), along = arrow->to - arrow->from;
    CHECK(dot(way, along) > 0.999 * length(way) * length(along));
    for (const Vec2d& end : {arrow->from, arrow->to}) {
      CHECK(end.x >= 0);
      CHECK(end.y >= 0);
      CHECK(end.x <= pane.width);
      CHECK(end.y <= pane.height);
    }
    CHECK(text_with(list, state.scene().lights[static_cast<std::size_t>(light)].name) != nullptr);
  }
}
