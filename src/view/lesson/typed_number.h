#pragma once
// Interprets numbers typed as answers to a lesson's questions.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct LessonRoom;

/// Bytes. Each quotient may double how many numbers are meant.
inline constexpr std::size_t longest_typed = 64;

/// Possible values of the text: with surrounding spaces, a comma or a point before the decimals, groups of three
/// digits, a fraction, a power of ten, the question's unit. "1,234" has two values; other text none, nor one of
/// more than 64 bytes.
[[nodiscard]] std::vector<double> typed_numbers(std::string_view typed, std::string_view unit = {});

/// The answer to the open step's question; of several values, the one nearest to the truth: notation never makes an
/// answer wrong.
[[nodiscard]] std::optional<double> typed_guess(const LessonRoom& sitting, std::string_view typed);

}  // namespace raywalk
