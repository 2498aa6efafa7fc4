#pragma once
// The formulas of lessons: conditions to run to, claims to check, numbers for a text. For example
//
//   line == "Form reflect ray" and depth == 2
//   t == 4.62 +- 0.01
//   n1 * sin(angle_in) == n2 * sin(angle_out) +- 1e-9
//   count(formed and kind == "shadow") == 3
//
// From lowest to highest precedence: or; and; not; == != < <= > >= (== and != with a tolerance after +-); + -; * /; ^;
// unary minus; a component such as .x or .r, of a name or behind a bracket. Strings are in either kind of quotes.
// Angles are in degrees.

#include "lesson/value.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

class Expression;

/// Resolves the names and functions of an expression.
class Scope {
 public:
  virtual ~Scope() = default;
  /// The value of a name such as "t" or "ray.length".
  [[nodiscard]] virtual Outcome name(std::string_view name) const = 0;
  /// A non-mathematical function. It may evaluate its arguments in other scopes.
  [[nodiscard]] virtual Outcome call(std::string_view function, const std::vector<Expression>& arguments) const = 0;
};

class Expression {
 public:
  /// Parses a formula, or says what is wrong with it.
  [[nodiscard]] static tl::expected<Expression, std::string> parse(std::string_view text);

  [[nodiscard]] Outcome evaluate(const Scope& scope) const;
  /// The two sides of a comparison, as values, for a message; empty for anything else.
  [[nodiscard]] std::string sides(const Scope& scope) const;

  /// The left side of a comparison; none for anything else.
  [[nodiscard]] std::optional<Expression> left_side() const;

  struct Node;

 private:
  friend class ExpressionParser;
  explicit Expression(std::shared_ptr<const Node> root) : root_(std::move(root)) {}
  std::shared_ptr<const Node> root_;
};

}  // namespace raywalk
