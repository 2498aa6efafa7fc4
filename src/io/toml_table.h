#pragma once
// Prints a parsed TOML table. toml++ can too, but version 3.3 takes the logarithm of a fraction as a size.

#include "text/toml.h"

#include <string>

namespace raywalk {

/// `table` as a file: its values, then its tables under headers. Comments are lost; numbers are read back exactly.
[[nodiscard]] std::string text_of(const toml::table& table);

}  // namespace raywalk
