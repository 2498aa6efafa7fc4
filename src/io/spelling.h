#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The candidate that `word` most likely was meant to be, upper and lower case aside; empty when none is near enough.
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string_view>& candidates);

/// "a, b or c".
[[nodiscard]] std::string one_of(const std::vector<std::string_view>& words);

}  // namespace raywalk
