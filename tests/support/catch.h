// Catch2, whichever of v2 (Debian 12) and v3 is installed, under the names both can serve: TEST_CASE, SECTION, CHECK,
// REQUIRE, INFO, CAPTURE, GENERATE, TEMPLATE_TEST_CASE, `Approx`, and the few below. Each test file includes this.
#pragma once

#include <string>

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace raywalk::test {

// Matches a string in which `part` occurs: CHECK_THAT(message, contains("did you mean")).
inline auto contains(const std::string& part) {
#if __has_include(<catch2/catch_test_macros.hpp>)
  return Catch::Matchers::ContainsSubstring(part);
#else
  return Catch::Matchers::Contains(part);
#endif
}

}  // namespace raywalk::test

// Leaves the test case with a message when this machine lacks what it needs (a display, the shared tables). Catch2 v2
// has no SKIP, so the case counts as passed and its message is printed.
#define RAYWALK_SKIP(message)     \
  do {                            \
    WARN("skipped: " << message); \
    return;                       \
  } while (false)
