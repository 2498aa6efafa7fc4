#include "accel/library.h"

#include "accel/accelerator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace raywalk::accel {

namespace {

template <class T>
std::optional<BuildFailure> why_not(std::span<const T> positions, std::span<const std::uint32_t> indices) {
  if (indices.empty()) return BuildFailure{BuildProblem::no_triangles};
  if (positions.size() % 3 != 0) return BuildFailure{BuildProblem::incomplete_vertex, positions.size()};
  if (indices.size() % 3 != 0) return BuildFailure{BuildProblem::incomplete_triangle, indices.size()};
  if (positions.size() / 3 > max_triangles) return BuildFailure{BuildProblem::too_many, 3 * max_triangles};
  if (indices.size() / 3 > max_triangles) return BuildFailure{BuildProblem::too_many, 3 * max_triangles};
  const auto is_bad = [](T x) { return !(std::abs(static_cast<double>(x)) <= max_coordinate); };
  if (const auto bad = std::find_if(positions.begin(), positions.end(), is_bad); bad != positions.end())
    return BuildFailure{BuildProblem::bad_position, static_cast<std::size_t>(bad - positions.begin())};
  const auto is_outside = [&](std::uint32_t vertex) { return vertex >= positions.size() / 3; };
  if (const auto bad = std::find_if(indices.begin(), indices.end(), is_outside); bad != indices.end())
    return BuildFailure{BuildProblem::bad_index, static_cast<std::size_t>(bad - indices.begin())};
  return std::nullopt;
}

/// Exact arithmetic is exact unless it under- or overflows: products of three of the numbers that are left have all
/// their digits. Those of floats always have.
template <class T>
T without_underflow(T x) {
  if constexpr (std::is_same_v<T, double>) return std::abs(x) < min_coordinate ? 0 : x;
  return x;
}

template <class T>
Primitives<T> primitives_of(std::span<const T> positions, std::span<const std::uint32_t> indices) {
  Mesh mesh;
  mesh.positions.reserve(positions.size() / 3);
  for (std::size_t i = 0; i < positions.size(); i += 3)
    mesh.positions.emplace_back(without_underflow(positions[i]), without_underflow(positions[i + 1]),
                                without_underflow(positions[i + 2]));
  mesh.triangles.reserve(indices.size() / 3);
  const auto vertex = [&](std::size_t i) { return static_cast<std::int32_t>(indices[i]); };
  for (std::size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.push_back({vertex(i), vertex(i + 1), vertex(i + 2)});
  Primitives<T> primitives;
  primitives.add(mesh, {}, false);
  return primitives;
}

/// A query as it is searched: a direction far from 1 is multiplied by 2^exponent, which divides t.
template <class T>
struct Search {
  Ray<T> ray;
  T t_max;
  int exponent = 0;
};

/// Nothing where it can meet nothing.
template <class T>
std::optional<Search<T>> search_of(const RayQuery<T>& query, std::size_t triangles) {
  Search<T> search{{}, query.t_max};
  Ray<T>& ray = search.ray;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int to = static_cast<int>(axis);
    ray.origin[to] = without_underflow(query.origin[axis]);
    ray.direction[to] = query.direction[axis];
    if (!(std::abs(static_cast<double>(ray.origin[to])) <= max_coordinate) || !std::isfinite(ray.direction[to]))
      return std::nullopt;
  }
  if (ray.direction == Vec3<T>(0) || !(query.t_max > 0)) return std::nullopt;
  if (query.leaves < triangles) ray.departure = {static_cast<int>(query.leaves), 0};
  if constexpr (std::is_same_v<T, double>) {  // products of floats are in a double's range
    const Vec3d size = absolute(ray.direction);
    const double largest = max_component(size);
    if (largest < 0x1p-32 || largest > 0x1p32) [[unlikely]] {
      search.exponent = -std::ilogb(largest);
      for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = std::scalbn(ray.direction[axis], search.exponent);
      search.t_max = std::scalbn(std::min(query.t_max, std::numeric_limits<T>::max()), -search.exponent);
    }
    for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = without_underflow(ray.direction[axis]);
  }
  return search;
}

/// The weights of b and c where a ray meets a triangle: from the areas between it and the corners as the ray sees them,
/// not from the point that is rounded, which for small triangles far away lies far outside.
template <class T>
Vec2<T> weights_where_met(const Triangle<T>& triangle, const Ray<T>& of) {
  const ShearedRay<T> ray(of);
  const auto seen = [&](const Vec3<T>& corner) { return plan(ray.sheared([&](int axis) { return corner[axis]; })); };
  const Vec2d a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
  const std::array<double, 3> areas{cross(b, c), cross(c, a), cross(a, b)};
  const double turn = areas[0] + areas[1] + areas[2] < 0 ? -1 : 1;
  // It is met: what has another sign is rounding.
  const auto weight = [&](std::size_t i) { return std::max(turn * areas[i], 0.0); };
  const double sum = weight(0) + weight(1) + weight(2);
  return sum > 0 ? Vec2<T>(Vec2d(weight(1), weight(2)) / sum) : Vec2<T>(0);
}

constexpr std::size_t most_at_once = 64;  ///< rays of a batch that are handed on at once

/// Calls `search(rays, t_max, exponents, at)` with what can meet something, a few neighbours at a time; `at`: where in
/// `queries` each is.
template <class T, class SearchBlock>
void in_blocks(std::span<const RayQuery<T>> queries, std::size_t triangles, const SearchBlock& search) {
  std::array<Ray<T>, most_at_once> rays;
  std::array<T, most_at_once> t_max;
  std::array<int, most_at_once> exponents;
  std::array<std::size_t, most_at_once> at;
  std::size_t count = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (const auto one = search_of(queries[i], triangles)) {
      rays[count] = one->ray, t_max[count] = one->t_max, exponents[count] = one->exponent, at[count] = i;
      ++count;
    }
    if (count < most_at_once && i + 1 < queries.size()) continue;
    search(std::span<const Ray<T>>(rays.data(), count), std::span<const T>(t_max.data(), count), exponents, at);
    count = 0;
  }
}

}  // namespace

const char* words_for(BuildProblem problem) noexcept {
  switch (problem) {
    case BuildProblem::no_triangles:
      return "there are no triangles";
    case BuildProblem::incomplete_vertex:
      return "the number of coordinates is no multiple of three";
    case BuildProblem::incomplete_triangle:
      return "the number of indices is no multiple of three";
    case BuildProblem::bad_position:
      return "a coordinate is not finite, or larger than 1e15";
    case BuildProblem::bad_index:
      return "an index names a vertex that does not exist";
    case BuildProblem::too_many:
      return "there are more than 2^27 triangles or vertices";
    case BuildProblem::no_memory:
      return "there is not enough memory";
  }
  return "";
}

template <class T>
struct TriangleSet<T>::Built {
  Accelerator<T> accelerator;

  [[nodiscard]] TriangleHit<T> told(const Ray<T>& ray, int exponent, const Hit<T>& hit) const {
    const Triangle<T> triangle = accelerator.primitives().triangles()[hit.primitive];
    const Vec2<T> weights = weights_where_met(triangle, ray);
    const T t = exponent == 0 ? hit.t : std::max(std::scalbn(hit.t, exponent), std::numeric_limits<T>::denorm_min());
    return {t, static_cast<std::uint32_t>(hit.primitive), weights.x, weights.y};
  }
};

template <class T>
TriangleSet<T>::TriangleSet(std::shared_ptr<const Built> built) noexcept : built_(std::move(built)) {}

template <class T>
std::variant<TriangleSet<T>, BuildFailure> TriangleSet<T>::build(std::span<const T> positions,
                                                                 std::span<const std::uint32_t> indices) noexcept {
  try {
    if (const auto failure = why_not(positions, indices)) return *failure;
    return TriangleSet(
        std::make_shared<const Built>(Built{Accelerator<T>(primitives_of(positions, indices), AcceleratorKind::bvh)}));
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return BuildFailure{BuildProblem::no_memory};
}

template <class T>
std::optional<TriangleHit<T>> TriangleSet<T>::closest(const RayQuery<T>& query) const noexcept {
  const auto search = search_of(query, size());
  if (!search) return std::nullopt;
  TestCounts counts;
  const auto hit = built_->accelerator.closest(search->ray, search->t_max, counts);
  return hit ? std::optional(built_->told(search->ray, search->exponent, *hit)) : std::nullopt;
}

template <class T>
bool TriangleSet<T>::any(const RayQuery<T>& query) const noexcept {
  const auto search = search_of(query, size());
  TestCounts counts;
  return search && built_->accelerator.occluded(search->ray, search->t_max, counts);
}

template <class T>
void TriangleSet<T>::closest(std::span<const RayQuery<T>> rays,
                             std::span<std::optional<TriangleHit<T>>> hits) const noexcept {
  const std::size_t size = std::min(rays.size(), hits.size());
  std::fill_n(hits.begin(), size, std::nullopt);
  in_blocks(rays.first(size), this->size(),
            [&](const auto& valid, const auto& t_max, const auto& exponents, const auto& at) {
              TestCounts counts;
              std::array<std::optional<Hit<T>>, most_at_once> found;
              built_->accelerator.closest(valid, t_max, std::span(found).first(valid.size()), counts);
              for (std::size_t i = 0; i < valid.size(); ++i)
                if (found[i]) hits[at[i]] = built_->told(valid[i], exponents[i], *found[i]);
            });
}

template <class T>
void TriangleSet<T>::any(std::span<const RayQuery<T>> rays, std::span<bool> met) const noexcept {
  const std::size_t size = std::min(rays.size(), met.size());
  std::fill_n(met.begin(), size, false);
  in_blocks(rays.first(size), this->size(),
            [&](const auto& valid, const auto& t_max, const auto& /*exponents*/, const auto& at) {
              TestCounts counts;
              std::array<bool, most_at_once> found;
              built_->accelerator.occluded(valid, t_max, std::span(found).first(valid.size()), counts);
              for (std::size_t i = 0; i < valid.size(); ++i) met[at[i]] = found[i];
            });
}

template <class T>
std::size_t TriangleSet<T>::size() const noexcept {
  return static_cast<std::size_t>(built_->accelerator.primitives().size());
}

template <class T>
std::size_t TriangleSet<T>::bytes() const noexcept {
  return built_->accelerator.statistics().bytes;
}

template class TriangleSet<float>;
template class TriangleSet<double>;

}  // namespace raywalk::accel
