#include "lesson/expression.h"

#include "lesson/expression_parser.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace raywalk {

namespace {

using Kind = Expression::Node::Kind;

struct NumberFunction {
  std::string_view name;
  double (*of)(double);
};
constexpr std::array number_functions{
    NumberFunction{"abs", [](double x) { return std::abs(x); }},
    NumberFunction{"sqrt", [](double x) { return std::sqrt(x); }},
    NumberFunction{"round", [](double x) { return std::round(x); }},
    NumberFunction{"floor", [](double x) { return std::floor(x); }},
    NumberFunction{"log", [](double x) { return std::log(x); }},
    NumberFunction{"exp", [](double x) { return std::exp(x); }},
    NumberFunction{"sin", [](double x) { return std::sin(x * degree); }},
    NumberFunction{"cos", [](double x) { return std::cos(x * degree); }},
    NumberFunction{"tan", [](double x) { return std::tan(x * degree); }},
    NumberFunction{"asin", [](double x) { return std::asin(x) / degree; }},
    NumberFunction{"acos", [](double x) { return std::acos(x) / degree; }},
    NumberFunction{"atan", [](double x) { return std::atan(x) / degree; }},
};

std::string kind_of(const Value& value) {
  constexpr std::array<std::string_view, 5> words{"nothing", "yes or no", "a number", "a text", "a point or colour"};
  return std::string(words[value.index()]);
}

bool is_nothing(const Value& value) { return std::holds_alternative<Nothing>(value); }

Outcome arithmetic(Kind kind, const Value& a, const Value& b) {
  if (is_nothing(a) || is_nothing(b)) return Nothing{};
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  const auto *u = std::get_if<Vec3d>(&a), *v = std::get_if<Vec3d>(&b);
  if (kind == Kind::add && x && y) return *x + *y;
  if (kind == Kind::add && u && v) return *u + *v;
  if (kind == Kind::subtract && x && y) return *x - *y;
  if (kind == Kind::subtract && u && v) return *u - *v;
  if (kind == Kind::multiply && x && y) return *x * *y;
  if (kind == Kind::multiply && x && v) return *x * *v;
  if (kind == Kind::multiply && u && y) return *u * *y;
  if (kind == Kind::multiply && u && v) return *u * *v;
  if (kind == Kind::divide && x && y) return *x / *y;
  if (kind == Kind::divide && u && y) return *u / *y;
  if (kind == Kind::power && x && y) return std::pow(*x, *y);
  return wrong(fmt::format("{} and {} do not go together in this sum or product", kind_of(a), kind_of(b)));
}

Outcome compare(const std::string& sign, const Value& a, const Value& b, double within) {
  if (is_nothing(a) || is_nothing(b)) return sign == "!=";
  if (a.index() != b.index()) return wrong(fmt::format("{} is compared with {}", kind_of(a), kind_of(b)));
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  if (sign == "==" || sign == "!=") {
    bool equal = false;
    if (x != nullptr) {
      equal = within > 0 ? std::abs(*x - *y) <= within : *x == *y;
    } else if (const auto* u = std::get_if<Vec3d>(&a), *v = std::get_if<Vec3d>(&b); u != nullptr) {
      const Vec3d apart = *u - *v;
      equal = within > 0 ? std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= within : *u == *v;
    } else if (const auto* s = std::get_if<std::string>(&a), *r = std::get_if<std::string>(&b); s != nullptr) {
      equal = *s == *r;
    } else {
      equal = std::get<bool>(a) == std::get<bool>(b);
    }
    return equal == (sign == "==");
  }
  if (x == nullptr) return wrong(fmt::format("{} has no order for {}", kind_of(a), sign));
  return sign == "<" ? *x < *y : sign == "<=" ? *x <= *y : sign == ">" ? *x > *y : *x >= *y;
}

/// Functions of numbers and vectors; empty for other names.
std::optional<Outcome> mathematics(const std::string& name, const std::vector<Value>& values) {
  if (std::any_of(values.begin(), values.end(), is_nothing)) return Outcome(Nothing{});
  const auto number = [&](std::size_t i) { return i < values.size() ? std::get_if<double>(&values[i]) : nullptr; };
  const auto vector = [&](std::size_t i) { return i < values.size() ? std::get_if<Vec3d>(&values[i]) : nullptr; };
  const std::size_t count = values.size();
  for (const NumberFunction& function : number_functions) {
    if (name != function.name) continue;
    if (count != 1 || number(0) == nullptr) return wrong(name + " takes one number");
    return Outcome(function.of(*number(0)));
  }
  if (name == "min" || name == "max") {
    if (count != 2 || !number(0) || !number(1)) return wrong(name + " takes two numbers");
    return Outcome(name == "min" ? std::min(*number(0), *number(1)) : std::max(*number(0), *number(1)));
  }
  if (name == "length" || name == "brightest") {
    if (count != 1 || !vector(0)) return wrong(name + " takes a point or a colour");
    return Outcome(name == "length" ? length(*vector(0)) : max_component(*vector(0)));
  }
  if (name == "angle" || name == "distance" || name == "dot") {
    if (count != 2 || !vector(0) || !vector(1)) return wrong(name + " takes two points or directions");
    const Vec3d &u = *vector(0), &v = *vector(1);
    if (name == "distance") return Outcome(length(u - v));
    if (name == "dot") return Outcome(dot(u, v));
    return Outcome(std::atan2(length(cross(u, v)), dot(u, v)) / degree);
  }
  if (name == "vector") {
    if (count != 3 || !number(0) || !number(1) || !number(2)) return wrong("vector takes three numbers");
    return Outcome(Vec3d(*number(0), *number(1), *number(2)));
  }
  return std::nullopt;
}

bool is_mathematics(const std::string& name) {
  constexpr std::array<std::string_view, 8> others{"min",   "max",      "length", "brightest",
                                                   "angle", "distance", "dot",    "vector"};
  return std::find(others.begin(), others.end(), name) != others.end() ||
         std::any_of(number_functions.begin(), number_functions.end(),
                     [&](const NumberFunction& function) { return function.name == name; });
}

/// `point.x`, `total.r`, `(a - b).x`: a component of the value before the last dot.
Outcome component(const Value& value, std::string_view name) {
  if (is_nothing(value)) return Nothing{};
  const Vec3d* vector = std::get_if<Vec3d>(&value);
  if (vector == nullptr) return wrong(fmt::format("{} has no component {}", kind_of(value), name));
  return name == "x" || name == "r" ? vector->x : name == "y" || name == "g" ? vector->y : vector->z;
}

Outcome lookup(const std::string& word, const Scope& scope) {
  const std::size_t dot = word.rfind('.');
  if (dot != std::string::npos && dot + 2 == word.size() && std::string_view("xyzrgb").find(word.back()) < 6) {
    const Outcome whole = scope.name(std::string_view(word).substr(0, dot));
    return whole ? component(*whole, std::string_view(word).substr(dot + 1)) : whole;
  }
  return scope.name(word);
}

}  // namespace

tl::expected<Expression, std::string> Expression::parse(std::string_view text) {
  return ExpressionParser(text).parse();
}

Outcome Expression::evaluate(const Scope& scope) const {
  const Node& node = *root_;
  switch (node.kind) {
    case Kind::value:
      return node.value;
    case Kind::name:
      return lookup(node.word, scope);
    case Kind::component: {
      const Outcome whole = node.parts[0].evaluate(scope);
      return whole ? component(*whole, node.word) : whole;
    }
    case Kind::call: {
      if (!is_mathematics(node.word)) return scope.call(node.word, node.parts);
      std::vector<Value> values;
      for (const Expression& part : node.parts) {
        Outcome value = part.evaluate(scope);
        if (!value) return value;
        values.push_back(*value);
      }
      return mathematics(node.word, values).value_or(Outcome(Nothing{}));
    }
    case Kind::and_:
    case Kind::or_: {
      const Outcome left = node.parts[0].evaluate(scope);
      if (!left || holds(*left) == (node.kind == Kind::or_)) return left ? Outcome(holds(*left)) : left;
      const Outcome right = node.parts[1].evaluate(scope);
      return right ? Outcome(holds(*right)) : right;
    }
    case Kind::not_: {
      const Outcome part = node.parts[0].evaluate(scope);
      return part ? Outcome(!holds(*part)) : part;
    }
    case Kind::negative: {
      const Outcome part = node.parts[0].evaluate(scope);
      return part ? arithmetic(Kind::multiply, -1.0, *part) : part;
    }
    case Kind::add:
    case Kind::subtract:
    case Kind::multiply:
    case Kind::divide:
    case Kind::power:
    case Kind::compare: {
      const Outcome left = node.parts[0].evaluate(scope);
      if (!left) return left;
      const Outcome right = node.parts[1].evaluate(scope);
      if (!right) return right;
      if (node.kind != Kind::compare) return arithmetic(node.kind, *left, *right);
      double within = 0;
      if (node.within) {
        const Outcome tolerance = node.within->evaluate(scope);
        if (!tolerance) return tolerance;
        const double* number = std::get_if<double>(&*tolerance);
        if (number == nullptr) return wrong("the tolerance after +- is " + kind_of(*tolerance) + ", not a number");
        within = *number;
      }
      return compare(node.word, *left, *right, within);
    }
  }
  return Nothing{};
}

std::string Expression::sides(const Scope& scope) const {
  const Node& node = *root_;
  if (node.kind == Kind::and_ || node.kind == Kind::or_) {
    const std::string left = node.parts[0].sides(scope), right = node.parts[1].sides(scope);
    return left + (left.empty() || right.empty() ? "" : "; ") + right;
  }
  if (node.kind != Kind::compare) return "";
  const Outcome left = node.parts[0].evaluate(scope), right = node.parts[1].evaluate(scope);
  constexpr int decimals = 9;
  const auto shown = [](const Outcome& side) { return side ? text_of(*side, -decimals) : side.error(); };
  return shown(left) + " " + node.word + " " + shown(right);
}

std::optional<Expression> Expression::left_side() const {
  return root_->kind == Kind::compare ? std::optional(root_->parts[0]) : std::nullopt;
}

std::string text_of(const Value& value, int decimals, char decimal_mark) {
  const auto number = [&](double x) {
    const bool whole = decimals == -1 && std::abs(x) >= 999.5 && std::abs(x) < 999999.5;  // not 1.02e+03
    std::string text = decimals >= 0 ? fmt::format("{:.{}f}", x, decimals)
                       : whole       ? fmt::format("{:.0f}", x)
                                     : fmt::format("{:.{}g}", x, decimals == -1 ? 3 : -decimals);
    if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
    std::replace(text.begin(), text.end(), '.', decimal_mark);
    return text;
  };
  struct NodeWriter {
    const decltype(number)& write;
    char mark;
    std::string operator()(Nothing) const { return "nothing"; }
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(double x) const { return write(x); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const Vec3d& v) const {
      const std::string between = mark == ',' ? "; " : ", ";
      return write(v.x) + between + write(v.y) + between + write(v.z);
    }
  };
  return std::visit(NodeWriter{number, decimal_mark}, value);
}

}  // namespace raywalk
