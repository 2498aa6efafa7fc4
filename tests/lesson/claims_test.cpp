// Words that state something, and claims that hold by luck.
#include "lesson/check.h"
#include "lesson/play.h"

#include <algorithm>

#include "support/catch.h"

using namespace raywalk;

namespace {

const std::string source_root = RAYWALK_SOURCE_DIR;
const LessonCheckSettings claim_settings{source_root + "/scenes", source_root + "/lessons/words"};

const ClaimWords& english_words() {
  static const ClaimWords words = read_claim_words(claim_settings.words_folder).value().at("en");
  return words;
}
const ClaimWords& portuguese_words() {
  static const ClaimWords words = read_claim_words(claim_settings.words_folder).value().at("pt");
  return words;
}

/// "half: halved; same: equal"
std::string stated(std::string_view text, const ClaimWords& words = english_words(), bool quotes = true) {
  std::string all;
  for (const StatedWord& word : stated_words(text, words, quotes))
    all += (all.empty() ? "" : "; ") + word.name + ": " + word.form;
  return all;
}

/// A lesson of one step, a minute or two long.
std::string steps_with(const std::string& keys) {
  return "[[step]]\nid = \"a\"\nscene = \"classic\"\npixel = 3\nrun = 'line == \"Find closest intersection\"'\n" + keys;
}
std::string words_with(const std::string& text, const std::string& reveal = "") {
  std::string words = "# Title\nSummary.\n## a: A heading\n" + text + "\n";
  if (!reveal.empty()) words += "### predict\nHow many?\n### reveal\n" + reveal + "\n### teacher\nNotes.\n";
  words += "### presenter\n";
  for (int i = 0; i < 300; ++i) words += "word ";
  return words + "\n## teacher\nNotes.\n## sources\nA book.\n";
}

LessonCheck checked(const std::string& steps, const std::string& english, const std::string& portuguese,
                    int seeds = 20) {
  auto lesson = parse_lesson(steps, "lesson.toml");
  if (!lesson) return {{lesson.error()}, {}};
  lesson->folder = "folder";
  for (const std::string code : {"en", "pt"})
    lesson->words.emplace(code, parse_words(code == "pt" ? portuguese : english, code + ".md").value());
  LessonCheckSettings wanted = claim_settings;
  wanted.seeds = seeds;
  return check_lesson(*lesson, wanted);
}

std::string claim_faults(const std::string& steps, const std::string& english, const std::string& portuguese) {
  std::string text;
  for (Error error : checked(steps, english, portuguese).errors) {
    error.hint.clear();
    text += error.text() + "\n";
  }
  return text;
}
std::string claim_faults(const std::string& steps, const std::string& words) {
  return claim_faults(steps, words, words);
}

/// A picture that hangs on random numbers.
std::string noisy(const std::string& name, int samples, const std::string& keys = "") {
  return "[[step.picture]]\nname = \"" + name + "\"\nsize = [9, 7]\nsamples = " + std::to_string(samples) +
         "\nset.render.sampler = \"random\"\n" + keys;
}

}  // namespace

TEST_CASE("words that state something are found in any form, and only where they state it") {
  CHECK(stated("The error is halved, and Twice the price: equally dear.") ==
        "half: halved; twice: Twice; same: equally");
  CHECK(stated("Is it half? Or twice as much?") == "");
  CHECK(stated("Is it half? No. It is half.") == "half: half");
  CHECK(stated("`half` of {same(\"a\", \"b\")} behalf sameness timeset") == "");
  CHECK(stated("To the last bit, bit for bit.") == "exact: last bit; exact: bit for bit");
  CHECK(stated("\"Half\" is wrong. It is 3.5 times more.", english_words(), false) == "times: times");
  CHECK(stated("\"Half\" is right.") == "half: Half");
  CHECK(stated("A METADE, duas vezes e tr\u00eas vezes; as mesmas RA\u00cdZES.", portuguese_words()) ==
        "half: METADE; twice: duas vezes; times: vezes; same: mesmas; root: RA\u00cdZES");
  CHECK(stated("um quarto fechado, um quarto de hora", portuguese_words()) == "quarter: um quarto de");
}

TEST_CASE("numbers that are typed are found; names, years and right angles are none") {
  CHECK(typed_number("It takes 16 times as long.", english_words()) == "16");
  CHECK(typed_number("Pixel 9 of lesson 11, in 1986: above 90\u00b0, from 0 to 1, b\u00b2 \u2212 4ac in 3-D. {t:2} `7`",
                     english_words()) == "");
  CHECK(typed_number("O pixel 9 tem 45\u00b0.", portuguese_words()) == "45");
}

TEST_CASE("a word that no claim bears out fails, in its language and with its line") {
  const std::string words = words_with("It is half as far.");
  CHECK(claim_faults(steps_with(""), words, words_with("Fica longe.")) ==
        "en.md:4: \"half\" states something that no claim of the step \"a\" bears out\n");
  CHECK(claim_faults(steps_with("says.half = 't < 100'\n"), words, words_with("Fica na metade.")) == "");
  CHECK(claim_faults(steps_with("says.half = { means = \"a way of speaking\" }\n"), words) == "");
  CHECK_THAT(claim_faults(steps_with("says.half = 't < 1'\n"), words),
             test::contains("the trace does not bear out: t < 1"));
  CHECK_THAT(claim_faults(steps_with("says.half = ['t > 0', 't < 1']\n"), words),
             test::contains("the trace does not bear out: t < 1"));
  // Headings state something too, and so do words about the whole lesson.
  std::string heading = words;
  heading.replace(heading.find("A heading"), 9, "Twice");
  CHECK_THAT(claim_faults(steps_with("says.half = 't > 0'\n"), heading), test::contains("en.md:3: \"Twice\" states"));
  std::string summary = words;
  summary.replace(summary.find("Summary."), 8, "The same.");
  const std::string half = steps_with("says.half = 't > 0'\n");
  CHECK_THAT(claim_faults(half, summary),
             test::contains("en.md:2: \"same\" states something that no claim of the lesson"));
  CHECK(claim_faults("says.same = 'a == 1 +- 1e-9'\n" + half, summary) == "");
}

TEST_CASE("what is said and stands in no words, or on no list, fails") {
  CHECK_THAT(claim_faults(steps_with("says.half = 't > 0'\n"), words_with("Far.")),
             test::contains("folder/lesson.toml:6: says.half: no word of these stands in the words, in any language"));
  CHECK_THAT(claim_faults(steps_with("says.halff = 't > 0'\n"), words_with("Far.")),
             test::contains("says.halff: not on the list (expected exact, fraction, half"));
  CHECK_THAT(claim_faults(steps_with("says.half = {}\n"), words_with("half")),
             test::contains("says.half: expected a claim"));
  CHECK_THAT(claim_faults(steps_with("says.half = '1 +'\n"), words_with("half")),
             test::contains("lesson.toml:6: says.half"));
}

TEST_CASE("an answer with a typed number in it fails") {
  const std::string steps = steps_with("predict.number = 'count(formed)'\n");
  CHECK(claim_faults(steps, words_with("Text.", "It takes 37 rays.")) ==
        "en.md:8: the number 37 is typed into the answer of the step \"a\"\n"
        "pt.md:8: the number 37 is typed into the answer of the step \"a\"\n");
  CHECK(claim_faults(steps, words_with("Text.", "It takes {count(formed)} rays.")) == "");
}

TEST_CASE("what thinking finds has to be within the tolerance of the answer") {
  const auto steps = [](const std::string& theory) {
    return steps_with("predict.number = 't'\npredict.tolerance = 0.5\npredict.theory = '" + theory + "'\n");
  };
  CHECK(claim_faults(steps("7 + 0.2"), words_with("Text.", "There.")) == "");
  CHECK_THAT(claim_faults(steps("9"), words_with("Text.", "There.")),
             test::contains("theory: 9 is 9, and the trace has 7.38"));
}

TEST_CASE("a claim that holds by luck fails with other seeds, and its spread is told") {
  const std::string ratio = "rms(\"few\", \"reference\") / rms(\"many\", \"reference\")";
  const auto steps = [&](const std::string& keys) {
    return "[[step]]\nid = \"a\"\nscene = \"penumbra\"\n" + keys + noisy("few", 2) + noisy("many", 8) +
           noisy("reference", 64, "seed = 1000\n");
  };
  const std::string words = words_with("Text.");
  // Of a picture this small the error is a third more or less than by theory; the seed that is shown may be lucky.
  const LessonCheck loose = checked(steps("check = ['" + ratio + " > 0.5']\n"), words, words);
  CHECK(loose.errors.empty());
  REQUIRE(loose.spreads.size() == 1);
  CHECK(loose.spreads[0].step == "a");
  CHECK(loose.spreads[0].formula == ratio);
  CHECK(loose.spreads[0].least < loose.spreads[0].most);
  const std::string middle = std::to_string((loose.spreads[0].least + loose.spreads[0].most) / 2);
  const LessonCheck strict = checked(steps("check = ['" + ratio + " > " + middle + " or true']\n"), words, words);
  CHECK(strict.errors.empty());
  const LessonCheck lucky =
      checked(steps("check = ['abs(" + ratio + " - " + middle + ") < 1e-6 or not (1 > 2)']\n"), words, words, 0);
  CHECK(lucky.errors.empty());
  // With no other seed nothing is tried, with twenty the claim breaks.
  const std::string sharp = "check = ['" + ratio + " == " + ratio + "', '" + ratio + " > " + middle + "']\n";
  const auto broken = checked(steps(sharp), words, words).errors;
  REQUIRE_FALSE(broken.empty());
  CHECK_THAT(broken.back().message, test::contains("the trace does not bear out"));

  // An answer that varies needs one that can be thought out.
  const std::string asked = words_with("Text.", "There.");
  const auto number = [&](const std::string& keys) {
    return claim_faults(steps("predict.number = '" + ratio + "'\n" + keys), asked);
  };
  CHECK_THAT(number("predict.tolerance = 5\n"), test::contains("predict: the answer hangs on random numbers; it is"));
  CHECK(number("predict.tolerance = 5\npredict.theory = '2'\n") == "");
  CHECK_THAT(number("predict.tolerance = 0.001\npredict.theory = '2'\n"), test::contains("theory: 2 is"));
  // So does a choice that another seed turns over.
  std::string choices = words_with("Text.", "There.");
  choices.replace(choices.find("How many?"), 9, "Which?\n- more\n- less");
  CHECK_THAT(
      claim_faults(steps("predict.choices = ['" + ratio + " > " + middle + "', '" + ratio + " <= " + middle + "']\n"),
                   choices),
      test::contains("predict: another choice is right"));
}

TEST_CASE("a lesson is played whether its claims hold or not, and its pictures have the values that are checked") {
  const std::string steps =
      "[[step]]\nid = \"a\"\nscene = \"penumbra\"\npixel = 8\ncheck = ['drawn.rays == 0']\n" + noisy("drawn", 2);
  const auto lesson = parse_lesson(steps, "lesson.toml");
  REQUIRE(lesson);
  const PlayedLesson played = play_lesson(*lesson, claim_settings.scenes_folder);
  CHECK(played.errors.empty());
  REQUIRE(played.steps.size() == 1);
  const Outcome rays = value_at(played, 0, 0, *Expression::parse("drawn.rays"));
  REQUIRE(rays);
  CHECK(std::get<double>(*rays) > 0);
  const auto errors = detail::check_claims(played);
  REQUIRE(errors.size() == 1);
  CHECK_THAT(errors[0].message, test::contains("the trace does not bear out: drawn.rays == 0; it has"));
}

TEST_CASE("other seeds change what is drawn, and nothing else") {
  const std::string steps = "[[step]]\nid = \"a\"\nscene = \"penumbra\"\npixel = 8\n" + noisy("drawn", 2) +
                            noisy("kept", 2, "seed = 3\n") +
                            "[[step]]\nid = \"b\"\nscene = \"classic\"\npixel = 3\n"
                            "[[step.picture]]\nname = \"sharp\"\nsize = [9, 7]\n";
  auto lesson = parse_lesson(steps, "lesson.toml");
  REQUIRE(lesson);
  const PlayedLesson first = play_lesson(*lesson, claim_settings.scenes_folder);
  REQUIRE(first.errors.empty());
  const PlayedLesson again = play_again(first, claim_settings.scenes_folder, 5);
  REQUIRE(again.steps.size() == 2);
  const auto pixels = [](const PlayedLesson& played, std::size_t step, const char* name) {
    return played.steps[step].pictures.find(name)->second->rendering()->film_of<double>().pixels();
  };
  CHECK(depends_on_seed(first.steps[0]));
  CHECK_FALSE(depends_on_seed(first.steps[1]));
  CHECK(pixels(first, 0, "drawn") != pixels(again, 0, "drawn"));
  CHECK(pixels(first, 0, "kept") == pixels(again, 0, "kept"));
  CHECK(pixels(first, 1, "sharp") == pixels(again, 1, "sharp"));
}

TEST_CASE("each list of words has the same names, and names file and line where it is wrong") {
  const auto lists = read_claim_words(claim_settings.words_folder);
  REQUIRE(lists);
  CHECK(lists->size() >= 3);
  for (const char* word : {"half", "twice", "root", "same", "times", "exact"})
    for (const auto& [language, list] : *lists) CHECK(list.forms.contains(word));
  const auto wrong = parse_claim_words("half = [\"half\"]\ntwice = \"double\"\n", "en.toml");
  REQUIRE_FALSE(wrong);
  CHECK_THAT(wrong.error().text(), test::contains("en.toml:2: twice: expected a list of words in quotes"));
}
