// An animated GIF, read by giflib and shown frame by frame; and how far frames are from what they should be.
#pragma once

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "image/palette.h"
#include "support/catch.h"

namespace raywalk::test {

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

// Plays a GIF as a viewer does.
inline Read played(const std::string& bytes) {
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

struct Errors {
  double mean = 0, ninety_ninth = 0;  // OKLab: 0.02 can just be seen
};
inline Errors errors_of(std::vector<double> distances) {
  std::sort(distances.begin(), distances.end());
  double sum = 0;
  for (const double d : distances) sum += d;
  return {sum / static_cast<double>(distances.size()), distances[distances.size() * 99 / 100]};
}

// Between the means of squares of this edge: 1 of single pixels, more of what one sees from afar.
inline Errors errors(const Bytes& a, const Bytes& b, int width, int edge) {
  REQUIRE(a.size() == b.size());
  const int height = static_cast<int>(a.size()) / 3 / width;
  const auto lab = [](const Bytes& rgb, std::size_t at) {
    return lab_of(Rgb24{rgb[3 * at]} << 16 | Rgb24{rgb[3 * at + 1]} << 8 | Rgb24{rgb[3 * at + 2]});
  };
  std::vector<double> distances;
  for (int top = 0; top + edge <= height; top += edge)
    for (int left = 0; left + edge <= width; left += edge) {
      std::array<double, 3> difference{};
      for (int row = top; row < top + edge; ++row)
        for (int column = left; column < left + edge; ++column) {
          const auto at = static_cast<std::size_t>(row * width + column);
          const Lab was = lab(a, at), is = lab(b, at);
          for (std::size_t i = 0; i < 3; ++i) difference[i] += static_cast<double>(is[i] - was[i]) / (edge * edge);
        }
      distances.push_back(std::hypot(difference[0], difference[1], difference[2]));
    }
  return errors_of(std::move(distances));
}

}  // namespace raywalk::test
