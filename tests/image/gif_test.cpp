// Animated GIF, read back by giflib: every frame looks as it was given, changes are small, times are kept.
#include "image/gif.h"

#include <algorithm>
#include <cmath>

#include "image/palette.h"
#include "support/catch.h"
#include "support/played_film.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

int farthest(const Bytes& a, const Bytes& b) {
  REQUIRE(a.size() == b.size());
  int most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int{a[i]} - int{b[i]}));
  return most;
}

// A few flat colours, as drawings have them, and a bar that moves.
Bytes drawing(int bar) {
  Bytes rgb;
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      const bool in_bar = row >= 10 && row < 14 && column >= bar && column < bar + 6;
      const std::uint8_t ground = column < 20 ? 24 : 232;
      if (in_bar)
        rgb.insert(rgb.end(), {240, 200, 32});
      else
        rgb.insert(rgb.end(), {ground, ground, static_cast<std::uint8_t>(row < 15 ? 40 : 248)});
    }
  return rgb;
}

// What a window shows, 320 x 200: grounds of one colour, letters with soft edges, and a picture of smooth shades in
// every hue. `sentence`: which one stands at the bottom, 0 for none.
Bytes window(int sentence) {
  Bytes rgb;
  const auto put = [&](double r, double g, double b) {
    for (const double c : {r, g, b}) rgb.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(c, 0.0, 255.0))));
  };
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 320; ++column) {
      const double x = (column - 230) / 60.0, y = (row - 70) / 60.0, r2 = x * x + y * y;
      const unsigned letter = static_cast<unsigned>(column * 7919 + row * 104729 + sentence * 31) % 97U;
      if (column >= 160 && row < 140 && r2 < 1) {  // a ball
        const double light = 255 * std::sqrt(1 - r2);
        put(light * (0.6 + 0.4 * x), light * (0.6 + 0.4 * y), light * (0.6 - 0.4 * x));
      } else if (column >= 160 && row < 140) {  // tiles and sky
        const double far = 0.4 + 0.6 * row / 140;
        const bool dark = (static_cast<int>(column / (8 + row / 6)) + row / 24) % 2 == 0;
        row < 60 ? put(120 + row, 150 + 0.8 * row, 190 + 0.5 * row)
                 : put(far * (dark ? 110 : 190), far * (dark ? 118 : 196), far * (dark ? 112 : 180));
      } else if (row >= 150 && row < 162 && column > 10 && column < 250 && sentence > 0 && letter < 40) {
        const double ink = letter / 40.0;
        put(27 + ink * 200, 31 + ink * 200, 38 + ink * 200);
      } else if (row >= 145) {
        put(27, 31, 38);
      } else {
        put(17, 19, 24);
      }
    }
  return rgb;
}

}  // namespace

TEST_CASE("an animation shows its frames in order, each for its time, and repeats") {
  GifAnimation animation({40, 30});
  animation.add(drawing(2), 0.25);
  animation.add(drawing(5), 0.5);
  animation.add(drawing(5), 1);  // nothing changes
  animation.add(drawing(30), 2);
  const auto bytes = animation.finish();
  REQUIRE(bytes);
  CHECK(bytes->substr(0, 6) == "GIF89a");
  CHECK(bytes->find("NETSCAPE2.0") != std::string::npos);
  const Read read = played(*bytes);
  CHECK(read.width == 40);
  CHECK(read.height == 30);
  REQUIRE(read.frames.size() == 4);
  const int bars[] = {2, 5, 5, 30}, delays[] = {25, 50, 100, 200};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(farthest(read.frames[i].rgb, drawing(bars[i])) == 0);
    CHECK(read.frames[i].delay == delays[i]);
  }
  // Of a frame the file holds what has changed.
  CHECK(read.frames[0].width == 40);
  CHECK(read.frames[1].width == 9);
  CHECK(read.frames[1].height == 4);
  CHECK(read.frames[2].width * read.frames[2].height == 1);
}

TEST_CASE("a window of many colours looks as it did, and nothing stays of what is gone") {
  const int sentences[] = {1, 2, 2, 3, 0};
  GifAnimation animation({320, 200});
  for (const int sentence : sentences) animation.add(window(sentence), 0.1);
  const auto bytes = animation.finish();
  REQUIRE(bytes);
  const Read read = played(*bytes);
  REQUIRE(read.frames.size() == std::size(sentences));
  for (std::size_t i = 0; i < std::size(sentences); ++i) {
    CAPTURE(i);
    const Bytes exact = window(sentences[i]);
    const Errors near = errors(exact, read.frames[i].rgb, 320, 1), far = errors(exact, read.frames[i].rgb, 320, 4);
    CAPTURE(near.mean, near.ninety_ninth, far.mean, far.ninety_ninth);
    CHECK(near.mean < 0.006);
    CHECK(near.ninety_ninth < 0.05);
    CHECK(far.mean < 0.0015);
    CHECK(far.ninety_ninth < 0.012);
  }
  // The last sentence is gone to the last pixel, and what stayed the same does not flicker.
  const Bytes& first = read.frames.front().rgb;
  const Bytes& last = read.frames.back().rgb;
  const Bytes exact = window(0), was = window(1);
  for (std::size_t at = 0; at < exact.size(); ++at) {
    if (at / 3 / 320 >= 145 && last[at] != exact[at]) FAIL("byte " << at << " still shows a sentence");
    if (exact[at] == was[at] && at / 3 / 320 < 145 && first[at] != last[at]) FAIL("byte " << at << " flickers");
  }
}

TEST_CASE("every colour of a palette stands in the picture, and a mixture is right in the mean") {
  std::vector<Rgb24> pixels;
  for (Rgb24 i = 0; i < 4096; ++i) pixels.push_back((i % 64) * 4 << 16 | (i / 64) * 4 << 8 | 128);
  const FramePalette palette(pixels, 64);
  CHECK(palette.colours().size() == 64);
  for (const Rgb24 colour : palette.colours()) CHECK(std::count(pixels.begin(), pixels.end(), colour) == 1);
  for (const Rgb24 colour : pixels) {
    Lab mean{};
    for (int row = 0; row < 32; ++row)
      for (int column = 0; column < 32; ++column) {
        const Lab lab = lab_of(palette.colours()[palette.index(colour, column, row)]);
        for (std::size_t i = 0; i < 3; ++i) mean[i] += lab[i] / 1024;
      }
    const Lab exact = lab_of(colour);
    // Beyond the palette's outermost colours there is nothing to mix from.
    const bool inside =
        (colour >> 16) > 24 && (colour >> 16) < 228 && (colour >> 8 & 255U) > 24 && (colour >> 8 & 255U) < 228;
    if (inside) CHECK(std::hypot(mean[0] - exact[0], mean[1] - exact[1], mean[2] - exact[2]) < 0.013F);
  }
  CHECK(FramePalette({}, 255).colours().empty());
  CHECK(FramePalette({7, 7, 7}, 2).colours() == std::vector<Rgb24>{7});
}

TEST_CASE("a frame of many colours comes close, one of another size is left out") {
  Bytes smooth;
  for (int i = 0; i < 64 * 64; ++i)
    smooth.insert(smooth.end(),
                  {static_cast<std::uint8_t>(4 * (i % 64)), static_cast<std::uint8_t>(4 * (i / 64)), 128});
  GifAnimation animation({64, 64});
  animation.add(smooth, 0.1);
  animation.add(Bytes(12), 0.1);
  const auto bytes = animation.finish();
  REQUIRE(bytes);
  const Read read = played(*bytes);
  REQUIRE(read.frames.size() == 1);
  CHECK(errors(smooth, read.frames[0].rgb, 64, 1).mean < 0.016);
  CHECK(errors(smooth, read.frames[0].rgb, 64, 4).ninety_ninth < 0.012);
}
