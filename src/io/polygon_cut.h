#pragma once
// Cuts the faces of mesh files into triangles. Internal to `io`.

#include "shape/mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raywalk::detail {

/// The most corners of a face that no fan covers: the time to cut it grows with their square.
inline constexpr std::size_t max_cut_corners = 10'000;

/// Adds the triangles of a face with these vertices (3 or more), convex or concave, to a mesh that has them: a fan
/// around the first where that covers it. False, and nothing added, for a face that would take too long to cut.
/// `too_many_corners` says so.
[[nodiscard]] bool add_face(Mesh& mesh, const std::vector<std::int32_t>& face);

[[nodiscard]] std::string too_many_corners(std::size_t count);
inline constexpr const char* hint_to_cut = "cut it into smaller faces with a modelling program";

}  // namespace raywalk::detail
