#include "text/languages.h"

#include "support/temporary_folder.h"

#include <fstream>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string french = "[language]\nname = \"Fran\u00e7ais\"\ndecimal_mark = \",\"\nseparator = \"; \"\n";

void put(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  std::ofstream(folder.file(name), std::ios::binary) << bytes;
}

std::string codes_of(const LanguagesRead& read) {
  std::string codes;
  for (const Language language : read.languages->all()) codes += std::string(language.code()) + " ";
  return codes;
}

}  // namespace

TEST_CASE("a file that is dropped into the folder is a language; other files are none") {
  const TemporaryFolder folder;
  put(folder, "fr.toml", french + "[ending]\nhit = \"touche\"\n");
  put(folder, "README.toml", "x");
  put(folder, "fr.toml~", "x");
  put(folder, "notes.md", "x");
  const LanguagesRead read = read_languages(folder.path());
  CHECK(read.broken.empty());
  CHECK(codes_of(read) == "en fr ");
  const Language language = read.languages->find("fr").value();
  CHECK(language.name() == "Fran\u00e7ais");
  CHECK(language.decimal_mark() == ',');
  CHECK(text("ending.hit", language) == "touche");
}

TEST_CASE("a broken file is named with its line, and English stands") {
  const TemporaryFolder folder;
  put(folder, "en.toml", "[ending]\nhit = \"hit\n");
  put(folder, "fr.toml", french + "[ending]\nhit = 3\n");
  put(folder, "de.toml", std::string("\x00\x01", 2));
  const LanguagesRead read = read_languages(folder.path());
  CHECK(codes_of(read) == "en ");
  REQUIRE(read.broken.size() == 3);
  const auto of = [&](const std::string& name) {
    for (const Error& error : read.broken)
      if (error.file == folder.file(name)) return error;
    FAIL(name);
    return Error{};
  };
  CHECK(of("en.toml").line == 2);
  CHECK(of("fr.toml").line == 6);
  CHECK_THAT(of("fr.toml").message, contains("ending.hit"));
  CHECK_FALSE(of("de.toml").message.empty());
  CHECK(text("ending.hit", read.languages->english()) == text("ending.hit", Language()));
}

TEST_CASE("English itself may be changed, and the others fall back on what it says then") {
  const TemporaryFolder folder;
  put(folder, "en.toml",
      "[language]\nname = \"English\"\ndecimal_mark = \".\"\nseparator = \", \"\n[ending]\nhit = \"bang\"\n");
  put(folder, "da.toml", french);
  const LanguagesRead read = read_languages(folder.path());
  CHECK(read.broken.empty());
  CHECK(text("ending.hit", read.languages->english()) == "bang");
  CHECK(text("ending.blocked", read.languages->english()) == text("ending.blocked", Language()));
  CHECK(text("ending.hit", read.languages->find("da").value()) == "bang");
}

TEST_CASE("a folder that is not there leaves English") {
  const LanguagesRead read = read_languages("/nowhere/at/all");
  CHECK(codes_of(read) == "en ");
  CHECK(read.broken.empty());
}

TEST_CASE("digits are set as print has them: the language's decimal mark, a minus, powers of ten") {
  const Language english;
  CHECK(typeset_number("-1.25", english) == "\u22121.25");
  CHECK(typeset_power("-1.25", english) == "\u22121.25");
  CHECK(typeset_power("1.19e-15", english) == "1.19 · 10⁻¹⁵");
  CHECK(typeset_power("1e+18", english) == "10¹⁸");
  const TemporaryFolder folder;
  put(folder, "fr.toml", french);
  const LanguagesRead read = read_languages(folder.path());
  CHECK(typeset_power("-2.5e-07", read.languages->find("fr").value()) == "\u22122,5 · 10⁻⁷");
}
