#include "image/image_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <thread>

#include "image/quick_image.h"
#include "image/srgb.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/file.h"

// An independent decoder.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr float nan_float = std::numeric_limits<float>::quiet_NaN();
constexpr float inf_float = std::numeric_limits<float>::infinity();

Image two_by_three() {
  return {2, 3, {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0.5F, 0.25F, 0.125F}, {-1, 2, inf_float}}};
}

std::vector<int> decoded(const std::string& png, int& width, int& height) {
  int channels = 0;
  unsigned char* bytes = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                                               static_cast<int>(png.size()), &width, &height, &channels, 0);
  REQUIRE(bytes != nullptr);
  REQUIRE(channels == 3);
  std::vector<int> result(bytes, bytes + 3 * width * height);
  stbi_image_free(bytes);
  return result;
}

/// CRC-32 of a PNG chunk, bit by bit (ISO 3309).
std::uint32_t crc(std::string_view bytes) {
  std::uint32_t c = 0xffffffff;
  for (const char byte : bytes) {
    c ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320 ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

TEST_CASE("sRGB: the two pieces, their joint and the ends") {
  // Values of IEC 61966-2-1: 12.92 x below 0.0031308, the power above.
  CHECK(srgb_encode(0) == 0);
  CHECK(srgb_encode(1) == Approx(1).epsilon(1e-15));
  CHECK(srgb_encode(0.002) == 12.92 * 0.002);
  CHECK(srgb_encode(0.5) == Approx(0.7353569830524495).epsilon(1e-14));
  CHECK(srgb_encode(0.18) == Approx(0.46135612950044164).epsilon(1e-14));
  CHECK(srgb_encode(0.0031308) == Approx(srgb_encode(0.00313081)).epsilon(1e-4));
  for (int i = 0; i <= 100; ++i)
    CHECK(srgb_decode(srgb_encode(i / 100.0)) == Approx(i / 100.0).epsilon(0).margin(1e-7));
}

TEST_CASE("bytes: clamped, encoded and rounded") {
  CHECK(to_srgb8(0) == 0);
  CHECK(to_srgb8(-0.0F) == 0);
  CHECK(to_srgb8(-5) == 0);
  CHECK(to_srgb8(1) == 255);
  CHECK(to_srgb8(3) == 255);
  CHECK(to_srgb8(inf_float) == 255);
  CHECK(to_srgb8(-inf_float) == 0);
  CHECK(to_srgb8(0.5F) == 188);
  CHECK(to_srgb8(0.18F) == 118);
  CHECK(to_srgb8(0.25F) == 137);
  CHECK(to_srgb8(0.125F) == 99);
  CHECK(to_srgb8(0.0001F) == 0);
  CHECK(to_srgb8(0.0002F) == 1);
}

TEST_CASE("the table of bytes is the formula, to the last float") {
  const auto formula = [](float linear) { return static_cast<int>(std::lround(255 * srgb_encode(linear))); };
  for (int byte = 1; byte <= 255; ++byte) {
    // The floats around each step: the middle between two signals, decoded.
    const auto step = static_cast<float>(srgb_decode((byte - 0.5) / 255));
    float x = step;
    for (int i = 0; i < 8; ++i) x = std::nextafter(x, 0.0F);
    for (int i = 0; i < 16; ++i, x = std::nextafter(x, 1.0F)) {
      CAPTURE(byte, x);
      REQUIRE(to_srgb8(x) == formula(x));
    }
    REQUIRE(to_srgb8(static_cast<float>(srgb_decode(byte / 255.0))) == byte);
  }
}

TEST_CASE("a PNG holds the picture, right side up, in 8 bits of sRGB") {
  const auto png = encode_png(two_by_three());
  REQUIRE(png);
  int width = 0, height = 0;
  const std::vector<int> bytes = decoded(*png, width, height);
  CHECK(width == 2);
  CHECK(height == 3);
  CHECK(bytes == std::vector<int>{0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 255, 0, 188, 137, 99, 0, 255, 255});

  REQUIRE(png->substr(0, 16) == std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16));
  CHECK(png->substr(24, 5) == std::string("\x08\x02\0\0\0", 5));
  for (std::size_t at = 8; at < png->size();) {  // every chunk: length, name, data, checksum
    const std::size_t length = big_endian(*png, at);
    REQUIRE(at + length + 12 <= png->size());
    CHECK(crc(std::string_view(*png).substr(at + 4, length + 4)) == big_endian(*png, at + 8 + length));
    at += length + 12;
  }
}

TEST_CASE("a pixel that is not a number is magenta in a PNG") {
  Image image{3, 1, {{0, 0, 0}, {0, nan_float, 0}, {inf_float, 0, 0}}};
  const auto png = encode_png(image);
  REQUIRE(png);
  int width = 0, height = 0;
  CHECK(decoded(*png, width, height) == std::vector<int>{0, 0, 0, 255, 0, 255, 255, 0, 0});
  const TemporaryFolder folder;
  REQUIRE(write_image(folder.file("a.png"), image));
  CHECK(contents(folder.file("a.png")) == *png);
}

/// What the compressed data in a PNG say of the effort spent on them: 0 and 1 are fast, 2 is zlib's default, 3 its
/// slowest (RFC 1950, FLEVEL).
int compression_effort(const std::string& png) {
  const std::size_t data = png.find("IDAT");
  REQUIRE(data != std::string::npos);
  return static_cast<unsigned char>(png.at(data + 5)) >> 6;
}

TEST_CASE("a picture that is written quickly is the same picture, packed with less effort") {
  constexpr int width = 1200, height = 900;
  const int begun = GENERATE(0, 40, 900);  // rows: the others are black
  Image image{width, height, std::vector<Rgb<float>>(width * height)};
  for (int row = 0; row < begun; ++row)
    for (int column = 0; column < width; ++column)
      image.at(column, row) = {static_cast<float>(row) / height, 0.5F, static_cast<float>(column * row % 7) / 7};
  int deepest = -1;  // what is not begun is not asked for
  const ImageRows rows{width, height, begun, [&](int row) {
                         deepest = std::max(deepest, row);
                         return &image.at(0, row);
                       }};
  const TemporaryFolder folder;
  const auto quick = [&](const std::string& name) {
    REQUIRE(write_image_quickly(folder.file(name), rows, Encoding::srgb));
    CHECK(deepest == begun - 1);
    return read_file(folder.file(name), 1 << 30).value();
  };
  const std::string small_png = encode_png(image).value(), png = quick("a.png");
  CHECK(compression_effort(small_png) >= 2);
  CHECK(compression_effort(png) <= 1);
  int decoded_width = 0, decoded_height = 0;
  CHECK(decoded(png, decoded_width, decoded_height) == decoded(small_png, decoded_width, decoded_height));
  CHECK(decode_png_or_jpeg(png, "quick").value() == decode_png_or_jpeg(small_png, "small").value());
  CHECK(quick("a.pfm") == encode_pfm(image));
  if (has_exr()) CHECK(decode_exr(quick("a.exr"), "quick").value() == image);
}

TEST_CASE("black rows of a picture that is written quickly take no room on the disk") {
  const TemporaryFolder folder;
  const std::vector<Rgb<float>> grey(1000, Rgb<float>(0.5F));
  const auto on_disk = [&](int begun) {
    const std::string path = folder.file(std::to_string(begun) + ".pfm");
    REQUIRE(write_image_quickly(path, {1000, 1000, begun, [&](int) { return grey.data(); }}, Encoding::srgb));
    struct stat status{};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    CHECK(status.st_size == 12'000'000 + static_cast<int>(pfm_header(1000, 1000).size()));
    return status.st_blocks * 512;
  };
  if (on_disk(1) > 1'000'000) RAYWALK_SKIP("this file system has no holes");
}

TEST_CASE("a picture that is written quickly into a pipe is whole, and one that cannot be written is refused") {
  const TemporaryFolder folder;
  const ImageRows black{300, 200, 0, {}};
  const auto refused = write_image_quickly(folder.file("none/a.png"), black, Encoding::srgb);
  REQUIRE(!refused);
  CHECK_THAT(refused.error().message, contains("there is no folder"));
  CHECK(!write_image_quickly(folder.file("a.hdr"), black, Encoding::srgb));
  const std::string pipe = folder.file("a.pfm");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string read;
  std::thread reader([&] {
    std::ifstream from(pipe, std::ios::binary);
    read.assign(std::istreambuf_iterator<char>(from), {});
  });
  const auto written = write_image_quickly(pipe, black, Encoding::srgb);
  reader.join();
  REQUIRE(written);
  CHECK(read == encode_pfm({300, 200, std::vector<Rgb<float>>(300 * 200)}));
}

TEST_CASE("pictures may have more pixels than textures, and only of a damaged one is asked whether it is whole") {
  const TemporaryFolder folder;
  const auto refused = [&](std::uint32_t width, std::uint32_t height, bool as_picture) {
    std::string png = encode_png(two_by_three()).value();
    const auto put_number = [&](std::size_t at, std::uint32_t number) {
      for (std::size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>(number >> (24 - 8 * i));
    };
    put_number(16, width), put_number(20, height);
    put_number(29, crc(std::string_view(png).substr(12, 17)));
    put(folder.file("a.png"), png);
    const auto image = as_picture ? read_image(folder.file("a.png")) : decode_png_or_jpeg(png, "a.png");
    REQUIRE_FALSE(image);
    return image.error().message + ": " + image.error().hint;
  };
  CHECK_THAT(refused(8193, 8192, false), contains("(expected at most 67108864 in all): make it smaller"));
  CHECK_THAT(refused(8193, 8192, true), contains("damaged") && contains("whole"));
  CHECK_THAT(refused(16385, 16384, true), contains("(expected at most 268435456 in all): make it smaller"));
}

TEST_CASE("a PFM is bottom-up, little-endian and linear, byte by byte") {
  const std::string pfm = encode_pfm({1, 2, {{1, 0.5F, -2}, {0, 256, inf_float}}});
  const std::string expected = std::string("PF\n1 2\n-1.0\n") +
                               std::string("\0\0\0\0\0\0\x80\x43\0\0\x80\x7f", 12) +  // 0, 256, infinity
                               std::string("\0\0\x80\x3f\0\0\0\x3f\0\0\0\xc0", 12);   // 1, 0.5, -2
  CHECK(pfm == expected);
}

TEST_CASE("a PFM reads back bit for bit, also what is not a number") {
  Image image = two_by_three();
  image.at(1, 2) = {nan_float, -0.0F, 1e-42F};
  const TemporaryFolder folder;
  REQUIRE(write_image(folder.file("a.PFM"), image));
  const auto back = read_pfm(folder.file("a.PFM"));
  REQUIRE(back);
  CHECK(back->width == 2);
  CHECK(back->height == 3);
  REQUIRE(back->pixels.size() == image.pixels.size());
  CHECK(std::memcmp(back->pixels.data(), image.pixels.data(), image.pixels.size() * sizeof(Rgb<float>)) == 0);
}

TEST_CASE("a big-endian PFM reads the same") {
  const auto image = decode_pfm(std::string("PF 1\t1 2.5\n\x3f\x80\0\0\x3f\0\0\0\xc0\0\0\0", 23), "big.pfm");
  REQUIRE(image);
  CHECK(image->at(0, 0) == Rgb<float>(1, 0.5F, -2));
}

TEST_CASE("a grey PFM has one number a pixel") {
  const std::string lower("\0\0\x80\x43\0\0\0\xc0", 8), upper("\0\0\x80\x3f\0\0\0\x3f", 8);
  const std::string pfm = "Pf\n2 2\n-1.0\n" + lower + upper;
  const auto image = decode_pfm(pfm, "grey.pfm");
  REQUIRE(image);
  CHECK(*image == Image{2, 2, {Rgb<float>(1), Rgb<float>(0.5F), Rgb<float>(256), Rgb<float>(-2)}});
  const TemporaryFolder folder;
  put(folder.file("grey.pfm"), pfm);
  CHECK(read_image(folder.file("grey.pfm")).value() == *image);
  CHECK(read_pfm(folder.file("grey.pfm")).value() == *image);
  CHECK(decode_map(pfm, "grey.pfm", ByteMeaning::number).value() == *image);
  const auto cut = decode_pfm(pfm.substr(0, pfm.size() - 1), "grey.pfm");
  REQUIRE_FALSE(cut);
  CHECK_THAT(cut.error().message, contains("15 bytes of pixels (expected 4 for each of 4 pixels)"));
}

TEST_CASE("a broken PFM is refused") {
  const std::string pixel(12, '\0');
  for (const std::string& bytes :
       {std::string(), std::string("P"), std::string("Pf\n1 1\n-1.0\n") + pixel, std::string("PF\n1\n"),
        std::string("PF\n0 1\n-1.0\n"), std::string("PF\n-1 1\n-1.0\n") + pixel,
        std::string("PF\n1x 1\n-1.0\n") + pixel, std::string("PF\n1 1\n"), std::string("PF\n1 1\n-1.0\n"),
        std::string("PF\n1 1\n-1.0\n") + pixel + "x", std::string("PF\n2147483647 2147483647\n-1.0\n") + pixel,
        std::string("PF\n99999999999 1\n-1.0\n") + pixel}) {
    INFO(bytes);
    const auto image = decode_pfm(bytes, "broken.pfm");
    REQUIRE(!image);
    CHECK(image.error().file == "broken.pfm");
    CHECK(!image.error().hint.empty());
  }
}

TEST_CASE("the ending says the format") {
  CHECK(image_format_of("a.png") == ImageFormat::png);
  CHECK(image_format_of("dir.d/A.PnG") == ImageFormat::png);
  CHECK(image_format_of("a.b.pfm") == ImageFormat::pfm);
  for (const std::string path : {"a", "a.", "a.hdr", "a.jpg", "dir.png/a", ".png.txt", ""}) {
    INFO(path);
    const auto format = image_format_of(path);
    REQUIRE(!format);
    CHECK_THAT(format.error().message, contains("(expected .png, .pfm or .exr)"));
  }
  CHECK_THAT(image_format_of("a.hdr").error().message, contains("\".hdr\""));
  const TemporaryFolder folder;
  CHECK(!write_image(folder.file("a.hdr"), two_by_three()));
  CHECK(folder.entries() == 0);
}

TEST_CASE("a picture without pixels is refused") {
  const auto png = encode_png({});
  REQUIRE(!png);
  CHECK_THAT(png.error().message, contains("0 x 0"));
}

TEST_CASE("an image that cannot be written leaves the old one") {
  const TemporaryFolder folder;
  const auto written = write_image(folder.file("none/a.png"), two_by_three());
  REQUIRE(!written);
  CHECK(written.error().file == folder.file("none/a.png"));
}
