// PNG and JPEG, in linear light; what is wrong with a file is said.
#include "image/image_file.h"
#include "image/srgb.h"

#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Image gradient() {
  Image image{5, 3, {}};
  for (int i = 0; i < 15; ++i)
    image.pixels.emplace_back(static_cast<float>(i) / 14.0F, 0.2F, 1 - static_cast<float>(i) / 14.0F);
  return image;
}

/// What libpng writes of these samples as they are, row by row, those of 16 bits with the higher byte first.
struct Written {
  int depth, colour_type, interlacing;
};
std::string png_of(int width, int height, const Written& how, const std::vector<unsigned char>& samples) {
  std::string png;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  const auto take = [](png_structp from, png_bytep bytes, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<const char*>(bytes), size);
  };
  png_set_write_fn(writer, &png, take, nullptr);
  png_set_IHDR(writer, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), how.depth,
               how.colour_type, how.interlacing, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::array<png_color, 256> palette{};
  for (std::size_t i = 0; i < palette.size(); ++i)
    palette[i] = {static_cast<png_byte>(i), static_cast<png_byte>(3 * i), static_cast<png_byte>(255 - i)};
  if (how.colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(writer, info, palette.data(), 256);
  png_write_info(writer, info);
  const std::size_t row = samples.size() / static_cast<std::size_t>(height);
  for (int pass = png_set_interlace_handling(writer); pass > 0; --pass)
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) png_write_row(writer, samples.data() + y * row);
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return png;
}

}  // namespace

TEST_CASE("a texture holds what its PNG shows, in linear light, top row first") {
  const Image image = gradient();
  const auto texture = decode_png_or_jpeg(encode_png(image).value(), "wood.png");
  REQUIRE(texture);
  CHECK(texture->width == 5);
  CHECK(texture->height == 3);
  REQUIRE(texture->pixels.size() == 15);
  for (std::size_t i = 0; i < 15; ++i)
    for (int c = 0; c < 3; ++c)  // 8 bits of sRGB: steps of up to 1/110 near white
      CHECK(std::abs(texture->pixels[i][c] - image.pixels[i][c]) < 0.005F);
}

TEST_CASE("a texture holds what its JPEG shows") {
  std::vector<unsigned char> rgb;
  for (int i = 0; i < 16 * 8; ++i) rgb.insert(rgb.end(), {200, 100, 50});
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const tjhandle encoder = tjInitCompress();
  REQUIRE(tjCompress2(encoder, rgb.data(), 16, 0, 8, TJPF_RGB, &bytes, &size, TJSAMP_444, 95, 0) == 0);
  const std::string jpeg(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  const auto texture = decode_png_or_jpeg(jpeg, "wood.jpg");
  REQUIRE(texture);
  CHECK(texture->width == 16);
  CHECK(texture->height == 8);
  REQUIRE(texture->pixels.size() == 128);
  for (const auto& pixel : texture->pixels) {
    CHECK(pixel.x == Approx(srgb_decode(200 / 255.0)).margin(0.03));
    CHECK(pixel.y == Approx(srgb_decode(100 / 255.0)).margin(0.02));
    CHECK(pixel.z == Approx(srgb_decode(50 / 255.0)).margin(0.02));
  }
  unsigned char* inks = nullptr;
  const tjhandle printer = tjInitCompress();
  rgb.resize(std::size_t{4} * 16 * 8);
  REQUIRE(tjCompress2(printer, rgb.data(), 16, 0, 8, TJPF_CMYK, &inks, &size, TJSAMP_444, 95, 0) == 0);
  const auto print = decode_png_or_jpeg(std::string_view(reinterpret_cast<const char*>(inks), size), "print.jpg");
  tjFree(inks);
  tjDestroy(printer);
  REQUIRE_FALSE(print);
  CHECK(print.error().message == "this JPEG is in CMYK (expected RGB or grey)");
  CHECK_THAT(print.error().hint, contains("as RGB"));
  // A picture whose end is missing is not taken for one with grey below.
  const auto half = decode_png_or_jpeg(std::string_view(jpeg).substr(0, jpeg.size() - 40), "wood.jpg");
  REQUIRE_FALSE(half);
  CHECK_THAT(half.error().message, contains("damaged"));
}

TEST_CASE("what is transparent in a PNG keeps its colour") {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = 2, header.height = 1, header.format = PNG_FORMAT_RGBA;
  const std::array<unsigned char, 8> rgba{255, 0, 0, 0, 0, 255, 0, 128};
  std::string png(1000, '\0');
  png_alloc_size_t size = png.size();
  REQUIRE(png_image_write_to_memory(&header, png.data(), &size, 0, rgba.data(), 0, nullptr) != 0);
  png.resize(size);
  const auto texture = decode_png_or_jpeg(png, "");
  REQUIRE(texture);
  CHECK(texture->pixels == std::vector<Rgb<float>>{{1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("16 bits of a PNG mean what 8 do, and numbers what they say whatever the file says of colours") {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = 2, header.height = 1, header.format = PNG_FORMAT_LINEAR_RGB;
  const std::array<std::uint16_t, 6> rgb{0x8080, 0x4040, 0xffff, 0, 0xc0c0, 0x8080};
  std::string png(2000, '\0');
  png_alloc_size_t size = png.size();
  REQUIRE(png_image_write_to_memory(&header, png.data(), &size, 0, rgb.data(), 0, nullptr) != 0);
  png.resize(size);
  const auto is = [](const Result<Image>& image, auto decoded) {
    REQUIRE(image);
    const std::array<int, 6> bytes{0x80, 0x40, 0xff, 0, 0xc0, 0x80};
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(image->pixels[i / 3][static_cast<int>(i % 3)] ==
            Approx(decoded(bytes[i] / 255.0)).epsilon(0).margin(0.012));  // libpng's steps of 8 bits of sRGB
  };
  const auto as_it_is = [](double x) { return x; };
  // This file says that it is linear: its chunk gAMA.
  const std::size_t gamma = png.find("gAMA");
  REQUIRE(gamma != std::string::npos);
  is(decode_png_or_jpeg(png, "", ByteMeaning::colour), as_it_is);
  is(decode_png_or_jpeg(png, "", ByteMeaning::number), as_it_is);
  const std::string silent = png.substr(0, gamma - 4) + png.substr(gamma + 12);
  const std::size_t white = silent.find("cHRM");
  const std::string plain =
      white == std::string::npos ? silent : silent.substr(0, white - 4) + silent.substr(white + 40);
  is(decode_png_or_jpeg(plain, "", ByteMeaning::colour), srgb_decode);
  is(decode_png_or_jpeg(plain, "", ByteMeaning::number), as_it_is);
}

TEST_CASE("numbers keep the 16 bits of a PNG, also beside an alpha, whatever it hides") {
  for (const unsigned char alpha : std::array<unsigned char, 3>{0xff, 0x80, 0}) {
    const std::vector<unsigned char> rgba{0x12, 0x34, 0x12, 0x35, 0xff, 0xff, 0xff,  0xff,
                                          0,    1,    0,    0,    0x80, 0x01, alpha, alpha};
    const auto numbers = decode_png_or_jpeg(png_of(2, 1, {16, PNG_COLOR_TYPE_RGBA, 0}, rgba), "", ByteMeaning::number);
    REQUIRE(numbers);
    const auto number = [](int of) { return static_cast<float>(of / 65535.0); };
    CHECK(numbers->pixels ==
          std::vector<Rgb<float>>{{number(0x1234), number(0x1235), 1}, {number(1), 0, number(0x8001)}});
  }
}

TEST_CASE("a PNG that is interlaced holds what it holds row by row") {
  std::mt19937 random(3);
  constexpr int width = 11, height = 9;  // some of the seven passes end early
  for (const int depth : {8, 16})
    for (const auto& [type, channels] : {std::pair{PNG_COLOR_TYPE_GRAY, 1},
                                         {PNG_COLOR_TYPE_GRAY_ALPHA, 2},
                                         {PNG_COLOR_TYPE_PALETTE, 1},
                                         {PNG_COLOR_TYPE_RGB, 3},
                                         {PNG_COLOR_TYPE_RGBA, 4}}) {
      if (type == PNG_COLOR_TYPE_PALETTE && depth == 16) continue;
      INFO(depth << " bits, " << channels << " channels, type " << type);
      std::vector<unsigned char> samples(static_cast<std::size_t>(width * height * channels * depth / 8));
      for (unsigned char& sample : samples) sample = static_cast<unsigned char>(random());
      for (const ByteMeaning meaning : {ByteMeaning::colour, ByteMeaning::number}) {
        const auto plain = decode_png_or_jpeg(png_of(width, height, {depth, type, PNG_INTERLACE_NONE}, samples), "",
                                              meaning),
                   interlaced = decode_png_or_jpeg(png_of(width, height, {depth, type, PNG_INTERLACE_ADAM7}, samples),
                                                   "", meaning);
        REQUIRE(plain);
        REQUIRE(interlaced);
        CHECK(interlaced->width == width);
        CHECK(interlaced->height == height);
        CHECK(interlaced->pixels == plain->pixels);
      }
    }
}

TEST_CASE("16 bits of an interlaced PNG, to the bit") {
  using namespace std::string_view_literals;
  // 2 x 2 pixels: made by hand after the specification.
  const std::string_view png =
      "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x02\0\0\0\x02\x10\x02\0\0\x01\xda\x43\x76\xa6\0\0\0\x22IDAT\x78\x9c"
      "\x05\xc1\xc7\x11\x00\x20\x08\x00\xb0\x28\x67\xe3\xe9\x2c\xee\xbf\x1a\x26\xee\xa3\x8a\xa6\x0b\x86\x69\xd9\x8e\xfc"
      "\x33\x1f\x02\x78\x7e\x97\xac\xe7\0\0\0\0IEND\xae\x42\x60\x82"sv;
  const auto numbers = decode_png_or_jpeg(png, "", ByteMeaning::number),
             colours = decode_png_or_jpeg(png, "", ByteMeaning::colour);
  REQUIRE(numbers);
  REQUIRE(colours);
  const std::array<std::uint16_t, 12> samples{0x1234, 0, 0xffff, 1, 2, 3, 5, 6, 7, 8, 9, 10};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double number = samples[i] / 65535.0;
    const int channel = static_cast<int>(i % 3);
    CHECK(numbers->pixels[i / 3][channel] == static_cast<float>(number));
    CHECK(colours->pixels[i / 3][channel] == static_cast<float>(srgb_decode(std::round(255 * number) / 255)));
  }
}

TEST_CASE("a PNG says that it is in sRGB only where it is") {
  CHECK(encode_png(gradient()).value().find("sRGB") != std::string::npos);
  CHECK(encode_png(gradient(), Encoding::truncated).value().find("sRGB") == std::string::npos);
}

TEST_CASE("chunks that are empty, or say that they are huge") {  // a fuzzer's findings
  const std::string png = encode_png(gradient()).value();
  const std::size_t first = png.find("IDAT") - 4;
  const std::string head = png.substr(0, first);
  const auto texture =
      decode_png_or_jpeg(head + std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12) + png.substr(first), "wood.png");
  REQUIRE(texture);
  CHECK(texture->pixels == decode_png_or_jpeg(png, "wood.png")->pixels);
  CHECK_FALSE(decode_png_or_jpeg(head + "\x3f\xff\xff\xff" + png.substr(first + 4), "wood.png"));
}

TEST_CASE("what is no image, or a damaged one, is refused with its name and a hint") {
  const std::string png = encode_png(gradient()).value();
  for (const std::string& bad :
       {std::string(), std::string("wood"), png.substr(0, 40), png.substr(0, png.size() / 2)}) {
    const auto texture = decode_png_or_jpeg(bad, "wood.png");
    REQUIRE_FALSE(texture);
    CHECK(texture.error().file == "wood.png");
    CHECK_THAT(texture.error().hint, contains(bad.size() > 4 ? "is the file whole?" : "a PNG or a JPEG"));
  }
  // Any damage is refused or gives an image of the stated size, and does nothing worse.
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = png;
    for (int flips = 0; flips < 3; ++flips) damaged[random() % damaged.size()] = static_cast<char>(random());
    if (const auto texture = decode_png_or_jpeg(damaged, ""))
      CHECK(texture->pixels.size() ==
            static_cast<std::size_t>(texture->width) * static_cast<std::size_t>(texture->height));
  }
}
