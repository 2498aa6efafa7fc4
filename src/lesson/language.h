#pragma once
// The languages that Raywalk speaks: its lessons and its interface. The command line and the files speak English.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace raywalk {

enum class Language { english, portuguese };

inline constexpr std::array all_languages{Language::english, Language::portuguese};

/// Two letters, as ISO 639-1 has them: the name of a lesson's file of words, and how options and settings name it.
[[nodiscard]] constexpr std::string_view language_code(Language language) {
  switch (language) {
    case Language::english:
      return "en";
    case Language::portuguese:
      return "pt";
  }
  return {};
}

/// The same as a button shows it: "EN".
[[nodiscard]] constexpr std::string_view language_sign(Language language) {
  switch (language) {
    case Language::english:
      return "EN";
    case Language::portuguese:
      return "PT";
  }
  return {};
}

/// What its speakers call it.
[[nodiscard]] constexpr std::string_view language_name(Language language) {
  switch (language) {
    case Language::english:
      return "English";
    case Language::portuguese:
      return "Portugu\u00eas";
  }
  return {};
}

/// What stands between the whole part of a number and its decimals.
[[nodiscard]] constexpr char decimal_mark(Language language) {
  switch (language) {
    case Language::english:
      return '.';
    case Language::portuguese:
      return ',';
  }
  return '.';
}

/// What stands between numbers in a row: no comma where that is in the numbers.
[[nodiscard]] constexpr std::string_view separator(Language language) {
  return decimal_mark(language) == ',' ? "; " : ", ";
}

/// The language of a code; none for what is no code of one.
[[nodiscard]] constexpr std::optional<Language> language_of(std::string_view code) {
  for (const Language language : all_languages)
    if (language_code(language) == code) return language;
  return std::nullopt;
}

/// The one after it, and after the last the first.
[[nodiscard]] constexpr Language next_language(Language language) {
  for (std::size_t i = 0; i < all_languages.size(); ++i)
    if (all_languages[i] == language) return all_languages[(i + 1) % all_languages.size()];
  return language;
}

}  // namespace raywalk
