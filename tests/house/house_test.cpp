// The rules of the house, applied to the tree.
#include "house/rules.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "support/catch.h"

using namespace raywalk::house;

namespace {

const std::filesystem::path root = RAYWALK_SOURCE_DIR;

std::string read(const std::string& name) {
  std::ifstream in(root / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> entries(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

// The text files of `folders`; never none, because a rule that saw no file would pass without checking anything.
std::vector<SourceFile> files_of(const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    const std::vector<SourceFile> found = read_tree(root, folder);
    INFO("no text file under " << folder);
    REQUIRE_FALSE(found.empty());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

template <typename Rule>
std::string breaches(const std::vector<SourceFile>& files, const Rule& rule) {
  std::string text;
  for (const SourceFile& file : files) text += report(rule(file));
  return text;
}

}  // namespace

TEST_CASE("every floor of the tree includes only what it may") {
  const auto files = files_of({"src"});
  const Floors floors = declared_floors(read("CMakeLists.txt"));
  REQUIRE(floors.contains("math"));
  CHECK(breaches(files, [&](const SourceFile& file) { return check_includes(floors, file); }) == "");
}

TEST_CASE("every floor of the tree stands on what it includes, and on no more") {
  CHECK(report(check_edges(declared_floors(read("CMakeLists.txt")), files_of({"src"}))) == "");
}

TEST_CASE("no room of the tree includes a feature") {
  const auto files = files_of({"src/view"});
  CHECK(breaches(files, check_rooms) == "");
}

TEST_CASE("no floor of the tree below app prints or ends the program") {
  const auto files = files_of({"src"});
  CHECK(breaches(files, check_names) == "");
}

TEST_CASE("no floor of the tree that pictures depend on asks the library for a last bit") {
  const auto files = files_of({"src"});
  CHECK(breaches(files, check_portable) == "");
}

TEST_CASE("no two types of the tree have one name") { CHECK(report(check_types(files_of({"src"}))) == ""); }

TEST_CASE("headers of the tree guard themselves, and long files are named") {
  const auto files = files_of({"src", "tests"});
  CHECK(breaches(files, check_shape) == "");
  // Files are cut by subject, not by length: a reader is told, nothing fails.
  if (const std::string known = breaches(files, check_length); !known.empty()) WARN(known);
}

TEST_CASE("nothing in the tree is left for later") {
  const auto files = files_of({"src", "tests"});
  CHECK(breaches(files, check_finished) == "");
  for (const std::string name : {"CHANGELOG.md", "CMakeLists.txt", "CONTRIBUTING.md", "README.md", "run"}) {
    CHECK(report(check_finished({name, read(name)})) == "");
  }
}

TEST_CASE("only CMakeLists.txt knows the version") {
  const std::string version = declared_version(read("CMakeLists.txt"));
  REQUIRE_FALSE(version.empty());
  const auto files = files_of({"src", "tests"});
  CHECK(breaches(files, [&](const SourceFile& file) { return check_version(file, version); }) == "");
}

TEST_CASE("the top level and src of the tree hold only what the design has") {
  CHECK(report(check_top_level(entries(root), read(".gitignore"))) == "");
  CHECK(report(check_floors(declared_floors(read("CMakeLists.txt")), entries(root / "src"))) == "");
}
