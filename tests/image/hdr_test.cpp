// Radiance's pictures: every coding of a row, and what is wrong with one.

#include <string>
#include <vector>

#include "image/image_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::string head(int width, int height, const std::string& more = "FORMAT=32-bit_rle_rgbe\n") {
  return "#?RADIANCE\n# by hand\n" + more + "\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}
std::string bytes(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}
// Red 1, green 0.5, blue 0.25; then black; then 3 and the like.
const std::vector<int> one{128, 64, 32, 129}, none{0, 0, 0, 0}, three{192, 192, 192, 130};

Rgb<float> pixel(const std::vector<int>& rgbe) {
  const auto image = decode_hdr(head(1, 1) + bytes(rgbe), "one.hdr");
  REQUIRE(image);
  return image->at(0, 0);
}

}  // namespace

TEST_CASE("a mantissa each and one exponent make a colour") {
  CHECK(pixel(one) == Rgb<float>(1, 0.5F, 0.25F));
  CHECK(pixel(none) == Rgb<float>(0));
  CHECK(pixel(three) == Rgb<float>(3));
  CHECK(pixel({200, 100, 50, 0}) == Rgb<float>(0));
  CHECK(pixel({255, 0, 0, 255}).x == 255.0F * 0x1p119F);
  CHECK(pixel({128, 0, 0, 1}).x == 0x1p-128F);
}

TEST_CASE("a picture is the radiance before what its head says that it was multiplied by") {
  const std::string format = "FORMAT=32-bit_rle_rgbe\n";
  const auto read = [&](const std::string& lines) { return decode_hdr(head(1, 1, lines) + bytes(one), "a.hdr"); };
  const auto is = [&](const std::string& lines, const Rgb<float>& light) {
    INFO(lines);
    const auto image = read(lines);
    REQUIRE(image);
    CHECK(image->at(0, 0) == light);
  };
  is("EXPOSURE=1.0000000000000\n" + format, {1, 0.5F, 0.25F});
  is("EXPOSURE=4\n" + format, {0.25F, 0.125F, 0.0625F});
  is(format + "EXPOSURE= 2.0000e+00\r\nEXPOSURE=.25\n", {2, 1, 0.5F});  // all of them
  is(format + "COLORCORR= 0.5 1 2\nEXPOSURE=2\n", {1, 0.25F, 0.0625F});
  is(format + "\tEXPOSURE=4\n# EXPOSURE=4\npfilt -e 4\n", {1, 0.5F, 0.25F});  // of what it was made from, and words
  is(format + "EXPOSURE=3\n", {1.0F / 3, 0.5F / 3, 0.25F / 3});
  for (const std::string line : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=", "EXPOSURE=bright", "EXPOSURE=1 2",
                                 "EXPOSURE=1e999", "COLORCORR=1 1", "COLORCORR=1 1 0"}) {
    INFO(line);
    const auto image = read(format + line + "\n");
    REQUIRE_FALSE(image);
    CHECK_THAT(image.error().message, contains("it says " + line + " (expected"));
  }
}

TEST_CASE("rows are plain, repeated in the old way, or coded channel by channel") {
  const auto plain = decode_hdr(head(2, 2) + bytes(one) + bytes(none) + bytes(three) + bytes(one), "a.hdr");
  REQUIRE(plain);
  CHECK(plain->at(1, 1) == Rgb<float>(1, 0.5F, 0.25F));
  CHECK(plain->at(0, 1) == Rgb<float>(3));
  // Once, then five times the same, then 1 + 256 times.
  const auto old = decode_hdr(head(6, 1) + bytes(one) + bytes({1, 1, 1, 5}), "a.hdr");
  REQUIRE(old);
  CHECK(old->at(5, 0) == old->at(0, 0));
  const auto long_row = decode_hdr(head(258, 1) + bytes(one) + bytes({1, 1, 1, 1, 1, 1, 1, 1}), "a.hdr");
  REQUIRE(long_row);
  CHECK(long_row->at(257, 0) == Rgb<float>(1, 0.5F, 0.25F));
  // Nine pixels: each channel a run of eight and one by itself.
  std::string row = bytes({2, 2, 0, 9});
  for (int channel = 0; channel < 4; ++channel)
    row += bytes({128 + 8, one[static_cast<std::size_t>(channel)], 1, three[static_cast<std::size_t>(channel)]});
  const auto coded = decode_hdr(head(9, 1) + row, "a.hdr");
  REQUIRE(coded);
  CHECK(coded->at(7, 0) == Rgb<float>(1, 0.5F, 0.25F));
  CHECK(coded->at(8, 0) == Rgb<float>(3));
}

TEST_CASE("what is no whole Radiance picture is refused, and says why") {
  const std::string good = head(9, 1) + bytes({2, 2, 0, 9});
  const std::vector<std::pair<std::string, std::string>> bad{
      {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "its head does not end"},
      {head(1, 1, "FORMAT=32-bit_rle_xyze\n") + bytes(one), "FORMAT=32-bit_rle_rgbe"},
      {head(0, 1), "its size is wrong"},
      {head(-3, 1), "its size is wrong"},
      {"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n+X 1 +Y 1\n" + bytes(one), "its size is wrong"},
      {head(100000, 100000) + bytes(one), "its size is wrong"},
      {head(2, 1) + bytes(one), "row 0"},
      {head(2, 2) + bytes(one) + bytes(one) + bytes(one), "row 1"},
      {head(2, 1) + bytes({1, 1, 1, 2}), "row 0"},               // nothing to repeat
      {head(2, 1) + bytes(one) + bytes({1, 1, 1, 2}), "row 0"},  // beyond the row
      {good + bytes({128 + 10, 5}), "row 0"},
      {good + bytes({0}), "row 0"},
      {good + bytes({128 + 9}), "row 0"},
      {good, "row 0"}};
  for (const auto& [text, why] : bad) {
    const auto image = decode_hdr(text, "bad.hdr");
    INFO(why);
    REQUIRE_FALSE(image);
    CHECK(image.error().file == "bad.hdr");
    CHECK_THAT(image.error().message, contains(why));
    CHECK(!image.error().hint.empty());
  }
}

TEST_CASE("a Radiance picture is known by its first bytes") {
  const TemporaryFolder folder;
  put(folder.file("sky.any"), head(1, 1) + bytes(three));
  const auto image = read_image(folder.file("sky.any"));
  REQUIRE(image);
  CHECK(image->at(0, 0) == Rgb<float>(3));
}
