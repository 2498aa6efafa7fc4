#pragma once
// Copies of one mesh over a floor: GeneratedKind::forest.

#include "io/generate.h"

namespace raywalk {

[[nodiscard]] std::optional<Error> why_no_forest(const GenerateOptions& options, const std::string& path);

/// A scene in our own format with a group of the mesh, and an instance of it for each copy, all or nothing.
[[nodiscard]] Result<void> write_forest(const GenerateOptions& options, const std::string& path);

}  // namespace raywalk
