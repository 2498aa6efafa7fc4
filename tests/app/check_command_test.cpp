#include <csignal>

#include "app/process.h"
#include "support/catch.h"

using namespace raywalk::test;

namespace {

constexpr const char* without_oracle = "no exact oracle";

}  // namespace

TEST_CASE("check numerics judges rays of one family, and keeps what is done") {
  const Folder folder;
  const Outcome outcome = folder.run({"check", "numerics", "sphere", "--rays", "2400", "--state", "run.state"});
  if (outcome.err.find(without_oracle) != std::string::npos) {
    CHECK(outcome.exit_code == 1);
    return;
  }
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, contains("family") && contains("exactly tangent") && contains("double"));
  CHECK_THAT(outcome.out, !contains("BROKEN"));
  REQUIRE(folder.holds("run.state"));
  CHECK(folder.run({"check", "numerics", "sphere", "--rays", "2400", "--state", "run.state"}).out == outcome.out);
  // Another run's state is not mixed into this one.
  const Outcome other = folder.run({"check", "numerics", "sphere", "--rays", "4800", "--state", "run.state"});
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.err, contains("this keeps another run"));
}

TEST_CASE("a check of a single ray has enough of each line to judge it") {
  const Folder folder;
  const Outcome outcome = folder.run({"check", "numerics", "normals", "--rays", "1"});
  if (outcome.err.find(without_oracle) != std::string::npos) return;
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, contains("flat_polygon") && !contains("BROKEN"));
}

TEST_CASE("a check that was stopped before it kept anything does not say that it goes on from there") {
  const Folder folder;
  if (folder.run({"check", "numerics", "--list"}).err.find(without_oracle) != std::string::npos) return;
  Process process(raywalk_program(),
                  {"check", "numerics", "sphere", "--rays", "1000000000", "--threads", "1", "--state", "run.state"},
                  folder.path());
  process.wait_until_busy_and_catching(SIGINT);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("no part was finished that run.state could keep"));
  CHECK(folder.names().empty());
}

TEST_CASE("check numerics names its families, and knows a misspelt one") {
  const Folder folder;
  const Outcome listed = folder.run({"check", "numerics", "--list"});
  if (listed.err.find(without_oracle) != std::string::npos) return;
  CHECK(listed.exit_code == 0);
  for (const char* name : {"sphere\n", "flat_polygon\n", "mesh\n", "spawned\n", "accelerators\n", "laws\n"})
    CHECK_THAT(listed.out, contains(name));
  const Outcome misspelt = folder.run({"check", "numerics", "spere"});
  CHECK(misspelt.exit_code == 2);
  CHECK_THAT(misspelt.err, contains("did you mean sphere?"));
  CHECK(folder.run({"check"}).exit_code == 2);
}
