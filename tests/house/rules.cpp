#include "house/rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>

namespace raywalk::house {
namespace {

constexpr int long_file = 400;

// The floor that a file of src belongs to; empty for files elsewhere.
std::string floor_of(std::string_view path) {
  constexpr std::string_view src = "src/";
  if (!path.starts_with(src)) return {};
  path.remove_prefix(src.size());
  return std::string(path.substr(0, path.find('/')));
}

bool is_cpp(std::string_view path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

bool is_identifier(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

// The first character from `position` on that is no blank; 0 at the end of the text.
char next_visible(const std::string& text, std::size_t position) {
  while (position < text.size() && (text[position] == ' ' || text[position] == '\n')) ++position;
  return position < text.size() ? text[position] : '\0';
}

struct Name {
  std::string_view text;
  int line;
  std::string_view before;  // up to two characters before it, such as "::" or "->"
  char after;               // the next visible character
};

// Every identifier of `code`, which must be without comments and literals.
std::vector<Name> names_of(const std::string& code) {
  std::vector<Name> names;
  int line = 1;
  for (std::size_t i = 0; i < code.size();) {
    if (code[i] == '\n') ++line;
    if (!is_identifier(code[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < code.size() && is_identifier(code[end])) ++end;
    const std::size_t before = i >= 2 ? i - 2 : 0;
    const std::string_view all = code;
    names.push_back({all.substr(i, end - i), line, all.substr(before, i - before), next_visible(code, end)});
    i = end;
  }
  return names;
}

// The header that an #include line names, with its delimiters: "\"math/vec.h\"" or "<vector>".
std::optional<std::string> included(const std::string& line) {
  std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos || line[at] != '#') return std::nullopt;
  at = line.find_first_not_of(" \t", at + 1);
  if (at == std::string::npos || line.compare(at, 7, "include") != 0) return std::nullopt;
  const std::size_t open = line.find_first_of("\"<", at);
  if (open == std::string::npos) return std::nullopt;
  const std::size_t close = line.find_first_of("\">", open + 1);
  if (close == std::string::npos) return std::nullopt;
  return line.substr(open, close - open + 1);
}

// Headers that the web's older libc++ does not have.
constexpr std::array<std::string_view, 6> newer_headers{"format",    "expected", "execution",
                                                        "generator", "print",    "stop_token"};

// The floors that what the web is built from stands in.
bool is_on_web(const std::string& floor) { return floor != "gui" && floor != "app"; }

// The floor that a header in delimiters belongs to; empty when it is none of ours.
std::string floor_included(const Floors& floors, const std::string& header) {
  const std::size_t slash = header.find('/');
  std::string folder = slash == std::string::npos ? "" : header.substr(1, slash - 1);
  return floors.contains(folder) ? folder : "";
}

// Why `header` may not be included by a file at `path` on floor `here`; empty when it may.
std::string objection(const Floors& floors, const std::string& header, const std::string& path,
                      const std::string& here) {
  if (const std::string there = floor_included(floors, header); !there.empty()) {
    if (there == here || floors_below(floors, here).contains(there)) return {};
    return "floor " + here + " may not include " + header + ": it does not stand on " + there;
  }
  const std::string_view name = std::string_view(header).substr(1, header.size() - 2);
  const std::string_view folder = name.substr(0, name.find('/'));
  if (header.front() == '"') return header + " is to be included as \"FLOOR/name.h\", from a floor of the house";
  if (folder == "glm" && path != "src/math/vec.h") return "only src/math/vec.h includes GLM: include \"math/vec.h\"";
  const bool window = folder == "GLFW" || folder == "GL" || folder == "imgui" || name.starts_with("imgui") ||
                      folder == "ft2build.h" || folder == "freetype";
  if (window && here != "gui") return "only gui includes " + header;
  if (is_on_web(here) && std::find(newer_headers.begin(), newer_headers.end(), name) != newer_headers.end()) {
    return header + " is missing from the libc++ that the web is built with; floors up to view must do without";
  }
  return {};
}

// The words of `text` up to a closing parenthesis.
std::vector<std::string> words_to_parenthesis(const std::string& text) {
  std::istringstream in(text.substr(0, text.find(')')));
  return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

std::string report(const std::vector<Breach>& breaches) {
  std::string text;
  for (const Breach& breach : breaches) {
    text += breach.path + ":" + std::to_string(breach.line) + ": " + breach.what + "\n";
  }
  return text;
}

std::string without_comments(const std::string& code, bool keep_literals) {
  std::string out = code;
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, out.size()); ++i) {
      if (out[i] != '\n') out[i] = ' ';
    }
  };
  for (std::size_t i = 0; i < code.size();) {
    if (code.compare(i, 2, "//") == 0) {
      const std::size_t end = std::min(code.find('\n', i), code.size());
      blank(i, end);
      i = end;
    } else if (code.compare(i, 2, "/*") == 0) {
      const std::size_t close = code.find("*/", i + 2);
      const std::size_t end = close == std::string::npos ? code.size() : close + 2;
      blank(i, end);
      i = end;
    } else if (code[i] == '"' && i > 0 && code[i - 1] == 'R') {
      const std::size_t open = code.find('(', i);
      if (open == std::string::npos) return out;
      const std::string close = ")" + code.substr(i + 1, open - i - 1) + "\"";
      const std::size_t end = std::min(code.find(close, open), code.size());
      if (!keep_literals) blank(i + 1, end);
      i = end + close.size();
    } else if (code[i] == '"' || (code[i] == '\'' && (i == 0 || !is_identifier(code[i - 1])))) {
      // An apostrophe after a digit is a separator, as in 1'000.
      std::size_t end = i + 1;
      while (end < code.size() && code[end] != code[i] && code[end] != '\n') end += code[end] == '\\' ? 2 : 1;
      if (!keep_literals) blank(i + 1, end);
      i = end + 1;
    } else {
      ++i;
    }
  }
  return out;
}

Floors declared_floors(const std::string& cmake_lists) {
  Floors floors;
  const std::string call = "\nraywalk_floor(";
  for (std::size_t at = cmake_lists.find(call); at != std::string::npos; at = cmake_lists.find(call, at + 1)) {
    const std::vector<std::string> words = words_to_parenthesis(cmake_lists.substr(at + call.size()));
    if (words.empty()) continue;
    const auto below = std::find(words.begin(), words.end(), "BELOW");
    const auto uses = std::find(below, words.end(), "USES");
    floors[words.front()] = below == words.end() ? std::set<std::string>() : std::set<std::string>(below + 1, uses);
  }
  return floors;
}

std::set<std::string> floors_below(const Floors& floors, const std::string& floor) {
  std::set<std::string> all;
  for (std::vector<std::string> open{floor}; !open.empty();) {
    const auto found = floors.find(open.back());
    open.pop_back();
    if (found == floors.end()) continue;
    for (const std::string& next : found->second)
      if (all.insert(next).second) open.push_back(next);
  }
  return all;
}

std::vector<Breach> check_includes(const Floors& floors, const SourceFile& file) {
  const std::string here = floor_of(file.path);
  if (!floors.contains(here) || !is_cpp(file.path)) return {};
  std::vector<Breach> breaches;
  int number = 0;
  for (const std::string& line : lines_of(without_comments(file.text, true))) {
    ++number;
    const auto header = included(line);
    if (!header) continue;
    if (std::string what = objection(floors, *header, file.path, here); !what.empty()) {
      breaches.push_back({file.path, number, std::move(what)});
    }
  }
  return breaches;
}

std::vector<Breach> check_edges(const Floors& floors, const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> includes;
  for (const SourceFile& file : files) {
    if (!is_cpp(file.path)) continue;
    for (const std::string& line : lines_of(without_comments(file.text, true)))
      if (const auto header = included(line)) includes[floor_of(file.path)].insert(floor_included(floors, *header));
  }
  std::vector<Breach> breaches;
  for (const auto& [floor, below] : floors) {
    for (const std::string& edge : below) {
      if (floors_below(floors, edge).contains(floor)) {
        breaches.push_back({"CMakeLists.txt", 0, floor + " and " + edge + " stand on each other"});
      }
      if (!includes[floor].contains(edge)) {
        breaches.push_back({"CMakeLists.txt", 0, floor + " includes nothing from " + edge + ", below it"});
      }
      for (const std::string& other : below) {
        if (other != edge && floors_below(floors, other).contains(edge)) {
          breaches.push_back({"CMakeLists.txt", 0, floor + " reaches " + edge + " through " + other + " already"});
        }
      }
    }
  }
  return breaches;
}

std::vector<Breach> check_rooms(const SourceFile& file) {
  constexpr std::array<std::string_view, 8> shared{"appearance", "document", "drawing", "picture",
                                                   "plan",       "space",    "text",    "walk"};
  // The room of a path below src: "view/cost/cost.h" is in "cost"; "" outside of rooms.
  const auto room_of = [](std::string_view path) -> std::string_view {
    constexpr std::string_view view = "view/";
    if (!path.starts_with(view)) return {};
    path.remove_prefix(view.size());
    return path.substr(0, path.find('/') == std::string_view::npos ? 0 : path.find('/'));
  };
  const auto is_feature = [&](std::string_view room) {
    return !room.empty() && std::find(shared.begin(), shared.end(), room) == shared.end();
  };
  constexpr std::string_view source = "src/";
  if (!file.path.starts_with(source) || !is_cpp(file.path)) return {};
  const std::string_view here = room_of(std::string_view(file.path).substr(source.size()));
  if (here.empty()) return {};
  std::vector<Breach> breaches;
  int number = 0;
  for (const std::string& line : lines_of(without_comments(file.text, true))) {
    ++number;
    const auto header = included(line);
    const std::string_view there = header ? room_of(std::string_view(*header).substr(1)) : std::string_view();
    if (there == here || !is_feature(there)) continue;
    breaches.push_back({file.path, number,
                        "room " + std::string(here) + " may not include room " + std::string(there) +
                            ": what two features need stands in a shared room"});
  }
  return breaches;
}

std::vector<Breach> check_names(const SourceFile& file) {
  const std::string here = floor_of(file.path);
  if (here.empty() || here == "app" || !is_cpp(file.path)) return {};
  constexpr std::array<std::string_view, 11> printing{"cout", "cerr",   "clog",   "wcout",   "wcerr", "printf",
                                                      "puts", "stdout", "stderr", "putchar", "perror"};
  constexpr std::array<std::string_view, 6> ending{"exit", "_Exit", "_exit", "quick_exit", "abort", "terminate"};
  constexpr std::array<std::string_view, 3> newer{"jthread", "atomic_ref", "stop_token"};
  const auto is_one_of = [](const auto& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  const bool web = is_on_web(here);

  std::vector<Breach> breaches;
  const std::string code = without_comments(file.text, false);
  std::string_view previous;
  for (const Name& name : names_of(code)) {
    const bool member = name.before.ends_with(".") || name.before == "->";
    const bool call = name.after == '(';
    const std::string quoted = "'" + std::string(name.text) + "'";
    if (!member &&
        (is_one_of(printing, name.text) || ((name.text == "print" || name.text == "println") && call &&
                                            name.before == "::" && (previous == "fmt" || previous == "std")))) {
      breaches.push_back({file.path, name.line, quoted + " prints; only app may print: return the text instead"});
    }
    // `exit` may well be a distance along a ray: only the calls of the library's function are meant.
    const bool library = name.before != "::" || previous == "std";
    if (!member && call && library && is_one_of(ending, name.text)) {
      breaches.push_back({file.path, name.line, quoted + " ends the program; only app may: return an error instead"});
    }
    if (web && is_one_of(newer, name.text)) {
      breaches.push_back({file.path, name.line, quoted + " is missing from the libc++ that the web is built with"});
    }
    previous = name.text;
  }
  return breaches;
}

std::vector<Breach> check_portable(const SourceFile& file) {
  constexpr std::array<std::string_view, 8> floors{"math", "shape", "accel", "image", "scene", "io", "trace", "render"};
  constexpr std::array<std::string_view, 29> rounded{
      "sin",   "cos",   "tan",   "asin", "acos", "atan",   "atan2",  "sinh", "cosh",  "tanh",
      "asinh", "acosh", "atanh", "exp",  "exp2", "expm1",  "log",    "log2", "log10", "log1p",
      "pow",   "cbrt",  "hypot", "erf",  "erfc", "tgamma", "lgamma", "lerp", "sincos"};
  if (std::find(floors.begin(), floors.end(), floor_of(file.path)) == floors.end() || !is_cpp(file.path)) return {};
  // There these are our own, in a namespace.
  const bool defines_them = file.path.starts_with("src/math/elementary");

  std::vector<Breach> breaches;
  const std::string code = without_comments(file.text, false);
  std::string_view previous;
  for (const Name& name : names_of(code)) {
    const bool scoped = name.before == "::", member = name.before.ends_with(".") || name.before == "->";
    // `Log log(name)` declares a variable.
    const bool declared =
        name.before.size() == 2 && is_identifier(name.before[0]) && name.before[1] == ' ' && previous != "return";
    const bool library = scoped ? previous == "std" || previous == "glm" || previous == "return" : !defines_them;
    const bool function = name.after == '(' && !member && !declared && library &&
                          std::find(rounded.begin(), rounded.end(), name.text) != rounded.end();
    if (function || (scoped && previous == "std" && (name.text.ends_with("_distribution") || name.text == "complex"))) {
      breaches.push_back({file.path, name.line,
                          "'" + std::string(name.text) +
                              "' of the library differs in its last bit between machines: see "
                              "math/elementary.h"});
    }
    previous = name.text;
  }
  return breaches;
}

std::vector<Breach> check_types(const std::vector<SourceFile>& files) {
  static const std::regex opens(R"(namespace ?([\w:]*) \{.*)"), closes(R"(\}  // namespace.*)"),
      defines(R"((?:struct|class|enum class) (?:\[\[.*\]\] |alignas\(\d+\) )?(\w+)(?: final)?(?: :.*)? \{.*)");
  std::map<std::string, std::string> first;  // where each was seen first
  std::vector<Breach> breaches;
  for (const SourceFile& file : files) {
    if (!is_cpp(file.path)) continue;
    std::vector<std::string> spaces;
    int number = 0;
    for (const std::string& line : lines_of(file.text)) {
      ++number;
      std::smatch match;
      if (std::regex_match(line, match, opens)) {
        spaces.push_back(match[1]);
      } else if (std::regex_match(line, closes)) {
        if (!spaces.empty()) spaces.pop_back();
      } else if (std::regex_match(line, match, defines)) {
        std::string name;
        bool nameless = false;  // such a namespace is of one file alone
        for (const std::string& space : spaces) name += space + "::", nameless = nameless || space.empty();
        if (nameless) continue;
        name += match[1];
        if (const auto [at, is_first] = first.try_emplace(name, file.path); !is_first)
          breaches.push_back({file.path, number, "defines " + name + ", as " + at->second + " does"});
      }
    }
  }
  return breaches;
}

std::vector<Breach> check_length(const SourceFile& file) {
  if (!is_cpp(file.path)) return {};
  const auto count = static_cast<int>(lines_of(file.text).size());
  if (count <= long_file) return {};
  return {{file.path, count, "has " + std::to_string(count) + " lines: does it hold more than one subject?"}};
}

std::vector<Breach> check_shape(const SourceFile& file) {
  if (!is_cpp(file.path)) return {};
  std::vector<Breach> breaches;
  if (file.path.ends_with(".h") && file.text.find("#pragma once") == std::string::npos) {
    breaches.push_back({file.path, 0, "does not say #pragma once"});
  }
  return breaches;
}

std::vector<Breach> check_finished(const SourceFile& file) {
  // Written in two parts so that this file does not break its own rule.
  const std::array<std::string, 3> marks{std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X"};
  std::vector<Breach> breaches;
  int number = 0;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    for (const std::string& mark : marks) {
      const std::size_t at = line.find(mark);
      if (at == std::string::npos) continue;
      const bool inside = (at > 0 && is_identifier(line[at - 1])) ||
                          (at + mark.size() < line.size() && is_identifier(line[at + mark.size()]));
      if (!inside) breaches.push_back({file.path, number, "'" + mark + "': finish it or report it"});
    }
  }
  return breaches;
}

std::vector<Breach> check_version(const SourceFile& file, const std::string& version) {
  std::vector<Breach> breaches;
  int number = 0;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    if (line.find("\"" + version + "\"") != std::string::npos) {
      breaches.push_back({file.path, number, "spells out the version; use RAYWALK_VERSION"});
    }
  }
  return breaches;
}

std::string declared_version(const std::string& cmake_lists) {
  const std::size_t project = cmake_lists.find("\nproject(");
  if (project == std::string::npos) return {};
  const std::size_t close = cmake_lists.find(')', project);
  const std::string_view key = "VERSION ";
  const std::size_t at = cmake_lists.find(key, project);
  if (at == std::string::npos || at > close) return {};
  const std::size_t start = at + key.size();
  return cmake_lists.substr(start, cmake_lists.find_first_of(" \n)", start) - start);
}

std::vector<Breach> check_top_level(const std::vector<std::string>& entries, const std::string& gitignore) {
  constexpr std::array<std::string_view, 16> allowed{".ci",
                                                     ".clang-format",
                                                     ".clang-tidy",
                                                     ".git",
                                                     ".gitignore",
                                                     "LICENSE",
                                                     "CHANGELOG.md",
                                                     "CONTRIBUTING.md",
                                                     "CMakeLists.txt",
                                                     "CMakePresets.json",
                                                     "README.md",
                                                     "lessons",
                                                     "run",
                                                     "scenes",
                                                     "src",
                                                     "tests"};
  const std::vector<std::string> ignored = lines_of(gitignore);
  std::vector<Breach> breaches;
  for (const std::string& entry : entries) {
    if (std::find(allowed.begin(), allowed.end(), entry) != allowed.end()) continue;
    const auto names_it = [&](const std::string& line) { return line == "/" + entry || line == "/" + entry + "/"; };
    if (std::any_of(ignored.begin(), ignored.end(), names_it)) continue;
    breaches.push_back({entry, 0, "the design has no place for it at the top level"});
  }
  return breaches;
}

std::vector<Breach> check_floors(const Floors& floors, const std::vector<std::string>& folders) {
  std::vector<Breach> breaches;
  for (const std::string& folder : folders) {
    if (!floors.contains(folder)) breaches.push_back({"src/" + folder, 0, "is no floor of the house"});
  }
  return breaches;
}

std::vector<SourceFile> read_tree(const std::filesystem::path& root, const std::string& folder) {
  std::vector<SourceFile> files;
  if (!std::filesystem::exists(root / folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension().string();
    constexpr std::array<std::string_view, 8> text{".h", ".cpp", ".toml", ".md", ".txt", ".sh", ".json", ".html"};
    if (!entry.is_regular_file() || std::find(text.begin(), text.end(), extension) == text.end()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files.push_back({std::filesystem::relative(entry.path(), root).generic_string(),
                     {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

}  // namespace raywalk::house
