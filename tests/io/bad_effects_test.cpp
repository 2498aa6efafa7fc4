// The rules of lights with an extent, of lens and shutter, of lobes and of [render]: what breaks one is refused.

#include <string>
#include <vector>

#include "bad_scene.h"
#include "support/catch.h"

using namespace raywalk::test;

namespace {

/// `lines` of a light of this type; the first one is line 8.
std::string with_kind(const std::string& type, const std::string& lines) {
  return with_light("name = \"L\"\ntype = \"" + type + "\"\n" + lines);
}
/// `line` is line 5, within [camera].
std::string with_camera(const std::string& line) { return camera + line + "\n"; }
/// `line` is line 6.
std::string with_render(const std::string& line) { return camera + "[render]\n" + line + "\n"; }

}  // namespace

TEST_CASE("bad lights are refused at the place of their fault") {
  const std::string spot = "position = [0, 0, 3]\nlook_at = [0, 0, 0]\n";
  const std::vector<BadScene> scenes{
      {"spot without an axis", with_kind("spot", "position = [0, 0, 3]\n"), 5, 1,
       "look_at is missing in [[light]] \"L\"", ""},
      {"spot looks at itself", with_kind("spot", "position = [1, 2]\nlook_at = [1, 2, 0]\n"), 9, 11, "its own position",
       "middle"},
      {"spot of no width", with_kind("spot", spot + "angle = 0\n"), 10, 9, "above 0 and at most 180", ""},
      {"spot wider than half of space", with_kind("spot", spot + "angle = 180.5\n"), 10, 9, "found 180.5", ""},
      {"inner wider than outer", with_kind("spot", spot + "angle = 30\ninner_angle = 31\n"), 11, 15,
       "wider than the angle", "leave it out"},
      {"directional spot", with_kind("spot", "direction = [1, 0, 0]\n" + spot), 8, 1, "unknown key \"direction\"", ""},
      {"sphere light of negative radius", with_kind("sphere", "position = [0, 0]\nradius = -1\n"), 9, 10, "found -1",
       ""},
      {"sphere light without radius", with_kind("sphere", "position = [0, 0]\n"), 5, 1, "radius is missing", ""},
      {"no samples", with_kind("sphere", "position = [0, 0]\nradius = 1\nsamples = 0\n"), 10, 11,
       "a whole number from 1 to 256", ""},
      {"rectangle without an edge", with_kind("rectangle", "corner = [0, 0]\nu = [1, 0]\n"), 5, 1, "v is missing", ""},
      {"point light with samples", with_kind("point", "position = [0, 0]\nsamples = 2\n"), 9, 1,
       "unknown key \"samples\"", ""},
  };
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("bad lenses, shutters and lobes are refused at the place of their fault") {
  const std::vector<BadScene> scenes{
      {"negative aperture", with_camera("aperture = -0.1"), 5, 12, "a number that is 0 or more", ""},
      {"focus on the lens", with_camera("focus = 0"), 5, 9, "a number above 0", ""},
      {"shutter as a number", with_camera("shutter = 1"), 5, 11, "found 1 (expected [open, close])", ""},
      {"shutter of three times", with_camera("shutter = [0, 1, 2]"), 5, 11, "found a list of 3", ""},
      {"shutter closes first", with_camera("shutter = [1, 0.5]"), 5, 11, "closes before it opens", "freeze"},
      {"endless shutter", with_camera("shutter = [0, inf]"), 5, 15, "found inf", "finite"},
      {"negative gloss", with_material("gloss = -1"), 10, 22, "from 0 to 90", "sharp"},
      {"gloss of a full angle", with_material("gloss = 180"), 10, 22, "from 0 to 90", ""},
      {"translucency as a word", with_material("translucency = \"a lot\""), 10, 29, "from 0 to 90", "without quotes"},
      {"mirror of an unknown metal", with_material("mirror = \"tin\""), 10, 23, "\"gold\"", ""},
      {"metal that transmits", with_material("mirror = \"gold\", transmission = 1"), 10, 23, "expected \"ideal\"",
       "no light"},
      {"roughness above 1", with_material("roughness = 1.5"), 10, 26, "from 0 to 1", "polished"},
      {"rough glass of kr and kt", with_material("roughness = 0.1, transmission = 1"), 10, 26, "dielectric = true",
       "translucency"},
      {"rough and translucent glass",
       with_material("roughness = 0.1, transmission = 1, dielectric = true, translucency = 5"), 10, 26, "expected 0",
       "choose one"},
      {"diffuse roughness above 1", with_material("diffuse_roughness = 1.5"), 10, 34, "from 0 to 1", "Lambert"},
      {"roughness and gloss", with_material("roughness = 0.1, gloss = 5"), 10, 26, "expected 0", "choose one"},
      {"negative scattering", with_material("scattering = [0, -1, 0]"), 10, 31, "from 0 to 1e12", "never negative"},
      {"scattering that is no number", with_material("scattering = nan"), 10, 27, "found nan", "finite"},
      {"anisotropy of 1", with_material("anisotropy = 1"), 10, 27, "above -1 and below 1", "mean cosine"},
      {"anisotropy of -1", with_material("anisotropy = -1"), 10, 27, "above -1 and below 1", ""},
      {"anisotropy that is no number", with_material("anisotropy = nan"), 10, 27, "found nan", "finite"},
      {"misspelt scattering", with_material("scatering = 1"), 10, 14, "unknown key \"scatering\"", "scattering"},
      {"negative absorption", with_material("absorption = [0, -1, 0]"), 10, 31, "from 0 to 1e12", "never negative"},
      {"priority as a word", with_material("priority = \"high\""), 10, 25, "a number", "without quotes"},
      {"priority of all", with_material("priority = inf"), 10, 25, "found inf", "finite"},
      {"texture without a file", with_material("texture = { width = 1 }"), 10, 24, "file is missing", ""},
      {"texture of no width", with_material("texture = { file = \"a.png\", width = 0 }"), 10, 50, "above 0", ""},
      {"texture as text", with_material("texture = \"a.png\""), 10, 24, "a table", ""},
      {"texture file as a number", with_material("texture = { file = 1 }"), 10, 33, "the name of a file", "folder"},
      {"texture file without a name", with_material("texture = { file = \"\" }"), 10, 33, "the name of a file", ""},
  };
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("bad choices of rendering are refused at the place of their fault") {
  const std::vector<BadScene> scenes{
      {"misspelt integrator", with_render("integrator = \"whited\""), 6, 14, "found \"whited\"", "\"whitted\""},
      {"misspelt sampler", with_render("sampler = \"jitered\""), 6, 11, "found \"jitered\"", "\"jittered\""},
      {"no samples", with_render("samples = 0"), 6, 11, "a whole number from 1 to 1048576", ""},
      {"half a sample", with_render("samples = 1.5"), 6, 11, "a whole number", "decimal point"},
      {"grid of none", with_render("light_grid = 0"), 6, 14, "a whole number from 1 to 256", ""},
      {"negative tolerance", with_render("tolerance = -0.01"), 6, 13, "0 or more", ""},
      {"numerics of no kind", with_render("numerics = \"exact\""), 6, 12, "\"robust\" or \"naive\"", ""},
      {"negative epsilon", with_render("epsilon = -1e-4"), 6, 11, "0 or more", ""},
      {"paths of no ray", with_render("path_length = 0"), 6, 15, "a whole number from 1 to 1000", ""},
      {"depth in the wrong table", with_render("depth = 3"), 6, 1, "unknown key \"depth\" in [render]", ""},
  };
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("what may be left out has the values that the reference states") {
  const auto document = raywalk::parse_scene(
      with_light("name = \"S\"\ntype = \"spot\"\nposition = [0, 3]\nlook_at = [0, 0]\n"
                 "[[light]]\nname = \"R\"\ntype = \"rectangle\"\ncorner = [0, 0]\nu = [1, 0]\nv = [0, 1]\n"),
      "");
  REQUIRE(document);
  const raywalk::Scene& scene = document->scene;
  const auto& spot = std::get<raywalk::SpotLight>(scene.lights[0].kind);
  CHECK(spot.angle == 60);
  CHECK(spot.inner_angle == 40);
  CHECK(std::get<raywalk::RectangleLight>(scene.lights[1].kind).samples == 1);
  CHECK(scene.camera.aperture == 0);
  CHECK(scene.camera.focus_distance() == 1);  // as far as look_at
  CHECK(scene.camera.shutter_open == 0);
  CHECK(scene.camera.shutter_close == 1);
  CHECK(scene.render == raywalk::RenderChoices{});
}
