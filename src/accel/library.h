#pragma once
// raywalk/accel.h: which triangle a ray meets first, and whether it meets any. This header is the manual.
//
//   find_package(raywalk 0.1 REQUIRED)
//   target_link_libraries(program PRIVATE raywalk::accel)
//
//   auto built = raywalk::accel::TriangleSet<float>::build(positions, indices);
//   if (auto* failure = std::get_if<raywalk::accel::BuildFailure>(&built)) ...
//   const auto& triangles = std::get<raywalk::accel::TriangleSet<float>>(built);
//   if (auto hit = triangles.closest({{0, 0, -5}, {0, 0, 1}})) use(hit->triangle, hit->t);
//
// What holds:
// - A hit or a miss is right, as if computed without rounding, for the corners and the ray as given. A closed mesh has
//   no gaps: a ray through an edge or a corner crosses the surface once. A ray in the plane of a triangle does not meet
//   it.
// - The answer does not depend on the processor, on what else is in the set, or on batches.
// - t is rounded: as a rule by a few units in its last place, where the ray grazes the triangle or the triangle is a
//   sliver by as many more times as that makes where they meet doubtful (its condition number). Of triangles whose t
//   differ by less than that either may be told of. What is compared with t_max is t as T holds it; where T cannot hold
//   it there is no hit.
// - Everything const may be called from any number of threads at once. There is no global state.
// - Nothing throws. What build cannot use it says; a query whose origin is beyond `max_coordinate`, with a direction of
//   length 0, or with numbers that are not finite (t_max may be infinite) meets nothing. A query through an edge or a
//   corner may need a few kilobytes of memory for exact arithmetic; where there are none, the program ends.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <variant>

namespace raywalk::accel {

/// No number of a corner or of a ray's origin may be larger, to either side.
inline constexpr double max_coordinate = 1e15;
/// Numbers of corners and of origins that are nearer to 0 count as 0, so that nothing underflows; of directions, those
/// that are as much smaller than the largest one.
inline constexpr double min_coordinate = 0x1p-250;
/// The most triangles, and the most vertices, of one set.
inline constexpr std::size_t max_triangles = std::size_t{1} << 27;
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();

/// The points origin + t direction with 0 < t < t_max. The direction need not have unit length: t counts multiples of
/// it.
template <class T>
struct RayQuery {
  std::array<T, 3> origin{0, 0, 0}, direction{0, 0, 1};
  T t_max = std::numeric_limits<T>::infinity();
  /// The triangle that the ray leaves, if it begins on one: it is not met again at its beginning, nor is one that
  /// shares a corner with it and that rounding put before the origin, so that nothing has to be moved off the surface
  /// by an epsilon. Which of them the ray leaves, too, follows from their turns: of triangles that share an edge
  /// whatever these are; those that share one corner alone should have the same turn, as in a mesh that is wound alike.
  std::uint32_t leaves = no_triangle;
};

/// Where a ray meets a triangle. Of several at the same t it is the one with the lowest number.
template <class T>
struct TriangleHit {
  T t = 0;
  std::uint32_t triangle = no_triangle;  ///< its corners are indices[3 triangle] and the two that follow
  /// Weights of its second and third corner; the first has 1 - u - v. None is below 0, but for the rounding of the sum.
  /// They have the digits of a double less those by which the triangle is smaller than its distance, rounded to T.
  T u = 0, v = 0;
};

/// Why no set was built.
enum class BuildProblem {
  no_triangles,         ///< there is no index at all
  incomplete_vertex,    ///< the positions are no multiple of three numbers
  incomplete_triangle,  ///< the indices are no multiple of three
  bad_position,         ///< one is not finite, or beyond max_coordinate
  bad_index,            ///< there is no vertex of that number
  too_many,             ///< more than max_triangles triangles or vertices
  no_memory
};
struct BuildFailure {
  BuildProblem problem = BuildProblem::no_memory;
  std::size_t at = 0;  ///< of the first bad number: its place in positions or indices
};
/// A sentence for people, in English.
[[nodiscard]] const char* words_for(BuildProblem problem) noexcept;

/// Triangles, ready to be met by rays. T is float or double: what corners and rays are given in. Movable; copies share
/// what was built.
template <class T>
class TriangleSet {
 public:
  /// From x, y, z of each vertex and three vertices, from 0, of each triangle. Both are copied. Takes about 60 bytes
  /// a triangle beside the copies and, on one thread, some 2 microseconds. Triangles without an area are never met.
  [[nodiscard]] static std::variant<TriangleSet, BuildFailure> build(std::span<const T> positions,
                                                                     std::span<const std::uint32_t> indices) noexcept;

  [[nodiscard]] std::optional<TriangleHit<T>> closest(const RayQuery<T>& ray) const noexcept;
  /// Whether there is any: for shadows.
  [[nodiscard]] bool any(const RayQuery<T>& ray) const noexcept;
  /// The same for many rays, in order; as many as the shorter of the two spans holds. Neighbours that begin near each
  /// other and go nearly the same way, such as those of a square of pixels, are searched together, which is faster.
  void closest(std::span<const RayQuery<T>> rays, std::span<std::optional<TriangleHit<T>>> hits) const noexcept;
  void any(std::span<const RayQuery<T>> rays, std::span<bool> met) const noexcept;

  [[nodiscard]] std::size_t size() const noexcept;   ///< triangles
  [[nodiscard]] std::size_t bytes() const noexcept;  ///< of what was built, without corners and indices

 private:
  struct Built;
  explicit TriangleSet(std::shared_ptr<const Built> built) noexcept;
  std::shared_ptr<const Built> built_;
};

extern template class TriangleSet<float>;
extern template class TriangleSet<double>;

}  // namespace raywalk::accel
