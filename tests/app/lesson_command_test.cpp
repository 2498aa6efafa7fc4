#include "app/process.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a lesson's claims are checked with as many other seeds as are asked for") {
  const Folder folder;
  const auto checked = [&](const std::string& seeds) {
    const Outcome outcome = folder.run({"lesson", "check", "16", "--seeds", seeds});
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK_THAT(checked("0"), contains("claims hold") && !contains("seeds"));
  // The lesson's own is counted, too.
  CHECK_THAT(checked("1"), contains("with 2 seeds") && !contains("with 4 seeds"));
  CHECK_THAT(checked("3"), contains("with 4 seeds") && !contains("with 2 seeds"));
  CHECK(folder.run({"lesson", "check", "16", "--seeds", "-1"}).exit_code == 2);
}
