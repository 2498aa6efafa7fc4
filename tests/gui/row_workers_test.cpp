// The picture by workers, here played by servers in this program that answer when the test lets them.
#include "gui/row_workers.h"

#include "gui/session.h"
#include "support/catch.h"

#include <deque>
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

std::vector<std::uint8_t> by_threads(const State& state) {
  PlayedWorkers none(0);
  LiveImage image(none);
  image.follow(state);
  while (image.work(state, 1000)) {
  }
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
      int turns = 0;
      while (image.work(state, 14)) {
        CHECK(image.waits());
        workers.patience = 2 + turns++ % 3;
        REQUIRE(turns < 100000);
      }
      CHECK_FALSE(image.waits());
      CHECK(image.preview().finished());
      CHECK(image.preview().rgba() == by_threads(state));
    }
  }
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
  while (image.work(state, 14)) {
  }
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
  while (image.work(state, 1000)) {
  }
  CHECK(image.preview().finished());
  CHECK(image.preview().rgba() == by_threads(state));
}

TEST_CASE("a server that is told nonsense answers that it cannot") {
  RowServer server;
  CHECK(server.answer("").empty());  // a scene that cannot be read
  CHECK(!server.answer(std::string(2, '\1')).empty());
  CHECK(!server.answer(std::string(300, '\1')).empty());
}
