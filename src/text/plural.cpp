#include "text/plural.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace raywalk {

namespace {

using std::string_view_literals::operator""sv;

/// Languages with the same rule: its forms, and which of them a count takes (an index; `count` >= 0).
struct PluralRule {
  std::span<const std::string_view> codes, forms;
  std::size_t (*form)(long long count);
};

constexpr std::array only_other{"other"sv};
constexpr std::array one_other{"one"sv, "other"sv};
constexpr std::array one_few_many{"one"sv, "few"sv, "many"sv};
constexpr std::array one_few_other{"one"sv, "few"sv, "other"sv};
constexpr std::array zero_to_other{"zero"sv, "one"sv, "two"sv, "few"sv, "many"sv, "other"sv};

constexpr std::array without{"ja"sv, "ko"sv, "zh"sv, "th"sv, "vi"sv, "id"sv, "ms"sv};
constexpr std::array zero_as_one{"pt"sv, "fr"sv, "hy"sv};
constexpr std::array east_slavic{"ru"sv, "uk"sv, "be"sv};
constexpr std::array polish{"pl"sv};
constexpr std::array czech{"cs"sv, "sk"sv};
constexpr std::array arabic{"ar"sv};

bool within(long long value, long long least, long long most) { return value >= least && value <= most; }

/// The last rule is for all others.
constexpr std::array rules{
    PluralRule{without, only_other, [](long long) -> std::size_t { return 0; }},
    PluralRule{zero_as_one, one_other, [](long long n) -> std::size_t { return n <= 1 ? 0 : 1; }},
    PluralRule{east_slavic, one_few_many,
               [](long long n) -> std::size_t {
                 if (n % 10 == 1 && n % 100 != 11) return 0;
                 return within(n % 10, 2, 4) && !within(n % 100, 12, 14) ? 1 : 2;
               }},
    PluralRule{polish, one_few_many,
               [](long long n) -> std::size_t {
                 if (n == 1) return 0;
                 return within(n % 10, 2, 4) && !within(n % 100, 12, 14) ? 1 : 2;
               }},
    PluralRule{czech, one_few_other, [](long long n) -> std::size_t { return n == 1            ? 0
                                                                             : within(n, 2, 4) ? 1
                                                                                               : 2; }},
    PluralRule{arabic, zero_to_other,
               [](long long n) -> std::size_t {
                 if (n <= 2) return static_cast<std::size_t>(n);
                 return within(n % 100, 3, 10) ? 3 : within(n % 100, 11, 99) ? 4 : 5;
               }},
    PluralRule{{}, one_other, [](long long n) -> std::size_t { return n == 1 ? 0 : 1; }},
};

const PluralRule& rule_of(std::string_view code) {
  const auto* const found = std::find_if(rules.begin(), rules.end() - 1, [&](const PluralRule& rule) {
    return std::find(rule.codes.begin(), rule.codes.end(), code) != rule.codes.end();
  });
  return *found;
}

}  // namespace

std::span<const std::string_view> plural_forms(std::string_view code) { return rule_of(code).forms; }

std::string_view plural_form(std::string_view code, long long count) {
  const PluralRule& rule = rule_of(code);
  return rule.forms[rule.form(std::llabs(count))];
}

}  // namespace raywalk
