#include "text/memory.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("what does not fit is named, with how much is too much and what sets the limit") {
  constexpr double gib = 1 << 30;
  const MemoryNeed need{"a scene of 5 objects", 3.5 * gib, "use fewer"};
  const auto error = why_too_large(need, "big.nff", MemoryLeft{1.25 * gib, "this machine has free"});
  REQUIRE(error);
  CHECK(error->text() ==
        "big.nff: a scene of 5 objects would take about 3.5 GiB of memory, 2.2 GiB too much (expected at most 1.2 GiB, "
        "which this machine has free)\n  hint: use fewer");
  CHECK(!why_too_large(need, "", MemoryLeft{3.5 * gib, ""}));
  CHECK(!why_too_large(need, "", std::nullopt));  // nobody knows
  CHECK(!why_too_large({"a little", 1e6, ""}, ""));
}

TEST_CASE("what is left is known here, and no machine has a million terabytes") {
  const auto left = memory_left();
  REQUIRE(left);
  CHECK(left->bytes > 0);
  CHECK(!left->limit.empty());
  CHECK(why_too_large({"all of it", 1e18, ""}, ""));
}
