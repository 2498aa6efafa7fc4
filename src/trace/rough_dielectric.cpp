#include "trace/rough_dielectric.h"

#include "trace/facet_integral.h"
#include "trace/kept_tables.h"

namespace raywalk {

namespace {

/// A boundary seen from a medium of `index`, beyond which it is `beyond`.
struct Seen {
  double alpha, index, beyond;

  [[nodiscard]] double root(double cos) const { return std::sqrt(alpha * alpha + (1 - alpha * alpha) * cos * cos); }
  /// What a facet reflects, and what it transmits, over what is seen of it: what arrives on the wrong side of the
  /// surface counts as nothing.
  [[nodiscard]] double reflected(const Vec3d& to_eye, const Vec3d& half) const {
    const double cos = to_eye.z, light = 2 * dot(to_eye, half) * half.z - cos;
    if (!(light > 0)) return 0;
    return refraction_at(-to_eye, half, index, beyond).fresnel() * light * (cos + root(cos)) /
           (cos * root(light) + light * root(cos));
  }
  [[nodiscard]] double transmitted(const Vec3d& to_eye, const Vec3d& half) const {
    const Refraction<double> at = refraction_at(-to_eye, half, index, beyond);
    const auto sent = refract(-to_eye, half, at);
    if (!sent || !(sent->z < 0)) return 0;
    return (1 - at.fresnel()) * 2 * -sent->z / (-sent->z + root(sent->z));
  }
};

/// The mean over the hemisphere, by the cosine, of what a smooth boundary reflects of light from the rarer side.
double mean_fresnel(double rarer, double denser) {
  constexpr int steps = 2048;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cos = (i + 0.5) / steps;
    sum += refraction_at(Vec3d(std::sqrt(1 - cos * cos), 0, -cos), Vec3d(0, 0, 1), rarer, denser).fresnel() * 2 * cos;
  }
  return sum / steps;
}

template <class T>
DirectionalAlbedo<T, true> albedo_of(const Seen& seen) {
  std::array<double, DirectionalAlbedo<T, true>::knots> at_knots{};
  for (std::size_t knot = 0; knot < at_knots.size(); ++knot)
    at_knots[knot] = detail::mean_over_facets(seen.alpha, DirectionalAlbedo<T, true>::cos_of(knot, seen.alpha), 1e-4,
                                              [&](const Vec3d& to_eye, const Vec3d& half) {
                                                return seen.reflected(to_eye, half) + seen.transmitted(to_eye, half);
                                              });
  return {static_cast<T>(seen.alpha), at_knots};
}

}  // namespace

template <class T>
RoughDielectric<T>::Boundary::Boundary(T alpha, T own_index, T other_index)
    : index(own_index),
      albedo(albedo_of<T>(
          {static_cast<double>(alpha), static_cast<double>(own_index), static_cast<double>(other_index)})) {
  const Seen seen{static_cast<double>(alpha), static_cast<double>(own_index), static_cast<double>(other_index)};
  for (std::size_t i = 0; i <= steps; ++i) {
    // It only says how often each lobe is asked for: need not be fine.
    const double cos = std::max(static_cast<double>(i) / steps, 1e-9);
    reflected[i] = static_cast<T>(
        detail::mean_over_facets(seen.alpha, cos, 1e-3, [&](const auto&... a) { return seen.reflected(a...); }));
  }
}

template <class T>
RoughDielectric<T>::RoughDielectric(T alpha, T one, T other)
    : Ggx<T>(alpha),
      sides_{Boundary(this->alpha(), std::min(one, other), std::max(one, other)),
             Boundary(this->alpha(), std::max(one, other), std::min(one, other))} {
  Boundary &rarer = sides_[0], &denser = sides_[1];
  const T rarer_loss = 1 - rarer.albedo.mean(), denser_loss = 1 - denser.albedo.mean();
  mean_ = 1 - (rarer_loss + denser_loss) / 2;
  const T most = std::max(rarer_loss, denser_loss);
  if (!(most > 0)) return;
  const T passed =
      static_cast<T>(1 - mean_fresnel(static_cast<double>(rarer.index), static_cast<double>(denser.index)));
  const T ratio = rarer.index / denser.index;
  rarer.through = passed * denser_loss / most;
  denser.through = passed * ratio * ratio * rarer_loss / most;
}

template <class T>
std::shared_ptr<const RoughDielectric<T>> rough_dielectric_of(T alpha, T one, T other) {
  static detail::KeptTables<std::array<T, 3>, RoughDielectric<T>> kept;
  return kept.of({alpha, std::min(one, other), std::max(one, other)},
                 [&] { return std::make_shared<const RoughDielectric<T>>(alpha, one, other); });
}

template class RoughDielectric<float>;
template class RoughDielectric<double>;
template std::shared_ptr<const RoughDielectric<float>> rough_dielectric_of(float alpha, float one, float other);
template std::shared_ptr<const RoughDielectric<double>> rough_dielectric_of(double alpha, double one, double other);

}  // namespace raywalk
