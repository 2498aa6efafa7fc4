#include "text/language.h"

#include <algorithm>
#include <array>

namespace raywalk {

namespace {

/// English alone, the default set.
const Languages& only_english() {
  static const Languages alone;
  return alone;
}

std::string_view said(const Catalogue& catalogue, std::string_view id) {
  const std::string* const words = catalogue.find(id);
  return words == nullptr ? id : std::string_view(*words);
}

}  // namespace

Language::Language() : Language(only_english().english()) {}

std::string_view Language::name() const { return said(*catalogue_, "language.name"); }
char Language::decimal_mark() const { return said(*catalogue_, "language.decimal_mark").front(); }
std::string_view Language::separator() const { return said(*catalogue_, "language.separator"); }

Language Language::next() const {
  const std::vector<Language> all = others_->all();
  const auto at = std::find(all.begin(), all.end(), *this);
  return at == all.end() || at + 1 == all.end() ? all.front() : *(at + 1);
}

Languages::Languages() { catalogues_.push_back(std::make_unique<Catalogue>(Catalogue::embedded())); }

void Languages::add(Catalogue catalogue) {
  catalogue.complete(*catalogues_.front());
  const auto at = std::find_if(catalogues_.begin() + 1, catalogues_.end(),
                               [&](const auto& each) { return each->code() >= catalogue.code(); });
  if (catalogue.code() == catalogues_.front()->code())
    *catalogues_.front() = std::move(catalogue);
  else if (at != catalogues_.end() && (*at)->code() == catalogue.code())
    **at = std::move(catalogue);
  else
    catalogues_.insert(at, std::make_unique<Catalogue>(std::move(catalogue)));
}

std::vector<Language> Languages::all() const {
  std::vector<Language> all;
  for (const auto& catalogue : catalogues_) all.push_back({*catalogue, *this});
  return all;
}

std::optional<Language> Languages::find(std::string_view code) const {
  for (const auto& catalogue : catalogues_)
    if (catalogue->code() == code) return Language(*catalogue, *this);
  return std::nullopt;
}

bool is_language_code(std::string_view word) {
  return (word.size() == 2 || word.size() == 3) &&
         std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

std::string_view text(std::string_view id, Language language) { return said(language.catalogue(), id); }

std::string fill(std::string_view id, Language language, const TextArguments& arguments) {
  const auto counted = std::find_if(arguments.begin(), arguments.end(),
                                    [](const TextArgument& each) { return each.name == "count" && each.count; });
  const std::string* const form = counted == arguments.end() ? nullptr : language.catalogue().find(id, *counted->count);
  const std::string_view pattern = form == nullptr ? said(language.catalogue(), id) : std::string_view(*form);
  std::string result;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t open = pattern.find('{', at), close = pattern.find('}', open);
    result += pattern.substr(at, open - at);
    if (open == std::string_view::npos) break;
    const std::string_view name =
        close == std::string_view::npos ? std::string_view() : pattern.substr(open + 1, close - open - 1);
    const auto stands =
        std::find_if(arguments.begin(), arguments.end(), [&](const TextArgument& each) { return each.name == name; });
    // A brace without a matching argument is literal.
    result += stands == arguments.end() ? std::string_view("{") : std::string_view(stands->words);
    at = stands == arguments.end() ? open + 1 : close + 1;
  }
  return result;
}

std::string with_quotes(std::string_view text, Language language) {
  const std::string_view both = said(language.catalogue(), "language.quotes");  // with a blank between them
  const std::size_t blank = std::min(both.find(' '), both.size());
  const std::string_view opening = both.substr(0, blank), closing = both.substr(std::min(blank + 1, both.size()));
  std::string result;
  bool code = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '`') code = !code;
    const bool begins = at == 0 || std::string_view(" \n([").find(text[at - 1]) != std::string_view::npos;
    result += text[at] != '"' || code ? text.substr(at, 1) : begins ? opening : closing;
  }
  return result;
}

std::string typeset_number(std::string digits, Language language) {
  constexpr std::string_view minus = "\u2212";
  std::replace(digits.begin(), digits.end(), '.', language.decimal_mark());
  for (std::size_t at = 0; (at = digits.find('-', at)) != std::string::npos;) digits.replace(at, 1, minus);
  return digits;
}

std::string typeset_power(std::string digits, Language language) {
  const std::size_t at = digits.find('e');
  if (at == std::string::npos) return typeset_number(std::move(digits), language);
  static constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string power = std::to_string(std::stoi(digits.substr(at + 1)));
  std::string all;
  for (const char c : power) all += c == '-' ? std::string_view("⁻") : raised[static_cast<std::size_t>(c - '0')];
  const std::string before = digits.substr(0, at);
  return (before == "1" ? std::string() : typeset_number(before, language) + " · ") + "10" + all;
}

std::string_view family_text(std::string_view family, std::string_view name, Language language) {
  std::string id = std::string(family) + "." + std::string(name);
  std::replace_if(id.begin(), id.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  const std::string* const words = language.catalogue().find(id);
  return words == nullptr ? name : std::string_view(*words);
}

}  // namespace raywalk
