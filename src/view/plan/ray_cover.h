#pragma once
// Where the rays of a walk lie thick in the plan. Included only by the files of this folder that place names.

#include "view/plan/painter.h"

#include <cstddef>
#include <vector>

namespace raywalk {

/// How much of each part of the pane the rays of the whole walk cover: those of all its pixels, so that names keep off
/// rays and yet stay where they are while it goes on.
class RayCover {
 public:
  explicit RayCover(const Painter& painter);
  /// The part of a box that lies on rays, of a pixel's rays on average.
  [[nodiscard]] double of(const PixelRect& box) const;

 private:
  /// Of a cell while rays are added; then of all cells above and left of this one, it included. Cells count from 1.
  [[nodiscard]] double& at(std::size_t column, std::size_t row) { return sums_[row * (columns_ + 1) + column]; }
  [[nodiscard]] double at(std::size_t column, std::size_t row) const { return sums_[row * (columns_ + 1) + column]; }
  void add(const Painter& painter, const RayRecord& ray, double times);
  void add(const Painter& painter, const Vec2d& from, const Vec2d& end, double times);

  double cell_, pixels_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> sums_;  ///< empty: no rays are shown
};

}  // namespace raywalk
