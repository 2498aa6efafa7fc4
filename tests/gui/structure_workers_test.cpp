// The Structure tab by a worker, here played by a server in this program that answers when the test lets it.
#include "gui/structure_workers.h"

#include "io/scene_file.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/action.h"
#include "view/structure/structure.h"
#include "view/text/text.h"

#include <deque>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

class PlayedStructures final : public Workers {
 public:
  int count() override { return lost ? 0 : 1; }
  void tell(int, const std::string& message) override { messages.push_back(message); }
  std::optional<Answer> hear(MessageKind) override {
    while (!messages.empty() && patience > 0) {
      const std::string message = messages.front();
      messages.pop_front();
      const std::string answer = server_.answer(message);
      if (answer.empty()) continue;
      --patience;
      return Answer{0, answer};
    }
    return std::nullopt;
  }

  bool lost = false;
  int patience = 1000000;  ///< messages that are answered
  std::deque<std::string> messages;

 private:
  StructureServer server_;
};

State state_of(const std::string& name) {
  return make_state(read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml").value());
}

void search(State& state) {
  update(state, action::SetTab{StructureRoom::tab});
  update(state, action::JumpToCell{10});
  update(state, action::Step{true});
}

/// The words of the tab on both pages, in each structure, in the middle and at the end of its steps.
std::vector<std::string> told(State state) {
  std::vector<std::string> all;
  for (const StructurePage page : {StructurePage::search, StructurePage::build})
    for (const AcceleratorKind kind : watched_accelerators) {
      update(state, action::ShowStructurePage{page});
      update(state, action::ChooseStructure{kind});
      const int steps = structure_steps(state);
      for (const int step : {0, steps / 3, steps - 1, steps}) {
        update(state, action::GoInStructure{step});
        const StructurePanel panel = structure_panel(state);
        all.insert(all.end(), {panel.title, panel.sentence, panel.so_far, panel.counter, panel.summary});
        for (const StructureRow& row : panel.rows) all.insert(all.end(), row.numbers.begin(), row.numbers.end());
        all.insert(all.end(), panel.notes.begin(), panel.notes.end());
      }
      for (const StructureNode& node : state.structure.walks->build(kind).nodes)
        all.push_back(std::to_string(node.box.min.x) + " " + std::to_string(node.box.max.z) + " " +
                      std::to_string(node.depth * 1000 + node.items));
      for (const BuildStep& step : state.structure.walks->build(kind).steps)
        for (const BuildStep::Part& part : step.parts)
          all.push_back(std::to_string(part.box.max.y) + " " + std::to_string(part.items));
    }
  return all;
}

void serve_all(StructureWorkers& workers, State& state) {
  for (int i = 0; i < 20; ++i) workers.serve(state);
  REQUIRE_FALSE(state.structure.awaited);
  REQUIRE_FALSE(state.structure.walks->waits());
}

}  // namespace

TEST_CASE("a worker's structures tell what those built here tell, in both precisions and numerics") {
  for (const bool single : {false, true})
    for (const Numerics numerics : {Numerics::robust, Numerics::naive}) {
      CAPTURE(single, name_of(numerics));
      State state = state_of("mesh");
      state.document.contents.scene.render.numerics = numerics;
      update(state, action::SetImageSettings{{.single_precision = single}});
      State here = state;
      search(here);
      PlayedStructures played;
      StructureWorkers workers(played);
      workers.serve(state);
      REQUIRE(state.structure.most_here == StructureWorkers::most_here);
      search(state);
      CHECK(structure_panel(state).sentence ==
            fill("structure.being_built", in_english, {{"shapes", state.structure.walks->primitives()}}));
      CHECK(structure_steps(state) == 0);
      serve_all(workers, state);
      REQUIRE(state.structure.searches != nullptr);
      CHECK(structure_steps(state) > 0);
      CHECK(told(state) == told(here));
      // A search that was shown to its end is followed by the end of the next one.
      for (State* each : {&state, &here}) {
        update(*each, action::GoInStructure{structure_steps(*each)});
        update(*each, action::Step{true, Grain::ray});
      }
      CHECK(structure_panel(state).sentence == text("structure.being_searched", in_english));
      CHECK(workers.patience() == 0);
      workers.serve(state);
      CHECK(workers.patience() > 0);
      serve_all(workers, state);
      CHECK(structure_step(state) == structure_steps(state));
      CHECK(told(state) == told(here));
    }
}

TEST_CASE("few primitives are not sent away") {
  State state = state_of("classic");
  PlayedStructures played;
  StructureWorkers workers(played);
  workers.serve(state);
  search(state);
  CHECK(structure_steps(state) > 0);
  workers.serve(state);
  CHECK(played.messages.empty());
}

TEST_CASE("an edit makes what is under way void, another ray of the same scene builds nothing anew") {
  State state = state_of("mesh");
  PlayedStructures played;
  StructureWorkers workers(played);
  workers.serve(state);
  search(state);
  played.patience = 2;
  for (int i = 0; i < 5; ++i) workers.serve(state);
  CHECK(state.structure.walks->waits());
  CHECK(played.messages.size() == 1);  // one at a time
  update(state, action::SetMode{Mode::move});
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  search(state);
  State here = state;
  here.structure.most_here = 1000000;
  here.structure.walks.reset();
  StructureRoom::follow(here, {});
  played.patience = 1000000;
  serve_all(workers, state);
  CHECK(told(state) == told(here));

  update(state, action::WalkPixel{20, 14, state.scene().image});
  update(state, action::Step{true, Grain::ray});
  CHECK(state.structure.walks->waits());
  workers.serve(state);
  CHECK_FALSE(state.structure.walks->waits());
}

TEST_CASE("when workers are lost structures are built here") {
  State state = state_of("mesh");
  PlayedStructures played;
  StructureWorkers workers(played);
  workers.serve(state);
  search(state);
  played.patience = 1;
  workers.serve(state);
  played.lost = true;
  CHECK(workers.serve(state));
  CHECK_FALSE(state.structure.walks->elsewhere());
  CHECK(structure_steps(state) > 0);
}
