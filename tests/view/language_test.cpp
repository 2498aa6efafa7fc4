// The interface speaks several languages, each of them whole, and changes between them while it runs.

#include "fixtures.h"
#include "lesson_state.h"
#include "timeline/recorder.h"
#include "view/document/question.h"
#include "view/export/lesson_script.h"
#include "view/export/slides.h"
#include "view/lesson/lesson_panel.h"
#include "view/plan/plan_view.h"
#include "view/text/choice_text.h"
#include "view/text/text.h"
#include "view/walk/equation.h"
#include "view/walk/status.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

bool has_decimal(std::string_view text, char mark) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == mark && digit(text[i - 1]) && digit(text[i + 1])) return true;
  return false;
}

}  // namespace

TEST_CASE("every member of a family has its text, and none is there for nobody") {
  std::set<std::string> known;
  const auto ask = [&](const std::string& family, std::string_view name, std::string_view said) {
    std::string id = family + "." + std::string(name);
    std::replace(id.begin(), id.end(), ' ', '_');
    INFO(id);
    known.insert(id);
    REQUIRE(Catalogue::embedded().find(id) != nullptr);
    CHECK(said == *Catalogue::embedded().find(id));
  };
  const Language language;
  for (const RayKind kind : values_of<RayKind>) ask("ray", name_of(kind), text(kind, language));
  for (int i = 0; i < ending_count; ++i)
    ask("ending", name_of(static_cast<Ending>(i)), text(static_cast<Ending>(i), language));
  for (const AcceleratorKind kind : values_of<AcceleratorKind>) ask("accelerator", name_of(kind), text(kind, language));
  for (const Integrator integrator : values_of<Integrator>)
    ask("integrator", name_of(integrator), text(integrator, language));
  for (const Sampler sampler : values_of<Sampler>) ask("sampler", name_of(sampler), text(sampler, language));
  const auto choose = [&](std::string_view name) { ask("choice", name, family_text("choice", name, language)); };
  for (const ShadowKind kind : values_of<ShadowKind>) choose(name_of(kind));
  for (const ShadingNormal normal : values_of<ShadingNormal>) choose(name_of(normal));
  for (const CheckerFilter filter : values_of<CheckerFilter>) choose(name_of(filter));
  for (const MirrorKind kind : values_of<MirrorKind>) choose(name_of(kind));
  for (const TextureFilter filter : values_of<TextureFilter>) choose(name_of(filter));
  for (const ImageWrap wrap : values_of<ImageWrap>) choose(name_of(wrap));
  for (const MapChannel channel : values_of<MapChannel>) choose(name_of(channel));
  [&]<class... Kinds>(const std::variant<Kinds...>* /*all*/) {
    (choose(Kinds::name), ...);
  }(static_cast<const AnySky*>(nullptr));
  for (const Numerics numerics : values_of<Numerics>) ask("numerics", name_of(numerics), text(numerics, language));
  for (const Subsurface subsurface : values_of<Subsurface>)
    ask("subsurface", name_of(subsurface), text(subsurface, language));
  for (int i = 0; i < effect_count; ++i)
    ask("effect", name_of(static_cast<Effect>(i)), text(static_cast<Effect>(i), language));
  for (const Fault fault : values_of<Fault>)
    for (const std::string what : {"symptom", "hint", "wrong", "cure"}) {
      const std::string name = std::string(name_of(fault)) + "." + what;
      ask("fault", name, text("fault." + name, language));
    }
  for (const std::string_view id : Catalogue::embedded().ids()) {
    const std::string family(id.substr(0, id.find('.')));
    INFO(id);
    if (id.starts_with("explanation."))
      CHECK(Catalogue::embedded().find("property." + std::string(id.substr(id.find('.') + 1))) != nullptr);
    if (family == "ray" && id.starts_with("ray.short_")) continue;
    for (const std::string_view own : {"ray", "ending", "accelerator", "integrator", "sampler", "numerics",
                                       "subsurface", "effect", "fault", "choice"})
      if (family == own) CHECK(known.count(std::string(id)) == 1);
  }
}

TEST_CASE("help says the same in every language, in the same order") {
  const auto one = help(in_english);
  for (const Language language : all_languages()) {
    const auto two = help(language);
    REQUIRE(one.size() == two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      REQUIRE(one[i].entries.size() == two[i].entries.size());
      for (std::size_t k = 0; k < one[i].entries.size(); ++k)
        CHECK(one[i].entries[k].term.empty() == two[i].entries[k].term.empty());
    }
  }
}

TEST_CASE("changing the language changes what is said, and nothing else") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{40});
  const Scene scene = state.scene();
  const int position = state.walk.position;
  const std::string english = sentence(state), status = status_line(state);
  update(state, action::SetLanguage{"pt"});
  CHECK(state.appearance.language == in_portuguese);
  CHECK(sentence(state) != english);
  CHECK(status_line(state) != status);
  CHECK(state.scene() == scene);
  CHECK(state.walk.position == position);
  CHECK_FALSE(state.document.dirty);
  CHECK(state.document.undo.empty());
  update(state, action::SetLanguage{"en"});
  CHECK(sentence(state) == english);
  CHECK(status_line(state) == status);
}

TEST_CASE("the equation's numbers are the same in both languages, and written as each writes them") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  bool comma = false;
  for (int position = 1; position <= std::min(state.walk.timeline->steps(), 400); ++position) {
    update(state, action::Jump{position});
    state.appearance.language = in_english;
    const EquationPanel english = equation_panel(state);
    state.appearance.language = in_portuguese;
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

TEST_CASE("a question and a new scene speak the language; a scene names things in English, whatever it is") {
  State state = classic_state();
  update(state, action::SetLanguage{"pt"});
  update(state, action::AddObject{action::ObjectKind::transparent_sphere});
  CHECK(state.scene().objects.back().name == "Transparent Sphere 2");
  CHECK(state.scene().objects.front().name == "Solid Sphere");
  update(state, action::New{});
  REQUIRE(state.document.question);
  const std::string asked = question_panel(state).text;
  update(state, action::SetLanguage{"en"});
  CHECK(question_panel(state).text != asked);
}

TEST_CASE("a page of slides names its language and speaks it") {
  const Scene scene = read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").scene;
  const auto timeline = std::make_shared<const Timeline>(record_cell(scene, 10));
  const std::string page = slides_page(scene, timeline, in_portuguese);
  CHECK_THAT(page, contains("<html lang=\"pt\">"));
  CHECK_THAT(page, contains("raio prim\u00e1rio"));
  CHECK_THAT(page, contains(">VOLTAR</button>"));
  CHECK(page.find("primary ray leaves") == std::string::npos);
}

TEST_CASE("a language that is not there is refused, and the one that is spoken stays") {
  State state = classic_state();
  update(state, action::SetLanguage{"pt"});
  update(state, action::SetLanguage{"xx"});
  CHECK(state.appearance.language == in_portuguese);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK_THAT(state.document.notice->text, contains("xx"));
}

TEST_CASE("a lesson that is not in the language of the interface is told in English, and says so") {
  Languages languages;
  languages.add(Catalogue::parse("[language]\nname = \"Dansk\"\ndecimal_mark = \",\"\nseparator = \"; \"\n"
                                 "[lesson]\nin_english = \"P\u00e5 engelsk, ikke {language}.\"\n",
                                 "da")
                    .value());
  State state = state_with_lessons();
  CHECK(lesson_panel(state).told_in.empty());
  update(state, action::OpenLesson{state.lessons.list[0].name});
  const LessonPanel english = lesson_panel(state);
  CHECK(english.told_in.empty());
  state.appearance.language = languages.find("da").value();
  const LessonPanel danish = lesson_panel(state);
  CHECK(danish.told_in == "P\u00e5 engelsk, ikke Dansk.");
  CHECK(danish.text == english.text);
  CHECK_FALSE(document_title(state).empty());
  const std::string script = lesson_script(state.lessons.open->played, state.appearance.language, ScriptForm::markdown);
  CHECK_THAT(script, contains("ikke Dansk") && contains("# Ray casting"));
  update(state, action::LeaveLesson{});
  CHECK(lesson_panel(state).rows[0].title == "Ray casting");
}
