#pragma once
// What is wrong with a command line, in words that help.

#include "text/error.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raywalk {

/// "--size"; CLI11 has no name for a hidden option.
[[nodiscard]] std::string name_of(const CLI::Option& option);
/// Why `program` refuses these words, with what to type instead.
[[nodiscard]] Error misuse(const CLI::App& program, const CLI::ParseError& error,
                           const std::vector<std::string>& words);

}  // namespace raywalk
