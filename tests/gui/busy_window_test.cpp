// A window that is busy with what never ends still does what it is told.

#include <chrono>
#include <csignal>
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
