// Walking, pointing, editing and predicting in the real window, by mouse and keys.

#include "gui/classic_walk.h"

using namespace raywalk;
using namespace raywalk::test;

using Json = nlohmann::json;

namespace {

int number(const Json& report, const char* member) { return report[member].get<int>(); }

}  // namespace

TEST_CASE("time travel in the window: over and out of SHADE, held, scrubbed, to a step by its number", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  const auto beyond = [&](int position) {
    return raywalk.until([=](const Json& report) { return number(report, "position") > position; });
  };
  const auto position = [&] { return number(raywalk.report(), "position"); };

  // To where SHADE is about to be called; over it, and back; into it and out of it end at the same step.
  raywalk.click("line-3");  // If intersect something
  REQUIRE(beyond(0));
  while (raywalk.report()["sentence"].get<std::string>().find("has to be shaded") == std::string::npos) {
    const int before = position();
    raywalk.click("line-3");
    REQUIRE(beyond(before));
  }
  const int call = position();
  raywalk.key("Down");
  REQUIRE(beyond(call + 2));
  const int after = position();
  raywalk.key("shift+Down");
  REQUIRE(raywalk.until("position", call));
  raywalk.key("Right");
  raywalk.key("Right");
  REQUIRE(raywalk.until("position", call + 2));
  raywalk.key("Up");
  REQUIRE(raywalk.until("position", after));

  // Held down it goes on, and let go it rests.
  const auto [x, y] = raywalk.place("step");
  raywalk.move_to(x, y);
  walk.hand({"mousedown", "1"});
  REQUIRE(beyond(after + 3));
  walk.hand({"mouseup", "1", "sleep", "0.3"});
  REQUIRE(raywalk.until([](const Json& report) { return report["window"]["idle"] == true; }));
  const auto later = [&] {
    walk.hand({"sleep", "0.4"});
    raywalk.until([](const Json&) { return true; });
    return position();
  };
  // A busy machine may be late to see that it was let go.
  int rested = position();
  for (int waits = 0; waits < 5 && later() != rested; ++waits) rested = position();
  CHECK(later() == rested);

  raywalk.click("scrub");
  const int steps = number(raywalk.report(), "steps");
  REQUIRE(raywalk.until(
      [=](const Json& report) { return std::abs(number(report, "position") - steps / 2) <= steps / 20; }));

  raywalk.key("j");
  REQUIRE(raywalk.until([](const Json& report) { return report["items"].contains("breakpoints-popup"); }));
  raywalk.type("100");
  raywalk.key("Return");
  REQUIRE(raywalk.until("position", 100));
  walk.keep_picture("w1-step-100");
  raywalk.key("Escape");
  REQUIRE(raywalk.until([](const Json& report) { return !report["items"].contains("breakpoints-popup"); }));
  raywalk.click("grain-pixel");
  REQUIRE(raywalk.until("grain", "pixel"));
  raywalk.click("step");
  REQUIRE(raywalk.until([](const Json& report) {
    return report["sentence"].get<std::string>().find("gets its final shade") != std::string::npos;
  }));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("a ray of the tree lights up where it is pointed at, and a click goes to it", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.click("tab-tree");
  REQUIRE(raywalk.until("tab", "tree"));
  raywalk.click("line-9");  // Form reflect ray
  REQUIRE(raywalk.until([](const Json& report) { return number(report, "rays") >= 3; }));
  const int last = number(raywalk.report(), "rays") - 1, position = number(raywalk.report(), "position");
  const std::string node = "node-" + std::to_string(last - 1);
  REQUIRE(raywalk.until([&](const Json& report) { return report["items"].contains(node); }));
  const auto [x, y] = raywalk.place(node);
  raywalk.move_to(x, y);
  REQUIRE(raywalk.until("hovered_ray", last - 1));
  walk.keep_picture("w2-hovered-ray");
  raywalk.click(node);
  REQUIRE(raywalk.until([=](const Json& report) { return number(report, "position") < position; }));
  CHECK(number(raywalk.report(), "rays") == last);
  raywalk.click("tab-equation");
  REQUIRE(raywalk.until("tab", "equation"));
  walk.keep_picture("w3-equation");
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("an object is added, named, moved by a number, removed, and all of it undone, in the window", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("m");
  REQUIRE(raywalk.until("mode", "move"));
  const auto objects = raywalk.report()["objects"].size();
  raywalk.click("add-solid-sphere");
  REQUIRE(raywalk.until([=](const Json& report) { return report["objects"].size() == objects + 1; }));
  raywalk.key("Return");
  raywalk.type("Moon");
  // Faster than frames: the next field gets the keyboard, what is selected there is replaced by what is typed after it,
  // and Enter counts it.
  walk.hand({"key", "--delay", "0", "Tab", "ctrl+a", "2", "BackSpace", "3", "Return"});
  REQUIRE(raywalk.until([](const Json& report) { return report["objects"].contains("Moon"); }));
  REQUIRE(raywalk.until([](const Json& report) { return report["objects"]["Moon"]["plan"][0] == 3.0; }));
  walk.keep_picture("w4-moon");
  // The number counted before Enter; the keyboard is the plan's again a frame after it.
  walk.hand({"sleep", "0.5"});
  raywalk.key("Right");
  REQUIRE(raywalk.until([](const Json& report) { return report["objects"]["Moon"]["plan"][0].get<double>() > 3; }));
  raywalk.key("Delete");
  REQUIRE(raywalk.until([=](const Json& report) { return report["objects"].size() == objects; }));
  for (int undone = 0; undone < 5; ++undone) raywalk.key("ctrl+z");
  REQUIRE(raywalk.until("undo", 0));
  CHECK(raywalk.report()["objects"].size() == objects);
  CHECK(raywalk.report()["dirty"] == false);
  raywalk.key("ctrl+y");
  REQUIRE(raywalk.until([=](const Json& report) { return report["objects"].size() == objects + 1; }));
  raywalk.key("ctrl+z");
  REQUIRE(raywalk.until("dirty", false));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("a ray is predicted in the window: the arrow is dragged, STEP shows the way it goes", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("ctrl+p");
  REQUIRE(walk.until("predictions", "on", true));
  raywalk.click("line-9");  // Form reflect ray: rests before it
  REQUIRE(walk.until("predictions", "asks", true));
  const Json& eye = raywalk.report()["eye"]["window"];
  const double x = eye[0].get<double>(), y = eye[1].get<double>();
  raywalk.drag(x + 60, y + 80, x + 40, y - 20);
  REQUIRE(walk.until("predictions", "open", true));
  walk.keep_picture("w5-guess");
  raywalk.click("step");
  REQUIRE(walk.until("predictions", "made", 1));
  walk.keep_picture("w6-answer");
  raywalk.key("ctrl+p");
  REQUIRE(walk.until("predictions", "on", false));
  raywalk.key("ctrl+q");  // the prediction is in no file
  REQUIRE(raywalk.until([](const Json& report) { return report["items"].contains("answer-1"); }));
  walk.keep_picture("w7-question");
  raywalk.click("answer-1");
  CHECK(raywalk.wait() == 0);
}
