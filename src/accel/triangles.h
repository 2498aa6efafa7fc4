#pragma once

#include "accel/large_pages.h"
#include "math/transform.h"
#include "shape/mesh.h"
#include "shape/naive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

/// A mesh that stands in the scene once more: its triangles are not stored again but placed whenever they are asked
/// for, which gives the bits that a stored one would have.
struct MeshCopy {
  std::shared_ptr<const Mesh> mesh;
  Affine<double> to_world;
  bool smooth = false;     ///< normals between vertices that have one are interpolated
  bool mirrored = false;   ///< `to_world` is a reflection: b and c change places, so that the outside stays outside
  std::int32_t first = 0;  ///< the number of its first triangle

  [[nodiscard]] Mesh::Corners corners(std::int32_t of_mesh) const {
    const auto [a, b, c] = mesh->triangles[static_cast<std::size_t>(of_mesh)];
    return {a, mirrored ? c : b, mirrored ? b : c};
  }
  template <class T>
  [[nodiscard]] Vec3<T> position(std::int32_t vertex) const {
    return Vec3<T>(to_world.point(mesh->positions[static_cast<std::size_t>(vertex)]));
  }
  template <class T>
  [[nodiscard]] Triangle<T> triangle(std::int32_t of_mesh) const {
    const Mesh::Corners at = corners(of_mesh);
    return {position<T>(at[0]), position<T>(at[1]), position<T>(at[2])};
  }
};

/// The image of a vertex's normal, of unit length; 0 for none.
[[nodiscard]] inline Vec3d placed_normal(const Affine<double>& to_world, const Vec3d& normal) {
  const Vec3d image = to_world.normal(normal);
  const double size = length(image);
  return size > 0 ? image / size : Vec3d(0.0);
}

/// The triangles of all meshes in world space: 12 bytes each, besides the shared vertices. A shared vertex has the same
/// bits for every triangle, so that a watertight mesh stays watertight. Those of copies, which come last, take none.
template <class T>
class Triangles {
 public:
  /// With `smooth`, normals between vertices that have one are interpolated.
  void add(const Mesh& mesh, const Affine<double>& to_world, bool smooth);
  /// The same triangles, bit for bit, in a few bytes. Nothing but further copies can be added after one.
  void add_copy(std::shared_ptr<const Mesh> mesh, const Affine<double>& to_world, bool smooth);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int own_size() const { return own_size_; }  ///< without those of copies
  [[nodiscard]] const std::vector<MeshCopy>& copies() const { return copies_; }
  [[nodiscard, gnu::always_inline]] Triangle<T> operator[](int i) const {
    if (i >= own_size()) [[unlikely]]
      return copied(i);
    const Mesh::Corners& c = corners(i);
    return {position(c[0]), position(c[1]), position(c[2])};
  }

  /// Whether one has an area of exactly 0, and so no normal: it is not hit.
  [[nodiscard]] static bool degenerate(const Triangle<T>& triangle) {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a) == Vec3<T>(0) && normal_of(triangle) == Vec3<T>(0);
  }

  /// `AnyRay` is a Ray, a ShearedRay or a NaiveRay.
  template <class AnyRay, class Explain>
  [[nodiscard]] std::optional<Intersection<T>> intersect(int i, const AnyRay& ray, T t_max, int departed_part,
                                                         Explain&& explain) const {
    const Triangle<T> triangle = (*this)[i];
    auto intersection = raywalk::intersect(triangle, ray, t_max, departed_part, explain);
    // Checked last, only for the few that are hit.
    if (intersection && degenerate(triangle)) intersection.reset();
    return intersection;
  }

  /// Whether a ray from triangle `from` hits its neighbour `to` at a `t` that is 0 up to rounding, although it stays on
  /// its side of it.
  [[nodiscard]] bool leaves_by_edge(int from, int to, const Ray<T>& ray, T t) const;

  /// The interpolated normal at a point of triangle `i`, as the vertex normals are given; none where it is flat.
  [[nodiscard]] std::optional<Vec3<T>> given_normal(int i, const SurfacePoint<T>& point) const;
  /// The shading normal: the same, on the side of the triangle's geometric normal.
  [[nodiscard]] std::optional<Vec3<T>> smooth_normal(int i, const SurfacePoint<T>& point) const;
  [[nodiscard]] Vec2<T> uv_at(int i, const SurfacePoint<T>& point) const;
  /// How fast `smooth_normal` turns where the point moves along the triangle; 0 where it is flat.
  [[nodiscard]] Vec3<T> normal_derivative(int i, const SurfacePoint<T>& point, const Vec3<T>& along) const;
  [[nodiscard]] Vec2<T> uv_derivative(int i, const SurfacePoint<T>& point, const Vec3<T>& along) const;

  /// Whether two are the same surface: the same three corners, in any order.
  [[nodiscard]] bool equal(int a, int b) const;

 private:
  template <class Value>
  using AtCorners = std::array<Value, 3>;

  [[nodiscard]] const Mesh::Corners& corners(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  /// The largest coordinate, without its sign.
  static T largest_of(const Vec3<T>& at) { return std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}); }
  [[nodiscard]] const Vec3<T>& position(std::int32_t vertex) const {
    return positions_[static_cast<std::size_t>(vertex)];
  }
  [[nodiscard]] const MeshCopy& copy_of(int i) const {
    return *(std::upper_bound(copies_.begin(), copies_.end(), i,
                              [](int triangle, const MeshCopy& copy) { return triangle < copy.first; }) -
             1);
  }
  [[nodiscard, gnu::noinline]] Triangle<T> copied(int i) const {
    const MeshCopy& copy = copy_of(i);
    return copy.triangle<T>(i - copy.first);
  }
  /// The vertex normals of a triangle; none where a corner has none.
  [[nodiscard, gnu::always_inline]] inline std::optional<AtCorners<Vec3<T>>> normals_of(int i) const;
  [[nodiscard, gnu::noinline]] std::optional<AtCorners<Vec3<T>>> copied_normals(int i) const;
  /// The uv of its vertices; none where the mesh has none.
  [[nodiscard]] std::optional<AtCorners<Vec2<T>>> uvs_of(int i) const;
  /// The weighted sum of the corners' normals, not normalised.
  [[nodiscard]] std::optional<Vec3<T>> between(const std::optional<AtCorners<Vec3<T>>>& normals, int i,
                                               const Vec3<T>& point) const {
    if (!normals) return std::nullopt;
    const Weights w = weights_at(i, point);
    const Vec3<T> sum = w.a * (*normals)[0] + w.b * (*normals)[1] + w.c * (*normals)[2];
    return length(sum) > 0 ? std::optional(sum) : std::nullopt;
  }
  /// For `more` elements: exactly as many for the first mesh, in growing steps for the many copies of instances, which
  /// would otherwise be reallocated each time.
  template <class Element>
  static void make_room(LargeArray<Element>& list, std::size_t more) {
    if (list.size() + more > list.capacity()) list.reserve(std::max(list.size() + more, 2 * list.capacity()));
  }
  struct Weights {
    T a, b, c;
  };
  [[nodiscard]] Weights weights_at(int i, const Vec3<T>& point) const {
    const Vec2<T> bc = barycentric((*this)[i], point);
    return {1 - bc.x - bc.y, bc.x, bc.y};
  }

  LargeArray<Vec3<T>> positions_;      ///< by vertex
  LargeArray<Mesh::Corners> corners_;  ///< by triangle
  std::vector<Vec3<T>> normals_;       ///< by vertex, 0 for none; empty when no mesh is smooth
  std::vector<Vec2<T>> uv_;            ///< by vertex; empty when no mesh has any
  std::vector<std::uint8_t> has_uv_;   ///< by vertex, with uv_
  std::vector<MeshCopy> copies_;
  std::map<const Mesh*, Vec3d> sizes_;  ///< of copied meshes: the largest coordinates, without their signs
  T largest_ = 0;                       ///< at least `largest_of` each corner
  int own_size_ = 0, size_ = 0;
};

template <class T>
void Triangles<T>::add(const Mesh& mesh, const Affine<double>& to_world, bool smooth) {
  const auto first = static_cast<std::int32_t>(positions_.size());
  make_room(positions_, mesh.positions.size());
  for (const Vec3d& at : mesh.positions)
    largest_ = std::max(largest_, largest_of(positions_.emplace_back(to_world.point(at))));
  make_room(corners_, mesh.triangles.size());
  const bool mirrored = to_world.determinant() < 0;  // keeps the outside outside
  for (const auto& [a, b, c] : mesh.triangles)
    corners_.push_back({first + a, first + (mirrored ? c : b), first + (mirrored ? b : c)});
  own_size_ = size_ = static_cast<int>(corners_.size());
  if (smooth && !mesh.normals.empty()) {
    normals_.resize(static_cast<std::size_t>(first), Vec3<T>(0));
    for (const Vec3d& normal : mesh.normals) normals_.emplace_back(placed_normal(to_world, normal));
  }
  if (!mesh.uv.empty()) {
    uv_.resize(static_cast<std::size_t>(first), Vec2<T>(0));
    has_uv_.resize(static_cast<std::size_t>(first), 0);
    for (const Vec2d& uv : mesh.uv) uv_.emplace_back(uv);
    has_uv_.resize(uv_.size(), 1);
  }
  if (!normals_.empty()) normals_.resize(positions_.size(), Vec3<T>(0));
  if (!uv_.empty()) uv_.resize(positions_.size(), Vec2<T>(0)), has_uv_.resize(positions_.size(), 0);
}

template <class T>
void Triangles<T>::add_copy(std::shared_ptr<const Mesh> mesh, const Affine<double>& to_world, bool smooth) {
  copies_.push_back({std::move(mesh), to_world, smooth, to_world.determinant() < 0, size_});
  const MeshCopy& copy = copies_.back();
  size_ += static_cast<int>(copy.mesh->triangles.size());
  const auto [found, is_new] = sizes_.try_emplace(copy.mesh.get());
  if (is_new) found->second = largest_coordinates(bounds(*copy.mesh));
  constexpr T rounded = 1 + 16 * std::numeric_limits<T>::epsilon();
  const Vec3d placed = term_sizes(to_world, found->second) + absolute(to_world.move);
  largest_ = std::max(largest_, static_cast<T>(max_component(placed)) * rounded);
}

template <class T>
auto Triangles<T>::normals_of(int i) const -> std::optional<AtCorners<Vec3<T>>> {
  if (i >= own_size()) return copied_normals(i);
  if (normals_.empty()) return std::nullopt;
  const auto normal = [&](std::size_t corner) { return normals_[static_cast<std::size_t>(corners(i)[corner])]; };
  const Vec3<T> a = normal(0), b = normal(1), c = normal(2);
  if (a == Vec3<T>(0) || b == Vec3<T>(0) || c == Vec3<T>(0)) return std::nullopt;
  return AtCorners<Vec3<T>>{a, b, c};
}

template <class T>
auto Triangles<T>::copied_normals(int i) const -> std::optional<AtCorners<Vec3<T>>> {
  const MeshCopy& copy = copy_of(i);
  if (!copy.smooth || copy.mesh->normals.empty()) return std::nullopt;
  const Mesh::Corners at = copy.corners(i - copy.first);
  AtCorners<Vec3<T>> normals;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    normals[corner] = Vec3<T>(placed_normal(copy.to_world, copy.mesh->normals[static_cast<std::size_t>(at[corner])]));
    if (normals[corner] == Vec3<T>(0)) return std::nullopt;
  }
  return normals;
}

template <class T>
auto Triangles<T>::uvs_of(int i) const -> std::optional<AtCorners<Vec2<T>>> {
  AtCorners<Vec2<T>> uvs;
  if (i >= own_size()) {
    const MeshCopy& copy = copy_of(i);
    if (copy.mesh->uv.empty()) return std::nullopt;
    const Mesh::Corners at = copy.corners(i - copy.first);
    for (std::size_t corner = 0; corner < 3; ++corner)
      uvs[corner] = Vec2<T>(copy.mesh->uv[static_cast<std::size_t>(at[corner])]);
    return uvs;
  }
  const Mesh::Corners& at = corners(i);
  if (uv_.empty() || has_uv_[static_cast<std::size_t>(at[0])] == 0) return std::nullopt;
  for (std::size_t corner = 0; corner < 3; ++corner) uvs[corner] = uv_[static_cast<std::size_t>(at[corner])];
  return uvs;
}

template <class T>
std::optional<Vec3<T>> Triangles<T>::given_normal(int i, const SurfacePoint<T>& point) const {
  const auto sum = between(normals_of(i), i, point.position);
  return sum ? std::optional(*sum / length(*sum)) : std::nullopt;
}

template <class T>
std::optional<Vec3<T>> Triangles<T>::smooth_normal(int i, const SurfacePoint<T>& point) const {
  const auto sum = between(normals_of(i), i, point.position);
  if (!sum) return std::nullopt;
  const T size = length(*sum);
  return dot(*sum, point.normal) < 0 ? -*sum / size : *sum / size;
}

template <class T>
Vec2<T> Triangles<T>::uv_at(int i, const SurfacePoint<T>& point) const {
  const auto uv = uvs_of(i);
  if (!uv) return raywalk::uv_at((*this)[i], point, 0);
  const Weights w = weights_at(i, point.position);
  return w.a * (*uv)[0] + w.b * (*uv)[1] + w.c * (*uv)[2];
}

template <class T>
Vec3<T> Triangles<T>::normal_derivative(int i, const SurfacePoint<T>& point, const Vec3<T>& along) const {
  const auto normals = normals_of(i);
  const auto sum = between(normals, i, point.position);
  if (!sum) return Vec3<T>(0);
  const auto& [a, b, c] = *normals;
  const Vec2<T> bc = barycentric_along((*this)[i], along);
  const Vec3<T> turned = derivative_of_unit(*sum, bc.x * (b - a) + bc.y * (c - a));
  return dot(*sum, point.normal) < 0 ? -turned : turned;
}

template <class T>
Vec2<T> Triangles<T>::uv_derivative(int i, const SurfacePoint<T>& point, const Vec3<T>& along) const {
  const auto uv = uvs_of(i);
  if (!uv) return raywalk::uv_derivative((*this)[i], point, 0, along);
  const Vec2<T> bc = barycentric_along((*this)[i], along);
  return bc.x * ((*uv)[1] - (*uv)[0]) + bc.y * ((*uv)[2] - (*uv)[0]);
}

template <class T>
bool Triangles<T>::leaves_by_edge(int from, int to, const Ray<T>& ray, T t) const {
  constexpr T rounding = 32 * std::numeric_limits<T>::epsilon();
  const T way = t * largest_of(ray.direction), start = largest_of(ray.origin);
  // Told from the size of all, before the corners are fetched.
  if (way > rounding * std::max(largest_, start)) return false;
  const Triangle<T> met = (*this)[to];
  if (!(way <= rounding * std::max({largest_of(met.a), largest_of(met.b), largest_of(met.c), start}))) return false;
  const Triangle<T> left = (*this)[from];
  const auto place = [&](const Vec3<T>& p) { return p == left.a ? 0 : p == left.b ? 1 : p == left.c ? 2 : -1; };
  const std::array<int, 3> places{place(met.a), place(met.b), place(met.c)};
  const auto shared = std::count_if(places.begin(), places.end(), [](int at) { return at >= 0; });
  if (shared == 0) return false;
  // Neighbours of one turn run along their edge in opposite directions.
  bool alike = true;
  for (std::size_t i = 0; i < 3 && shared == 2; ++i)
    if (const int from_place = places[i], to_place = places[(i + 1) % 3]; from_place >= 0 && to_place >= 0)
      alike = to_place != (from_place + 1) % 3;
  const auto side = [&](const Triangle<T>& of) { return dot(normal_of(of), ray.direction); };
  const T both = side(left) * side(met);
  return alike ? both > 0 : both < 0;
}

template <class T>
bool Triangles<T>::equal(int a, int b) const {
  const Triangle<T> first = (*this)[a], second = (*this)[b];
  const auto has = [&](const Vec3<T>& p) { return p == second.a || p == second.b || p == second.c; };
  const auto held = [&](const Vec3<T>& p) { return p == first.a || p == first.b || p == first.c; };
  return has(first.a) && has(first.b) && has(first.c) && held(second.a) && held(second.b) && held(second.c);
}

}  // namespace raywalk
