#include "image/image_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/file.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Numbers that 16 bits or a curve would change.
Image sample() {
  Image image{5, 3, {}};
  for (int i = 0; i < 15; ++i) {
    const float x = static_cast<float>(i);
    image.pixels.emplace_back(x / 7, 1e-20F * x, 1e20F * x + 0.1F);
  }
  image.at(4, 2) = {-1.5F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::denorm_min()};
  return image;
}

/// One pixel with these channels, in the order of their names: 1, 2, 3 and so on.
std::string exr_of(const std::vector<std::string>& names) {
  const auto number = [](auto value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
  const std::string zero(1, '\0'), window(16, '\0');
  std::string channels, pixel;
  for (std::size_t i = 0; i < names.size(); ++i) {
    channels += names[i] + zero + number(std::int32_t{2}) + std::string(4, '\0') + number(std::int64_t{0x100000001});
    pixel += number(static_cast<float>(i + 1));
  }
  const auto attribute = [&](const std::string& name, const std::string& type, const std::string& value) {
    return name + zero + type + zero + number(static_cast<std::int32_t>(value.size())) + value;
  };
  const std::string head =
      "\x76\x2f\x31\x01" + number(std::int32_t{2}) + attribute("channels", "chlist", channels + zero) +
      attribute("compression", "compression", zero) + attribute("dataWindow", "box2i", window) +
      attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", zero) +
      attribute("pixelAspectRatio", "float", number(1.0F)) + attribute("screenWindowCenter", "v2f", window.substr(8)) +
      attribute("screenWindowWidth", "float", number(1.0F)) + zero;
  return head + number(static_cast<std::int64_t>(head.size()) + 8) + number(std::int32_t{0}) +
         number(static_cast<std::int32_t>(pixel.size())) + pixel;
}

}  // namespace

TEST_CASE("an OpenEXR picture without colours is grey, or refused with the names of its channels") {
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  const auto pixel = [](const std::vector<std::string>& names) {
    const auto image = decode_exr(exr_of(names), "a.exr");
    INFO((image ? "" : image.error().text()));
    REQUIRE(image);
    return image->at(0, 0);
  };
  CHECK(pixel({"B", "G", "R"}) == Rgb<float>(3, 2, 1));
  CHECK(pixel({"R"}) == Rgb<float>(1));  // as OpenImageIO calls the only channel of a grey picture
  CHECK(pixel({"A", "B"}) == Rgb<float>(2));
  CHECK(pixel({"G", "Z"}) == Rgb<float>(1));
  CHECK(pixel({"G", "R"}) == Rgb<float>(2, 1, 0));
  CHECK(pixel({"A"}) == Rgb<float>(1));
  CHECK(pixel({"A", "Y"}) == Rgb<float>(2));
  CHECK(pixel({"height"}) == Rgb<float>(1));
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"BY", "RY", "Y"}, {"X", "Y", "Z"}, {"gloss.B", "gloss.G", "gloss.R"}}) {
    const auto refused = decode_exr(exr_of(names), "a.exr");
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message,
               contains("the channels " + names[0] + ", " + names[1] + ", " + names[2] + " (expected"));
  }
}

TEST_CASE("an OpenEXR picture reads back as it was, to the last bit and with the top row on top") {
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  const TemporaryFolder folder;
  const Image image = sample();
  REQUIRE(write_image(folder.file("a.exr"), image));
  const auto bytes = read_file(folder.file("a.exr"), 1 << 20);
  REQUIRE(bytes);
  CHECK(bytes->substr(0, 4) == std::string("\x76\x2f\x31\x01"));
  const auto again = decode_exr(*bytes, "a.exr");
  REQUIRE(again);
  CHECK(*again == image);
  CHECK(folder.entries() == 1);  // nothing temporary is left
}

TEST_CASE("an OpenEXR picture keeps what is not a number") {
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  const TemporaryFolder folder;
  Image image = sample();
  image.at(1, 1).y = std::numeric_limits<float>::quiet_NaN();
  REQUIRE(write_image(folder.file("a.EXR"), image));
  const auto again = decode_exr(contents(folder.file("a.EXR")), "a.EXR");
  REQUIRE(again);
  CHECK(std::isnan(again->at(1, 1).y));
  CHECK(again->at(1, 1).x == image.at(1, 1).x);
}

TEST_CASE("what is no whole OpenEXR picture is refused with a message") {
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  const auto whole = encode_exr(sample());
  REQUIRE(whole);
  for (std::size_t size = 0; size < whole->size(); size += 7) {
    const auto image = decode_exr(whole->substr(0, size), "cut.exr");
    INFO(size << " of " << whole->size() << " bytes");
    REQUIRE(!image);
    CHECK(image.error().file == "cut.exr");
    CHECK(!image.error().hint.empty());
  }
  CHECK(!decode_exr("PF\n1 1\n-1.0\n123456789012", "a.pfm"));
}

TEST_CASE("a window that lies far away, or is larger than its file can fill") {  // a fuzzer's findings
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  const Image image = sample();
  const std::string bytes = encode_exr(image).value();
  const std::string name("dataWindow\0box2i", 17);
  const std::size_t window = bytes.find(name) + name.size() + 4;  // min x, min y, max x, max y
  const auto put = [](std::string& to, std::size_t at, std::int32_t number) {
    for (int i = 0; i < 4; ++i) to[at + static_cast<std::size_t>(i)] = static_cast<char>(number >> 8 * i);
  };
  std::string far = bytes;
  put(far, window, 0x19191919);
  put(far, window + 8, 0x19191919 + image.width - 1);
  const auto moved = decode_exr(far, "far.exr");
  REQUIRE(moved);
  CHECK(moved->pixels == image.pixels);
  std::string large = bytes;
  put(large, window + 8, 9999999);
  const auto refused = decode_exr(large, "large.exr");
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().message, contains("file that can hold them"));
}

TEST_CASE("rows that ask for gigabytes, and files of several parts, are refused before any is made room for") {
  if (!has_exr()) RAYWALK_SKIP("this build has no OpenEXR");
  // A fuzzer's finding: the library made room for the packed rows, 2 GiB, before the window could be looked at.
  const unsigned char found[] = {
      0x76, 0x2f, 0x31, 0x01, 0x02, 0,   0,    0,   'c', 'h', 'a', 'n', 'n', 'e', 'l', 's', 0,    'c', 'h', 'l', 'i',
      's',  't',  0,    0x34, 0,    0,   0,    'B', 0,   2,   0,   0,   0,   0,   0,   0,   0x99, 1,   0,   0,   0,
      1,    0,    0,    0,    'R',  0,   2,    0,   0,   0,   0,   0,   0,   0,   1,   0,   0,    0,   1,   0,   0,
      0,    0,    'c',  'o',  'n',  0,   'c',  'o', 'm', 'o', 'n', 0,   1,   0,   0,   0,   3,    'd', 'a', 't', 'a',
      'W',  'i',  'n',  'd',  'o',  'w', 0,    'b', 'o', 'x', '2', 'i', 0,   16,  0,   0,   0,    0,   0,   0,   0,
      0,    0,    0,    0,    2,    0,   0xfe, 0,   0,   0,   0,   0,   0,   0,   0,   0};
  const std::string rows(reinterpret_cast<const char*>(found), sizeof found);
  const auto refused = decode_exr(rows, "rows.exr");
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().message, contains("4 MiB a row"));
  std::string parts = encode_exr(sample()).value();
  parts[5] = 0x10;
  const auto several = decode_exr(parts, "parts.exr");
  REQUIRE_FALSE(several);
  CHECK_THAT(several.error().message, contains("several parts"));
}

TEST_CASE("without the library, asking for .exr says how to get it") {
  const auto format = image_format_of("a.exr");
  CHECK(format.has_value() == has_exr());
  if (!format) CHECK_THAT(format.error().hint, contains("libopenexr-dev"));
}
