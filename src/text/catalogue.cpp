#include "text/catalogue.h"

#include "text/plural.h"
#include "text/toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace raywalk {

// Generated from en.toml.
extern const std::string_view embedded_english;

namespace {

using Mistake = tl::unexpected<TextMistake>;
using std::string_view_literals::operator""sv;

/// Every form that a language may have.
constexpr std::array all_forms{"zero"sv, "one"sv, "two"sv, "few"sv, "many"sv, "other"sv};

/// "structure.shapes" for "structure.shapes.one"; other ids are returned unchanged.
std::string_view without_form(std::string_view id) {
  const std::size_t dot = id.rfind('.');
  if (dot == std::string_view::npos) return id;
  const bool is_form = std::find(all_forms.begin(), all_forms.end(), id.substr(dot + 1)) != all_forms.end();
  return is_form ? id.substr(0, dot) : id;
}

Mistake mistake(const toml::source_region& where, std::string message, std::string hint) {
  return Mistake(TextMistake{static_cast<int>(where.begin.line), static_cast<int>(where.begin.column),
                             std::move(message), std::move(hint)});
}

}  // namespace

tl::expected<Catalogue, TextMistake> Catalogue::parse(std::string_view toml_text, std::string_view code) {
  const toml::parse_result parsed = toml::parse(toml_text);
  if (!parsed)
    return mistake(parsed.error().source(), std::string(parsed.error().description()),
                   "the file is TOML: [walk], and below it found_hit = \"The {ray} hits {object}.\"");
  Catalogue catalogue;
  catalogue.code_ = code;
  catalogue.sign_ = code;
  for (char& letter : catalogue.sign_)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');

  struct Table {
    std::string prefix;
    const toml::table& of;
  };
  std::vector<Table> open{{"", parsed.table()}};
  while (!open.empty()) {
    const Table table = open.back();
    open.pop_back();
    for (const auto& [key, value] : table.of) {
      const std::string id = table.prefix + std::string(key.str());
      if (const toml::table* const inner = value.as_table()) {
        open.push_back({id + ".", *inner});
      } else if (const toml::value<std::string>* const words = value.as_string()) {
        catalogue.texts_.emplace(id, words->get());
      } else {
        return mistake(value.source(), fmt::format("\"{}\" is no text", id), "texts are strings in double quotes");
      }
    }
  }
  for (const std::string_view needed : {"language.name", "language.decimal_mark", "language.separator"})
    if (const std::string* const said = catalogue.find(needed); said == nullptr || said->empty())
      return mistake({{1, 1}, {1, 1}, {}}, fmt::format("\"{}\" is missing", needed),
                     "a file of texts begins with [language]: name, decimal_mark and separator");
  return catalogue;
}

const Catalogue& Catalogue::embedded() {
  static const Catalogue english = [] {
    tl::expected<Catalogue, TextMistake> read = parse(embedded_english, "en");
    assert(read);  // a test reads it
    return read ? *std::move(read) : Catalogue();
  }();
  return english;
}

const std::string* Catalogue::find(std::string_view id) const {
  const auto at = texts_.find(id);
  return at == texts_.end() ? nullptr : &at->second;
}

const std::string* Catalogue::find(std::string_view id, long long count) const {
  const auto form = [&](std::string_view name) { return find(std::string(id) + "." + std::string(name)); };
  if (const std::string* const alone = find(id)) return alone;
  if (count == 0)
    if (const std::string* const zero = form("zero")) return zero;
  const std::string* const chosen = form(plural_form(code_, count));
  return chosen != nullptr ? chosen : form("other");
}

std::vector<std::string_view> Catalogue::ids() const {
  std::vector<std::string_view> all;
  all.reserve(texts_.size());
  for (const auto& [id, words] : texts_) all.push_back(id);
  std::sort(all.begin(), all.end());
  return all;
}

bool Catalogue::has(std::string_view id) const {
  return find(id) != nullptr || std::any_of(all_forms.begin(), all_forms.end(), [&](std::string_view form) {
           return find(std::string(id) + "." + std::string(form)) != nullptr;
         });
}

void Catalogue::complete(const Catalogue& english) {
  missing_.clear();
  unknown_.clear();
  for (const auto& [id, words] : texts_)
    if (!english.has(id) && !english.has(without_form(id))) unknown_.push_back(id);
  // For texts with plural forms, checks the forms of its own rule; English has another rule.
  for (const auto& [id, words] : english.texts_) {
    const std::string_view whole = without_form(id);
    if (find(id) != nullptr) continue;
    if (whole == id || !has(whole)) {
      missing_.push_back(id);
      continue;
    }
    for (const std::string_view form : plural_forms(code_))
      if (const std::string of = std::string(whole) + "." + std::string(form); find(of) == nullptr)
        missing_.push_back(of);
  }
  std::sort(missing_.begin(), missing_.end());
  missing_.erase(std::unique(missing_.begin(), missing_.end()), missing_.end());
  std::sort(unknown_.begin(), unknown_.end());
  for (const std::string& id : missing_)
    if (const std::string* const words = english.find(id)) texts_.emplace(id, *words);
}

}  // namespace raywalk
