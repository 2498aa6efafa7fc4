// Textures of scenes: found and read once; what is wrong with one is said.
#include "io/textures.h"

#include "image/image_file.h"
#include "io/scene_file.h"
#include "support/temporary_folder.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Image gradient() {
  Image image{5, 3, {}};
  for (int i = 0; i < 15; ++i)
    image.pixels.emplace_back(static_cast<float>(i) / 14.0F, 0.2F, 1 - static_cast<float>(i) / 14.0F);
  return image;
}

const std::string scene_text =
    "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [3, "
    "0]\nradius = 1\n[object.material.texture]\nfile = \"pictures/wood.png\"\nwidth = 2\n";

}  // namespace

TEST_CASE("a scene finds its texture from its own folder") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  put(path, scene_text);
  const auto missing = read_scene(path);
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().text(), contains("scene.toml:11:8: file \"pictures/wood.png\": cannot read"));
  CHECK_THAT(missing.error().hint, contains("the texture of \"Ball\""));
  // However it is written, and not where other words are the same.
  std::string quoted = scene_text;
  for (const std::size_t at : {quoted.find("\"pictures"), quoted.find("\"\nwidth")}) quoted[at] = '\'';
  put(path, "title = \"pictures/wood.png\"\n" + quoted);
  CHECK_THAT(read_scene(path).error().text(), contains("scene.toml:12:8: file \"pictures/wood.png\": cannot read"));
  put(path, scene_text);
  std::filesystem::create_directory(folder.file("pictures"));
  REQUIRE(write_image(folder.file("pictures/wood.png"), gradient()));
  const auto document = read_scene(path);
  REQUIRE(document);
  const auto& texture = document->scene.objects[0].material.texture;
  REQUIRE(texture.has_value());
  REQUIRE(texture->pixels != nullptr);
  CHECK(texture->pixels->width == 5);
  CHECK(texture->width == 2);
  CHECK(texture->height == 1);
  // Without its folder the text alone is a scene too; it wears nothing yet.
  CHECK(parse_scene(scene_text, "")->scene.objects[0].material.texture->pixels == nullptr);
}
