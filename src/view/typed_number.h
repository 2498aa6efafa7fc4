#pragma once
// What a person means who types a number as the answer to a lesson's question.

#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct LessonSitting;

/// What the text can mean: spaces around it, a comma or a point before the decimals, groups of three digits, a
/// fraction, a power of ten, the question's unit behind it. "1,234" can mean two numbers; what is no number, none.
[[nodiscard]] std::vector<double> typed_numbers(std::string_view typed, std::string_view unit = {});

/// The answer to the question of the step that is open; of what a text can mean, what is nearer the truth: nobody is
/// wrong for how they write a number.
[[nodiscard]] std::optional<double> typed_guess(const LessonSitting& sitting, std::string_view typed);

}  // namespace raywalk
