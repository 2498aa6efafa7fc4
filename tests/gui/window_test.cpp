// The real program in a real window, driven as a person would. Pictures of what was seen are kept beside the program,
// in window-test.

#include <GLFW/glfw3.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "gui/desktop.h"
#include "gui/window.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

fs::path picture(const std::string& name) {
  return fs::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test" / (name + ".png");
}

// A copy of the classic scene that may be written to.
std::string own_classic(const Desktop& desktop) {
  const fs::path path = desktop.folder() / "scene.toml";
  fs::copy_file(fs::path(RAYWALK_SOURCE_DIR) / "scenes/classic.toml", path, fs::copy_options::overwrite_existing);
  return path.string();
}

std::pair<double, double> object(const Visualiser& raywalk, const std::string& name) {
  const Json& at = raywalk.report()["objects"][name]["window"];
  return {at[0].get<double>(), at[1].get<double>()};
}

double number(const Visualiser& raywalk, const std::string& member) { return raywalk.report()[member].get<double>(); }

bool started(Visualiser& raywalk) {
  return raywalk.until([](const Json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60);
}

}  // namespace

TEST_CASE("the classic walk with the mouse: Move, STEP, back, AUTO, PAUSE, CLEAR, Help", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const std::string scene = own_classic(desktop);
  Visualiser raywalk(desktop, {scene});
  INFO(raywalk.said());
  REQUIRE(started(raywalk));
  CHECK(raywalk.report()["path"] == scene);
  desktop.picture(picture("1-start"));

  // Move: the sphere follows the mouse, by as much.
  raywalk.click("mode-move");
  REQUIRE(raywalk.until("mode", "move"));
  const auto [x, y] = object(raywalk, "Solid Sphere");
  raywalk.drag(x, y, x + 60, y + 40);
  REQUIRE(raywalk.until("dirty", true));
  REQUIRE(raywalk.until("undo", 1));
  CHECK(object(raywalk, "Solid Sphere").first == Approx(x + 60).margin(1.5));
  CHECK(object(raywalk, "Solid Sphere").second == Approx(y + 40).margin(1.5));
  CHECK(raywalk.report()["selected"] == "Solid Sphere");
  desktop.picture(picture("2-moved"));
  raywalk.key("ctrl+z");
  REQUIRE(raywalk.until("undo", 0));
  CHECK(object(raywalk, "Solid Sphere").first == Approx(x).margin(0.01));
  CHECK(raywalk.report()["dirty"] == false);

  // Trace: three steps forward and one back.
  raywalk.click("mode-trace");
  REQUIRE(raywalk.until("mode", "trace"));
  CHECK(number(raywalk, "position") == 0);
  for (int step = 1; step <= 3; ++step) {
    raywalk.click("step");
    REQUIRE(raywalk.until("position", step));
  }
  desktop.picture(picture("3-three-steps"));
  raywalk.click("step-back");
  REQUIRE(raywalk.until("position", 2));
  raywalk.key("Right");
  REQUIRE(raywalk.until("position", 3));
  raywalk.key("ctrl+Right");
  REQUIRE(raywalk.until([](const Json& report) { return report["position"].get<int>() > 4; }));

  // AUTO goes on by itself and pauses at once.
  const double before = number(raywalk, "position");
  raywalk.click("faster");
  raywalk.click("faster");
  raywalk.click("play");
  REQUIRE(raywalk.until("playing", true));
  REQUIRE(raywalk.until([&](const Json& report) { return report["position"].get<double>() >= before + 5; }));
  raywalk.click("play");
  REQUIRE(raywalk.until("playing", false));
  const double paused = number(raywalk, "position");
  desktop.hand({"sleep", "0.5"});
  raywalk.until([](const Json&) { return true; });
  CHECK(number(raywalk, "position") == paused);
  desktop.picture(picture("4-auto"));

  // The tabs.
  raywalk.click("tab-tree");
  REQUIRE(raywalk.until("tab", "tree"));
  desktop.picture(picture("5-tree"));
  raywalk.click("tab-stack");
  REQUIRE(raywalk.until("tab", "stack"));
  raywalk.click("tab-image");
  REQUIRE(raywalk.until("tab", "image"));

  // The whole strip, then CLEAR.
  raywalk.key("End");
  REQUIRE(raywalk.until([](const Json& report) { return report["position"] == report["steps"]; }));
  desktop.picture(picture("6-all"));
  raywalk.click("clear");
  REQUIRE(raywalk.until("position", 0));

  raywalk.click("mode-help");
  REQUIRE(raywalk.until("mode", "help"));
  desktop.picture(picture("7-help"));
  raywalk.key("p");
  REQUIRE(raywalk.until("theme", "projector"));
  raywalk.click("mode-trace");
  REQUIRE(raywalk.until("mode", "trace"));
  desktop.picture(picture("8-projector"));

  // Nothing is unsaved: the window closes without a question.
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
  CHECK(raywalk.said() == "");
}

TEST_CASE("a scene that is not planar: the picture is turned, a pixel of it is walked, the lines are turned",
          "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/quadrics.toml", "--start-mode", "trace"});
  REQUIRE(started(raywalk));
  CHECK(raywalk.report()["lines"] == true);
  const auto [x, y] = raywalk.place("image");
  raywalk.drag(x, y, x + 60, y + 20);
  REQUIRE(raywalk.until("turned", true));
  CHECK(raywalk.report()["dirty"] == false);
  raywalk.click("image");
  REQUIRE(raywalk.until([](const Json& report) { return report.contains("walk"); }));
  CHECK(raywalk.report()["position"] == raywalk.report()["steps"]);
  CHECK(raywalk.report()["rays"].get<int>() >= 1);
  CHECK(raywalk.report()["tab"] == "image");
  desktop.picture(picture("d-pixel"));
  const auto [left, top] = raywalk.place("lines");
  raywalk.drag(left, top, left + 120, top + 40);
  desktop.picture(picture("d-turned"));
  raywalk.key("s");
  REQUIRE(raywalk.until([](const Json& report) { return !report.contains("walk"); }));
  raywalk.key("i");
  REQUIRE(raywalk.until("tab", "image"));
  raywalk.key("o");
  REQUIRE(raywalk.until("turned", false));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
  CHECK(raywalk.said() == "");
}

TEST_CASE("files with mouse and keyboard: save as, open, undo, unsaved work, recovery", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const std::string scene = own_classic(desktop);
  const std::string other = (desktop.folder() / "other.toml").string();
  {
    Visualiser raywalk(desktop, {scene, "--start-mode", "move"});
    INFO(raywalk.said());
    REQUIRE(started(raywalk));
    const auto [x, y] = object(raywalk, "Polygon");
    raywalk.drag(x, y, x - 40, y + 10);
    REQUIRE(raywalk.until("dirty", true));
    const Json moved = raywalk.report()["objects"]["Polygon"]["plan"];

    raywalk.key("ctrl+shift+s");
    REQUIRE(raywalk.until("prompt", "save_as"));
    desktop.picture(picture("a-save-as"));
    raywalk.retype(other);
    raywalk.key("Return");
    REQUIRE(raywalk.until("path", other));
    CHECK(raywalk.report()["dirty"] == false);
    const auto written = read_scene(other);
    REQUIRE(written.has_value());
    CHECK(fs::file_size(scene) > 0);

    // The first file again: through the dialog, by its name in the list.
    raywalk.key("ctrl+o");
    REQUIRE(raywalk.until("prompt", "open"));
    raywalk.click("gallery-files");
    raywalk.click("browser/scene.toml");
    raywalk.click("browser-accept");
    REQUIRE(raywalk.until("path", scene));
    CHECK(raywalk.report()["objects"]["Polygon"]["plan"] != moved);

    // Closing with unsaved work asks; cancelled, everything is as before.
    raywalk.click("mode-move");
    raywalk.click("add-light");
    REQUIRE(raywalk.until("dirty", true));
    raywalk.key("ctrl+q");
    REQUIRE(raywalk.until("question", "unsaved"));
    desktop.picture(picture("b-unsaved"));
    raywalk.key("Escape");
    REQUIRE(raywalk.until("question", ""));
    CHECK(raywalk.report()["dirty"] == true);

    // The look is kept, and the autosave written, without being asked for.
    raywalk.key("p");
    REQUIRE(raywalk.until("theme", "projector"));
    REQUIRE(raywalk.until([&](const Json&) { return fs::exists(desktop.folder() / "state" / "autosave.toml"); }, 30));
    kill(raywalk.id(), SIGKILL);
    CHECK(raywalk.wait() == 128 + SIGKILL);
  }
  Visualiser raywalk(desktop, {scene});
  INFO(raywalk.said());
  REQUIRE(started(raywalk));
  CHECK(raywalk.report()["theme"] == "projector");
  REQUIRE(raywalk.until("question", "recover"));
  desktop.picture(picture("c-recover"));
  raywalk.click("answer-0");
  REQUIRE(raywalk.until("question", ""));
  CHECK(raywalk.report()["dirty"] == true);
  CHECK(raywalk.report()["lights"].size() == 2);

  // Closing, and not saving: the file is as it was.
  raywalk.key("ctrl+q");
  REQUIRE(raywalk.until("question", "unsaved"));
  raywalk.click("answer-1");
  CHECK(raywalk.wait() == 0);
  const auto untouched = read_scene(scene);
  REQUIRE(untouched.has_value());
  CHECK(untouched->scene.lights.size() == 1);
  CHECK(raywalk.said() == "");
}

TEST_CASE("a key does what is written on it: Ctrl+Z of a German keyboard, which has Y in its place, undoes",
          "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  Child german({"setxkbmap", "de"}, {{"DISPLAY", desktop.display()}}, desktop.folder() / "setxkbmap.err");
  REQUIRE(german.wait(20) == 0);
  Visualiser raywalk(desktop, {own_classic(desktop), "--start-mode", "move"});
  INFO(raywalk.said());
  REQUIRE(started(raywalk));
  raywalk.click("add-light");
  REQUIRE(raywalk.until("undo", 1));
  raywalk.key("ctrl+z");
  CHECK(raywalk.until("undo", 0));
  raywalk.key("ctrl+y");
  CHECK(raywalk.until("undo", 1));
  CHECK(raywalk.said() == "");
}

TEST_CASE("the window survives any size, and is idle when nothing happens", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  Visualiser raywalk(desktop, {own_classic(desktop), "--start-mode", "trace", "--start-position", "60"});
  INFO(raywalk.said());
  REQUIRE(started(raywalk));
  const auto resized = [&](const char* width, const char* height) {
    const auto is_so = [&](const Json& report) { return report["window"]["width"] == std::stof(width); };
    // A request may be lost on a busy desktop. The second changes nothing there if it was the window that missed it.
    for (int request = 0; request < 2; ++request) {
      desktop.hand({"search", "--onlyvisible", "--class", "raywalk", "windowsize", width, height});
      if (raywalk.until(is_so)) return true;
    }
    UNSCOPED_INFO("asked for " << width << " x " << height << ", has " << raywalk.report()["window"].dump());
    return false;
  };
  for (const auto& [width, height] : {std::pair{"1", "1"}, {"20", "700"}, {"1200", "12"}, {"300", "200"}}) {
    REQUIRE(resized(width, height));
    raywalk.key("Right");
  }
  REQUIRE(resized("1280", "720"));
  CHECK(number(raywalk, "position") == 64);

  // Until the 3-D image is done there is work to do.
  REQUIRE(
      raywalk.until([](const Json& report) { return report["image"]["finished"] && report["window"]["idle"]; }, 200));
  desktop.hand({"sleep", "1"});
  const double before = raywalk.processor_time();
  constexpr double seconds = 4;
  desktop.hand({"sleep", std::to_string(seconds)});
  CHECK(raywalk.processor_time() - before < 0.01 * seconds + 0.011);  // one tick of the clock is 0.01 s
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("what cannot be opened is said, with exit code 1", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(640, 480);
  const std::string broken = (desktop.folder() / "broken.toml").string();
  std::ofstream(broken) << "this is no scene";
  Visualiser raywalk(desktop, {broken});
  CHECK(raywalk.wait() == 1);
  CHECK_THAT(raywalk.said(), contains("broken.toml"));
}

TEST_CASE("a demo that cannot export what it was to export says so, with exit code 1", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const std::string demo = (desktop.folder() / "show.demo").string();
  for (const char* ending : {"svg", "png"}) {
    std::ofstream(demo) << "step forward\nexport " << (desktop.folder() / "missing/walk.").string() << ending
                        << "\nwait 1\nquit\n";
    Visualiser raywalk(desktop, {own_classic(desktop), "--demo", demo});
    CHECK(raywalk.wait(100) == 1);
    CHECK_THAT(raywalk.said(), contains("show.demo") && contains("there is no folder") && contains("missing"));
  }
}

TEST_CASE("a demo that cannot open its lesson says so, with exit code 1", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const std::string demo = (desktop.folder() / "show.demo").string();
  const auto ends_with = [&](const std::string& lesson, int code, const char* why) {
    std::ofstream(demo) << "open-lesson " << lesson << "\nquit\n";
    Visualiser raywalk(desktop, {own_classic(desktop), "--demo", demo});
    CHECK(raywalk.wait(100) == code);
    if (code == 0)
      CHECK(raywalk.said() == why);
    else
      CHECK_THAT(raywalk.said(), contains(why));
  };
  ends_with("01-ray-casting", 0, "");
  ends_with("99-nowhere", 1, "There is no lesson named 99-nowhere");
  ends_with("04-reflection", 1, "Locked: finish the lesson above it first");
}

TEST_CASE("a demo that waits for an answer that cannot come ends with exit code 1", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(640, 480);
  const std::string demo = (desktop.folder() / "show.demo").string();
  const std::string walk = (desktop.folder() / "walk.svg").string();
  std::ofstream(walk) << "mine";
  std::ofstream(demo) << "export " << walk << "\nwait 0.1\nquit\n";
  {
    Visualiser raywalk(desktop, {own_classic(desktop), "--demo", demo});
    CHECK(raywalk.wait(100) == 1);
    CHECK_THAT(raywalk.said(), contains("show.demo") && contains("answer save"));
  }
  CHECK(fs::file_size(walk) == 4);
  std::ofstream(demo) << "export " << walk << "\nwait 0.1\nanswer save\nquit\n";
  Visualiser raywalk(desktop, {own_classic(desktop), "--demo", demo});
  CHECK(raywalk.wait(100) == 0);
  CHECK(fs::file_size(walk) > 1000);
}

TEST_CASE("the window's picture replaces nothing that the window reads", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(640, 480);
  const std::string scene = own_classic(desktop), link = (desktop.folder() / "link.png").string();
  fs::create_symlink(scene, link);
  const auto before = fs::file_size(scene);
  Visualiser raywalk(desktop, {scene, "--screenshot", link});
  CHECK(raywalk.wait(100) == 2);
  CHECK_THAT(raywalk.said(), contains("link.png: cannot write: this is the same file as"));
  CHECK(fs::file_size(scene) == before);
}

TEST_CASE("the program takes its own picture", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const fs::path path = picture("d-own");
  fs::create_directories(path.parent_path());
  fs::remove(path);
  Visualiser raywalk(desktop, {own_classic(desktop), "--screenshot", path.string(), "--start-mode", "trace",
                               "--start-position", "-1", "--window", "640x480"});
  REQUIRE(raywalk.wait(250) == 0);
  CHECK(fs::file_size(path) > 10000);
}

TEST_CASE("a program that is closed before its own picture says that there is none", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(640, 480);
  const fs::path path = desktop.folder() / "own.png", demo = desktop.folder() / "quits.demo";
  std::ofstream(demo) << "quit\n";
  Visualiser raywalk(desktop, {own_classic(desktop), "--screenshot", path.string(), "--demo", demo.string()});
  CHECK(raywalk.wait(250) == 1);
  CHECK_THAT(raywalk.said(), contains("own.png: not written"));
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("the window hears of files that are dropped on it", "[window]") {
  NEEDS_A_DESKTOP
  if (sanitized) return;  // what drivers allocate once and keep would be a leak of this program's
  const Desktop desktop(640, 480);
  // xdotool drops no files: what GLFW would call is called here.
  const char* const display = std::getenv("DISPLAY");
  const std::string before = display == nullptr ? "" : display;
  setenv("DISPLAY", desktop.display().c_str(), 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  {
    const auto window = Window::open("drops", 320, 240);
    REQUIRE(window.has_value());
    GLFWwindow* const handle = glfwGetCurrentContext();
    const GLFWdropfun dropped = glfwSetDropCallback(handle, nullptr);
    REQUIRE(dropped != nullptr);
    CHECK((*window)->take_dropped().empty());
    const char* paths[] = {"/a/one.toml", "/a/b c.ply"};
    dropped(handle, 2, paths);
    CHECK((*window)->take_dropped() == std::vector<std::string>{"/a/one.toml", "/a/b c.ply"});
    CHECK((*window)->take_dropped().empty());
  }
  if (before.empty())
    unsetenv("DISPLAY");
  else
    setenv("DISPLAY", before.c_str(), 1);
}
