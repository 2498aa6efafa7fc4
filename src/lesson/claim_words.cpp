#include "lesson/claim_words.h"

#include "text/file.h"
#include "text/languages.h"
#include "text/toml.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace raywalk {

namespace {

bool is_figure(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The length in bytes of the letter of `text` at `at`, or 0: ASCII, and Latin letters of two bytes in UTF-8.
std::size_t letter_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  if (std::isalpha(static_cast<int>(byte(at))) != 0) return 1;
  const bool latin = byte(at) >= 0xC3 && byte(at) <= 0xC9 && byte(at + 1) >= 0x80;
  const bool is_sign = byte(at) == 0xC3 && (byte(at + 1) == 0x97 || byte(at + 1) == 0xB7);  // multiplied, divided
  return latin && !is_sign ? 2 : 0;
}

/// The letter in lower case.
std::string in_lower_case(std::string_view letter) {
  std::string small(letter);
  if (letter.size() == 1) small[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(letter[0])));
  const auto second = static_cast<unsigned char>(letter.back());
  if (letter.size() == 2 && letter[0] == '\xC3' && second < 0x9F) small[1] = static_cast<char>(second + 0x20);
  return small;
}

/// A word of a text, or a formula, code or a number.
struct Token {
  std::string word;  ///< in lower case; empty for a formula or code
  std::size_t at = 0, end = 0;
  bool quoted = false;
  int sentence = 0;
};

class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) {
    for (std::size_t at = 0; at < text.size();) at = take(at);
    questions_.resize(static_cast<std::size_t>(sentence_) + 1);
  }
  [[nodiscard]] const std::vector<Token>& list() const { return list_; }
  [[nodiscard]] bool is_question(const Token& token) const {
    return questions_[static_cast<std::size_t>(token.sentence)];
  }

 private:
  std::size_t take(std::size_t at) {
    const char c = text_[at];
    if (c == '{' || c == '`') {
      const std::size_t close = std::min(text_.find(c == '{' ? '}' : '`', at + 1), text_.size() - 1);
      return add("", at, close + 1);
    }
    std::string word;
    std::size_t end = at;
    while (end < text_.size() && is_figure(text_[end])) word += text_[end++];
    for (std::size_t size = letter_at(text_, end); word.empty() || !is_figure(word[0]); size = letter_at(text_, end)) {
      if (size == 0) break;
      word += in_lower_case(text_.substr(end, size));
      end += size;
    }
    if (!word.empty()) return add(word, at, end);
    if (c == '"') quoted_ = !quoted_;
    const bool stops = c == '.' || c == '!' || c == '?' || c == '\n';
    const bool decimal =
        stops && at > 0 && at + 1 < text_.size() && is_figure(text_[at - 1]) && is_figure(text_[at + 1]);
    if (stops && !decimal) {
      questions_.resize(static_cast<std::size_t>(sentence_) + 1);
      if (c == '?') questions_.back() = true;
      ++sentence_;
    }
    return at + 1;
  }
  std::size_t add(std::string word, std::size_t at, std::size_t end) {
    list_.push_back({std::move(word), at, end, quoted_, sentence_});
    return end;
  }

  std::string_view text_;
  std::vector<Token> list_;
  std::vector<bool> questions_;
  bool quoted_ = false;
  int sentence_ = 0;
};

bool fits_form(const std::string& form, const std::string& word) {
  if (form.ends_with('*')) return word.starts_with(std::string_view(form).substr(0, form.size() - 1));
  return form == word;
}

/// How many tokens from `at` on match the form, or 0.
std::size_t length_at(const std::vector<Token>& tokens, std::size_t at, const std::string& form) {
  std::size_t taken = 0;
  for (std::size_t begin = 0; begin < form.size(); ++taken) {
    const std::size_t end = std::min(form.find(' ', begin), form.size());
    if (at + taken >= tokens.size() || !fits_form(form.substr(begin, end - begin), tokens[at + taken].word)) return 0;
    begin = end + 1;
  }
  return taken;
}

}  // namespace

Result<ClaimWords> parse_claim_words(std::string_view text, const std::string& file_name) {
  if (const auto checked = toml_text::check(text, file_name, "words"); !checked) return tl::unexpected(checked.error());
  const toml::parse_result parsed = toml::parse(text, file_name);
  if (!parsed)
    return tl::unexpected(Error{file_name, static_cast<int>(parsed.error().source().begin.line),
                                static_cast<int>(parsed.error().source().begin.column),
                                std::string(parsed.error().description()), "the file is TOML, as scenes are"});
  ClaimWords words;
  for (const auto& [key, node] : parsed.table()) {
    std::vector<std::string> forms;
    const toml::array* array = node.as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
      forms.push_back(array->get(i)->value_or(std::string()));
    if (forms.empty() || std::find(forms.begin(), forms.end(), "") != forms.end())
      return tl::unexpected(Error{file_name, static_cast<int>(node.source().begin.line), 0,
                                  fmt::format("{}: expected a list of words in quotes", key.str()),
                                  "in lower case; a * at the end stands for any ending"});
    if (key == "before_names")
      words.before_names = std::move(forms);
    else
      words.forms.emplace(key.str(), std::move(forms));
  }
  return words;
}

Result<ClaimWordsByLanguage> read_claim_words(const std::string& folder) {
  constexpr std::size_t max_bytes = std::size_t{1} << 16;
  ClaimWordsByLanguage all;
  for (const std::string& code : language_codes_in(folder, ".toml")) {
    const std::string file = folder + "/" + code + ".toml";
    const auto text = read_file(file, max_bytes);
    if (!text) return tl::unexpected(text.error());
    auto words = parse_claim_words(*text, file);
    if (!words) return tl::unexpected(words.error());
    const ClaimWords& first = all.empty() ? *words : all.at("en");
    const auto lacks = [&](const ClaimWords& one, const ClaimWords& other) {
      return std::find_if(one.forms.begin(), one.forms.end(),
                          [&](const auto& each) { return !other.forms.contains(each.first); });
    };
    if (const auto missing = lacks(first, *words); missing != first.forms.end())
      return tl::unexpected(Error{file, 0, 0, "\"" + missing->first + "\" is missing", "each list has the same names"});
    if (const auto more = lacks(*words, first); more != words->forms.end())
      return tl::unexpected(
          Error{file, 0, 0, "\"" + more->first + "\" is in no other list", "each list has the same names"});
    all.emplace(code, std::move(*words));
  }
  return all;
}

std::vector<StatedWord> stated_words(std::string_view text, const ClaimWords& words, bool quotes_state) {
  std::vector<StatedWord> stated;
  const Tokens tokens(text);
  const std::vector<Token>& list = tokens.list();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (tokens.is_question(list[i]) || (list[i].quoted && !quotes_state)) continue;
    std::size_t longest = 0;  // "duas vezes" is no "vezes"
    const std::string* stands_for = nullptr;
    for (const auto& [name, forms] : words.forms)
      for (const std::string& form : forms)
        if (const std::size_t length = length_at(list, i, form); length > longest) {
          longest = length;
          stands_for = &name;
        }
    if (longest == 0) continue;
    const std::size_t end = list[i + longest - 1].end;
    stated.push_back({*stands_for, std::string(text.substr(list[i].at, end - list[i].at))});
    i += longest - 1;
  }
  return stated;
}

std::string typed_number(std::string_view text, const ClaimWords& words) {
  const Tokens tokens(text);
  const std::vector<Token>& list = tokens.list();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Token& token = list[i];
    if (token.word.empty() || !is_figure(token.word[0]) || token.word == "0" || token.word == "1") continue;
    const std::string_view after = text.substr(token.end);
    const bool angle =
        after.starts_with("\u00b0") && (token.word == "90" || token.word == "180" || token.word == "360");
    const bool year = token.word.size() == 4 && token.word >= "1500" && token.word < "2100";
    const bool space = after.starts_with("-D");          // 2-D, 3-D
    const bool factor = letter_at(text, token.end) > 0;  // 4ac
    const bool name = i > 0 && std::find(words.before_names.begin(), words.before_names.end(), list[i - 1].word) !=
                                   words.before_names.end();
    if (!angle && !year && !space && !factor && !name) return token.word;
  }
  return "";
}

}  // namespace raywalk
