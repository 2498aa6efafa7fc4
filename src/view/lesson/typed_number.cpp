#include "view/lesson/typed_number.h"

#include "view/lesson/room.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace raywalk {

namespace {

bool is_figure(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Normalizes typographic characters: non-breaking spaces, the minus sign.
std::string with_plain_signs(std::string_view typed) {
  std::string text(typed);
  for (const auto& [sign, as] : {std::pair{"\u00a0", " "},
                                 {"\u202f", " "},
                                 {"\u2009", " "},
                                 {"\t", " "},
                                 {"\u2212", "-"},
                                 {"\u2013", "-"},
                                 {"\u00d7", "x"}})
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, std::string_view(sign).size(), as);
  return text;
}

std::string_view without_spaces(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Digits with at most one decimal separator, as a point; empty for anything else.
std::string with_a_point(std::string_view digits) {
  std::string text(digits);
  std::replace(text.begin(), text.end(), ',', '.');
  const bool any = std::any_of(text.begin(), text.end(), is_figure);
  const bool only = std::all_of(text.begin(), text.end(), [](char c) { return is_figure(c) || c == '.'; });
  return any && only && std::count(text.begin(), text.end(), '.') <= 1 ? text : std::string();
}

/// The same without thousands separators; empty if there are none.
std::string ungrouped(std::string_view digits) {
  for (const char mark : {',', '.', ' ', '\''}) {
    if (digits.find(mark) == std::string_view::npos) continue;
    const std::size_t first = digits.find(mark);
    std::string text(digits.substr(0, first));
    std::size_t at = first;
    while (at < digits.size() && digits[at] == mark && digits.size() - at > 3 &&
           std::all_of(digits.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                       digits.begin() + static_cast<std::ptrdiff_t>(at) + 4, is_figure)) {
      text += digits.substr(at + 1, 3);
      at += 4;
    }
    const bool leads = first >= 1 && first <= 3 && digits[0] != '0';
    const std::string_view rest = digits.substr(at);
    const bool ends = rest.empty() || ((rest[0] == ',' || rest[0] == '.') && rest[0] != mark);
    if (leads && at > first && ends) return with_a_point(text + std::string(rest));
  }
  return {};
}

}  // namespace

std::vector<double> typed_numbers(std::string_view typed, std::string_view unit) {
  if (typed.size() > longest_typed) return {};
  const std::string text = with_plain_signs(typed);
  std::string_view rest = without_spaces(text);
  for (const std::string_view end : {unit, unit.empty() ? std::string_view("x") : std::string_view()})
    if (!end.empty() && rest.ends_with(end)) rest = without_spaces(rest.substr(0, rest.size() - end.size()));
  if (const std::size_t stroke = rest.find('/'); stroke != std::string_view::npos) {
    std::vector<double> quotients;
    const std::vector<double> divisors = typed_numbers(rest.substr(stroke + 1));
    for (const double above : typed_numbers(rest.substr(0, stroke)))
      for (const double below : divisors)
        if (below != 0) quotients.push_back(above / below);
    return quotients;
  }
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest = without_spaces(rest.substr(1));
  std::string power;
  if (const std::size_t e = rest.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view digits = rest.substr(e + 1);
    if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
    if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_figure)) return {};
    power = rest.substr(e);
    rest = rest.substr(0, e);
  }
  std::vector<double> meant;
  for (const std::string& digits : {with_a_point(rest), ungrouped(rest)}) {
    if (digits.empty()) continue;
    const double number = std::strtod((digits + power).c_str(), nullptr);
    if (std::isfinite(number)) meant.push_back(negative ? -number : number);
  }
  return meant;
}

std::optional<double> typed_guess(const LessonRoom& sitting, std::string_view typed) {
  const PlayedStep* step = sitting.at();
  const auto* question =
      step != nullptr && step->step->question ? std::get_if<NumberQuestion>(&*step->step->question) : nullptr;
  if (question == nullptr) return std::nullopt;
  const std::vector<double> meant = typed_numbers(typed, question->unit);
  if (meant.empty()) return std::nullopt;
  if (meant.size() == 1) return meant.front();
  const Outcome truth =
      value_at(sitting.open->played, static_cast<std::size_t>(sitting.step), step->shown, question->answer.expression);
  const double* number = truth ? std::get_if<double>(&*truth) : nullptr;
  if (number == nullptr) return meant.front();
  return *std::min_element(meant.begin(), meant.end(),
                           [&](double a, double b) { return std::abs(a - *number) < std::abs(b - *number); });
}

}  // namespace raywalk
