#include "trace/microfacets.h"

#include <mutex>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// The integral of `f` from a to b by Simpson's rule, whose halves are halved again where they differ from the whole.
/// `f_mid`: in the middle.
template <class F>
double simpson(const F& f, double a, double b, double f_a, double f_mid, double f_b, double tolerance, int depth) {
  const double mid = (a + b) / 2, left = f((a + mid) / 2), right = f((mid + b) / 2), size = (b - a) / 6;
  const double whole = size * (f_a + 4 * f_mid + f_b);
  const double halves = size / 2 * (f_a + 4 * left + 2 * f_mid + 4 * right + f_b);
  if (depth == 0 || std::abs(halves - whole) < tolerance) return halves + (halves - whole) / 15;
  return simpson(f, a, mid, f_a, left, f_mid, tolerance / 2, depth - 1) +
         simpson(f, mid, b, f_mid, right, f_b, tolerance / 2, depth - 1);
}
/// Over the parts of 0..1.
template <class F>
double integral(const F& f, double tolerance) {
  constexpr int parts = 4, deepest = 8;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double from = static_cast<double>(i) / parts, to = static_cast<double>(i + 1) / parts;
    sum += simpson(f, from, to, f(from), f((from + to) / 2), f(to), tolerance / parts, deepest);
  }
  return sum;
}

}  // namespace

/// E is the mean of G2 / G1 over the mirrors that the eye sees: over a cap of the sphere, whose height is evenly
/// distributed. What a mirror sends below the surface counts as nothing, which is no smooth end: hence Simpson's rule.
template <class T>
Microfacets<T>::Microfacets(T alpha) : alpha_(std::max(alpha, narrowest)) {
  const double a = static_cast<double>(alpha_);
  const auto root = [a](double cos) { return std::sqrt(a * a + (1 - a * a) * cos * cos); };
  const auto cosine_at = [a](double place) { return std::min(a * place * place / (1 + a - place * place), 1.0); };
  for (std::size_t knot = 0; knot < knots; ++knot) {
    const double cos = std::max(cosine_at(static_cast<double>(knot) / (knots - 1)), 1e-9);
    const Vec3d to_eye(std::sqrt(1 - cos * cos), 0, cos), eye = normalize(Vec3d(a * to_eye.x, 0, to_eye.z));
    const auto at_height = [&](double height) {
      const double z = height * (1 + eye.z) - eye.z, radius = std::sqrt(std::max(1 - z * z, 0.0));
      const auto at_half_turn = [&](double share) {  // left and right are alike
        const auto [sin, cosine] = portable::sin_cos(pi_v<double> * share);
        const Vec3d half =
            normalize(Vec3d(a * (radius * cosine + eye.x), a * radius * sin, std::max(z + eye.z, 1e-12)));
        const double light = 2 * dot(to_eye, half) * half.z - cos;
        return light > 0 ? light * (cos + root(cos)) / (cos * root(light) + light * root(cos)) : 0.0;
      };
      return integral(at_half_turn, 3e-5);
    };
    const double sum = integral(at_height, 3e-5);
    squared_cos_[knot] = static_cast<T>(cos * cos);
    reflectance_[knot] = static_cast<T>(std::min(sum, 1.0));
  }
  constexpr int steps = 2048;
  double mean = 0;
  const auto cosine_of = [](int i) { return static_cast<double>(i) * i / (static_cast<double>(steps) * steps); };
  for (int i = 0; i < steps; ++i) {
    const double low = cosine_of(i), high = cosine_of(i + 1);
    mean += static_cast<double>(reflectance(static_cast<T>((low + high) / 2))) * (high - low) * (high + low);
  }
  mean_ = static_cast<T>(std::min(mean, 1.0));
  squared_cos_[0] = 0;
  for (std::size_t knot = 0; knot + 1 < knots; ++knot) {
    lost_[knot] = 1 - (reflectance_[knot] + reflectance_[knot + 1]) / 2;
    sum_[knot + 1] = sum_[knot] + lost_[knot] * (squared_cos_[knot + 1] - squared_cos_[knot]);
  }
  const T all = sum_.back();
  if (!(all > 0)) return;
  for (T& one : lost_) one /= all;
  for (T& one : sum_) one /= all;
}

template <class T>
std::shared_ptr<const Microfacets<T>> microfacets_of(T alpha) {
  constexpr std::size_t most = 32;
  static std::mutex looking;
  static std::vector<std::pair<T, std::shared_ptr<const Microfacets<T>>>> kept;  // the last asked for is the last
  const std::lock_guard lock(looking);
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const auto& one) { return one.first == alpha; });
  if (found != kept.end()) {
    std::rotate(found, found + 1, kept.end());
  } else {
    if (kept.size() == most) kept.erase(kept.begin());
    kept.emplace_back(alpha, std::make_shared<const Microfacets<T>>(alpha));
  }
  return kept.back().second;
}

template class Microfacets<float>;
template class Microfacets<double>;
template std::shared_ptr<const Microfacets<float>> microfacets_of(float alpha);
template std::shared_ptr<const Microfacets<double>> microfacets_of(double alpha);

}  // namespace raywalk
