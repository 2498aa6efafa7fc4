#include "app/progress_bar.h"

#include <limits>

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("durations read as clocks do") {
  CHECK(duration_text(0) == "0:00");
  CHECK(duration_text(-1) == "0:00");
  CHECK(duration_text(0.2) == "0:01");
  CHECK(duration_text(61) == "1:01");
  CHECK(duration_text(3599.5) == "1:00:00");
  CHECK(duration_text(3 * 3600 + 5) == "3:00:05");
  CHECK(duration_text(1e9) == "over 99 h");
  CHECK(duration_text(std::numeric_limits<double>::quiet_NaN()) == "over 99 h");
}

TEST_CASE("the progress line fills and fits") {
  CHECK(progress_line({0, 0, 0}, 40) == "[>                     ]   0%  0:00 left");
  CHECK(progress_line({0.5, 3, 3}, 40) == "[===========>          ]  50%  0:03 left");
  CHECK(progress_line({1, 3, 0}, 40) == "[======================] 100%  0:00 left");
  CHECK(progress_line({0.999, 3, 0.1}, 40).find("99%") != std::string::npos);
  for (const int width : {0, 1, 5, 20, 22, 23, 24, 30, 79, 500}) {
    CAPTURE(width);
    for (const double done : {0.0, 0.07, 0.5, 0.99, 1.0})
      CHECK(progress_line({done, 10, 1e7}, width).size() <= static_cast<std::size_t>(width));
  }
}
