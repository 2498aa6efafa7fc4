#include "gui/session.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gui/bench.h"
#include "gui/folder.h"
#include "gui/loading.h"
#include "gui/report.h"
#include "support/catch.h"
#include "support/languages.h"
#include "support/working_folder.h"
#include "view/document/document.h"

using namespace raywalk;
using namespace raywalk::test;

namespace fs = std::filesystem;

namespace {

GuiOptions options(const Folder& folder) {
  GuiOptions result;
  result.data_dir = RAYWALK_SOURCE_DIR;
  result.state_dir = folder / "state";
  result.languages = shipped_texts().languages;
  result.language = in_english;
  return result;
}

}  // namespace

TEST_CASE("the window starts with the classic scene, at the first step") {
  const Folder folder;
  const auto state = start(options(folder));
  REQUIRE(state.has_value());
  CHECK_THAT(state->document.path, contains("classic.toml"));
  CHECK(state->walk.position == 0);
  CHECK_FALSE(state->document.dirty);
}

TEST_CASE("options choose mode, tab, theme, scale and position") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  wanted.start_mode = "trace";
  wanted.start_tab = "stack";
  wanted.theme = Theme::projector;
  wanted.ui_scale = 1.5;
  wanted.start_position = 12;
  const auto state = start(wanted);
  REQUIRE(state.has_value());
  CHECK(state->walk.mode == Mode::trace);
  CHECK(state->appearance.tab == StackRoom::tab);
  CHECK(state->appearance.theme == Theme::projector);
  CHECK(state->appearance.ui_scale == 1.5);
  CHECK(state->walk.position == 12);
  wanted.start_position = -1;
  const auto at_end = start(wanted);
  REQUIRE(at_end.has_value());
  CHECK(at_end->walk.position == at_end->walk.timeline->steps());
  for (const char* tab : {"microscope", "structure", "cost", "equation"}) {
    wanted.start_tab = tab;
    const auto there = start(wanted);
    REQUIRE(there.has_value());
    CHECK(name_of(there->appearance.tab) == tab);
  }
  wanted.ui_scale = 99;
  CHECK(start(wanted)->appearance.ui_scale == max_ui_scale);
}

TEST_CASE("what no option can be is refused with what it can be") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  wanted.start_mode = "fly";
  const auto state = start(wanted);
  REQUIRE_FALSE(state.has_value());
  CHECK_THAT(state.error().text(), contains("fly"));
  CHECK_THAT(state.error().text(), contains("trace"));
  wanted = options(folder);
  wanted.start_tab = "nothing";
  CHECK_FALSE(start(wanted).has_value());
}

TEST_CASE("a scene that cannot be read is an error that names it") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  wanted.scene_path = folder / "missing.toml";
  auto state = start(wanted);
  REQUIRE_FALSE(state.has_value());
  CHECK_THAT(state.error().text(), contains("missing.toml"));
  folder.put("broken.toml", "[[object]]\nradius = ");
  wanted.scene_path = folder / "broken.toml";
  state = start(wanted);
  REQUIRE_FALSE(state.has_value());
  CHECK(state.error().line == 2);
}

TEST_CASE("settings are kept; broken ones are as good as none") {
  const Folder folder;
  const Settings chosen{
      Theme::projector, 2.25, TreeRoom::tab, "pt", false, true, {TreeRoom::tab, CostRoom::tab}, 0, true};
  write_settings(folder / "state", {}, chosen);
  CHECK(read_settings(folder / "state") == chosen);
  GuiOptions wanted = options(folder);
  CHECK(start(wanted)->appearance.theme == Theme::projector);
  CHECK_FALSE(start(wanted)->walk.tweens);
  CHECK(start(wanted)->appearance.english_code);
  CHECK(start(wanted)->appearance.exchanges());
  CHECK(start(wanted)->lessons.presenter);
  wanted.theme = Theme::dark;
  CHECK(start(wanted)->appearance.theme == Theme::dark);
  for (const std::string text : {"", "{", "[1, 2]", R"({"theme": 7, "ui_scale": "large", "tab": "x"})", "\xff\xfe"}) {
    std::ofstream(folder / "state/settings.json") << text;
    CAPTURE(text);
    CHECK(read_settings(folder / "state") == Settings{});
  }
  std::ofstream(folder / "state/settings.json") << R"({"ui_scale": 1e9})";
  CHECK(read_settings(folder / "state").ui_scale == max_ui_scale);
  CHECK(read_settings("") == Settings{});
  Settings odd;
  odd.link_page = "https://caf\xe9.example/";  // which is no UTF-8
  write_settings(folder / "state", {}, odd);
  CHECK_THAT(read_settings(folder / "state").link_page, contains("https://caf"));
}

TEST_CASE("of two windows each writes the settings that were chosen in it, and leaves those of the other") {
  const Folder folder;
  const Settings before{Theme::dark, 1.5, PictureRoom::tab, "pt", false};
  write_settings(folder / "state", {}, before);
  Settings one = before, other = before;
  one.language = "es";
  one.theme = Theme::projector;
  other.tab = TreeRoom::tab;
  write_settings(folder / "state", before, one);
  write_settings(folder / "state", before, other);
  one.tab = other.tab;
  CHECK(read_settings(folder / "state") == one);
}

TEST_CASE("the language is the option's, else the one that was kept, else the environment's, else English") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  const auto environment = [](const char* all, const char* messages, const char* lang) {
    setenv("LC_ALL", all, 1);
    setenv("LC_MESSAGES", messages, 1);
    setenv("LANG", lang, 1);
  };
  wanted.language.reset();
  environment("", "", "pt_BR.UTF-8");
  CHECK(start(wanted)->appearance.language == in_portuguese);
  environment("", "en_US.UTF-8", "pt_BR.UTF-8");
  CHECK(start(wanted)->appearance.language == in_english);
  environment("pt", "C", "C");
  CHECK(start(wanted)->appearance.language == in_portuguese);
  environment("", "", "");
  CHECK(start(wanted)->appearance.language == in_english);
  environment("de_DE.UTF-8", "pt_PT", "pt_PT");
  CHECK(start(wanted)->appearance.language == in_english);
  write_settings(folder / "state", {}, {Theme::dark, 1, PictureRoom::tab, "pt"});
  CHECK(start(wanted)->appearance.language == in_portuguese);
  wanted.language = in_english;
  CHECK(start(wanted)->appearance.language == in_english);
  // Whose file is gone.
  wanted.language.reset();
  write_settings(folder / "state", {}, {Theme::dark, 1, PictureRoom::tab, "xx"});
  environment("", "", "es_MX.UTF-8");
  CHECK(start(wanted)->appearance.language.code() == "es");
}

TEST_CASE("a file of texts that cannot be read is told in the window, with its line") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  CHECK_FALSE(start(wanted)->document.notice);
  wanted.broken_texts = {Error{"texts/fr.toml", 6, 1, "\"walk.start\" is no text", ""}};
  const auto state = start(wanted);
  REQUIRE(state->document.notice);
  CHECK(state->document.notice->kind == Notice::Kind::error);
  CHECK_THAT(state->document.notice->text, contains("texts/fr.toml:6:"));
}

TEST_CASE("work on a file named from its own folder is recovered into it, and into no other of its name") {
  const Folder folder;
  const std::string shipped = RAYWALK_SOURCE_DIR "/scenes/classic.toml";
  for (const char* name : {"a", "b"}) {
    fs::create_directories(folder / name);
    fs::copy_file(shipped, folder / (std::string(name) + "/my.toml"));
  }
  GuiOptions wanted = options(folder);
  wanted.scene_path = "my.toml";
  Scene lost;
  {
    const WorkingFolder there(folder / "a");
    auto state = start(wanted);
    REQUIRE(state.has_value());
    update(*state, action::AddObject{action::ObjectKind::polygon});
    update(*state, action::Tick{60});
    lost = state->scene();
  }
  const WorkingFolder elsewhere(folder / "b");
  auto state = start(wanted);
  REQUIRE(state.has_value());
  REQUIRE(state->document.question);
  update(*state, action::AnswerQuestion{action::Answer::recover});
  update(*state, action::Save{});
  CHECK(read_scene(folder / "a/my.toml")->scene == lost);
  CHECK(read_scene(folder / "b/my.toml")->scene == read_scene(shipped)->scene);
}

TEST_CASE("a window that begins with a scene whose beams cannot be followed says so, in its language") {
  const Folder folder;
  auto document = read_scene(RAYWALK_SOURCE_DIR "/scenes/beams.toml");
  REQUIRE(document.has_value());
  Object& egg = document->scene.objects[0];
  egg.transform.push_back({Scale{{1, 1.5, 1}}});
  GuiOptions wanted = options(folder);
  wanted.scene_path = folder / "egg.toml";
  wanted.language = in_portuguese;
  REQUIRE(write_scene(*document, wanted.scene_path));
  const auto state = start(wanted);
  REQUIRE(state.has_value());
  REQUIRE(state->document.notice);
  CHECK(state->document.notice->text == fill("notice.no_beams", in_portuguese, {{"object", egg.name}}));
}

TEST_CASE("a picture is taken of the scene alone: no question of an earlier sitting, nothing left behind") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  {
    auto state = start(wanted);
    REQUIRE(state.has_value());
    update(*state, action::AddObject{action::ObjectKind::polygon});
    update(*state, action::Tick{60});
    REQUIRE(fs::exists(folder / "state/autosave.toml"));
    CHECK_FALSE(start(wanted)->document.question.has_value());  // that window still runs
  }
  CHECK(start(wanted)->document.question.has_value());
  wanted.screenshot_path = folder / "picture.png";
  CHECK_FALSE(start(wanted)->document.question.has_value());
}

TEST_CASE("the 3-D image follows the scene, and goes no further than coarse while it is dragged") {
  State state = classic();
  state.document.contents.scene.image = {33, 25};
  LiveImage image;
  CHECK_FALSE(image.rests(state));
  image.follow(state);
  while (image.work(state, 50)) {
  }
  CHECK(image.preview().finished());
  CHECK(image.preview().size() == ImageSize{33, 25});
  CHECK(image.rests(state));
  ++state.document.revision;
  CHECK_FALSE(image.rests(state));
  state.plan.drag = Drag{};
  image.follow(state);
  while (image.work(state, 1)) {
  }
  CHECK(image.preview().has_every_pixel());
  CHECK_FALSE(image.preview().finished());
  state.plan.drag.reset();
  CHECK_FALSE(image.rests(state));
}

TEST_CASE("a picture of another document is not left where that of this one will be; after an edit it is") {
  State state = classic();
  state.document.contents.scene.image = {33, 25};
  LiveImage image;
  CHECK_FALSE(image.follow(state));  // there was none
  while (image.work(state, 50)) {
  }
  const auto picture = image.preview().rgba();
  const auto is_black = [&] {
    const auto& bytes = image.preview().rgba();
    for (std::size_t i = 0; i < bytes.size(); ++i)
      if (bytes[i] != (i % 4 == 3 ? 255 : 0)) return false;
    return true;
  };
  ++state.document.revision;
  CHECK_FALSE(image.follow(state));
  CHECK(image.preview().rgba() == picture);
  SceneDocument next = state.document.contents;
  show_document(state, std::move(next), {});
  CHECK(image.follow(state));
  CHECK(image.preview().size() == ImageSize{33, 25});
  CHECK(is_black());
  CHECK_FALSE(image.follow(state));
  while (image.work(state, 50)) {
  }
  CHECK(image.preview().rgba() == picture);
}

TEST_CASE("the 3-D image is of the world that is walked") {
  State state = classic();
  state.document.contents.scene.image = {33, 25};
  const std::weak_ptr<const World<double>> world = state.document.worlds->of<double>(*pictured_scene(state));
  LiveImage image;
  const long before = world.use_count();
  image.follow(state);
  CHECK(world.use_count() == before + 1);
}

TEST_CASE("only of a large scene the window says that it is being read") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  CHECK_FALSE(takes_long_to_read(wanted));  // the classic scene
  wanted.scene_path = folder.put("small.nff", "v");
  CHECK_FALSE(takes_long_to_read(wanted));
  wanted.scene_path = folder.put("large.nff", std::string(5 << 20, '#'));
  CHECK(takes_long_to_read(wanted));
  wanted.scene_path = folder / "missing.nff";
  CHECK_FALSE(takes_long_to_read(wanted));
}

TEST_CASE("the word about it is in the language of the window") {
  const Folder folder;
  GuiOptions wanted = options(folder);
  Settings settings;
  settings.language = "pt";
  CHECK(language_for(wanted, settings) == in_english);
  wanted.language.reset();
  CHECK(language_for(wanted, settings) == in_portuguese);
}

TEST_CASE("a demo hands its actions out one by one, at a walking pace") {
  Demo demo({action::Step{}, action::Clear{}});
  CHECK(demo.due(0.01) == nullptr);
  const Action* first = demo.due(1);
  REQUIRE(first != nullptr);
  CHECK(first->is<action::Step>());
  CHECK(demo.due(0) == nullptr);
  CHECK_FALSE(demo.over());
  CHECK(demo.due(1)->is<action::Clear>());
  CHECK(demo.over());
  CHECK(demo.due(10) == nullptr);
}

TEST_CASE("the report says what a test needs to aim and to judge") {
  Bench bench;
  bench.frames(2);
  update(bench.state, action::SetMode{Mode::trace});
  update(bench.state, action::Jump{7});
  bench.state.document.path = "caf\xe9.toml";  // names of files need not be UTF-8
  bench.frames(2);
  const Preview preview;
  const auto json = nlohmann::json::parse(
      report(bench.state, bench.interface(), preview, LiveCosts{}, 1, {12, 0.25, 1280, 720, true}), nullptr, false);
  REQUIRE(json.is_object());
  CHECK(json["mode"] == "trace");
  CHECK(json["position"] == 7);
  CHECK(json["steps"] == bench.state.walk.timeline->steps());
  CHECK(json["window"]["frames"] == 12);
  CHECK(json["objects"].size() == bench.state.scene().objects.size());
  const Rect step = bench.rect("step");
  CHECK(json["items"]["step"][0].get<float>() == step.x);
  CHECK(json["items"]["step"][3].get<float>() == step.height);
}
