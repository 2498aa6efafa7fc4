#include "math/sampling.h"

namespace raywalk {

SphericalRectangle::SphericalRectangle(const Vec3d& point, const Vec3d& corner, const Vec3d& u, const Vec3d& v)
    : length_x_(length(u)), length_y_(length(v)) {
  const Vec3d x = u / length_x_, y = v / length_y_;
  const Vec3d to_corner = corner - point;
  x0_ = dot(to_corner, x);
  y0_ = dot(to_corner, y);
  z_ = -std::abs(dot(to_corner, cross(x, y)));  // both sides are equivalent
  x1_ = x0_ + length_x_;
  y1_ = y0_ + length_y_;
  // Normals of the planes through the point and each edge have one component along the rectangle's normal, n_z; the
  // angles between neighbouring planes follow from these alone.
  const auto n_z = [this](double side) { return side / std::hypot(side, z_); };
  const double below = -n_z(y0_), right = n_z(x1_), above = n_z(y1_), left = -n_z(x0_);
  const auto angle = [](double a, double b) { return std::acos(std::clamp(-a * b, -1.0, 1.0)); };
  const double g0 = angle(below, right), g1 = angle(right, above), g2 = angle(above, left), g3 = angle(left, below);
  b0_ = below;
  b1_ = above;
  k_ = 2 * pi_v<double> - g2 - g3;
  solid_angle_ = z_ < 0 ? g0 + g1 - k_ : 0;
}

Vec2d SphericalRectangle::point_at(const Vec2d& unit) const {
  const double phi = unit.x * solid_angle_ + k_;
  const double f = (std::cos(phi) * b0_ - b1_) / std::sin(phi);
  const double cu = std::clamp(std::copysign(1 / std::sqrt(f * f + b0_ * b0_), f), -1.0, 1.0);
  const double x = std::clamp(-(cu * z_) / std::max(std::sqrt(1 - cu * cu), 1e-300), x0_, x1_);
  const double d = std::hypot(x, z_);
  const double h0 = y0_ / std::hypot(d, y0_), h1 = y1_ / std::hypot(d, y1_);
  const double h = h0 + unit.y * (h1 - h0), h2 = h * h;
  const double y = h2 < 1 ? std::clamp(h * d / std::sqrt(1 - h2), y0_, y1_) : y1_;
  return {(x - x0_) / length_x_, (y - y0_) / length_y_};
}

}  // namespace raywalk
