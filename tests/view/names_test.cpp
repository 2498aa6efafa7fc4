// What the window calls things: the pseudocode and the names of the shipped scenes in every language, a name that a
// person gave as it was given.

#include "scene/names.h"
#include "fixtures.h"
#include "io/scene_file.h"
#include "view/plan/plan_view.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/code_panel.h"
#include "view/walk/equation.h"
#include "view/walk/status.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

namespace fs = std::filesystem;

std::vector<PseudocodeLine> all_lines() {
  std::vector<PseudocodeLine> lines;
  for (const Pseudocode& each : pseudocodes) lines.insert(lines.end(), each.lines.begin(), each.lines.end());
  return lines;
}

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Light& light : scene.lights) names.push_back(light.name);
  for (const Object& object : scene.objects) names.push_back(object.name);
  for (const Group& group : scene.groups) {
    names.push_back(group.name);
    for (const Object& object : group.objects) names.push_back(object.name);
  }
  return names;
}

bool is_drawn(const State& state, const std::string& name) {
  std::string letters;
  for (const DisplayItem& item : plan_view(state))
    if (const auto* text = std::get_if<TextItem>(&item.shape)) letters += text->text + "\n";
  return letters.find(name + "\n") != std::string::npos;
}

/// The words of a lesson without its formulas.
std::string words_of_lesson(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string words;
  int depth = 0;
  for (const char c : std::string{std::istreambuf_iterator<char>(file), {}}) {
    depth += c == '{' ? 1 : 0;
    if (depth == 0) words += c;
    depth -= c == '}' ? 1 : 0;
  }
  return words;
}

int count_of(const std::string& words, const std::string& what) {
  int count = 0;
  for (std::size_t at = words.find(what); at != std::string::npos; at = words.find(what, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("no two things are called the same in the window, in any language") {
  for (const Language language : all_languages()) {
    INFO(language.code());
    State state = busy_state();
    state.appearance.language = language;
    update(state, action::AddObject{action::ObjectKind::solid_sphere});
    const Target added = state.plan.selected;
    const std::string shown = object_name(state, added.index);
    const std::string before = state.scene().objects[0].name;
    update(state, action::Rename{{TargetKind::object, 0}, shown});
    CHECK(state.scene().objects[0].name == before);
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->text == fill("notice.refused_name_taken", language, {{"name", shown}}));
    update(state, action::Rename{{TargetKind::light, 0}, shown});
    CHECK(light_name(state, 0) != shown);
    // A new thing is not called as another has been meanwhile.
    update(state, action::Rename{{TargetKind::object, 0}, shown + " 2"});
    CHECK(object_name(state, 0) == shown + " 2");
    update(state, action::AddObject{action::ObjectKind::solid_sphere});
    CHECK(object_name(state, state.plan.selected.index) == shown + " 3");
    // Its own name is no other's: a person may call it so in every language.
    update(state, action::Rename{added, shown});
    CHECK(state.scene().objects[static_cast<std::size_t>(added.index)].name == shown);
  }
}

TEST_CASE(
    "every line and heading of the pseudocode has its words in every language, and in English those of the code") {
  for (const PseudocodeLine& line : all_lines()) {
    INFO(line.text);
    CHECK(text(line.line, in_english) == line.text);
    for (const Language language : all_languages()) {
      INFO(language.code());
      const std::string* const said = language.catalogue().find("line." + std::string(line.id));
      REQUIRE(said != nullptr);
      CHECK(text(line.line, language) == *said);
      // A call is of names alone, which stay.
      const bool is_call = line.text.find('(') != std::string_view::npos;
      CHECK((*said == line.text) == (is_call || language == in_english));
    }
  }
  for (const Procedure procedure : values_of<Procedure>) {
    CHECK(text(procedure, in_english) == name_of(procedure));
    for (const Language language : all_languages())
      CHECK(language.catalogue().find("procedure." + std::string(procedure_id(procedure))) != nullptr);
  }
  std::set<std::string_view> ids;
  for (const PseudocodeLine& line : all_lines()) ids.insert(line.id);
  for (const std::string_view id : Catalogue::embedded().ids())
    if (id.starts_with("line.")) CHECK(ids.count(id.substr(id.find('.') + 1)) == 1);
}

TEST_CASE("the panel of code speaks the language of the window, and English on request") {
  State state = classic_state();
  update(state, action::SetLanguage{"pt"});
  update(state, action::Jump{2});
  CHECK(code_panel(state).boxes[0].title == "ALGORITMO PRINCIPAL");
  CHECK(code_panel(state).boxes[0].rows[1].text == "Formar raio prim\u00e1rio");
  CHECK(equation_panel(state).title == "Formar raio prim\u00e1rio");
  update(state, action::SetEnglishCode{true});
  CHECK(code_panel(state).boxes[0].title == "MAIN ALGORITHM");
  CHECK(code_panel(state).boxes[0].rows[1].text == "Form primary ray");
  CHECK(equation_panel(state).title == "Form primary ray");
  CHECK(state.appearance.language == in_portuguese);
}

TEST_CASE("lessons name the lines of the code as their language shows them") {
  int mentions = 0;
  for (const auto& entry : fs::directory_iterator(RAYWALK_SOURCE_DIR "/lessons")) {
    if (!fs::exists(entry.path() / "en.md")) continue;
    const std::string english = words_of_lesson(entry.path() / "en.md");
    for (const Language language : all_languages()) {
      if (language == in_english) continue;
      const std::string words = words_of_lesson(entry.path() / (std::string(language.code()) + ".md"));
      std::set<std::string> own, foreign;
      for (const PseudocodeLine& line : all_lines()) {
        foreign.insert('"' + std::string(line.text) + '"');
        own.insert('"' + std::string(text(line.line, language)) + '"');
      }
      int named = 0, expected = 0;
      for (const std::string& line : own) named += count_of(words, line);
      for (const std::string& line : foreign) {
        expected += count_of(english, line);
        INFO(entry.path().filename() << ", " << language.code() << ": " << line);
        if (own.count(line) == 0) CHECK(count_of(words, line) == 0);
      }
      INFO(entry.path().filename() << ", " << language.code());
      CHECK(named == expected);
      mentions += expected;
    }
  }
  CHECK(mentions > 20);
}

TEST_CASE("the names of the shipped scenes have their words in every language, and no word is there for nobody") {
  std::set<std::string> wanted{"Solid Sphere", "Transparent Sphere", "Polygon", "Light Source", "Floor"};
  std::vector<std::string> paths = shipped_scenes();
  for (const auto& entry : fs::directory_iterator(RAYWALK_SOURCE_DIR "/scenes/hard"))
    paths.push_back(entry.path().string());
  for (const std::string& path : paths) {
    const Scene scene = read_document(path).scene;
    const std::vector<std::string> names = names_of(scene);
    INFO(path);
    for (const std::string& name : scene.translated) {
      INFO(name);
      CHECK(std::find(names.begin(), names.end(), name) != names.end());
      CHECK(shown_name(scene, name, in_english) == name);
      const std::string word = name.substr(0, name.find_last_not_of("0123456789. ") + 1);
      const std::string id = Catalogue::embedded().find("name." + name) != nullptr ? name : word;
      for (const Language language : all_languages()) CHECK(language.catalogue().find("name." + id) != nullptr);
      wanted.insert(id);
    }
    // Names that are no words are letters, or those of the parts of a group.
    for (const Object& object : scene.objects)
      if (object.name.size() > 1)
        CHECK(std::find(scene.translated.begin(), scene.translated.end(), object.name) != scene.translated.end());
  }
  for (const std::string_view id : Catalogue::embedded().ids()) {
    INFO(id);
    if (id.starts_with("name.")) CHECK(wanted.count(std::string(id.substr(id.find('.') + 1))) == 1);
  }
}

TEST_CASE("plan, sentences and handles name the shipped things in the language that is chosen") {
  State state = classic_state();
  CHECK(is_drawn(state, "Solid Sphere"));
  update(state, action::SetLanguage{"pt"});
  CHECK(is_drawn(state, "Esfera s\u00f3lida"));
  CHECK(is_drawn(state, "OLHO"));
  CHECK(is_drawn(state, "TELA"));
  CHECK_FALSE(is_drawn(state, "Solid Sphere"));
  CHECK(target_text(state, {TargetKind::object, 0}).find(object_name(state, 0)) == 0);
  std::string said;
  for (int position = 0; position < state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    said += sentence(state) + "\n";
  }
  CHECK_THAT(said, contains("Esfera s\u00f3lida") && !contains("Solid Sphere") && !contains("Polygon"));
}

TEST_CASE("what is added is shown in every language, and what a person names is called so in all of them") {
  State state = classic_state();
  update(state, action::SetLanguage{"pt"});
  update(state, action::AddObject{action::ObjectKind::polygon});
  const int added = static_cast<int>(state.scene().objects.size()) - 1;
  CHECK(object_name(state, added) == "Pol\u00edgono 2");
  update(state, action::SetLanguage{"en"});
  CHECK(object_name(state, added) == "Polygon 2");
  // Also a name that is a word in the files of texts, and one that another thing had.
  update(state, action::Rename{{TargetKind::object, added}, "Ball"});
  update(state, action::SetLanguage{"pt"});
  CHECK(object_name(state, added) == "Ball");
  update(state, action::Rename{{TargetKind::object, 0}, "Meu espelho"});
  update(state, action::Rename{{TargetKind::object, added}, "Solid Sphere"});
  CHECK(object_name(state, 0) == "Meu espelho");
  CHECK(object_name(state, added) == "Solid Sphere");
  update(state, action::Undo{});
  CHECK(object_name(state, added) == "Ball");
}

TEST_CASE("which names are translated is kept in the scene's file") {
  State state = classic_state();
  update(state, action::Rename{{TargetKind::object, 0}, "Ball"});
  const auto written = format_scene(state.scene(), state.document.contents.text);
  REQUIRE(written.has_value());
  const auto read = parse_scene(*written, "written.toml");
  REQUIRE(read.has_value());
  CHECK(read->scene == state.scene());
  CHECK(shown_name(read->scene, "Ball", in_portuguese) == "Ball");
  CHECK(shown_name(read->scene, "Polygon", in_portuguese) == "Pol\u00edgono");
  CHECK(shown_name(read->scene, "Solid Sphere", in_portuguese) == "Solid Sphere");
  CHECK_FALSE(parse_scene("translated = [1]\n" + *written, "w.toml").has_value());
}
