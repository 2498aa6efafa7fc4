// Maps and masks of scenes: read, written, found beside the scene, decoded as what they are; what is wrong with one is
// said.

#include "image/image_file.h"
#include "io/bad_scene.h"
#include "io/scene_file.h"
#include "support/temporary_folder.h"

#include <bit>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Image bytes_image() {
  Image image{2, 1, {}};
  // Encoded to sRGB, these become the bytes 128 and 255.
  image.pixels.emplace_back(static_cast<float>(srgb_decode(128.0 / 255)));
  image.pixels.emplace_back(1.0F);
  return image;
}

// A ball with these lines in its material; the first one is line 11.
std::string with_lines(const std::string& lines) {
  return with_sphere("centre = [3, 0]\nradius = 1\n[object.material]\n" + lines);
}

const std::string everything =
    "diffuse = 0.5\nspecular = 0.1\nreflection = 0.2\nroughness = 1\nemission = 1\n"
    "texture = { file = \"t.png\", wrap = \"mirror\" }\n"
    "normal_map = { file = \"n.png\", strength = 0.5, wrap = \"clamp\" }\n"
    "bump_map = { file = \"b.png\", width = 2, relief = -0.05, channel = \"blue\" }\n"
    "[[object.material.map]]\nof = \"roughness\"\nfile = \"r.png\"\nwidth = 2\nheight = 3\nchannel = \"green\"\nwrap = "
    "\"clamp\"\n"
    "[[object.material.map]]\nof = \"emission\"\nfile = \"r.png\"\n"
    "[object.material.mask]\nfile = \"m.png\"\nwrap = \"mirror\"\n"
    "[object.material.mask.second]\ndiffuse = [0.4, 0.2, 0.1]\nroughness = 0.4\nreflection = 0.1\n"
    "map = [{ of = \"diffuse\", file = \"r.png\" }]\n";

std::vector<std::string> warnings_of(const std::string& lines) {
  return parse_scene(with_lines(lines), "s.toml")->warnings;
}

}  // namespace

TEST_CASE("maps and masks are read with all their keys, and saved as they stand") {
  const auto document = parse_scene(with_lines(everything), "s.toml");
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  CHECK(document->warnings.empty());
  const Material& material = document->scene.objects[0].material;
  REQUIRE(material.maps.size() == 2);
  REQUIRE(material.texture);
  CHECK(material.texture->wrap == ImageWrap::mirror);
  CHECK(material.maps[0] ==
        ParameterMap{{"r.png", 2, 3, {}, ImageWrap::clamp}, MappedParameter::roughness, MapChannel::green});
  CHECK(material.maps[1] == ParameterMap{{"r.png"}, MappedParameter::emission, MapChannel::red});
  CHECK(material.normal_map == NormalMap{{"n.png", 1, 1, {}, ImageWrap::clamp}, 0.5});
  CHECK(material.bump_map == BumpMap{{"b.png", 2, 1}, -0.05, MapChannel::blue});
  REQUIRE(material.mask);
  CHECK(material.mask->file == "m.png");
  CHECK(material.mask->wrap == ImageWrap::mirror);
  CHECK(material.mask->second.roughness == 0.4);
  CHECK(material.mask->second.maps.size() == 1);
  const auto written = format_scene(document->scene);
  REQUIRE(written);
  const auto again = parse_scene(*written, "again.toml");
  INFO(*written);
  REQUIRE(again);
  CHECK(again->scene == document->scene);
  const auto squares = parse_scene(with_lines("mask = { squares = 0.5, second = { diffuse = 0 } }\n"), "s.toml");
  REQUIRE(squares);
  CHECK(squares->scene.objects[0].material.mask->squares == 0.5);
}

TEST_CASE("images of colours are decoded from sRGB, those of numbers are the numbers") {
  const TemporaryFolder folder;
  for (const char* name : {"t.png", "r.png", "n.png", "b.png", "m.png"})
    REQUIRE(write_image(folder.file(name), bytes_image()));
  const std::string path = folder.file("scene.toml");
  put(path, with_lines(everything));
  const auto document = read_scene(path);
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  const Material& material = document->scene.objects[0].material;
  const float half = static_cast<float>(128.0 / 255), decoded = static_cast<float>(srgb_decode(128.0 / 255));
  CHECK(material.maps[0].pixels->at(0, 0).x == half);
  CHECK(material.maps[1].pixels->at(0, 0).x == decoded);
  CHECK(material.texture->pixels->at(0, 0).x == decoded);
  CHECK(material.normal_map->pixels->at(0, 0).z == half);
  CHECK(material.bump_map->pixels->at(0, 0).x == half);
  CHECK(material.mask->pixels->at(0, 0).x == half);
  CHECK(material.mask->second.maps[0].pixels->at(0, 0).x == decoded);
  // Floats are linear already.
  Image floats{1, 1, {Rgb<float>(0.5F)}};
  REQUIRE(write_image(folder.file("r.pfm"), floats));
  put(path, with_lines("emission = 1\nroughness = 1\nreflection = 1\nmap = [{ of = \"emission\", file = \"r.pfm\" }, "
                       "{ of = \"roughness\", file = \"r.pfm\" }]\n"));
  const auto linear = read_scene(path);
  REQUIRE(linear);
  for (const ParameterMap& map : linear->scene.objects[0].material.maps) CHECK(map.pixels->at(0, 0).x == 0.5F);
}

TEST_CASE("a map that is missing, no picture, or holds what is no number is refused with its name and place") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  const auto refusal_of = [&](const std::string& file) {
    put(path, with_lines("roughness = 1\nreflection = 1\nmap = [{ of = \"roughness\", file = \"" + file + "\" }]\n"));
    const auto read = read_scene(path);
    REQUIRE_FALSE(read);
    CHECK(read.error().file == path);
    CHECK(read.error().line == 13);
    CHECK_THAT(read.error().message, contains("file \"" + file + "\": "));
    CHECK_THAT(read.error().hint, contains("it is a map of \"Ball\""));
    return read.error().message;
  };
  CHECK_FALSE(refusal_of("none.png").empty());
  put(folder.file("text.png"), "no picture");
  CHECK_THAT(refusal_of("text.png"), contains("PNG or JPEG"));
  for (const float wrong : {-0.5F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Image image{2, 2, std::vector<Rgb<float>>(4, Rgb<float>(0.5F))};
    image.at(1, 0).y = wrong;
    put(folder.file("wrong.pfm"), encode_pfm(image));
    CHECK_THAT(refusal_of("wrong.pfm"), contains("pixel (1, 0)"));
  }
}

TEST_CASE("bad maps and masks are refused at the place of their fault") {
  const std::vector<BadScene> scenes{
      {"map of nothing", with_lines("map = [{ file = \"a.png\" }]\n"), 11, 8, "of is missing", ""},
      {"map of an unknown parameter", with_lines("map = [{ of = \"ior\", file = \"a.png\" }]\n"), 11, 15,
       "of of [[object.material.map]] number 1 of \"Ball\": found \"ior\" (expected", ""},
      {"map without a file", with_lines("map = [{ of = \"diffuse\" }]\n"), 11, 8, "file is missing", ""},
      {"map without height", with_lines("map = [{ of = \"diffuse\", file = \"a.png\", height = 0 }]\n"), 11, 51,
       "above 0", ""},
      {"unknown channel", with_lines("bump_map = { file = \"a.png\", channel = \"alpha\" }\n"), 11, 40, "\"blue\"", ""},
      {"two maps of one parameter",
       with_lines("map = [{ of = \"diffuse\", file = \"a.png\" }, { of = \"diffuse\", file = \"b.png\" }]\n"), 11, 7,
       "diffuse has two maps", "multiplies"},
      {"negative strength", with_lines("normal_map = { file = \"a.png\", strength = -1 }\n"), 11, 43, "0 or more", ""},
      {"relief of a fixed normal", with_lines("normal = \"fixed\"\nbump_map = { file = \"a.png\" }\n"), 12, 12,
       "fixed normal", "as it is given"},
      {"normals of a fixed normal", with_lines("normal = \"fixed\"\nnormal_map = { file = \"a.png\" }\n"), 12, 14,
       "fixed normal", "as it is given"},
      {"mask of nothing", with_lines("mask = { second = {} }\n"), 11, 8, "a mask without a file or squares",
       "rust.png"},
      {"mask of two kinds", with_lines("mask = { file = \"a.png\", squares = 1 }\n"), 11, 17,
       "either a file or squares", "checker"},
      {"mask and filtered shadows", with_lines("transmission = 1\nshadow = \"filtered\"\nmask = { squares = 1 }\n"), 13,
       8, "filtered shadows", "mixes"},
      {"mapped transmission and filtered shadows",
       with_lines("transmission = 1\nshadow = \"filtered\"\nmap = [{ of = \"transmission\", file = \"a.png\" }]\n"), 13,
       7, "filtered shadows", ""},
      {"second material with metal", with_lines("mask = { squares = 1, second = { mirror = \"gold\" } }\n"), 11, 34,
       "unknown key \"mirror\"", ""},
      {"second material that is rough and glossy",
       with_lines("gloss = 4\nmask = { squares = 1, second = { roughness = 0.4 } }\n"), 12, 8, "does not go with gloss",
       ""},
      {"second material that mirrors on glass",
       with_lines("transmission = 1\ndielectric = true\nmask = { squares = 1, second = { reflection = 0.4 } }\n"), 13,
       8, "does not go with a dielectric", ""},
      {"map of what the second material has not",
       with_lines("mask = { squares = 1, second = { map = [{ of = \"gloss\", file = \"a.png\" }] } }\n"), 11, 8,
       "no gloss of its own", ""},
  };
  for (const BadScene& bad : scenes) check_refused(bad);
}

TEST_CASE("maps that change nothing are warned about") {
  const auto warning = [&](const std::string& lines) {
    const auto warnings = warnings_of(lines);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], contains("s.toml:5:1: warning: \"Ball\""));
    return warnings[0];
  };
  CHECK_THAT(warning("map = [{ of = \"roughness\", file = \"a.png\" }]\nreflection = 1\ndiffuse = 0\n"),
             contains("the map of roughness changes nothing, for what it multiplies is 0"));
  CHECK_THAT(warning("map = [{ of = \"roughness\", file = \"a.png\" }]\nroughness = 1\n"),
             contains("there is no reflection"));
  CHECK_THAT(warning("map = [{ of = \"shininess\", file = \"a.png\" }]\n"), contains("there is no specular"));
  CHECK_THAT(warning("map = [{ of = \"emission\", file = \"a.png\" }]\n"), contains("the map of emission"));
  CHECK_THAT(warning("mask = { squares = 1, second = { map = [{ of = \"specular\", file = \"a.png\" }] } }\n"),
             contains(", second material: the map of specular"));
  CHECK_THAT(warning("bump_map = { file = \"a.png\", relief = 0 }\n"), contains("its relief is 0"));
  CHECK_THAT(warning("normal_map = { file = \"a.png\", strength = 0 }\n"), contains("its strength is 0"));
  CHECK_THAT(warning("mask = { squares = 1, second = { diffuse = 0.7, specular = 0.5 } }\n"),
             contains("sends out more light"));
  CHECK(warnings_of("map = [{ of = \"diffuse\", file = \"a.png\" }]\n").empty());
}

TEST_CASE("a scene that is written elsewhere still finds its maps") {
  const auto document = parse_scene(with_lines(everything), "s.toml");
  REQUIRE(document);
  const TemporaryFolder folder;
  const auto moved = with_names_from(document->scene, folder.file("a/scene.toml"), folder.file("b/scene.toml"));
  REQUIRE(moved);
  const Material& material = moved->objects[0].material;
  CHECK(material.maps[0].file == "../a/r.png");
  CHECK(material.normal_map->file == "../a/n.png");
  CHECK(material.bump_map->file == "../a/b.png");
  CHECK(material.mask->file == "../a/m.png");
  CHECK(material.mask->second.maps[0].file == "../a/r.png");
}
