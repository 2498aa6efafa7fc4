#pragma once
// The mean of a checker over a footprint, in closed form.

#include "trace/ray_differential.h"

namespace raywalk {

/// The share of even squares, in 0..1, of a checker's parallelogram with the sides footprint.x and footprint.y about a
/// position: a box filter over the pixel, as far as the footprint is one. Exact where its sides cross up to 32 squares.
/// Up to 48, the parallelogram goes over into its bounding rectangle, for which the mean is a product of two, nearly
/// 1/2: what is lost are stripes right along a diagonal of far squares, narrower than these.
template <class T>
[[nodiscard]] T even_share(const Vec2<T>& uv, T size, const Footprint<T>& footprint);

extern template float even_share(const Vec2<float>&, float, const Footprint<float>&);
extern template double even_share(const Vec2<double>&, double, const Footprint<double>&);

}  // namespace raywalk
