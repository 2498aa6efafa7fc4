#pragma once
// TOML at the level of characters: checks before parsing, and writing of strings and numbers.

#include "text/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk::toml_text {

/// The position after the string that begins at `at` with a quote; the text's end if it is unterminated.
[[nodiscard]] std::size_t after_string(std::string_view text, std::size_t at);

/// Refuses what no parser should get: empty text, binary data, encodings other than UTF-8, and keys nested so deeply
/// that a recursive parser would run out of stack. `what` is expected there.
[[nodiscard]] Result<void> check(std::string_view text, const std::string& file_name,
                                 std::string_view what = "a scene");

/// `text` as a TOML string in double quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// The shortest TOML number that is read back as the same double. Not for NaN and infinity.
[[nodiscard]] std::string number(double value);

/// A whole word as a number: decimal digits with optional sign, point and exponent, and no other form that strtod
/// reads. None if it is anything else.
[[nodiscard]] std::optional<double> read_number(std::string_view word);

}  // namespace raywalk::toml_text
