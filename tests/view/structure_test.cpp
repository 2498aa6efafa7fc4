// The Structure tab without a window: its steps, its words and its boxes in the plan.
#include "view/structure/structure.h"

#include <algorithm>
#include <set>

#include "fixtures.h"
#include "inspect/search_walk.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/space/lines_view.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State many_circles() {
  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/many_circles.toml"));
  update(state, action::ResizePlan{{800, 600}});
  return state;
}

// At the primary ray of a cell, with the tab open.
State searching(State state, int cell = 10) {
  update(state, action::SetTab{StructureRoom::tab});
  update(state, action::JumpToCell{cell});
  update(state, action::Step{true});
  REQUIRE(shows_structure(state));
  return state;
}

int dashed_lines(const DisplayList& list) {
  return static_cast<int>(std::count_if(list.begin(), list.end(), [](const DisplayItem& item) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    return line != nullptr && line->stroke.dash == DashPattern{{7, 4}, 2};
  }));
}

}  // namespace

TEST_CASE("the tab opens in Trace mode, and tells what to do until a ray is formed") {
  State state = many_circles();
  CHECK(state.walk.mode == Mode::move);
  update(state, action::SetTab{StructureRoom::tab});
  CHECK(state.walk.mode == Mode::trace);
  CHECK(shows_structure(state));
  CHECK(structure_steps(state) == 0);
  CHECK(structure_panel(state).sentence == text("structure.no_ray", in_english));
  const State at_ray = searching(state);
  CHECK(structure_steps(at_ray) > 5);
  CHECK(structure_panel(at_ray).sentence == text("structure.not_begun", in_english));
  CHECK(structure_panel(at_ray).rows.size() == watched_count);
  State left = at_ray;
  update(left, action::SetTab{TreeRoom::tab});
  CHECK(left.structure.walks == nullptr);
  CHECK(structure_steps(left) == 0);
}

TEST_CASE("steps stay within the search, and go back to where they came from") {
  State state = searching(many_circles());
  const int last = structure_steps(state);
  update(state, action::GoInStructure{-3});
  CHECK(structure_step(state) == 0);
  update(state, action::GoInStructure{last + 5});
  CHECK(structure_step(state) == last);
  const StructurePanel at_end = structure_panel(state);
  CHECK(at_end.counter == std::to_string(last) + " / " + std::to_string(last));
  update(state, action::GoInStructure{last - 1});
  update(state, action::GoInStructure{last});
  CHECK(structure_panel(state).sentence == at_end.sentence);

  // The end of one search leads to the end of the next, the middle to the start.
  update(state, action::ChooseStructure{AcceleratorKind::grid});
  CHECK(structure_step(state) == structure_steps(state));
  update(state, action::Step{true, Grain::ray});
  CHECK(structure_step(state) == structure_steps(state));
  update(state, action::GoInStructure{2});
  update(state, action::ChooseStructure{AcceleratorKind::kdtree});
  CHECK(structure_step(state) == 0);
  update(state, action::GoInStructure{2});
  update(state, action::Step{true, Grain::ray});
  CHECK(structure_step(state) == 0);

  // What is not stepped stands for the first.
  update(state, action::ChooseStructure{AcceleratorKind::ellipsoids});
  CHECK(state.structure.kind == AcceleratorKind::bvh);
}

TEST_CASE("the pages keep their own places") {
  State state = searching(many_circles());
  update(state, action::GoInStructure{3});
  update(state, action::ShowStructurePage{StructurePage::build});
  CHECK(structure_step(state) == 0);
  update(state, action::GoInStructure{5});
  update(state, action::ShowStructurePage{StructurePage::search});
  CHECK(structure_step(state) == 3);
  // Another ray begins a search anew, and leaves the build where it is.
  update(state, action::Step{true, Grain::ray});
  update(state, action::ShowStructurePage{StructurePage::build});
  CHECK(structure_step(state) == 5);
  // Another scene has another build.
  update(state, action::New{});
  CHECK(structure_step(state) <= structure_steps(state));
}

TEST_CASE("every step of every search and build has a sentence in both languages, with all of its numbers") {
  std::set<std::string> sentences;
  for (const Language language : {in_english, in_portuguese}) {
    State state = searching(many_circles(), 4);
    state.appearance.language = language;
    const int cells = static_cast<int>(state.walk.timeline->pixels().size());
    for (int cell = 0; cell < cells; ++cell) {
      update(state, action::JumpToCell{cell});
      for (int rays = 0; rays < 4; ++rays) {
        update(state, action::Step{true, Grain::ray});
        for (const AcceleratorKind kind : watched_accelerators) {
          update(state, action::ChooseStructure{kind});
          for (const StructurePage page : {StructurePage::search, StructurePage::build}) {
            if (page == StructurePage::build && (cell > 0 || rays > 0)) continue;
            update(state, action::ShowStructurePage{page});
            for (int step = 0; step <= structure_steps(state); ++step) {
              update(state, action::GoInStructure{step});
              const StructurePanel panel = structure_panel(state);
              CHECK_FALSE(panel.sentence.empty());
              for (const std::string& text : {panel.title, panel.sentence, panel.so_far, panel.counter, panel.summary})
                CHECK(text.find('{') == std::string::npos);
              for (const StructureRow& row : panel.rows) CHECK(row.numbers.size() == panel.columns.size());
              if (language == in_english) sentences.insert(panel.sentence);
            }
            update(state, action::GoInStructure{0});
            update(state, action::ShowStructurePage{StructurePage::search});
          }
        }
      }
    }
  }
  const auto said = [&](std::string_view id) {
    const std::string whole(text(id, in_english));
    const std::string start = whole.substr(whole.find('}') == std::string::npos ? 0 : whole.find('}') + 1);
    const std::string part = start.substr(0, start.find('{'));
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& each) { return each.find(part) != std::string::npos; });
  };
  for (const std::string_view id : {"structure.entered_inner.other",
                                    "structure.entered_leaf",
                                    "structure.entered_cell",
                                    "structure.opened",
                                    "structure.skip_missed",
                                    "structure.skip_behind",
                                    "structure.skip_beyond",
                                    "structure.skip_off_plan",
                                    "structure.test_missed",
                                    "structure.test_nearest",
                                    "structure.test_blocks",
                                    "structure.test_outside",
                                    "structure.test_unbounded",
                                    "structure.end_all",
                                    "structure.end_blocked",
                                    "structure.end_beyond",
                                    "structure.end_left",
                                    "structure.joined",
                                    "structure.cells",
                                    "structure.listed.other",
                                    "structure.eight",
                                    "structure.leaf_few",
                                    "structure.build_none"}) {
    CAPTURE(text(id, in_english));
    CHECK(said(id));
  }
}

TEST_CASE("the comparison counts the search of the ray in hand, and the summary says what is saved") {
  State state = searching(many_circles());
  update(state, action::GoInStructure{structure_steps(state)});
  const StructurePanel panel = structure_panel(state);
  const RaySearches& searches = *state.structure.searches;
  for (const StructureRow& row : panel.rows) {
    const TestCounts& counts = searches.in[watched_index(row.kind)].counts;
    CHECK(row.numbers[0] == std::to_string(counts.nodes));
    CHECK(row.numbers[1] == std::to_string(counts.primitives));
  }
  CHECK(panel.rows.back().numbers == std::vector<std::string>{"0", "28", "0"});
  const auto own = searches.in[watched_index(AcceleratorKind::bvh)].counts.primitives;
  CHECK(panel.summary == "BVH: " + std::to_string(own) + " of 28 tests, " + std::to_string(28 - own) + " saved");
  CHECK(panel.so_far == "So far: nodes " + panel.rows[0].numbers[0] + ", tests " + panel.rows[0].numbers[1]);
}

TEST_CASE("the plan shows boxes while the tab is open: dashed what is skipped") {
  State state = searching(many_circles());
  State elsewhere = state;
  update(elsewhere, action::SetTab{TreeRoom::tab});
  const std::size_t without = plan_view(elsewhere).size();
  CHECK(plan_view(state).size() > without + 40);
  CHECK(dashed_lines(plan_view(state)) == 0);
  const auto& events = state.structure.searches->in[0].events;
  int skipped = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    skipped += events[i].kind == SearchEvent::Kind::skipped;
    update(state, action::GoInStructure{static_cast<int>(i) + 1});
    CHECK(dashed_lines(plan_view(state)) == 4 * skipped);
    CHECK(is_finite(plan_view(state)));
  }
  CHECK(skipped > 0);
  for (const AcceleratorKind kind : watched_accelerators) {
    update(state, action::ChooseStructure{kind});
    update(state, action::ShowStructurePage{StructurePage::build});
    update(state, action::GoInStructure{0});
    const std::size_t before = plan_view(state).size();
    update(state, action::GoInStructure{1});
    CHECK((plan_view(state).size() > before) == (kind != AcceleratorKind::none));
  }
}

TEST_CASE("boxes stand in the lines too, and the tab says where they leave the plan") {
  State state = searching(make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/whitted.toml")));
  update(state, action::ResizePlan{{800, 600}});
  update(state, action::ShowLines{false});
  const auto& notes = structure_panel(state).notes;
  CHECK(std::find(notes.begin(), notes.end(), text("structure.note_above", in_english)) != notes.end());
  update(state, action::ShowLines{true});
  State elsewhere = state;
  update(elsewhere, action::SetTab{TreeRoom::tab});
  CHECK(lines_view(state, state.plan.viewport).size() > lines_view(elsewhere, state.plan.viewport).size());
}

TEST_CASE("nothing to search and things without end have sentences of their own") {
  Scene scene = classic_state().scene();
  scene.objects.clear();
  State empty = searching(state_of(scene));
  CHECK(structure_panel(empty).sentence == text("structure.not_begun", in_english));
  update(empty, action::GoInStructure{1});
  CHECK(structure_panel(empty).sentence.find(text("structure.found_nothing", in_english)) != std::string::npos);
  update(empty, action::ShowStructurePage{StructurePage::build});
  CHECK(structure_panel(empty).sentence == text("structure.build_empty", in_english));
  CHECK(structure_panel(empty).notes.empty());

  State classic = searching(classic_state());
  CHECK(structure_panel(classic).notes ==
        std::vector<std::string>{fill("structure.note_unbounded", in_english, {{"shapes", "1"}})});
  update(classic, action::GoInStructure{1});
  CHECK(structure_panel(classic).sentence.find(text("structure.test_unbounded", in_english)) != std::string::npos);
}

TEST_CASE("a ray is not searched for while a prediction asks what it will meet") {
  State state = searching(classic_state(), 4);
  REQUIRE(state.structure.searches);
  update(state, action::SetPredictions{true});
  REQUIRE(prediction_asked(state)->what == PredictionKind::end);
  CHECK_FALSE(state.structure.searches);
  CHECK(structure_panel(state).sentence == text("lesson.predict_first", in_english));
  update(state, action::GuessEnd{});
  update(state, action::Step{true});
  CHECK(state.structure.searches);
}

TEST_CASE("a ray that a limit forbade is not searched for") {
  State state = searching(many_circles());
  update(state, action::SetLimits{{1, 0}});
  const auto& rays = state.walk.timeline->rays();
  const auto stub = std::find_if(rays.begin(), rays.end(), [](const RayRecord& ray) { return !ray.formed; });
  REQUIRE(stub != rays.end());
  update(state, action::Jump{stub->formed_at});
  CHECK(structure_panel(state).sentence == text("structure.stub", in_english));
  CHECK(structure_steps(state) == 0);
}
