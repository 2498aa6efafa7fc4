// The interface speaks two languages, each of them whole, and changes between them while it runs.

#include "fixtures.h"
#include "language_checks.h"
#include "timeline/recorder.h"
#include "view/equation.h"
#include "view/panels.h"
#include "view/plan_view.h"
#include "view/slides.h"

#include <memory>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The applet's and the pseudocode's own words, signs, and what the field calls the same in both languages.
const std::set<std::string> same_in_both{"EYE",
                                         "SCREEN",
                                         "STEP",
                                         "AUTO",
                                         "CLEAR",
                                         "Material",
                                         "Normal",
                                         "DEPTH {0}",
                                         "MAIN ALGORITHM",
                                         "PATH TRACING",
                                         "SHADE (DEPTH {0})",
                                         "final",
                                         "REFLSHADE",
                                         "REFRSHADE",
                                         "BVH",
                                         "Octree",
                                         "kd-tree",
                                         "{0} / {1}",
                                         "\u2013",
                                         "?",
                                         "float",
                                         "double",
                                         "t",
                                         "{0} ulp",
                                         "{0} \u00b5s",
                                         "{0} = {1} ulp",
                                         "pixel",
                                         "bvh",
                                         "octree",
                                         "kdtree",
                                         "whitted",
                                         "sobol",
                                         "jittered",
                                         "penumbra",
                                         "antialiasing"};

}  // namespace

TEST_CASE("every text of the panels stands in both languages, with the same arguments, and differs") {
  check_languages(every_text_of_view(), same_in_both);
}

TEST_CASE("help and explanations have the same parts in both languages") {
  const auto one = help(Language::english), two = help(Language::portuguese);
  REQUIRE(one.size() == two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    INFO(one[i].title);
    REQUIRE(one[i].entries.size() == two[i].entries.size());
    for (std::size_t k = 0; k < one[i].entries.size(); ++k)
      CHECK(one[i].entries[k].term.empty() == two[i].entries[k].term.empty());
  }
  const auto english = explanations(Language::english), portuguese = explanations(Language::portuguese);
  REQUIRE(english.size() == portuguese.size());
  for (std::size_t i = 0; i < english.size(); ++i) CHECK(english[i].property == portuguese[i].property);
}

TEST_CASE("changing the language changes what is said, and nothing else") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{40});
  const Scene scene = state.scene();
  const int position = state.position;
  const std::string english = sentence(state), status = status_line(state);
  update(state, action::SetLanguage{Language::portuguese});
  CHECK(state.language == Language::portuguese);
  CHECK(sentence(state) != english);
  CHECK(status_line(state) != status);
  CHECK(state.scene() == scene);
  CHECK(state.position == position);
  CHECK_FALSE(state.dirty);
  CHECK(state.undo.empty());
  update(state, action::SetLanguage{Language::english});
  CHECK(sentence(state) == english);
  CHECK(status_line(state) == status);
}

TEST_CASE("the equation's numbers are the same in both languages, and written as each writes them") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  bool comma = false;
  for (int position = 1; position <= std::min(state.timeline->steps(), 400); ++position) {
    update(state, action::Jump{position});
    state.language = Language::english;
    const EquationPanel english = equation_panel(state);
    state.language = Language::portuguese;
    const EquationPanel portuguese = equation_panel(state);
    REQUIRE(english.rows.size() == portuguese.rows.size());
    for (std::size_t i = 0; i < english.rows.size(); ++i) {
      INFO(english.rows[i].text << " | " << portuguese.rows[i].text);
      REQUIRE(english.rows[i].values == portuguese.rows[i].values);
      REQUIRE_FALSE(has_decimal(portuguese.rows[i].text, '.'));
      REQUIRE_FALSE(has_decimal(english.rows[i].text, ','));
      comma = comma || has_decimal(portuguese.rows[i].text, ',');
    }
  }
  CHECK(comma);
}

TEST_CASE("a question and a new scene speak the language; names in a scene stay as they are") {
  State state = classic_state();
  update(state, action::SetLanguage{Language::portuguese});
  update(state, action::AddObject{action::ObjectKind::transparent_sphere});
  CHECK(state.scene().objects.back().name == "Esfera transparente");
  CHECK(state.scene().objects.front().name == "Solid Sphere");
  update(state, action::New{});
  REQUIRE(state.question);
  const std::string asked = question_panel(state).text;
  update(state, action::SetLanguage{Language::english});
  CHECK(question_panel(state).text != asked);
}

TEST_CASE("a page of slides names its language and speaks it") {
  const Scene scene = read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").scene;
  const auto timeline = std::make_shared<const Timeline>(record_cell(scene, 10));
  const std::string page = slides_page(scene, timeline, Language::portuguese);
  CHECK_THAT(page, contains("<html lang=\"pt\">"));
  CHECK_THAT(page, contains("raio prim\u00e1rio"));
  CHECK_THAT(page, contains(">VOLTAR</button>"));
  CHECK(page.find("primary ray leaves") == std::string::npos);
}

TEST_CASE("codes and names of languages lead back to them") {
  for (const Language language : all_languages) CHECK(language_of(language_code(language)) == language);
  CHECK_FALSE(language_of("de"));
  CHECK_FALSE(language_of(""));
  CHECK(next_language(Language::english) == Language::portuguese);
  CHECK(next_language(Language::portuguese) == Language::english);
}
