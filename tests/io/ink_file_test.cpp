// What is drawn over a plan, in the file of its scene.
#include "bad_scene.h"
#include "io/scene_file.h"
#include "io/scene_patch.h"
#include "random_scene.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/temporary_folder.h"

#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string head = R"(# mine
[camera]
eye = [-7, 0]   # left
look_at = [0, 0]
fov = 45

[[object]]
name = "ball"
type = "sphere"
centre = [0, 0]
radius = 1
)";

const std::string drawn = R"(
[[ink]]   # by hand
type = "pen"
points = [[0, 0], [1, 0.5]]
colour = "green"

# how far
[[ink]]
type = "ruler"
from = [-7, 0]
to = [0, 0]
)";

Ink random_ink(Random& random) {
  const auto place = [&] { return Vec2d(random.number(), random.number()); };
  Ink ink;
  for (std::size_t i = random.below(5); i > 0; --i) {
    InkMark mark{Ruler{place(), place()}, static_cast<InkColour>(random.below(std::size(words_of<InkColour>)))};
    switch (random.below(5)) {
      case 0:
        mark.shape = PenStroke{{place(), place(), place()}};
        break;
      case 1:
        mark.shape = InkArrow{place(), place()};
        break;
      case 2:
        mark.shape = InkText{place(), "\u00e9 \"" + std::to_string(random.below(9)) + "\" # \\"};
        break;
      case 3:
        mark.shape = Protractor{place(), place(), place()};
        break;
      default:
        break;
    }
    ink.push_back(std::move(mark));
  }
  return ink;
}

SceneDocument parsed(const std::string& text) {
  auto document = parse_scene(text, "scene.toml");
  if (!document) FAIL(document.error().text());
  return std::move(*document);
}

}  // namespace

TEST_CASE("ink is read beside the scene, which is the same without it") {
  const SceneDocument with = parsed(head + drawn), without = parsed(head);
  CHECK(with.scene == without.scene);
  CHECK(with.ink == Ink{{PenStroke{{{0, 0}, {1, 0.5}}}, InkColour::green}, {Ruler{{-7, 0}, {0, 0}}, InkColour::red}});
  CHECK(with.keeps_ink);
  CHECK_FALSE(without.keeps_ink);
  // No link's changes and no sum of a scene know of it.
  CHECK(scene_patch(with.scene, without.scene).empty());
  CHECK(scene_sum(with.scene) == scene_sum(without.scene));
}

TEST_CASE("a file without ink stays as it was, and ink is written only if it is kept") {
  const TemporaryFolder folder;
  SceneDocument document = parsed(head);
  document.ink = {{InkArrow{{0, 0}, {1, 1}}, InkColour::blue}};
  REQUIRE(write_scene(document, folder.file("scene.toml")));
  CHECK(document.text == head);
  document.keeps_ink = true;
  REQUIRE(write_scene(document, folder.file("scene.toml")));
  CHECK(document.text == head + "\n[[ink]]\ntype = \"arrow\"\nfrom = [0, 0]\nto = [1, 1]\ncolour = \"blue\"\n");
  const auto read = read_scene(folder.file("scene.toml"));
  REQUIRE(read);
  CHECK(read->ink == document.ink);
  CHECK(read->keeps_ink);
}

TEST_CASE("marks that stay keep their text, those that go take it along") {
  SceneDocument document = parsed(head + drawn);
  CHECK(format_scene(document.scene, document.text, document.ink).value() == head + drawn);
  document.ink.push_back({InkText{{1, 2}, "n"}, InkColour::plain});
  const std::string more = format_scene(document.scene, document.text, document.ink).value();
  CHECK(more == head + drawn + "\n[[ink]]\ntype = \"text\"\nat = [1, 2]\ntext = \"n\"\ncolour = \"plain\"\n");
  document.ink.erase(document.ink.begin());
  const std::string less = format_scene(document.scene, more, document.ink).value();
  CHECK(less == head + "\n# how far\n" + more.substr(more.find("[[ink]]\ntype = \"ruler\"")));
  const std::string none = format_scene(document.scene, more, {}).value();
  CHECK_THAT(none, !contains("ink") && !contains("how far") && contains(head));
}

TEST_CASE("any ink comes back bit for bit, whatever it replaces") {
  Random random(7);
  for (int i = 0; i < rounds(300); ++i) {
    const Scene scene = random_scene(random);
    const Ink before = random_ink(random), after = random_ink(random);
    const std::string text = format_scene(scene, {}, before).value();
    CHECK(parsed(text).ink == before);
    const auto changed = format_scene(scene, text, after);
    REQUIRE(changed);
    const SceneDocument read = parsed(*changed);
    CHECK(read.ink == after);
    CHECK(same_bits(read.scene, scene));
  }
}

TEST_CASE("a mark that cannot be is refused with its line") {
  const auto error_of = [](const std::string& mark) {
    const auto read = parse_scene(head + "\n[[ink]]\n" + mark, "scene.toml");
    REQUIRE(!read);
    return read.error();
  };
  CHECK(error_of("type = \"pencil\"\n").message ==
        "type of [[ink]] number 1: found \"pencil\" (expected \"pen\", \"arrow\", "
        "\"text\", \"ruler\" or \"protractor\")");
  CHECK_THAT(error_of("type = \"pen\"\npoints = []\n").message,
             contains("expected a list of 1 to 10000 places [x, y]"));
  CHECK_THAT(error_of("type = \"ruler\"\nfrom = [0, 0]\n").message, contains("to"));
  CHECK_THAT(error_of("type = \"text\"\nat = [0, 0]\ntext = \"\"\n").message, contains("one line of text in quotes"));
  CHECK_THAT(error_of("type = \"arrow\"\nfrom = [0, 0]\nto = [0, inf]\n").message, contains("to of [[ink]] number 1"));
  CHECK(error_of("type = \"arrow\"\nfrom = [0, 0]\nto = [0, 1]\ncolor = \"red\"\n").hint == "did you mean \"colour\"?");
}
