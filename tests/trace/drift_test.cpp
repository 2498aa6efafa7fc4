// Invariant 5: the panel cannot drift. Every line of the pseudocode on the screen stands in the tracer's source as a
// comment that heads the statement it names, in the order and in the procedure of the panel.

#include "trace/drift.h"
#include "support/catch.h"
#include "trace/pseudocode.h"

using namespace raywalk;
using raywalk::test::contains;

namespace {

std::string drift(const std::string& source) {
  return test::drift(
      source, pseudocode,
      {std::pair{Procedure::main_algorithm, "void main_algorithm("}, std::pair{Procedure::shade, "Rgb<T> shade("}});
}

std::string tracer_source() { return test::source_of(RAYWALK_SOURCE_DIR "/src/trace/tracer.h"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string path_drift(const std::string& source) {
  return test::drift(source, path_pseudocode,
                     {std::pair{Procedure::path_tracing, "void main_algorithm("},
                      std::pair{Procedure::follow_path, "Rgb<T> follow_path("}});
}

std::string path_source() { return test::source_of(RAYWALK_SOURCE_DIR "/src/trace/path.h"); }

}  // namespace

TEST_CASE("every line of pseudocode heads its statement in the path tracer") {
  REQUIRE_FALSE(path_source().empty());
  CHECK(path_drift(path_source()) == "");
}

TEST_CASE("planted drift of the path tracer is found") {
  const std::string source = path_source();
  CHECK_THAT(path_drift(replaced(source, "// Choose direction", "// Choose a direction")),
             contains("FOLLOW PATH (RTNSHADE): expected `// Choose direction`, found `// Choose a direction`"));
  CHECK_THAT(path_drift(replaced(source, "// Add emission, weighted\n", "\n")),
             contains("expected `// Add emission, weighted`"));
  CHECK_THAT(path_drift(replaced(source, "// Follow path (final)\n", "// Follow path (final)\n      // Once more\n")),
             contains("PATH TRACING: no statement under `// Follow path (final)`"));
  CHECK_THAT(path_drift(replaced(source, "    return shade;", "    // Give it back\n    return shade;")),
             contains("`// Give it back` is no line"));
}

TEST_CASE("the table of the path tracer's pseudocode is the enumeration, in order") {
  int number = line_count;
  for (const PseudocodeLine& line : path_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK_FALSE(line.text.empty());
  }
  CHECK(static_cast<int>(Line::form_next_ray) == number - 1);
  CHECK(name_of(Procedure::path_tracing) == "PATH TRACING");
}

TEST_CASE("every line of pseudocode heads its statement in the photon tracer") {
  const std::string source = test::source_of(RAYWALK_SOURCE_DIR "/src/trace/photons.h");
  const auto photon_drift = [](const std::string& text) {
    return test::drift(text, photon_pseudocode,
                       {std::pair{Procedure::photon_mapping, "void main_algorithm("},
                        std::pair{Procedure::follow_photon, "void follow_photon("},
                        std::pair{Procedure::gather_light, "Rgb<T> gather_light("}});
  };
  REQUIRE_FALSE(source.empty());
  CHECK(photon_drift(source) == "");
  CHECK_THAT(photon_drift(replaced(source, "// Store photon", "// Keep photon")),
             contains("FOLLOW PHOTON (POWER): expected `// Store photon`, found `// Keep photon`"));
  CHECK_THAT(photon_drift(replaced(source, "// Find nearest photons\n", "\n")),
             contains("expected `// Find nearest photons`"));
  int number = line_count + path_line_count;
  for (const PseudocodeLine& line : photon_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK(&pseudocode_with(line.line) == &pseudocodes[2]);
  }
}

TEST_CASE("every line of pseudocode heads its statement in radiosity") {
  const std::string source = test::source_of(RAYWALK_SOURCE_DIR "/src/trace/radiosity.h");
  const auto radiosity_drift = [](const std::string& text) {
    return test::drift(text, radiosity_pseudocode,
                       {std::pair{Procedure::radiosity, "void main_algorithm("},
                        std::pair{Procedure::shoot_light, "void shoot_light("}});
  };
  REQUIRE_FALSE(source.empty());
  CHECK(radiosity_drift(source) == "");
  CHECK_THAT(radiosity_drift(replaced(source, "// Add what arrives", "// Add light")),
             contains("SHOOT LIGHT (PATCH): expected `// Add what arrives`, found `// Add light`"));
  int number = line_count + path_line_count + photon_line_count;
  for (const PseudocodeLine& line : radiosity_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK(&pseudocode_with(line.line) == &pseudocodes[3]);
  }
}

TEST_CASE("every line of pseudocode heads its statement in the beam tracers") {
  for (const auto& [file, procedure] :
       {std::pair{"beams.h", "Rgbd shade_parts("}, std::pair{"space_beams.h", "Shades shade_parts("}}) {
    CAPTURE(file);
    const std::string source = test::source_of(std::string(RAYWALK_SOURCE_DIR "/src/trace/") + file);
    std::vector<PseudocodeLine> lines;
    for (const PseudocodeLine& line : beam_pseudocode)
      if (!is_of_plan(line.line) || std::string_view(file) == "beams.h") lines.push_back(line);
    const auto beam_drift = [name = procedure, &lines](const std::string& text) {
      return test::drift(
          text, lines,
          {std::pair{Procedure::beam_tracing, "void main_algorithm("}, std::pair{Procedure::shade_parts, name}});
    };
    REQUIRE_FALSE(source.empty());
    CHECK(beam_drift(source) == "");
    CHECK_THAT(beam_drift(replaced(source, "// Shade its middle", "// Shade one of its points")),
               contains("expected `// Shade its middle`, found `// Shade one of its points`"));
  }
  int number = line_count + path_line_count + photon_line_count + radiosity_line_count;
  for (const PseudocodeLine& line : beam_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK(&pseudocode_with(line.line) == &pseudocodes[4]);
  }
}

TEST_CASE("every line of pseudocode heads its statement in the cone tracer") {
  const std::string source = test::source_of(RAYWALK_SOURCE_DIR "/src/trace/cones.h");
  const auto cone_drift = [](const std::string& text) {
    return test::drift(text, cone_pseudocode,
                       {std::pair{Procedure::cone_tracing, "void main_algorithm("},
                        std::pair{Procedure::shade_cone, "Rgb<T> shade_cone("}});
  };
  REQUIRE_FALSE(source.empty());
  CHECK(cone_drift(source) == "");
  CHECK_THAT(cone_drift(replaced(source, "// Find how much is uncovered", "// Find intersection")),
             contains("expected `// Find how much is uncovered`, found `// Find intersection`"));
  int number = line_count + path_line_count + photon_line_count + radiosity_line_count + beam_line_count;
  for (const PseudocodeLine& line : cone_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK(&pseudocode_with(line.line) == &pseudocodes[5]);
  }
}

TEST_CASE("every line of pseudocode heads its statement in the pencil tracer") {
  const std::string source = test::source_of(RAYWALK_SOURCE_DIR "/src/trace/pencils.h");
  const auto pencil_drift = [](const std::string& text) {
    return test::drift(text, pencil_pseudocode,
                       {std::pair{Procedure::pencil_tracing, "void main_algorithm("},
                        std::pair{Procedure::shade_pencil, "Rgb<T> shade_pencil("}});
  };
  REQUIRE_FALSE(source.empty());
  CHECK(pencil_drift(source) == "");
  CHECK_THAT(pencil_drift(replaced(source, "// Reflect: M = R M", "// Reflect: M = M R")),
             contains("expected `// Reflect: M = R M`, found `// Reflect: M = M R`"));
  int number =
      line_count + path_line_count + photon_line_count + radiosity_line_count + beam_line_count + cone_line_count;
  for (const PseudocodeLine& line : pencil_pseudocode) {
    CHECK(static_cast<int>(line.line) == number++);
    CHECK(pseudocode_of(line.line).text == line.text);
    CHECK(&pseudocode_with(line.line) == &pseudocodes[6]);
    CHECK(with_pencil(without_pencil(line.line)) == line.line);
  }
  CHECK(number == all_lines_count);
  // What both do has the same words, but where a pencil's axis is named.
  for (const PseudocodeLine& line : pseudocode) CHECK(without_pencil(with_pencil(line.line)) == line.line);
}

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
  CHECK_THAT(drift(replaced(source, "DirectLighting direct;", "// All lights together\n    DirectLighting direct;")),
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
  CHECK(name_of(Procedure::main_algorithm) == "MAIN ALGORITHM");
  CHECK(name_of(Procedure::shade) == "SHADE (DEPTH, RTNSHADE)");
}

TEST_CASE("a deeper line follows the condition or loop that governs it") {
  for (std::size_t i = 1; i < pseudocode.size(); ++i) {
    const PseudocodeLine &line = pseudocode[i], &above = pseudocode[i - 1];
    if (line.procedure != above.procedure || line.indent <= above.indent) continue;
    CHECK(line.indent == above.indent + 1);
    CHECK((above.text.rfind("If ", 0) == 0 || above.text.rfind("For ", 0) == 0));
  }
}
