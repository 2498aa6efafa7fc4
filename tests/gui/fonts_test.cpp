#include "gui/fallback_fonts.h"

#include <imgui.h>
#include <filesystem>
#include <fstream>

#include "gui/folder.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace fs = std::filesystem;

namespace {

void check_complete(const Fonts& fonts) {
  for (const ImFont* font : {fonts.text, fonts.strong, fonts.small, fonts.title, fonts.code, fonts.code_strong})
    CHECK(font != nullptr);
}

}  // namespace

TEST_CASE("fonts are found in subfolders, earlier folders first, better names before others") {
  const Folder folder;
  const std::string own = folder.put("own/Inter.ttf", "no font");
  const std::string regular = folder.put("system/deep/er/Inter-Regular.otf", "no font");
  const std::string mono = folder.put("system/JetBrainsMono-Regular.ttf", "no font");
  folder.put("system/Inter-Regular.txt", "no font");
  const FontFiles both = find_fonts({folder / "own", folder / "missing", folder / "system"});
  CHECK(both.text == own);
  CHECK(both.code == mono);
  CHECK(both.strong == "");
  CHECK(find_fonts({folder / "system"}).text == regular);
  folder.put("system/Inter.ttf", "no font");
  CHECK(find_fonts({folder / "system"}).text == regular);
  CHECK(find_fonts({}) == FontFiles{});
}

TEST_CASE("without fonts, and with files that are none, ImGui's own face stands in") {
  const Folder folder;
  ImFontAtlas atlas;
  check_complete(build_fonts(atlas, {}, 1, 1));
  ImFontAtlas other;
  const std::string empty = folder.put("Inter-Regular.otf", "");
  check_complete(build_fonts(other, {empty, folder / "gone.ttf", "", ""}, 2, 1));
}

TEST_CASE("faces grow with the scale, and their height in units does not depend on the density") {
  ImFontAtlas small, large, dense;
  const Fonts one = build_fonts(small, {}, 1, 1), three = build_fonts(large, {}, 3, 1),
              two = build_fonts(dense, {}, 1, 2);
  CHECK(line_height(three, *three.text) == Approx(3 * line_height(one, *one.text)).margin(1));
  CHECK(line_height(two, *two.text) == Approx(line_height(one, *one.text)).margin(0.5));
  CHECK(line_height(one, *one.title) > line_height(one, *one.text));
}

TEST_CASE("the installed faces have every character that the texts use") {
  const FontFiles files = find_fonts(font_folders(""));
  if (files.text.empty() || files.code.empty()) RAYWALK_SKIP("Inter or JetBrains Mono is not installed");
#if IMGUI_VERSION_NUM < 19200
  ImFontAtlas atlas;
  const Fonts fonts = build_fonts(atlas, files, 1, 1);
  for (const ImWchar character : {u'A', u'\u00e9', u'\u00e7', u'\u00b0', u'\u00b7', u'\u2190', u'\u2191', u'\u2192',
                                  u'\u2193', u'\u2013', u'\u2212', u'\u00d7'}) {
    CAPTURE(static_cast<int>(character));
    CHECK(fonts.text->FindGlyphNoFallback(character) != nullptr);
    CHECK(fonts.small->FindGlyphNoFallback(character) != nullptr);
  }
#endif
}

TEST_CASE("a language that is written in another alphabet brings its letters along") {
  const FontFiles files = find_fonts(font_folders(""));
  if (files.text.empty()) RAYWALK_SKIP("Inter is not installed");
#if IMGUI_VERSION_NUM < 19200
  constexpr ImWchar zhe = 0x0416, lambda = 0x039B, iota_with_dialytika = 0x03CA;
  ImFontAtlas latin, cyrillic;
  CHECK(build_fonts(latin, files, 1, 1).text->FindGlyphNoFallback(zhe) == nullptr);
  Languages languages;
  languages.add(Catalogue::parse("[language]\nname = \"\u0420\u0443\u0441\u0441\u043a\u0438\u0439\"\n"
                                 "decimal_mark = \",\"\nseparator = \"; \"\n",
                                 "ru")
                    .value());
  const Fonts fonts = build_fonts(cyrillic, files, 1, 1, languages);
  for (const ImFont* font : {fonts.text, fonts.strong, fonts.small, fonts.title}) {
    CHECK(font->FindGlyphNoFallback(zhe) != nullptr);
    CHECK(font->FindGlyphNoFallback(lambda) != nullptr);
    CHECK(font->FindGlyphNoFallback(iota_with_dialytika) == nullptr);  // nothing there is Greek
  }
#endif
}

namespace {

// A language called so, with one more text.
void add_language(Languages& languages, const std::string& code, const std::string& name) {
  languages.add(
      Catalogue::parse("[language]\nname = \"" + name + "\"\ndecimal_mark = \",\"\nseparator = \"; \"\n", code)
          .value());
}

constexpr char16_t an = 0x10D0, hae = 0x10F0;  // the first and the last letter of Georgian
const std::string georgian = "\u10e5\u10d0\u10e0\u10d7\u10e3\u10da\u10d8";

}  // namespace

TEST_CASE("letters beyond Inter's alphabets are found in the texts and the lessons of a language") {
  Languages languages;
  CHECK(letters_beyond(languages, "").empty());
  add_language(languages, "ru", "\u0420\u0443\u0441\u0441\u043a\u0438\u0439");
  CHECK(letters_beyond(languages, "").empty());  // Inter has Cyrillic
  // Of an alphabet all letters, of ideographs those that are there: also in lessons.
  const Folder folder;
  folder.put("01-one/zh.md", "# \u5149\u7ebf");
  folder.put("01-one/fr.md", "# \u6f22");
  add_language(languages, "ka", georgian);
  add_language(languages, "zh", "\u4e2d\u6587");
  const std::u16string letters = letters_beyond(languages, folder / "");
  const auto has = [&](char16_t letter) { return letters.find(letter) != std::u16string::npos; };
  CHECK((has(an) && has(hae)));
  CHECK((has(u'\u4e2d') && has(u'\u5149') && has(u'\u7ebf')));
  CHECK_FALSE(has(u'\u6f22'));
  CHECK_FALSE(has(u'\u0416'));
  CHECK(letters.size() < 0x80 + 10);
  CHECK(std::is_sorted(letters.begin(), letters.end()));
  CHECK(ranges_of(u"abcxz") == std::vector<ImWchar>{u'a', u'c', u'x', u'x', u'z', u'z', 0});
}

TEST_CASE("a font of the system lends the letters that Inter lacks, and nothing is searched without need") {
  const std::vector<std::string> folders = font_folders("");
  FontFiles files = find_fonts(folders);
  const FontFiles plain = files;
  find_fallbacks(files, folders, {});
  CHECK(files == plain);
  find_fallbacks(files, folders, std::u16string{an, hae});
  if (files.text.empty() || files.more.empty())
    RAYWALK_SKIP("Inter, or a font with Georgian letters, is not installed");
#if IMGUI_VERSION_NUM < 19200
  CHECK(files.more.size() == 1);
  ImFontAtlas without, with;
  CHECK(build_fonts(without, plain, 1, 1).text->FindGlyphNoFallback(an) == nullptr);
  const Fonts fonts = build_fonts(with, files, 1, 1);
  for (const ImFont* font : {fonts.text, fonts.strong, fonts.small, fonts.title, fonts.code, fonts.code_strong}) {
    CHECK(font->FindGlyphNoFallback(an) != nullptr);
    CHECK(font->FindGlyphNoFallback(hae) != nullptr);
  }
  // Latin letters are still those of Inter.
  CHECK(fonts.text->FindGlyphNoFallback('W')->AdvanceX ==
        build_fonts(without, plain, 1, 1).text->FindGlyphNoFallback('W')->AdvanceX);
#endif
}

TEST_CASE("a fallback that is no font is passed over") {
  const Folder folder;
  folder.put("DejaVuSans.ttf", "no font");
  folder.put("NotoSans-Regular.ttf", "");
  folder.put("NotoSansThai-Bold.ttf", "no font");
  FontFiles files;
  find_fallbacks(files, {folder / "", folder / "missing"}, std::u16string{an});
  CHECK(files.more.empty());
  ImFontAtlas atlas;
  check_complete(build_fonts(atlas, files, 1, 1));
}
