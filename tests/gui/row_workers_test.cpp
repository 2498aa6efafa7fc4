// The picture by workers, here played by servers in this program that answer when the test lets them.
#include "gui/row_workers.h"

#include "gui/session.h"
#include "render/film.h"
#include "support/catch.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <vector>

using namespace raywalk;

namespace {

class PlayedWorkers final : public Workers {
 public:
  explicit PlayedWorkers(int count) : servers_(static_cast<std::size_t>(count)) {}

  int count() override { return static_cast<int>(servers_.size()); }
  void tell(int worker, const std::string& message) override {
    ++told;
    messages_.emplace_back(worker, message);
  }
  std::optional<Answer> hear(MessageKind) override {
    while (!messages_.empty() && patience > 0) {
      const auto [worker, message] = messages_.front();
      messages_.pop_front();
      --patience;
      const std::string answer = servers_[static_cast<std::size_t>(worker)].answer(message);
      if (!answer.empty()) return Answer{worker, answer};
    }
    return std::nullopt;
  }

  void lose() { servers_.clear(); }

  int patience = 0;  ///< messages that are answered
  int told = 0;

 private:
  std::vector<RowServer> servers_;
  std::deque<std::pair<int, std::string>> messages_;
};

State scene_of(const std::string& name) {
  State state = make_state(read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml").value());
  update(state, action::SetImageSettings{{.samples = 4}});
  Scene small = state.scene();
  small.image = {48, 36};
  state.document.contents.scene = small;
  return state;
}

/// Works until nothing is left to do, with `milliseconds` a turn.
void finish(LiveImage& image, const State& state, double milliseconds, const std::function<void(int)>& each_turn = {}) {
  for (int turn = 0; image.work(state, milliseconds); ++turn) {
    REQUIRE(turn < 100'000);
    if (each_turn) each_turn(turn);
  }
}

std::vector<std::uint8_t> by_threads(const State& state) {
  PlayedWorkers none(0);
  LiveImage image(none);
  image.follow(state);
  finish(image, state, 1000);
  return image.preview().rgba();
}

}  // namespace

TEST_CASE("workers make the picture that threads make, in every shipped scene's kind") {
  for (const char* name : {"classic", "whitted", "cornell", "distributed", "mesh"}) {
    INFO(name);
    const State state = scene_of(name);
    for (const int count : {1, 3}) {
      PlayedWorkers workers(count);
      LiveImage image(workers);
      image.follow(state);
      finish(image, state, 14, [&](int turn) {
        CHECK(image.waits());
        workers.patience = 2 + turn % 3;
      });
      CHECK_FALSE(image.waits());
      CHECK(image.preview().finished());
      CHECK(image.preview().rgba() == by_threads(state));
    }
  }
}

// Switches and the depth that is looked at are in no scene's file: the workers have to be told of them.
TEST_CASE("workers leave out what is switched off, as threads do") {
  State state = scene_of("whitted");
  update(state, action::ShowEffects{true});
  const auto picture_by = [&](int count) {
    PlayedWorkers workers(count);
    LiveImage image(workers);
    image.follow(state);
    finish(image, state, 14, [&](int) { workers.patience = 3; });
    CHECK(image.preview().finished());
    return image_of(image.preview().film<double>());
  };
  std::vector<Image> seen;
  const auto look = [&] {
    seen.push_back(picture_by(2));
    CHECK(seen.back() == picture_by(0));
    CHECK(std::find(seen.begin(), seen.end() - 1, seen.back()) == seen.end() - 1);
  };
  look();
  for (const Effect effect : {Effect::shadows, Effect::reflection, Effect::refraction, Effect::textures}) {
    INFO(static_cast<int>(effect));
    update(state, action::SwitchEffect{effect, false});
    look();
    update(state, action::SwitchEffect{effect, true});
  }
  update(state, action::LimitDepth{1});
  look();
}

TEST_CASE("an edit makes what was handed out void, and few rows are out at any time") {
  State state = scene_of("classic");
  PlayedWorkers workers(2);
  LiveImage image(workers);
  image.follow(state);
  CHECK(image.work(state, 14));
  CHECK(workers.told == 2 + 2 * 2);  // the scene, and two messages ahead
  CHECK(image.work(state, 14));
  CHECK(workers.told == 2 + 2 * 2);
  update(state, action::SetMode{Mode::move});
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  image.follow(state);
  CHECK(image.preview().done() == 0);
  workers.patience = 1000000;
  finish(image, state, 14);
  CHECK(image.preview().rgba() == by_threads(state));
}

TEST_CASE("when workers are lost the picture is made here") {
  const State state = scene_of("classic");
  PlayedWorkers workers(2);
  LiveImage image(workers);
  image.follow(state);
  workers.patience = 5;
  CHECK(image.work(state, 14));
  workers.lose();
  image.work(state, 0);
  CHECK_FALSE(image.waits());
  finish(image, state, 1000);
  CHECK(image.preview().finished());
  CHECK(image.preview().rgba() == by_threads(state));
}

TEST_CASE("a server that is told nonsense answers that it cannot") {
  RowServer server;
  CHECK(server.answer("").empty());  // a scene that cannot be read
  CHECK(!server.answer(std::string(2, '\1')).empty());
  CHECK(!server.answer(std::string(300, '\1')).empty());
}
