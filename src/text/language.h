#pragma once
// The languages of Raywalk, and its texts in them. A language is a data file, `src/text/en.toml`: every text by a
// dotted id, such as "walk.found_hit", with arguments in braces. Texts missing in a file appear in English, which is
// built in. Code uses the id: text("image.waiting", language).

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

/// A language of a set, which must outlive it. As cheap as a pointer.
class Language {
 public:
  Language();  ///< built-in English, in a set of its own

  /// Its ISO 639-1 code: the name of its file and of a lesson's file of words, and its name in options and settings.
  [[nodiscard]] std::string_view code() const { return catalogue_->code(); }
  [[nodiscard]] std::string_view sign() const { return catalogue_->sign(); }  ///< as a button shows it: "EN"
  [[nodiscard]] std::string_view name() const;                                ///< in the language itself
  /// The decimal separator.
  [[nodiscard]] char decimal_mark() const;
  /// The separator of numbers in a list: no comma if numbers contain one.
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
  Languages();  ///< built-in English alone
  ~Languages() = default;
  Languages(const Languages&) = delete;
  Languages& operator=(const Languages&) = delete;

  /// Adds a language, in order of the codes. Missing texts are taken from the current English. English replaces the one
  /// that is there.
  void add(Catalogue catalogue);

  [[nodiscard]] std::vector<Language> all() const;
  [[nodiscard]] Language english() const { return {*catalogues_.front(), *this}; }
  [[nodiscard]] std::optional<Language> find(std::string_view code) const;

 private:
  std::vector<std::unique_ptr<Catalogue>> catalogues_;
};

/// Whether this can be a language code: two or three lower-case letters.
[[nodiscard]] bool is_language_code(std::string_view word);

/// The value of a {name} in a text.
struct TextArgument {
  TextArgument(std::string_view of, std::string_view stands) : name(of), words(stands) {}
  /// An integer. For {count}, it also selects the plural form.
  template <std::integral Number>
  TextArgument(std::string_view of, Number number) : name(of), words(std::to_string(number)), count(number) {}

  std::string_view name;
  std::string words;
  std::optional<long long> count{};
};
using TextArguments = std::vector<TextArgument>;

/// The text of an id; the id itself if no file has it. Valid as long as the set.
[[nodiscard]] std::string_view text(std::string_view id, Language language);

/// A text with its arguments filled in, in the plural form for {count} if it has several.
[[nodiscard]] std::string fill(std::string_view id, Language language, const TextArguments& arguments = {});

/// A text with straight double quotes, with those of the language ("language.quotes") in their place; not within `code`
/// in backquotes.
[[nodiscard]] std::string with_quotes(std::string_view text, Language language);

/// Printed digits: with the language's decimal separator and a true minus sign.
[[nodiscard]] std::string typeset_number(std::string digits, Language language);
/// The same of digits as fmt writes them, with an exponent as a power of ten: "1.5e-42" becomes 1.5 · 10⁻⁴².
[[nodiscard]] std::string typeset_power(std::string digits, Language language);

/// A text of a family, by the name used in files and options: family_text("effect", "depth of field", language) is the
/// text of "effect.depth_of_field".
[[nodiscard]] std::string_view family_text(std::string_view family, std::string_view name, Language language);

}  // namespace raywalk
