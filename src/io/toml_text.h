#pragma once
// The characters of a TOML text: what must hold before it is parsed, and what is needed to write one.

#include "io/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raywalk::toml_text {

/// The position after the string that begins at `at` with a quote; the text's end when the string never ends.
[[nodiscard]] std::size_t after_string(std::string_view text, std::size_t at);

/// Refuses what no parser should be given: nothing at all, binary data, other encodings than UTF-8, and keys nested so
/// deeply that a recursive parser would run out of stack.
[[nodiscard]] Result<void> check(std::string_view text, const std::string& file_name);

/// `text` as a TOML string in double quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// The shortest TOML number that reads back as the same double. Not for NaN and infinity.
[[nodiscard]] std::string number(double value);

}  // namespace raywalk::toml_text
