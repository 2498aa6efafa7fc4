// Invariant 5: the panel cannot drift. Every line of the pseudocode on the screen stands in the tracer's source as a
// comment that heads the statement it names, in the order and in the procedure of the panel.

#include "support/catch.h"
#include "trace/pseudocode.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

using namespace raywalk;
using raywalk::test::contains;

namespace {

std::string trimmed(const std::string& line) {
  const auto begin = line.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

// The lines of the function whose head contains `head`, from its opening brace to its closing one; none if not found.
std::vector<std::string> body_of(const std::string& source, const std::string& head) {
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

bool is_comment(const std::string& line) { return line.rfind("//", 0) == 0; }

// Why the source and the pseudocode differ; "" when they do not. In both procedures every comment on a line of its own
// is a line of the pseudocode: nothing else may stand between.
std::string drift(const std::string& source) {
  for (const auto& [procedure, head] :
       {std::pair{Procedure::main_algorithm, "void main_algorithm("}, std::pair{Procedure::shade, "Rgb<T> shade("}}) {
    const std::vector<std::string> body = body_of(source, head);
    const std::string where = std::string(procedure_title(procedure)) + ": ";
    if (body.empty()) return where + "no function `" + head + "`";
    std::size_t at = 0;
    for (const PseudocodeLine& line : pseudocode) {
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

std::string tracer_source() {
  std::ifstream in(RAYWALK_SOURCE_DIR "/src/trace/tracer.h", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("every line of pseudocode heads its statement in the tracer") {
  REQUIRE_FALSE(tracer_source().empty());
  CHECK(drift(tracer_source()) == "");
}

TEST_CASE("planted drift is found") {
  const std::string source = tracer_source();
  // Another wording, a line lost, a line too many, a heading without a statement.
  CHECK_THAT(drift(replaced(source, "// Form primary ray", "// Form the primary ray")),
             contains("MAIN ALGORITHM: expected `// Form primary ray`, found `// Form the primary ray`"));
  CHECK_THAT(drift(replaced(source, "// Find intersection\n", "\n")), contains("expected `// Find intersection`"));
  CHECK_THAT(drift(replaced(source, "// If reflective\n", "// If reflective\n      // or nearly so\n")),
             contains("no statement under `// If reflective`"));
  CHECK_THAT(drift(replaced(source, "Direct direct;", "// All lights together\n    Direct direct;")),
             contains("found `// All lights together`"));
  CHECK_THAT(
      drift(replaced(source, "// Compute rtnshade", "// Compute rtnshade\n    return {};\n    // Form shadow ray")),
      contains("`// Form shadow ray` is no line"));
  // Two lines swapped, also where their texts differ only by their place.
  std::string swapped = replaced(source, "// Shade (DEPTH+1, REFLSHADE)", "// Shade (DEPTH+1, X)");
  swapped = replaced(swapped, "// Shade (DEPTH+1, REFRSHADE)", "// Shade (DEPTH+1, REFLSHADE)");
  swapped = replaced(swapped, "// Shade (DEPTH+1, X)", "// Shade (DEPTH+1, REFRSHADE)");
  CHECK_THAT(drift(swapped), contains("SHADE (DEPTH, RTNSHADE): expected `// Shade (DEPTH+1, REFLSHADE)`"));
  // A line that has moved to the other procedure.
  std::string moved = replaced(source, "// Put final shade in pixel\n", "\n");
  moved = replaced(moved, "// Compute rtnshade", "// Put final shade in pixel");
  CHECK_THAT(drift(moved), contains("MAIN ALGORITHM: no comment `// Put final shade in pixel`"));
  // A procedure renamed, and no source at all.
  CHECK_THAT(drift(replaced(source, "Rgb<T> shade(", "Rgb<T> shading(")), contains("no function"));
  CHECK_THAT(drift(""), contains("no function"));
}

TEST_CASE("the table of the pseudocode is the enumeration, in order") {
  int number = 0;
  for (const PseudocodeLine& line : pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK_FALSE(line.text.empty());
  }
  CHECK(number == line_count);
  CHECK(static_cast<int>(Line::compute_rtnshade) == line_count - 1);
  CHECK(procedure_title(Procedure::main_algorithm) == "MAIN ALGORITHM");
  CHECK(procedure_title(Procedure::shade) == "SHADE (DEPTH, RTNSHADE)");
}

TEST_CASE("a deeper line follows the condition or loop that governs it") {
  for (std::size_t i = 1; i < pseudocode.size(); ++i) {
    const PseudocodeLine &line = pseudocode[i], &above = pseudocode[i - 1];
    if (line.procedure != above.procedure || line.indent <= above.indent) continue;
    CHECK(line.indent == above.indent + 1);
    CHECK((above.text.rfind("If ", 0) == 0 || above.text.rfind("For ", 0) == 0));
  }
}
