// The rules of each shape and of transforms: what breaks one is refused at its place.

#include <string>
#include <vector>

#include "bad_scene.h"
#include "support/catch.h"

using namespace raywalk::test;

namespace {

/// `lines` of an object of this type; the first one is line 8.
std::string with_shape(const std::string& type, const std::string& lines) {
  return with_object("name = \"S\"\ntype = \"" + type + "\"\n" + lines);
}
/// The steps stand in line 10.
std::string with_steps(const std::string& steps) {
  return with_sphere("centre = [0, 0]\nradius = 1\ntransform = " + steps + "\n");
}

}  // namespace

TEST_CASE("bad shapes are refused at the place of their fault") {
  const std::string square = "corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]\n";
  const std::vector<BadScene> scenes{
      {"box inside out", with_shape("box", "min = [0, 0, 0]\nmax = [1, -1, 1]\n"), 9, 7, "beyond the other",
       "smallest"},
      {"box without a corner", with_shape("box", "min = [0, 0, 0]\n"), 5, 1, "max is missing in [[object]] \"S\"", ""},
      {"cone without radii", with_shape("cone", "z_max = 1\n"), 5, 1, "radii is missing", ""},
      {"radius 0", with_shape("cone", "radii = 0\n"), 8, 9, "found 0 (expected one number above 0", "[1, 2, 0.5]"},
      {"one radius 0", with_shape("ellipsoid", "radii = [1, 0, 1]\n"), 8, 13, "found 0", ""},
      {"two radii", with_shape("ellipsoid", "radii = [1, 2]\n"), 8, 9, "found a list of 2", ""},
      {"infinite radius", with_shape("cylinder", "radii = inf\n"), 8, 9, "found inf", "finite"},
      {"limits change places", with_shape("cylinder", "radii = 1\nz_min = 1\nz_max = -1\n"), 10, 9,
       "nothing is left between z_min and z_max", "leave them out"},
      {"equal limits", with_shape("cylinder", "radii = 1\nz_min = 1\nz_max = 1\n"), 10, 9, "nothing is left", ""},
      {"infinite limit", with_shape("cylinder", "radii = 1\nz_max = inf\n"), 9, 9, "found inf", "finite"},
      {"capped as a number", with_shape("cylinder", "radii = 1\ncapped = 1\n"), 9, 10,
       "found 1 (expected true or false)", ""},
      {"cap of a sphere", with_shape("sphere", "centre = [0, 0]\nradius = 1\ncapped = true\n"), 10, 1,
       "unknown key \"capped\"", ""},
      {"disk without direction", with_shape("disk", "centre = [0, 0]\nradius = 1\nnormal = [0, 0, 0]\n"), 10, 10,
       "length 0", ""},
      {"disk of radius 0", with_shape("disk", "centre = [0, 0]\nradius = 0\nnormal = [0, 0, 1]\n"), 9, 10, "found 0",
       ""},
      {"triangle on a line", with_shape("triangle", "a = [0, 0]\nb = [1, 1]\nc = [2, 2]\n"), 10, 5, "on one line",
       "move one"},
      {"triangle of two corners", with_shape("triangle", "a = [0, 0]\nb = [1, 1]\n"), 5, 1, "c is missing", ""},
      {"flat polygon of two corners", with_shape("flat_polygon", "corners = [[0, 0, 0], [1, 0, 0]]\n"), 8, 11,
       "found a list of 2", "such as"},
      {"flat polygon in the plan", with_shape("flat_polygon", "corners = [[0, 0], [1, 0], [1, 1]]\n"), 8, 12,
       "a corner [x, y, z]", ""},
      {"bent polygon", with_shape("flat_polygon", "corners = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]\n"), 8, 11,
       "", "one plane"},
      {"polygon without area", with_shape("flat_polygon", "corners = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\n"), 8, 11, "",
       "area"},
      {"holes as corners", with_shape("flat_polygon", square + "holes = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n"), 9, 11,
       "", ""},
      {"hole as a number", with_shape("flat_polygon", square + "holes = 1\n"), 9, 9, "a list of holes", ""},
      {"hole off the plane", with_shape("flat_polygon", square + "holes = [[[0, 0, 1], [0.5, 0, 1], [0, 0.5, 1]]]\n"),
       8, 11, "", "one plane"},
      {"steps as a word", with_steps("\"up\""), 10, 13, "found \"up\" (expected a list of at most",
       "the first is done"},
      {"one step without its list", with_steps("[\"translate\", 1, 0, 0]"), 10, 14, "expected steps such as", ""},
      {"misspelt step", with_steps("[[\"rotat\", 0, 0, 1, 30]]"), 10, 15, "found \"rotat\"", "\"rotate\"?"},
      {"too few numbers", with_steps("[[\"rotate\", 0, 0, 1]]"), 10, 14, "[\"rotate\", x, y, z, degrees]", "turns"},
      {"word among the numbers", with_steps("[[\"translate\", 0, \"y\", 1]]"), 10, 31, "found \"y\"", ""},
      {"scale 0", with_steps("[[\"scale\", 1, 0, 1]]"), 10, 14, "flattens the object", "no scale may be 0"},
      {"no axis", with_steps("[[\"translate\", 1, 0, 0], [\"rotate\", 0, 0, 0, 30]]"), 10, 38, "flattens", ""},
      {"no mirror", with_steps("[[\"mirror\", 0, 0, 0]]"), 10, 14, "flattens", ""},
      {"shear to a plane", with_steps("[[\"shear\", 1, 0, 1, 0, 0, 0]]"), 10, 14, "flattens", ""},
      {"matrix without depth", with_steps("[[\"matrix\", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0]]"), 10, 14, "flattens",
       ""},
      {"matrix not a number", with_steps("[[\"matrix\", nan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]]"), 10, 25, "found nan",
       ""},
  };
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("the pieces that the bad shapes are made from are fine") {
  for (const std::string& text :
       {with_shape("box", "min = [0, 0, 0]\nmax = [1, 1, 0]\n"), with_shape("cylinder", "radii = 1\nz_max = 1\n"),
        with_shape("triangle", "a = [0, 0]\nb = [1, 1]\nc = [2, 0]\n"),
        with_steps("[[\"scale\", 1, -1, 1], [\"rotate\", 0, 0, 1, 30]]"), with_steps("[]")}) {
    const auto scene = raywalk::parse_scene(text, "good.toml");
    INFO(text << (scene ? "" : scene.error().text()));
    CHECK(scene);
  }
}
