// The Structure tab by mouse and keys.

#include "view/structure/structure.h"
#include "gui/bench.h"
#include "gui/command.h"
#include "inspect/search_walk.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State at_a_ray() {
  State state = classic();
  update(state, action::SetMode{Mode::trace});
  update(state, action::JumpToCell{9});
  update(state, action::Step{true});
  return state;
}

}  // namespace

TEST_CASE("the structures leave code and plan their room, and have the plan's on request") {
  Bench bench(at_a_ray());
  bench.frames(2);
  const Rect plan = bench.rect("plan");
  bench.click("tab-structure");
  REQUIRE(bench.state.appearance.tab == StructureRoom::tab);
  bench.frames(2);
  CHECK(bench.rect("plan") == plan);
  CHECK(bench.has("code"));
  CHECK(bench.has("structure/sentence"));
  CHECK(bench.has("step"));  // the walk goes on beside it
  CHECK(bench.rect("structure-next").bottom() <= 720);
  bench.key("X");
  CHECK(bench.rect("tabs") == plan);
  CHECK(bench.has("code"));
  for (const AcceleratorKind kind : watched_accelerators) {
    const Rect row = bench.rect("structure/" + std::string(name_of(kind)));
    CHECK(row.bottom() <= 720);
    CHECK(row.right() <= 1280);
  }
  CHECK(bench.rect("structure/summary").bottom() <= 720);
}

TEST_CASE("a search is stepped by keys, buttons and the slider") {
  Bench bench(at_a_ray());
  bench.key("Ctrl+T");
  REQUIRE(bench.state.appearance.tab == StructureRoom::tab);
  bench.frames(2);
  const int last = structure_steps(bench.state);
  REQUIRE(last > 2);
  bench.click("structure-next");
  CHECK(structure_step(bench.state) == 1);
  bench.key("Ctrl+J");
  CHECK(structure_step(bench.state) == 2);
  bench.click("structure-back");
  CHECK(structure_step(bench.state) == 1);
  bench.key("Ctrl+K");
  CHECK(structure_step(bench.state) == 0);
  bench.forget();
  bench.key("Ctrl+K");  // there is no step before the first
  CHECK(bench.last<action::GoInStructure>() == nullptr);
  bench.key("Ctrl+Shift+J");
  CHECK(structure_step(bench.state) == last);
  bench.key("Ctrl+Shift+K");
  CHECK(structure_step(bench.state) == 0);
  bench.drag("structure/slider", 400, 0);
  CHECK(structure_step(bench.state) == last);
  bench.key("Space");  // STEP still steps the walk
  CHECK(bench.last<action::Step>() != nullptr);
}

TEST_CASE("the structure and the page are chosen by mouse and keys") {
  Bench bench(at_a_ray());
  update(bench.state, action::SetTab{StructureRoom::tab});
  bench.frames(2);
  bench.key("X");  // the small pane scrolls
  bench.click("structure/octree");
  CHECK(bench.state.structure.kind == AcceleratorKind::octree);
  bench.key("Ctrl+U");
  CHECK(bench.state.structure.kind == AcceleratorKind::kdtree);
  bench.click("structure/build");
  CHECK(bench.state.structure.page == StructurePage::build);
  bench.frames(2);
  bench.click("structure-next");
  CHECK(bench.state.structure.build_step == 1);
  bench.key("Ctrl+I");
  CHECK(bench.state.structure.page == StructurePage::search);
  // Elsewhere these keys are silent.
  update(bench.state, action::SetTab{TreeRoom::tab});
  bench.forget();
  bench.key("Ctrl+U");
  bench.key("Ctrl+I");
  bench.key("Ctrl+J");
  CHECK(bench.last<action::ChooseStructure>() == nullptr);
  CHECK(bench.last<action::ShowStructurePage>() == nullptr);
  CHECK(bench.last<action::GoInStructure>() == nullptr);
}

TEST_CASE("before a ray is formed the tab says what to do") {
  Bench bench;
  update(bench.state, action::SetTab{StructureRoom::tab});
  bench.frames(3);
  CHECK(bench.has("structure/sentence"));
  CHECK_FALSE(bench.has("structure-next"));
  CHECK_FALSE(bench.has("structure/bvh"));
}
