// Skies in scene files: read, written, refused; their pictures found and judged.

#include <cmath>
#include <filesystem>
#include <limits>

#include "bad_scene.h"
#include "image/image_file.h"
#include "io/key_reference.h"
#include "io/scene_file.h"
#include "io/scene_patch.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// `lines` of [sky]; the first one is line 6.
std::string with_sky(const std::string& lines) { return raywalk::test::camera + "[sky]\n" + lines; }

Image grey(int width, int height, float light = 1) {
  return {width, height, std::vector<Rgb<float>>(static_cast<std::size_t>(width * height), Rgb<float>(light))};
}

}  // namespace

TEST_CASE("each kind of sky is read, and written back as it was") {
  const std::vector<std::pair<std::string, Sky>> skies{
      {"type = \"gradient\"\nhorizon = [1, 0.5, 0]\nzenith = 0.2\n", {GradientSky{{1, 0.5, 0}, Rgbd(0.2)}}},
      {"type = \"gradient\"\n", {GradientSky{}}},
      {"type = \"overcast\"\nzenith = 3\nrotation = -20\n", {OvercastSky{Rgbd(3)}, {0, 0, 1}, -20}},
      {"type = \"clear\"\nelevation = 12\nturbidity = 2.5\nalbedo = 0.4\nstrength = 0.1\nup = [0, 1, 0]\n",
       {ClearSky{12, 2.5, 0.4, Rgbd(0.1)}, {0, 1, 0}, 0}},
      {"type = \"image\"\nfile = \"a.hdr\"\nstrength = 2\nrotation = 90\n",
       {ImageSky{"a.hdr", Rgbd(2)}, {0, 0, 1}, 90}}};
  for (const auto& [lines, sky] : skies) {
    INFO(lines);
    const auto read = parse_scene(with_sky(lines), "a.toml");
    REQUIRE(read);
    REQUIRE(read->scene.sky.has_value());
    CHECK(*read->scene.sky == sky);
    const auto written = format_scene(read->scene);
    REQUIRE(written);
    const auto again = parse_scene(*written, "b.toml");
    REQUIRE(again);
    CHECK(again->scene == read->scene);
    CHECK(*format_scene(read->scene, read->text) == read->text);
  }
  CHECK_FALSE(parse_scene(raywalk::test::camera, "a.toml")->scene.sky.has_value());
}

TEST_CASE("bad skies are refused at the place of their fault") {
  const std::vector<BadScene> scenes{
      {"no type", with_sky("zenith = 1\n"), 5, 1, "type", "gradient"},
      {"unknown type", with_sky("type = \"starry\"\n"), 6, 8, "starry", ""},
      {"key of another kind", with_sky("type = \"overcast\"\nhorizon = 1\n"), 7, 1, "unknown key \"horizon\"", ""},
      {"negative light", with_sky("type = \"overcast\"\nzenith = [1, -1, 0]\n"), 7, 14, "found -1", "never negative"},
      {"black overcast", with_sky("type = \"overcast\"\nzenith = 0\n"), 7, 10, "wholly black", "leave [sky] out"},
      {"black gradient", with_sky("type = \"gradient\"\nhorizon = 0\nzenith = 0\n"), 8, 10, "wholly black", ""},
      {"sun below", with_sky("type = \"clear\"\nelevation = -1\n"), 7, 13, "from 0 to 90", "sunset"},
      {"too clear", with_sky("type = \"clear\"\nturbidity = 0.5\n"), 7, 13, "from 1 to 10", "hazy"},
      {"too hazy", with_sky("type = \"clear\"\nturbidity = 11\n"), 7, 13, "from 1 to 10", ""},
      {"too white", with_sky("type = \"clear\"\nalbedo = 1.1\n"), 7, 10, "from 0 to 1", "snow"},
      {"no file", with_sky("type = \"image\"\n"), 5, 1, "file is missing", ""},
      {"black strength", with_sky("type = \"image\"\nfile = \"a.hdr\"\nstrength = 0\n"), 8, 12, "wholly black", ""},
      {"up of no length", with_sky("type = \"clear\"\nup = [0, 0, 0]\n"), 7, 6, "", ""},
      {"round and round", with_sky("type = \"clear\"\nrotation = 400\n"), 7, 12, "-360 to 360", "left"},
      {"a word", "sky = \"blue\"\n" + raywalk::test::camera, 1, 7, "a table", ""}};
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("the reference says that no sky is wholly black") {
  int count = 0;
  for (const KeyTable& table : key_tables()) {
    if (!table.heading.starts_with("[sky] of type")) continue;
    INFO(table.heading);
    CHECK_THAT(table.keys.back().sentence, contains("not 0") || contains("not both 0"));
    ++count;
  }
  CHECK(count == 4);
}

TEST_CASE("the picture of a sky is found from the scene's folder, in every format") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("skies"));
  REQUIRE(write_image(folder.file("skies/a.pfm"), grey(4, 2, 0.5F)));
  REQUIRE(write_image(folder.file("skies/a.png"), grey(4, 2)));
  if (has_exr()) REQUIRE(write_image(folder.file("skies/a.exr"), grey(4, 2, 7)));
  put(folder.file("skies/a.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string(8, '\x81'));
  for (const std::string ending : {"pfm", "png", "exr", "hdr"}) {
    if (ending == "exr" && !has_exr()) continue;
    INFO(ending);
    put(folder.file("scene.toml"), with_sky("type = \"image\"\nfile = \"skies/a." + ending + "\"\n"));
    const auto read = read_scene(folder.file("scene.toml"));
    REQUIRE(read);
    const auto& pixels = std::get<ImageSky>(read->scene.sky->kind).pixels;
    REQUIRE(pixels != nullptr);
    CHECK(pixels->width == 2 * pixels->height);
    CHECK(read->files.size() == 2);
  }
  // From another folder, it is named from there.
  const auto document = read_scene(folder.file("scene.toml"));
  const auto moved = with_names_from(document->scene, folder.file("scene.toml"), folder.file("skies/new.toml"));
  REQUIRE(moved);
  CHECK(std::get<ImageSky>(moved->sky->kind).file == "a.hdr");
}

TEST_CASE("a link brings the picture of its scene's sky along, and can name no other") {
  const TemporaryFolder folder;
  for (const char* name : {"sky.pfm", "other.pfm"}) REQUIRE(write_image(folder.file(name), grey(4, 2)));
  put(folder.file("scene.toml"), with_sky("type = \"image\"\nfile = \"sky.pfm\"\n"));
  put(folder.file("bare.toml"), raywalk::test::camera);
  const auto under_sky = read_scene(folder.file("scene.toml")), bare = read_scene(folder.file("bare.toml"));
  REQUIRE((under_sky && bare));
  CHECK(names_files(under_sky->scene));
  CHECK_FALSE(names_files(bare->scene));
  Scene moved = under_sky->scene;
  moved.camera.eye.z += 1;
  const auto seen = patched_scene(*under_sky, scene_patch(under_sky->scene, moved));
  REQUIRE(seen);
  CHECK(std::get<ImageSky>(seen->scene.sky->kind).pixels != nullptr);
  Scene elsewhere = under_sky->scene;
  std::get<ImageSky>(elsewhere.sky->kind).file = "other.pfm";
  for (const SceneDocument* from : {&*under_sky, &*bare}) {
    const auto refused = patched_scene(*from, scene_patch(from->scene, elsewhere));
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, contains("needs the file \"other.pfm\", which a link cannot hold"));
  }
}

TEST_CASE("a picture that can be no sky is refused with its file and a hint") {
  const TemporaryFolder folder;
  put(folder.file("scene.toml"), with_sky("type = \"image\"\nfile = \"sky.pfm\"\n"));
  const auto refused = [&](const Image& picture, const std::string& why) {
    REQUIRE(write_image(folder.file("sky.pfm"), picture));
    const auto read = read_scene(folder.file("scene.toml"));
    INFO(why);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().text(), contains("file \"sky.pfm\": "));
    CHECK_THAT(read.error().message, contains(why));
    CHECK(!read.error().hint.empty());
  };
  const auto missing = read_scene(folder.file("scene.toml"));
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().hint, contains("the picture of the sky"));
  refused(grey(4, 3), "4 x 3 pixels (expected twice as many columns as rows)");
  refused(grey(4, 2, 0), "wholly black");
  for (const auto& [light, what] :
       std::vector<std::pair<float, std::string>>{{std::nanf(""), "NaN"},
                                                  {-1, "negative light"},
                                                  {std::numeric_limits<float>::infinity(), "infinite light"},
                                                  {2e12F, "light above 1e12"}}) {
    Image picture = grey(4, 2);
    picture.at(3, 1).y = light;
    refused(picture, "column 3 of row 1");
    refused(picture, what);
  }
  put(folder.file("sky.pfm"), "no picture");
  CHECK_FALSE(read_scene(folder.file("scene.toml")));
}
