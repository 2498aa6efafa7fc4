// Textures: the pixels of an image file, in linear light; what is wrong with a file is said.
#include "io/texture_file.h"

#include "io/image.h"
#include "io/scene_file.h"
#include "temporary_folder.h"

#include <random>

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

TEST_CASE("a texture holds what its PNG shows, in linear light, top row first") {
  const Image image = gradient();
  const auto texture = decode_texture(encode_png(image).value(), "wood.png");
  REQUIRE(texture);
  CHECK(texture->width == 5);
  CHECK(texture->height == 3);
  REQUIRE(texture->pixels.size() == 15);
  for (std::size_t i = 0; i < 15; ++i)
    for (int c = 0; c < 3; ++c)  // 8 bits of sRGB: steps of up to 1/110 near white
      CHECK(std::abs(texture->pixels[i][c] - image.pixels[i][c]) < 0.005F);
}

TEST_CASE("what is no image, or a damaged one, is refused with its name and a hint") {
  const std::string png = encode_png(gradient()).value();
  for (const std::string& bad :
       {std::string(), std::string("wood"), png.substr(0, 40), png.substr(0, png.size() / 2)}) {
    const auto texture = decode_texture(bad, "wood.png");
    REQUIRE_FALSE(texture);
    CHECK(texture.error().file == "wood.png");
    CHECK_THAT(texture.error().hint, contains("PNG or a JPEG"));
  }
  // Any damage is refused or gives an image of the stated size, and does nothing worse.
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = png;
    for (int flips = 0; flips < 3; ++flips) damaged[random() % damaged.size()] = static_cast<char>(random());
    if (const auto texture = decode_texture(damaged, ""))
      CHECK(texture->pixels.size() ==
            static_cast<std::size_t>(texture->width) * static_cast<std::size_t>(texture->height));
  }
}

TEST_CASE("a scene finds its texture from its own folder") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  put(path, scene_text);
  const auto missing = read_scene(path);
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().file, contains("pictures/wood.png"));
  CHECK_THAT(missing.error().hint, contains("the texture of \"Ball\""));
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
