// The Cost panel's tries by a worker, here played by a server in this program.
#include "gui/try_workers.h"

#include "gui/live_costs.h"
#include "support/catch.h"
#include "view/action.h"

#include <deque>

using namespace raywalk;

namespace {

class PlayedBench final : public Workers {
 public:
  int count() override { return lost ? 0 : 1; }
  void tell(int, const std::string& message) override { messages_.push_back(message); }
  std::optional<Answer> hear(MessageKind) override {
    while (!messages_.empty()) {
      const std::string answer = server_.answer(messages_.front());
      messages_.pop_front();
      if (!answer.empty()) return Answer{0, answer};
    }
    return std::nullopt;
  }

  bool lost = false;

 private:
  TryServer server_;
  std::deque<std::string> messages_;
};

class NoWorkers final : public Workers {
  int count() override { return 0; }
  void tell(int, const std::string&) override {}
  std::optional<Answer> hear(MessageKind) override { return std::nullopt; }
};

State with_tries() {
  State state = make_state(read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").value());
  state.document.contents.scene.image = {40, 30};
  update(state, action::SetTab{CostRoom::tab});
  study::Setup setup = study::setup_of(state.scene());
  for (const int samples : {1, 2, 4}) {
    setup.samples = samples;
    state.cost.tried.push_back(setup);
  }
  return state;
}

/// Until every try is done, and the reference has a few passes.
void work(LiveCosts& costs, const State& state) {
  const auto done = [&] {
    const auto& all = costs.bench().attempts();
    return all.size() == state.cost.tried.size() && all.back().done >= 1 && costs.bench().reference_samples() >= 32;
  };
  while (!done()) costs.work(state, 30);
}

}  // namespace

TEST_CASE("a worker's tries have the images and the counts of tries made here") {
  State state = with_tries();
  PlayedBench bench;
  NoWorkers none;
  LiveCosts there(bench), here(none);
  work(there, state);
  work(here, state);
  for (int more = 0; more < 2; ++more) {
    const auto &ours = here.bench().attempts(), &theirs = there.bench().attempts();
    REQUIRE(ours.size() == theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      CHECK(ours[i].setup == theirs[i].setup);
      CHECK(ours[i].image == theirs[i].image);
      CHECK(ours[i].cost.rays == theirs[i].cost.rays);
      CHECK(ours[i].cost.tests == theirs[i].cost.tests);
      CHECK(theirs[i].error > 0);
    }
    CHECK(!there.bench().reference().pixels.empty());
    // A further one, which the worker has not heard of yet.
    study::Setup setup = state.cost.tried.back();
    setup.samples = 8;
    if (more == 0) state.cost.tried.push_back(setup);
    work(there, state);
    work(here, state);
  }
}

TEST_CASE("tries go on here when the worker is lost") {
  const State state = with_tries();
  PlayedBench bench;
  LiveCosts costs(bench);
  costs.work(state, 30);
  CHECK(costs.waits(state));
  bench.lost = true;
  work(costs, state);
  CHECK_FALSE(costs.waits(state));
  CHECK(!costs.bench().attempts().front().image.pixels.empty());
}

TEST_CASE("tries that took the place of as many others are made anew") {
  State state = with_tries();
  NoWorkers none;
  LiveCosts costs(none);
  work(costs, state);
  for (study::Setup& setup : state.cost.tried) setup.depth = 1;
  costs.work(state, 30);
  work(costs, state);
  REQUIRE(costs.bench().attempts().size() == state.cost.tried.size());
  for (std::size_t i = 0; i < state.cost.tried.size(); ++i)
    CHECK(costs.bench().attempts()[i].setup == state.cost.tried[i]);
}
