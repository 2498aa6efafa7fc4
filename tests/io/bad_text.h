// Texts in formats of words and numbers that have one fault, and what must be said of it.
#pragma once

#include "io/scene_file.h"
#include "support/catch.h"

#include <string>
#include <vector>

namespace raywalk::test {

struct BadText {
  std::string name;
  std::string text;
  int line;             ///< 0: of the whole file
  std::string message;  ///< a part of it
};

/// `parse` refuses the text at its line, in words, with a hint.
template <class Parse>
void check_refused(const Parse& parse, const BadText& bad) {
  INFO(bad.name << "\n" << bad.text.substr(0, 300));
  const auto document = parse(bad.text, "bad.scene");
  REQUIRE(!document);
  const Error& error = document.error();
  INFO(error.text());
  CHECK(error.file == "bad.scene");
  CHECK(error.line == bad.line);
  CHECK_THAT(error.message, contains(bad.message));
  CHECK(!error.hint.empty());
  CHECK(error.text().size() < 1000);
}

}  // namespace raywalk::test
