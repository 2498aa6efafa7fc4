// Animated GIF, read back by giflib: every frame looks as it was given, changes are small, times are kept.
#include "io/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <cstring>

#include "support/catch.h"

using namespace raywalk;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Shown {
  Bytes rgb;
  int delay;          // 1/100 s
  int width, height;  // of what the file holds of it
};
struct Read {
  int width = 0, height = 0;
  std::vector<Shown> frames;
};

// Plays the file as a viewer does.
Read played(const std::string& bytes) {
  struct Source {
    const std::string& bytes;
    std::size_t at = 0;
  } source{bytes};
  int error = 0;
  GifFileType* file = DGifOpen(
      &source,
      [](GifFileType* from, GifByteType* to, int size) {
        auto& in = *static_cast<Source*>(from->UserData);
        const std::size_t count = std::min(static_cast<std::size_t>(size), in.bytes.size() - in.at);
        std::memcpy(to, in.bytes.data() + in.at, count);
        in.at += count;
        return static_cast<int>(count);
      },
      &error);
  REQUIRE(file != nullptr);
  REQUIRE(DGifSlurp(file) == GIF_OK);
  Read read{file->SWidth, file->SHeight, {}};
  Bytes screen(3 * static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height));
  for (int i = 0; i < file->ImageCount; ++i) {
    const SavedImage& frame = file->SavedImages[i];
    GraphicsControlBlock control{};
    REQUIRE(DGifSavedExtensionToGCB(file, i, &control) == GIF_OK);
    const GifImageDesc& part = frame.ImageDesc;
    for (int row = 0; row < part.Height; ++row) {
      for (int column = 0; column < part.Width; ++column) {
        const GifByteType index = frame.RasterBits[row * part.Width + column];
        if (index == control.TransparentColor) continue;
        const GifColorType& colour = part.ColorMap->Colors[index];
        std::uint8_t* to = &screen[3 * static_cast<std::size_t>((part.Top + row) * read.width + part.Left + column)];
        to[0] = colour.Red, to[1] = colour.Green, to[2] = colour.Blue;
      }
    }
    read.frames.push_back({screen, control.DelayTime, part.Width, part.Height});
  }
  REQUIRE(DGifCloseFile(file, &error) == GIF_OK);
  return read;
}

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

}  // namespace

TEST_CASE("a film shows its frames in their order and for their time, for ever") {
  GifFilm film({40, 30});
  film.add(drawing(2), 0.25);
  film.add(drawing(5), 0.5);
  film.add(drawing(5), 1);  // nothing changes
  film.add(drawing(30), 2);
  const auto bytes = film.finish();
  REQUIRE(bytes);
  CHECK(bytes->substr(0, 6) == "GIF89a");
  CHECK(bytes->find("NETSCAPE2.0") != std::string::npos);
  const Read read = played(*bytes);
  CHECK(read.width == 40);
  CHECK(read.height == 30);
  REQUIRE(read.frames.size() == 4);
  const int bars[] = {2, 5, 5, 30}, delays[] = {25, 50, 100, 200};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(farthest(read.frames[i].rgb, drawing(bars[i])) <= 8);  // 5 bits a channel
    CHECK(read.frames[i].delay == delays[i]);
  }
  // Of a frame the file holds what has changed.
  CHECK(read.frames[0].width == 40);
  CHECK(read.frames[1].width == 9);
  CHECK(read.frames[1].height == 4);
  CHECK(read.frames[2].width * read.frames[2].height == 1);
}

TEST_CASE("a frame of many colours comes close, one of another size is left out") {
  Bytes smooth;
  for (int i = 0; i < 64 * 64; ++i)
    smooth.insert(smooth.end(),
                  {static_cast<std::uint8_t>(4 * (i % 64)), static_cast<std::uint8_t>(4 * (i / 64)), 128});
  GifFilm film({64, 64});
  film.add(smooth, 0.1);
  film.add(Bytes(12), 0.1);
  const auto bytes = film.finish();
  REQUIRE(bytes);
  const Read read = played(*bytes);
  REQUIRE(read.frames.size() == 1);
  CHECK(farthest(read.frames[0].rgb, smooth) <= 40);
}
