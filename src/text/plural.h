#pragma once
// Plural forms: the cardinal rules of the Unicode CLDR, for integers.
// http://www.unicode.org/cldr/charts/latest/supplemental/language_plural_rules.html

#include <span>
#include <string_view>

namespace raywalk {

/// The plural forms of a language, named as in its data file: "one", "few", "many", "other"; English's for an unknown
/// language. `code`: ISO 639-1.
[[nodiscard]] std::span<const std::string_view> plural_forms(std::string_view code);

/// The form for `count`, one of plural_forms(code).
[[nodiscard]] std::string_view plural_form(std::string_view code, long long count);

}  // namespace raywalk
