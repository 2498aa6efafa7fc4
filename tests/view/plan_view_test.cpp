#include "fixtures.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"

#include <algorithm>
#include <set>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::vector<TextItem> texts_of(const DisplayList& list) {
  std::vector<TextItem> texts;
  for (const DisplayItem& item : list)
    if (const auto* text = std::get_if<TextItem>(&item.shape)) texts.push_back(*text);
  return texts;
}

}  // namespace

TEST_CASE("pixels and scene units turn into each other") {
  const State state = busy_state();
  for (const Vec2d& at : {Vec2d(0, 0), Vec2d(800, 600), Vec2d(13, 477)})
    CHECK(length(to_pixels(state, to_scene(state.plan.camera, state.plan.viewport, at)) - at) < 1e-9);
  // y runs up in the scene and down on the screen.
  CHECK(to_pixels(state, Vec2d(0, 1)).y < to_pixels(state, Vec2d(0, 0)).y);
}

TEST_CASE("a sphere so large that it is a wall is drawn where it meets the pane") {
  State near = classic_state();
  Scene scene = near.scene();
  scene.objects.resize(1);
  const Vec2d inside(6, 0), outside(2, 0);
  for (const double radius : {100.0, 1e4, 1e7, 1e12}) {
    scene.objects[0].shape = Sphere<double>{{3 + radius, 0, 0}, radius};
    State state = state_of(scene);
    update(state, action::ResizePlan{{800, 600}});
    state.plan.camera = near.plan.camera;
    const auto drawn = items_of(plan_view(state), {TargetKind::object, 0});
    REQUIRE_FALSE(drawn.empty());
    const auto distance = [&](const Vec2d& at) { return distance_to(drawn[0], to_pixels(state, at)); };
    CHECK(distance(inside) == 0);
    CHECK(distance(outside) == Approx(state.plan.camera.pixels_per_unit).epsilon(0.02));
    CHECK(pick(state, to_pixels(state, inside)) == Target{TargetKind::object, 0});
  }
  // And the pane may lie within it.
  scene.objects[0].shape = Sphere<double>{{0, 0, 0}, 1e6};
  State state = state_of(scene);
  update(state, action::ResizePlan{{800, 600}});
  state.plan.camera = near.plan.camera;
  const auto drawn = items_of(plan_view(state), {TargetKind::object, 0});
  REQUIRE_FALSE(drawn.empty());
  for (const Vec2d& at : {Vec2d(0, 0), Vec2d(800, 600), Vec2d(400, 300)}) CHECK(distance_to(drawn[0], at) == 0);
}

TEST_CASE("a plan shows all of a single sphere, but of one like a wall what is near the eye") {
  Scene scene = classic_state().scene();
  scene.objects.resize(1);
  const auto fitted_to = [&](double radius) {
    scene.objects[0].shape = Sphere<double>{{3 + radius, 0, 0}, radius};
    return fit(scene, {800, 600}).pixels_per_unit;
  };
  CHECK(fitted_to(50) * 100 < 600);
  CHECK(fitted_to(1e6) > fitted_to(50));
}

TEST_CASE("a plane that is turned is drawn as the one that stands there") {
  Scene scene = classic_state().scene();
  scene.objects[0].shape = Plane<double>{{1, 2, 0}, {-1, 0, 0}};
  scene.objects[0].transform.clear();
  const auto wall = wall_line(scene.objects[0]);
  REQUIRE(wall);
  scene.objects[0].shape = Plane<double>{{0, 2, 0}, {0, 1, 0}};
  scene.objects[0].transform = {{Rotate{{0, 0, 1}, 90}}, {Translate{{3, 2, 0}}}};
  const auto turned = wall_line(scene.objects[0]);
  REQUIRE(turned);
  CHECK(length(turned->along - wall->along) < 1e-12);
  CHECK(std::abs(cross(turned->point - wall->point, wall->along)) < 1e-12);
  State state = state_of(scene);
  CHECK_FALSE(items_of(plan_view(state), {TargetKind::object, 0}).empty());
}

TEST_CASE("of many lights only the one that is looked at has its name") {
  Scene scene = classic_state().scene();
  for (int i = 0; i < 60; ++i) {
    scene.lights.push_back(scene.lights[0]);
    scene.lights.back().name = "Lamp " + std::to_string(i);
  }
  State state = state_of(scene);
  update(state, action::ResizePlan{{800, 600}});
  const auto named = [&] {
    const auto texts = texts_of(plan_view(state));
    return std::count_if(texts.begin(), texts.end(),
                         [](const TextItem& text) { return text.text.rfind("Lamp ", 0) == 0; });
  };
  CHECK(named() == 0);
  state.plan.selected = {TargetKind::light, 7};
  CHECK(named() == 1);
}

TEST_CASE("everything with a place fits into the pane") {
  for (const Viewport& pane : {Viewport{800, 600}, Viewport{300, 900}, Viewport{1500, 200}}) {
    State state = classic_state();
    update(state, action::ResizePlan{pane});
    std::vector<Target> targets{{TargetKind::eye}, {TargetKind::screen_height, -1, 0}, {TargetKind::light, 0}};
    for (int i = 0; i < 3; ++i) targets.push_back({TargetKind::object, i});
    for (const Target& target : targets) {
      const Vec2d at = pixels_of(state, target);
      CHECK(at.x > 0);
      CHECK(at.y > 0);
      CHECK(at.x < pane.width);
      CHECK(at.y < pane.height);
    }
  }
}

TEST_CASE("pick finds what plan_view draws") {
  for (const Mode mode : {Mode::move, Mode::trace}) {
    for (State state : {classic_state(), busy_state()}) {
      update(state, action::SetMode{mode});
      std::set<int> kinds;
      for (const DisplayItem& item : plan_view(state)) {
        if (!item.target) continue;
        CHECK(exists(state, item.target));
        kinds.insert(static_cast<int>(item.target.kind));
      }
      // Everything that can be pointed at is found where its handle or symbol is.
      std::vector<Target> targets{{TargetKind::eye}};
      for (int i = 0; i < static_cast<int>(state.scene().lights.size()); ++i) targets.push_back({TargetKind::light, i});
      if (mode == Mode::move) {
        for (const Target& target :
             {Target{TargetKind::view_direction}, Target{TargetKind::screen_distance},
              Target{TargetKind::screen_height, -1, 0}, Target{TargetKind::screen_height, -1, 1}})
          targets.push_back(target);
      } else {
        for (int i = 0; i < state.scene().camera.screen.cells; ++i) targets.push_back({TargetKind::cell, i});
      }
      for (int i = 0; i < static_cast<int>(state.scene().objects.size()); ++i) {
        const ObjectShape& shape = state.scene().objects[static_cast<std::size_t>(i)].shape;
        if (std::holds_alternative<Plane<double>>(shape)) continue;
        targets.push_back({TargetKind::object, i});
        if (mode != Mode::move) continue;
        if (std::holds_alternative<Sphere<double>>(shape)) targets.push_back({TargetKind::radius, i});
        if (const auto* prism = std::get_if<Prism<double>>(&shape)) {
          targets.push_back({TargetKind::rotation, i});
          for (int corner = 0; corner < prism->sides(); ++corner) targets.push_back({TargetKind::corner, i, corner});
        }
      }
      for (const Target& target : targets) {
        INFO("mode " << static_cast<int>(mode) << ", kind " << static_cast<int>(target.kind) << ", index "
                     << target.index << ", part " << target.part);
        CHECK(kinds.count(static_cast<int>(target.kind)) == 1);
        CHECK(pick(state, pixels_of(state, target)) == target);
        CHECK_FALSE(target_text(state, target).empty());
      }
    }
  }
}

TEST_CASE("the object under the pointer says what it is") {
  State state = classic_state();
  for (const std::string name : {"Solid Sphere", "Transparent Sphere", "Polygon"}) {
    const Target target{TargetKind::object, index_of_object(state.scene(), name)};
    update(state, action::PointerMoved{pixels_of(state, target)});
    CHECK(state.plan.hovered == target);
    CHECK_THAT(target_text(state, state.plan.hovered), contains(name));
  }
  update(state, action::PointerMoved{pixels_of(state, {TargetKind::light, 0})});
  CHECK_THAT(target_text(state, state.plan.hovered), contains("Light Source"));
  update(state, action::PointerMoved{pixels_of(state, {TargetKind::eye})});
  CHECK_THAT(target_text(state, state.plan.hovered), contains("EYE"));
  update(state, action::PointerLeft{});
  CHECK_FALSE(state.plan.hovered);
}

TEST_CASE("a ground that is many times as large as all else does not make that tiny") {
  Scene scene = classic_state().scene();
  const Viewport pane{800, 600};
  const PlanCamera before = fit(scene, pane);
  Object ground;
  ground.name = "Ground";
  ground.shape = Box<double>{{-9, -300, -2}, {600, 300, -1.5}};
  scene.objects.push_back(ground);
  Object fence = ground;
  fence.shape = Box<double>{{-3, 5, -1}, {90, 5.2, 1}};
  scene.objects.push_back(fence);
  const PlanCamera after = fit(scene, pane);
  CHECK(after.pixels_per_unit > 0.5 * before.pixels_per_unit);
  // One that is only large is seen whole.
  scene.objects.back().shape = Box<double>{{-3, 5, -1}, {20, 5.2, 1}};
  CHECK(to_pixels(fit(scene, pane), pane, Vec2d(20, 5)).x < pane.width);
  // So is whatever there is nothing beside.
  scene.objects = {ground};
  CHECK(to_pixels(fit(scene, pane), pane, Vec2d(600, 300)).x < pane.width);
}

TEST_CASE("a wall is a line that can be taken hold of, a floor is not drawn") {
  const State state = busy_state();
  const DisplayList list = plan_view(state);
  const int wall = index_of_object(state.scene(), "Wall"), floor = index_of_object(state.scene(), "Floor");
  CHECK_FALSE(items_of(list, {TargetKind::object, wall}).empty());
  CHECK(items_of(list, {TargetKind::object, floor}).empty());
  CHECK(pick(state, to_pixels(state, Vec2d(6, 1.234))) == Target{TargetKind::object, wall});
  // Its hatches lie on its back, which is at larger x.
  const double x = to_pixels(state, Vec2d(6, 0)).x;
  int hatches = 0;
  for (const DisplayItem& item : list) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    if (line == nullptr || std::abs(line->from.x - x) > 1e-6 || std::abs(line->to.x - x) < 1) continue;
    CHECK(line->to.x > x);
    ++hatches;
  }
  CHECK(hatches > 20);
}

TEST_CASE("cells stand in order along SCREEN, cell 0 to the left of the view") {
  const State state = classic_state();
  const DisplayList list = plan_view(state);
  const Camera& camera = state.scene().camera;
  double last_y = -1e9;
  for (int cell = 0; cell < camera.screen.cells; ++cell) {
    const auto items = items_of(list, {TargetKind::cell, cell});
    REQUIRE(items.size() == 1);
    const auto& quad = std::get<PolygonItem>(items.front().shape);
    CHECK(quad.fill == palette(state.appearance.theme).empty_cell);
    Vec2d middle(0.0);
    for (const Vec2d& corner : quad.points) middle += corner / 4.0;
    // EYE looks along +x, so its left is up.
    CHECK(middle.y > last_y);
    last_y = middle.y;
    const double from_left = (cell + 0.5) / camera.screen.cells;
    const Vec2d expected(camera.eye.x + camera.screen.distance, (0.5 - from_left) * *camera.screen.width);
    CHECK(length(middle - to_pixels(state, expected)) < 1e-6);
  }
}

TEST_CASE("cells fill with their final shades, and CLEAR empties them") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  const auto fill_of = [&](int cell) {
    return *std::get<PolygonItem>(items_of(plan_view(state), {TargetKind::cell, cell}).front().shape).fill;
  };
  const Colour empty = palette(state.appearance.theme).empty_cell;
  update(state, action::Step{true, Grain::pixel});
  update(state, action::Step{true, Grain::pixel});
  CHECK(fill_of(0) == display_colour(state.walk.timeline->pixels()[0].shade));
  CHECK(fill_of(1) == display_colour(state.walk.timeline->pixels()[1].shade));
  CHECK(fill_of(2) == empty);
  update(state, action::Step{false, Grain::line});
  CHECK(fill_of(1) == empty);
  update(state, action::Clear{});
  CHECK(fill_of(0) == empty);
}

TEST_CASE("the four objects, EYE and SCREEN carry their names, and no label covers another") {
  for (const Theme theme : {Theme::dark, Theme::projector})
    for (const double scale : {1.0, 2.0}) {
      State state = classic_state();
      update(state, action::SetTheme{theme});
      update(state, action::SetUiScale{scale});
      const auto labels = texts_of(plan_view(state));
      // A name in two lines is two items, one after the other.
      std::string all;
      for (const TextItem& label : labels) all += label.text + " ";
      std::size_t letters = 0;
      for (const std::string name :
           {"EYE", "SCREEN", "Light Source", "Solid Sphere", "Transparent Sphere", "Polygon"}) {
        CHECK_THAT(all, contains(name + " "));
        letters += name.size() + 1;
      }
      CHECK(all.size() == letters);
      for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = i + 1; j < labels.size(); ++j) {
          const double apart_x = std::abs(labels[i].at.x - labels[j].at.x);
          const double apart_y = std::abs(labels[i].at.y - labels[j].at.y);
          const double width =
              (text_width(labels[i].text, labels[i].size) + text_width(labels[j].text, labels[j].size)) / 2;
          INFO(labels[i].text << " and " << labels[j].text << " at scale " << scale);
          CHECK((apart_x >= width || apart_y >= labels[i].size));
        }
    }
}

TEST_CASE("a name stands on what is solid, and beside what rays run through") {
  State state = classic_state();
  update(state, action::ResizePlan{{1600, 1000}});  // so large that every name fits onto its object
  update(state, action::Jump{1 << 20});
  const DisplayList list = plan_view(state);
  const auto stands_on_own = [&](const std::string& name) {
    const auto labels = texts_of(list);
    const auto label = std::find_if(labels.begin(), labels.end(), [&](const TextItem& t) { return t.text == name; });
    REQUIRE(label != labels.end());
    const Target own{TargetKind::object, index_of_object(state.scene(), name)};
    return std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
      return item.target == own && distance_to(item, label->at) == 0;
    });
  };
  CHECK(stands_on_own("Solid Sphere"));
  CHECK(stands_on_own("Polygon"));
  CHECK_FALSE(stands_on_own("Transparent Sphere"));
}

TEST_CASE("move mode has handles and no rays, trace mode rays and no handles") {
  State state = busy_state();
  update(state, action::Jump{1 << 20});
  const auto kinds = [&] {
    std::set<TargetKind> found;
    for (const DisplayItem& item : plan_view(state)) found.insert(item.target.kind);
    return found;
  };
  CHECK(kinds().count(TargetKind::ray) == 1);
  CHECK(kinds().count(TargetKind::radius) == 0);
  update(state, action::SetMode{Mode::move});
  CHECK(kinds().count(TargetKind::ray) == 0);
  for (const TargetKind kind : {TargetKind::radius, TargetKind::corner, TargetKind::edge, TargetKind::rotation,
                                TargetKind::screen_height, TargetKind::screen_distance, TargetKind::view_direction})
    CHECK(kinds().count(kind) == 1);
}

TEST_CASE("lengths and letters grow with the scale and the projector's theme") {
  State state = classic_state();
  const double before = texts_of(plan_view(state)).front().size;
  update(state, action::SetUiScale{2});
  CHECK(texts_of(plan_view(state)).front().size == Approx(2 * before));
  update(state, action::SetTheme{Theme::projector});
  CHECK(texts_of(plan_view(state)).front().size > 2 * before);
}

TEST_CASE("every shipped scene is drawn with finite numbers, at every zoom") {
  std::size_t turn = 0;
  for (const auto& path : shipped_scenes()) {
    INFO(path);
    State state = make_state(read_document(path));
    for (const Mode mode : {Mode::move, Mode::trace, Mode::help, Mode::trace}) {
      if (left_to_all(turn++, 3)) continue;
      update(state, action::SetMode{mode});
      state.walk.position = state.walk.timeline->steps();
      for (const double factor : {1.0, 1e-3, 1e6, 1e6, 1e-12}) {
        update(state, action::Zoom{{100, 100}, factor});
        CHECK(is_finite(plan_view(state)));
      }
    }
  }
}

TEST_CASE("the plan is drawn however far away it is looked at") {
  for (const double factor : {1e-12, 1.0, 1e12}) {
    State state = busy_state();
    update(state, action::Pan{{1e300, -1e300}});
    update(state, action::Zoom{{400, 300}, factor});
    const DisplayList list = plan_view(state);
    CHECK(is_finite(list));
    CHECK(list.size() < 1000);
    update(state, action::AddObject{action::ObjectKind::polygon});
    CHECK(broken_promise(state) == "");
  }
}

TEST_CASE("of a crowd the plan draws no more than can be told apart, and all that stands out") {
  State state = classic_state();
  const auto drawn_of = [&](int count) {
    Scene scene = state.scene();
    scene.objects.resize(1);
    scene.objects[0].shape = Sphere<double>{{0, 0, 0}, 0.5};
    Object small = scene.objects[0];
    for (int i = 0; i < count; ++i) {
      small.name = "Small " + std::to_string(i);
      small.shape = Sphere<double>{{std::sin(i * 0.37) * 2, std::cos(i * 0.91) * 2, 0}, 1e-3};
      scene.objects.push_back(small);
    }
    const State crowded = state_of(scene);
    std::set<int> objects;
    for (const DisplayItem& item : plan_view(crowded))
      if (item.target.kind == TargetKind::object && std::holds_alternative<CircleItem>(item.shape))
        objects.insert(item.target.index);
    CHECK(objects.count(0) == 1);
    return static_cast<int>(objects.size());
  };
  CHECK(drawn_of(4000) == 4001);
  const double cells = (state.plan.viewport.width / 6 + 1) * (state.plan.viewport.height / 6 + 1);
  const int many = drawn_of(60000);
  CHECK(many > 1000);
  CHECK(many < cells);
  CHECK(many < 20000);
}
