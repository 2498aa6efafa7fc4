// The rules of the house that a machine can check: who may include whom, what may stand where. Each rule is a function
// of one file's text, so that it can be tried on planted text as well as on the tree.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace raywalk::house {

struct SourceFile {
  std::string path;  // relative to the source folder, with forward slashes: "src/math/vec.h"
  std::string text;
};

struct Breach {
  std::string path;
  int line;  // from 1; 0 when it concerns the whole file
  std::string what;
};

// "src/math/vec.h:12: what", one breach a line; empty when there is none.
std::string report(const std::vector<Breach>& breaches);

// `code` with comments blanked out, and the contents of string and character literals too unless `keep_literals`.
// Newlines stay, so line numbers do not change.
std::string without_comments(const std::string& code, bool keep_literals);

// Each floor of the house, with those that it is declared to stand on.
using Floors = std::map<std::string, std::set<std::string>>;

// The floors that CMakeLists.txt declares: raywalk_floor(NAME BELOW floors... USES libraries...).
Floors declared_floors(const std::string& cmake_lists);

// All that a floor stands on, also through others.
std::set<std::string> floors_below(const Floors& floors, const std::string& floor);

// Src files include only from their own folder and the floors below; others' headers only where they belong.
std::vector<Breach> check_includes(const Floors& floors, const SourceFile& file);

// Every floor that one is declared to stand on is included from, and not reached through another. `files`: all of src.
std::vector<Breach> check_edges(const Floors& floors, const std::vector<SourceFile>& files);

// No room of `view`, shared or not, includes a feature, which is a room that is not shared, other than itself.
std::vector<Breach> check_rooms(const SourceFile& file);

// Below `app` nothing prints or ends the program, and nothing is used that the web's older libc++ lacks.
std::vector<Breach> check_names(const SourceFile& file);

// Floors that pictures depend on call no function of the library whose last bit is not the same everywhere.
std::vector<Breach> check_portable(const SourceFile& file);

// No two types have one name: the linker would take the functions of one for those of the other. `files`: all of src.
std::vector<Breach> check_types(const std::vector<SourceFile>& files);

// Files over 400 lines, which may hold more than one subject.
std::vector<Breach> check_length(const SourceFile& file);

// Headers say #pragma once.
std::vector<Breach> check_shape(const SourceFile& file);

// Nothing is marked as to be done later; what is missing is reported, not written into the tree.
std::vector<Breach> check_finished(const SourceFile& file);

// The number of the version stands in CMakeLists.txt alone; `version` as 1.22.3, unquoted.
std::vector<Breach> check_version(const SourceFile& file, const std::string& version);

// The version that CMakeLists.txt declares in its project(); empty when there is none.
std::string declared_version(const std::string& cmake_lists);

// The entries of the top level that neither the design nor `gitignore` (the text of .gitignore) knows.
std::vector<Breach> check_top_level(const std::vector<std::string>& entries, const std::string& gitignore);

// The folders of src that are no floor.
std::vector<Breach> check_floors(const Floors& floors, const std::vector<std::string>& folders);

// All text files under `folder` of the source tree at `root`, sorted by path.
std::vector<SourceFile> read_tree(const std::filesystem::path& root, const std::string& folder);

}  // namespace raywalk::house
