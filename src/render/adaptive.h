#pragma once

#include "render/film.h"
#include "trace/kernel.h"

#include <cstdint>
#include <vector>

namespace raywalk {

/// Adaptive sampling: a pixel takes samples until it is known accurately enough.
///
/// After 16, 32, 64 ... samples every pixel is examined. It is known when in each channel the 95% interval of its mean,
/// as a screen shows it (sRGB, 0..1), reaches at most `tolerance` to either side, and it takes no more samples when the
/// eight pixels around it are known too: detail that the few samples of one pixel miss is usually hit in a neighbour.
///
/// The confidence holds for all examinations together. Stopping at the first of L that succeeds errs more often than a
/// single one would, so each uses the interval of Student's distribution at 1 - 0.05 / L (Bonferroni). Samples are
/// treated as independent: for jittered and Sobol samples, which are better distributed, the interval is too wide
/// rather than too narrow. What no sample has hit, here or in a neighbour, cannot be known.
template <class T>
class Adaptive {
 public:
  static constexpr int first_look = 16;
  static constexpr double confidence = 0.95;

  /// `most`: maximum samples per pixel. With a tolerance of 0 every pixel takes them all.
  Adaptive(ImageSize size, int most, double tolerance);

  /// Takes only the samples of these blocks, which may overlap; to be called first. Pixels within reach() of a block's
  /// edge may end too soon, since what lies beyond is not looked at.
  void restrict_to(const std::vector<PixelBlock>& blocks);
  /// How far away a pixel can be that decides how many samples another takes.
  [[nodiscard]] int reach() const { return looks_; }

  /// The samples of the current pass: every active pixel takes those in from() .. to() - 1.
  [[nodiscard]] int from() const { return from_; }
  [[nodiscard]] int to() const { return to_; }
  [[nodiscard]] bool all_active() const { return active_.empty(); }
  [[nodiscard]] bool is_active(int column, int row) const { return all_active() || active_[index(column, row)] != 0; }

  /// Calls `trace(begin, end)` for each run of active columns of a row, from `begin` up to `end`.
  template <class Trace>
  void for_each_run(int row, int begin, int end, Trace trace) const {
    for (int from = begin, to = begin; from < end; from = to) {
      const bool active = is_active(from, row);
      while (to < end && is_active(to, row) == active) ++to;
      if (active) trace(from, to);
    }
  }

  /// Adds a sample of an active pixel, in order; also to the film. Other pixels may be added to concurrently.
  void add(Film<T>& film, int column, int row, int sample, const Rgb<T>& shade) {
    if (spread_.empty()) return film.add(column, row, sample, shade);
    const Vec3d before(film.at(column, row));
    film.add(column, row, sample, shade);
    const Vec3d value(shade);
    if (sample > 0)
      spread_[index(column, row)] += Vec3<float>((value - before) * (value - Vec3d(film.at(column, row))));
  }

  /// Ends the pass: examines the pixels, and returns whether any continues.
  [[nodiscard]] bool next(const Film<T>& film);

  /// The samples that all pixels together will have taken if no remaining pixel stops early.
  [[nodiscard]] std::uint64_t expected() const { return expected_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool is_known(const Rgb<T>& mean, const Vec3<float>& spread, double quantile) const;

  ImageSize size_;
  int most_, from_ = 0, to_, looks_ = 0;
  double tolerance_;
  std::uint64_t expected_;
  std::vector<Vec3<float>> spread_;   ///< sum of squared deviations; empty without adaptive sampling
  std::vector<std::uint8_t> active_;  ///< empty: all are
};

/// The two-sided quantile of Student's distribution with `freedom` (>= 15) degrees: |t| exceeds it with this
/// probability.
[[nodiscard]] double student_quantile(double two_sided, int freedom);

extern template class Adaptive<float>;
extern template class Adaptive<double>;

}  // namespace raywalk
