// Broken and strange texts: read without harm, and when they are scenes, saved without loss.

#include <string>
#include <string_view>

#include "io/scene_file.h"
#include "io/toml_layout.h"
#include "random_scene.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// `text` with a few characters or stretches changed, removed, doubled or swapped for what TOML gives a meaning.
std::string damaged(std::string text, Random& random) {
  constexpr std::string_view pieces[] = {"[",    "]",   "{",   "}",    "\"",    "'",          "\"\"\"", "'''",
                                         ",",    ".",   "=",   "\n",   "\\",    "#",          "-",      "0",
                                         "1e9",  "inf", "nan", " ",    "eye",   "[[object]]", "\r",     "\\u",
                                         "true", "é",   "\t",  "[a.b", "x = 1", "0x1f",       "_",      "\xff"};
  for (std::size_t edits = 1 + random.below(4); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = random.chance(0.5) ? 1 : random.below(40);
    switch (random.below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, pieces[random.below(std::size(pieces))]);
        break;
      case 2:
        text.insert(at, text.substr(random.below(text.size()), length));
        break;
      default:
        text.replace(at, 1, pieces[random.below(std::size(pieces))]);
        break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("damaged scenes are refused with a place, or are scenes that can be saved") {
  const std::string classic = contents(RAYWALK_SOURCE_DIR "/scenes/classic.toml");
  REQUIRE(!classic.empty());
  Random random(11);
  int refused = 0, read = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    const std::string text = damaged(random.chance(0.5) ? classic : *format_scene(random_scene(random)), random);
    const auto document = parse_scene(text, "damaged.toml");
    INFO("round " << round << "\n" << text);
    if (!document) {
      ++refused;
      REQUIRE(document.error().line > 0);
      REQUIRE(!document.error().message.empty());
      REQUIRE(!document.error().hint.empty());
      continue;
    }
    ++read;
    const auto unchanged = format_scene(document->scene, text);
    REQUIRE(unchanged);
    const std::string end = text.back() == '\n' ? "" : text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
    if (text.find('\r') == std::string::npos) REQUIRE(*unchanged == text + end);
    Scene scene = document->scene;
    change_something(scene, random);
    const auto changed = format_scene(scene, text);
    INFO((changed ? *changed : changed.error().text()));
    REQUIRE(changed);
    const auto back = parse_scene(*changed, "changed.toml");
    REQUIRE(back);
    REQUIRE(same_bits(back->scene, scene));
  }
  CHECK(refused > rounds(500));
  CHECK(read > rounds(500));
}

TEST_CASE("every beginning of a scene is read without harm") {
  const std::string classic = contents(RAYWALK_SOURCE_DIR "/scenes/classic.toml");
  int read = 0;
  for (std::size_t length = 0; length < classic.size(); length += 3) {
    if (left_out(length / 3, 7)) continue;
    const auto document = parse_scene(classic.substr(0, length), "part.toml");
    if (document)
      ++read;
    else
      CHECK(!document.error().hint.empty());
  }
  CHECK(read > 0);
}

TEST_CASE("texts that are no TOML have no layout, or one that lies within them") {
  Random random(12);
  for (int round = 0; round < rounds(3000); ++round) {
    const std::string text = damaged(*format_scene(random_scene(random)), random);
    const auto layout = detail::scan_toml(text);
    if (!layout) continue;
    for (const detail::Section& section : layout->sections) {
      REQUIRE(section.lead_begin <= section.header_begin);
      REQUIRE(section.header_begin <= section.body_end);
      REQUIRE(section.body_end <= section.own_end);
      REQUIRE(section.own_end <= text.size());
    }
  }
}

TEST_CASE("a folder, a missing file and an endless one are no scenes") {
  const TemporaryFolder folder;
  const auto missing = read_scene(folder.file("missing.toml"));
  REQUIRE(!missing);
  CHECK(missing.error().file == folder.file("missing.toml"));
  CHECK_THAT(missing.error().text(), contains("there is no such file"));
  const auto directory = read_scene(folder.path());
  REQUIRE(!directory);
  CHECK_THAT(directory.error().text(), contains("this is a folder"));
  const auto endless = read_scene("/dev/zero");
  REQUIRE(!endless);
  CHECK_THAT(endless.error().text(), contains("this is a device (expected a file)"));
  put(folder.file("large.toml"), std::string((std::size_t{16} << 20) + 1, '#'));
  const auto large = read_scene(folder.file("large.toml"));
  REQUIRE(!large);
  CHECK_THAT(large.error().text(), contains("too large (expected at most 16 MiB)"));
}

TEST_CASE("a file of a million tables is refused at the first one that is wrong") {
  std::string text = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n";
  for (int i = 0; i < rounds(1'000'000); ++i) text += "[[object]]\n";
  const auto document = parse_scene(text, "many.toml");
  REQUIRE(!document);
  CHECK(document.error().line == 5);
}
