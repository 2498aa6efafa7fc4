#pragma once
// A parsed TOML table as text again. toml++ can print one too, but 3.3 takes the logarithm of a fraction for a size.

#include "text/toml.h"

#include <string>

namespace raywalk {

/// `table` as a file: its values, then its tables under headers. Comments are gone, every number reads back the same.
[[nodiscard]] std::string text_of(const toml::table& table);

}  // namespace raywalk
