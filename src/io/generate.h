#pragma once
// Scenes and meshes of any size, to measure and to look at. All of them are made from formulas and written as they are
// made, so memory does not grow with their size.

#include "io/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

enum class GeneratedKind {
  spheres,  ///< strewn evenly over a cube, each with about the same share of it, in eight materials
  flake,    ///< a sphere on which nine smaller ones sit, and so on (E. Haines's sphereflake)
  mesh,     ///< a ball with bumps, of triangles with normals
};
[[nodiscard]] constexpr std::string_view generated_name(GeneratedKind kind) {
  switch (kind) {
    case GeneratedKind::spheres:
      return "spheres";
    case GeneratedKind::flake:
      return "flake";
    case GeneratedKind::mesh:
      return "mesh";
  }
  return "";
}

struct GenerateOptions {
  GeneratedKind kind = GeneratedKind::spheres;
  int count = 1000;  ///< spheres exactly, triangles about
  int levels = 3;    ///< of a flake: (9^(levels + 1) - 1) / 8 spheres
  std::uint64_t seed = 0;
};

/// What is wrong with writing this to a file of that name.
[[nodiscard]] std::optional<Error> why_not_generated(const GenerateOptions& options, const std::string& path);

/// Writes a whole scene (.nff, .toml) or a mesh alone (.ply in binary, .obj), all or nothing.
[[nodiscard]] Result<void> generate(const GenerateOptions& options, const std::string& path);

}  // namespace raywalk
