#pragma once
// The languages that Raywalk speaks, and what it says in them. A language is a data file, `src/text/en.toml`: every
// text by a dotted id, such as "walk.found_hit", with names in braces for what is filled in. What a file lacks is said
// in English, which the program itself holds too. Code names the id where it speaks: text("image.waiting", language).

#include "text/catalogue.h"

#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

class Languages;

/// One of the languages of a set, which outlives it. As cheap as a pointer.
class Language {
 public:
  Language();  ///< English, as the program holds it: of a set of its own

  /// Two letters, as ISO 639-1 has them: the name of its file, of a lesson's file of words, and of options and
  /// settings.
  [[nodiscard]] std::string_view code() const { return catalogue_->code(); }
  [[nodiscard]] std::string_view sign() const { return catalogue_->sign(); }  ///< as a button shows it: "EN"
  [[nodiscard]] std::string_view name() const;                                ///< what its speakers call it
  /// What stands between the whole part of a number and its decimals.
  [[nodiscard]] char decimal_mark() const;
  /// What stands between numbers in a row: no comma where that is in the numbers.
  [[nodiscard]] std::string_view separator() const;

  [[nodiscard]] const Catalogue& catalogue() const { return *catalogue_; }
  [[nodiscard]] const Languages& others() const { return *others_; }  ///< the whole set, with itself
  [[nodiscard]] Language next() const;                                ///< the one after it; after the last, the first

  friend bool operator==(const Language& a, const Language& b) { return a.code() == b.code(); }

 private:
  friend class Languages;
  Language(const Catalogue& catalogue, const Languages& others) : catalogue_(&catalogue), others_(&others) {}
  const Catalogue* catalogue_;
  const Languages* others_;
};

/// A set of languages, English first.
class Languages {
 public:
  Languages();  ///< English alone, as the program holds it
  ~Languages() = default;
  Languages(const Languages&) = delete;
  Languages& operator=(const Languages&) = delete;

  /// Adds a language, after those whose code comes before its own. What it lacks is said in English as it is by then.
  /// English takes the place of that which is there.
  void add(Catalogue catalogue);

  [[nodiscard]] std::vector<Language> all() const;
  [[nodiscard]] Language english() const { return {*catalogues_.front(), *this}; }
  [[nodiscard]] std::optional<Language> find(std::string_view code) const;

 private:
  std::vector<std::unique_ptr<Catalogue>> catalogues_;
};

/// Whether this can be the code of a language: two or three small letters.
[[nodiscard]] bool is_language_code(std::string_view word);

/// What stands for a {name} in a text.
struct TextArgument {
  TextArgument(std::string_view of, std::string_view stands) : name(of), words(stands) {}
  /// A whole number. That for {count} also chooses the form of a text that has several.
  template <std::integral Number>
  TextArgument(std::string_view of, Number number) : name(of), words(std::to_string(number)), count(number) {}

  std::string_view name;
  std::string words;
  std::optional<long long> count{};
};
using TextArguments = std::vector<TextArgument>;

/// The text of an id; the id itself where no file has it. It lives as long as the set.
[[nodiscard]] std::string_view text(std::string_view id, Language language);

/// A text with its arguments filled in, in the form that goes with {count} where it has forms.
[[nodiscard]] std::string fill(std::string_view id, Language language, const TextArguments& arguments = {});

/// A word of a family, by the name that files and options give it: family_text("effect", "depth of field", language) is
/// the text of "effect.depth_of_field".
[[nodiscard]] std::string_view family_text(std::string_view family, std::string_view name, Language language);

}  // namespace raywalk
