// Switches for effects: at once in the plan and in the picture, and what they say of rays.
#include <algorithm>

#include "fixtures.h"
#include "io/scene_file.h"
#include "lesson_state.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

int formed(const State& state) {
  const auto& rays = state.walk.timeline->rays();
  return static_cast<int>(std::count_if(rays.begin(), rays.end(), [](const RayRecord& ray) { return ray.formed; }));
}

}  // namespace

TEST_CASE("a switch leaves an effect out of the walk and of the picture, and the scene as it is") {
  State state = classic_state();
  update(state, action::ShowEffects{true});
  const Scene scene = state.scene();
  for (const Effect effect : {Effect::shadows, Effect::reflection, Effect::refraction}) {
    INFO(name_of(effect));
    const std::size_t i = number_of(effect);
    REQUIRE(state.effects.rays->offered[i]);
    const int all = formed(state), brings = state.effects.rays->brought[i];
    const auto revision = state.picture.revision;
    CHECK(state.effects.rays->all == all);
    CHECK(brings > 0);
    update(state, action::SwitchEffect{effect, false});
    CHECK(formed(state) == all - brings);
    CHECK(state.effects.rays->brought[i] == brings);
    CHECK(state.picture.revision > revision);
    const EffectSwitches seen = pictured_scene(state)->render.switches;
    CHECK_FALSE((effect == Effect::shadows      ? seen.shadows
                 : effect == Effect::reflection ? seen.reflection
                                                : seen.refraction));
    CHECK(state.scene() == scene);
    CHECK_FALSE(state.document.dirty);
    update(state, action::SwitchEffect{effect, true});
    CHECK(formed(state) == all);
  }
}

TEST_CASE("the depth is limited in plan and picture, and what the deepest level brings is counted") {
  State state = classic_state();
  update(state, action::ShowEffects{true});
  const int own = state.scene().limits.depth;
  for (int depth = own - 1; depth >= 1; --depth) {
    const int all = formed(state), brings = state.effects.rays->by_depth;
    update(state, action::LimitDepth{depth});
    CHECK(formed(state) == all - brings);
    CHECK(pictured_scene(state)->limits.depth == depth);
  }
  update(state, action::LimitDepth{-4});
  CHECK(walked_scene(state)->limits.depth == 1);
  update(state, action::LimitDepth{own});
  CHECK_FALSE(state.effects.leaves_out());
}

TEST_CASE("hiding the switches, another scene and a step of a lesson bring all effects back") {
  State state = classic_state();
  const int all = formed(state);
  update(state, action::SwitchEffect{Effect::shadows, false});
  CHECK(state.effects.shown);
  update(state, action::ShowEffects{false});
  CHECK(formed(state) == all);
  State student = state_with_lessons();
  update(student, action::OpenLesson{"04-reflection"});
  const int steps = student.walk.timeline->steps();
  update(student, action::SwitchEffect{Effect::reflection, false});
  REQUIRE(student.walk.timeline->steps() != steps);
  update(student, action::GoToLessonStep{0});
  CHECK_FALSE(student.effects.leaves_out());
  CHECK(student.walk.timeline->steps() == student.lessons.at()->walk->timeline.steps());
}

TEST_CASE("rays are counted when a drag ends, not during it") {
  State state = classic_state();
  update(state, action::ShowEffects{true});
  const auto before = state.effects.rays;
  const Vec2d from = pixels_of(state, {TargetKind::eye});
  update(state, action::PointerMoved{from});
  update(state, action::PointerPressed{from});
  update(state, action::PointerMoved{from + Vec2d(20, 10)});
  CHECK(state.effects.rays == before);
  update(state, action::PointerReleased{from + Vec2d(20, 10), {}});
  CHECK(state.effects.rays->of == state.walk.timeline);
}

TEST_CASE("every effect that a scene uses is offered, and left out of the walked and the pictured scene alike") {
  EffectSet tried;
  for (const std::string name :
       {"distributed", "everything", "gloss", "milk", "maps", "metals", "filters", "radiosity"}) {
    const auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/" + name + ".toml");
    REQUIRE(read);
    State state = state_of(read->scene);
    update(state, action::SetMode{Mode::trace});
    ImageSettings settings = state.picture.settings;
    settings.samples = 4;
    update(state, action::SetImageSettings{settings});
    update(state, action::ShowEffects{true});
    const Effects used = effects_of(*walked_scene(state), samples_seen(state, settings.samples));
    const Scene scene = state.scene();
    for (const Effect effect : values_of<Effect>) {
      CAPTURE(name, name_of(effect));
      CHECK(state.effects.rays->offered[number_of(effect)] == used.used(effect));
      const bool can = state.effects.rays->can[number_of(effect)];
      const auto revision = state.picture.revision;
      update(state, action::SwitchEffect{effect, false});
      CHECK(state.effects.leaves_out(effect) == can);
      CHECK((state.picture.revision > revision) == can);
      if (!can) continue;
      tried.set(number_of(effect));
      // The tracer's own switches leave effects out that the scene still has.
      if (effect != Effect::shadows && effect != Effect::reflection)
        for (const SceneSeen& seen : {walked_scene(state), pictured_scene(state)})
          CHECK_FALSE(effects_of(*seen, samples_seen(state, settings.samples)).used(effect));
      CHECK(state.effects.rays->offered[number_of(effect)]);
      CHECK(state.scene() == scene);
      update(state, action::SwitchEffect{effect, true});
      CHECK_FALSE(state.effects.leaves_out());
    }
  }
  CHECK(tried.count() > 11);
}

TEST_CASE("a beam is as wide as its pixel: that cannot be left out, nor what the scene does not use") {
  const auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/beams.toml");
  REQUIRE(read);
  State state = state_of(read->scene);
  update(state, action::SetMode{Mode::trace});
  for (const Effect effect : {Effect::antialiasing, Effect::sky}) {
    CHECK_FALSE(can_switch(state, effect));
    update(state, action::SwitchEffect{effect, false});
    CHECK_FALSE(state.effects.leaves_out());
  }
  CHECK(state.effects.rays->offered[number_of(Effect::antialiasing)]);
  CHECK_FALSE(state.effects.rays->offered[number_of(Effect::sky)]);
}

TEST_CASE("an effect that brings no ray says so in every language, also where nothing is counted like one thing") {
  for (const Language language : all_languages())
    for (const std::string_view id : {"effects.rays", "effects.all_rays"}) {
      CAPTURE(language.code(), id);
      CHECK_THAT(fill(id, language, {{"count", 0}}), contains("0"));
    }
}
