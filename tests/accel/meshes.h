// Closed meshes to test with.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "shape/mesh.h"

namespace raywalk::test {

// A sphere of 20 * 4^level triangles about `centre`, its corners shared, with normals.
inline Mesh icosphere(int level, const Vec3d& centre = Vec3d(0.0), double radius = 1) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) {
      mesh.normals.push_back({0, a, b});
      mesh.normals.push_back({a, b, 0});
      mesh.normals.push_back({b, 0, a});
    }
  // Faces are the triples of mutual neighbours, turned outwards.
  const auto near = [&](std::size_t i, std::size_t j) { return length(mesh.normals[i] - mesh.normals[j]) < 2.1; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(i, k)) continue;
        const Vec3d &a = mesh.normals[i], &b = mesh.normals[j], &c = mesh.normals[k];
        const bool outwards = raywalk::dot(cross(b - a, c - a), a) > 0;
        const auto index = [](std::size_t n) { return static_cast<std::int32_t>(n); };
        mesh.triangles.push_back({index(i), index(outwards ? j : k), index(outwards ? k : j)});
      }
  for (; level > 0; --level) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto [entry, is_new] = middles.emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.normals.size()));
      if (is_new)
        mesh.normals.push_back(normalize(normalize(mesh.normals[static_cast<std::size_t>(a)]) +
                                         normalize(mesh.normals[static_cast<std::size_t>(b)])));
      return entry->second;
    };
    std::vector<Mesh::Corners> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Mesh::Corners& each : {Mesh::Corners{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(each);
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3d& normal : mesh.normals) {
    normal = normalize(normal);
    mesh.positions.push_back(centre + radius * normal);
  }
  return mesh;
}

}  // namespace raywalk::test
