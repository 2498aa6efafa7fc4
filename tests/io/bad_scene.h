// A scene with one fault, and what must be said of it. Pieces to make such scenes from.
#pragma once

#include <string>

#include "io/scene_file.h"
#include "support/catch.h"

namespace raywalk::test {

struct BadScene {
  std::string name;
  std::string text;
  int line, column;     ///< column 0: as the TOML parser counts, which differs between versions
  std::string message;  ///< a part of it
  std::string hint;     ///< a part of it
};

/// Four lines that are a whole scene.
inline const std::string camera = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n";
/// `lines` as an object or light; its first line is line 6.
inline std::string with_object(const std::string& lines) { return camera + "[[object]]\n" + lines; }
inline std::string with_light(const std::string& lines) { return camera + "[[light]]\n" + lines; }
inline std::string with_sphere(const std::string& lines) {
  return with_object("name = \"Ball\"\ntype = \"sphere\"\n" + lines);  // first line: 8
}
inline std::string with_material(const std::string& line) {
  return with_sphere("centre = [0, 0]\nradius = 1\nmaterial = { " + line + " }\n");  // line 10
}
inline std::string with_polygon(const std::string& corners) {
  return with_object("name = \"P\"\ntype = \"polygon\"\ncorners = " + corners + "\n");  // line 8
}
inline std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

/// It is refused at its place, with its words and a hint.
inline void check_refused(const BadScene& bad) {
  INFO(bad.name << "\n" << bad.text.substr(0, 400));
  const auto scene = parse_scene(bad.text, "bad.toml");
  REQUIRE(!scene);
  const Error& error = scene.error();
  INFO(error.text());
  CHECK(error.file == "bad.toml");
  CHECK(error.line == bad.line);
  if (bad.column != 0) CHECK(error.column == bad.column);
  CHECK(error.column > 0);
  CHECK_THAT(error.message, contains(bad.message));
  CHECK_THAT(error.hint, contains(bad.hint));
  CHECK(!error.hint.empty());
}

}  // namespace raywalk::test
