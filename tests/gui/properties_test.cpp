#include <cmath>
#include <set>
#include <string>

#include "gui/folder.h"
#include "gui/properties_bench.h"
#include "image/image_file.h"
#include "io/key_reference.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/text/text.h"

using namespace raywalk;
using namespace raywalk::test;

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
