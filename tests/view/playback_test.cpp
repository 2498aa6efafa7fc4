#include "fixtures.h"
#include "view/stack/stack_panel.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/code_panel.h"
#include "view/walk/status.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Everything that the position decides, as text: two states that look the same at a position are the same here.
std::string picture_of(const State& state) {
  std::string picture = sentence(state) + "\n" + status_line(state);
  for (const CodeBox& box : code_panel(state).boxes)
    for (const CodeRow& row : box.rows) picture += row.just_run ? "#" : row.next ? ">" : ".";
  for (const TreeNode& node : tree_panel(state).nodes) picture += node.symbol + node.label + node.throughput;
  for (const StackRow& row : stack_panel(state).rows) picture += row.title + row.waiting;
  for (const DisplayItem& item : plan_view(state))
    if (const auto* line = std::get_if<LineItem>(&item.shape))
      picture += number_text(line->from.x, state.appearance.language) +
                 number_text(line->to.x, state.appearance.language) +
                 number_text(line->to.y, state.appearance.language);
  return picture;
}

}  // namespace

TEST_CASE("STEP runs one line and BACK takes it back") {
  State state = classic_state();
  CHECK(state.walk.position == 0);
  update(state, action::Step{true, Grain::line});
  CHECK(state.walk.mode == Mode::trace);
  CHECK(state.walk.position == 1);
  update(state, action::Step{true, {}});
  CHECK(state.walk.position == 2);
  update(state, action::Step{false, {}});
  update(state, action::Step{false, {}});
  CHECK(state.walk.position == 0);
  update(state, action::Step{false, {}});
  CHECK(state.walk.position == 0);
}

TEST_CASE("k steps forward and k back is the identity") {
  for (const auto& path : shipped_scenes()) {
    INFO(path);
    State state = make_state(read_document(path));
    const int steps = state.walk.timeline->steps();
    for (const int start : {0, 1, steps / 3, steps / 2}) {
      update(state, action::Jump{start});
      const std::string before = picture_of(state);
      const int k = std::min(57, steps - start);
      for (int i = 0; i < k; ++i) update(state, action::Step{true, Grain::line});
      CHECK(state.walk.position == start + k);
      for (int i = 0; i < k; ++i) update(state, action::Step{false, Grain::line});
      CHECK(state.walk.position == start);
      CHECK(picture_of(state) == before);
    }
  }
}

TEST_CASE("the state at a position does not depend on the way there") {
  State walked = busy_state(), jumped = busy_state();
  const int steps = walked.walk.timeline->steps();
  REQUIRE(steps > 100);
  for (int position = 1; position <= steps; ++position) {
    update(walked, action::Step{true, Grain::line});
    if (position % 23 != 0 && position != steps) continue;
    // From the far end, through the middle, to the place.
    update(jumped, action::Jump{steps});
    update(jumped, action::Jump{steps / 2});
    update(jumped, action::Jump{position});
    REQUIRE(walked.walk.position == position);
    CHECK(picture_of(jumped) == picture_of(walked));
  }
}

TEST_CASE("jumps are clamped to the timeline") {
  State state = classic_state();
  update(state, action::Jump{1 << 30});
  CHECK(state.walk.position == state.walk.timeline->steps());
  update(state, action::Jump{-(1 << 30)});
  CHECK(state.walk.position == 0);
}

TEST_CASE("each grain reaches the end forward and the start backward") {
  for (const Grain grain : {Grain::line, Grain::ray, Grain::pixel}) {
    State state = busy_state();
    update(state, action::SetGrain{grain});
    CHECK(state.walk.grain == grain);
    int forward = 0;
    for (; state.walk.position < state.walk.timeline->steps() && forward < 100000; ++forward) {
      const int before = state.walk.position;
      update(state, action::Step{});
      REQUIRE(state.walk.position > before);
    }
    if (grain == Grain::pixel) CHECK(forward == state.scene().camera.screen.cells);
    if (grain == Grain::ray) CHECK(forward >= static_cast<int>(state.walk.timeline->rays().size()));
    for (int i = 0; state.walk.position > 0 && i < 100000; ++i) {
      const int before = state.walk.position;
      update(state, action::Step{false, {}});
      REQUIRE(state.walk.position < before);
    }
    CHECK(state.walk.position == 0);
  }
}

TEST_CASE("a step of grain pixel ends with the pixel's final shade") {
  State state = classic_state();
  for (int cell = 0; cell < state.scene().camera.screen.cells; ++cell) {
    update(state, action::Step{true, Grain::pixel});
    CHECK(state.walk.timeline->just_run(state.walk.position)->line == Line::put_final_shade);
    CHECK(current_cell(state) == cell);
  }
}

TEST_CASE("AUTO by ticks equals steps, however the time is cut") {
  for (const double tick : {0.25, 0.1, 0.013}) {
    State state = classic_state();
    update(state, action::SetSpeed{8});
    update(state, action::PlayPause{});
    REQUIRE(state.walk.playing);
    CHECK(state.walk.mode == Mode::trace);
    const int ticks = static_cast<int>(5 / tick);
    for (int i = 0; i < ticks; ++i) update(state, action::Tick{tick});
    // 8 lines a second for 5 seconds; sums of ticks may round one line away.
    CHECK(state.walk.position >= 39);
    CHECK(state.walk.position <= 40);
    State stepped = classic_state();
    for (int i = 0; i < state.walk.position; ++i) update(stepped, action::Step{true, Grain::line});
    CHECK(picture_of(stepped) == picture_of(state));
  }
}

TEST_CASE("AUTO pauses at once, changes speed while it runs, and stops by itself at the end") {
  State state = classic_state();
  update(state, action::SetSpeed{10});
  update(state, action::PlayPause{});
  update(state, action::Tick{1});
  CHECK(state.walk.position == 10);
  update(state, action::SetSpeed{100});
  update(state, action::Tick{1});
  CHECK(state.walk.position == 110);
  update(state, action::PlayPause{});
  CHECK_FALSE(state.walk.playing);
  update(state, action::Tick{1});
  CHECK(state.walk.position == 110);
  update(state, action::PlayPause{});
  for (int i = 0; i < 100 && state.walk.playing; ++i) update(state, action::Tick{1});
  CHECK(state.walk.position == state.walk.timeline->steps());
  CHECK_FALSE(state.walk.playing);
  update(state, action::PlayPause{});
  CHECK_FALSE(state.walk.playing);
}

TEST_CASE("AUTO walks in the chosen grain") {
  State state = classic_state();
  update(state, action::SetGrain{Grain::pixel});
  update(state, action::SetSpeed{2});
  update(state, action::PlayPause{});
  update(state, action::Tick{1});
  CHECK(current_cell(state) == 1);
  CHECK(state.walk.timeline->just_run(state.walk.position)->line == Line::put_final_shade);
}

TEST_CASE("a step by hand and CLEAR end AUTO") {
  State state = classic_state();
  update(state, action::PlayPause{});
  update(state, action::Step{});
  CHECK_FALSE(state.walk.playing);
  update(state, action::PlayPause{});
  update(state, action::Tick{1});
  update(state, action::Clear{});
  CHECK_FALSE(state.walk.playing);
  CHECK(state.walk.position == 0);
  CHECK(state.walk.timeline->rays_at(state.walk.position).empty());
}

TEST_CASE("the speed stays within its bounds") {
  State state = classic_state();
  update(state, action::SetSpeed{1e9});
  CHECK(state.walk.lines_per_second == max_speed);
  update(state, action::SetSpeed{-1});
  CHECK(state.walk.lines_per_second == min_speed);
  update(state, action::SetSpeed{std::nan("")});
  CHECK(state.walk.lines_per_second == min_speed);
}

TEST_CASE("going to a ray shows it just formed, going to a cell its first line") {
  State state = busy_state();
  for (std::size_t i = 0; i < state.walk.timeline->rays().size(); i += 7) {
    const int ray = static_cast<int>(i);
    update(state, action::JumpToRay{ray});
    CHECK(state.walk.timeline->current_ray(state.walk.position) == ray);
    CHECK(static_cast<int>(state.walk.timeline->rays_at(state.walk.position).size()) == ray + 1);
  }
  update(state, action::JumpToCell{7});
  CHECK(current_cell(state) == 7);
  CHECK(state.walk.timeline->just_run(state.walk.position)->line == Line::for_each_pixel);
  const int before = state.walk.position;
  update(state, action::JumpToCell{99});
  update(state, action::JumpToRay{-1});
  CHECK(state.walk.position == before);
}

TEST_CASE("running to a line stops each time it has run") {
  State state = busy_state();
  int found = 0;
  while (state.walk.position < state.walk.timeline->steps()) {
    update(state, action::RunToLine{Line::compute_rtnshade});
    if (state.walk.timeline->just_run(state.walk.position)->line == Line::compute_rtnshade) ++found;
  }
  CHECK(found == static_cast<int>(state.walk.timeline->frames().size()));
}
