#include "text/catalogue.h"

#include "text/language.h"
#include "text/plural.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string head = "[language]\nname = \"Fran\u00e7ais\"\ndecimal_mark = \",\"\nseparator = \"; \"\n";

Catalogue catalogue_of(const std::string& texts, std::string_view code = "fr") {
  const auto read = Catalogue::parse(head + texts, code);
  INFO((read ? "" : read.error().message));
  REQUIRE(read.has_value());
  return *read;
}

}  // namespace

TEST_CASE("ids are the names of tables and keys, joined by dots") {
  const Catalogue read = catalogue_of("[walk]\nstart = \"Ici.\"\n[command.step]\nlabel = \"PAS\"\n");
  REQUIRE(read.find("walk.start") != nullptr);
  CHECK(*read.find("walk.start") == "Ici.");
  CHECK(*read.find("command.step.label") == "PAS");
  CHECK(read.find("walk") == nullptr);
  CHECK(read.find("command.step") == nullptr);
  CHECK(read.code() == "fr");
  CHECK(read.sign() == "FR");
}

TEST_CASE("a line that goes on in the next may go on with any letter") {
  // Of every alphabet, where the library's table of white space has its gaps too.
  std::string written, meant;
  for (const auto& [from, to] : {std::pair{0xA1U, 0x167FU}, {0x2100U, 0x2FFFU}, {0x3001U, 0xD7FFU}, {0xE000U, 0xFEFEU}})
    for (unsigned letter = from; letter <= to; ++letter) {
      std::string bytes;  // UTF-8
      if (letter >= 0x800) bytes += static_cast<char>(0xE0U | letter >> 12U);
      bytes += static_cast<char>(letter >= 0x800 ? 0x80U | (letter >> 6U & 0x3FU) : 0xC0U | letter >> 6U);
      bytes += static_cast<char>(0x80U | (letter & 0x3FU));
      written += "\\\n  " + bytes;
      meant += bytes;
    }
  const Catalogue read = catalogue_of("[walk]\nstart = \"\"\"\n" + written + "\"\"\"\n");
  CHECK((*read.find("walk.start") == meant));  // not printed when it fails: a hundred thousand letters
  CHECK(!Catalogue::parse(head + "[walk]\n\u00e1 = \"a\"\n", "fr").has_value());
}

TEST_CASE("English stands in the program, whole") {
  CHECK(Catalogue::embedded().ids().size() > 900);
  CHECK(Language().code() == "en");
  CHECK(Language().name() == "English");
  CHECK(Language().next() == Language());
}

TEST_CASE("what cannot be understood is refused with its line") {
  const auto wrong = [](const std::string& toml) {
    const auto read = Catalogue::parse(toml, "fr");
    REQUIRE_FALSE(read.has_value());
    CHECK_FALSE(read.error().message.empty());
    CHECK_FALSE(read.error().hint.empty());
    return read.error();
  };
  CHECK(wrong(head + "[walk]\nstart = \"Ici.\n").line == 6);
  const TextMistake number = wrong(head + "[walk]\nstart = 7\n");
  CHECK(number.line == 6);
  CHECK_THAT(number.message, contains("walk.start"));
  CHECK_THAT(wrong("[walk]\nstart = \"Ici.\"\n").message, contains("language.name"));
  CHECK_THAT(wrong("[language]\nname = \"\"\n").message, contains("language.name"));
}

TEST_CASE("what a language lacks is said in English and listed, as is what nothing asks for") {
  Languages languages;
  languages.add(catalogue_of("[ending]\nhit = \"touche\"\n[ending2]\nhit = \"?\"\n[structure.shapes]\none = \"1\"\n"));
  const Language french = languages.find("fr").value();
  CHECK(text("ending.hit", french) == "touche");
  CHECK(text("ending.blocked", french) == text("ending.blocked", languages.english()));
  const std::vector<std::string>& missing = french.catalogue().missing();
  const auto lacks = [&](const std::string& id) {
    return std::find(missing.begin(), missing.end(), id) != missing.end();
  };
  CHECK(lacks("ending.blocked"));
  CHECK_FALSE(lacks("ending.hit"));
  CHECK(lacks("structure.shapes.other"));
  CHECK_FALSE(lacks("structure.shapes.one"));
  CHECK_FALSE(lacks("structure.shapes.zero"));
  CHECK(french.catalogue().unknown() == std::vector<std::string>{"ending2.hit"});
  CHECK(text("no.such.text", french) == "no.such.text");
}

TEST_CASE("languages stand in the order of their codes, English first, and follow each other") {
  Languages languages;
  languages.add(catalogue_of("", "pt"));
  languages.add(catalogue_of("", "de"));
  std::string codes;
  for (const Language language : languages.all()) codes += std::string(language.code()) + " ";
  CHECK(codes == "en de pt ");
  CHECK(languages.english().next() == languages.find("de"));
  CHECK(languages.find("pt")->next() == languages.english());
  CHECK_FALSE(languages.find("es"));
  languages.add(catalogue_of("[ending]\nhit = \"trifft\"\n", "de"));
  CHECK(languages.all().size() == 3);
  CHECK(text("ending.hit", languages.find("de").value()) == "trifft");
}

TEST_CASE("arguments stand where their names are, whatever they hold") {
  Languages languages;
  languages.add(catalogue_of("[a]\nb = \"{x} et {y}, {x}; {z} {\"\n"));
  const Language french = languages.find("fr").value();
  CHECK(fill("a.b", french, {{"y", "{x}"}, {"x", 7}}) == "7 et {x}, 7; {z} {");
  CHECK(fill("a.b", french) == "{x} et {y}, {x}; {z} {");
}

TEST_CASE("straight quotes become those of the language, but not within code") {
  Languages languages;
  languages.add(Catalogue::parse("[language]\nname = \"x\"\ndecimal_mark = \".\"\nseparator = \", \"\n"
                                 "quotes = \"\u00ab \u00bb\"\n",
                                 "es")
                    .value());
  const std::string text = "\"One\" and (\"two\"), `key = \"three\"`.\n\"Four.\"";
  CHECK(with_quotes(text, languages.find("es").value()) ==
        "\u00abOne\u00bb and (\u00abtwo\u00bb), `key = \"three\"`.\n\u00abFour.\u00bb");
  CHECK(with_quotes("\"a\"", Language()) == "\u201ca\u201d");
}

TEST_CASE("a count chooses the form, and none has one of its own where the language wants it") {
  Languages languages;
  languages.add(
      catalogue_of("[a.n]\nzero = \"rien\"\none = \"{count} chose\"\nother = \"{count} choses\"\n"
                   "[a.m]\none = \"{count} pas\"\nother = \"{count} des pas\"\n"));
  const Language french = languages.find("fr").value();
  CHECK(fill("a.n", french, {{"count", 0}}) == "rien");
  CHECK(fill("a.n", french, {{"count", 1}}) == "1 chose");
  CHECK(fill("a.n", french, {{"count", 5}}) == "5 choses");
  CHECK(fill("a.m", french, {{"count", 0}}) == "0 pas");
  CHECK(fill("structure.shapes", languages.english(), {{"count", 1}}) ==
        text("structure.shapes.one", languages.english()));
}

TEST_CASE("plural forms follow the rules of CLDR") {
  const auto forms = [](std::string_view code, std::initializer_list<long long> counts) {
    std::string all;
    for (const long long count : counts) all += std::string(plural_form(code, count)) + " ";
    return all;
  };
  CHECK(forms("en", {0, 1, 2, 21}) == "other one other other ");
  CHECK(forms("es", {0, 1, 2}) == "other one other ");
  CHECK(forms("pt", {0, 1, 2}) == "one one other ");
  CHECK(forms("ja", {0, 1, 2}) == "other other other ");
  CHECK(forms("ru", {1, 2, 5, 11, 12, 21, 22, 111}) == "one few many many many one few many ");
  CHECK(forms("pl", {1, 2, 5, 12, 21, 22}) == "one few many many many few ");
  CHECK(forms("cs", {0, 1, 3, 5}) == "other one few other ");
  CHECK(forms("ar", {0, 1, 2, 3, 11, 100}) == "zero one two few many other ");
  CHECK(forms("unknown", {1, 2}) == "one other ");
}
