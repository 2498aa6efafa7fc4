// Numbers as people type them.
#include "view/lesson/typed_number.h"

#include <algorithm>
#include <cmath>

#include "lesson_state.h"
#include "support/catch.h"

using namespace raywalk;

TEST_CASE("a number may be typed as people type numbers") {
  const auto means = [](std::string_view typed, double number, std::string_view unit = {}) {
    const std::vector<double> meant = typed_numbers(typed, unit);
    INFO(typed);
    CHECK(std::any_of(meant.begin(), meant.end(), [&](double each) { return std::abs(each - number) < 1e-9; }));
  };
  for (const char* two : {"2", " 2 ", "2.", "2,0", "+2", "2.00", "2x", "2 \u00d7", "4/2", " 4 / 2", "2e0", "20e-1"})
    means(two, 2);
  for (const char* half : {"0.5", "0,5", ".5", ",5", "1/2"}) means(half, 0.5);
  for (const char* nine : {"9%", "9 %", "9\u00a0%"}) means(nine, 9, "%");
  for (const char* angle : {"24.6\u00b0", "24,6 \u00b0", "24.6"}) means(angle, 24.6, "\u00b0");
  for (const char* many : {"145971", "145,971", "145.971", "145 971", "145\u202f971", "145'971"}) means(many, 145971);
  means("1,234.5", 1234.5);
  means("1.234,5", 1234.5);
  means("1,234,567", 1234567);
  means("-6.5", -6.5);
  means("\u22126,5", -6.5);
  for (const char* none : {"", " ", "two", "1 2", "12 34", "1.2.3", "2 apples", "0x10", "nan", "inf", "1e", "e5", "-",
                           "/2", "2/0", "1e999", "9%", "--2", ","}) {
    INFO(none);
    CHECK(typed_numbers(none).empty());
  }
}

TEST_CASE("a typed number of many quotients has few meanings, and one that is too long none") {
  std::string quotients = "1,111";
  while (quotients.size() + 6 <= 64) quotients += "/1,111";
  CHECK(typed_numbers(quotients).size() == std::size_t{1} << (quotients.size() / 6 + 1));
  CHECK(typed_numbers(quotients + "/1,111").empty());
  for (int i = 0; i < 100; ++i) quotients += "/1,111";
  CHECK(typed_numbers(quotients).empty());
  CHECK(typed_numbers(std::string(62, ' ') + "20").size() == 1);
  CHECK(typed_numbers(std::string(63, ' ') + "20").empty());
}

TEST_CASE("what a typed number means is what is nearer the truth") {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{"08-strip-to-picture"});
  update(state, action::GoToLessonStep{1});
  CHECK(typed_guess(state.lessons, "145,971") == 145971);
  CHECK(typed_guess(state.lessons, "145.971") == 145971);
  update(state, action::OpenLesson{"02-ray-meets-sphere"});
  update(state, action::GoToLessonStep{4});
  CHECK(typed_guess(state.lessons, "6,970") == 6.97);
  CHECK_FALSE(typed_guess(state.lessons, "six"));
}
