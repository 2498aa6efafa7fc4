#include "accel/mesh_copies.h"

#include "accel/float_slabs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace raywalk {
namespace {
/// Twice the rounding error of mapping, in proportion to the sizes of its terms, is less.
constexpr double map_error = 8 * std::numeric_limits<double>::epsilon();

/// Of mapping points whose coordinates are up to `size`.
Vec3d rounding_of(const Affine<double>& map, const Vec3d& size) {
  return map_error * (term_sizes(map, size) + absolute(map.move));
}

/// The tree that all copies of a mesh share, in its own space.
WideTree tree_over(const Mesh& mesh, const BuildOptions& build) {
  std::vector<TreeItem> items;
  items.reserve(mesh.triangles.size());
  const auto corners_of = [&](std::int32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(triangle)];
    const auto at = [&](std::int32_t vertex) { return mesh.positions[static_cast<std::size_t>(vertex)]; };
    return std::array{at(a), at(b), at(c)};
  };
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh.triangles.size()); ++i) {
    build.stop.check();
    const auto [a, b, c] = corners_of(i);
    items.push_back({rounded_out(bounds(Triangle<double>{a, b, c})), i, 1});
  }
  BuildOptions own = build;
  own.watcher = nullptr;  // its boxes are those of no place in the scene
  WideTree tree(std::move(items), own, corners_of);
  tree.fill_packs(build.stop, [&](std::int32_t triangle) { return std::optional(corners_of(triangle)); });
  return tree;
}

}  // namespace

CopyPlace::CopyPlace(const Affine<double>& to_world, const Bounds<double>& box, const Bounds<double>& placed,
                     double rounding)
    : to_mesh_(inverse(to_world).value_or(Affine<double>{})), far_(largest_coordinates(placed)) {
  const Affine<double>&a = to_mesh_, &m = to_world, both = a * m;
  const Vec3d size = largest_coordinates(box);
  // (A M - I) p, in which A M is itself rounded.
  const Affine<double> residue{both.x - Vec3d(1, 0, 0), both.y - Vec3d(0, 1, 0), both.z - Vec3d(0, 0, 1), both.move};
  const Vec3d of_map =
      term_sizes(residue, size) + absolute(residue.move) + rounding_of(a, term_sizes(m, size) + absolute(m.move));
  off_ = 2.0 * (of_map + term_sizes(a, rounding_of(m, size) + rounding * far_));
}

Vec3d CopyPlace::off_at(const Vec3d& origin) const {
  return off_ + rounding_of(to_mesh_, 2.0 * absolute(origin) + far_);
}

double CopyPlace::turned(const Vec3d& direction, const Vec3d& along) const {
  return map_error * max_component(term_sizes(to_mesh_, absolute(direction))) / max_component(absolute(along));
}

template <class T>
MeshCopies<T>::MeshCopies(const Primitives<T>& primitives, const BuildOptions& build) {
  std::map<const Mesh*, std::uint32_t> known;
  std::vector<Bounds<double>> boxes;  // by tree
  std::vector<TreeItem> items;
  double tests = 0;  // expected, times area
  for (const MeshCopy& copy : primitives.triangles().copies()) {
    build.stop.check();
    const auto [entry, is_new] = known.try_emplace(copy.mesh.get(), static_cast<std::uint32_t>(trees_.size()));
    if (is_new) {
      trees_.push_back(std::make_shared<const WideTree>(tree_over(*copy.mesh, build)));
      boxes.push_back(bounds(*copy.mesh));
      statistics_.nodes += trees_.back()->node_count();
      statistics_.references += trees_.back()->item_count();
      statistics_.bytes += trees_.back()->bytes();
      statistics_.depth = std::max(statistics_.depth, trees_.back()->depth());
    }
    const Bounds<double>& box = boxes[entry->second];
    Bounds<double> placed = image_of(copy.to_world, box);
    constexpr double rounding = static_cast<double>(std::numeric_limits<T>::epsilon());
    if (!placed.empty()) {
      // As a primitive's own box is (Primitives::box), and by what mapping it rounds.
      const Vec3d pad =
          8 * rounding * largest_coordinates(placed) + rounding_of(copy.to_world, largest_coordinates(box));
      placed.min -= pad, placed.max += pad;
    }
    tree_of_.push_back(entry->second);
    places_.emplace_back(copy.to_world, box, placed, rounding);
    if (placed.empty()) continue;
    tests += half_area(placed) * trees_[entry->second]->expected_cost();
    items.push_back({rounded_out(placed), static_cast<std::int32_t>(places_.size() - 1), 0});
  }
  over_copies_ = WideTree(std::move(items), build);
  statistics_.nodes += over_copies_.node_count();
  statistics_.references += over_copies_.item_count();
  statistics_.bytes += over_copies_.bytes() + places_.size() * (sizeof(CopyPlace) + sizeof(std::uint32_t));
  statistics_.depth += over_copies_.depth() + 1;
  const double whole = half_area(box());
  statistics_.expected_cost = over_copies_.expected_cost() + (whole > 0 ? tests / whole : 0);
}

template class MeshCopies<float>;
template class MeshCopies<double>;

}  // namespace raywalk
