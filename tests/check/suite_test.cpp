// The suite at a small share of its counts, and the machinery that runs it in full.

#include "check/suite.h"

#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::check;
using raywalk::test::contains;

namespace {

// Enough for the sanitizers to see all of its code; where there are none, check/numerics asks the same of far more.
constexpr std::uint64_t rays = 4'000;

/// A family of two lines of which nothing is missed but `missed`.
Family toy(std::uint64_t missed) {
  const auto run = [missed](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
    Tally tally;
    tally.rays = count;
    tally.missed = first == 0 ? missed : 0;
    tally.fast_ulps = static_cast<double>(seed);
    return tally;
  };
  return {"toy", "", {{"left", "float", run}, {"right", "double", run}}};
}

}  // namespace

TEST_CASE("every family keeps its goals on a share of its rays") {
  for (const Family& family : all_families()) {
    SuiteOptions options;
    options.rays = rays;
    const auto result = run_suite({family}, options);
    REQUIRE(result);
    INFO(table_text({family}, *result));
    CHECK(result->good());
    CHECK(result->lines.size() == family.lines.size());
  }
}

TEST_CASE("the suite splits its rays into chunks, and breaks of a goal are found in any") {
  SuiteOptions options;
  options.rays = 30'000;
  options.threads = 2;
  const auto good = run_suite({toy(0)}, options);
  REQUIRE(good);
  CHECK(good->good());
  REQUIRE(good->lines.size() == 2);
  CHECK(good->lines[0].tally.rays == 15'000);
  CHECK(good->lines[0].tally.fast_ulps == 1);
  const auto bad = run_suite({toy(3)}, options);
  REQUIRE(bad);
  CHECK_FALSE(bad->good());
  CHECK(bad->lines[1].broken == "3 missed");
  CHECK_THAT(table_text({toy(3)}, *bad), contains("BROKEN: 3 missed"));
}

TEST_CASE("each goal that a line breaks is named") {
  Tally tally;
  CHECK(broken_goal({}, tally) == "no ray could be formed");
  tally.rays = 10;
  CHECK(broken_goal({}, tally) == "");
  tally.self_hits = 1, tally.sheet_missed = 2, tally.unequal = 3, tally.false_hits = 4;
  tally.exact_ulps = 1.5, tally.fast_ulps_by_condition = 5;
  for (const char* words : {"1 self-hits", "near sheet missed 2", "3 answers differ", "4 false", "1.5 ulps", "5 times"})
    CHECK_THAT(broken_goal({}, tally), contains(words));
  // Where decisions are only promised up to the input's rounding, that is what is checked.
  Goals goals;
  goals.decisions = false;
  Tally near;
  near.rays = 10, near.missed = 2, near.excused = 2;
  CHECK(broken_goal(goals, near) == "");
  near.excused = 1;
  CHECK(broken_goal(goals, near) == "1 wrong for every ray nearby");
}

TEST_CASE("a run goes on from its state file, and refuses another run's") {
  const test::TemporaryFolder folder;
  SuiteOptions options;
  options.rays = 1000;
  options.state = folder.file("run.state");
  int lines = 0;
  Family counted = toy(2);
  for (TableLine& line : counted.lines)
    line.run = [&lines, inner = line.run](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
      ++lines;
      return inner(seed, first, count);
    };
  const auto first = run_suite({counted}, options);
  REQUIRE(first);
  CHECK(lines == 2);
  const auto second = run_suite({counted}, options);
  REQUIRE(second);
  CHECK(lines == 2);
  CHECK(second->lines.size() == 2);
  CHECK(second->lines[0].tally.missed == 2);
  CHECK(second->lines[0].tally.fast_ulps == 1);
  CHECK_FALSE(second->good());
  options.seed = 2;
  const auto other = run_suite({counted}, options);
  REQUIRE_FALSE(other);
  CHECK_THAT(other.error().text(), contains("seed 2"));
  options.seed = 1;
  options.program = "built later";
  const auto rebuilt = run_suite({counted}, options);
  REQUIRE_FALSE(rebuilt);
  CHECK_THAT(rebuilt.error().text(), contains("program built later"));
  options.program.clear();
  REQUIRE(write_file_atomically(options.state, state_text(options, {}) + "toy\tleft\tfloat\t1\t2\n"));
  const auto damaged = run_suite({counted}, options);
  REQUIRE_FALSE(damaged);
  CHECK(damaged.error().line == 2);
  // What would be read as a large number, and what stands behind the last one.
  const std::string whole = state_text(options, second->lines);
  const std::size_t count = whole.find('\t', whole.find("float\t") + 6) + 1;
  for (const std::string& text :
       {whole.substr(0, count) + "-" + whole.substr(count), whole.substr(0, whole.size() - 1) + "\t7\n"}) {
    REQUIRE(write_file_atomically(options.state, text));
    CHECK_FALSE(run_suite({counted}, options));
  }
  REQUIRE(write_file_atomically(options.state, whole));
  CHECK(run_suite({counted}, options));
}

TEST_CASE("a stopped run says that it is not finished") {
  Stopper stopper;
  stopper.raised = true;
  SuiteOptions options;
  options.stop = Stop(stopper);
  const auto result = run_suite({toy(0)}, options);
  REQUIRE(result);
  CHECK_FALSE(result->finished);
  CHECK_FALSE(result->good());
}
