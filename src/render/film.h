#pragma once

#include "image/image_file.h"
#include "render/zeroed_memory.h"
#include "scene/scene.h"
#include "trace/representable.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace raywalk {

/// The picture while it is rendered: for each pixel the mean of its samples so far, in linear RGB and in the tracer's
/// scalar type. Row 0 is the top one.
template <class T>
class Film {
 public:
  using Pixels = std::vector<Rgb<T>, ZeroedMemory<Rgb<T>>>;

  Film() = default;
  /// Black, without samples.
  explicit Film(ImageSize size)
      : size_(size),
        begun_(size.height),
        means_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

  /// Adds sample number `sample` of a pixel, from 0. The previous ones must have been added, each once. The mean is
  /// updated as m += (x - m) / n: unlike a sum over n, it stays exact when all samples are equal.
  void add(int column, int row, int sample, const Rgb<T>& shade) {
    Rgb<T>& mean = means_[index(column, row)];
    if (sample == 0)
      mean = shade + T(0);  // -0 becomes 0, as below
    else
      mean += (shade - mean) / static_cast<T>(sample + 1);
  }

  /// Sets a pixel to the mean of all its samples.
  void set(int column, int row, const Rgb<T>& mean) { means_[index(column, row)] = mean; }

  [[nodiscard]] const Rgb<T>& at(int column, int row) const { return means_[index(column, row)]; }
  [[nodiscard]] ImageSize size() const { return size_; }
  [[nodiscard]] const Pixels& pixels() const { return means_; }
  /// The rows from the top that may have samples: all, until a cancelled render says otherwise. The pages of the others
  /// were never touched, and touching them may take seconds.
  [[nodiscard]] int begun() const { return begun_; }
  void set_begun(int rows) { begun_ = std::min(rows, size_.height); }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(column);
  }

  ImageSize size_{0, 0};
  int begun_ = 0;
  Pixels means_;
};

/// From a film of the corners of pixels, the film of the pixels: one column and one row fewer.
template <class T>
[[nodiscard]] Film<T> mean_of_corners(const Film<T>& corners) {
  Film<T> film({corners.size().width - 1, corners.size().height - 1});
  film.set_begun(corners.begun());
  for (int row = 0; row < film.begun(); ++row)
    for (int column = 0; column < film.size().width; ++column) {
      const Rgb<T> above = corners.at(column, row) + corners.at(column + 1, row);
      const Rgb<T> below = corners.at(column, row + 1) + corners.at(column + 1, row + 1);
      film.add(column, row, 0, (above + below) / T(4));
    }
  return film;
}

/// Each number rounded to float once.
template <class T>
[[nodiscard]] Image image_of(const Film<T>& film) {
  Image image{film.size().width, film.size().height, {}};
  image.pixels.reserve(film.pixels().size());
  for (const Rgb<T>& mean : film.pixels()) image.pixels.emplace_back(mean);
  return image;
}

/// The same row by row. The film must outlive it.
template <class T>
[[nodiscard]] ImageRows rows_of(const Film<T>& film) {
  const auto row = [&film, pixels = std::vector<Rgb<float>>()](int number) mutable {
    const auto begin = film.pixels().begin() + static_cast<std::ptrdiff_t>(film.size().width) * number;
    pixels.assign(begin, begin + film.size().width);
    return static_cast<const Rgb<float>*>(pixels.data());
  };
  return {film.size().width, film.size().height, film.begun(), row};
}

/// Pixels that are not finite in a picture's file, even though every sample was: sums of very bright ones.
template <class T>
[[nodiscard]] std::size_t not_finite(const Film<T>& film) {
  const auto begun = film.pixels().begin() + static_cast<std::ptrdiff_t>(film.size().width) * film.begun();
  return static_cast<std::size_t>(
      std::count_if(film.pixels().begin(), begun, [](const Rgb<T>& mean) { return !is_representable(mean); }));
}

}  // namespace raywalk
