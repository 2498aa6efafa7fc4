// The meshes of mesh_race.cpp, each with a camera and a light.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "io/mesh_file.h"

namespace raywalk::race_meshes {

struct Subject {
  std::string name;
  Mesh mesh;
  Vec3d eye, look_at, up;
  double field = 50;  // degrees, of height and width
  Vec3d light;
};

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double real(double low, double high) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t mixed = (state_ ^ state_ >> 29) * 0xbf58476d1ce4e5b9U;
    return low + (high - low) * static_cast<double>(mixed >> 11) * 0x1p-53;
  }
  Vec3d unit() {
    const double z = real(-1, 1), angle = real(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::uint64_t state_;
};

inline std::optional<Subject> bunny() {
  const char* told = std::getenv("RAYWALK_SHARED_DIR");
  for (const std::string& shared : {std::string(told ? told : ""), std::string(RAYWALK_SOURCE_DIR "/../shared"),
                                    std::string(RAYWALK_SOURCE_DIR "/../../shared")}) {
    const std::string path = shared + "/data/bunny_room.ply";
    if (shared.empty() || !std::filesystem::exists(path)) continue;
    const auto file = read_mesh(path);
    if (!file) {
      std::fprintf(stderr, "%s\n", file.error().text().c_str());
      return std::nullopt;
    }
    return Subject{"bunny room", *file->mesh, {2.4184, 6.36349, 10.4013}, {-1.0816, 3.86349, -0.0987129},
                   {0, 1, 0},    50,          {-1.0816, 15.8, -0.1}};
  }
  return std::nullopt;
}

// A rolling surface of 2 n^2 triangles over [-1, 1]^2, seen from above its rim.
inline Subject hills(const std::string& name, int n) {
  Subject all{name, {}, {-1.1, -0.9, 0.8}, {0.1, 0.1, 0}, {0, 0, 1}, 60, {0.3, -0.2, 2}};
  const auto height = [](double x, double y) {
    return 0.12 * std::sin(7 * x + 1.3 * y) * std::cos(5 * y - 2 * x) + 0.03 * std::sin(41 * x) * std::sin(37 * y) +
           0.004 * std::sin(203 * x + 7) * std::cos(177 * y);
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = -1 + 2.0 * i / n, y = -1 + 2.0 * j / n;
      all.mesh.positions.push_back({x, y, height(x, y)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, c = a + n + 1;
      all.mesh.triangles.push_back({a, a + 1, c + 1});
      all.mesh.triangles.push_back({a, c + 1, c});
    }
  return all;
}

// A lattice of sticks in all three directions, each of eight triangles hundreds of times as long as wide.
inline Subject slivers() {
  Subject all{"slivers", {}, {2.2, 1.7, 1.9}, {0, 0, 0}, {0, 0, 1}, 60, {0.4, 0.7, 1.5}};
  constexpr int n = 40;
  for (int axis = 0; axis < 3; ++axis)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const auto first = static_cast<std::int32_t>(all.mesh.positions.size());
        for (const double end : {-1.0, 1.0})
          for (int corner = 0; corner < 4; ++corner) {
            Vec3d at(0.0);
            // Tilted, so that no box fits.
            at[axis] = end;
            at[(axis + 1) % 3] = -1 + 2.0 * (i + 0.5) / n + 0.03 * end * (j % 7 - 3) + (corner % 2) * 0.003;
            at[(axis + 2) % 3] = -1 + 2.0 * (j + 0.5) / n + 0.03 * end * (i % 5 - 2) + (corner / 2) * 0.003;
            all.mesh.positions.push_back(at);
          }
        for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}}) {
          all.mesh.triangles.push_back({first + a, first + b, first + b + 4});
          all.mesh.triangles.push_back({first + a, first + b + 4, first + a + 4});
        }
      }
  return all;
}

// Triangles anywhere, large enough to overlap a hundred others.
inline Subject soup() {
  Subject all{"soup", {}, {2.2, 1.7, 1.9}, {0, 0, 0}, {0, 0, 1}, 60, {0.4, 0.7, 3}};
  Numbers next(17);
  for (std::int32_t i = 0; i < 50000; ++i) {
    const Vec3d at(next.real(-1, 1), next.real(-1, 1), next.real(-1, 1));
    const double size = std::pow(next.real(0.1, 1), 4) * 0.3;
    for (int corner = 0; corner < 3; ++corner) all.mesh.positions.push_back(at + size * next.unit());
    all.mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return all;
}

}  // namespace raywalk::race_meshes
