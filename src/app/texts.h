#pragma once
// The languages found in the data folder.

#include "app/options.h"
#include "text/languages.h"

#include <optional>
#include <string>

namespace raywalk {

/// Read on first use: most commands need only English.
[[nodiscard]] const LanguagesRead& texts();

/// The option --language.
CLI::Option* add_language(CLI::App& command, std::optional<Language>& target, const std::string& help);

/// Reports on standard error which language files could not be read.
void warn_of_broken_texts();

}  // namespace raywalk
