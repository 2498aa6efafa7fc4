#pragma once
// Warnings of scene readers, made short enough to read.

#include <string>
#include <vector>

namespace raywalk {

struct Scene;

/// Whether no ray meets anything, so that every pixel is the background.
[[nodiscard]] bool is_empty(const Scene& scene);

/// One line per kind: of warnings that differ only in numbers and quoted names, the first, with the number of others
/// ("...; and 999 more like it"). The order is kept. Collecting again changes nothing.
[[nodiscard]] std::vector<std::string> collected(const std::vector<std::string>& warnings);

}  // namespace raywalk
