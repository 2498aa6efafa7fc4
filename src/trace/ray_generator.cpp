#include "trace/ray_generator.h"

#include <cmath>
#include <numeric>

namespace raywalk {

template <class T>
Ray<T> RayGenerator<T>::sampled_ray(const Pixel& pixel, Vec2<T> place, PixelDraws& draws,
                                    Statistics& statistics) const {
  if (!draws.hold(pixel)) draw_ahead(pixel, draws);
  if (sampling_.per_pixel > 1) {
    if (draws_) statistics.drew(Effect::antialiasing, 2);
    place += draws.offsets[static_cast<std::size_t>(pixel.sample - draws.first)];
  }
  const Vec3<T> ahead = through(place);
  Vec3<T> origin = eye_, direction = normalize(ahead);
  T time = shutter_open_;
  if (lens_radius_ > 0) {
    // A thin lens: all rays of one pixel position meet in one point of the plane in focus.
    statistics.drew(Effect::depth_of_field, 2);
    const auto drawn = draws.lens.template draw<T>(static_cast<std::uint32_t>(pixel.sample));
    const Vec2<T> on_lens = lens_radius_ * sample_concentric_disk(drawn);
    const Vec3<T> aside = on_lens.x * lens_right_ + on_lens.y * lens_up_;
    origin = eye_ + aside;
    direction = normalize(focus_ * ahead - aside);
  }
  if (moves_) {
    const T share = draw<T>(sampler_, key(pixel, Effect::motion_blur), count());
    statistics.drew(Effect::motion_blur, 1);
    time = time_after(share);
  }
  return {origin, direction, {}, time};
}

template <class T>
void RayGenerator<T>::draw_ahead(const Pixel& pixel, PixelDraws& draws) const {
  draws.column = pixel.column, draws.row = pixel.row;
  draws.first = pixel.sample;
  draws.end = std::clamp(pixel.until, pixel.sample + 1, pixel.sample + PixelDraws::most);
  if (sampling_.per_pixel > 1) {
    const SamplePairs pairs = draws_ ? SamplePairs(sampler_, key(pixel, Effect::antialiasing), strata_) : SamplePairs();
    for (int sample = draws.first; sample < draws.end; ++sample) {
      const Vec2<T> unit = draws_ ? pairs.template draw<T>(static_cast<std::uint32_t>(sample)) : fixed_place(sample);
      draws.offsets[static_cast<std::size_t>(sample - draws.first)] = {2 * unit.x - 1, 2 * unit.y - 1};
    }
  }
  if (lens_radius_ > 0) draws.lens = SamplePairs(sampler_, key(pixel, Effect::depth_of_field), strata_);
}

int cell_of_sample(int sample, int edge) {
  // One column back and about 0.618 of the rows on, by the golden ratio: coprime to the number of cells, since coprime
  // to k.
  const int stride = edge * static_cast<int>(std::lround(0.6180339887498949 * edge)) - 1;
  return static_cast<int>(static_cast<std::int64_t>(sample) * stride % (edge * edge));
}

/// The position of a sample without random numbers: in a k x k grid or, where there is none of as many cells, in a
/// lattice with one sample in each of as many rows and columns.
template <class T>
Vec2<T> RayGenerator<T>::fixed_place(int sample) const {
  const int count = sampling_.per_pixel;
  int edge = 1;
  while (edge * edge < count) ++edge;
  const auto in = [](std::int64_t cell, int cells) { return (static_cast<T>(cell) + T(0.5)) / static_cast<T>(cells); };
  if (edge * edge == count) {
    const int cell = cell_of_sample(sample, edge);
    return {in(cell % edge, edge), in(cell / edge, edge)};
  }
  // The sequence R2 of M. Roberts ("The Unreasonable Effectiveness of Quasirandom Sequences", 2018), so that the first
  // ones are spread, too: its steps in x and y, each made coprime to the number of samples.
  const auto coprime = [count](double share, int other) {
    int step = static_cast<int>(std::lround(share * count));
    while (step > 1 && (std::gcd(step, count) != 1 || step == other)) --step;
    return step;
  };
  const int across = coprime(0.7548776662466927, 0), up = coprime(0.5698402909980532, across);
  const auto at = [&](int step) { return in(static_cast<std::int64_t>(sample) * step % count, count); };
  return {at(across), at(up)};
}

template class RayGenerator<float>;
template class RayGenerator<double>;

}  // namespace raywalk
