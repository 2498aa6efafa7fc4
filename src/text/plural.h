#pragma once
// Which form of a text goes with a count: the cardinal rules of Unicode's CLDR, for whole numbers.
// http://www.unicode.org/cldr/charts/latest/supplemental/language_plural_rules.html

#include <span>
#include <string_view>

namespace raywalk {

/// The forms that a language's texts need for counts, each named as in its data file: "one", "few", "many", "other".
/// English's for a language that is not known here. `code`: as ISO 639-1 has it.
[[nodiscard]] std::span<const std::string_view> plural_forms(std::string_view code);

/// The form that goes with `count`, one of plural_forms(code).
[[nodiscard]] std::string_view plural_form(std::string_view code, long long count);

}  // namespace raywalk
