// The window's own words in both languages, the letters that they need, and how the language is changed.

#include <GLFW/glfw3.h>

#include "../view/language_checks.h"
#include "gui/bench.h"
#include "gui/command_text.h"
#include "gui/folder.h"
#include "gui/key_list.h"
#include "gui/key_text.h"
#include "gui/window_text.h"
#include "lesson/lesson.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The applet's own words, and what the field calls the same in both languages.
const std::set<std::string> same_in_both{"STEP",   "AUTO",  "CLEAR", "Double", "Float",
                                         "double", "float", "3-D",   "Menus",  "Slides"};

std::vector<TextPair> every_text_of_window() {
  std::vector<TextPair> all;
  add_family(all, "WindowText", WindowText::key_other);
  add_family(all, "KeyText", KeyText::name_mouse);
  for (int i = 0; i < command_count; ++i) {
    const auto command = static_cast<Command>(i);
    const CommandText one = english(command), two = portuguese(command);
    all.push_back({"label", std::string(one.label), std::string(two.label)});
    all.push_back({"hint", std::string(one.hint), std::string(two.hint)});
  }
  return all;
}

/// The code points of UTF-8, of up to three bytes each.
std::set<unsigned> letters_of(const std::vector<TextPair>& all) {
  std::set<unsigned> found;
  for (const TextPair& pair : all)
    for (const std::string& text : {pair.english, pair.portuguese})
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
  return found;
}

}  // namespace

TEST_CASE("every text of the window stands in both languages, with the same arguments, and differs") {
  check_languages(every_text_of_window(), same_in_both);
}

TEST_CASE("hints begin with a letter that is made a capital") {
  for (const Language language : all_languages)
    for (int i = 0; i < command_count; ++i) {
      const std::string hint = command_hint(static_cast<Command>(i), language);
      INFO(hint);
      CHECK(std::isalpha(static_cast<unsigned char>(hint.front())) != 0);
    }
}

TEST_CASE("the installed faces have every letter of every text, in both languages") {
  const FontFiles files = find_fonts(font_folders(""));
  if (files.text.empty() || files.code.empty()) RAYWALK_SKIP("Inter or JetBrains Mono is not installed");
  std::vector<TextPair> all = every_text_of_window();
  for (const TextPair& pair : every_text_of_view()) all.push_back(pair);
  for (const Language language : all_languages)
    all.push_back({"name", std::string(language_name(language)), std::string(language_sign(language))});
#if IMGUI_VERSION_NUM < 19200
  ImFontAtlas atlas;
  const Fonts fonts = build_fonts(atlas, files, 1, 1);
  for (const unsigned letter : letters_of(all)) {
    if (letter == '\n') continue;
    CAPTURE(letter);
    for (const ImFont* font : {fonts.text, fonts.small, fonts.strong, fonts.title})
      CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr);
  }
#endif
}

TEST_CASE("Ctrl+L, the button in the bar and the menu entry change the language while the window is open") {
  Bench bench;
  bench.frames(2);
  REQUIRE(bench.state.language == Language::english);
  bench.key(GLFW_KEY_L, true);
  CHECK(bench.state.language == Language::portuguese);
  CHECK(command_label(Command::mode_move, bench.state) == "Mover");
  bench.frames(2);
  bench.click("language");
  CHECK(bench.state.language == Language::english);
  bench.click("menu-view");
  bench.frames(2);
  bench.click("menu/language");
  CHECK(bench.state.language == Language::portuguese);
  CHECK(short_label(Command::language, bench.state) == "EN");
}

TEST_CASE("the keys of the list are the same in both languages but for names that are words") {
  const auto one = key_list(Language::english), two = key_list(Language::portuguese);
  REQUIRE(one.size() == two.size());
  CHECK_THAT(two.front().keys, contains("Espa\u00e7o"));
  for (std::size_t i = 0; i < one.size(); ++i) {
    INFO(one[i].keys << " | " << two[i].keys);
    CHECK(std::count(one[i].keys.begin(), one[i].keys.end(), '+') ==
          std::count(two[i].keys.begin(), two[i].keys.end(), '+'));
    CHECK(one[i].does != two[i].does);
  }
}

TEST_CASE("in both languages, every button stands in the window and its words within it") {
  for (const Language language : all_languages)
    for (const Mode mode : {Mode::move, Mode::trace})
      for (const float scale : {1.0f, 1.5f}) {
        Bench bench;
        bench.unit = scale;
        update(bench.state, action::SetLanguage{language});
        update(bench.state, action::SetMode{mode});
        bench.resize(1280, 720);
        bench.frames(3);
        for (const std::string item : {"mode-move", "mode-trace", "mode-help", "undo", "redo", "language", "step",
                                       "step-back", "play", "clear", "tab-image", "tab-legend"}) {
          const Rect where = bench.rect(item);
          CAPTURE(language_code(language), scale, item, where.x, where.y, where.width, where.height);
          CHECK(where.x >= 0);
          CHECK(where.right() <= 1280);
          CHECK(where.bottom() <= 720);
        }
      }
}

TEST_CASE("where the tabs have no room in one line they stand in two, in both languages") {
  for (const Language language : all_languages) {
    Bench bench;
    CAPTURE(language_code(language));
    update(bench.state, action::SetLanguage{language});
    bench.resize(2600, 900);
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
