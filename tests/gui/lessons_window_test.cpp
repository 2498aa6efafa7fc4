// Lessons in the real window: as a student goes through one, and as a teacher presents one. Pictures are kept as
// window_test.cpp's are.

#include <filesystem>
#include <fstream>
#include <iterator>

#include "gui/classic_walk.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

using Json = nlohmann::json;

namespace {

std::string contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The middle of a body, light or eye of the scene, in the window.
std::pair<double, double> middle_of(const Json& at) {
  return {at["window"][0].get<double>(), at["window"][1].get<double>()};
}

}  // namespace

TEST_CASE("lesson 1 in the window, as a student finishes it: by click, by key, by arrow and by number", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("F2");
  REQUIRE(walk.until("lesson", "open", ""));
  // The second one is locked, and says so.
  raywalk.click("lesson/02-ray-meets-sphere");
  REQUIRE(raywalk.until([](const Json& report) { return report["notice"].get<std::string>().find("Locked") == 0; }));
  CHECK(raywalk.report()["lesson"]["open"] == "");
  raywalk.click("lesson/01-ray-casting");
  REQUIRE(walk.until("lesson", "open", "01-ray-casting"));
  raywalk.click("lesson-next");
  REQUIRE(walk.until("lesson", "step", 2));
  // STEP shows no answer before there is a prediction.
  const Json asked = raywalk.report()["position"];
  raywalk.click("step");
  REQUIRE(raywalk.until([](const Json& report) { return report["notice"].get<std::string>().find("Predict") == 0; }));
  CHECK(raywalk.report()["position"] == asked);
  raywalk.click("guess/2");
  raywalk.click("lesson-reveal");
  REQUIRE(walk.until("lesson", "revealed", true));
  CHECK(raywalk.report()["lesson"]["right"] == 1);
  walk.keep_picture("l1-choice");
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "step", 3));
  raywalk.key("3");
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "revealed", true));
  CHECK(raywalk.report()["lesson"]["right"] == 2);
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "step", 4));
  const auto [x, y] = middle_of(raywalk.report()["objects"]["Polygon"]);
  const auto [to_x, to_y] = middle_of(raywalk.report()["lights"]["Light Source"]);
  raywalk.drag(x, y, to_x, to_y);
  REQUIRE(walk.until("lesson", "aimed", true));
  walk.keep_picture("l2-arrow");
  raywalk.click("step");
  REQUIRE(walk.until("lesson", "revealed", true));
  CHECK(raywalk.report()["lesson"]["right"] == 3);
  walk.keep_picture("l3-answer");
  raywalk.click("lesson-next");
  REQUIRE(walk.until("lesson", "step", 5));
  REQUIRE(raywalk.until([](const Json& report) { return report["items"].contains("lesson-number"); }));
  raywalk.type("21");
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "revealed", true));
  CHECK(raywalk.report()["lesson"]["right"] == 4);
  CHECK(raywalk.report()["lesson"]["judged"] == 4);
  walk.keep_picture("l4-number");
  raywalk.click("lesson-next");
  REQUIRE(walk.until("lesson", "open", ""));
  CHECK(raywalk.report()["path"].get<std::string>().ends_with("classic.toml"));
  // It is done: the next one opens.
  raywalk.click("lesson/02-ray-meets-sphere");
  REQUIRE(walk.until("lesson", "open", "02-ray-meets-sphere"));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("lesson 5 in the window, as a teacher presents it: hands, notes, script, language, projector", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("F2");
  REQUIRE(walk.until("lesson", "open", ""));
  raywalk.click("lesson-presenter");
  REQUIRE(walk.until("lesson", "presenter", true));
  raywalk.click("lesson/05-refraction");
  REQUIRE(walk.until("lesson", "open", "05-refraction"));
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "revealed", true));
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "step", 2));
  for (const char* hand : {"3", "3", "1", "3", "shift+3"}) raywalk.key(hand);
  REQUIRE(walk.until("lesson", "hands", Json::array({1, 0, 2})));
  raywalk.click("hand-more/2");
  REQUIRE(walk.until("lesson", "hands", Json::array({1, 1, 2})));
  raywalk.click("lesson-reveal");
  REQUIRE(walk.until("lesson", "revealed", true));
  walk.keep_picture("l5-presenter");
  raywalk.click("lesson-notes");
  REQUIRE(walk.until("lesson", "notes", false));
  raywalk.click("lesson-script");
  REQUIRE(raywalk.until("prompt", "export"));
  walk.keep_picture("l6-script");
  const std::string path = (walk.folder() / "five.script.html").string();
  raywalk.retype(path);
  raywalk.key("Return");
  REQUIRE(raywalk.until("prompt", ""));
  CHECK(contents(path).find("Slower, so steeper") != std::string::npos);
  raywalk.key("ctrl+l");
  REQUIRE(raywalk.until("language", "pt"));
  raywalk.key("p");
  REQUIRE(raywalk.until("theme", "projector"));
  raywalk.key("ctrl+equal");
  REQUIRE(raywalk.until([](const Json& report) { return report["ui_scale"].get<double>() > 1; }));
  walk.keep_picture("l7-projector");
  // Closed, one's own scene stands there again.
  raywalk.click("lesson-close");
  REQUIRE(raywalk.until([](const Json& report) { return !report.contains("lesson"); }));
  CHECK(raywalk.report()["path"].get<std::string>().ends_with("classic.toml"));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}
