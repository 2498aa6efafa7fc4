#pragma once
// Image textures over a footprint, from a pyramid of the image: L. Williams, "Pyramidal Parametrics", SIGGRAPH 1983
// (trilinear), and P. Heckbert, "Fundamentals of Texture Mapping and Image Warping", Berkeley 1989 (elliptical weighted
// average).

#include "image/image.h"
#include "trace/ray_differential.h"
#include "trace/texture.h"

#include <memory>
#include <vector>

namespace raywalk {

/// An image, and the same in half as many pixels each way, and again, down to one. Each pixel is the mean of what it
/// covers of the level before.
class TexturePyramid {
 public:
  explicit TexturePyramid(std::shared_ptr<const Image> image);

  [[nodiscard]] int size() const { return 1 + static_cast<int>(smaller_.size()); }
  [[nodiscard]] const Image& level(int i) const { return i == 0 ? *image_ : smaller_[static_cast<std::size_t>(i - 1)]; }

  /// The colour at (u, v), of which the first copy spans 0..1: bilinear in the two levels between whose pixels the
  /// longer derivative of the footprint lies, and linear between these. `footprint`: in copies.
  template <class T>
  [[nodiscard]] Rgb<T> trilinear(T u, T v, const Footprint<T>& footprint, ImageWraps wraps = {}) const;
  /// The mean over the ellipse of the footprint, by a Gaussian that ends where it is e^-2. It is taken from the levels
  /// in which the ellipse is about two pixels narrow; one that is more than 16 times as long as narrow is widened.
  template <class T>
  [[nodiscard]] Rgb<T> ewa(T u, T v, const Footprint<T>& footprint, ImageWraps wraps = {}) const;

 private:
  template <class T>
  [[nodiscard]] Rgb<T> ewa_of_level(int level, T u, T v, const Footprint<T>& footprint, ImageWraps wraps) const;
  /// Of `width` pixels of the image: the level whose pixels are so wide, between two of them, at least 0.
  template <class T>
  struct Between {
    int level;
    T share;  ///< of the level above it
  };
  template <class T>
  [[nodiscard]] Between<T> level_of(T width) const;

  std::shared_ptr<const Image> image_;
  std::vector<Image> smaller_;
};

extern template Rgb<float> TexturePyramid::trilinear(float, float, const Footprint<float>&, ImageWraps) const;
extern template Rgb<double> TexturePyramid::trilinear(double, double, const Footprint<double>&, ImageWraps) const;
extern template Rgb<float> TexturePyramid::ewa(float, float, const Footprint<float>&, ImageWraps) const;
extern template Rgb<double> TexturePyramid::ewa(double, double, const Footprint<double>&, ImageWraps) const;

}  // namespace raywalk
