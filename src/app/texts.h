#pragma once
// The languages that the program found in its data folder.

#include "app/options.h"
#include "io/languages.h"

#include <optional>
#include <string>

namespace raywalk {

/// Read when they are first asked for: most commands speak English alone.
[[nodiscard]] const LanguagesRead& texts();

/// The option --language.
CLI::Option* add_language(CLI::App& command, std::optional<Language>& target, const std::string& help);

/// Says on standard error which files of texts could not be read.
void warn_of_broken_texts();

}  // namespace raywalk
