#include "view/plan/ray_cover.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

RayCover::RayCover(const Painter& painter) : cell_(6 * painter.sizes.unit) {
  if (painter.state.walk.mode != Mode::trace) return;
  const Timeline& timeline = *painter.state.walk.timeline;
  columns_ = static_cast<std::size_t>(painter.viewport.width / cell_) + 1;
  rows_ = static_cast<std::size_t>(painter.viewport.height / cell_) + 1;
  pixels_ = static_cast<double>(std::max<std::size_t>(timeline.pixels().size(), 1));
  sums_.assign((columns_ + 1) * (rows_ + 1), 0);
  constexpr std::size_t many = 2000;  // of more rays, some stand for all
  const std::size_t stride = timeline.rays().size() / many + 1;
  // The pixel that a lesson begins with is looked at more than all others.
  const int own = rays_shown(painter.state).first_pixel;
  for (std::size_t i = 0; i < timeline.rays().size(); i += stride) {
    const RayRecord& ray = timeline.rays()[i];
    add(painter, ray, static_cast<double>(stride) * (own > 0 && ray.pixel == own ? 1 + pixels_ / 2 : 1));
  }
  for (std::size_t row = 1; row <= rows_; ++row)
    for (std::size_t column = 1; column <= columns_; ++column)
      at(column, row) += at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1);
}

double RayCover::of(const PixelRect& box) const {
  if (sums_.empty()) return 0;
  const auto place = [&](double pixels, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(std::floor(pixels / cell_), 0.0, static_cast<double>(count - 1)));
  };
  const std::size_t left = place(box.min.x, columns_), right = place(box.max.x, columns_) + 1,
                    top = place(box.min.y, rows_), bottom = place(box.max.y, rows_) + 1;
  const double all = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  return all / (static_cast<double>((right - left) * (bottom - top)) * pixels_);
}

void RayCover::add(const Painter& painter, const RayRecord& ray, double times) {
  if (ray.beam >= 0 && painter.state.walk.timeline->of_beams()) {
    const BeamArea& area = painter.state.walk.timeline->beams()[static_cast<std::size_t>(ray.beam)].area;
    for (const std::size_t side : {std::size_t{0}, area.starts.size() - 1})
      add(painter, painter.pixels(plan(area.starts[side])), painter.pixels(plan(area.ends[side])), times);
    return;
  }
  if (const auto way = ray.formed ? ray_way(painter, ray, true) : std::nullopt) add(painter, way->from, way->to, times);
}

void RayCover::add(const Painter& painter, const Vec2d& from, const Vec2d& end, double times) {
  const Vec2d to = painter.seen_end(from, end);
  constexpr double most = 1000;
  const auto steps = static_cast<int>(std::min(length(to - from) / cell_, most)) + 1;
  for (int i = 0; i < steps; ++i) {
    const Vec2d place = (from + (i + 0.5) / steps * (to - from)) / cell_;
    if (place.x >= 0 && place.y >= 0 && place.x < static_cast<double>(columns_) && place.y < static_cast<double>(rows_))
      at(static_cast<std::size_t>(place.x) + 1, static_cast<std::size_t>(place.y) + 1) += times;
  }
}

}  // namespace raywalk
