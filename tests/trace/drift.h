// Finds where the pseudocode on the screen and the source that runs differ: every line of a procedure stands in its
// function as a comment that heads the statement it names, in order, and no other comment on a line of its own does.
#pragma once

#include <fstream>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace raywalk::test {

inline std::string trimmed(const std::string& line) {
  const auto begin = line.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

// The lines of the function whose head contains `head`, from its opening brace to its closing one; none if not found.
inline std::vector<std::string> body_of(const std::string& source, const std::string& head) {
  std::istringstream in(source);
  std::vector<std::string> lines;
  int depth = 0;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (!inside && line.find(head) == std::string::npos) continue;
    inside = true;
    lines.push_back(trimmed(line));
    for (const char c : line) depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (depth == 0) break;
  }
  return lines;
}

inline bool is_comment(const std::string& line) { return line.rfind("//", 0) == 0; }

// Why the source and the pseudocode differ; "" when they do not. `heads`: each procedure with the head of its function.
template <class Table, class Procedure>
std::string drift(const std::string& source, const Table& table,
                  std::initializer_list<std::pair<Procedure, const char*>> heads) {
  for (const auto& [procedure, head] : heads) {
    const std::vector<std::string> body = body_of(source, head);
    const std::string where = std::string(name_of(procedure)) + ": ";
    if (body.empty()) return where + "no function `" + head + "`";
    std::size_t at = 0;
    for (const auto& line : table) {
      if (line.procedure != procedure) continue;
      while (at < body.size() && !is_comment(body[at])) ++at;
      if (at == body.size()) return where + "no comment `// " + std::string(line.text) + "`";
      if (body[at] != "// " + std::string(line.text))
        return where + "expected `// " + std::string(line.text) + "`, found `" + body[at] + "`";
      const std::string next = at + 1 < body.size() ? body[at + 1] : "";
      if (next.empty() || is_comment(next) || next[0] == '}') return where + "no statement under `" + body[at] + "`";
      ++at;
    }
    while (at < body.size() && !is_comment(body[at])) ++at;
    if (at < body.size()) return where + "`" + body[at] + "` is no line of the pseudocode";
  }
  return "";
}

inline std::string source_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace raywalk::test
