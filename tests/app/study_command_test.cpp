#include <algorithm>
#include <csignal>
#include <sstream>

#include "app/process.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("study writes its folder and says which laws hold") {
  const Folder folder;
  const Outcome outcome = folder.run({"study", "depth", "-o", "results", "--quick"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, contains("E4") && contains("mirror 0.3") && contains("holds") && contains("index.html"));
  CHECK_THAT(outcome.out, !contains("DOES NOT"));
  for (const char* file : {"results/index.html", "results/depth.csv", "results/depth-1.svg"}) CHECK(folder.holds(file));
  CHECK_THAT(folder.read("results/index.html"), contains("raywalk study depth -o DIR --quick"));
}

TEST_CASE("experiments go by name and number") {
  const Folder folder;
  const Outcome all = folder.run({"study", "--list"});
  CHECK(all.exit_code == 0);
  for (const char* name : {"numerics", "offsets", "samples", "depth", "endings", "lights", "structures", "adaptive",
                           "tessellation", "scene", "photons", "sky", "E1", "E10", "radiosity", "E11", "E12", "E14"})
    CHECK_THAT(all.out, contains(name));
  CHECK_THAT(folder.run({"study", "e4", "--list"}).out, contains("depth") && !contains("samples"));
  const Outcome unknown = folder.run({"study", "sampels", "-o", "results"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.err, contains("sampels") && contains("did you mean samples?"));
  CHECK_FALSE(folder.holds("results"));
  const Outcome nowhere = folder.run({"study", "depth"});
  CHECK(nowhere.exit_code == 2);
  CHECK_THAT(nowhere.err, contains("-o DIR"));
  folder.write("file", "");
  CHECK(folder.run({"study", "depth", "-o", "file/in", "--quick"}).exit_code == 1);
  CHECK_THAT(folder.run({"study", "--help"}).out, contains("Seeds are fixed") && contains("Examples"));
}

TEST_CASE("parts of a study, measured apart, are the study") {
  const Folder folder;
  REQUIRE(folder.run({"study", "depth", "-o", "whole", "--quick"}).exit_code == 0);
  for (const std::string part : {"3/3", "1/3"}) {
    const Outcome outcome = folder.run({"study", "depth", "-o", "parts", "--quick", "--part", part});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, contains("part " + part.substr(0, 1) + " of 3 is in parts") &&
                                contains("raywalk study depth -o DIR --quick"));
  }
  CHECK_FALSE(folder.holds("parts/index.html"));
  CHECK_FALSE(folder.holds("parts/depth.csv"));
  const std::string first = folder.read("parts/depth.part-1-of-3.csv");
  // What a part lacks, the whole measures; what is there, it does not.
  REQUIRE(folder.run({"study", "depth", "-o", "parts", "--quick"}).exit_code == 0);
  CHECK(folder.read("parts/depth.part-1-of-3.csv") == first);
  const auto lines = [&](const std::string& name) {
    const std::string text = folder.read(name);
    return std::count(text.begin(), text.end(), '\n');
  };
  CHECK(lines("parts/depth.csv") == lines("whole/depth.csv"));
  CHECK(folder.holds("parts/index.html"));
  std::istringstream rows(first);
  int found = 0;
  for (std::string row; std::getline(rows, row);)
    if (!row.empty() && row[0] != '#') {
      CHECK_THAT(folder.read("parts/depth.csv"), contains(row));
      ++found;
    }
  CHECK(found > 3);
}

TEST_CASE("study replaces nothing that no study wrote") {
  const Folder folder;
  std::filesystem::create_directory(folder / "results");
  for (const std::string name : {"index.html", "depth.csv", "depth-1.svg"}) {
    folder.write("results/" + name, "mine");
    const Outcome outcome = folder.run({"study", "depth", "-o", "results", "--quick"});
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, contains(name + ": this is not a file of a study") && contains("-o"));
    CHECK(folder.read("results/" + name) == "mine");
    std::filesystem::remove(folder / ("results/" + name));
  }
  CHECK(folder.run({"study", "depth", "-o", "results", "--quick"}).exit_code == 0);
  CHECK(folder.run({"study", "depth", "-o", "results", "--quick"}).exit_code == 0);
}

TEST_CASE("Ctrl-C leaves a study that goes on") {
  // The second is stopped inside of a path, by several threads.
  const std::string name = GENERATE("adaptive", "scattering");
  const Folder folder;
  Process process(raywalk_program(), {"study", name, "-o", "results", "--threads", name == "adaptive" ? "1" : "2"},
                  folder.path());
  process.wait_until_busy_and_catching(SIGINT);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("interrupted") && contains("goes on"));
  CHECK_FALSE(folder.holds("results/index.html"));
}
