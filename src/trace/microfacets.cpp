#include "trace/microfacets.h"

#include "trace/facet_integral.h"
#include "trace/kept_tables.h"

namespace raywalk {

namespace {

/// E is the mean of G2 / G1 over the mirrors that the eye sees; what a mirror sends below the surface counts as
/// nothing.
template <class T>
DirectionalAlbedo<T> albedo_of_mirrors(T alpha) {
  const double a = static_cast<double>(alpha);
  const auto root = [a](double cos) { return std::sqrt(a * a + (1 - a * a) * cos * cos); };
  std::array<double, DirectionalAlbedo<T>::knots> at_knots{};
  for (std::size_t knot = 0; knot < at_knots.size(); ++knot) {
    const double cos = DirectionalAlbedo<T>::cos_of(knot, a);
    const double sum = detail::mean_over_facets(a, cos, 3e-5, [&](const Vec3d& to_eye, const Vec3d& half) {
      const double light = 2 * dot(to_eye, half) * half.z - cos;
      return light > 0 ? light * (cos + root(cos)) / (cos * root(light) + light * root(cos)) : 0.0;
    });
    at_knots[knot] = sum;
  }
  return {alpha, at_knots};
}

}  // namespace

template <class T, bool is_even>
double DirectionalAlbedo<T, is_even>::cos_of(std::size_t knot, double alpha) {
  const double place = static_cast<double>(knot) / (knots - 1);
  constexpr double least = 1e-9;
  if constexpr (!is_even) return std::max(std::min(alpha * place * place / (1 + alpha - place * place), 1.0), least);
  double low = 0, high = 1;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double mid = (low + high) / 2;
    (std::sqrt(mid * (1 + alpha) / (mid + alpha)) + mid < 2 * place ? low : high) = mid;
  }
  return std::max(high, least);
}

template <class T, bool is_even>
DirectionalAlbedo<T, is_even>::DirectionalAlbedo(T alpha, const std::array<double, knots>& at_knots) : alpha_(alpha) {
  for (std::size_t knot = 0; knot < knots; ++knot) {
    const double cos = cos_of(knot, static_cast<double>(alpha));
    squared_cos_[knot] = static_cast<T>(cos * cos);
    albedo_[knot] = static_cast<T>(std::min(at_knots[knot], 1.0));
  }
  constexpr int steps = 2048;
  double mean = 0;
  const auto cosine_of = [](int i) { return static_cast<double>(i) * i / (static_cast<double>(steps) * steps); };
  for (int i = 0; i < steps; ++i) {
    const double low = cosine_of(i), high = cosine_of(i + 1);
    mean += static_cast<double>((*this)(static_cast<T>((low + high) / 2))) * (high - low) * (high + low);
  }
  mean_ = static_cast<T>(std::min(mean, 1.0));
  squared_cos_[0] = 0;
  for (std::size_t knot = 0; knot + 1 < knots; ++knot) {
    lost_[knot] = 1 - (albedo_[knot] + albedo_[knot + 1]) / 2;
    sum_[knot + 1] = sum_[knot] + lost_[knot] * (squared_cos_[knot + 1] - squared_cos_[knot]);
  }
  const T all = sum_.back();
  if (!(all > 0)) return;
  for (T& one : lost_) one /= all;
  for (T& one : sum_) one /= all;
}

template <class T>
Microfacets<T>::Microfacets(T alpha) : Ggx<T>(alpha), albedo_(albedo_of_mirrors(this->alpha())) {}

template <class T>
std::shared_ptr<const Microfacets<T>> microfacets_of(T alpha) {
  static detail::KeptTables<T, Microfacets<T>> kept;
  return kept.of(alpha, [&] { return std::make_shared<const Microfacets<T>>(alpha); });
}

template class DirectionalAlbedo<float>;
template class DirectionalAlbedo<double>;
template class DirectionalAlbedo<float, true>;
template class DirectionalAlbedo<double, true>;
template class Microfacets<float>;
template class Microfacets<double>;
template std::shared_ptr<const Microfacets<float>> microfacets_of(float alpha);
template std::shared_ptr<const Microfacets<double>> microfacets_of(double alpha);

}  // namespace raywalk
