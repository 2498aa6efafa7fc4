// The panels that open on demand, in the real window, by mouse and keys. Pictures are kept as window_test.cpp's are.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gui/classic_walk.h"
#include "image/image_file.h"
#include "support/catch.h"
#include "support/played_film.h"

using namespace raywalk;
using namespace raywalk::test;

using Json = nlohmann::json;

TEST_CASE("Cost in the window: knobs, tries, marks, two pictures, what each effect adds", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("F3");
  REQUIRE(raywalk.until("tab", "cost"));
  CHECK(raywalk.report()["cost"]["tried"] == 0);
  raywalk.click("cost-try");
  REQUIRE(walk.until("cost", "tried", 1));
  REQUIRE(walk.until("cost", "done", 1));
  // Another setting: the number is typed, and tried by the button below it.
  raywalk.click("cost-knobs");
  REQUIRE(raywalk.until([](const Json& report) { return report["items"].contains("cost-knobs-popup"); }));
  walk.keep_picture("p1-cost-knobs");
  raywalk.key("Escape");
  REQUIRE(raywalk.until([](const Json& report) { return !report["items"].contains("cost-knobs-popup"); }));
  raywalk.key("shift+F4");
  REQUIRE(raywalk.until([](const Json& report) { return report["cost"]["tried"].get<int>() >= 4; }));
  const int tried = raywalk.report()["cost"]["tried"].get<int>();
  REQUIRE(walk.until("cost", "done", tried, 120));
  REQUIRE(raywalk.until([](const Json& report) { return report["cost"]["reference_samples"].get<int>() >= 64; }, 120));
  raywalk.click("cost-mark-0");
  REQUIRE(walk.until("cost", "chosen", 0));
  raywalk.key("shift+F5");
  REQUIRE(walk.until("cost", "against", 0));
  walk.keep_picture("p2-cost-tries");
  raywalk.key("F6");
  REQUIRE(walk.until("cost", "difference", true));
  raywalk.key("F6");
  REQUIRE(walk.until("cost", "difference", false));
  const double split = raywalk.report()["cost"]["split"].get<double>();
  raywalk.key("F8");
  REQUIRE(raywalk.until([&](const Json& report) { return report["cost"]["split"].get<double>() > split; }));
  raywalk.click("cost-page");
  REQUIRE(walk.until("cost", "page", "effects"));
  REQUIRE(walk.until("cost", "surveyed", 1.0, 120));
  walk.keep_picture("p3-cost-effects");
  raywalk.key("F9");
  REQUIRE(walk.until("cost", "page", "tries"));
  raywalk.key("ctrl+F4");
  REQUIRE(walk.until("cost", "tried", 0));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("Microscope in the window: closer, to single floats, naive and back", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.click("line-6");  // Form shadow ray: something was hit
  REQUIRE(raywalk.until([](const Json& report) { return report["position"].get<int>() > 4; }));
  raywalk.key("y");
  REQUIRE(raywalk.until("tab", "microscope"));
  raywalk.key("z");
  REQUIRE(raywalk.until([](const Json& report) { return report["magnified"].get<double>() > 0; }));
  raywalk.click("to-numbers");
  REQUIRE(raywalk.until("magnified", 1.0));
  raywalk.click("numerics-naive");
  REQUIRE(raywalk.until("naive", true));
  CHECK(raywalk.report()["undo"] == 1);
  raywalk.move_to(640, 650);
  walk.keep_picture("p4-microscope");
  raywalk.key("ctrl+z");
  REQUIRE(raywalk.until("naive", false));
  raywalk.key("alt+shift+z");
  REQUIRE(raywalk.until("magnified", 0.0));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("breakpoints in the window: a click left of a line, on to it, and none again", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("Home");
  REQUIRE(raywalk.until("position", 0));
  raywalk.click("break-9");  // Form reflect ray
  REQUIRE(raywalk.until("stops", 1));
  raywalk.key("w");
  REQUIRE(raywalk.until([](const Json& report) { return report["position"].get<int>() > 0; }));
  const int before = raywalk.report()["position"].get<int>();
  walk.keep_picture("p5-breakpoint");
  // The next step runs that line: a ray more is drawn.
  const int rays = raywalk.report()["rays"].get<int>();
  raywalk.key("space");
  REQUIRE(raywalk.until("position", before + 1));
  CHECK(raywalk.report()["rays"] == rays + 1);
  raywalk.click("break-9");
  REQUIRE(raywalk.until("stops", 0));
  raywalk.key("w");
  REQUIRE(raywalk.until([](const Json& report) { return report["position"] == report["steps"]; }));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("spot the bug in the window: from the list to the cure and back to one's own scene", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("shift+F2");
  raywalk.click("bug/2");
  REQUIRE(walk.until("bug", "hunted", true));
  walk.keep_picture("p6-bug");
  raywalk.click("line-6");  // a wrong answer, then the right one
  raywalk.click("bug-mark");
  REQUIRE(walk.until("bug", "known", false));
  raywalk.click("line-9");
  raywalk.click("bug-mark");
  REQUIRE(raywalk.until([](const Json& report) { return report["items"].contains("bug-mend"); }));
  raywalk.click("bug-mend");
  REQUIRE(walk.until("bug", "mended", true));
  walk.keep_picture("p7-bug-mended");
  raywalk.click("bugs-list");
  raywalk.click("bugs-close");
  REQUIRE(raywalk.until([](const Json& report) { return !report.contains("bug"); }));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("Structure in the window: a search stepped, another structure, how it was built", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.click("line-6");  // Form shadow ray: something was hit
  REQUIRE(raywalk.until([](const Json& report) { return report["position"].get<int>() > 4; }));
  raywalk.key("ctrl+t");
  REQUIRE(raywalk.until("tab", "structure"));
  REQUIRE(raywalk.until([](const Json& report) { return report["structure"]["steps"].get<int>() > 2; }));
  raywalk.click("structure-next");
  REQUIRE(walk.until("structure", "step", 1));
  raywalk.key("ctrl+j");
  REQUIRE(walk.until("structure", "step", 2));
  walk.keep_picture("p7-structure");
  raywalk.key("ctrl+k");
  REQUIRE(walk.until("structure", "step", 1));
  // Exchanged with the plan, the panel shows all of its table.
  raywalk.key("x");
  REQUIRE(raywalk.until([](const Json& report) { return report["items"]["structure/kdtree"][1].get<double>() < 560; }));
  raywalk.click("structure/kdtree");
  REQUIRE(walk.until("structure", "kind", "kdtree"));
  raywalk.key("ctrl+u");
  REQUIRE(walk.until("structure", "kind", "none"));
  raywalk.key("ctrl+u");
  REQUIRE(walk.until("structure", "kind", "bvh"));
  raywalk.click("structure/build");
  REQUIRE(walk.until("structure", "build", true));
  raywalk.key("ctrl+shift+j");
  REQUIRE(raywalk.until([](const Json& report) {
    return report["structure"]["step"] == report["structure"]["steps"] && report["structure"]["steps"].get<int>() > 0;
  }));
  walk.keep_picture("p8-structure-build");
  raywalk.key("ctrl+i");
  REQUIRE(walk.until("structure", "build", false));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("exports of the window: exact, without a trace of the pointer, and the demo goes on after them", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const auto file = [&](const std::string& name) { return (desktop.folder() / name).string(); };
  const auto contents = [&](const std::string& name) {
    std::ifstream in(file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto pixels = [&](const std::string& name) {
    const auto image = read_image(file(name));
    REQUIRE(image);
    return bytes_of(*image, Encoding::srgb);
  };
  std::ofstream(file("show.demo")) << "mode trace\njump 11\ngrain ray\nspeed 10\nexport " << file("begin.png")
                                   << "\nwait 2\nexport " << file("pointed.png") << "\nexport " << file("walk.gif")
                                   << "\nstep forward pixel\nexport " << file("end.png") << "\njump 0\n";
  Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml", "--demo", file("show.demo")});
  INFO(raywalk.said());
  // The pointer rests on a sphere, whose name then stands beside it.
  REQUIRE(raywalk.until([&](const Json&) { return std::filesystem::exists(file("begin.png")); }, 120));
  raywalk.move_to(525, 200);
  // The animation leaves the walk where it was; the demo then leads back to the start.
  REQUIRE(raywalk.until(
      [&](const Json& report) { return std::filesystem::exists(file("end.png")) && report["position"] == 0; }, 120));
  CHECK(contents("begin.png") == contents("pointed.png"));
  const Read animation = played(contents("walk.gif"));
  REQUIRE(animation.frames.size() >= 3);
  for (const auto& [frame, picture] :
       {std::pair(&animation.frames.front(), "begin.png"), std::pair(&animation.frames.back(), "end.png")}) {
    CAPTURE(picture);
    const Errors near = errors(pixels(picture), frame->rgb, animation.width, 1),
                 far = errors(pixels(picture), frame->rgb, animation.width, 4);
    CAPTURE(near.mean, near.ninety_ninth, far.mean, far.ninety_ninth);
    CHECK(near.mean < 0.003);
    CHECK(near.ninety_ninth < 0.04);
    CHECK(far.ninety_ninth < 0.01);
  }

  raywalk.key("ctrl+e");
  REQUIRE(raywalk.until("prompt", "export"));
  raywalk.retype(file("slides.html"));
  raywalk.key("Return");
  REQUIRE(raywalk.until("prompt", ""));
  CHECK(contents("slides.html").starts_with("<!DOCTYPE html>"));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}
