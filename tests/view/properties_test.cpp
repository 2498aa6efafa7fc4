// The keys of a thing as texts: all that a form has fields for, set by a line, refused as a scene file is.

#include "view/document/properties.h"

#include "io/scene_file.h"
#include "view/action_text.h"
#include "view/state.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "support/catch.h"
#include "support/languages.h"
#include "view/fixtures.h"

using namespace raywalk;
using test::contains;

namespace {

Target object(int index) { return {TargetKind::object, index, -1}; }
const Target the_eye{TargetKind::eye, -1, -1};

const PropertyText* find(const std::vector<PropertyText>& keys, std::string_view key) {
  const auto at = std::find_if(keys.begin(), keys.end(), [&](const PropertyText& each) { return each.key == key; });
  return at == keys.end() ? nullptr : &*at;
}

std::string value_of(const State& state, const Target& target, std::string_view key) {
  const std::vector<PropertyText> keys = property_texts(state, target);
  const PropertyText* found = find(keys, key);
  return found == nullptr ? "there is none" : found->value;
}

State classic_with_words() {
  State state = test::classic_state();
  state.appearance.language = test::in_english;
  return state;
}

/// Of the scenes that come with Raywalk.
std::vector<State> shipped_states() {
  std::vector<State> states;
  for (const auto& entry : std::filesystem::directory_iterator(RAYWALK_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    auto document = read_scene(entry.path().string());
    REQUIRE(document);
    states.push_back(test::state_of(document->scene));
    states.back().document.contents.path = entry.path().string();
    states.back().appearance.language = test::in_english;
  }
  return states;
}

}  // namespace

TEST_CASE("a key that is given its own value leaves the scene as it is, in every shipped scene") {
  int tried = 0;
  std::set<std::string> kinds;
  for (State& state : shipped_states()) {
    CAPTURE(state.scene().title);
    std::vector<Target> targets{the_eye};
    for (int i = 0; i < static_cast<int>(state.scene().objects.size()); ++i) targets.push_back(object(i));
    for (int i = 0; i < static_cast<int>(state.scene().lights.size()); ++i)
      targets.push_back({TargetKind::light, i, -1});
    if (targets.size() > 6) targets.resize(6);
    for (const Target& target : targets) {
      std::set<std::string> names;
      const std::vector<PropertyText> keys = property_texts(state, target);
      // Of an instance all but its name is elsewhere.
      CHECK(((keys.size() == 1) ==
             (target.kind == TargetKind::object &&
              std::holds_alternative<Instance>(state.scene().objects[static_cast<std::size_t>(target.index)].shape))));
      for (const PropertyText& each : keys) {
        CAPTURE(name_of(target.kind), target.index, each.key, each.value);
        CHECK(names.insert(each.key).second);
        CHECK_FALSE(each.label.empty());
        kinds.insert(each.key);
        // Printed digits are fewer than those of some numbers.
        const auto edit = edit_of_property(state, target, each.key, each.value);
        if (!edit) {
          CHECK(edit.error().text() == "");
          continue;
        }
        State next = state;
        update(next, action::SetKey{target, each.key + " " + each.value});
        CHECK_FALSE(next.document.notice.has_value());
        const std::vector<PropertyText> after = property_texts(next, target);
        REQUIRE(after.size() == keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) {
          CHECK(after[i].key == keys[i].key);
          CHECK(after[i].value == keys[i].value);
        }
        ++tried;
      }
    }
  }
  CHECK(tried > 1500);
  for (const char* kind : {"radius", "centre", "corners.1", "material.diffuse", "material.dielectric",
                           "material.shadow", "material.checker", "position", "strength", "eye", "screen.cells",
                           "scene.background", "scene.ambient", "limits.depth"})
    CHECK(kinds.count(kind) == 1);
}

TEST_CASE("keys are set by a line of a demo, undone, and followed by the walk") {
  State state = classic_with_words();
  const auto act = [&](const std::string& line) {
    const Result<Action> action = parse_action(line);
    REQUIRE(action);
    CHECK(write_action(*action) == line);
    update(state, *action);
  };
  const Scene before = state.scene();
  act("set object 0 -1 radius 0.5");
  CHECK_FALSE(state.document.notice);
  CHECK(std::get<Sphere<double>>(state.scene().objects[0].shape).radius == 0.5);
  act("set object 0 -1 material.diffuse 0.25");
  CHECK(state.scene().objects[0].material.diffuse == Rgbd(0.25));
  act("set object 0 -1 material.diffuse 0.25 0,5 1");
  CHECK(state.scene().objects[0].material.diffuse == Rgbd(0.25, 0.5, 1));
  CHECK(value_of(state, object(0), "material.diffuse") == "0.25 0.5 1");
  act("set object 0 -1 material.dielectric on");
  CHECK(state.scene().objects[0].material.dielectric);
  act("set object 0 -1 material.checker on");
  CHECK(state.scene().objects[0].material.checker);
  act("set object 0 -1 material.checker off");
  CHECK_FALSE(state.scene().objects[0].material.checker);
  act("set light 0 -1 strength 2");
  CHECK(state.scene().lights[0].strength == Rgbd(2));
  act("set eye -1 -1 limits.depth 3");
  CHECK(state.scene().limits.depth == 3);
  act("set eye -1 -1 scene.background 0.1 0.2 0.3");
  CHECK(state.scene().background == Rgbd(0.1, 0.2, 0.3));
  act("set eye -1 -1 screen.width_set on");
  CHECK(state.scene().camera.screen.width == Approx(before.camera.screen_width()));
  CHECK_FALSE(state.scene().camera.fov);
  act("set eye -1 -1 screen.width 3");
  CHECK(state.scene().camera.screen.width == 3);
  act("set eye -1 -1 screen.width_set off");
  CHECK_FALSE(state.scene().camera.screen.width);
  CHECK(state.scene().camera.fov);
  act("set object 0 -1 name A ball");
  CHECK(state.scene().objects[0].name == "A ball");
  CHECK_FALSE(state.document.notice);
  for (int i = 0; i < 13; ++i) update(state, action::Undo{});
  CHECK(state.scene() == before);
  CHECK(property_texts(state, object(0)).size() == property_texts(classic_with_words(), object(0)).size());
}

TEST_CASE("what no key takes is refused with its reason, and changes nothing") {
  State state = classic_with_words();
  const Scene before = state.scene();
  const auto refused = [&](const Target& target, const std::string& setting, const std::string& why) {
    CAPTURE(setting);
    state.document.notice.reset();
    update(state, action::SetKey{target, setting});
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->kind == Notice::Kind::error);
    CHECK_THAT(state.document.notice->text, contains(why));
    CHECK(state.scene() == before);
  };
  refused(object(0), "radius -1", "expected a number above 0");
  refused(object(0), "radius", "expected a number above 0");
  refused(object(0), "radius 1 2", "expected a number above 0");
  refused(object(0), "radius nan", "expected numbers");
  refused(object(0), "radius 1e400", "expected numbers");
  refused(object(0), "centre 1", "expected [x, y]");
  refused(object(0), "raduis 1", "there is no key 'raduis' here");
  refused(object(0), "raduis 1", "one of: name, centre, radius");
  refused(object(0), "material.dielectric maybe", "expected \"on\" or \"off\"");
  refused(object(0), "material.shadow none of it", "expected \"");
  refused(object(0), "material.ior 0", "expected");
  refused(object(0), "material.texture nowhere.png", "nowhere.png");
  refused(the_eye, "look_at " + value_of(state, the_eye, "eye"), "eye");
  refused(the_eye, "limits.depth 2.5", "expected a whole number");
  refused(the_eye, "screen.cells 0", "expected a whole number");
  // What is not there is not changed.
  state.document.notice.reset();
  update(state, action::SetKey{object(99), "radius 1"});
  CHECK(state.scene() == before);
}
