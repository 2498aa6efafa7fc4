#pragma once
// What the tests of nested bodies share: glass, ways to look along a ray, and the closed forms.

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/catch.h"
#include "trace/paths.h"
#include "trace/sampled.h"

namespace raywalk::test {

// Clear, and all goes through: one ray in, one out.
inline Material clear(double ior, double priority = 0) {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.ior = ior;
  material.priority = priority;
  material.shadow = ShadowKind::filtered;
  return material;
}
inline Material fresnel(double ior) {
  Material material = clear(ior);
  material.dielectric = true;
  return material;
}
// Bends nothing.
inline Material tinted(const Rgbd& absorption, double priority = 0) {
  Material material = clear(1, priority);
  material.absorption = absorption;
  return material;
}

inline Box<double> slab(double from, double to) { return {{from, -90, -90}, {to, 90, 90}}; }

inline PathSettings without_chance() {
  PathSettings settings;
  settings.roulette_from = 1000;
  return settings;
}

// The secondary rays of a ray's tree, in the order in which they were formed.
inline std::vector<RayFormed> secondary_rays(Scene scene, Integrator integrator, const Vec3d& eye,
                                             const Vec3d& target) {
  scene.limits.depth = 30;
  scene.render.integrator = integrator;
  std::vector<RayFormed> formed;
  if (integrator == Integrator::path) {
    Recording recording;
    static_cast<void>(path_picture<double>(looking(scene, eye, target), 1, 1, without_chance(), {}, &recording));
    formed = recording.all<RayFormed>();
  } else {
    formed = record_along(scene, eye, target).all<RayFormed>();
  }
  std::vector<RayFormed> secondary;
  for (const RayFormed& ray : formed)
    if (ray.kind == RayKind::reflect || ray.kind == RayKind::refract) secondary.push_back(ray);
  return secondary;
}
inline constexpr std::array bending_integrators{Integrator::whitted, Integrator::distributed, Integrator::path};

// The indices on both sides of every surface that the ray is refracted at.
using Indices = std::vector<std::pair<double, double>>;
inline void check_indices(const Scene& scene, const Vec3d& eye, const Vec3d& target, const Indices& expected) {
  for (const Integrator integrator : bending_integrators) {
    Indices met;
    for (const RayFormed& ray : secondary_rays(scene, integrator, eye, target))
      if (ray.snell) met.emplace_back(ray.snell->n1, ray.snell->n2);
    CAPTURE(name_of(integrator));
    CHECK(met == expected);
  }
}

// What comes along a ray, by all of them, where nothing is drawn.
inline void check_along(Scene scene, const Vec3d& eye, const Vec3d& target, const Rgbd& expected) {
  scene.limits.depth = 30;
  const auto check = [&](const Rgbd& got) {
    CAPTURE(got.x, got.y, got.z, expected.x, expected.y, expected.z);
    for (int c = 0; c < 3; ++c) CHECK(got[c] == Approx(expected[c]).epsilon(1e-9).margin(1e-300));
  };
  for (const Integrator integrator : {Integrator::whitted, Integrator::distributed}) {
    scene.render.integrator = integrator;
    check(shade_along(scene, eye, target));
  }
  check(light_along(scene, eye, target, 1, without_chance()).mean);
}

inline Rgbd left(const Rgbd& depth) { return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)}; }

inline const Rgbd red(0.1, 0.7, 1.3), blue(1.1, 0.4, 0.2), green(0.5, 0.05, 0.6);

// Unpolarised reflectance by the angles, as Fresnel wrote it.
inline double reflectance(double n1, double n2, double in) {
  const double out = std::asin(n1 * std::sin(in) / n2);
  if (in == 0) return std::pow((n1 - n2) / (n1 + n2), 2);
  const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}

}  // namespace raywalk::test
