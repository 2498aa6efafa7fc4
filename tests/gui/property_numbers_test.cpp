// Numbers that are typed into the properties, in every language.
#include <cmath>
#include <string>

#include "gui/folder.h"
#include "gui/properties_bench.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/text/text.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a number is typed") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  REQUIRE(std::holds_alternative<Sphere<double>>(bench.state.scene().objects[0].shape));
  type_into(bench, field("property.radius"), "0.875");
  CHECK(sphere(bench).radius == 0.875);
  type_into(bench, field("property.centre", "/1"), "-1.25");
  CHECK(sphere(bench).centre.y == -1.25);
  // A comma is what half the world types for the point.
  type_into(bench, field("property.radius"), "0,5");
  CHECK(sphere(bench).radius == 0.5);
  CHECK(bench.state.document.undo.size() == 3);
}

TEST_CASE(
    "where the language has a comma numbers are typed with it, or with a point, and what is left alone keeps its "
    "digits") {
  Bench bench(selected({TargetKind::object, 0}));
  update(bench.state, action::SetLanguage{"pt"});
  bench.frames(2);
  const std::string radius = "property/" + std::string(text("property.radius", in_portuguese));
  Scene scene = bench.state.scene();
  std::get<Sphere<double>>(scene.objects[0].shape).radius = 1.0 / 3;
  update(bench.state, action::SetShape{0, scene.objects[0].shape});
  bench.frames(2);
  bench.double_click(radius);
  bench.frames(3);
  bench.enter();
  CHECK(sphere(bench).radius == 1.0 / 3);
  type_into(bench, radius, "0,875");
  CHECK(sphere(bench).radius == 0.875);
  type_into(bench, radius, "0.5");
  CHECK(sphere(bench).radius == 0.5);
  // One digit more at the end of what stands there.
  bench.double_click(radius);
  bench.key("End");
  bench.type("25");
  bench.enter();
  CHECK((sphere(bench).radius == 0.525 || sphere(bench).radius == 25));
  type_into(bench, radius, "1,2,3");
  CHECK(sphere(bench).radius != 1);
  bench.frames(2);
  bench.drag(radius, 60, 0);
  CHECK(sphere(bench).radius > 0.5);
  // In the window a click begins the typing, and the second one selects the whole number.
  ImGui::GetIO().ConfigDragClickToInputText = true;
  type_into(bench, radius, "0,75");
  REQUIRE(sphere(bench).radius == 0.75);
  bench.frames(60);
  type_into(bench, radius, "0,5");
  CHECK(sphere(bench).radius == 0.5);
}

TEST_CASE("in every language a number means what stands there, and text that is none is refused") {
  for (const Language language : all_languages()) {
    CAPTURE(language.code());
    Bench bench(selected({TargetKind::object, 0}));
    bench.state.appearance.language = language;
    bench.frames(2);
    const std::string radius = "property/" + std::string(text("property.radius", language));
    const std::string y = "property/" + std::string(text("property.centre", language)) + "/1";
    type_into(bench, radius, "0.875");
    REQUIRE(sphere(bench).radius == 0.875);
    for (const auto& [typed, number] :
         {std::pair{"+1", 1.0}, {"+1", 1.0}, {"3/4", 0.75}, {"2e-1", 0.2}, {"1,5", 1.5}, {" 0.5 ", 0.5}}) {
      CAPTURE(typed);
      type_into(bench, radius, typed);
      CHECK(sphere(bench).radius == number);
      CHECK_FALSE(bench.has(radius + "/refused"));
    }
    type_into(bench, y, "\u22121");
    CHECK(sphere(bench).centre.y == -1);
    for (const char* const none : {"*2", "/4", "1.2.3", "12e", "abc", "1 2", "-"}) {
      CAPTURE(none);
      bench.double_click(radius);
      bench.type(none);
      CHECK(bench.has(radius + "/refused"));
      bench.enter();
      CHECK(sphere(bench).radius == 0.5);
    }
    // What is refused may become a number yet.
    bench.double_click(radius);
    bench.type("1e");
    CHECK(bench.has(radius + "/refused"));
    bench.type("0");
    CHECK_FALSE(bench.has(radius + "/refused"));
    CHECK(sphere(bench).radius == 1);
  }
}

TEST_CASE("a whole number is read in the same way") {
  Bench bench(selected({TargetKind::light, 0}));
  Light light = bench.state.scene().lights[0];
  light.kind = SphereLight{{0, 3, 0}, 1, 1, {}};
  update(bench.state, action::SetLight{0, light});
  bench.frames(2);
  const auto samples = [&] { return std::get<SphereLight>(bench.state.scene().lights[0].kind).samples; };
  const std::string item = field("property.light_samples");
  for (const auto& [typed, number] : {std::pair{"4", 4}, {"+1", 1}, {"8/2", 4}}) {
    CAPTURE(typed);
    type_into(bench, item, typed);
    CHECK(samples() == number);
  }
  for (const char* const none : {"*2", "2.5", "0", "\u22123"}) {
    CAPTURE(none);
    bench.double_click(item);
    bench.type(none);
    CHECK(bench.has(item + "/refused"));
    bench.enter();
    CHECK(samples() == 4);
  }
}

TEST_CASE("Escape gives back a typed number with all its digits") {
  Bench bench(selected({TargetKind::object, 0}));
  Scene scene = bench.state.scene();
  std::get<Sphere<double>>(scene.objects[0].shape).radius = 1.0 / 3;
  update(bench.state, action::SetShape{0, scene.objects[0].shape});
  bench.frames(2);
  bench.double_click(field("property.radius"));
  bench.type("3");
  REQUIRE(sphere(bench).radius == 3);
  bench.hold(ImGuiKey_Escape, true);
  bench.frames(1);
  bench.hold(ImGuiKey_Escape, false);
  bench.frames(2);
  CHECK(sphere(bench).radius == 1.0 / 3);
  CHECK(bench.state.document.undo.size() == 1);  // of the test's own
}

TEST_CASE("numbers outside the format's limits are not taken over") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const double before = sphere(bench).radius;
  for (const std::string number : {"-3", "0", "1e300", "nan", "inf", "hello"}) {
    CAPTURE(number);
    type_into(bench, field("property.radius"), number);
    CHECK(sphere(bench).radius == before);
  }
}

TEST_CASE("a number that grows too large while it is typed leaves the one that stood there") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const double before = sphere(bench).radius;
  bench.double_click(field("property.radius"));
  for (const char digit : std::string(16, '9')) bench.type(std::string(1, digit));
  bench.enter();
  CHECK(sphere(bench).radius == before);
}
