#include "check/aim.h"
#include "check/family.h"

#include <array>
#include <memory>

namespace raywalk::check {

namespace {

/// A closed star-shaped triangle mesh about a point: an octahedron with each face cut in four, its corners moved in or
/// out at random. Neighbours share their corners exactly.
template <class T>
struct Ball32 {
  std::vector<Vec3<T>> corners;
  std::vector<std::array<int, 3>> triangles;
  Vec3d centre;
  double size;

  Ball32(Random& random, double scale, const Vec3d& about) : centre(about), size(scale) {
    std::vector<Vec3d> places = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<int, 3>> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const auto between = [&](int a, int b) {
      const Vec3d middle = normalize(places[static_cast<std::size_t>(a)] + places[static_cast<std::size_t>(b)]);
      for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i] == middle) return static_cast<int>(i);
      places.push_back(middle);
      return static_cast<int>(places.size()) - 1;
    };
    for (const auto& [a, b, c] : faces) {
      const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
      for (const auto& small : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        triangles.push_back(small);
    }
    // Some keep their place on the axes: edges and rays in coordinate planes.
    const bool rough = random.coin();
    for (const Vec3d& place : places)
      corners.emplace_back(about + scale * (rough ? random.real(0.7, 1.3) : 1.0) * place);
  }

  [[nodiscard]] Triangle<T> triangle(std::size_t i) const {
    const auto corner = [&](std::size_t k) { return corners[static_cast<std::size_t>(triangles[i][k])]; };
    return {corner(0), corner(1), corner(2)};
  }
};

/// Rays from inside must cross the surface an odd number of times, rays from outside an even number.
template <class T>
Tally leaks(bool at_vertex, std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  constexpr std::uint64_t rays_a_mesh = 64;
  std::unique_ptr<Ball32<T>> mesh;
  for (std::uint64_t number = first; number < first + count; ++number) {
    if (!mesh || number % rays_a_mesh == 0) {
      Random shape(seed, at_vertex ? 30 : 31, number / rays_a_mesh);
      const double scale = shape.magnitude(-3, 3), reach = std::numeric_limits<T>::digits == 24 ? 3 : 9;
      const Vec3d away = shape.coin() ? Vec3d(0.0) : scale * shape.magnitude(0, reach) * shape.unit();
      mesh = std::make_unique<Ball32<T>>(shape, scale, away);
    }
    Random random(seed, at_vertex ? 32 : 33, number);
    const auto& corners =
        mesh->triangles[static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh->triangles.size()) - 1))];
    const auto corner = [&](std::size_t k) { return Vec3d(mesh->corners[static_cast<std::size_t>(corners[k])]); };
    const Vec3d target = at_vertex ? corner(0) : corner(0) + random.real(0, 1) * (corner(1) - corner(0));
    const bool inside = random.coin();
    const double away = mesh->size * (inside ? random.real(0, 0.2) : random.magnitude(0.5, 4));
    Vec3d eye = mesh->centre + away * random.unit();
    if (random.whole(0, 3) == 0) eye[random.whole(0, 2)] = target[random.whole(0, 2)];
    // Inside or outside is decided from the stored origin, and skipped if in doubt.
    const double distance = length(Vec3d(Vec3<T>(eye)) - mesh->centre);
    const bool surely_inside = distance < 0.3 * mesh->size, surely_outside = distance > 1.5 * mesh->size;
    const auto ray = ray_towards<T>(eye, target, random);
    if (!ray || !(surely_inside || surely_outside)) continue;
    int met = 0;
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i)
      met += intersect(mesh->triangle(i), *ray, infinity<T>).has_value();
    ++tally.rays;
    tally.hits += met > 0;
    tally.leaks += (met % 2 != 0) != surely_inside;
  }
  return tally;
}

}  // namespace

Family mesh_family() {
  Family family{"mesh", "", {}};
  const auto add = [&](const char* name, const char* scalar, auto run, bool at_vertex) {
    family.lines.push_back({name,
                            scalar,
                            [run, at_vertex](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
                              return run(at_vertex, seed, first, count);
                            },
                            {}});
  };
  add("aimed at vertices", "float", leaks<float>, true);
  add("aimed at edges", "float", leaks<float>, false);
  add("aimed at vertices", "double", leaks<double>, true);
  add("aimed at edges", "double", leaks<double>, false);
  return family;
}

}  // namespace raywalk::check
