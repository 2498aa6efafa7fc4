// A window that is busy with what never ends still does what it is told.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
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

// A scene that takes seconds to read; a larger file would be refused.
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

std::uintmax_t bytes_of_picture(const Desktop& desktop, const std::string& name) {
  const auto path = std::filesystem::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test" / (name + ".png");
  desktop.picture(path);
  return std::filesystem::file_size(path);
}

bool in_time(const std::function<bool()>& wanted) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!wanted()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

// Waits until the program has computed for a while, which nothing but its picture makes it do.
void let_it_begin(const Visualiser& raywalk) {
  const double before = raywalk.processor_time();
  REQUIRE(in_time([&] { return raywalk.processor_time() > before + 1; }));
}

}  // namespace

TEST_CASE("a window is closed in the middle of a pixel", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 720);
  Visualiser raywalk(desktop, {room_in(desktop), "--start-tab", "image"});
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin(raywalk);
  // Another tab, and the walk goes on: the picture gives way each time.
  raywalk.click("tab-tree");
  REQUIRE(raywalk.until("tab", "tree"));
  raywalk.click("tab-image");
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin(raywalk);
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("a window ends at a signal in the middle of a pixel", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 720);
  Visualiser raywalk(desktop, {room_in(desktop), "--start-tab", "image"});
  REQUIRE(raywalk.until("tab", "image"));
  let_it_begin(raywalk);
  kill(raywalk.id(), SIGHUP);
  CHECK(raywalk.wait() == 1);
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
  const std::uintmax_t full = bytes_of_picture(desktop, "r0-open");
  raywalk.key("Return");
  // A line of words on an empty ground packs far better than a window.
  REQUIRE(in_time([&] { return 3 * bytes_of_picture(desktop, "r1-reading") < full; }));
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
  CHECK(raywalk.wait() == 0);
}
