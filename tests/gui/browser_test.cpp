#include "gui/browser.h"
#include "view/document/document.h"
#include "view/export/export.h"

#include <algorithm>
#include <filesystem>

#include "gui/bench.h"
#include "gui/folder.h"
#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A folder with two scenes, a folder with one more, and things that are no scene.
class Scenes : public Folder {
 public:
  Scenes() {
    for (const char* name : {"b.toml", "a.toml", "inner/c.toml", ".hidden/d.toml", ".secret.toml", "picture.png"})
      put(name, "");
  }
};

// A state whose scene stands in `folder`, with the dialog open.
State asking(const std::string& file, const Action& question) {
  State state = classic();
  state.document.path = file;
  update(state, question);
  return state;
}

}  // namespace

TEST_CASE(
    "every shipped scene and lesson is in the gallery, with a title and a sentence in every language and a picture") {
  const std::string root = RAYWALK_SOURCE_DIR;
  for (const Language language : all_languages()) {
    State state = classic();
    state.appearance.language = language;
    state.lessons.folder = root + "/lessons";
    state.lessons.scenes_folder = root + "/scenes";
    update(state, action::ListLessons{});
    const std::vector<GalleryCard> scenes = scene_cards(state), lessons = lesson_cards(state);
    CHECK(scenes.size() == list_folder(root + "/scenes").files.size() + 1 - 1);  // a new scene; ball.ply is no scene
    CHECK(scenes.at(1).name == "scene/classic");
    CHECK(lessons.size() == state.lessons.list.size());
    CHECK(lessons.size() >= 18);
    for (const std::vector<GalleryCard>* cards : {&scenes, &lessons}) {
      for (const GalleryCard& card : *cards) {
        CAPTURE(language.code(), card.name);
        CHECK(card.sentence.size() > 20);
        if (card.path.empty() && card.lesson.empty()) continue;
        CHECK(std::filesystem::exists(card.picture));
        if (!card.lesson.empty()) continue;
        const std::string scene = std::filesystem::path(card.path).stem().string();
        const std::string* title = language.catalogue().find("gallery." + scene + ".title");
        REQUIRE(title != nullptr);
        CHECK(card.title == *title);
      }
    }
  }
}

TEST_CASE("scenes stand in the gallery by their titles, in the window's language") {
  const std::string root = RAYWALK_SOURCE_DIR;
  const auto place = [&](const Language language, const std::string& scene) {
    State state = classic();
    state.appearance.language = language;
    state.lessons.scenes_folder = root + "/scenes";
    const std::vector<GalleryCard> cards = scene_cards(state);
    const auto at = std::find_if(cards.begin(), cards.end(),
                                 [&](const GalleryCard& card) { return card.name == "scene/" + scene; });
    REQUIRE(at != cards.end());
    return at - cards.begin();
  };
  CHECK(place(in_english, "radiosity") < place(in_english, "appel"));                 // Ray casting
  CHECK(place(in_portuguese, "motion_blur") + 1 == place(in_portuguese, "caustic"));  // Borrão, Cáustica
  CHECK(place(in_portuguese, "caustic") + 1 == place(in_portuguese, "cones"));
}

TEST_CASE("New and Open begin with the gallery") {
  const std::string root = RAYWALK_SOURCE_DIR;
  const auto begin = [&](const Action& ask) {
    State state = classic();
    state.lessons.folder = root + "/lessons";
    state.lessons.scenes_folder = root + "/scenes";
    update(state, ask);
    return state;
  };
  {
    Bench bench(begin(action::AskNew{}));
    bench.frames(4);
    bench.click("scene-new");
    CHECK(bench.last<action::New>() != nullptr);
    CHECK(bench.state.document.prompt == PathPrompt::none);
    CHECK(bench.state.scene().objects.size() == 2);
    bench.forget();
    bench.key("Ctrl+N");
    bench.frames(3);
    REQUIRE(bench.state.document.prompt == PathPrompt::start);
    bench.key("Enter");
    CHECK(bench.last<action::New>() != nullptr);
  }
  Bench bench(begin(action::AskOpen{}));
  bench.frames(4);
  bench.click("scene/antialiasing");
  CHECK(bench.state.document.path == root + "/scenes/antialiasing.toml");
  CHECK(bench.state.document.prompt == PathPrompt::none);
  update(bench.state, action::AskOpen{});
  bench.frames(3);
  bench.click("gallery-recent");
  bench.obedient = false;
  bench.click("recent/0");
  REQUIRE(bench.last<action::Open>() != nullptr);
  CHECK(bench.last<action::Open>()->path == root + "/scenes/antialiasing.toml");
  bench.obedient = true;
  bench.click("gallery-lessons");
  bench.frames(3);
  bench.click("lesson-card/01-ray-casting");
  CHECK(bench.state.document.prompt == PathPrompt::none);
  REQUIRE(bench.state.lessons.open);
  CHECK(bench.state.lessons.open->lesson.name == "01-ray-casting");
}

TEST_CASE("a folder's listing has its folders and scenes, sorted, and nothing hidden") {
  const Scenes scenes;
  const FolderListing listing = list_folder(scenes / "");
  CHECK(listing.readable);
  CHECK(listing.folders == std::vector<std::string>{"inner"});
  CHECK(listing.files == std::vector<std::string>{"a.toml", "b.toml"});
  CHECK_FALSE(list_folder(scenes / "no such folder").readable);
  CHECK_FALSE(list_folder(scenes / "a.toml").readable);
}

TEST_CASE("a scene is opened by clicks, through folders") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(3);
  bench.click("gallery-files");
  CHECK(bench.has("browser/b.toml"));
  CHECK_FALSE(bench.has("browser/picture.png"));
  bench.click("browser/inner/");
  CHECK(bench.has("browser/c.toml"));
  bench.click("browser-up");
  bench.obedient = false;
  bench.click("browser/b.toml");
  bench.click("browser-accept");
  REQUIRE(bench.last<action::Open>() != nullptr);
  CHECK(bench.last<action::Open>()->path == scenes / "b.toml");
}

TEST_CASE("a double click opens at once") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(3);
  bench.click("gallery-files");
  bench.obedient = false;
  bench.double_click("browser/b.toml");
  REQUIRE(bench.last<action::Open>() != nullptr);
  CHECK(bench.last<action::Open>()->path == scenes / "b.toml");
}

TEST_CASE("a path is typed, and Enter takes it") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(4);
  bench.obedient = false;
  bench.type(scenes / "inner/c.toml");
  bench.enter();
  REQUIRE(bench.last<action::Open>() != nullptr);
  CHECK(bench.last<action::Open>()->path == scenes / "inner/c.toml");
}

TEST_CASE("a shipped scene is opened by its name, unless a file of this folder has it") {
  const Scenes scenes;
  Folder shipped;
  shipped.put("sphereflake.toml", "");
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.state.lessons.scenes_folder = shipped.path();
  bench.frames(4);
  bench.obedient = false;
  bench.type("sphereflake");
  bench.enter();
  REQUIRE(bench.last<action::Open>() != nullptr);
  CHECK(bench.last<action::Open>()->path == shipped / "sphereflake.toml");
  bench.type("b.toml");
  bench.enter();
  CHECK(bench.last<action::Open>()->path == scenes / "b.toml");
  bench.type("nowhere");
  bench.enter();
  CHECK(bench.last<action::Open>()->path == scenes / "nowhere");
}

TEST_CASE("a path may be pasted as shells, file managers and addresses write it") {
  const Scenes scenes;
  scenes.put("two words.toml", "");
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(4);
  bench.obedient = false;
  const auto opened = [&](const std::string& typed) {
    bench.forget();
    bench.type(typed);
    bench.enter();
    REQUIRE(bench.last<action::Open>() != nullptr);
    return bench.last<action::Open>()->path;
  };
  CHECK(opened("  " + scenes / "inner/c.toml" + " ") == scenes / "inner/c.toml");
  CHECK(opened("'" + scenes / "two words.toml" + "'") == scenes / "two words.toml");
  CHECK(opened("file://" + scenes.path().string() + "/two%20words.toml") == scenes / "two words.toml");
  CHECK(opened("\"b.toml\"") == scenes / "b.toml");
  scenes.put("'b.toml'", "");  // a file that is really called so
  CHECK(opened("'b.toml'") == scenes / "'b.toml'");
}

TEST_CASE("what is saved goes where the path leads that was pasted in quotes") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskSaveAs{}));
  bench.frames(4);
  bench.obedient = false;
  bench.type(" '" + scenes / "inner/new.toml" + "' ");
  bench.enter();
  REQUIRE(bench.last<action::SaveAs>() != nullptr);
  CHECK(bench.last<action::SaveAs>()->path == scenes / "inner/new.toml");
}

TEST_CASE("a link is opened by the field for a path, and one that is none keeps the dialog and says why") {
  State state = classic();
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  update(state, action::AskOpen{});
  Bench bench(std::move(state));
  bench.frames(4);
  bench.type("raywalk:#v=9999/scene=glass");
  bench.enter();
  bench.frames(3);
  CHECK(bench.state.document.prompt == PathPrompt::open);
  REQUIRE(bench.state.document.notice);
  CHECK(bench.state.document.notice->text.find("later version") != std::string::npos);
  bench.type("https://an.example/of/links.html");
  bench.enter();
  bench.frames(3);
  CHECK(bench.state.document.prompt == PathPrompt::open);
  REQUIRE(bench.last<action::OpenLink>() != nullptr);
  CHECK(bench.last<action::OpenLink>()->link == "https://an.example/of/links.html");
  bench.type(" raywalk:#v=1/scene=glass/step=5 ");
  bench.enter();
  bench.frames(3);
  CHECK(bench.state.document.prompt == PathPrompt::none);
  CHECK(bench.state.scene() == read_scene(shipped_path(bench.state, "glass"))->scene);
  CHECK(bench.state.walk.position == 5);
}

TEST_CASE("the longest link fits into the field for a path") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(4);
  bench.obedient = false;
  const std::string link = "https://a.example/#v=1/scene=glass/changes=" + std::string(7900, 'x');
  bench.type(link);
  bench.enter();
  REQUIRE(bench.last<action::OpenLink>() != nullptr);
  CHECK(bench.last<action::OpenLink>()->link == link);
}

TEST_CASE("saving begins with the file's own name and folder") {
  const Scenes scenes;
  Bench bench(asking(scenes / "b.toml", action::AskSaveAs{}));
  bench.frames(3);
  bench.obedient = false;
  bench.click("browser-accept");
  REQUIRE(bench.last<action::SaveAs>() != nullptr);
  CHECK(bench.last<action::SaveAs>()->path == scenes / "b.toml");
}

TEST_CASE("a broken file's message never pushes the buttons out, and the name keeps the keyboard") {
  const Scenes scenes;
  scenes.put("broken.toml", "[[object]]\nshape = \"spear\"\n");
  for (const float height : {480.0f, 720.0f}) {
    Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
    bench.resize(1024, height);
    bench.frames(4);
    bench.type(scenes / "broken.toml");
    bench.enter();
    bench.frames(3);
    REQUIRE(bench.state.document.notice);
    bench.state.document.notice->text += std::string(2000, 'x') + std::string(400, '\n');
    bench.frames(3);
    CHECK(bench.has("browser-complaint"));
    for (const char* button : {"browser-cancel", "browser-accept", "browser-path"})
      CHECK(bench.rect(button).bottom() <= (height + std::min(height, 620.0f)) / 2 - 5);
    CHECK(bench.rect("browser-complaint").bottom() <= bench.rect("browser-path").y);
    // The next name is typed over it.
    bench.obedient = false;
    bench.forget();
    bench.type(scenes / "inner/c.toml");
    bench.enter();
    REQUIRE(bench.last<action::Open>() != nullptr);
    CHECK(bench.last<action::Open>()->path == scenes / "inner/c.toml");
  }
}

TEST_CASE("an export goes where the last one went") {
  const Scenes scenes;
  Bench bench(asking(scenes / "b.toml", action::AskExport{}));
  bench.frames(4);
  bench.type(scenes / "inner/walk.txt");
  bench.enter();
  bench.frames(3);
  REQUIRE(bench.state.document.prompt == PathPrompt::none);
  update(bench.state, action::AskExport{});
  bench.frames(4);
  bench.obedient = false;
  bench.click("browser-accept");
  REQUIRE(bench.last<action::Export>() != nullptr);
  CHECK(bench.last<action::Export>()->path == scenes / "inner/b.html");
}

TEST_CASE("what an export is stands in the window of a telephone, in every language") {
  const Scenes scenes;
  for (const Language language : all_languages()) {
    Bench bench(asking(scenes / "b.toml", action::AskExport{}), 360, 640);
    bench.unit = bench.dpi = shrink_to_fit(360, 640, 1);
    bench.state.appearance.language = language;
    bench.frames(4);
    CHECK(bench.rect("export-hint").right() <= 360);
    CHECK(bench.rect("browser-accept").bottom() <= 640);
  }
}

TEST_CASE("an export's kinds can be seen, and give the name its ending") {
  const Scenes scenes;
  Bench bench(asking(scenes / "b.toml", action::AskExport{}));
  bench.frames(3);
  CHECK_FALSE(bench.has("export.script.html"));
  for (const ExportEnding& each : kinds_of_export) {
    if (each.kind == ExportKind::script) continue;  // of lessons alone
    CAPTURE(each.ending);
    update(bench.state, action::CancelPrompt{});
    bench.frames(2);
    update(bench.state, action::AskExport{});
    bench.frames(3);
    bench.obedient = true;
    bench.click("export" + std::string(each.ending));
    bench.obedient = false;
    bench.click("browser-accept");
    REQUIRE(bench.last<action::Export>() != nullptr);
    CHECK(bench.last<action::Export>()->path == scenes / ("b" + std::string(each.ending)));
  }
}

TEST_CASE("a kind of export that was asked for stays, whatever is typed, and the name follows in sight") {
  const Scenes scenes;
  const std::string root = RAYWALK_SOURCE_DIR;
  for (const Language language : all_languages()) {
    State state = classic();
    state.appearance.language = language;
    state.lessons.folder = root + "/lessons";
    state.lessons.scenes_folder = root + "/scenes";
    update(state, action::SetLessonOptions{true, false});
    update(state, action::OpenLesson{"05-refraction"});
    REQUIRE(state.lessons.open);
    Bench bench(std::move(state));
    for (const ExportEnding& asked : kinds_of_export) {
      for (const ExportEnding& typed : kinds_of_export) {
        CAPTURE(asked.ending, typed.ending);
        bench.obedient = true;
        update(bench.state, action::CancelPrompt{});
        bench.frames(2);
        update(bench.state, action::AskExport{});
        bench.frames(4);
        // The script is what a presenter's dialog begins with, as its button asks.
        if (asked.kind != ExportKind::script) {
          bench.click("export" + std::string(asked.ending));
          bench.click("browser-path");
        }
        bench.type(scenes / ("walk" + std::string(typed.ending)));
        CHECK(bench.has("export-as") == (asked.kind != typed.kind));
        bench.obedient = false;
        bench.enter();
        REQUIRE(bench.last<action::Export>() != nullptr);
        CHECK(bench.last<action::Export>()->path == scenes / ("walk" + std::string(asked.ending)));
      }
    }
  }
}

TEST_CASE("until a kind is asked for the name's ending says what") {
  const Scenes scenes;
  Bench bench(asking(scenes / "b.toml", action::AskExport{}));
  bench.frames(4);
  bench.type("walk.svg");
  bench.frames();
  CHECK_FALSE(bench.has("export-as"));
  bench.obedient = false;
  bench.enter();
  REQUIRE(bench.last<action::Export>() != nullptr);
  CHECK(bench.last<action::Export>()->path == scenes / "walk.svg");
  bench.click("export.gif");
  bench.click("browser-path");
  bench.type("walk.png");
  bench.frames();
  CHECK(bench.has("export-as"));
  bench.click("browser-accept");
  CHECK(bench.last<action::Export>()->path == scenes / "walk.gif");
}

TEST_CASE("a name that is there once its ending is right is written over only when that is said") {
  const Scenes scenes;
  scenes.put("walk.txt", "mine");
  Bench bench(asking(scenes / "b.toml", action::AskExport{}));
  bench.frames(4);
  bench.click("export.txt");
  bench.click("browser-path");
  bench.type("walk.html");
  bench.enter();
  REQUIRE(bench.state.document.question);
  CHECK(bench.state.document.question->path == scenes / "walk.txt");
  update(bench.state, action::AnswerQuestion{action::Answer::cancel});
  bench.frames(4);
  bench.click("browser-accept");  // the dialog shows the name that it asked about
  CHECK(bench.state.document.question);
}

TEST_CASE("the dialog is taken back by its button and by Escape, also while a path is typed") {
  const Scenes scenes;
  Bench bench(asking(scenes / "a.toml", action::AskOpen{}));
  bench.frames(3);
  bench.click("browser-cancel");
  CHECK(bench.state.document.prompt == PathPrompt::none);
  update(bench.state, action::AskOpen{});
  bench.frames(4);
  bench.type("half a na");
  bench.key("Escape");
  CHECK(bench.state.document.prompt == PathPrompt::none);
  bench.click("mode-help");
  CHECK(bench.state.walk.mode == Mode::help);
}
