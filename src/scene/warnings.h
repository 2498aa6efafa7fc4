#pragma once
// What readers of scenes warn about, made short enough to be read.

#include <string>
#include <vector>

namespace raywalk {

/// One line a kind: of warnings that differ in nothing but numbers and quoted names, the first, with how many more
/// there are ("...; and 999 more like it"). They stay in their order. Collecting once more changes nothing.
[[nodiscard]] std::vector<std::string> collected(const std::vector<std::string>& warnings);

}  // namespace raywalk
