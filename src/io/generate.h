#pragma once
// Scenes and meshes of any size, for measuring and viewing. All are computed from formulas and written on the fly, so
// memory does not grow with their size.

#include "math/words.h"
#include "text/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

enum class GeneratedKind {
  spheres,  ///< scattered evenly over a cube, in eight materials
  flake,    ///< a sphere on which nine smaller ones sit, and so on (E. Haines's sphereflake)
  mesh,     ///< a ball with bumps, of triangles with normals
  forest,   ///< copies of a mesh, scattered over a floor
};
template <>
inline constexpr Word<GeneratedKind> words_of<GeneratedKind>[] = {{GeneratedKind::spheres, "spheres"},
                                                                  {GeneratedKind::flake, "flake"},
                                                                  {GeneratedKind::mesh, "mesh"},
                                                                  {GeneratedKind::forest, "forest"}};

/// The axis of a mesh that points upwards.
enum class UpAxis { x, y, z };
template <>
inline constexpr Word<UpAxis> words_of<UpAxis>[] = {{UpAxis::x, "x"}, {UpAxis::y, "y"}, {UpAxis::z, "z"}};

struct GenerateOptions {
  GeneratedKind kind = GeneratedKind::spheres;
  int count = 1000;  ///< exact for spheres and copies, approximate for triangles
  int levels = 3;    ///< of a flake: (9^(levels + 1) - 1) / 8 spheres
  std::uint64_t seed = 0;
  std::string mesh{};  ///< of a forest: its file
  UpAxis up = UpAxis::z;
};

/// Why this cannot be written to a file of that name.
[[nodiscard]] std::optional<Error> why_not_generated(const GenerateOptions& options, const std::string& path);

/// Writes a whole scene (.nff, .toml) or a mesh alone (.ply in binary, .obj), all or nothing.
[[nodiscard]] Result<void> generate(const GenerateOptions& options, const std::string& path);

}  // namespace raywalk
