#include "fixtures.h"
#include "view/text/text.h"

#include <functional>
#include <limits>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Edit {
  std::string name;
  std::function<void(State&)> make;
};

Material changed_material(const State& state, int object) {
  Material material = state.scene().objects[static_cast<std::size_t>(object)].material;
  material.diffuse = Rgbd(0.123, 0.4, 0.5);
  return material;
}

/// One of each kind of edit, on the busy scene.
std::vector<Edit> all_edits() {
  using action::ObjectKind;
  std::vector<Edit> edits;
  for (const ObjectKind kind :
       {ObjectKind::solid_sphere, ObjectKind::transparent_sphere, ObjectKind::polygon, ObjectKind::light})
    edits.push_back({"add", [kind](State& s) { update(s, action::AddObject{kind}); }});
  const auto removal = [](const Target& target) {
    return [target](State& s) {
      update(s, action::Select{target});
      update(s, action::RemoveSelected{});
    };
  };
  edits.push_back({"remove object", removal({TargetKind::object, 1})});
  edits.push_back({"remove light", removal({TargetKind::light, 0})});
  edits.push_back({"remove selected corner", removal({TargetKind::corner, 2, 3})});
  edits.push_back({"insert corner", [](State& s) { update(s, action::InsertCorner{2, 0, Vec2d(3.3, -2.1)}); }});
  edits.push_back({"remove corner", [](State& s) { update(s, action::RemoveCorner{2, 3}); }});
  edits.push_back({"rename object", [](State& s) { update(s, action::Rename{{TargetKind::object, 0}, "Chrome"}); }});
  edits.push_back({"rename light", [](State& s) { update(s, action::Rename{{TargetKind::light, 1}, "Star"}); }});
  edits.push_back({"material", [](State& s) { update(s, action::SetMaterial{1, changed_material(s, 1)}); }});
  edits.push_back({"shape", [](State& s) { update(s, action::SetShape{0, Sphere<double>{Vec3d(1, 1, 0), 0.5}}); }});
  edits.push_back({"light", [](State& s) {
                     Light light = s.scene().lights[0];
                     light.strength = Rgbd(0.5);
                     update(s, action::SetLight{0, light});
                   }});
  edits.push_back({"camera", [](State& s) {
                     Camera camera = s.scene().camera;
                     camera.screen.cells = 31;
                     update(s, action::SetCamera{camera});
                   }});
  edits.push_back({"limits", [](State& s) { update(s, action::SetLimits{{2, 0.1}}); }});
  edits.push_back({"surroundings", [](State& s) { update(s, action::SetSurroundings{Rgbd(0.5), Rgbd(0.1), {}}); }});
  for (const Target& target :
       {Target{TargetKind::object, 0}, Target{TargetKind::object, 2}, Target{TargetKind::object, 3},
        Target{TargetKind::light, 0}, Target{TargetKind::light, 1}, Target{TargetKind::eye},
        Target{TargetKind::view_direction}, Target{TargetKind::screen_height, -1, 0},
        Target{TargetKind::screen_distance}, Target{TargetKind::radius, 0}, Target{TargetKind::corner, 2, 1},
        Target{TargetKind::rotation, 2}})
    edits.push_back({"nudge", [target](State& s) {
                       update(s, action::Select{target});
                       update(s, action::Nudge{{1, 0.5}, true});
                     }});
  return edits;
}

}  // namespace

TEST_CASE("every edit changes the scene, and undo and redo lead exactly back and forth") {
  int number = 0;
  for (const Edit& edit : all_edits()) {
    INFO(edit.name << ", edit " << number++);
    State state = busy_state();
    const Scene before = state.scene();
    const std::uint64_t revision = state.document.revision;
    edit.make(state);
    const Scene after = state.scene();
    CHECK(after != before);
    CHECK(state.document.revision != revision);
    CHECK(state.document.dirty);
    CHECK(state.document.undo.size() == 1);
    CHECK(broken_promise(state) == "");
    update(state, action::Undo{});
    CHECK(state.scene() == before);
    CHECK_FALSE(state.document.dirty);
    CHECK(broken_promise(state) == "");
    update(state, action::Redo{});
    CHECK(state.scene() == after);
    CHECK(state.document.dirty);
    CHECK(broken_promise(state) == "");
  }
}

TEST_CASE("many edits in a row are undone one by one, and redone") {
  State state = busy_state();
  std::vector<Scene> scenes{state.scene()};
  for (const Edit& edit : all_edits()) {
    edit.make(state);
    if (state.scene() != scenes.back()) scenes.push_back(state.scene());
  }
  REQUIRE(scenes.size() > 15);
  for (std::size_t i = scenes.size() - 1; i-- > 0;) {
    update(state, action::Undo{});
    CHECK(state.scene() == scenes[i]);
  }
  update(state, action::Undo{});
  CHECK(state.scene() == scenes.front());
  REQUIRE(state.document.notice);
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    update(state, action::Redo{});
    CHECK(state.scene() == scenes[i]);
  }
}

TEST_CASE("an edit after undo forgets what could have been redone") {
  State state = busy_state();
  update(state, action::AddObject{action::ObjectKind::polygon});
  update(state, action::Undo{});
  update(state, action::SetLimits{{3, 0}});
  const Scene scene = state.scene();
  update(state, action::Redo{});
  CHECK(state.scene() == scene);
}

TEST_CASE("a slider that is dragged is one entry of undo, two edits are two") {
  State state = busy_state();
  const Scene before = state.scene();
  Material material = state.scene().objects[0].material;
  for (int i = 0; i < 10; ++i) {
    material.shininess = 10 + i;
    update(state, action::SetMaterial{0, material, i > 0});
  }
  CHECK(state.document.undo.size() == 1);
  material.shininess = 99;
  update(state, action::SetMaterial{0, material});
  CHECK(state.document.undo.size() == 2);
  // It continues nothing: the edit before was of another object.
  update(state, action::SetMaterial{1, material, true});
  CHECK(state.document.undo.size() == 3);
  for (int i = 0; i < 3; ++i) update(state, action::Undo{});
  CHECK(state.scene() == before);
}

TEST_CASE("an edit that leads back to where it began leaves undo and redo as they were") {
  State state = busy_state();
  const auto set_radius = [&](double radius, bool continues) {
    update(state, action::SetShape{0, Sphere<double>{Vec3d(1, 1, 0), radius}, continues});
  };
  set_radius(0.6, false);
  set_radius(0.7, false);
  const Scene last = state.scene();
  update(state, action::Undo{});
  const Scene before = state.scene();
  REQUIRE(state.document.undo.size() == 1);
  REQUIRE(state.document.redo.size() == 1);
  // Digits that take effect as they are typed, and Escape.
  for (int i = 0; i < 2; ++i) {
    set_radius(3, false);
    set_radius(3.5, true);
    CHECK(state.document.undo.size() == 2);
    CHECK(state.document.redo.empty());
    set_radius(0.6, true);
    CHECK(state.scene() == before);
    CHECK(state.document.undo.size() == 1);
    CHECK(state.document.redo.size() == 1);
  }
  // What continues after that is an edit of its own.
  set_radius(4, true);
  CHECK(state.document.undo.size() == 2);
  CHECK(state.document.redo.empty());
  set_radius(0.6, true);
  update(state, action::Redo{});
  CHECK(state.scene() == last);
  CHECK(state.document.undo.size() == 2);
  update(state, action::Undo{});
  // A second edit leads back, too, but is one that can be undone.
  set_radius(3, false);
  set_radius(0.6, false);
  CHECK(state.document.undo.size() == 3);
  CHECK(state.document.redo.empty());
}

TEST_CASE("an edit that would break the scene is refused and says why") {
  const auto refused = [](const std::string& what, const auto& make) {
    INFO(what);
    State state = busy_state();
    const Scene before = state.scene();
    make(state);
    CHECK(state.scene() == before);
    CHECK(state.document.undo.empty());
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->kind == Notice::Kind::error);
    CHECK(state.document.notice->text.size() > 10);
    CHECK(broken_promise(state) == "");
  };
  refused("radius 0", [](State& s) { update(s, action::SetShape{0, Sphere<double>{Vec3d(0.0), 0}}); });
  refused("radius < 0", [](State& s) { update(s, action::SetShape{0, Sphere<double>{Vec3d(0.0), -1}}); });
  refused("radius nan", [](State& s) { update(s, action::SetShape{0, Sphere<double>{Vec3d(0.0), not_a_number}}); });
  refused("crossing edges",
          [](State& s) { update(s, action::SetShape{2, Prism<double>{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1}}); });
  refused("no corners", [](State& s) { update(s, action::SetShape{2, Prism<double>{{}, 1}}); });
  refused("plane without normal",
          [](State& s) { update(s, action::SetShape{3, Plane<double>{Vec3d(0.0), Vec3d(0.0)}}); });
  refused("eye onto look-at", [](State& s) {
    Camera camera = s.scene().camera;
    camera.eye = camera.look_at;
    update(s, action::SetCamera{camera});
  });
  refused("up along the view", [](State& s) {
    Camera camera = s.scene().camera;
    camera.up = camera.look_at - camera.eye;
    update(s, action::SetCamera{camera});
  });
  refused("no cells", [](State& s) {
    Camera camera = s.scene().camera;
    camera.screen.cells = 0;
    update(s, action::SetCamera{camera});
  });
  refused("negative diffuse", [](State& s) {
    Material material;
    material.diffuse = Rgbd(-1, 0, 0);
    update(s, action::SetMaterial{0, material});
  });
  refused("ior 0", [](State& s) {
    Material material;
    material.ior = 0;
    update(s, action::SetMaterial{0, material});
  });
  refused("light at infinity", [](State& s) {
    Light light = s.scene().lights[0];
    light.kind = PointLight{Vec3d(std::numeric_limits<double>::infinity(), 0, 0), {}};
    update(s, action::SetLight{0, light});
  });
  refused("depth 0", [](State& s) { update(s, action::SetLimits{{0, 0}}); });
  refused("background nan", [](State& s) { update(s, action::SetSurroundings{Rgbd(not_a_number), Rgbd(0.0), {}}); });
  refused("empty name", [](State& s) { update(s, action::Rename{{TargetKind::object, 0}, ""}); });
  refused("taken name", [](State& s) { update(s, action::Rename{{TargetKind::object, 0}, "Lamp"}); });
  refused("nudge across an edge", [](State& s) {
    update(s, action::Select{{TargetKind::corner, 2, 3}});
    update(s, action::Nudge{{0, -20}, true});
  });
}

TEST_CASE("why a name is refused is told in the language of the window") {
  for (const Language language : all_languages()) {
    State state = busy_state();
    state.appearance.language = language;
    const Scene before = state.scene();
    const auto refused = [&](const std::string& name) {
      update(state, action::Rename{{TargetKind::object, 0}, name});
      CHECK(state.scene() == before);
      REQUIRE(state.document.notice);
      return state.document.notice->text;
    };
    for (const char* blanks : {"", "   ", " \t"}) CHECK(refused(blanks) == text("notice.refused_name_empty", language));
    CHECK(refused(std::string(101, 'a')) ==
          fill("notice.refused_name_long", language, {{"bytes", 101}, {"most", 100}}));
    CHECK(refused("Luna \uFFFD") == text("notice.refused_name_letters", language));
    update(state, action::Rename{{TargetKind::object, 0}, std::string(100, 'a')});
    CHECK(state.scene().objects[0].name == std::string(100, 'a'));
  }
}

TEST_CASE("edits of what is not there do nothing") {
  State state = busy_state();
  const Scene before = state.scene();
  update(state, action::SetMaterial{-1, Material{}});
  update(state, action::SetMaterial{99, Material{}});
  update(state, action::SetShape{99, Sphere<double>{}});
  update(state, action::SetLight{99, Light{}});
  update(state, action::InsertCorner{0, 0, Vec2d(0.0)});
  update(state, action::InsertCorner{2, 99, Vec2d(0.0)});
  update(state, action::RemoveCorner{2, -1});
  update(state, action::Rename{{TargetKind::eye}, "Eye"});
  update(state, action::Select{{TargetKind::object, 99}});
  update(state, action::RemoveSelected{});
  CHECK(state.scene() == before);
  CHECK_FALSE(state.plan.selected);
}

TEST_CASE("a polygon keeps three corners") {
  State state = busy_state();
  for (int i = 0; i < 10; ++i) update(state, action::RemoveCorner{2, 0});
  CHECK(std::get<Prism<double>>(state.scene().objects[2].shape).sides() == 3);
  CHECK(broken_promise(state) == "");
}

TEST_CASE("an inserted corner lies on its edge and leaves the shape as it was") {
  State state = busy_state();
  const auto area = [&] { return std::get<Prism<double>>(state.scene().objects[2].shape).twice_signed_area(); };
  const double before = area();
  update(state, action::InsertCorner{2, 0, Vec2d(3.3, -1)});
  CHECK(area() == Approx(before));
  CHECK(state.plan.selected == Target{TargetKind::corner, 2, 1});
}

TEST_CASE("added objects have their own names, stand free and are selected") {
  State state = classic_state();
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  CHECK(state.plan.selected == Target{TargetKind::object, static_cast<int>(state.scene().objects.size()) - 1});
  CHECK(state.scene().objects.back().name == "Solid Sphere 2");
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  CHECK(state.scene().objects.back().name == "Solid Sphere 3");
  update(state, action::AddObject{action::ObjectKind::light});
  CHECK(state.scene().lights.back().name == "Light Source 2");
  std::vector<Sphere<double>> spheres;
  for (const Object& object : state.scene().objects)
    if (const auto* sphere = std::get_if<Sphere<double>>(&object.shape)) spheres.push_back(*sphere);
  REQUIRE(spheres.size() == 4);
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j)
      CHECK(length(spheres[i].centre - spheres[j].centre) > spheres[i].radius + spheres[j].radius);
}

TEST_CASE("an edit keeps the place in the walk") {
  State state = classic_state();
  update(state, action::JumpToCell{9});
  update(state, action::Step{true, Grain::line});
  Material material = state.scene().objects[0].material;
  material.reflection = Rgbd(0.0);
  update(state, action::SetMaterial{0, material});
  CHECK(current_cell(state) == 9);
  CHECK(state.walk.timeline->just_run(state.walk.position)->line == Line::form_primary_ray);
  update(state, action::Jump{1 << 20});
  update(state, action::Undo{});
  CHECK(state.walk.position == state.walk.timeline->steps());
}

TEST_CASE("an edit keeps the place in what is done before the first pixel") {
  for (const char* name : {"caustic", "radiosity"}) {
    State state = classic_state();
    update(state, action::Open{std::string(RAYWALK_SOURCE_DIR "/scenes/") + name + ".toml"});
    const int whole = state.walk.timeline->steps();
    for (const int position : {1, 10, state.walk.timeline->pixels().front().begun_at - 1}) {
      update(state, action::Jump{position});
      const Line line = state.walk.timeline->just_run(position)->line;
      Material material = state.scene().objects[0].material;
      material.ambient += Rgbd(0.125);
      update(state, action::SetMaterial{0, material});
      CAPTURE(name, position, state.walk.position, whole);
      CHECK(state.walk.timeline->current_pixel(state.walk.position) == -1);
      CHECK(state.walk.timeline->just_run(state.walk.position)->line == line);
    }
  }
}

TEST_CASE("history stays within its bounds") {
  State state = busy_state();
  for (std::size_t i = 0; i < undo_entries + 40; ++i) {
    Material material;
    material.shininess = static_cast<double>(i);
    update(state, action::SetMaterial{0, material});
  }
  CHECK(state.document.undo.size() == undo_entries);
}

TEST_CASE("a deep scene of two facing mirrors is recorded as far as it is long, a bush of glass only so deep") {
  Scene scene = busy_scene();
  scene.limits = {1000, 0};
  State state = state_of(scene);
  CHECK(state.walk.timeline->steps() < 1000000);
  CHECK(broken_promise(state) == "");
  Material glass = scene.objects[1].material;
  for (Object& object : scene.objects)
    if (!std::holds_alternative<Plane<double>>(object.shape)) object.material = glass;
  scene.objects.push_back({"Glass 2", Sphere<double>{Vec3d(1, -3, 0), 1.2}, glass});
  State bush = state_of(scene);
  CHECK(bush.walk.timeline->steps() < 4000000);
  CHECK(broken_promise(bush) == "");
}

TEST_CASE("undo and redo keep the same thing selected, wherever it then stands") {
  State state = busy_state();
  const auto selected = [&] {
    const Target& target = state.plan.selected;
    const auto index = static_cast<std::size_t>(target.index);
    if (target.kind == TargetKind::light) return state.scene().lights[index].name;
    return target.kind == TargetKind::nothing ? std::string() : state.scene().objects[index].name;
  };
  SECTION("an object after one that was removed") {
    update(state, action::Select{{TargetKind::object, 0}});
    update(state, action::RemoveSelected{});
    update(state, action::Select{{TargetKind::object, 1}});
    REQUIRE(selected() == "Notch");
    update(state, action::Undo{});
    CHECK(selected() == "Notch");
    update(state, action::Redo{});
    CHECK(selected() == "Notch");
  }
  SECTION("a light") {
    update(state, action::Select{{TargetKind::light, 0}});
    update(state, action::RemoveSelected{});
    update(state, action::Select{{TargetKind::light, 0}});
    update(state, action::Undo{});
    CHECK(selected() == "Sun");
  }
  SECTION("one that is renamed") {
    update(state, action::Rename{{TargetKind::object, 1}, "Ball"});
    update(state, action::Select{{TargetKind::object, 1}});
    update(state, action::Undo{});
    CHECK(selected() == "Glass");
  }
  SECTION("nothing, once it is gone") {
    update(state, action::Select{{TargetKind::object, 0}});
    update(state, action::RemoveSelected{});
    update(state, action::Undo{});
    update(state, action::Select{{TargetKind::object, 0}});
    update(state, action::Redo{});
    CHECK(selected().empty());
  }
  SECTION("a corner, or its polygon where that has other corners") {
    update(state, action::InsertCorner{2, 0, Vec2d(3.3, -2.1)});
    update(state, action::Select{{TargetKind::corner, 2, 3}});
    update(state, action::Nudge{{1, 0}});
    update(state, action::Undo{});
    CHECK(state.plan.selected == Target{TargetKind::corner, 2, 3});
    update(state, action::Undo{});
    CHECK(state.plan.selected == Target{TargetKind::object, 2});
  }
  CHECK(broken_promise(state) == "");
}

TEST_CASE("a key that is held down moves a thing with one undo entry, and the next thing with another") {
  State state = busy_state();
  const Scene before = state.scene();
  for (const int object : {0, 1}) {
    update(state, action::Select{{TargetKind::object, object}});
    for (int i = 0; i < 60; ++i) update(state, action::Nudge{{1, 0}, false, i > 0 || object > 0});
  }
  CHECK(state.document.undo.size() == 2);
  update(state, action::Undo{});
  update(state, action::Undo{});
  CHECK(state.scene() == before);
}

TEST_CASE("undo takes back what the pointer was on, which may have moved away") {
  State state = busy_state();
  update(state, action::Select{{TargetKind::object, 0}});
  update(state, action::Nudge{{1, 0}});
  update(state, action::PointerMoved{pixels_of(state, {TargetKind::object, 0})});
  REQUIRE(state.plan.hovered.kind != TargetKind::nothing);
  update(state, action::Undo{});
  CHECK(state.plan.hovered == Target{});
}
