// The ids that the sources ask for and the files of texts belong together.

#include "text/language.h"
#include "text/plural.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "support/catch.h"

using namespace raywalk;

namespace {

namespace fs = std::filesystem;

const fs::path root = RAYWALK_SOURCE_DIR;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The languages that ship, as their files have them: nothing falls back on English.
std::vector<Catalogue> shipped() {
  std::vector<Catalogue> all;
  for (const auto& entry : fs::directory_iterator(root / "src/text")) {
    if (entry.path().extension() != ".toml") continue;
    const auto read = Catalogue::parse(contents(entry.path()), entry.path().stem().string());
    INFO(entry.path() << ": " << (read ? "" : read.error().message));
    REQUIRE(read.has_value());
    all.push_back(*read);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.code() < b.code(); });
  REQUIRE(all.size() >= 2);
  return all;
}

const Catalogue& english() { return Catalogue::embedded(); }

constexpr std::array<std::string_view, 6> forms{"zero", "one", "two", "few", "many", "other"};

/// An id as the sources name it: of a text in several forms, without the form.
std::string asked_as(std::string_view id) {
  const std::size_t dot = id.rfind('.');
  const bool is_form = std::find(forms.begin(), forms.end(), id.substr(dot + 1)) != forms.end();
  return std::string(is_form ? id.substr(0, dot) : id);
}

/// "{ray}" and so on in a text, each once.
std::set<std::string> placeholders(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close != std::string_view::npos) found.insert(std::string(text.substr(open + 1, close - open - 1)));
  }
  return found;
}

/// A place in the sources that names an id, with the arguments that the same call names: {"ray", ...}.
struct Use {
  std::string file, id;
  int line = 0;
  std::set<std::string> arguments;
};

/// Where the string that begins at `at` ends: behind its quote.
std::size_t after_string(const std::string& code, std::size_t at) {
  for (++at; at < code.size() && code[at] != '"'; ++at)
    if (code[at] == '\\') ++at;
  return at + 1;
}

/// The names of arguments between `from` and the end of the call that holds it, not those of calls within it.
std::set<std::string> named_from(const std::string& code, std::size_t from) {
  std::set<std::string> names;
  int depth = 0;
  for (std::size_t at = from; at < code.size();) {
    const char c = code[at];
    if (c == '"') {
      const std::size_t end = after_string(code, at);
      if (depth == 0 && at > 0 && code[at - 1] == '{' && end < code.size() && code[end] == ',')
        names.insert(code.substr(at + 1, end - at - 2));
      at = end;
      continue;
    }
    if (c == '(' || c == '[') ++depth;
    if ((c == ')' || c == ']') && --depth < 0) break;
    if (c == ';') break;
    ++at;
  }
  return names;
}

std::vector<Use> uses() {
  std::set<std::string> tables;
  for (const std::string_view id : english().ids()) tables.emplace(id.substr(0, id.find('.')));
  std::vector<Use> all;
  for (const auto& entry : fs::recursive_directory_iterator(root / "src")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".h") continue;
    const std::string code = contents(entry.path());
    int line = 1;
    for (std::size_t at = 0; at < code.size();) {
      if (code[at] == '\n') ++line;
      if (code.compare(at, 2, "//") == 0) {
        at = std::min(code.find('\n', at), code.size());
        continue;
      }
      if (code[at] == '\'') {  // a character, or a mark between digits
        at += code.compare(at, 3, "'\"'") == 0 ? 3 : 1;
        continue;
      }
      if (code[at] != '"') {
        ++at;
        continue;
      }
      const std::size_t end = after_string(code, at);
      const std::string text = code.substr(at + 1, end - at - 2);
      const std::size_t dot = text.find('.');
      const bool is_id = dot != std::string::npos && tables.count(text.substr(0, dot)) == 1 &&
                         std::all_of(text.begin(), text.end(), [](char c) {
                           return c == '.' || c == '_' || std::islower(static_cast<unsigned char>(c)) != 0 ||
                                  std::isdigit(static_cast<unsigned char>(c)) != 0;
                         });
      const bool is_file = text.ends_with(".toml") || text.ends_with(".md");
      if (is_id && !is_file && text.back() != '.')
        all.push_back({fs::relative(entry.path(), root).string(), text, line, named_from(code, end)});
      at = end;
    }
  }
  return all;
}

/// The tables whose texts are asked for by the name of an enumerator or of a command, and not each by its id; the tests
/// of those families ask for every one. The page's JavaScript asks for those of `page`.
const std::set<std::string> families{"accelerator", "choice",   "command",    "effect",     "ending",
                                     "explanation", "fault",    "gallery",    "integrator", "language",
                                     "line",        "name",     "subsurface", "numerics",   "page",
                                     "procedure",   "property", "ray",        "sampler"};

std::string table_of(std::string_view id) { return std::string(id.substr(0, id.find('.'))); }

}  // namespace

TEST_CASE("every id that the sources name has a text") {
  std::set<std::string> known;
  for (const std::string_view id : english().ids()) known.insert(asked_as(id));
  const std::vector<Use> all = uses();
  CHECK(all.size() > 500);
  for (const Use& use : all) {
    INFO(use.file << ":" << use.line << ": \"" << use.id << "\"");
    CHECK(known.count(use.id) == 1);
  }
}

TEST_CASE("every text is asked for") {
  std::set<std::string> asked;
  for (const Use& use : uses()) asked.insert(use.id);
  for (const std::string_view id : english().ids()) {
    INFO(id);
    CHECK((asked.count(asked_as(id)) == 1 || families.count(table_of(id)) == 1));
  }
}

TEST_CASE("what a text wants filled in is what the sources give it") {
  std::map<std::string, std::set<std::string>> wanted;
  for (const std::string_view id : english().ids()) {
    std::set<std::string>& names = wanted[asked_as(id)];
    for (const std::string& name : placeholders(*english().find(id))) names.insert(name);
  }
  // Their arguments stand elsewhere than in the call that names the id.
  const std::set<std::string> apart{"heat.scale_rays",
                                    "heat.scale_tests",
                                    "heat.scale_time",
                                    "heat.scale_noise",
                                    "property.corners",
                                    "walk.shade_called",
                                    "walk.shade_called_unlit",
                                    "walk.direction_diffuse",
                                    "walk.direction_highlight",
                                    "walk.direction_mirror",
                                    "walk.direction_transparent",
                                    "structure.test_missed",
                                    "structure.test_nearest",
                                    "structure.test_farther",
                                    "structure.test_blocks",
                                    "structure.test_filters",
                                    "notice.refused_number",
                                    "notice.refused_whole",
                                    "question.overwrite",
                                    "question.overwrite_changed",
                                    "question.unsaved_new",
                                    "question.unsaved_open",
                                    "question.unsaved_quit",
                                    "question.unsaved_link",
                                    "question.unsaved_lesson_open",
                                    "walk.photon_diffused",
                                    "walk.photon_in_highlight",
                                    "walk.photon_mirrored",
                                    "walk.photon_passed",
                                    "walk.direction_scattered",
                                    "walk.direction_small_mirror",
                                    "walk.direction_small_facet",
                                    "walk.direction_rough_matt",
                                    "walk.photon_small_mirror",
                                    "walk.photon_small_facet"};
  std::map<std::string, bool> filled;
  for (const Use& use : uses()) {
    if (use.arguments.empty()) continue;
    INFO(use.file << ":" << use.line << ": \"" << use.id << "\"");
    filled[use.id] = true;
    for (const std::string& name : wanted[use.id]) {
      INFO("{" << name << "}");
      CHECK(use.arguments.count(name) == 1);
    }
  }
  for (const auto& [id, names] : wanted) {
    INFO(id);
    if (!names.empty()) CHECK((filled[id] || apart.count(id) == 1));
  }
}

TEST_CASE("every language has every text, in all its forms, with the same things to be filled in") {
  for (Catalogue language : shipped()) {
    language.complete(english());
    INFO(language.code());
    for (const std::string& id : language.missing()) FAIL_CHECK(id << " is missing");
    for (const std::string& id : language.unknown()) FAIL_CHECK(id << " is known to nobody");
  }
  for (const Catalogue& language : shipped())
    for (const std::string_view id : language.ids()) {
      const std::string whole = asked_as(id);
      const std::string* model = english().find(id);
      if (model == nullptr) model = english().find(whole + ".other");
      INFO(language.code() << ": " << id << ": " << *language.find(id));
      REQUIRE(model != nullptr);
      std::set<std::string> own = placeholders(*language.find(id)), expected = placeholders(*model);
      if (whole != id) {  // "one shape" may leave the number out
        own.erase("count");
        expected.erase("count");
      }
      CHECK(own == expected);
      CHECK_FALSE(language.find(id)->empty());
    }
}

TEST_CASE("numbers in texts are written as the language writes them") {
  const auto has_decimal = [](std::string_view text, char mark) {
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
      if (text[i] == mark && digit(text[i - 1]) && digit(text[i + 1])) return true;
    return false;
  };
  for (const Catalogue& language : shipped()) {
    const char wrong = language.find("language.decimal_mark")->front() == '.' ? ',' : '.';
    for (const std::string_view id : language.ids()) {
      INFO(language.code() << ": " << id << ": " << *language.find(id));
      CHECK_FALSE(has_decimal(*language.find(id), wrong));
    }
  }
}

TEST_CASE("what is said in other words in English is translated") {
  // The applet's and the pseudocode's own words, signs, what the field calls the same, and what is one word in both.
  const std::set<std::string> same{"?",
                                   "Antialiasing",
                                   "Penumbra",
                                   "AUTO",
                                   "BVH",
                                   "DEPTH {number}",
                                   "0: no",
                                   "error (RMS)",
                                   "Backspace",
                                   "Del",
                                   "End",
                                   "Enter",
                                   "Home",
                                   "Page Down",
                                   "Page Up",
                                   "Shift",
                                   "no",
                                   "ideal",
                                   "Double",
                                   "Float",
                                   "Material",
                                   "Menus",
                                   "Normal",
                                   "Octree",
                                   "REFLSHADE",
                                   "REFRSHADE",
                                   "SHADE (DEPTH {depth})",
                                   "SHADE (DEPTH, RTNSHADE)",
                                   "FOLLOW PATH (RTNSHADE)",
                                   "Follow path (final)",
                                   "FOLLOW PHOTON (POWER)",
                                   "Follow photon (POWER)",
                                   "Cones",
                                   "cones",
                                   "cone",
                                   "SHADE CONE (DEPTH, RTNSHADE)",
                                   "SHADE CONE (DEPTH {depth})",
                                   "Shade cone (DEPTH+1, final)",
                                   "Shade cone (DEPTH+1, REFLSHADE)",
                                   "Shade cone (DEPTH+1, REFRSHADE)",
                                   "SHADE PENCIL (DEPTH, RTNSHADE)",
                                   "SHADE PENCIL (DEPTH {depth})",
                                   "Shade pencil (DEPTH+1, final)",
                                   "Shade pencil (DEPTH+1, REFLSHADE)",
                                   "Shade pencil (DEPTH+1, REFRSHADE)",
                                   "SHADE PARTS (DEPTH, RTNSHADE)",
                                   "SHADE PARTS (DEPTH {depth})",
                                   "Shade parts (DEPTH+1, final)",
                                   "Shade parts (DEPTH+1, REFLSHADE)",
                                   "Shade parts (DEPTH+1, REFRSHADE)",
                                   "GATHER LIGHT (RTNSHADE)",
                                   "Gather light (final)",
                                   "SHOOT LIGHT (PATCH)",
                                   "Shoot light (PATCH)",
                                   "Shade (DEPTH+1, REFLSHADE)",
                                   "Shade (DEPTH+1, REFRSHADE)",
                                   "Shade (DEPTH+1, final)",
                                   "Base",
                                   "Cone",
                                   "Face",
                                   "Links",
                                   "Slides",
                                   "antialiasing",
                                   "double",
                                   "final",
                                   "float",
                                   "kd-tree",
                                   "octree",
                                   "penumbra",
                                   "pixel",
                                   "sobol",
                                   "t",
                                   "trilinear",
                                   "whitted",
                                   "{length} = {ulps} ulp",
                                   "{number} \u00b5s",
                                   "{position} / {steps}",
                                   "{step} / {steps}",
                                   "{ulps} ulp",
                                   "\u2013"};
  std::set<std::string> seen;
  for (const Catalogue& language : shipped()) {
    if (language.code() == "en") continue;
    for (const std::string_view id : language.ids()) {
      const std::string* const model = english().find(id);
      if (model == nullptr || *model != *language.find(id) || table_of(id) == "language") continue;
      INFO(language.code() << ": " << id << ": " << *model);
      CHECK(same.count(*model) == 1);
      seen.insert(*model);
    }
  }
  for (const std::string& words : same) {
    INFO(words);
    CHECK(seen.count(words) == 1);  // the list names nothing that every language translates
  }
}
