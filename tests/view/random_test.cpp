// Any sequence of actions keeps the promises of view/state.h.

#include "random_actions.h"
#include "view/action_text.h"

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("thousands of random actions of every kind keep every promise, and undo leads all the way back") {
  const unsigned seed = GENERATE(1u, 2u, 3u, 4u);
  if (left_to_all(seed, 4)) return;
  const TemporaryFolder folder;
  RandomActions actions(seed, folder.path());
  State state = busy_state();
  state.document.state_dir = folder.file("state");
  state.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  std::vector<std::string> latest;
  std::array<int, action_kinds> applied{};
  /// What undo leads back to.
  struct Moment {
    Scene scene;
    Ink ink;
    bool operator==(const Moment&) const = default;
  };
  const auto now = [&] { return Moment{state.scene(), state.document.contents.ink}; };
  Moment oldest = now();

  const auto apply = [&](const Action& action) {
    latest.push_back(write_action(action));
    if (!state.document.question && state.document.prompt == PathPrompt::none) ++applied[action.kind()];
    update(state, action);
    if (state.document.quit) {
      // The window would have closed; nothing else closes it.
      const bool may_quit = action.is<action::Quit>() || state.document.prompt == PathPrompt::none;
      CHECK(may_quit);
      state.document.quit = false;
    }
    const bool between = state.bugs.hunt || state.plan.drag;  // what is dragged is in the scene before it can be undone
    if (state.document.undo.empty() && state.document.redo.empty() && !between) oldest = now();
    const std::string broken = broken_promise(state);
    if (broken.empty()) return;
    std::string way;
    for (std::size_t j = latest.size() > 12 ? latest.size() - 12 : 0; j < latest.size(); ++j) way += latest[j] + "\n";
    INFO("seed " << seed << ", action " << latest.size() << ", after\n" << way);
    REQUIRE(broken == "");
  };
  const auto settle = [&] {
    apply(action::AnswerQuestion{action::Answer::cancel});
    CHECK_FALSE(state.document.question);
  };
  for (int i = 0; i < rounds(2500); ++i) {
    const Action action = actions.next(state);
    // Too many objects make the rest of the test slow, not better.
    if (action.is<action::AddObject>() && state.scene().objects.size() > 8) continue;
    if (i % 500 == 250) apply(action::SetLightWays{i % 1000 < 500 ? Subsurface::dipole : Subsurface::walk, false});
    apply(action);
    // Work that is discarded cannot be undone.
    if (state.document.question && actions.whole(0, 9) > 0) settle();
  }
  // An eighth of them under sanitizers is not enough to meet each kind.
  for (std::size_t kind = 0; kind < action_kinds && !sanitized; ++kind) {
    INFO("action " << kind);
    CHECK(applied[kind] > 0);
  }

  // Undo all the way and redo all the way: the same scenes, and the same ink, in the opposite order.
  if (state.document.question) settle();
  for (const Action& action :
       {Action(action::CancelPrompt{}), Action(action::CancelDrag{}), Action(action::LeaveHunt{})})
    apply(action);
  for (int i = 0; i < rounds(80); ++i) apply(actions.next_edit(state));
  if (state.ink.begun) apply(action::LeaveInk{});  // undo would only drop it
  std::vector<Moment> moments{now()};
  while (!state.document.undo.empty()) {
    update(state, action::Undo{});
    CHECK(now() != moments.back());
    moments.push_back(now());
    REQUIRE(broken_promise(state) == "");
  }
  REQUIRE(moments.size() > (sanitized ? 2 : 20));
  if (moments.size() <= undo_entries) CHECK(moments.back() == oldest);
  while (!state.document.redo.empty() && moments.size() > 1) {
    moments.pop_back();
    update(state, action::Redo{});
    REQUIRE(now() == moments.back());
  }
}
