#include <cmath>
#include <set>
#include <string>

#include "gui/bench.h"
#include "gui/folder.h"
#include "image/image_file.h"
#include "io/key_reference.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/text/text.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Move mode with this thing selected.
State selected(Target target) {
  State state = classic();
  update(state, action::SetMode{Mode::move});
  update(state, action::Select{target});
  return state;
}

std::string field(std::string_view label, const char* rest = "") {
  return "property/" + std::string(text(label, in_english)) + rest;
}

// Double-clicks a number and types another one.
void type_into(Bench& bench, const std::string& item, const std::string& number) {
  bench.double_click(item);
  bench.type(number);
  bench.enter();
}

const Sphere<double>& sphere(const Bench& bench) {
  return std::get<Sphere<double>>(bench.state.scene().objects[0].shape);
}

}  // namespace

TEST_CASE("the code gives way to the properties of what is selected, and comes back") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  CHECK(bench.has("properties"));
  CHECK_FALSE(bench.has("code"));
  bench.click("deselect");
  bench.frames(2);
  CHECK(bench.has("code"));
  CHECK_FALSE(bench.has("properties"));
}

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

TEST_CASE("of a grey the first number is enough, and the others make it coloured") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const auto reflection = [&] { return bench.state.scene().objects[0].material.reflection; };
  REQUIRE((reflection().x == reflection().y && reflection().y == reflection().z));
  type_into(bench, field("property.reflection", "/0"), "0.75");
  CHECK(reflection() == Rgbd(0.75));
  type_into(bench, field("property.reflection", "/1"), "0.5");
  CHECK(reflection() == Rgbd(0.75, 0.5, 0.75));
  type_into(bench, field("property.reflection", "/0"), "0.25");
  CHECK(reflection() == Rgbd(0.25, 0.5, 0.75));
}

TEST_CASE("what is refused is explained below its field and gone when the field is left") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const double before = sphere(bench).radius;
  const std::string refused = field("property.radius", "/refused");
  bench.double_click(field("property.radius"));
  bench.type("-3");
  bench.frames(2);
  CHECK(bench.has(refused));
  bench.enter();
  CHECK(bench.has(refused));
  CHECK(sphere(bench).radius == before);
  // The next thing that is typed ends it.
  type_into(bench, field("property.centre", "/0"), "1.5");
  CHECK_FALSE(bench.has(refused));
  CHECK(sphere(bench).centre.x == 1.5);
  type_into(bench, field("property.radius"), "0.75");
  CHECK_FALSE(bench.has(refused));
  CHECK(sphere(bench).radius == 0.75);
}

TEST_CASE("what a property means is said where it stands") {
  for (const std::string_view id :
       {"property.ambient", "property.diffuse", "property.specular", "property.shininess", "property.reflection",
        "property.transmission", "property.ior", "property.dielectric", "property.priority", "property.shadow",
        "property.attenuation", "property.limits_depth", "property.threshold"})
    CHECK_FALSE(explanation(id, in_english).empty());
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  CHECK(bench.has(field("property.diffuse", "/label")));
}

TEST_CASE("every key of a scene that has a field has a name in the window") {
  // Those that only the scene's file gives.
  const std::set<std::string> without{
      "name",      "type",    "title",    "description", "transform", "motion", "file",   "holes",  "group", "vertices",
      "triangles", "normals", "uv",       "camera",      "screen",    "image",  "limits", "render", "light", "object",
      "width",     "height",  "encoding", "translated",  "ink",       "map",    "of",     "second"};
  for (const KeyTable& table : key_tables()) {
    if (table.name == "render" || table.name == "transform" || table.heading.starts_with("[[ink]]")) continue;
    for (const KeyEntry& key : table.keys) {
      INFO(table.name << "." << key.name);
      const Catalogue& texts = Language().catalogue();
      CHECK((without.count(key.name) == 1 || texts.find("property." + key.name) != nullptr ||
             texts.find("property." + table.name + "_" + key.name) != nullptr));
    }
  }
}

TEST_CASE("all that a material says has a field") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const auto material = [&] { return bench.state.scene().objects[0].material; };
  const auto scroll = [&](float clicks) {
    bench.point_at(field("property.reflection", "/label"));
    bench.wheel(clicks);
    bench.frames(10);
  };
  scroll(-4);
  type_into(bench, field("property.gloss"), "5");
  type_into(bench, field("property.translucency"), "2.5");
  type_into(bench, field("property.absorption", "/0"), "0.5");
  type_into(bench, field("property.priority"), "3");
  CHECK(material().gloss == 5);
  CHECK(material().translucency == 2.5);
  CHECK(material().absorption == Rgbd(0.5));
  CHECK(material().priority == 3);
  type_into(bench, field("property.gloss"), "91");
  CHECK(material().gloss == 5);
  scroll(-30);
  bench.click(field("property.checker"));
  REQUIRE(material().checker);
  bench.frames(2);
  bench.point_at(field("property.checker"));
  bench.wheel(-30);
  bench.frames(10);
  type_into(bench, field("property.size"), "2");
  CHECK(material().checker->size == 2);

  // A texture begins with the name of its file, which is read at once, and ends without one.
  const Folder folder;
  REQUIRE(write_image(folder / "wood.png", Image{1, 1, {Rgb<float>(0.5f)}}));
  const auto name_texture = [&](const std::string& file) {
    bench.point_at(field("property.size"));
    bench.wheel(-30);
    bench.frames(10);
    bench.click(field("property.texture"));
    bench.key("Ctrl+A");
    bench.type(file);
    bench.enter();
    bench.frames(2);
  };
  name_texture(folder / "none.png");
  CHECK_FALSE(material().texture);
  CHECK(bench.state.document.notice->kind == Notice::Kind::error);
  name_texture(folder / "wood.png");
  REQUIRE(material().texture);
  CHECK(material().texture->pixels->width == 1);
  bench.point_at(field("property.size"));
  bench.wheel(-30);
  bench.frames(10);
  type_into(bench, field("property.texture_width"), "4");
  CHECK(material().texture->width == 4);
  CHECK(material().texture->file == folder / "wood.png");
}

TEST_CASE("what a camera may leave out is stated, and left out again") {
  Bench bench(selected({TargetKind::eye}));
  const auto camera = [&]() -> const Camera& { return bench.state.scene().camera; };
  bench.frames(2);
  REQUIRE_FALSE(camera().focus);
  const double before = camera().focus_distance();
  bench.click(field("property.focus_set"));
  bench.frames(2);
  CHECK(camera().focus == before);
  type_into(bench, field("property.focus"), "2.5");
  CHECK(camera().focus == 2.5);
  bench.click(field("property.focus_set"));
  CHECK_FALSE(camera().focus);
  // The picture is as wide as before, whichever says so.
  REQUIRE(camera().screen.width);
  const double width = *camera().screen.width;
  bench.click(field("property.screen_width_set"));
  bench.frames(2);
  REQUIRE(camera().fov);
  CHECK_FALSE(camera().screen.width);
  CHECK(std::abs(camera().screen_width() - width) < 1e-12);
  bench.click(field("property.screen_width_set"));
  CHECK_FALSE(camera().fov);
  CHECK(std::abs(camera().screen.width.value_or(0) - width) < 1e-12);
}

TEST_CASE("lights of every kind have fields, and what breaks a rule is not taken over") {
  Bench bench(selected({TargetKind::light, 0}));
  Light light = bench.state.scene().lights[0];
  const auto show = [&](const auto& kind) {
    light.kind = kind;
    update(bench.state, action::SetLight{0, light});
    bench.frames(2);
  };
  const auto kind = [&] { return bench.state.scene().lights[0].kind; };
  show(SphereLight{{0, 3, 0}, 1, 1, {}});
  type_into(bench, field("property.radius"), "0.5");
  type_into(bench, field("property.light_samples"), "4");
  CHECK(std::get<SphereLight>(kind()).radius == 0.5);
  CHECK(std::get<SphereLight>(kind()).samples == 4);
  show(RectangleLight{{0, 3, 0}, {1, 0, 0}, {0, 1, 0}, 1, {}});
  type_into(bench, field("property.u", "/0"), "2");
  CHECK(std::get<RectangleLight>(kind()).u.x == 2);
  show(SpotLight{{0, 3, 0}, {0, 0, 0}, 60, 40, {}});
  type_into(bench, field("property.inner_angle"), "50");
  CHECK(std::get<SpotLight>(kind()).inner_angle == 50);
  type_into(bench, field("property.angle"), "45");  // narrower than what is lit in full
  CHECK(std::get<SpotLight>(kind()).angle == 60);
}

TEST_CASE("dragging a number is one entry of undo") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const double before = sphere(bench).radius;
  bench.drag(field("property.radius"), 60, 0);
  CHECK(sphere(bench).radius > before);
  CHECK(bench.state.document.undo.size() == 1);
  bench.drag(field("property.radius"), -30, 0);
  CHECK(bench.state.document.undo.size() == 2);
  bench.key("Ctrl+Z");
  bench.key("Ctrl+Z");
  CHECK(sphere(bench).radius == before);
}

TEST_CASE("materials are edited with numbers, boxes and a palette") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const auto material = [&] { return bench.state.scene().objects[0].material; };
  type_into(bench, field("property.diffuse", "/2"), "0.5");
  CHECK(material().diffuse.z == 0.5);
  const bool before = material().dielectric;
  bench.click(field("property.dielectric"));
  CHECK(material().dielectric != before);
  const Rgbd diffuse = material().diffuse;
  bench.click(field("property.diffuse", "/swatch"));
  const Rect picker = bench.rect(field("property.diffuse", "/palette"));
  bench.move_to(picker.x + picker.width / 4, picker.y + picker.height / 4);
  bench.press();
  bench.release();
  CHECK(material().diffuse != diffuse);
}

TEST_CASE("an object is renamed when the typing has ended, not letter by letter") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  bench.type("Moon");
  CHECK(bench.state.scene().objects[0].name == before);
  bench.enter();
  const std::string after = bench.state.scene().objects[0].name;
  CHECK(after != before);
  CHECK_THAT(after, contains("Moon"));
  CHECK(bench.state.document.undo.size() == 1);
}

TEST_CASE("a name keeps its characters when it is edited, as long as it may be and whatever they are") {
  std::string accents = "x";
  for (int i = 0; i < 49; ++i) accents += "\u00e9";
  for (const std::string& name : {accents, std::string("Luna \U0001F319")}) {
    CAPTURE(name);
    Bench bench(selected({TargetKind::object, 0}));
    update(bench.state, action::Rename{{TargetKind::object, 0}, name});
    REQUIRE(bench.state.scene().objects[0].name == name);
    bench.frames(2);
    bench.double_click(field("property.name"));
    bench.hold(ImGuiKey_End, true);
    bench.frames(1);
    bench.hold(ImGuiKey_End, false);
    bench.type("!");
    bench.enter();
    const std::string now = bench.state.scene().objects[0].name;
    // A field that cannot hold them takes no edit.
    CHECK((now == name + "!" || (name != accents && now == name)));
    if (name == accents) CHECK(now == name + "!");
  }
}

TEST_CASE("a name that is pasted and too long is told to be so, and the old one stays") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  ImGui::SetClipboardText(std::string(300, 'a').c_str());
#if IMGUI_VERSION_NUM < 18700
  const auto hold_ctrl = [](bool down) { ImGui::GetIO().KeyCtrl = down; };
#else
  const auto hold_ctrl = [](bool down) { ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, down); };
#endif
  hold_ctrl(true);
  bench.frames(1);
  for (const ImGuiKey_ key : {ImGuiKey_A, ImGuiKey_V}) {  // in place of all that stands there
    bench.hold(key, true);
    bench.frames(1);
    bench.hold(key, false);
    bench.frames(1);
  }
  hold_ctrl(false);
  bench.frames(1);
  bench.enter();
  REQUIRE(bench.last<action::Rename>() != nullptr);
  CHECK(bench.last<action::Rename>()->name == std::string(300, 'a'));
  CHECK(bench.state.scene().objects[0].name == before);
  REQUIRE(bench.state.document.notice);
  CHECK_THAT(bench.state.document.notice->text, contains("300"));
}

TEST_CASE("a name with characters that the field cannot hold is not taken without them") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  bench.type("\U0001F319");
  bench.enter();
  const std::string now = bench.state.scene().objects[0].name;
  CHECK((now == before || now.find("\U0001F319") != std::string::npos));
  if (now == before) {
    REQUIRE(bench.state.document.notice);
    CHECK(bench.state.document.notice->text == text("notice.refused_name_letters", in_english));
  }
}

TEST_CASE("commands that no field has a use for take over what was typed, and then act") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const auto name = [&] { return bench.state.scene().objects[0].name; };
  bench.double_click(field("property.name"));
  bench.type("Moo");
  bench.forget();
  // Its last letter comes with the same frame as the key.
  ImGui::GetIO().AddInputCharactersUTF8("n");
  bench.key("Ctrl+S");
  CHECK_THAT(name(), contains("Moon"));
  REQUIRE(bench.actions.size() >= 2);
  CHECK(bench.actions[0].is<action::Rename>());
  CHECK(bench.actions[1].is<action::Save>());
  CHECK(bench.state.document.prompt == PathPrompt::save_as);
  update(bench.state, action::CancelPrompt{});
  bench.frames(3);

  bench.double_click(field("property.radius"));
  bench.type("0.75");
  bench.key("Ctrl+O");
  CHECK(sphere(bench).radius == 0.75);
  CHECK(bench.state.document.prompt == PathPrompt::open);
  update(bench.state, action::CancelPrompt{});
  bench.frames(3);

  // What edits text stays the field's.
  bench.double_click(field("property.name"));
  bench.type("Mars");
  bench.forget();
  for (const char* const key : {"Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+Shift+Left", "Shift+K"}) bench.key(key);
  CHECK(bench.actions.empty());
  CHECK(ImGui::GetIO().WantTextInput);
}

TEST_CASE("a name that is being typed when the window is closed is asked about, and saved") {
  const Folder folder;
  Bench bench(selected({TargetKind::object, 0}));
  update(bench.state, action::SaveAs{folder / "mine.toml"});
  REQUIRE_FALSE(bench.state.document.dirty);
  bench.frames(2);
  bench.double_click(field("property.name"));
  bench.type("Moon");
  bench.interface().act_after_typing(action::Quit{});
  bench.frames(3);
  CHECK_FALSE(bench.state.document.quit);
  REQUIRE(bench.state.document.question);
  CHECK(bench.state.document.question->kind == Question::Kind::unsaved);
  update(bench.state, action::AnswerQuestion{action::Answer::save});
  CHECK(bench.state.document.quit);
  CHECK_THAT(read_scene(folder / "mine.toml")->scene.objects[0].name, contains("Moon"));
}

TEST_CASE("where nothing is typed the window is closed at once") {
  Bench bench;
  bench.frames(2);
  bench.interface().act_after_typing(action::Quit{});
  bench.frames(1);
  CHECK(bench.state.document.quit);
}

TEST_CASE("letters typed into a field are not commands") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  bench.double_click(field("property.name"));
  bench.forget();
  bench.key("C");
  bench.key("Delete");
  bench.key("Space");
  CHECK(bench.last<action::Clear>() == nullptr);
  CHECK(bench.last<action::RemoveSelected>() == nullptr);
  CHECK(bench.last<action::Step>() == nullptr);
}

TEST_CASE("the keyboard gets into the properties") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  bench.key("Enter");
  bench.frames(3);
  CHECK(ImGui::GetIO().WantTextInput);
}

TEST_CASE("lights, the camera and the scene have properties") {
  Bench bench(selected({TargetKind::light, 0}));
  bench.frames(2);
  type_into(bench, field("property.strength", "/0"), "0.25");
  CHECK(bench.state.scene().lights[0].strength.x == 0.25);
  type_into(bench, field("property.attenuation", "/1"), "0.125");
  CHECK(std::get<PointLight>(bench.state.scene().lights[0].kind).attenuation.linear == 0.125);

  update(bench.state, action::Select{{TargetKind::eye}});
  bench.frames(2);
  type_into(bench, field("property.screen_distance"), "1.75");
  CHECK(bench.state.scene().camera.screen.distance == 1.75);
  type_into(bench, field("property.background", "/0"), "0.5");
  CHECK(bench.state.scene().background.x == 0.5);
  // What is further down is scrolled to.
  bench.point_at(field("property.background", "/0"));
  bench.wheel(-30);
  bench.frames(10);
  type_into(bench, field("property.threshold"), "0.02");
  CHECK(bench.state.scene().limits.threshold == 0.02);
  // Whole numbers have buttons beside them, and what is typed takes the place of what stood there.
  type_into(bench, field("property.limits_depth"), "12");
  CHECK(bench.state.scene().limits.depth == 12);
  type_into(bench, field("property.limits_depth"), "0");
  CHECK(bench.state.scene().limits.depth == 12);
  bench.point_at(field("property.limits_depth"));
  bench.wheel(30);
  bench.frames(10);
  type_into(bench, field("property.screen_cells"), "33");
  CHECK(bench.state.scene().camera.screen.cells == 33);
}
