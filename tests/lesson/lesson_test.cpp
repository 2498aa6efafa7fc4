// Lessons that are right, and lessons that say what is not so.
#include "lesson/check.h"
#include "lesson/script.h"
#include "lesson/staging.h"

#include <filesystem>
#include <fstream>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using raywalk::test::in_english;
using raywalk::test::in_portuguese;

namespace {

const std::string root = RAYWALK_SOURCE_DIR;
const std::string scenes = root + "/scenes";
const LessonCheckSettings settings{scenes, root + "/lessons/words"};

const std::string good_steps = R"(
[[step]]
id = "hit"
scene = "classic"
pixel = 3
run = 'line == "Find closest intersection"'
check = ['object == "Solid Sphere"']
[[step]]
id = "mirror"
run = 'line == "Form reflect ray"'
predict.arrow = 10
[[step]]
id = "count"
reveal = 'line == "Put final shade in pixel"'
predict.number = 'count(formed)'
[[step]]
id = "choice"
pixel = 0
run = 'line == "Find closest intersection"'
predict.choices = ['ending == "hit"', 'ending == "missed"']
)";

const std::string good_words = R"(# Title
Summary.
## hit: A hit
It is {t:2} away.
### presenter
One
## mirror: A mirror
Text of two
lines.
### predict
Where to?
### reveal
There, {angle(direction, parent.normal):0} degrees.
### presenter
Two
### teacher
Wrong answers.
## count: Count
Text.
### predict
How many?
### reveal
{count(formed)}, of {at("hit", object)}.
### presenter
Three
### teacher
Wrong answers.
## choice: Choose
Text.
### predict
Which?
- a hit
- none
### reveal
None.
### presenter
)" + [] {
  std::string words;
  for (int i = 0; i < 200; ++i) words += "word ";
  return words;
}() + R"(
### teacher
Wrong answers.
## teacher
Notes.
## sources
A book.
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A lesson without a folder: its scenes are those that ship.
Result<Lesson> lesson_of(const std::string& steps, const std::string& english, const std::string& portuguese) {
  auto lesson = parse_lesson(steps, "lesson.toml");
  if (!lesson) return lesson;
  lesson->folder = "folder";
  for (const auto& [language, text] : {std::pair(in_english, english), std::pair(in_portuguese, portuguese)}) {
    const auto words = parse_words(text, std::string(language.code()) + ".md");
    if (!words) return tl::unexpected(words.error());
    lesson->words.emplace(language.code(), *words);
  }
  return lesson;
}

/// All that is wrong, one line each, without hints.
std::string faults(const std::string& steps, const std::string& english = good_words,
                   const std::string& portuguese = good_words) {
  const auto lesson = lesson_of(steps, english, portuguese);
  const auto line = [](Error error) {
    error.hint.clear();
    return error.text() + "\n";
  };
  if (!lesson) return line(lesson.error());
  std::string text;
  for (const Error& error : check_lesson(*lesson, settings).errors) text += line(error);
  return text;
}

}  // namespace

TEST_CASE("every lesson that ships is borne out by the trace, in every language") {
  const auto names = lesson_names(root + "/lessons");
  REQUIRE_FALSE(names.empty());
  for (const std::string& name : names) {
    const auto lesson = read_lesson(root + "/lessons/" + name);
    INFO(name);
    REQUIRE(lesson);
    for (const Error& error : check_lesson(*lesson, settings).errors) FAIL_CHECK(error.text());
  }
}

TEST_CASE("a step stands where it runs to, and before its line when it asks") {
  const auto lesson = lesson_of(good_steps, good_words, good_words);
  REQUIRE(lesson);
  const PlayedLesson played = play_lesson(*lesson, scenes);
  REQUIRE(played.errors.empty());
  REQUIRE(played.steps.size() == 4);
  const auto line_at = [&](const PlayedStep& step, int position) {
    return step.walk->timeline.just_run(position)->line;
  };
  CHECK(line_at(played.steps[0], played.steps[0].shown) == Line::find_closest_intersection);
  CHECK(played.steps[0].asked == played.steps[0].shown);
  CHECK(line_at(played.steps[1], played.steps[1].asked) == Line::if_reflective);
  CHECK(line_at(played.steps[1], played.steps[1].shown) == Line::form_reflect_ray);
  CHECK(played.steps[2].asked == played.steps[1].shown);
  CHECK(line_at(played.steps[2], played.steps[2].shown) == Line::put_final_shade);
  CHECK(played.steps[1].walk == played.steps[0].walk);
}

TEST_CASE("words are filled in from the trace") {
  const auto lesson = lesson_of(good_steps, good_words, good_words);
  REQUIRE(lesson);
  const PlayedLesson played = play_lesson(*lesson, scenes);
  const PlayedStep& step = played.steps[0];
  const double t = std::get<Found>(step.walk->timeline.event(step.shown - 1).detail).t;
  const Passage passage{"{t:3} of {object}, {scene(\"limits.depth\")}", 1};
  CHECK(filled(played, 0, step.shown, passage, in_english).value() == text_of(t, 3) + " of Solid Sphere, 5");
  CHECK(filled(played, 0, step.shown, {"{t:3}", 1}, in_portuguese).value() == text_of(t, 3, ','));
}

TEST_CASE("a good lesson has no fault") { CHECK(faults(good_steps) == ""); }

TEST_CASE("a claim that the trace does not bear out fails") {
  CHECK(faults(replaced(good_steps, "'object == \"Solid Sphere\"'", "'object == \"Polygon\"'")) ==
        "folder/lesson.toml:7: the trace does not bear out: object == \"Polygon\"; it has Solid Sphere == Polygon\n");
  CHECK(faults(replaced(good_steps, "'ending == \"hit\"', ", "'true', ")) ==
        "folder/lesson.toml:16: predict: 2 of the 2 choices hold in the trace (expected exactly one)\n");
  CHECK(faults(replaced(good_steps, "'count(formed)'", "'object'")) ==
        "folder/lesson.toml:15: predict: object is no number here\n");
}

TEST_CASE("a step that is not reached fails") {
  const std::string text = faults(replaced(good_steps, "\"Form reflect ray\"", "\"Form reflect\""));
  CHECK_THAT(text, raywalk::test::contains("folder/lesson.toml:10: no line of the walk"));
  CHECK_THAT(faults(replaced(good_steps, "pixel = 0", "pixel = 21")),
             raywalk::test::contains("SCREEN has no cell 21 (expected 0 to 20)"));
  CHECK_THAT(faults(replaced(good_steps, "\"classic\"", "\"clasic\"")),
             raywalk::test::contains("there is no scene \"clasic\""));
}

TEST_CASE("words that are missing or too many fail, in the language they are missing in") {
  CHECK(faults(good_steps, good_words, replaced(good_words, "### teacher\nWrong answers.\n## count", "## count")) ==
        "pt.md:7: the step \"mirror\" has no \"### teacher\"\n"
        "pt.md:7: \"### teacher\" of the step \"mirror\" stands in one language only\n");
  CHECK(faults(good_steps, replaced(good_words, "- none\n", ""), good_words) ==
        "en.md:28: the step \"choice\" has 1 choices (expected 2, as in lesson.toml)\n");
  CHECK(faults(good_steps, replaced(good_words, "## hit:", "## hitt:"), good_words) ==
        "en.md:1: the step \"hit\" has no words\nen.md:3: lesson.toml has no step \"hitt\"\n");
  CHECK(faults(good_steps, replaced(good_words, "## sources\nA book.", ""), good_words) ==
        "en.md:1: the section \"## sources\" is missing\n");
}

TEST_CASE("a number that nothing checks, and a formula that means nothing, fail") {
  CHECK(faults(good_steps, replaced(good_words, "{t:2}", "7.4"), good_words) ==
        "en.md:4: the number \"7.4 ...\" stands in the words and is checked by nothing\n");
  CHECK(faults(good_steps, replaced(good_words, "{t:2}", "{tt:2}"), good_words) ==
        "en.md:4: tt: \"tt\" is no name that formulas know; lessons/README.md lists them\n");
  CHECK_THAT(faults(good_steps, replaced(good_words, "{t:2}", "{n1}"), good_words),
             raywalk::test::contains("en.md:4: {n1} is nothing at step "));
}

TEST_CASE("a number that is another one once the answer stands there fails") {
  const std::string found = R"({so_far(line == "Find closest intersection")})";
  const std::string words = replaced(replaced(good_words, "Which?", "At {steps} steps, " + found + ": which?"), "None.",
                                     "None, at {steps} and " + found + ".");
  CHECK(faults(good_steps, words) ==
        "en.md:29: " + found + " is 0 before the answer of the step \"choice\" and 1 with it\n");
}

TEST_CASE("a presentation takes five minutes, without the steps that are extra") {
  std::string words;
  for (int i = 0; i < 600; ++i) words += "{count(formed) + 1} word ";
  const std::string long_words = replaced(good_words, "\nThree\n", "\n" + words + "\n");
  const std::string long_fault = faults(good_steps, long_words, good_words);
  CHECK(long_fault.find("en.md:1: the presenter needs 12.8 minutes (expected 2 to 5.5)") != std::string::npos);
  const std::string extra = replaced(good_steps, "id = \"count\"\n", "id = \"count\"\nextra = true\n");
  CHECK(faults(extra, long_words, good_words) == "");
  const std::string short_words = replaced(good_words, "word word word", "word");
  CHECK(faults(good_steps, short_words, good_words) == "");
  CHECK(faults(replaced(extra, "id = \"choice\"\n", "id = \"choice\"\nextra = true\n")).find("the presenter needs") !=
        std::string::npos);
  CHECK(faults(replaced(good_steps, "pixel = 3\n", "pixel = 3\nextra = 1\n")).find("extra: expected true or false") !=
        std::string::npos);
}

TEST_CASE("the minutes of a step are those of its words and its question") {
  StepWords words;
  words.presenter.text = "one two\n\nthree {a + b} \u00b7 five";
  words.reveal.text = "{t:2} seven";
  LessonStep step;
  CHECK(minutes_of(step, words) == Approx(8 / 130.0));
  step.question = ArrowQuestion{};
  CHECK(minutes_of(step, words) == Approx(8 / 130.0 + 40 / 60.0));
  CHECK(minutes_text(0) == "0:00");
  CHECK(minutes_text(1.09) == "1:05");
  CHECK(minutes_text(4.99) == "5:00");
}

TEST_CASE("a lesson's file is refused with line and hint") {
  CHECK(faults("[[step]]\nid = \"a\"\nscene = \"classic\"\nrunn = 'true'\n") ==
        "lesson.toml:4: unknown key \"runn\" in [[step]] (expected id, scene, set, remove, pixel, fault, run, reveal, "
        "predict, check, says, picture, show, then, large, breakpoints, extra, zoom or pencils)\n");
  CHECK_THAT(faults("[[step]]\nid = \"a\"\nscene = \"classic\"\nthen = \"picture\"\n"),
             raywalk::test::contains("lesson.toml:4: then stands without predict (expected both, or show)"));
  CHECK_THAT(faults("[[step]]\nid = \"a\"\nscene = \"classic\"\nthen = \"pictures\"\n"),
             raywalk::test::contains("lesson.toml:4: then: \"pictures\" is not known (expected picture, "));
  CHECK_THAT(faults("[[step]]\nid = \"a\"\nscene = \"classic\"\nlarge = 1\n"),
             raywalk::test::contains("large: expected true or false"));
  CHECK(faults("[[step]]\nid = \"a\"\n") ==
        "lesson.toml:1: the first step has no scene (expected scene = \"classic\" or another)\n");
  CHECK_THAT(faults("[[step]]\nid = \"a\"\nscene = \"classic\"\nrun = '1 +'\n"),
             raywalk::test::contains("lesson.toml:4: run: \"1 +\""));
  CHECK_THAT(faults("step = 3"), raywalk::test::contains("has no steps"));
}

TEST_CASE("words that begin without a title are refused") {
  for (const std::string begins : {"Text.", "## teacher", "## a: Heading", "### predict", "- a choice"}) {
    const auto words = parse_words("\n" + begins + "\n# Title\n", "en.md");  // a heading of ## was a fuzzer's finding
    REQUIRE_FALSE(words);
    CHECK_THAT(words.error().text(), raywalk::test::contains("en.md:2: words stand before the title"));
  }
}

TEST_CASE("a step changes values of its scene") {
  std::string steps = replaced(good_steps, "pixel = 3",
                               "pixel = 3\nset.\"Solid Sphere\".material.reflection = 0.5\n"
                               "remove = [\"Polygon\"]");
  steps = replaced(steps, "check = [",
                   "check = ['scene(\"Solid Sphere.material.reflection\") == 0.5', "
                   "'scene(\"Solid Sphere.radius\") == 1.2', 'walk(object == \"Polygon\") == 0', ");
  CHECK(faults(steps) == "");
  CHECK_THAT(faults(replaced(good_steps, "pixel = 3", "set.\"Solid Spher\".radius = 2")),
             raywalk::test::contains("there is no \"Solid Spher\" in the scene"));
  CHECK_THAT(faults(replaced(good_steps, "pixel = 3", "set.\"Solid Sphere\".radius = -2")),
             raywalk::test::contains("radius"));
}

namespace {

// The good lesson, whose last step asks for a line at fault.
std::string steps_with_bug(const std::string& keys) {
  const std::size_t last = good_steps.rfind("[[step]]");
  return good_steps.substr(0, last) + "[[step]]\nid = \"choice\"\npixel = 3\n" + keys;
}
std::string words_with_bug() { return replaced(good_words, "- a hit\n- none\n", ""); }
std::string faults_with_bug(const std::string& keys) {
  return faults(steps_with_bug(keys), words_with_bug(), words_with_bug());
}

}  // namespace

TEST_CASE("a step with a fault asks for the line at fault, and its claims are about the broken walk") {
  const std::string keys = R"(
fault = "reflection_flipped"
run = 'line == "Put final shade in pixel"'
predict.line = "Form reflect ray"
)";
  CHECK(faults_with_bug(keys) == "");
  CHECK(faults_with_bug(
            keys + "check = ['first(line == \"Form reflect ray\", angle(direction, parent.normal)) > 90']\n") == "");
  CHECK_THAT(
      faults_with_bug(keys + "check = ['first(line == \"Form reflect ray\", angle(direction, parent.normal)) < 90']\n"),
      test::contains("the trace does not bear out"));
  // The next step has the ordinary tracer again, and may begin where it likes.
  const auto lesson = parse_lesson(steps_with_bug(keys) + "[[step]]\nid = \"after\"\npixel = 3\n", "lesson.toml");
  REQUIRE(lesson);
  const PlayedLesson played = play_lesson(*lesson, scenes);
  REQUIRE(played.errors.empty());
  REQUIRE(played.steps.size() == 5);
  const PlayedStep& step = played.steps[3];
  CHECK(step.walk->fault == Fault::reflection_flipped);
  CHECK(step.asked == step.shown);  // all of the pixel is seen before the question
  CHECK_FALSE(played.steps[4].walk->fault);
}

TEST_CASE("a fault that breaks nothing, and a line that is not at fault, are said") {
  CHECK_THAT(faults_with_bug("fault = \"shadow_ray\"\npredict.line = \"Form shadow ray\"\n"),
             test::contains("fault: \"shadow_ray\" is not known (expected shadow_ray_misaimed, reflection_flipped"));
  CHECK_THAT(faults_with_bug("fault = \"attenuation_forgotten\"\nrun = 'line == \"Put final shade in pixel\"'\n"
                             "predict.line = \"Compute rtnshade\"\n"),
             test::contains("fault: attenuation_forgotten changes nothing in pixel 3"));
  CHECK_THAT(
      faults_with_bug("fault = \"reflection_flipped\"\nrun = 'line == \"Put final shade in pixel\"'\n"
                      "predict.line = \"Form refract ray\"\n"),
      test::contains("predict: \"Form refract ray\" is not the line that reflection_flipped breaks (expected \"Form "
                     "reflect ray\")"));
  CHECK_THAT(faults_with_bug("run = 'line == \"Put final shade in pixel\"'\npredict.line = \"Form reflect ray\"\n"),
             test::contains("a line is asked for, and no line is at fault"));
  CHECK_THAT(faults_with_bug("predict.line = \"Form reflect ray\"\npredict.arrow = 4\n"),
             test::contains("expected one of arrow"));
}

TEST_CASE("at least five lessons let students find a bug, each of another line or kind") {
  int count = 0;
  for (const std::string& name : lesson_names(root + "/lessons")) {
    const auto lesson = read_lesson(root + "/lessons/" + name);
    REQUIRE(lesson);
    for (const LessonStep& step : lesson->steps) {
      count += step.fault ? 1 : 0;
      CHECK(step.fault.has_value() == (step.question && std::holds_alternative<LineQuestion>(*step.question)));
    }
  }
  CHECK(count >= 5);
}

TEST_CASE("a changed scene keeps its meshes, its images and its sky") {
  const std::string folder = std::string(RAYWALK_SOURCE_DIR) + "/scenes/";
  for (const std::string name : {"gold", "maps", "mesh"}) {
    CAPTURE(name);
    const auto document = read_scene(folder + name + ".toml");
    REQUIRE(document);
    const auto changed = changed_scene(*document, "render.integrator = 'whitted'", {}, "somewhere/else.toml");
    REQUIRE(changed);
    Scene expected = document->scene;
    expected.render.integrator = Integrator::whitted;
    CHECK(changed->scene == expected);
    CHECK(changed->path == document->path);
    CHECK(changed->files == document->files);
    const auto has_pixels = [](const Scene& scene) {
      const auto* sky = scene.sky ? std::get_if<ImageSky>(&scene.sky->kind) : nullptr;
      return sky != nullptr && sky->pixels != nullptr;
    };
    CHECK(has_pixels(changed->scene) == has_pixels(document->scene));
    CHECK(has_pixels(changed->scene) == (name == "gold"));
  }
}
