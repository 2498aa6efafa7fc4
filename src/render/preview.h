#pragma once
// A picture that comes into being while a person looks on: coarse at once, then fine, then smooth.

#include "render/film.h"
#include "render/heat.h"
#include "render/worlds.h"
#include "trace/kernel.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

/// What a preview shows.
struct PreviewSettings {
  ImageSize size{};  ///< each side >= 1
  Precision precision = Precision::double_;
  int samples = 16;  ///< of each pixel in the end, >= 1
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  /// What the pixels show in place of their colours: what the ray through each one's centre cost, and no samples are
  /// taken; or how far its samples scatter, of which there are then `fewest_for_noise` or more.
  Heat heat = Heat::none;
  static constexpr int fewest_for_noise = 16;
  std::optional<Fault> fault{};  ///< breaks the tracer on purpose
  friend bool operator==(const PreviewSettings&, const PreviewSettings&) = default;
};

/// A render in slices of time.
///
/// First every eighth column of every eighth row is traced, then every fourth, second and first; no pixel is traced
/// twice on the way, and while pixels are missing each traced one is shown as a block around it. The film then equals
/// that of render() at one sample bit for bit. After that come the samples of an antialiased render at `samples`, shown
/// together with the first picture until all are in; the film then equals that of render() at `samples`.
class Preview {
 public:
  Preview();
  Preview(const Scene& scene, const PreviewSettings& settings);
  ~Preview();
  Preview(Preview&&) noexcept;
  Preview& operator=(Preview&&) noexcept;

  /// Starts afresh. Costs the building of the world, where `worlds`, of this scene, do not have it; the picture shown
  /// stays until the first refine when its size is the same, so that an edit does not flicker. Throws Stopped when
  /// `stop` ends that; all is as before then.
  void reset(const Scene& scene, const PreviewSettings& settings, Worlds* worlds = nullptr, const Stop& stop = {});

  /// Works for about `milliseconds`, in up to `threads` threads (0: as many as the machine runs at once): at least one
  /// row, and no longer than that by more than one row; `stop` may end it inside a pixel, and that row is left to do.
  /// Whether anything is left to do.
  bool refine(double milliseconds, int threads = 0, const Stop& stop = {});
  [[nodiscard]] bool finished() const;
  /// Every pixel has been traced once: the film is that of render() at one sample.
  [[nodiscard]] bool has_every_pixel() const;
  /// Share of all samples taken, 0..1.
  [[nodiscard]] double done() const;

  [[nodiscard]] ImageSize size() const;
  /// size().width * size().height pixels of four bytes: red, green and blue in the scene's encoding, and 255; top row
  /// first. What is not a number is magenta.
  [[nodiscard]] const std::vector<std::uint8_t>& rgba() const { return rgba_; }
  /// Another number whenever rgba() has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Of a heat map: the cost that has the last colour; costs above it, if any, have it too. 0 while nothing is traced.
  [[nodiscard]] double hottest() const;
  /// What has been traced since the last reset.
  [[nodiscard]] Statistics statistics() const;

  /// The picture in full: the film of one sample a pixel, and once finished() that of all samples. `T` as in the
  /// settings' precision; before has_every_pixel() the pixels not yet traced are black.
  template <class T>
  [[nodiscard]] const Film<T>& film() const;

 private:
  class Work;
  template <class T>
  class WorkIn;

  std::unique_ptr<Work> work_;  ///< null before the first reset
  std::vector<std::uint8_t> rgba_;
  std::uint64_t revision_ = 0;
};

extern template const Film<float>& Preview::film<float>() const;
extern template const Film<double>& Preview::film<double>() const;

}  // namespace raywalk
