// Course scenes with one fault each.

#include "bad_text.h"
#include "io/test_format_reader.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Two lines.
const std::string head = "size 8 6\ncamera 0 0 4 0 0 0 0 1 0 30\n";
std::string after_head(const std::string& lines) { return head + lines; }  // from line 3
std::string with_camera(const std::string& line) { return "size 8 6\n" + line + "\n"; }
const std::string corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";  // lines 3 to 5

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("course format: every fault is refused at its line, with what was expected and a hint") {
  const std::vector<BadText> texts{
      {"empty", "", 0, "the file is empty"},
      {"blanks only", "\r\n \t\r\n", 0, "the file is empty"},
      {"binary", std::string("size 8 6\n\0", 10), 2, "the byte 0x00"},
      {"gzip", "\x1f\x8b\x08", 1, "the byte 0x1f"},
      {"comments only", "# nothing\n", 2, "there is no size"},
      {"no size", "camera 0 0 4 0 0 0 0 1 0 30\n", 2, "there is no size"},
      {"no camera", "size 8 6\n", 2, "there is no camera"},
      {"two cameras", after_head("camera 0 0 4 0 0 0 0 1 0 30\n"), 3, "a second camera"},
      {"two sizes", after_head("size 8 6\n"), 3, "there is a second size (expected one)"},
      {"size 0", "size 0 6\n", 1, "found \"0\" (expected a whole number from 1"},
      {"a negative size", "size 8 -6\n", 1, "found \"-6\""},
      {"half a size", "size 8\n", 1, "the line ends here (expected a whole number"},
      {"a size of three numbers", "size 8 6 1\n", 1, "found \"1\" (expected the end of the line)"},
      {"a huge size", "size 32000 32000\n", 1, "32000 x 32000 pixels"},
      {"a size of words", "size eight six\n", 1, "found \"eight\""},
      {"a camera cut short", with_camera("camera 0 0 4 0 0 0 0 1 0"), 2, "the line ends here"},
      {"a camera over two lines", with_camera("camera 0 0 4\n0 0 0 0 1 0 30"), 2, "the line ends here"},
      {"a camera that looks at itself", with_camera("camera 1 2 3 1 2 3 0 1 0 30"), 2, "where it stands"},
      {"up along the view", with_camera("camera 0 0 4 0 0 0 0 0 1 30"), 2, "up is parallel to the view"},
      {"up of length 0", with_camera("camera 0 0 4 0 0 0 0 0 0 30"), 2, "has length 0"},
      {"an angle of 180", with_camera("camera 0 0 4 0 0 0 0 1 0 180"), 2, "found \"180\""},
      {"a negative angle", with_camera("camera 0 0 4 0 0 0 0 1 0 -3"), 2, "found \"-3\""},
      {"NaN", with_camera("camera nan 0 4 0 0 0 0 1 0 30"), 2, "found \"nan\""},
      {"infinity", with_camera("camera -inf 0 4 0 0 0 0 1 0 30"), 2, "found \"-inf\""},
      {"a number too large", with_camera("camera 1e300 0 4 0 0 0 0 1 0 30"), 2, "at most 1e+15"},
      {"a negative depth", after_head("maxdepth -1\n"), 3, "found \"-1\""},
      {"a depth of a million", after_head("maxdepth 1000000\n"), 3, "a whole number from 0 to 999"},
      {"an unknown command", after_head("cube 1\n"), 3, "unknown command cube (expected size, maxdepth"},
      {"a misspelt command", after_head("shpere 0 0 0 1\n"), 3, "unknown command shpere"},
      {"a command in capitals", after_head("SPHERE 0 0 0 1\n"), 3, "unknown command SPHERE"},
      {"a command of many letters", after_head(std::string(100'000, 'x')), 3, "unknown command of many letters"},
      {"a sphere without radius", after_head("sphere 0 0 0\n"), 3, "the line ends here"},
      {"a sphere of radius 0", after_head("sphere 0 0 0 0\n"), 3, "found \"0\" (expected a number above 0"},
      {"a negative radius", after_head("sphere 0 0 0 -1\n"), 3, "found \"-1\""},
      {"a vertex of two numbers", after_head("vertex 0 0\n"), 3, "the line ends here"},
      {"a triangle before its vertices", after_head("tri 0 1 2\n"), 3, "there is no vertex yet"},
      {"an index too large", after_head(corners + "tri 0 1 3\n"), 6,
       "found \"3\" (expected a whole number from 0 to 2)"},
      {"a negative index", after_head(corners + "tri 0 1 -1\n"), 6, "found \"-1\""},
      {"an index of 20 digits", after_head(corners + "tri 0 1 99999999999999999999\n"), 6,
       "a whole number from 0 to 2"},
      {"a broken index", after_head(corners + "tri 0 1 1.5\n"), 6, "found \"1.5\""},
      {"an index into the other list", after_head(corners + "trinormal 0 1 2\n"), 6, "there is no vertex yet"},
      {"a quad", after_head(corners + "tri 0 1 2 0\n"), 6, "expected the end of the line"},
      {"pop without push", after_head("popTransform\n"), 3, "popTransform without a pushTransform"},
      {"one pop too many", after_head("pushTransform\npopTransform\npopTransform\n"), 5, "popTransform without"},
      {"a push with a number", after_head("pushTransform 1\n"), 3, "expected the end of the line"},
      {"endless pushes", after_head(repeated("pushTransform\n", 20'000)), 10'003, "too many pushTransform"},
      {"scale 0", after_head("scale 1 0 1\n"), 3, "a factor is 0"},
      {"a scale that vanishes", after_head(repeated("scale 1e-15 1e-15 1e-15\n", 30) + "sphere 0 0 0 1\n"), 33,
       "the current matrix flattens the object"},
      {"a scale beyond numbers", after_head(repeated("scale 1e15 1e15 1e15\n", 30) + "sphere 0 0 0 1\n"), 33,
       "the current matrix flattens the object, or its numbers have become too large"},
      {"a rotation about nothing", after_head("rotate 0 0 0 30\n"), 3, "has length 0"},
      {"a rotation without an angle", after_head("rotate 0 0 1\n"), 3, "the line ends here"},
      {"an attenuation of nothing", after_head("attenuation 0 0 0\n"), 3, "all three terms"},
      {"a negative attenuation", after_head("attenuation 1 -1 0\n"), 3, "found \"-1\""},
      {"a light without colour", after_head("point 0 0 1\n"), 3, "the line ends here"},
      {"a light of negative colour", after_head("point 0 0 1 -1 0 0\n"), 3, "found \"-1\""},
      {"a direction of length 0", after_head("directional 0 0 0 1 1 1\n"), 3, "has length 0"},
      {"a light in no direction",
       after_head("scale 1e-15 1e-15 1e-15\nscale 1e-15 1e-15 1e-15\ndirectional 0 0 1 1 1 1\n"), 5,
       "leaves the light no direction"},
      {"a light too far away", after_head(repeated("scale 1e15 1 1\n", 2) + "point 1 0 0 1 1 1\n"), 5, "too far away"},
      {"a negative shininess", after_head("shininess -1\n"), 3, "found \"-1\""},
      {"a diffuse beyond measure", after_head("diffuse 1 2000 1\n"), 3,
       "found \"2000\" (expected a number from 0 to 1000)"},
      {"a specular beyond measure", after_head("specular 1e12 1 1\n"), 3, "(expected a number from 0 to 1000)"},
      {"an emission beyond measure", after_head("emission 1e13 1 1\n"), 3, "(expected a number from 0 to 1e12)"},
      {"a light beyond measure", after_head("point 0 0 0 1e13 1 1\n"), 3, "(expected a number from 0 to 1e12)"},
      {"a grey ambient", after_head("ambient 1\n"), 3, "the line ends here"},
      {"vertices of negative number", after_head("maxverts -1\n"), 3, "found \"-1\""},
  };
  CHECK(texts.size() >= 40);
  for (const BadText& bad : texts) check_refused(parse_test_format, bad);
}

TEST_CASE("course format: what the bad files are made from is fine") {
  for (const std::string& text :
       {head, after_head(corners + "tri 0 1 2\n"), after_head("sphere 0 0 0 1\nmaxdepth 0\n")}) {
    const auto document = parse_test_format(text, "good.test");
    INFO(text << (document ? "" : document.error().text()));
    CHECK(document);
  }
  const auto misspelt = parse_test_format(after_head("shpere 0 0 0 1\n"), "bad.test");
  REQUIRE(!misspelt);
  CHECK_THAT(misspelt.error().hint, contains("did you mean sphere?"));
}
