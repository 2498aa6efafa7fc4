#include "accel/accelerator.h"
#include "check/aim.h"
#include "check/family.h"

#include <array>
#include <optional>

namespace raywalk::check {

namespace {

/// A closed star-shaped triangle mesh about a point: an octahedron with each face cut in four, its corners moved in or
/// out at random. Neighbours share their corners exactly. Some have a corner of another in the middle of an edge,
/// beside it by rounding alone: a triangle without any width fills the gap.
template <class T>
struct RoughBall {
  Mesh mesh;  ///< its corners as T holds them
  Vec3d centre;
  double size;

  RoughBall(Random& random, double scale, const Vec3d& about) : centre(about), size(scale) {
    std::vector<Vec3d> places = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Mesh::Corners> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
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
        mesh.triangles.push_back(small);
    }
    // Some keep their place on the axes: edges and rays in coordinate planes.
    const bool rough = random.coin();
    for (const Vec3d& place : places) add_corner(about + scale * (rough ? random.real(0.7, 1.3) : 1.0) * place);
    for (std::size_t i = 0, count = mesh.triangles.size(); i < count; i += 2) {
      const auto [a, b, c] = mesh.triangles[i];
      const int between_ab = add_corner(corner(a) + random.real(0.1, 0.9) * (corner(b) - corner(a)));
      mesh.triangles[i] = {between_ab, c, a};
      mesh.triangles.push_back({between_ab, b, c});
      mesh.triangles.push_back({between_ab, a, b});
    }
  }

  [[nodiscard]] const Vec3d& corner(int i) const { return mesh.positions[static_cast<std::size_t>(i)]; }

 private:
  int add_corner(const Vec3d& at) {
    mesh.positions.push_back(wide(Vec3<T>(at)));
    return static_cast<int>(mesh.positions.size()) - 1;
  }
};

/// Rays from inside must cross the surface an odd number of times, rays from outside an even number, one triangle after
/// the other and through a tree.
template <class T>
Tally leaks(bool at_vertex, std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  constexpr std::uint64_t rays_a_mesh = 64;
  std::optional<RoughBall<T>> ball;
  std::optional<Accelerator<T>> list, tree;
  std::vector<ShadowRole> roles;
  std::vector<int> crossed, crossed_in_tree;
  TestCounts counts;
  for (std::uint64_t number = first; number < first + count; ++number) {
    if (!ball || number % rays_a_mesh == 0) {
      Random shape(seed, at_vertex ? 30 : 31, number / rays_a_mesh);
      const double scale = shape.magnitude(-3, 3), reach = std::numeric_limits<T>::digits == 24 ? 3 : 9;
      const Vec3d away = shape.coin() ? Vec3d(0.0) : scale * shape.magnitude(0, reach) * shape.unit();
      ball.emplace(shape, scale, away);
      Primitives<T> primitives;
      primitives.add(ball->mesh, {}, false);
      list.emplace(primitives, AcceleratorKind::none);
      tree.emplace(primitives, AcceleratorKind::bvh);
      roles.assign(ball->mesh.triangles.size(), ShadowRole::filters);
    }
    Random random(seed, at_vertex ? 32 : 33, number);
    const auto& triangles = ball->mesh.triangles;
    const auto [a, b, c] = triangles[static_cast<std::size_t>(random.whole(0, static_cast<int>(triangles.size()) - 1))];
    const Vec3d along = ball->corner(b) - ball->corner(a);
    const Vec3d target = ball->corner(a) + (at_vertex ? 0 : random.real(0, 1)) * along;
    const bool inside = random.coin();
    const double away = ball->size * (inside ? random.real(0, 0.2) : random.magnitude(0.5, 4));
    Vec3d eye = ball->centre + away * random.unit();
    if (random.whole(0, 3) == 0) eye[random.whole(0, 2)] = target[random.whole(0, 2)];
    // Inside or outside is decided from the stored origin, and skipped if in doubt.
    const double distance = length(Vec3d(Vec3<T>(eye)) - ball->centre);
    const bool surely_inside = distance < 0.3 * ball->size, surely_outside = distance > 1.5 * ball->size;
    const auto ray = ray_towards<T>(eye, target, random);
    if (!ray || !(surely_inside || surely_outside)) continue;
    // Crossings filter the light and never stop it: all of them are told.
    const bool stopped = list->occluded_or_filtered(*ray, infinity<T>, counts, roles, crossed) ||
                         tree->occluded_or_filtered(*ray, infinity<T>, counts, roles, crossed_in_tree);
    ++tally.rays;
    tally.hits += !crossed.empty();
    tally.leaks += (crossed.size() % 2 != 0) != surely_inside;
    tally.unequal += stopped || crossed != crossed_in_tree ||
                     tree->closest(*ray, infinity<T>, counts).has_value() == crossed.empty();
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
