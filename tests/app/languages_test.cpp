// A language is a file that is dropped into the data folder of a program that is built already.
#include "app/process.h"
#include "support/catch.h"

#include <filesystem>
#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

const std::string french_head = "[language]\nname = \"Fran\u00e7ais\"\ndecimal_mark = \",\"\nseparator = \"; \"\n";

/// Raywalk as it is installed, with a folder of texts that may be changed.
class Installed {
 public:
  Installed() {
    const fs::path source = RAYWALK_SOURCE_DIR, data = folder_.path() / "share/raywalk";
    fs::create_directories(folder_.path() / "bin");
    fs::create_directories(data);
    fs::copy_file(raywalk_program(), folder_.path() / "bin/raywalk");
    for (const std::string each : {"scenes", "lessons"}) fs::create_directory_symlink(source / each, data / each);
    fs::copy(source / "src/text", data / "text");
  }

  void put(const std::string& name, const std::string& bytes) const {
    folder_.write("share/raywalk/text/" + name, bytes);
  }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const {
    return Process(folder_ / "bin/raywalk", arguments, folder_.path()).wait();
  }
  [[nodiscard]] Outcome step_in(const std::string& language) const {
    return run({"step", "classic", "--pixel", "10", "--language", language});
  }

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("a language that is dropped into the data folder is spoken, with English for what it lacks") {
  const Installed program;
  const Outcome english = program.step_in("en"), before = program.step_in("fr");
  CHECK(english.exit_code == 0);
  CHECK(before.exit_code == 2);
  CHECK_THAT(before.err, contains("fr.toml") && contains("expected en, es or pt"));
  CHECK_THAT(program.run({"lesson", "check", "1"}).out, !contains("missing"));

  program.put("fr.toml", french_head + "[walk]\nstart = \"Rien encore.\"\n[ray]\nprimary = \"rayon primaire\"\n");
  const Outcome step = program.step_in("fr");
  CHECK(step.err == "");
  CHECK(step.exit_code == 0);
  CHECK_THAT(english.out, contains("The primary ray hits Polygon") && contains("weight 0.45,"));
  CHECK_THAT(step.out, contains("The rayon primaire hits Polygon") && contains("weight 0,45,"));

  const Outcome check = program.run({"lesson", "check", "1"});
  CHECK(check.exit_code == 0);
  CHECK_THAT(check.out, contains("not in fr") && contains("fr.toml: ") && contains("texts are missing") &&
                            contains("\n  walk.pixel_begun\n") && !contains("  walk.start\n"));
}

TEST_CASE("what is installed from the build folder is all that the program needs, texts that may be changed among it") {
  const fs::path build = fs::path(raywalk_program()).parent_path();
  if (!fs::exists(build / "cmake_install.cmake")) RAYWALK_SKIP("the program does not stand in its build folder");
  const Folder folder;
  if (Process("/bin/sh", {"-c", "command -v cmake"}, folder.path()).wait().exit_code != 0)
    RAYWALK_SKIP("cmake is not installed");
  // Without the library, which need not be built and has a test of its own.
  const std::string words = "exec cmake --install \"$0\" --prefix \"$1\" --component Unspecified";
  const Outcome installed =
      Process("/bin/sh", {"-c", words, build.string(), folder.path().string()}, folder.path()).wait();
  INFO(installed.out << installed.err);
  REQUIRE(installed.exit_code == 0);
  CHECK(folder.names() == std::vector<std::string>{"bin", "share"});
  folder.write("share/raywalk/text/fr.toml", french_head + "[ray]\nprimary = \"rayon primaire\"\n");
  const auto run = [&](const std::vector<std::string>& arguments) {
    return Process(folder / "bin/raywalk", arguments, folder.path()).wait();
  };
  const Outcome step = run({"step", "classic", "--pixel", "10", "--language", "fr"});
  CHECK(step.err == "");
  CHECK_THAT(step.out, contains("The rayon primaire hits Polygon"));
  CHECK(run({"lesson", "list"}).out == folder.run({"lesson", "list"}).out);
  CHECK(run({"lesson", "check", "1"}).exit_code == 0);
}

TEST_CASE("a broken file of texts is named with its line, and the other languages stand") {
  const Installed program;
  program.put("fr.toml", french_head + "[walk]\nstart = Rien\n");
  const Outcome refused = program.step_in("fr");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, contains("fr.toml:6:"));
  CHECK(program.step_in("pt").exit_code == 0);
  const Outcome check = program.run({"lesson", "check", "1"});
  CHECK(check.exit_code == 1);
  CHECK_THAT(check.err, contains("fr.toml:6:"));
}

TEST_CASE("where English itself is broken, what the program holds of it is spoken") {
  const Installed program;
  const Outcome whole = program.step_in("en");
  program.put("en.toml", "[walk\n");
  const Outcome step = program.step_in("en");
  CHECK(step.out == whole.out);
  CHECK(step.exit_code == 0);
  CHECK_THAT(program.step_in("xx").err, contains("en.toml:1:"));
}
