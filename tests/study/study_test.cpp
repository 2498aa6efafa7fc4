// The experiments in small, whole studies in a folder, and that a study sees what is wrong.
#include "study/study.h"

#include <cmath>
#include <filesystem>

#include "study/curve.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/temporary_folder.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::study;
using namespace raywalk::test;

namespace {

StudyOptions options_in(const std::string& folder) {
  StudyOptions options{folder, Effort::glance, 2, "test machine", "raywalk study"};
  return options;
}

std::vector<Trial> kept(const std::string& folder, const std::string& name) {
  const auto csv = read_file(folder + "/" + name + ".csv", 1 << 26);
  REQUIRE(csv);
  const std::size_t heading = csv->find("\nround,") + 1, columns = csv->find('\n', heading);
  Columns named;
  for (const Experiment& e : all_experiments(Effort::glance))
    if (e.name == name) named = e.columns;
  REQUIRE(columns != std::string::npos);
  return trials_of(*csv, named, csv->substr(0, heading));
}

std::vector<std::string> broken_in(const Experiment& experiment) {
  const TemporaryFolder folder;
  const auto result = run_study({experiment}, options_in(folder.path()));
  REQUIRE(result);
  CHECK(result->finished);
  CHECK(result->laws() > 0);
  CHECK_FALSE(kept(folder.path(), experiment.name).empty());  // or it would be measured again
  return result->broken();
}

bool names(const std::vector<std::string>& broken, const std::string& law) {
  return std::find(broken.begin(), broken.end(), law) != broken.end();
}

}  // namespace

TEST_CASE("every law of every experiment holds, in small") {
  for (Experiment experiment : all_experiments(Effort::glance)) {
    CAPTURE(experiment.name);
    CHECK(experiment.rounds >= 20);
    experiment.rounds = rounds(experiment.rounds);
    const std::vector<std::string> broken = broken_in(experiment);
    for (const std::string& law : broken) UNSCOPED_INFO(law);
    CHECK((broken.empty() || sanitized));  // too few rounds to hold a law to
  }
}

TEST_CASE("planted: a biased sampler is found") {
  const auto broken = broken_in(samples_experiment(Effort::glance, {0.02, 1, false}));
  CHECK(names(broken, "samples: sobol, smooth"));
  CHECK(names(broken, "samples: jittered, smooth"));
}

TEST_CASE("planted: a wrong reference is found") {
  CHECK(names(broken_in(samples_experiment(Effort::glance, {0, 1.01, false})), "samples: sobol, smooth"));
  CHECK(names(broken_in(lights_experiment(Effort::glance, {0, 1.02, false})), "lights: sobol, open"));
  CHECK(names(broken_in(depth_experiment(Effort::glance, {0, 1.001, false})), "depth: mirror 0.3"));
  CHECK(names(broken_in(sky_experiment(Effort::glance, {0, 1.05, false})), "sky: surface, overcast"));
  CHECK(names(broken_in(radiosity_experiment(Effort::glance, {0, 1.05, false})), "radiosity: ball, mean"));
  CHECK(names(broken_in(scattering_experiment(Effort::glance, {0, 1.05, false})),
              "scattering: walks, normal, albedo 0.9"));
  CHECK(
      names(broken_in(photon_experiment(Effort::glance, {0, 1.05, false})), "photons: k = 17, k - 1 over the circle"));
}

TEST_CASE("planted: a seed that changes from sample to sample is found") {
  const auto broken = broken_in(samples_experiment(Effort::glance, {0, 1, true}));
  CHECK(names(broken, "samples: jittered, smooth"));
  CHECK(names(broken, "samples: jittered, edge"));
  CHECK(names(broken, "samples: sobol, smooth"));
  CHECK_FALSE(names(broken, "samples: random, smooth"));  // there it makes no difference
}

TEST_CASE("a study leaves tables, plots and one page, complete in itself") {
  const TemporaryFolder folder;
  const std::string at = folder.file("new");
  const auto result = run_study({depth_experiment(Effort::glance), lights_experiment(Effort::glance)}, options_in(at));
  REQUIRE(result);
  const auto page = read_file(at + "/index.html", 1 << 26);
  REQUIRE(page);
  for (const char* word : {"What accuracy costs", "E4", "E6", "test machine", "raywalk study", "Holm", "holds", "<svg",
                           "data:image/png;base64,iVBOR", "lights.csv", "dotted line"})
    CHECK_THAT(*page, contains(word));
  CHECK_THAT(*page, !contains("<script") && !contains("src='http") && !contains("href='http") && !contains("@import"));
  for (const char* file : {"depth.csv", "lights.csv", "depth-1.svg", "lights-2.svg"})
    CHECK(std::filesystem::exists(at + "/" + file));
  // Every trial is there with its costs.
  const std::vector<Trial> trials = kept(at, "lights");
  CHECK(trials.size() == 24u * 4 * 2 * 4);
  for (const Trial& trial : trials) {
    CHECK(trial.cost.rays > 0);
    CHECK(trial.cost.tests > 0);
    CHECK((trial.cost.draws > 0) == !trial.method.starts_with("regular"));
  }
}

TEST_CASE("a study that was stopped goes on, and its numbers are those of one that was not") {
  const TemporaryFolder folder;
  const std::string at = folder.path();
  const Experiment experiment = lights_experiment(Effort::glance);
  Stopper stopper;
  StudyOptions options = options_in(at);
  options.stop = Stop(stopper);
  int told = 0;
  double left = -1;
  options.progress = [&](const std::string& name, double done, double seconds_left) {
    CHECK(name == "lights");
    CHECK(done > 0);
    left = seconds_left;
    if (++told == 5) stopper.raised = true;
  };
  const auto stopped = run_study({experiment}, options);
  REQUIRE(stopped);
  CHECK_FALSE(stopped->finished);
  CHECK(left > 0);
  CHECK_FALSE(std::filesystem::exists(at + "/index.html"));
  const std::size_t before = kept(at, "lights").size();
  CHECK(before == 10u * 32);  // 5 times 2 rounds

  stopper.raised = false;
  int rounds = 0;
  Experiment counted = experiment;
  counted.run = [&](int round, const Stop& stop) {
    ++rounds;
    return experiment.run(round, stop);
  };
  options.threads = 1;
  options.progress = {};
  const auto whole = run_study({counted}, options);
  REQUIRE(whole);
  CHECK(whole->finished);
  CHECK(rounds == 14);
  const TemporaryFolder other;
  REQUIRE(run_study({experiment}, options_in(other.path())));
  std::vector<Trial> a = kept(at, "lights"), b = kept(other.path(), "lights");
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].round == b[i].round);
    CHECK(a[i].method == b[i].method);
    CHECK(a[i].error == b[i].error);
    CHECK(a[i].cost.rays == b[i].cost.rays);
    CHECK(a[i].cost.draws == b[i].cost.draws);
  }

  // Of another machine's rounds none counts; a table that is damaged is measured anew.
  rounds = 0;
  options.machine = "another";
  REQUIRE(run_study({counted}, options));
  CHECK(rounds == 25);  // and one to warm up
  REQUIRE(write_file_atomically(at + "/lights.csv", "# raywalk study lights: damaged"));
  rounds = 0;
  REQUIRE(run_study({counted}, options));
  CHECK(rounds == 25);
}

TEST_CASE(
    "the page shows factors, not their logarithms, says what a number is, and repeats itself by its own command") {
  const TemporaryFolder folder;
  Experiment factor = depth_experiment(Effort::glance);
  factor.rounds = 2;
  factor.run = [](int round, const Stop&) { return std::vector<Trial>{{round, "a", 1, 0, 0, {}}}; };
  factor.conclude = [](const std::vector<Trial>&) {
    Report report;
    report.laws.push_back({"twice",
                           "more than twice",
                           LawKind::at_least,
                           std::log(2.0),
                           {std::log(4.5), 0.01, 23},
                           0,
                           "no",
                           "how many times as many",
                           true});
    return report;
  };
  StudyOptions options = options_in(folder.path());
  options.effort = Effort::quick;
  REQUIRE(run_study({factor}, options));
  const auto page = read_file(folder.file("index.html"), 1 << 20);
  REQUIRE(page);
  CHECK_THAT(*page, contains(">at least 2.0000<") && contains(">4.5000<") && contains("how many times as many") &&
                        contains("raywalk study depth -o DIR --quick</code>"));
}

TEST_CASE("a folder that cannot be made is said") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("file"), "x"));
  const auto result = run_study({depth_experiment(Effort::glance)}, options_in(folder.file("file/in")));
  REQUIRE_FALSE(result);
  CHECK_THAT(result.error().text(), contains("file/in") && contains("hint"));
}

TEST_CASE("tables keep every bit, and what is not understood is not taken") {
  const Columns columns{"knob", "error", "other"};
  const std::vector<Trial> trials{{3, "a b", 0.1, 1.0 / 3, 1e-300, {1, 2, 3, 4, 0.5}},
                                  {4, "in float, or \"double\"", 16, -0.0, 7, {}}};
  const std::string csv = csv_of(trials, columns, "# head\n");
  const std::vector<Trial> read = trials_of(csv, columns, "# head\n");
  REQUIRE(read.size() == 2);
  CHECK(read[0].round == 3);
  CHECK(read[0].method == "a b");
  CHECK(read[0].knob == 0.1);
  CHECK(read[0].error == 1.0 / 3);
  CHECK(read[0].other == 1e-300);
  CHECK(read[0].cost.draws == 4);
  CHECK(read[0].cost.seconds == 0.5);
  CHECK_THAT(csv, contains("\n4,\"in float, or \"\"double\"\"\",16,"));  // RFC 4180
  CHECK(read[1].method == trials[1].method);
  CHECK(read[1].other == 7);
  CHECK(trials_of(csv, columns, "# other\n").empty());
  CHECK(trials_of(csv, {"knob", "error", "another"}, "# head\n").empty());
  CHECK(trials_of(csv.substr(0, csv.size() - 3), columns, "# head\n").empty());
  for (const std::string round : {"-1", "0.5", "nan", "1e300"})
    CHECK(trials_of(csv + round + ",d,1,0,0,0,0,0,0,0\n", columns, "# head\n").empty());
  CHECK(trials_of(csv + "5,d,1,0,0,0,0,0,0,0\n", columns, "# head\n").size() == 3);
  CHECK(trials_of(csv + "5,d,x,0,0,0,0,0,0,0\n", columns, "# head\n").empty());
}
