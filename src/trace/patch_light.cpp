// What patches see of each other, and what reaches them straight from what shines.

#include "trace/patches.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

Exchange Patches::exchange(int a, int b) const {
  const Patch &one = (*this)[std::min(a, b)], &other = (*this)[std::max(a, b)];
  const double area = flat_ ? strings_between(one.edge(), other.edge()).exchange_length()
                            : exchange_area(one.outline(), other.outline());
  if (!(area > 0)) return {0, 1};
  const int points = flat_ ? 8 : 2;
  const double first = visible_share(one, other, points);
  if (first == 1 || first == 0) return {area, first};
  return {area, visible_share(one, other, flat_ ? 4 * points : 2 * points)};
}

Vec3d Patches::point_on(const Patch& patch, double u, double v) const {
  const auto& c = patch.corner;
  if (flat_) return {Vec2d(c[0]) + u * Vec2d(c[1] - c[0]), 0};
  if (patch.corners == 3) {
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3d point = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
    // Not on an edge, which its neighbour has too.
    constexpr double within = 0.9;
    return patch.centre + within * (point - patch.centre);
  }
  const Vec3d low = c[0] + u * (c[1] - c[0]), high = c[3] + u * (c[2] - c[3]);
  return low + v * (high - low);
}

bool Patches::sees(const Patch& from, const Vec3d& a, const Patch& to, const Vec3d& b) const {
  constexpr double almost = 1 - 1e-9;
  TestCounts uncounted;
  const Ray<double> ray{a, b - a, Departure{from.face, 0}, 0};
  const auto met = occluders_->closest(ray, almost, uncounted);
  return !met || met->primitive == to.face;
}

Vec3d Patches::grid_point(const Patch& patch, int k, int points) const {
  if (flat_) return point_on(patch, (k + 0.5) / points, 0);
  return point_on(patch, (k % points + 0.5) / points, (k / points + 0.5) / points);
}

void Patches::look_along(const Patch& a, const Vec3d& p, const Patch& b, const Vec3d& q, VisibleShare& share) const {
  const Vec3d way = q - p;
  const double square = dot(way, way), cosines = dot(way, a.normal) * -dot(way, b.normal);
  const bool apart = dot(way, a.normal) > 0 && dot(way, b.normal) < 0 && square > 0;
  if (!apart) return;
  const double weight = cosines / (flat_ ? square * std::sqrt(square) : square * square);
  share.all += weight;
  if (sees(a, p, b, q)) share.seen += weight;
}

double Patches::visible_share(const Patch& a, const Patch& b, int points) const {
  VisibleShare share;
  // All pairs of few points; of many, in space, each with four that lie apart.
  const int count = flat_ ? points : points * points, partners = flat_ ? count : std::min(count, 4);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < partners; ++k) {
      const int j = partners == count ? k : (5 * i + k * (count / partners) + k) % count;
      look_along(a, grid_point(a, i, points), b, grid_point(b, j, points), share);
    }
  return share.value();
}

double Patches::visible_share(const Patch& patch, const Vec3d& at, const Patch& source, int points) const {
  VisibleShare share;
  for (int k = 0; k < points * points; ++k) look_along(patch, at, source, grid_point(source, k, points), share);
  return share.value();
}

Patches::LampLight Patches::light_of(const World<double>::Light& light, const Patch& patch, const Vec3d& at,
                                     int grid) const {
  // In a flat world an area light is its middle.
  if (flat_ || light.reach == 0 || light.is_distant) grid = 1;
  LampLight found;
  int hidden = 0, reaching = 0;
  TestCounts uncounted;
  for (int k = 0; k < grid * grid; ++k) {
    const Vec3d to_light = light.direction_to(light.regular(k, grid), at);
    if (!light.shines_along(to_light)) continue;
    if (!(dot(patch.normal, to_light) > 0)) {  // below the horizon
      ++hidden;
      continue;
    }
    if (occluders_->occluded(Ray<double>{at, to_light, Departure{patch.face, 0}, 0}, light.t_far(), uncounted)) {
      ++hidden;
      continue;
    }
    ++reaching;
    const double distance = light.distance(to_light);
    const Vec3d l = to_light / distance;
    found.irradiance +=
        light.strength * (light.falloff(l) * dot(patch.normal, l) / light.attenuation(distance) / (grid * grid));
  }
  found.irradiance *= cosines();
  found.partly_hidden = hidden > 0 && reaching > 0;
  return found;
}

Rgbd Patches::light_of_lamps(int index) const {
  Rgbd sum(0.0);
  if (!world_) return sum;
  const Patch& patch = (*this)[index];
  const int points = flat_ ? 16 : 3, count = flat_ ? points : points * points;
  for (const World<double>::Light& light : world_->lights)
    for (int k = 0; k < count; ++k)
      sum += light_of(light, patch, grid_point(patch, k, points), 3).irradiance / static_cast<double>(count);
  return sum;
}

Rgbd Patches::straight_light(int index, const Vec3d& at, const std::vector<int>& sources) const {
  constexpr int few = 2, many = 6;  // rays along each side of a light: many where it is near or partly hidden
  constexpr double near = 4;        // of its reach
  const Patch& patch = (*this)[index];
  Rgbd sum(0.0);
  for (const int id : sources) {
    const Patch& source = (*this)[id];
    if (source.face == patch.face || !in_front(source, at)) continue;
    const double factor = point_factor(at, patch.normal, source.outline());
    if (!(factor > 0)) continue;
    double visible = visible_share(patch, at, source, few);
    if (visible > 0 && visible < 1) visible = visible_share(patch, at, source, many);
    sum += factor * visible * source.emission;
  }
  for (const World<double>::Light& light : world_->lights) {
    const bool is_near = !light.is_distant && length(light.direction_to(light.place, at)) < near * light.reach;
    LampLight found = light_of(light, patch, at, is_near ? many : few);
    if (found.partly_hidden && !is_near) found = light_of(light, patch, at, many);
    sum += found.irradiance;
  }
  return sum;
}

}  // namespace raywalk
