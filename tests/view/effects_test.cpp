// Switches for effects: at once in the plan and in the picture, and what they say of rays.
#include <algorithm>

#include "lesson_state.h"
#include "support/catch.h"
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
  for (std::size_t i = 0; i < switched_effects.size(); ++i) {
    const Effect effect = switched_effects[i];
    INFO(name_of(effect));
    const int all = formed(state), brings = state.effects.rays->brought[i];
    const auto revision = state.picture.revision;
    CHECK(state.effects.rays->all == all);
    CHECK(brings > 0);
    update(state, action::SwitchEffect{effect, false});
    CHECK(formed(state) == all - brings);
    CHECK(state.effects.rays->brought[i] == brings);
    CHECK(state.picture.revision > revision);
    EffectSwitches seen = pictured_scene(state)->render.switches;
    CHECK_FALSE(switch_of(seen, effect));
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
