#include "lesson/expression.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

/// Knows x = 3, v = (1, 2, 2), who = "Ball" and none.
class Names : public Scope {
 public:
  [[nodiscard]] Outcome name(std::string_view name) const override {
    if (name == "x") return 3.0;
    if (name == "v") return Vec3d(1, 2, 2);
    if (name == "who") return std::string("Ball");
    if (name == "none") return Nothing{};
    return tl::unexpected("no " + std::string(name));
  }
  [[nodiscard]] Outcome call(std::string_view function, const std::vector<Expression>& arguments) const override {
    if (function != "twice") return tl::unexpected("no " + std::string(function));
    const Outcome value = arguments[0].evaluate(*this);
    return value ? Outcome(2 * std::get<double>(*value)) : value;
  }
};

std::string value_of(const std::string& text) {
  const auto expression = Expression::parse(text);
  if (!expression) return "unread: " + expression.error();
  const Outcome value = expression->evaluate(Names());
  return value ? text_of(*value) : "wrong: " + value.error();
}

}  // namespace

TEST_CASE("formulas follow the order of operations") {
  CHECK(value_of("1 + 2 * x") == "7");
  CHECK(value_of("(1 + 2) * x") == "9");
  CHECK(value_of("10 - 3 - 2") == "5");
  CHECK(value_of("24 / 4 / 2") == "3");
  CHECK(value_of("2 ^ 3 ^ 2") == "512");
  CHECK(value_of("-x^2") == "-9");
  CHECK(value_of("1e-3 * 1000") == "1");
}

TEST_CASE("formulas compare, with a tolerance where one is given") {
  CHECK(value_of("x == 3") == "true");
  CHECK(value_of("x != 3") == "false");
  CHECK(value_of("x == 3.01") == "false");
  CHECK(value_of("x == 3.01 +- 0.02") == "true");
  CHECK(value_of("x != 3.01 +- 0.02") == "false");
  CHECK(value_of("v == vector(1, 2, 2.1) +- 0.05") == "false");
  CHECK(value_of("v == vector(1, 2, 2.1) +- 0.2") == "true");
  CHECK(value_of("2 < x and not x <= 2") == "true");
  CHECK(value_of("x < 3 or x >= 3") == "true");
  CHECK(value_of("who == \"Ball\" and who != 'Floor'") == "true");
}

TEST_CASE("and binds more strongly than or, and neither asks on when the answer is known") {
  CHECK(value_of("true or false and false") == "true");
  CHECK(value_of("true or missing") == "true");
  CHECK(value_of("false and missing") == "false");
  CHECK(value_of("true and missing") == "wrong: no missing");
}

TEST_CASE("nothing is equal to nothing, and fulfils no condition") {
  CHECK(value_of("none == none") == "false");
  CHECK(value_of("none != \"Ball\"") == "true");
  CHECK(value_of("none < 5") == "false");
  CHECK(value_of("none + 1") == "nothing");
  CHECK(value_of("none and true") == "false");
}

TEST_CASE("formulas know geometry, in degrees") {
  CHECK(value_of("length(v)") == "3");
  CHECK(value_of("v.y + v.g") == "4");
  CHECK(value_of("vector(1, 2, 3).y") == "2");
  CHECK(value_of("(v + v).x * 2 + (v - 3 * v).b ^ 2") == "20");
  CHECK(value_of("-(v).g") == "-2");
  CHECK(value_of("twice(x).x") == "wrong: a number has no component x");
  CHECK(value_of("(none).x") == "nothing");
  CHECK(value_of("brightest(v)") == "2");
  CHECK(value_of("angle(vector(1,0,0), vector(0,2,0))") == "90");
  CHECK(value_of("asin(1 / 2)") == "30");
  CHECK(value_of("cos(60)") == "0.5");
  CHECK(value_of("distance(v, vector(1,2,0))") == "2");
  CHECK(value_of("dot(v, v)") == "9");
  CHECK(value_of("twice(x) + min(1, 2) + max(1, 2)") == "9");
}

TEST_CASE("what is no formula is refused at its place") {
  CHECK(value_of("1 +") == "unread: \"1 +\": found the end at character 4 (expected a number, a name or a bracket)");
  CHECK(value_of("(1") == "unread: \"(1\": found the end at character 3 (expected a closing bracket)");
  CHECK(value_of("1 2") == "unread: \"1 2\": found \"2\" at character 3 (expected the end, or a sign such as + or ==)");
  CHECK_THAT(value_of("(v).q"), test::contains("unread: \"(v).q\": found \".q\" at character 4"));
  CHECK(value_of("(v).x.y").starts_with("unread: "));
  CHECK(value_of("(v).x1").starts_with("unread: "));
  CHECK(value_of("'Ball") == "unread: \"'Ball\": found \"'Ball\" at character 1 (expected a closing quote)");
  CHECK(value_of(std::string(5000, '(')).starts_with("unread: "));
  CHECK(value_of(std::string(5000, '-') + "1").starts_with("unread: "));
  std::string sum = "1";
  for (int i = 0; i < 300'000; ++i) sum += "+1";
  CHECK_THAT(value_of(sum), test::contains("unread: a formula of 600001 characters (expected at most 4096)"));
  CHECK(value_of("who + 1") == "wrong: a text and a number do not go together in this sum or product");
  CHECK(value_of("who < 1") == "wrong: a text is compared with a number");
  CHECK(value_of("sqrt(v)") == "wrong: sqrt takes one number");
}

TEST_CASE("values are written with as many decimals as are asked for") {
  CHECK(text_of(2.0 / 3, 2) == "0.67");
  CHECK(text_of(-0.001, 2) == "0.00");
  CHECK(text_of(2.0 / 3, 2, ',') == "0,67");
  CHECK(text_of(Vec3d(0.5, 1, 0), 1) == "0.5, 1.0, 0.0");
  CHECK(text_of(Vec3d(0.5, 1, 0), 1, ',') == "0,5; 1,0; 0,0");
  CHECK(text_of(21.0) == "21");
  CHECK(text_of(7381.0) == "7381");
  CHECK(text_of(-1023.6) == "-1024");
  CHECK(text_of(1e18) == "1e+18");
}
