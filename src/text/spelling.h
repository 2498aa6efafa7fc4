#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The candidate most similar to `word`, ignoring case; empty if none is close enough.
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string_view>& candidates);

/// "a, b or c".
[[nodiscard]] std::string one_of(const std::vector<std::string_view>& words);

}  // namespace raywalk
