// Answers to the lessons' questions as theory gives them are right, and the usual mistakes are wrong.

#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "lesson_state.h"
#include "support/catch.h"
#include "view/lesson/typed_number.h"
#include "view/walk/code_panel.h"

using namespace raywalk;

namespace {

/// What a student answers who thinks and does not look: written down by hand from the scenes' files and the laws.
/// A choice counts from 1; an arrow is its angle in degrees, anticlockwise from +x.
struct Theory {
  const char *lesson, *step, *answer;
};
constexpr std::array theory{
    Theory{"01-ray-casting", "first-surface", "2"},
    Theory{"01-ray-casting", "between", "3"},
    Theory{"01-ray-casting", "second-ray", "142.5"},  // from (4.17, 0.53) to the light at (-1, 4.5)
    Theory{"01-ray-casting", "all-rays", "21"},
    Theory{"02-ray-meets-sphere", "which-root", "1"},
    Theory{"02-ray-meets-sphere", "from-inside", "2"},
    Theory{"02-ray-meets-sphere", "tangent", "2"},
    Theory{"02-ray-meets-sphere", "grow", "6.98"},  // 7.38 - 0.4, near enough; 6.97 by the quadratic
    Theory{"03-shadows", "how-many", "2"},
    Theory{"03-shadows", "blocked", "2"},
    Theory{"03-shadows", "facing-away", "3"},
    Theory{"03-shadows", "aim", "-132.3"},  // atan2(-1.1, -1)
    Theory{"03-shadows", "glass", "2"},
    Theory{"03-shadows", "bug", "Form shadow ray"},
    Theory{"04-reflection", "mirror", "144.4"},  // d - 2 (d.n) n at the side from (4.4, 1.3) to (3.75, -0.9)
    Theory{"04-reflection", "meets", "1"},
    Theory{"04-reflection", "share", "9"},  // 0.45 * 0.20
    Theory{"04-reflection", "tree", "4"},
    Theory{"04-reflection", "bug", "Form reflect ray"},
    Theory{"05-refraction", "into-glass", "-22.5"},  // 45.4 degrees to the normal outside, 28.4 inside
    Theory{"05-refraction", "out-of-glass", "3"},
    Theory{"05-refraction", "passes", "1"},
    Theory{"05-refraction", "turned", "2"},
    Theory{"05-refraction", "critical", "24.6"},  // asin(1 / 2.4)
    Theory{"05-refraction", "bug", "Form refract ray"},
    Theory{"06-when-does-it-end", "bounces", "5"},
    Theory{"06-when-does-it-end", "why", "1"},
    Theory{"06-when-does-it-end", "dark", "2"},
    Theory{"06-when-does-it-end", "no-threshold", "1"},  // a quarter cubed of what a dark wall shows, a tenth
    Theory{"06-when-does-it-end", "deeper", "1"},
    Theory{"06-when-does-it-end", "bug", "Shade (DEPTH+1, REFLSHADE)"},
    Theory{"07-shading", "largest", "2"},
    Theory{"07-shading", "cosine", "0.36"},  // 0.65 cos 56
    Theory{"07-shading", "shadow", "2"},
    Theory{"07-shading", "double", "1"},
    Theory{"08-strip-to-picture", "middle-row", "1"},
    Theory{"08-strip-to-picture", "how-many", "145971"},  // 441 * 331
    Theory{"08-strip-to-picture", "below", "2"},
    Theory{"08-strip-to-picture", "floor-shadow", "3"},
    Theory{"09-numbers-lie", "start", "2"},
    Theory{"09-numbers-lie", "touch", "1"},
    Theory{"09-numbers-lie", "near-miss", "2"},
    Theory{"09-numbers-lie", "far", "6.5"},  // 8 - 1.5
    Theory{"09-numbers-lie", "bug", "Form shadow ray"},
    Theory{"10-fewer-tests", "brute", "2465254"},  // 334 * 7381
    Theory{"10-fewer-tests", "bounds", "2"},
    Theory{"10-fewer-tests", "tree", "13"},  // 7381 halved
    Theory{"10-fewer-tests", "inside", "1"},
    Theory{"10-fewer-tests", "same", "1"},
    Theory{"10-fewer-tests", "small", "2"},
    Theory{"11-noise", "many", "9"},
    Theory{"11-noise", "four-times", "2"},
    Theory{"11-noise", "lens", "1"},
    Theory{"11-noise", "all-at-once", "1"},
    Theory{"12-what-accuracy-costs", "one-digit", "16"},
    Theory{"12-what-accuracy-costs", "better-places", "1"},
    Theory{"12-what-accuracy-costs", "threshold", "1"},  // only the dark wedge goes below 5%
    Theory{"12-what-accuracy-costs", "free", "1"},
    Theory{"13-whitted-to-path-tracing", "ambient", "2"},
    Theory{"13-whitted-to-path-tracing", "ceiling", "1"},
    Theory{"13-whitted-to-path-tracing", "paths", "2"},
    Theory{"13-whitted-to-path-tracing", "one-or-two", "2"},  // six: in, out, and once round inside, with their mirrors
    Theory{"13-whitted-to-path-tracing", "price", "2"},       // the root of four
    Theory{"14-radiosity", "dark", "2"},
    Theory{"14-radiosity", "first", "2"},
    Theory{"14-radiosity", "strings", "1"},
    Theory{"14-radiosity", "shadow", "2"},
    Theory{"14-radiosity", "less", "3"},
    Theory{"14-radiosity", "colour", "1"},
    Theory{"14-radiosity", "bug", "Look up light of patches"},
    Theory{"15-photons", "spot", "2"},
    Theory{"15-photons", "glass", "2"},
    Theory{"15-photons", "circle", "59"},  // 60, without the one on the edge
    Theory{"15-photons", "caustic", "1"},
    Theory{"15-photons", "bug", "Add light of photons"},
    Theory{"16-light-inside", "white", "2"},
    Theory{"16-light-inside", "in", "2"},     // 24 free paths through the middle: exp(-24)
    Theory{"16-light-inside", "tenth", "2"},  // Chandrasekhar: 1 - sqrt(0.1) H(1) = 0.415
    Theory{"16-light-inside", "ahead", "3"},
    Theory{"17-skies-and-metals", "metal", "2"},
    Theory{"17-skies-and-metals", "matt", "2"},
    Theory{"17-skies-and-metals", "clouds", "0.78"},  // 7 / 9
    Theory{"17-skies-and-metals", "wall", "0.39"},    // half of it
    Theory{"17-skies-and-metals", "moon", "2"},       // cos + r sin^2, which at the rim is about 1, too
    Theory{"18-rays-with-width", "one-ray", "1"},
    Theory{"18-rays-with-width", "coverage", "0.3"},  // 0.405 - 0.315 of the slopes from 0.15 to 0.45
    Theory{"18-rays-with-width", "mirror", "2"},
    Theory{"18-rays-with-width", "seen", "0.5"},
    Theory{"18-rays-with-width", "bent", "2"},
    Theory{"18-rays-with-width", "left", "0.12"},  // 0.71 times 0.17
    Theory{"18-rays-with-width", "lamp", "0.4"},   // of its width, at the ball
    Theory{"18-rays-with-width", "spread", "1"},
    Theory{"18-rays-with-width", "fold", "2.25"},  // 1 / 4.5 + 1 / 2.25 = 1 / 1.5
};

/// Numbers that students answer who have not understood: none may pass for right.
constexpr std::array usual_mistakes{
    Theory{"01-ray-casting", "all-rays", "37"},               // with the shadow rays
    Theory{"03-shadows", "how-many", "3"},                    // a light each
    Theory{"04-reflection", "share", "65"},                   // added, not multiplied
    Theory{"04-reflection", "tree", "5"},                     // with the stub
    Theory{"05-refraction", "critical", "45"},                // half a right angle
    Theory{"06-when-does-it-end", "bounces", "6"},            // the depth
    Theory{"07-shading", "cosine", "0.54"},                   // the sine
    Theory{"08-strip-to-picture", "how-many", "772"},         // added
    Theory{"09-numbers-lie", "far", "8"},                     // to the centre
    Theory{"10-fewer-tests", "brute", "334"},                 // one a ray
    Theory{"10-fewer-tests", "tree", "1"},                    // what the ray meets
    Theory{"11-noise", "many", "3"},                          // the number in the scene
    Theory{"12-what-accuracy-costs", "one-digit", "4"},       // price for quality
    Theory{"13-whitted-to-path-tracing", "price", "4"},       // one to one
    Theory{"13-whitted-to-path-tracing", "one-or-two", "1"},  // a pair
    Theory{"15-photons", "circle", "60"},                     // with the one on the edge
    Theory{"17-skies-and-metals", "clouds", "0.67"},          // the mean without the cosine
    Theory{"17-skies-and-metals", "wall", "0.78"},            // the whole sky
    Theory{"17-skies-and-metals", "moon", "1"},               // as by Lambert
    Theory{"18-rays-with-width", "coverage", "0.25"},         // a part of four
    Theory{"18-rays-with-width", "left", "0.17"},             // as if nothing were before it
    Theory{"18-rays-with-width", "lamp", "0"},                // as a point would see it
    Theory{"18-rays-with-width", "fold", "1.5"},              // as if EYE were endlessly far away
};

void give_answer(State& state, const char* said) {
  const LessonQuestion& question = *state.lessons.at()->step->question;
  if (std::holds_alternative<ChoiceQuestion>(question)) return update(state, action::GuessChoice{std::atoi(said) - 1});
  if (std::holds_alternative<NumberQuestion>(question)) {
    const auto number = typed_guess(state.lessons, said);
    REQUIRE(number);
    return update(state, action::GuessNumber{*number});
  }
  if (std::holds_alternative<LineQuestion>(question)) {
    for (const CodeBox& box : code_panel(state).boxes)
      for (const CodeRow& row : box.rows)
        if (row.text == said) update(state, action::MarkLine{row.line});
    return;
  }
  const auto origin = arrow_origin(state);
  REQUIRE(origin);
  const double angle = std::strtod(said, nullptr) * 3.14159265358979 / 180;
  update(state, action::GuessWay{*origin + Vec2d(std::cos(angle), std::sin(angle))});
}

/// Answers every one of the list in a sitting, a lesson after the other, and tells each verdict.
template <class Told>
void judge_all(const auto& list, const Told& tell) {
  State state = test::state_with_lessons();
  std::string open;
  for (const Theory& each : list) {
    CAPTURE(each.lesson, each.step, each.answer);
    if (open != each.lesson) update(state, action::OpenLesson{open = each.lesson});
    REQUIRE(state.lessons.at() != nullptr);
    update(state, action::GoToLessonStep{0});
    while (state.lessons.at()->step->id != std::string(each.step)) {
      const int before = state.lessons.step;
      update(state, action::GoToLessonStep{before + 1});
      REQUIRE(state.lessons.step == before + 1);
    }
    give_answer(state, each.answer);
    update(state, action::RevealLesson{});
    const LessonPanel panel = lesson_panel(state);
    CHECK_FALSE(panel.verdict.empty());
    tell(each, panel.is_right);
  }
}

}  // namespace

TEST_CASE("the answer by theory is right, in every step of every lesson") {
  std::set<std::pair<std::string, std::string>> known;
  judge_all(theory, [&](const Theory& each, bool right) {
    CHECK(right);
    known.emplace(each.lesson, each.step);
  });
  for (const std::string& name : lesson_names(RAYWALK_SOURCE_DIR "/lessons")) {
    const auto lesson = read_lesson(RAYWALK_SOURCE_DIR "/lessons/" + name);
    REQUIRE(lesson);
    for (const LessonStep& step : lesson->steps) {
      CAPTURE(name, step.id);
      CHECK(known.contains({name, step.id}) == step.question.has_value());
    }
  }
}

TEST_CASE("the usual mistakes are wrong") {
  judge_all(usual_mistakes, [](const Theory&, bool right) { CHECK_FALSE(right); });
}
