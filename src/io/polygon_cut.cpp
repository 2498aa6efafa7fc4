#include "io/polygon_cut.h"

#include <fmt/format.h>

namespace raywalk::detail {

namespace {

/// The polygon of a face, seen along its normal.
class FaceOutline {
 public:
  FaceOutline(const Mesh& mesh, const std::vector<std::int32_t>& face) : mesh_(mesh), face_(face) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) normal_ += area_vector(0, i, i + 1);
  }

  /// Twice the area of the triangle of three corners, times the normal's length; negative if they run clockwise.
  [[nodiscard]] double turn(std::size_t a, std::size_t b, std::size_t c) const {
    return dot(area_vector(a, b, c), normal_);
  }
  /// Whether no triangle of a fan around the first corner is turned over, but for those that rounding turns.
  [[nodiscard]] bool is_covered_by_fan() const {
    const double rounding = 1e-6 * dot(normal_, normal_);
    for (std::size_t i = 1; i + 1 < face_.size(); ++i)
      if (turn(0, i, i + 1) < -rounding) return false;
    return true;
  }
  /// Whether this triangle holds the corner `p`. Corners at one place, as where a hole is joined to the outline, do not
  /// hold each other.
  [[nodiscard]] bool holds(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
    return at(p) != at(a) && at(p) != at(b) && at(p) != at(c) && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
           turn(c, a, p) >= 0;
  }

 private:
  [[nodiscard]] const Vec3d& at(std::size_t i) const { return mesh_.positions[static_cast<std::size_t>(face_[i])]; }
  [[nodiscard]] Vec3d area_vector(std::size_t a, std::size_t b, std::size_t c) const {
    return cross(at(b) - at(a), at(c) - at(a));
  }

  const Mesh& mesh_;
  const std::vector<std::int32_t>& face_;
  Vec3d normal_{0.0};  ///< as long as twice the area
};

/// Triangles around the first corner.
void add_fan(Mesh& mesh, const std::vector<std::int32_t>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

// Cuts off ears: triangles of neighbours that hold no other corner (G. Meisters, "Polygons have ears", 1975).
bool add_face(Mesh& mesh, const std::vector<std::int32_t>& face) {
  const FaceOutline polygon(mesh, face);
  const std::size_t count = face.size();
  if (polygon.is_covered_by_fan()) {
    add_fan(mesh, face);
    return true;
  }
  if (count > max_cut_corners) return false;
  std::vector<std::size_t> before(count), after(count), asked(count);
  for (std::size_t i = 0; i < count; ++i) before[i] = (i + count - 1) % count, after[i] = (i + 1) % count, asked[i] = i;
  std::vector<bool> taken(count);
  std::size_t left = count;
  // Only what has new neighbours may have become an ear.
  for (std::size_t next = 0; next < asked.size() && left > 3; ++next) {
    const std::size_t b = asked[next], a = before[b], c = after[b];
    if (taken[b] || !(polygon.turn(a, b, c) > 0)) continue;
    bool is_ear = true;
    for (std::size_t p = after[c]; p != a && is_ear; p = after[p]) is_ear = !polygon.holds(a, b, c, p);
    if (!is_ear) continue;
    mesh.triangles.push_back({face[a], face[b], face[c]});
    taken[b] = true, --left;
    after[a] = c, before[c] = a;
    asked.push_back(a), asked.push_back(c);
  }
  // Three corners; more only of an outline that crosses itself.
  std::vector<std::int32_t> rest;
  for (std::size_t i = 0; i < count; ++i)
    if (!taken[i]) rest.push_back(face[i]);
  add_fan(mesh, rest);
  return true;
}

std::string too_many_corners(std::size_t count) {
  return fmt::format("a concave face of {} corners (expected at most {})", count, max_cut_corners);
}

}  // namespace raywalk::detail
