#include "lesson/expression_parser.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cstdlib>

namespace raywalk {

namespace {

/// A lesson's formulas are short; deeper nesting is not handwritten.
constexpr int max_nesting = 60;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

Expression ExpressionParser::make(Expression::Node node) {
  return Expression(std::make_shared<const Expression::Node>(std::move(node)));
}

void ExpressionParser::skip_spaces() {
  while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
}

bool ExpressionParser::take(std::string_view sign) {
  skip_spaces();
  if (text_.substr(at_, sign.size()) != sign) return false;
  at_ += sign.size();
  return true;
}

bool ExpressionParser::take_word(std::string_view word) {
  skip_spaces();
  const std::size_t end = at_ + word.size();
  if (text_.substr(at_, word.size()) != word) return false;
  if (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) return false;
  at_ = end;
  return true;
}

tl::unexpected<std::string> ExpressionParser::fail(const std::string& expected) const {
  const std::string found = at_ < text_.size() ? "\"" + std::string(text_.substr(at_, 20)) + "\"" : "the end";
  return tl::unexpected(fmt::format("\"{}\": found {} at character {} (expected {})", text_, found, at_ + 1, expected));
}

tl::expected<Expression, std::string> ExpressionParser::parse() {
  constexpr std::size_t most = 4096;  // characters: sums are trees, which are walked by recursion
  if (text_.size() > most)
    return tl::unexpected(fmt::format("a formula of {} characters (expected at most {})", text_.size(), most));
  auto whole = either();
  skip_spaces();
  if (whole && at_ < text_.size()) return fail("the end, or a sign such as + or ==");
  return whole;
}

ExpressionParser::Parsed ExpressionParser::either() {
  if (++nesting_ > max_nesting) return fail("fewer brackets");
  auto left = both();
  while (left && take_word("or")) {
    auto right = both();
    if (!right) return right;
    left = make({.kind = Kind::or_, .parts = {*left, *right}});
  }
  --nesting_;
  return left;
}

ExpressionParser::Parsed ExpressionParser::both() {
  auto left = negation();
  while (left && take_word("and")) {
    auto right = negation();
    if (!right) return right;
    left = make({.kind = Kind::and_, .parts = {*left, *right}});
  }
  return left;
}

ExpressionParser::Parsed ExpressionParser::negation() {
  if (!take_word("not")) return comparison();
  if (++nesting_ > max_nesting) return fail("fewer negations");
  auto part = negation();
  --nesting_;
  if (!part) return part;
  return make({.kind = Kind::not_, .parts = {*part}});
}

ExpressionParser::Parsed ExpressionParser::comparison() {
  auto left = sum();
  if (!left) return left;
  for (const std::string_view sign : {"==", "!=", "<=", ">=", "<", ">"}) {
    if (!take(sign)) continue;
    auto right = sum();
    if (!right) return right;
    Expression::Node node{.kind = Kind::compare, .word = std::string(sign), .parts = {*left, *right}};
    if ((sign == "==" || sign == "!=") && take("+-")) {
      auto within = sum();
      if (!within) return within;
      node.within = *within;
    }
    return make(std::move(node));
  }
  return left;
}

ExpressionParser::Parsed ExpressionParser::sum() {
  auto left = product();
  for (;;) {
    skip_spaces();
    if (!left || text_.substr(at_, 2) == "+-") return left;
    const Kind kind = take("+") ? Kind::add : take("-") ? Kind::subtract : Kind::value;
    if (kind == Kind::value) return left;
    auto right = product();
    if (!right) return right;
    left = make({.kind = kind, .parts = {*left, *right}});
  }
}

ExpressionParser::Parsed ExpressionParser::product() {
  auto left = power();
  for (;;) {
    if (!left) return left;
    const Kind kind = take("*") ? Kind::multiply : take("/") ? Kind::divide : Kind::value;
    if (kind == Kind::value) return left;
    auto right = power();
    if (!right) return right;
    left = make({.kind = kind, .parts = {*left, *right}});
  }
}

ExpressionParser::Parsed ExpressionParser::power() {
  auto base = single();
  if (!base || !take("^")) return base;
  if (++nesting_ > max_nesting) return fail("fewer powers");
  auto exponent = power();
  --nesting_;
  if (!exponent) return exponent;
  return make({.kind = Kind::power, .parts = {*base, *exponent}});
}

ExpressionParser::Parsed ExpressionParser::single() {
  skip_spaces();
  if (at_ >= text_.size()) return fail("a number, a name or a bracket");
  const char c = text_[at_];
  if (take("(")) {
    auto inner = either();
    if (!inner) return inner;
    if (!take(")")) return fail("a closing bracket");
    return component_of(*inner);
  }
  if (take("-")) {
    if (++nesting_ > max_nesting) return fail("fewer signs");
    auto part = power();
    --nesting_;
    if (!part) return part;
    return make({.kind = Kind::negative, .parts = {*part}});
  }
  if (c == '"' || c == '\'') return quoted(c);
  if (is_digit(c) || c == '.') return number();
  if (is_letter(c)) return named();
  return fail("a number, a name or a bracket");
}

ExpressionParser::Parsed ExpressionParser::quoted(char quote) {
  const std::size_t end = text_.find(quote, at_ + 1);
  if (end == std::string_view::npos) return fail("a closing quote");
  const std::string inner(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  return make({.value = inner});
}

ExpressionParser::Parsed ExpressionParser::number() {
  const std::string rest(text_.substr(at_, 40));
  char* end = nullptr;
  const double value = std::strtod(rest.c_str(), &end);
  if (end == rest.c_str()) return fail("a number");
  at_ += static_cast<std::size_t>(end - rest.c_str());
  return make({.value = value});
}

ExpressionParser::Parsed ExpressionParser::named() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
  const std::string word(text_.substr(begin, at_ - begin));
  if (word == "true" || word == "false") return make({.value = word == "true"});
  if (!take("(")) return make({.kind = Kind::name, .word = word});
  Expression::Node call{.kind = Kind::call, .word = word};
  if (take(")")) return component_of(make(std::move(call)));
  do {
    auto argument = either();
    if (!argument) return argument;
    call.parts.push_back(*argument);
  } while (take(","));
  if (!take(")")) return fail("a comma or a closing bracket");
  return component_of(make(std::move(call)));
}

/// What stands right behind a closing bracket, such as `.x`; a name has its own within it.
ExpressionParser::Parsed ExpressionParser::component_of(Expression whole) {
  const std::string_view rest = text_.substr(at_);
  const bool is_one = rest.size() > 1 && rest[0] == '.' && std::string_view("xyzrgb").find(rest[1]) < 6 &&
                      (rest.size() == 2 || (!is_letter(rest[2]) && !is_digit(rest[2]) && rest[2] != '.'));
  if (!is_one) return whole;
  at_ += 2;
  return make({.kind = Kind::component, .word = std::string(1, rest[1]), .parts = {std::move(whole)}});
}

}  // namespace raywalk
