// What is wrong with a scene is refused with its line, its column, what was expected and a hint.

#include <string>
#include <vector>

#include "bad_scene.h"
#include "io/scene_file.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::vector<BadScene> bad_scenes() {
  using namespace std::string_literals;
  const std::string two_balls = "centre = [0, 0]\nradius = 1\n[[object]]\nname = \"Ball\"\n";
  std::vector<BadScene> scenes{
      // Not a scene at all.
      {"empty", "", 1, 1, "empty (expected a scene in TOML)", "classic.toml"},
      {"blank", " \n\t\r\n\n", 1, 1, "empty", "classic.toml"},
      {"only a comment", "# nothing\n", 1, 1, "camera is missing", "add camera"},
      {"binary",
       "\x7f"
       "ELF\x02\x01\0\0\0"s,
       1, 7, "binary file", "right file"},
      {"a picture", "\x89PNG\r\n\x1a\n", 1, 1, "byte 0x89 is not UTF-8", "UTF-8"},
      {"Latin-1", camera + "[[object]]\nname = \"caf\xe9\"\n", 6, 12, "byte 0xe9 is not UTF-8", "encoding"},
      {"overlong UTF-8", "title = \"\xc0\xaf\"\n", 1, 10, "0xc0", "UTF-8"},
      {"half a surrogate", "title = \"\xed\xa0\x80\"\n", 1, 10, "0xed", "UTF-8"},
      {"cut in a character", "title = \"\xe6\xbc", 1, 10, "0xe6", "UTF-8"},
      {"UTF-16", "\xff\xfe[\0c\0"s, 1, 1, "UTF-16", "encoding"},
      {"another format: NFF", "v\nfrom 2.1 1.3 1.7\n", 1, 0, "not valid TOML", "KEY = VALUE"},
      {"another format: JSON", "{ \"camera\": {} }", 1, 0, "not valid TOML", "KEY = VALUE"},
      {"letter outside of quotes", camera + "n\xc3\xa9 = 1\n", 5, 2, "U+00E9 stands outside of quotes", "quotes"},
      {"no-break space", camera + "up =\xc2\xa0[0, 0, 1]\n", 5, 5, "U+00A0", "type it anew"},
      {"typographic quotes", "title = \xe2\x80\x9cT\xe2\x80\x9d\n", 1, 9, "U+201C", "quotes"},
      {"quote after a number", camera + "fov_axis = 1\"\xc3\xa9\"\n", 5, 14, "U+00E9", ""},
      {"emoji", "\xf0\x9f\x98\x80\n", 1, 1, "U+1F600", ""},
      // Not TOML.
      {"no value", camera + "fov_axis =\n", 5, 0, "not valid TOML", "KEY = VALUE"},
      {"header without a name", "[=]\n", 1, 0, "not valid TOML", ""},
      {"open list", camera + "up = [0, 0\n", 5, 0, "not valid TOML", "brackets"},
      {"open text", "title = \"half\n" + camera, 1, 0, "not valid TOML", "quotes"},
      {"key twice", camera + "fov = 50\n", 5, 0, "redefine", ""},
      {"table twice", camera + "[camera]\n", 5, 0, "redefine", ""},
      {"number too large for a double", camera + "up = [0, 0, 1e999]\n", 5, 0, "1e999", "as large as 1e308"},
      {"whole number too large", camera + "up = [0, 0, 9223372036854775808]\n", 5, 0, "64 bits", "as large as 1e308"},
      {"deep lists", "x = " + repeated("[", 100'000), 1, 0, "nested", ""},
      {"deep tables", "x = " + repeated("{a=", 100'000), 1, 0, "nested", ""},
      {"deep dotted key", "x = 1\n" + repeated("a.", 100'000) + "b = 1\n", 2, 130, "nested too deeply", "three levels"},
      {"deep header", "[" + repeated("a.", 100'000) + "b]\n", 1, 131, "nested too deeply", "three levels"},
      {"deep quoted header", "[[" + repeated("\"#\".", 100'000) + "b]]\n", 1, 262, "nested too deeply", ""},
      // Keys.
      {"unknown key", camera + "zoom = 2\n", 5, 1, "unknown key \"zoom\" in [camera]", "info --keys"},
      {"misspelt key", camera + "[limits]\ndeph = 3\n", 6, 1, "unknown key \"deph\"", "did you mean \"depth\"?"},
      {"American key", with_sphere("center = [0, 0]\nradius = 1\n"), 8, 1, "\"center\"", "\"centre\"?"},
      {"key in capitals", camera + "Up = [0, 0, 1]\n", 5, 1, "\"Up\"", "\"up\"?"},
      {"unknown table", camera + "[lens]\n", 5, 2, "unknown key \"lens\" (expected title, ", ""},
      {"misspelt table", camera + "[[objects]]\n", 5, 3, "unknown key \"objects\"", "\"object\"?"},
      {"key of another shape",
       with_object("name = \"F\"\ntype = \"plane\"\npoint = [0, 0]\nradius = 1\nnormal = [0, 1]\n"), 9, 1,
       "unknown key \"radius\" in [[object]] \"F\"", ""},
      {"first of two unknown keys", camera + "zz = 1\naa = 1\n", 5, 1, "\"zz\"", ""},
      {"include", "include = \"other.toml\"\n" + camera, 1, 1, "unknown key \"include\"", ""},
      {"table as a value", "camera = 3\n", 1, 10, "camera: found 3 (expected a table)", "[camera]"},
      {"table as a list", "[[camera]]\neye = [0, 0]\n", 1, 1, "found a list of 1 (expected a table)", "not [[camera]]"},
      {"one table for many", camera + "[object]\nname = \"A\"\n", 5, 1, "expected [[object]] tables", "two brackets"},
      {"list of numbers for tables", "light = [1, 2]\n" + camera, 1, 9, "light: found a list of 2", "[[light]]"},
      {"mixed list for tables", "light = [{ name = \"A\" }, 2]\n" + camera, 1, 9, "light: found a list of 2", ""},
      // The camera.
      {"no camera", "title = \"T\"\n", 1, 1, "camera is missing", "info --keys"},
      {"no eye", "[camera]\nlook_at = [1, 0]\nfov = 45\n", 1, 1, "eye is missing in [camera]", "add eye = "},
      {"no angle and no width", "[camera]\neye = [0, 0]\nlook_at = [1, 0]\n", 1, 1, "no width", "fov = 45"},
      {"angle and width", camera + "[screen]\nwidth = 2\n", 6, 9, "only one of them", "remove width"},
      {"axis without angle", "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov_axis = \"x\"\n", 1, 1, "fov is missing",
       ""},
      {"unknown axis", camera + "fov_axis = \"z\"\n", 5, 12, "found \"z\" (expected \"x\" or \"y\")", ""},
      {"eye is look_at", "[camera]\neye = [2, 0]\nlook_at = [2, 0, 0]\nfov = 45\n", 3, 11, "the same point", "move"},
      {"up along the view", camera + "up = [2, 0, 0]\n", 5, 6, "parallel to the view", "[0, 1, 0]"},
      {"straight down", "[camera]\neye = [0, 0, 1]\nlook_at = [0, 0]\nfov = 45\n", 3, 11, "parallel", "[0, 1, 0]"},
      {"no up", camera + "up = [0, 0, 0]\n", 5, 6, "direction of length 0", "only where it points"},
      {"angle 0", "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 0\n", 4, 7, "found 0 (expected an angle", "45"},
      {"angle 180", "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 180\n", 4, 7, "below 180", "45"},
      {"point with one number", "[camera]\neye = [1]\n", 2, 7, "eye of [camera]: found a list of 1 (expected [x, y]",
       ""},
      {"point with four numbers", "[camera]\neye = [1, 2, 3, 4]\n", 2, 7, "found a list of 4", "x to the right"},
      {"point as a number", "[camera]\neye = 7\n", 2, 7, "found 7 (expected [x, y]", ""},
      {"word in a point", "[camera]\neye = [1, \"2\"]\n", 2, 11, "found \"2\" (expected a number)", "without quotes"},
      {"not a number", "[camera]\neye = [nan, 0]\n", 2, 8, "found nan (expected a number)", "finite"},
      {"infinity", "[camera]\neye = [0, -inf]\n", 2, 11, "found -inf", "finite"},
      {"too far away", "[camera]\neye = [0, 2e15]\n", 2, 11, "(expected at most 1e+15)", "another unit"},
      {"screen at the eye", camera + "[screen]\ndistance = 0\n", 6, 12,
       "distance of [screen]: found 0 (expected a number above 0)", "0.5"},
      {"screen too near", camera + "[screen]\ndistance = 1e-16\n", 6, 12, "(expected at least 1e-15)", "another unit"},
      {"no cells", camera + "[screen]\ncells = 0\n", 6, 9, "found 0 (expected a whole number from 1 to", ""},
      {"half a cell", camera + "[screen]\ncells = 20.5\n", 6, 9, "found 20.5 (expected a whole number",
       "decimal point"},
      {"cells with a decimal point", camera + "[screen]\ncells = 21.0\n", 6, 9, "found 21.0 (expected a whole number",
       "decimal point"},
      // The image and the limits.
      {"no columns", camera + "[image]\nwidth = 0\n", 6, 9, "width of [image]: found 0", ""},
      {"negative rows", camera + "[image]\nheight = -5\n", 6, 10, "found -5", ""},
      {"more columns than an int holds", camera + "[image]\nwidth = 99999999999\n", 6, 9, "found 99999999999", ""},
      {"too many pixels", camera + "[image]\nwidth = 32000\nheight = 32000\n", 7, 10, "32000 x 32000 pixels",
       "narrower"},
      {"depth 0", camera + "[limits]\ndepth = 0\n", 6, 9, "found 0 (expected a whole number from 1 to 1000)", ""},
      {"depth as a text", camera + "[limits]\ndepth = \"5\"\n", 6, 9, "found \"5\"", "without quotes"},
      {"negative threshold", camera + "[limits]\nthreshold = -0.1\n", 6, 13,
       "found -0.1 (expected a number that is 0 or more)", ""},
      // Lights.
      {"light without a name", with_light("type = \"point\"\nposition = [0, 0]\n"), 5, 1,
       "name is missing in [[light]] number 1", ""},
      {"light without a type", with_light("name = \"L\"\nposition = [0, 0]\n"), 5, 1,
       "type is missing in [[light]] \"L\" (expected point, directional, spot, sphere or rectangle)",
       "type = \"point\""},
      {"misspelt type key", with_light("name = \"L\"\ntyp = \"point\"\n"), 7, 1, "unknown key \"typ\"", "\"type\"?"},
      {"misspelt type", with_light("name = \"L\"\ntype = \"piont\"\n"), 7, 8, "found \"piont\"", "\"point\"?"},
      {"light without a position", with_light("name = \"L\"\ntype = \"point\"\n"), 5, 1,
       "position is missing in [[light]] \"L\"", ""},
      {"light without a direction", with_light("name = \"L\"\ntype = \"directional\"\ndirection = [0, 0]\n"), 8, 13,
       "length 0", ""},
      {"negative strength", with_light("name = \"L\"\ntype = \"point\"\nposition = [0, 0]\nstrength = [1, -1, 0]\n"), 9,
       16, "strength of [[light]] \"L\": found -1", "never negative"},
      {"light without measure", with_light("name = \"L\"\ntype = \"point\"\nposition = [0, 0]\nstrength = 1e13\n"), 9,
       12, "(expected a number from 0 to 1e12)", ""},
      {"more than the light that arrives",
       with_object(
           "name = \"A\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\nmaterial = { transmission = 1e12 }\n"),
       10, 29, "(expected a number from 0 to 1000)", "0 to 1"},
      {"a pattern that adds light",
       with_object("name = \"A\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"
                   "material = { checker = { odd = [0, 1e4, 0] } }\n"),
       10, 36, "(expected a number from 0 to 1000)", ""},
      {"endless emission",
       with_object("name = \"A\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\nmaterial = { emission = 2e12 }\n"),
       10, 25, "(expected a number from 0 to 1e12)", ""},
      {"infinite light", with_light("name = \"L\"\ntype = \"point\"\nposition = [0, 0]\nattenuation = [0, 0, 0]\n"), 9,
       15, "all three terms are 0", "[1, 0, 0]"},
      {"two terms", with_light("name = \"L\"\ntype = \"point\"\nposition = [0, 0]\nattenuation = [1, 0]\n"), 9, 15,
       "[constant, linear, quadratic]", ""},
      {"negative term", with_light("name = \"L\"\ntype = \"point\"\nposition = [0, 0]\nattenuation = [1, -1, 0]\n"), 9,
       19, "found -1", ""},
      // Objects.
      {"unknown shape", with_object("name = \"A\"\ntype = \"cube\"\n"), 7, 8,
       "found \"cube\" (expected \"sphere\", \"plane\"", "choose one"},
      {"type as a number", with_object("name = \"A\"\ntype = 3\n"), 7, 8, "type of [[object]] \"A\": found 3",
       "quotes"},
      {"no name", with_object("name = \"\"\n"), 6, 8, "found \"\" (expected one line of text", ""},
      {"name of blanks", with_object("name = \"  \"\n"), 6, 8, "expected one line of text", ""},
      {"name of two lines", with_object("name = \"a\\nb\"\n"), 6, 8, "expected one line of text", ""},
      {"long name", with_object("name = \"" + repeated("n", 101) + "\"\n"), 6, 8, "found a long text", "Solid Sphere"},
      {"name as a list", with_object("name = [\"a\"]\n"), 6, 8, "found a list of 1", ""},
      {"name used twice", with_sphere(two_balls), 11, 8, "\"Ball\" is already used in line 6", "different name"},
      {"name of a light", with_light("name = \"A\"\ntype = \"point\"\nposition = [0, 0]\n[[object]]\nname = \"A\"\n"),
       10, 8, "already used in line 6", ""},
      {"no radius", with_sphere("centre = [0, 0]\n"), 5, 1, "radius is missing in [[object]] \"Ball\"", "add radius"},
      {"radius 0", with_sphere("centre = [0, 0]\nradius = 0\n"), 9, 10,
       "radius of [[object]] \"Ball\": found 0 (expected a number above 0)", ""},
      {"radius -0.0", with_sphere("centre = [0, 0]\nradius = -0.0\n"), 9, 10, "found -0", ""},
      {"negative radius", with_sphere("centre = [0, 0]\nradius = -1\n"), 9, 10, "found -1", ""},
      {"radius is not a number", with_sphere("centre = [0, 0]\nradius = nan\n"), 9, 10, "found nan", "finite"},
      {"tiny radius", with_sphere("centre = [0, 0]\nradius = 5e-324\n"), 9, 10, "at least 1e-15", ""},
      {"radius as a date", with_sphere("centre = [0, 0]\nradius = 1979-05-27\n"), 9, 10, "found a date", ""},
      {"plane without a direction", with_object("name = \"F\"\ntype = \"plane\"\npoint = [0, 0]\nnormal = [0, 0, 0]\n"),
       9, 10, "length 0", ""},
      {"two corners", with_polygon("[[0, 0], [1, 0]]"), 8, 11, "3 to 1000 corners", "once around"},
      {"corner in space", with_polygon("[[0, 0], [1, 0], [1, 1, 1]]"), 8, 28, "a corner [x, y]", ""},
      {"corner is not a number", with_polygon("[[0, 0], [1, 0], [1, nan]]"), 8, 32, "found nan", "finite"},
      {"edges cross", with_polygon("[[0, 0], [1, 1], [1, 0], [0, 1]]"), 8, 11, "crosses", "once around"},
      {"equal corners", with_polygon("[[0, 0], [1, 1], [1, 1], [0, 1]]"), 8, 11, "the same point", ""},
      {"flat polygon", with_polygon("[[0, 0], [1, 0], [2, 0]]"), 8, 11, "fold back", ""},
      {"corners as numbers", with_polygon("[0, 0, 1, 0, 1, 1]"), 8, 12, "a corner [x, y]", ""},
      {"too many corners", with_polygon("[" + repeated("[0, 0],", 1001) + "]"), 8, 11, "3 to 1000 corners", ""},
      {"height 0", with_polygon("[[0, 0], [1, 0], [1, 1]]\nheight = 0"), 9, 10, "found 0", ""},
      // Materials.
      {"material by name", with_sphere("centre = [0, 0]\nradius = 1\nmaterial = \"glass\"\n"), 10, 12,
       "found \"glass\" (expected a table)", "[material]"},
      {"misspelt reflection", with_material("reflektion = 0.5"), 10, 14,
       "unknown key \"reflektion\" in material of [[object]] \"Ball\"", "\"reflection\"?"},
      {"negative share", with_material("diffuse = -0.5"), 10, 24,
       "diffuse of material of [[object]] \"Ball\": found -0.5", ""},
      {"colour of two", with_material("diffuse = [1, 1]"), 10, 24, "[red, green, blue]", ""},
      {"colour as a word", with_material("diffuse = \"red\""), 10, 24, "found \"red\"", ""},
      {"index of refraction 0", with_material("ior = 0"), 10, 20, "found 0 (expected a number above 0)", ""},
      {"negative shininess", with_material("shininess = -1"), 10, 26, "found -1", ""},
      {"dielectric as a number", with_material("dielectric = 1"), 10, 27, "found 1 (expected true or false)", ""},
      {"unknown shadow", with_material("shadow = \"none\""), 10, 23, "expected \"opaque\" or \"filtered\"", ""},
      {"checker of size 0", with_material("checker = { size = 0 }"), 10, 33, "size of checker of material", ""},
      {"an image's filter of a checker", with_material("checker = { filter = \"ewa\" }"), 10, 35,
       "expected \"none\" or \"closed\"", ""},
      {"checker as a flag", with_material("checker = true"), 10, 24, "found true (expected a table)", ""},
      {"title as a number", "title = 3\n" + camera, 1, 9, "title: found 3 (expected text in quotes)", ""},
      {"endless title", "title = \"" + repeated("t", 10'001) + "\"\n" + camera, 1, 9, "at most 10000 bytes", ""},
  };
  return scenes;
}

}  // namespace

TEST_CASE("the scene that the bad ones are made from is fine") {
  const auto scene = parse_scene(with_polygon("[[0, 0], [1, 0], [1, 1]]"), "good.toml");
  INFO((scene ? "" : scene.error().text()));
  REQUIRE(scene);
  CHECK(scene->warnings.empty());
}

TEST_CASE("bad scenes are refused at the place of their fault") {
  const std::vector<BadScene> scenes = bad_scenes();
  CHECK(scenes.size() >= 100);
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("a scene that is too large is refused before it is parsed") {
  const auto scene = parse_scene(std::string(std::size_t{17} << 20, '#'), "large.toml");
  REQUIRE(!scene);
  CHECK_THAT(scene.error().message, contains("too large for a scene (expected at most 16 MiB)"));
}

TEST_CASE("a material that makes light is warned about, by name and place") {
  const std::string sum = "diffuse = [0.5, 0.7, 0.5]\nspecular = 0.2\nreflection = 0.2\n";
  const std::string ball = with_sphere("centre = [0, 0]\nradius = 1\n[object.material]\n" + sum);
  const auto bright = parse_scene(ball, "bright.toml");
  REQUIRE(bright);
  REQUIRE(bright->warnings.size() == 1);
  CHECK_THAT(bright->warnings[0], contains("bright.toml:5:1: warning: \"Ball\" sends out more light"));
  CHECK_THAT(bright->warnings[0], contains("1.1 in its largest channel"));
  // 0.7 + 0.1 + 0.2 is above 1 in floating point, and still all right.
  const auto full = parse_scene(with_material("diffuse = 0.7, specular = 0.1, reflection = 0.2"), "full.toml");
  REQUIRE(full);
  CHECK(full->warnings.empty());
}
