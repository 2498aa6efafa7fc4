#include "study/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raywalk::study {

double solid_angle(const Rectangle& rectangle, double x, double y, double height) {
  const auto corner = [&](double cx, double cy) {
    const double a = cx - x, b = cy - y;
    return std::atan2(a * b, height * std::sqrt(a * a + b * b + height * height));
  };
  return corner(rectangle.x1, rectangle.y1) - corner(rectangle.x0, rectangle.y1) - corner(rectangle.x1, rectangle.y0) +
         corner(rectangle.x0, rectangle.y0);
}

double disk_area_in(const Rectangle& rectangle, double radius) {
  const double from = std::max(rectangle.x0, -radius), to = std::min(rectangle.x1, radius);
  if (!(from < to)) return 0;
  const double r2 = radius * radius;
  const auto half_height = [&](double x) { return std::sqrt(std::max(r2 - x * x, 0.0)); };
  const auto half_area = [&](double x) {
    return (x * half_height(x) + r2 * std::asin(std::clamp(x / radius, -1.0, 1.0))) / 2;
  };
  // Where the circle crosses the sides y0 and y1; in between, each end of a column is on one of them throughout.
  const double at_y0 = half_height(rectangle.y0), at_y1 = half_height(rectangle.y1);
  std::array<double, 6> cuts{from, to, -at_y0, at_y0, -at_y1, at_y1};
  for (double& cut : cuts) cut = std::clamp(cut, from, to);
  std::sort(cuts.begin(), cuts.end());
  double area = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double a = cuts[i], b = cuts[i + 1], reach = half_height((a + b) / 2), of_arc = half_area(b) - half_area(a);
    if (!(a < b) || std::min(rectangle.y1, reach) <= std::max(rectangle.y0, -reach)) continue;
    area += rectangle.y1 < reach ? rectangle.y1 * (b - a) : of_arc;
    area -= rectangle.y0 > -reach ? rectangle.y0 * (b - a) : -of_arc;
  }
  return area;
}

double silhouette_radius(double radius, double distance) {
  return radius / std::sqrt(distance * distance - radius * radius);
}

double disk_form_factor(double radius, double height, double aside) {
  const double r2 = radius * radius, h2 = height * height, a2 = aside * aside;
  const double sum = h2 + a2 + r2;
  return 0.5 * (1 - (h2 + a2 - r2) / std::sqrt(sum * sum - 4 * r2 * a2));
}

double rectangle_form_factor(const Rectangle& rectangle, double height) {
  const auto corner = [&](double x, double y) {
    const double a = std::hypot(x, height), b = std::hypot(y, height);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * std::numbers::pi);
  };
  return corner(rectangle.x1, rectangle.y1) - corner(rectangle.x0, rectangle.y1) - corner(rectangle.x1, rectangle.y0) +
         corner(rectangle.x0, rectangle.y0);
}

double furnace(double emission, double albedo, int length) {
  return albedo == 1 ? emission * length : emission * (1 - std::pow(albedo, length)) / (1 - albedo);
}

}  // namespace raywalk::study
