#pragma once
// The texts of one language, from its data file.

#include <functional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <unordered_map>
#include <vector>

namespace raywalk {

/// Where a data file is malformed.
struct TextMistake {
  int line = 0, column = 0;  ///< from 1
  std::string message, hint;
};

class Catalogue {
 public:
  /// Reads a data file: tables of strings, whose names and keys are joined by dots to the ids. A text with plural forms
  /// is a table of them: one, few, many, other, as in the language (text/plural.h), and zero if it is expressed
  /// differently. `code`: of the language, "pt".
  [[nodiscard]] static tl::expected<Catalogue, TextMistake> parse(std::string_view toml, std::string_view code);
  /// English, as built in.
  [[nodiscard]] static const Catalogue& embedded();

  [[nodiscard]] const std::string& code() const { return code_; }
  [[nodiscard]] const std::string& sign() const { return sign_; }  ///< "PT"

  /// The text of an id, or null. Plural forms have their own ids: "structure.shapes.one".
  [[nodiscard]] const std::string* find(std::string_view id) const;
  /// The form of a text that goes with a count, or null.
  [[nodiscard]] const std::string* find(std::string_view id, long long count) const;
  /// All ids, sorted.
  [[nodiscard]] std::vector<std::string_view> ids() const;

  /// Adds from `english` what it lacks.
  void complete(const Catalogue& english);
  /// What it lacked, sorted.
  [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }
  /// What it has and `english` does not, so that it is unused, sorted.
  [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  /// Whether it has this text, or at least one of its forms.
  [[nodiscard]] bool has(std::string_view id) const;

  std::string code_, sign_;
  std::unordered_map<std::string, std::string, Hash, std::equal_to<>> texts_;
  std::vector<std::string> missing_, unknown_;
};

}  // namespace raywalk
