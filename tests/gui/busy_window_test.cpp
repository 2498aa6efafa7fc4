// A window that is busy with what never ends still does what it is told.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gui/desktop.h"
#include "support/endless_room.h"

using namespace raywalk::test;

namespace {

std::string room_in(const Desktop& desktop) {
  const std::string path = (desktop.folder() / "room.toml").string();
  std::ofstream(path) << endless_room;
  return path;
}

// A scene that takes seconds to read.
std::string long_scene_in(const Desktop& desktop) {
  const std::string path = (desktop.folder() / "long.toml").string();
  std::ofstream file(path);
  file << "[camera]\neye = [-7, 0]\nlook_at = [0, 0]\nfov = 45\n";
  constexpr int spheres = 190'000;
  for (int i = 0; i < spheres; ++i)
    file << "[[object]]\nname = \"" << i << "\"\ntype = \"sphere\"\ncentre = [" << i % 1000 << ", " << i / 1000
         << "]\nradius = 0.2\n";
  return path;
}

// Waits until the window shows that it reads: a line of words on an empty ground, which packs far better than a scene.
bool shows_reading(const Desktop& desktop) {
  const auto path = std::filesystem::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test" / "r1-reading.png";
  constexpr std::uintmax_t most_bytes = 20'000;
  for (int i = 0; i < 100; ++i) {
    desktop.picture(path);
    if (std::filesystem::file_size(path) < most_bytes) return true;
  }
  return false;
}

void let_it_begin() { std::this_thread::sleep_for(std::chrono::seconds(2)); }

}  // namespace

TEST_CASE("a window is closed in the middle of a pixel", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 720);
  Visualiser raywalk(desktop, {room_in(desktop), "--start-tab", "image"});
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin();
  // Another tab, and the walk goes on: the picture gives way each time.
  raywalk.click("tab-tree");
  REQUIRE(raywalk.until("tab", "tree"));
  raywalk.click("tab-image");
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin();
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait(10) == 0);
}

TEST_CASE("a window ends at a signal in the middle of a pixel", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 720);
  Visualiser raywalk(desktop, {room_in(desktop), "--start-tab", "image"});
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin();
  kill(raywalk.id(), SIGHUP);
  CHECK(raywalk.wait(10) == 1);
}

TEST_CASE("reading a long file is cancelled by Escape, and the scene is as it was", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 720);
  const std::string path = long_scene_in(desktop);
  Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"});
  REQUIRE(raywalk.until([](const nlohmann::json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60));
  const std::string before = raywalk.report()["path"];
  raywalk.key("ctrl+o");
  REQUIRE(raywalk.until("prompt", "open"));
  raywalk.type(path);
  raywalk.key("Return");
  REQUIRE(shows_reading(desktop));
  raywalk.key("Escape");
  // The dialog is open again, with the name; its own Escape closes it.
  REQUIRE(raywalk.until([](const nlohmann::json& report) { return !report["notice"].get<std::string>().empty(); }, 20));
  CHECK(raywalk.report()["path"] == before);
  CHECK(raywalk.report()["prompt"] == "open");
  raywalk.key("Escape");
  REQUIRE(raywalk.until("prompt", ""));
  raywalk.key("t");
  REQUIRE(raywalk.until("mode", "trace"));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait(10) == 0);
}
