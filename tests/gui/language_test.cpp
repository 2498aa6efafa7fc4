// The window's own words in every language, the letters that they need, and how the language is changed.

#include <algorithm>
#include <filesystem>
#include <set>

#include "gui/bench.h"
#include "gui/command.h"
#include "gui/folder.h"
#include "gui/session.h"
#include "lesson/lesson.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The code points of all texts, which are UTF-8 of up to three bytes each.
std::set<unsigned> letters_of_texts() {
  std::set<unsigned> found;
  for (const Language language : all_languages())
    for (const std::string_view id : language.catalogue().ids()) {
      const std::string_view text = raywalk::text(id, language);
      for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t at) {
          return static_cast<unsigned>(static_cast<unsigned char>(text.at(at)));
        };
        const unsigned first = byte(i);
        const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : 3;
        unsigned letter = length == 1 ? first : first & (length == 2 ? 0x1FU : 0x0FU);
        for (std::size_t k = 1; k < length; ++k) letter = letter << 6 | (byte(i + k) & 0x3FU);
        found.insert(letter);
        i += length;
      }
    }
  return found;
}

}  // namespace

TEST_CASE("every command has a word and a hint of its own") {
  for (const Language language : all_languages())
    for (const Command* each : commands()) {
      const std::string name = "command." + std::string(each->name);
      for (const std::string& id : {name + ".label", name + ".hint"}) {
        std::string known = id;
        std::replace(known.begin(), known.end(), '-', '_');
        INFO(known);
        CHECK(language.catalogue().find(known) != nullptr);
      }
    }
  // And no text is there for a command that is not.
  std::set<std::string> names;
  for (const Command* each : commands()) {
    std::string name(each->name);
    std::replace(name.begin(), name.end(), '-', '_');
    names.insert("command." + name);
  }
  for (const std::string_view id : Catalogue::embedded().ids()) {
    if (!id.starts_with("command.")) continue;
    INFO(id);
    CHECK(names.count(std::string(id.substr(0, id.rfind('.')))) == 1);
    const std::string_view which = id.substr(id.rfind('.') + 1);
    CHECK((which == "label" || which == "short" || which == "hint"));
  }
}

TEST_CASE("hints begin with a letter that is made a capital") {
  for (const Language language : all_languages())
    for (const Command* each : commands()) {
      const std::string hint = command_hint(*each, language);
      INFO(hint);
      CHECK(std::isalpha(static_cast<unsigned char>(hint.front())) != 0);
    }
}

TEST_CASE("the installed faces have every letter of every text, in every language") {
  const FontFiles files = find_fonts(font_folders(""));
  if (files.text.empty() || files.code.empty()) RAYWALK_SKIP("Inter or JetBrains Mono is not installed");
#if IMGUI_VERSION_NUM < 19200
  ImFontAtlas atlas;
  const Fonts fonts = build_fonts(atlas, files, 1, 1);
  for (const unsigned letter : letters_of_texts()) {
    if (letter == '\n') continue;
    CAPTURE(letter);
    for (const ImFont* font : {fonts.text, fonts.small, fonts.strong, fonts.title})
      CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr);
  }
#endif
}

TEST_CASE("the menu View holds every language, by the name that its file gives it") {
  Bench bench;
  bench.frames(2);
  for (const Language language : all_languages()) {
    bench.click("menu-view");
    bench.frames(2);
    bench.click("menu/language/" + std::string(language.code()));
    bench.frames(2);
    CHECK(bench.state.appearance.language == language);
  }
}

TEST_CASE("a file of French that is dropped into the folder of texts stands in View, with English for what it lacks") {
  const Folder folder;
  std::filesystem::copy(std::string(RAYWALK_SOURCE_DIR) + "/src/text", folder.path(),
                        std::filesystem::copy_options::recursive);
  const std::string head = "[language]\nname = \"Fran\u00e7ais\"\ndecimal_mark = \",\"\nseparator = \"; \"\n";
  folder.put("fr.toml", head + "[menu]\nedit = \"\u00c9dition\"\n[command.step]\nlabel = \"PAS\"\n");
  const LanguagesRead read = read_languages(folder.path().string());
  REQUIRE(read.broken.empty());
  State state = classic();
  state.appearance.language = read.languages->english();
  Bench bench(std::move(state));
  bench.frames(2);
  bench.click("menu-view");
  bench.frames(2);
  for (const std::string code : {"en", "es", "fr", "pt"}) {
    CAPTURE(code);
    CHECK(bench.has("menu/language/" + code));
  }
  bench.click("menu/language/fr");
  bench.frames(2);
  CHECK(bench.state.appearance.language.name() == "Fran\u00e7ais");
  CHECK(command_label(command("step"), bench.state) == "PAS");
  CHECK(command_label(command("clear"), bench.state) == text("command.clear.label", in_english));
  CHECK(settings_of(bench.state).language == "fr");
}

TEST_CASE("Ctrl+L, the button in the bar and the menu entry change the language while the window is open") {
  Bench bench;
  bench.frames(2);
  REQUIRE(bench.state.appearance.language == in_english);
  const std::size_t count = all_languages().size();
  for (std::size_t i = 0; i < count; ++i) {
    const Language before = bench.state.appearance.language;
    CHECK(command_label(command("language"), bench.state, true) == before.sign());
    bench.key("Ctrl+L");
    CHECK(bench.state.appearance.language == before.next());
    CHECK(command_label(command("mode-move"), bench.state) == text("command.mode_move.label", before.next()));
  }
  CHECK(bench.state.appearance.language == in_english);
  bench.frames(2);
  bench.click("language");
  CHECK(bench.state.appearance.language == in_english.next());
  bench.click("menu-view");
  bench.frames(2);
  bench.click("menu/language");
  CHECK(bench.state.appearance.language == in_english.next().next());
}

TEST_CASE("the keys of the list are the same in every language but for names that are words") {
  const auto one = key_list(in_english), two = key_list(in_portuguese);
  REQUIRE(one.size() == two.size());
  CHECK_THAT(two.front().keys, contains("Espa\u00e7o"));
  for (std::size_t i = 0; i < one.size(); ++i) {
    INFO(one[i].keys << " | " << two[i].keys);
    CHECK(std::count(one[i].keys.begin(), one[i].keys.end(), '+') ==
          std::count(two[i].keys.begin(), two[i].keys.end(), '+'));
    CHECK(one[i].does != two[i].does);
  }
}

TEST_CASE("in every language, every button stands in the window and its words within it") {
  const FontFiles files = find_fonts(font_folders(""));
  for (const Language language : all_languages())
    for (const Mode mode : {Mode::move, Mode::trace})
      for (const float scale : {1.0f, 1.5f}) {
        Bench bench(classic(), 1280, 720, files);
        bench.unit = scale;
        update(bench.state, action::SetLanguage{std::string(language.code())});
        update(bench.state, action::SetMode{mode});
        bench.resize(1280, 720);
        bench.frames(3);
        for (const std::string item : {"mode-move", "mode-trace", "mode-help", "undo", "redo", "language", "step",
                                       "step-back", "play", "clear", "tab-image", "tab-legend"}) {
          const Rect where = bench.rect(item);
          CAPTURE(language.code(), scale, item, where.x, where.y, where.width, where.height);
          CHECK(where.x >= 0);
          CHECK(where.right() <= 1280);
          CHECK(where.bottom() <= 720);
          CHECK(where.y >= 0);
          CHECK_FALSE(bench.has(item + "/clipped"));
        }
      }
}

TEST_CASE("a word that is longer than its button or its place is told of") {
  const Folder folder;
  const std::string head = "[language]\nname = \"Long\"\ndecimal_mark = \",\"\nseparator = \"; \"\n";
  const std::string words = "\"" + std::string(300, 'W') + "\"\n";
  folder.put("en.toml", read_file(RAYWALK_SOURCE_DIR "/src/text/en.toml", 1 << 22).value());
  folder.put("xx.toml", head + "[command.step]\nlabel = " + words + "[property]\nname = " + words);
  const LanguagesRead read = read_languages(folder.path().string());
  REQUIRE(read.broken.empty());
  State state = classic();
  state.appearance.language = read.languages->find("xx").value();
  update(state, action::SetMode{Mode::move});
  update(state, action::Select{{TargetKind::object, 0}});
  Bench bench(std::move(state));
  bench.frames(3);
  const auto told = [&](const std::string& end) {
    const auto& items = bench.interface().items();
    return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.first.ends_with(end); });
  };
  CHECK(told("/label/clipped"));
  update(bench.state, action::SetMode{Mode::trace});
  bench.frames(3);
  CHECK(bench.has("step"));
  CHECK(bench.has("step/clipped"));
  CHECK_FALSE(bench.has("clear/clipped"));
}

TEST_CASE("no word is longer than its button or its place at 1280 x 720, in every language") {
  const FontFiles faces = find_fonts(font_folders(""));
  if (faces.text.empty() || faces.code.empty()) RAYWALK_SKIP("Inter or JetBrains Mono is not installed");
  for (const Language language : all_languages()) {
    Bench bench(classic(), 1280, 720, faces);
    update(bench.state, action::SetLanguage{std::string(language.code())});
    bench.state.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
    bench.state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
    std::set<std::string> clipped;
    const auto look = [&] {
      bench.frames(3);
      for (const auto& [name, where] : bench.interface().items())
        if (name.ends_with("/clipped")) clipped.insert(name);
    };
    for (const Mode mode : {Mode::move, Mode::trace, Mode::help}) {
      update(bench.state, action::SetMode{mode});
      for (const Tab tab : {PictureRoom::tab, TreeRoom::tab, StackRoom::tab, LegendRoom::tab, CostRoom::tab,
                            EquationRoom::tab, MicroscopeRoom::tab, StructureRoom::tab}) {
        if (mode != Mode::trace && tab == StructureRoom::tab) continue;  // which goes to Trace
        update(bench.state, action::SetTab{tab});
        look();
      }
    }
    update(bench.state, action::SetMode{Mode::move});
    for (const Target& target :
         {Target{TargetKind::object, 0}, Target{TargetKind::object, 1}, Target{TargetKind::object, 2},
          Target{TargetKind::light, 0}, Target{TargetKind::eye}}) {
      update(bench.state, action::Select{target});
      look();
    }
    update(bench.state, action::Select{});
    update(bench.state, action::SetMode{Mode::trace});
    update(bench.state, action::AskExport{});
    look();
    REQUIRE(bench.has("browser-accept"));
    update(bench.state, action::CancelPrompt{});
    update(bench.state, action::AddObject{action::ObjectKind::transparent_sphere});
    update(bench.state, action::New{});
    look();
    REQUIRE(bench.has("answer-0"));
    update(bench.state, action::AnswerQuestion{action::Answer::discard});
    update(bench.state, action::ShowBugs{true});
    look();
    update(bench.state, action::HuntBug{1, false});
    look();
    update(bench.state, action::LeaveHunt{});
    update(bench.state, action::ShowBugs{false});
    for (const bool presents : {false, true}) {
      update(bench.state, action::SetLessonOptions{presents, true});
      update(bench.state, action::ShowLessons{true});
      look();
      REQUIRE_FALSE(bench.state.lessons.list.empty());
      update(bench.state, action::OpenLesson{bench.state.lessons.list[0].name});
      look();
      update(bench.state, action::LeaveLesson{});
    }
    std::string all;
    for (const std::string& name : clipped) all += name + "\n";
    INFO(language.code() << ":\n" << all);
    CHECK(clipped.empty());
  }
}

TEST_CASE("where the tabs have no room in one line they stand in two, in every language") {
  for (const Language language : all_languages()) {
    Bench bench;
    CAPTURE(language.code());
    update(bench.state, action::SetLanguage{std::string(language.code())});
    bench.resize(3200, 900);
    bench.frames(3);
    CHECK(bench.rect("tab-image").y == bench.rect("tab-microscope").y);
    bench.resize(900, 700);
    bench.frames(3);
    const Rect pane = bench.rect("tabs"), first = bench.rect("tab-image"), last = bench.rect("tab-microscope");
    CHECK(last.y >= first.bottom() - 1);
    CHECK(last.right() <= pane.right());
    CHECK(bench.rect("exchange").x >= last.right() - 1);
  }
}
