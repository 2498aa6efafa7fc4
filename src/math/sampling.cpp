#include "math/sampling.h"

namespace raywalk {

SphericalRectangle::SphericalRectangle(const Vec3d& point, const Vec3d& corner, const Axes& axes)
    : length_x_(axes.length_x), length_y_(axes.length_y) {
  const Vec3d to_corner = corner - point;
  x0_ = dot(to_corner, axes.x);
  y0_ = dot(to_corner, axes.y);
  z_ = -std::abs(dot(to_corner, axes.z));  // both sides are equivalent
  x1_ = x0_ + length_x_;
  y1_ = y0_ + length_y_;
  // Normals of the planes through the point and each edge have one component along the rectangle's normal, n_z; the
  // angles between neighbouring planes follow from these alone.
  const auto n_z = [this](double side) { return side / length(Vec2d(side, z_)); };
  const double below = -n_z(y0_), right = n_z(x1_), above = n_z(y1_), left = -n_z(x0_);
  // The sum of two such angles, each in 0..pi: sin is -0 where it is the full turn.
  const auto sum_of_angles = [](double cos_a, double cos_b) {
    const auto sin_of = [](double cos) { return std::sqrt((1 - cos) * (1 + cos)); };
    const double sin_a = sin_of(cos_a), sin_b = sin_of(cos_b);
    const double sin = sin_a * cos_b + cos_a * sin_b, cos = cos_a * cos_b - sin_a * sin_b;
    return portable::atan2(sin, cos) + (std::signbit(sin) ? 2 * pi_v<double> : 0);
  };
  b0_ = below;
  b1_ = above;
  k_ = 2 * pi_v<double> - sum_of_angles(-above * left, -left * below);
  solid_angle_ = z_ < 0 ? sum_of_angles(-below * right, -right * above) - k_ : 0;
}

Vec2d SphericalRectangle::point_at(const Vec2d& unit) const {
  const double phi = unit.x * solid_angle_ + k_;
  const auto [sin, cos] = portable::sin_cos(phi);
  const double f = (cos * b0_ - b1_) / sin;
  const double cu = std::clamp(std::copysign(1 / std::sqrt(f * f + b0_ * b0_), f), -1.0, 1.0);
  const double x = std::clamp(-(cu * z_) / std::max(std::sqrt(1 - cu * cu), 1e-300), x0_, x1_);
  const double d = length(Vec2d(x, z_));
  const double h0 = y0_ / length(Vec2d(d, y0_)), h1 = y1_ / length(Vec2d(d, y1_));
  const double h = h0 + unit.y * (h1 - h0), h2 = h * h;
  const double y = h2 < 1 ? std::clamp(h * d / std::sqrt(1 - h2), y0_, y1_) : y1_;
  return {(x - x0_) / length_x_, (y - y0_) / length_y_};
}

}  // namespace raywalk
