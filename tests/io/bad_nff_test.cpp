// NFF files with one fault each.

#include "bad_text.h"
#include "io/nff_reader.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Seven lines.
const std::string view = "v\nfrom 0 -5 1\nat 0 0 1\nup 0 0 1\nangle 40\nhither 1\nresolution 64 48\n";
const std::string matter = "f 1 1 1 1 0 0 0 0\n";  // line 8 after the view

std::string after_view(const std::string& lines) { return view + lines; }             // from line 8
std::string after_matter(const std::string& lines) { return view + matter + lines; }  // from line 9

std::string without(const std::string& key) {
  std::string text = view;
  const std::size_t begin = text.find(key);
  return text.erase(begin, text.find('\n', begin) + 1 - begin);
}
std::string with(const std::string& key, const std::string& line) {
  std::string text = view;
  const std::size_t begin = text.find(key);
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

}  // namespace

TEST_CASE("NFF: every fault is refused at its line, with what was expected and a hint") {
  const std::string million_digits(1'000'000, '7');
  const std::vector<BadText> texts{
      {"empty", "", 0, "the file is empty"},
      {"blanks only", " \n\t\r\n", 0, "the file is empty"},
      {"binary", std::string("v\nfrom\0 1", 9), 2, "the byte 0x00"},
      {"an ELF header",
       std::string("\x7f"
                   "ELF",
                   4),
       1, "the byte 0x7f"},
      {"PNG", "\x89PNG\r\n\x1a\n", 2, "the byte 0x1a"},
      {"comments only", "# nothing\n# at all\n", 3, "there is no view"},
      {"no view", "l 1 2 3\n", 2, "there is no view"},
      {"two views", view + view, 8, "a second view (expected one)"},
      {"no from", without("from"), 1, "from is missing in the view"},
      {"no at", without("at"), 1, "at is missing in the view"},
      {"no up", without("up"), 1, "up is missing in the view"},
      {"no angle", without("angle"), 1, "angle is missing in the view"},
      {"no resolution", without("resolution"), 1, "resolution is missing in the view"},
      {"cut short", "v\nfrom 0 0", 2, "the file ends here (expected a number)"},
      {"cut within a word", "v\nfrom 0 0 0\nat 1 0 0\nup 0 0 1\nang", 1, "angle is missing in the view"},
      {"at is from", with("at", "at 0 -5 1"), 1, "looks at the point where it stands"},
      {"up along the view", with("up", "up 0 1 0"), 1, "up is parallel to the view"},
      {"up of length 0", with("up", "up 0 0 0"), 4, "the direction has length 0"},
      {"angle 0", with("angle", "angle 0"), 5, "found \"0\" (expected an angle in degrees above 0 and below 180)"},
      {"angle 180", with("angle", "angle 180"), 5, "found \"180\""},
      {"angle as a word", with("angle", "angle wide"), 5, "found \"wide\""},
      {"half a resolution", with("resolution", "resolution 64"), 8, "the file ends here"},
      {"resolution 0", with("resolution", "resolution 0 48"), 7, "found \"0\" (expected a whole number from 1"},
      {"a broken resolution", with("resolution", "resolution 64.5 48"), 7, "found \"64.5\""},
      {"a huge resolution", with("resolution", "resolution 32768 32768"), 7, "32768 x 32768 pixels"},
      {"resolution of 20 digits", with("resolution", "resolution 99999999999999999999 1"), 7, "a whole number from 1"},
      {"NaN", with("from", "from nan 0 0"), 2, "found \"nan\" (expected a number)"},
      {"infinity", with("from", "from 0 inf 0"), 2, "found \"inf\""},
      {"a number too large", with("from", "from 1e16 0 0"), 2, "expected at most 1e+15"},
      {"a number beyond double", with("from", "from 1e999 0 0"), 2, "expected at most 1e+15"},
      {"a hexadecimal number", with("from", "from 0x10 0 0"), 2, "found \"0x10\""},
      {"a number with a comma", with("from", "from 1,5 0 0"), 2, "found \"1,5\""},
      {"a number with two points", with("from", "from 1.2.3 0 0"), 2, "found \"1.2.3\""},
      {"only a sign", with("from", "from - 0 0"), 2, "found \"-\""},
      {"a number of a million digits", with("from", "from " + million_digits + " 0 0"), 2, "found a long word"},
      {"an unknown item", after_view("q 1 2 3\n"), 8, "unknown item q (expected v, b, l, f, s, c, p or pp)"},
      {"a keyword of another version", after_view("tpp 3\n"), 8, "unknown item tpp"},
      {"a number too many", after_matter("s 0 0 0 1 5\n"), 9, "unknown item 5"},
      {"a word of many letters", after_view(std::string(100'000, 'x')), 8, "unknown item of many letters"},
      {"an object before the first material", after_view("s 0 0 0 1\n"), 8, "before the first material"},
      {"a light of one number", after_view("l 1\n"), 9, "the file ends here"},
      {"a light of negative colour", after_view("l 1 2 3 -1 0 0\n"), 8,
       "found \"-1\" (expected a number from 0 to 1e12"},
      {"a light of half a colour", after_view("l 1 2 3 1 0\ns 0 0 0 1"), 9, "found \"s\""},
      {"a background without blue", after_view("b 1 0\nl 1 2 3\n"), 9, "found \"l\""},
      {"a negative Kd", after_view("f 1 1 1 -1 0 0 0 0\n"), 8, "Kd of f: found \"-1\""},
      {"a material of seven numbers", after_view("f 1 1 1 1 0 0 0\ns 0 0 0 1\n"), 9, "found \"s\""},
      {"glass of index 0", after_view("f 1 1 1 0 0 0 1 0\n"), 8, "the index of refraction of f: found \"0\""},
      {"a colour beyond measure", view + "f 2000 1 1 1 0 0 0 1\n", 8,
       "found \"2000\" (expected a number from 0 to 1000)"},
      {"a share beyond measure", view + "f 1 1 1 1 0 0 1e12 1\n", 8, "(expected a number from 0 to 1000)"},
      {"a product beyond measure", view + "f 500 1 1 5 0 0 0 1\n", 8, "more than a thousand times the light"},
      {"a light beyond measure", view + "l 0 0 1 1e13 1 1\n", 8, "(expected a number from 0 to 1e12)"},
      {"a sphere of radius 0", after_matter("s 0 0 0 0\n"), 9, "the radius of s is 0"},
      {"a sphere without radius", after_matter("s 0 0 0\n"), 10, "the file ends here"},
      {"a cone without height", after_matter("c 1 1 1 2 1 1 1 1\n"), 9, "base and apex are the same point"},
      {"a cone of two tips", after_matter("c 0 0 0 0 0 0 1 0\n"), 9, "both radii are 0"},
      {"an endless cone", after_matter("c 0 0 0 1e-15 1e15 0 0 0\n"), 9, "too slender"},
      {"a polygon of two corners", after_matter("p 2 0 0 0 1 0 0\n"), 9, "a whole number from 3 to 10000"},
      {"a polygon of a billion corners", after_matter("p 1000000000 0 0 0\n"), 9, "found \"1000000000\""},
      {"a polygon of negative corners", after_matter("p -3 0 0 0\n"), 9, "found \"-3\""},
      {"a polygon cut short", after_matter("p 4 0 0 0 1 0 0 1 1 0\n"), 10, "the file ends here"},
      {"a patch without normals", after_matter("pp 3 0 0 0 1 0 0 1 1 0\n"), 10, "the file ends here"},
  };
  CHECK(texts.size() >= 40);
  for (const BadText& bad : texts) check_refused(parse_nff, bad);
}

TEST_CASE("NFF: a whole number out of range is told from one that is not written as one") {
  for (const auto& [corners, hint] : {std::pair("2", "choose one in this range"),
                                      {"-3", "choose one in this range"},
                                      {"20000000000", "choose one in this range"},
                                      {"3.0", "plain digits"}}) {
    const auto document = parse_nff(after_matter("p " + std::string(corners) + " 0 0 0 1 0 0\n"), "bad.nff");
    REQUIRE(!document);
    INFO(document.error().text());
    CHECK_THAT(document.error().hint, contains(hint));
  }
}

TEST_CASE("NFF: what the bad files are made from is fine") {
  for (const std::string& text : {view, after_view("l 1 2 3\n"), after_matter("s 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\n")}) {
    const auto document = parse_nff(text, "good.nff");
    INFO(text << (document ? "" : document.error().text()));
    CHECK(document);
  }
}

TEST_CASE("NFF: a line of a million numbers and a million lines are read in no time") {
  const std::size_t balls = sanitized ? 25'000 : 200'000;
  std::string line = view + matter, lines = view + matter;
  for (std::size_t i = 0; i < balls; ++i) line += "s 0 0 0 1 ";
  for (std::size_t i = 0; i < balls; ++i) lines += "s 0 0 0 1\n";
  for (const std::string& text : {line, lines, line + "s 0 0 0 x"}) {
    const auto document = parse_nff(text, "long.nff");
    CHECK(document.has_value() == (text.back() != 'x'));
    if (document) CHECK(document->scene.objects.size() == balls);
  }
}
