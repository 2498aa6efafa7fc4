#pragma once
// A progressive picture: coarse at once, then fine, then smooth.

#include "render/film.h"
#include "render/row_tracer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

/// A render in time slices.
///
/// First every eighth column of every eighth row is traced, then every fourth, second and first; no pixel is traced
/// twice, and while pixels are missing each traced one is shown as a block. The film then equals that of render() at
/// one sample bit for bit. Then come the samples of an antialiased render at `samples`, blended with the first picture
/// until all are done; the film then equals that of render() at `samples`.
class Preview {
 public:
  Preview();
  Preview(const Scene& scene, const PreviewSettings& settings);
  ~Preview();
  Preview(Preview&&) noexcept;
  Preview& operator=(Preview&&) noexcept;

  /// Starts over. Builds the world, unless `worlds`, the cache of this scene, has it; a picture of the same size stays
  /// visible until the first refine, so that an edit does not flicker. Throws Stopped when cancelled; nothing has
  /// changed then.
  void reset(const Scene& scene, const PreviewSettings& settings, WorldCache* worlds = nullptr, const Stop& stop = {});

  /// Makes the picture that is still visible black.
  void blank();

  /// The same as reset for rows that others trace: nothing is built, and nothing to refine.
  void reset_elsewhere(const Scene& scene, const PreviewSettings& settings);
  /// Rows to be traced elsewhere, at most so many, each given once: those of this pass, then of the next one, so that
  /// nobody waits for the last row of a pass.
  [[nodiscard]] std::vector<PreviewRow> hand_out(int most);
  /// Rows that were handed out; in any order.
  void take(std::vector<TracedRow> rows);

  /// Works for about `milliseconds`, in up to `threads` threads (0: as many as the machine runs concurrently): at least
  /// one row, and at most one row longer; `stop` may cancel inside a pixel, and that row is then redone. Returns
  /// whether anything is left to do.
  bool refine(double milliseconds, int threads = 0, const Stop& stop = {});
  [[nodiscard]] bool finished() const;
  /// Every pixel has been traced once: the film is that of render() at one sample.
  [[nodiscard]] bool has_every_pixel() const;
  /// Fraction of all samples taken, 0..1.
  [[nodiscard]] double done() const;

  [[nodiscard]] ImageSize size() const;
  /// size().width * size().height pixels of four bytes: red, green and blue in the scene's encoding, and 255; top row
  /// first. NaN is magenta.
  [[nodiscard]] const std::vector<std::uint8_t>& rgba() const { return rgba_; }
  /// Changes whenever rgba() has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Of a heat map: the cost that the last colour stands for, shared by any higher costs. 0 while nothing is traced.
  [[nodiscard]] double hottest() const;
  /// Counters since the last reset.
  [[nodiscard]] Statistics statistics() const;

  /// The full-precision picture: at one sample per pixel, and once finished() with all samples. `T` must match the
  /// settings' precision; pixels not yet traced are black.
  template <class T>
  [[nodiscard]] const Film<T>& film() const;

 private:
  class Work;
  template <class T>
  class WorkIn;

  std::unique_ptr<Work> work_;       ///< null before the first reset
  std::optional<RowTracer> tracer_;  ///< none while rows are traced elsewhere
  std::vector<std::uint8_t> rgba_;
  std::uint64_t revision_ = 0;
};

extern template const Film<float>& Preview::film<float>() const;
extern template const Film<double>& Preview::film<double>() const;

}  // namespace raywalk
