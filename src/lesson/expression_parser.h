#pragma once
// The representation and the parser of expressions. Internal to lesson/expression.

#include "lesson/expression.h"

#include <cstddef>
#include <optional>

namespace raywalk {

struct Expression::Node {
  enum class Kind {
    value,
    name,
    call,
    component,
    negative,
    not_,
    and_,
    or_,
    add,
    subtract,
    multiply,
    divide,
    power,
    compare
  };
  Kind kind = Kind::value;
  Value value{};                       ///< of a literal
  std::string word{};                  ///< a name, a function, a component, a comparison operator
  std::vector<Expression> parts{};     ///< arguments or sides
  std::optional<Expression> within{};  ///< a comparison's tolerance
};

class ExpressionParser {
 public:
  explicit ExpressionParser(std::string_view text) : text_(text) {}
  [[nodiscard]] tl::expected<Expression, std::string> parse();

 private:
  using Parsed = tl::expected<Expression, std::string>;
  using Kind = Expression::Node::Kind;

  [[nodiscard]] Parsed either();
  [[nodiscard]] Parsed both();
  [[nodiscard]] Parsed negation();
  [[nodiscard]] Parsed comparison();
  [[nodiscard]] Parsed sum();
  [[nodiscard]] Parsed product();
  [[nodiscard]] Parsed power();
  [[nodiscard]] Parsed single();
  [[nodiscard]] Parsed named();
  [[nodiscard]] Parsed component_of(Expression whole);
  [[nodiscard]] Parsed number();
  [[nodiscard]] Parsed quoted(char quote);

  void skip_spaces();
  [[nodiscard]] bool take(std::string_view sign);
  [[nodiscard]] bool take_word(std::string_view word);
  [[nodiscard]] tl::unexpected<std::string> fail(const std::string& expected) const;
  [[nodiscard]] static Expression make(Expression::Node node);

  std::string_view text_;
  std::size_t at_ = 0;
  int nesting_ = 0;
};

}  // namespace raywalk
