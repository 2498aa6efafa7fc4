#include "math/sampling.h"

namespace raywalk {

namespace {

// Complex numbers, for their angles.
Vec2d product(const Vec2d& a, const Vec2d& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Vec2d conjugate(const Vec2d& a) { return {a.x, -a.y}; }

}  // namespace

SphericalRectangle::SphericalRectangle(const Vec3d& point, const Vec3d& corner, const Axes& axes)
    : height_(axes.height) {
  const Vec3d to_corner = corner - point;
  x0_ = dot(to_corner, axes.x);
  y0_ = dot(to_corner, axes.y);
  z_ = std::abs(dot(to_corner, axes.z));  // both sides are equivalent
  x1_ = x0_ + 1;
  y1_ = y0_ + height_;
  // The planes through the point and each edge meet at angles whose sum less the full turn is the solid angle. Between
  // two edges it is a quarter turn and, signed, the angle of the corner that they share: one whose tangent is
  // x y / (z distance). Angles of products are sums, and so one arc tangent does for all four.
  const auto angle_of = [this](double x, double y) { return Vec2d(z_ * std::sqrt(x * x + y * y + z_ * z_), x * y); };
  left_ = product(angle_of(x0_, y1_), conjugate(angle_of(x0_, y0_)));
  const Vec2d all = product(product(angle_of(x1_, y1_), conjugate(angle_of(x1_, y0_))), conjugate(left_));
  const double angle = portable::atan2(all.y, all.x);
  // More than a half turn only where the point is in front of the rectangle, and near.
  const bool near = x0_ < 0 && x1_ > 0 && y0_ < 0 && y1_ > 0 && z_ < std::max(1.0, height_);
  constexpr double edge_on = 1e-100;  // below, products of lengths have no digits
  solid_angle_ = !(z_ > edge_on) ? 0 : angle < 0 && near ? angle + 2 * pi_v<double> : std::max(angle, 0.0);
}

Vec2d SphericalRectangle::point_at(const Vec2d& unit) const {
  // Which x cuts off that share of the solid angle?
  const double z2 = z_ * z_, squared0 = y0_ * y0_ + z2, squared1 = y1_ * y1_ + z2;
  const double b0 = -y0_ / std::sqrt(squared0), b1 = y1_ / std::sqrt(squared1);
  const auto [sin_share, cos_share] = portable::sin_cos(unit.x * solid_angle_);
  const Vec2d phi = -product(left_ / length(left_), {cos_share, sin_share});
  const double f = phi.x * b0 - b1, below = f * f - phi.y * phi.y * (z2 / squared0);
  const double far = std::copysign(z_ * phi.y / std::sqrt(std::max(below, 1e-300)), f * phi.y);
  const double x = std::clamp(far, x0_, x1_);
  // Which y that share of the arc at x?
  const double d2 = x * x + z2;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + unit.y * (h1 - h0), h2 = h * h;
  const double y = h2 < 1 ? std::clamp(h * std::sqrt(d2 / (1 - h2)), y0_, y1_) : y1_;
  return {x - x0_, std::min((y - y0_) / height_, 1.0)};
}

}  // namespace raywalk
