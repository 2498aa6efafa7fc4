// Normals that a file gives its triangles, where the material keeps its normals: interpolated and used as they are,
// also across and against the winding (the course format says so, and our own by normal = "fixed"). Against shades
// worked out by hand.

#include "io/scene_file.h"
#include "io/test_format_reader.h"
#include "render/render.h"
#include "support/catch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace raywalk;

namespace {

// The middle of the triangle (-1, -1, 0), (1, -1, 0), (0, 2, 0), which winds about +z, is the origin: its three corners
// weigh the same there.
struct Case {
  std::string what;
  std::array<Vec3d, 3> normals;  ///< of the corners
  Vec3d to_light;                ///< of any length
  double eye_z;                  ///< the eye stands above or below the origin
};

constexpr double specular = 0.5, shininess = 3, ambient = 0.125;
const Rgbd diffuse{0.25, 0.5, 1}, light{1, 0.75, 0.5};

std::string words(const Vec3d& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string list(const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string course_text(const Case& of, bool winds_back) {
  std::string text = fmt::format(
      "size 1 1\ncamera 0 0 {} 0 0 0 0 1 0 30\nmaxdepth 0\nmaxverts 3\nmaxvertnorms 3\ndirectional {} {}\n"
      "ambient {} {} {}\ndiffuse {}\nspecular {} {} {}\nshininess {}\n",
      of.eye_z, words(of.to_light), words(light), ambient, ambient, ambient, words(diffuse), specular, specular,
      specular, shininess);
  const std::array<Vec3d, 3> corners{Vec3d(-1, -1, 0), Vec3d(1, -1, 0), Vec3d(0, 2, 0)};
  for (std::size_t i = 0; i < 3; ++i) text += "vertexnormal " + words(corners[i]) + " " + words(of.normals[i]) + "\n";
  return text + (winds_back ? "trinormal 0 2 1\n" : "trinormal 0 1 2\n");
}

std::string own_text(const Case& of, bool winds_back) {
  return fmt::format(
      "ambient = 1\n[camera]\neye = [0, 0, {}]\nlook_at = [0, 0, 0]\nup = [0, 1, 0]\nfov = 30\n[image]\nwidth = 1\n"
      "height = 1\n[[light]]\nname = \"Sun\"\ntype = \"directional\"\ndirection = {}\nstrength = {}\n"
      "[[object]]\nname = \"Sail\"\ntype = \"mesh\"\nvertices = [[-1, -1, 0], [1, -1, 0], [0, 2, 0]]\n"
      "triangles = [{}]\nnormals = [{}, {}, {}]\nmaterial = {{ ambient = {}, diffuse = {}, specular = {}, shininess = "
      "{}, normal = \"fixed\" }}\n",
      of.eye_z, list(of.to_light), list(light), winds_back ? "[0, 2, 1]" : "[0, 1, 2]", list(of.normals[0]),
      list(of.normals[1]), list(of.normals[2]), ambient, list(diffuse), specular, shininess);
}

// I = A + L (D max(n.l, 0) + S max(n.h, 0)^s)
Rgbd by_hand(const Case& of) {
  const Vec3d n = normalize(of.normals[0] + of.normals[1] + of.normals[2]), l = normalize(of.to_light),
              h = l + Vec3d(0, 0, of.eye_z > 0 ? 1 : -1);
  // Light from straight ahead of the eye has no direction halfway, and no highlight.
  const double n_h = h == Vec3d(0.0) ? 0 : std::max(dot(n, normalize(h)), 0.0);
  return Rgbd(ambient) + light * (std::max(dot(n, l), 0.0) * diffuse + Rgbd(specular * std::pow(n_h, shininess)));
}

Rgbd rendered(const Result<SceneDocument>& document) {
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  const auto rendering = render(document->scene);
  REQUIRE(rendering);
  return rendering->film_of<double>().at(0, 0);
}

void check_near(const Rgbd& a, const Rgbd& b) {
  INFO(a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z);
  CHECK(length(a - b) <= 1e-12);
}

const Vec3d up{0, 0, 1}, down{0, 0, -1}, tilted{0.6, 0, 0.8}, across{1, 0, 0}, against{0.48, 0.36, -0.8};

const std::vector<Case> cases{
    {"along the winding", {up, up, up}, {3, 0, 4}, 4},
    {"tilted", {tilted, tilted, tilted}, {3, 0, 4}, 4},
    {"three directions", {tilted, {0, 0.6, 0.8}, up}, {1, 2, 2}, 4},
    {"across", {across, across, across}, {3, 0, 4}, 4},
    {"across, lit from behind", {across, across, across}, {3, 0, -4}, 4},
    {"against the winding, lit from the eye's side", {against, against, against}, {3, 0, 4}, 4},
    {"against the winding, lit from behind", {down, down, down}, {0, 0, -1}, 4},
    {"against the winding, lit from behind, aslant", {against, against, against}, {3, 0, -4}, 4},
    {"seen from behind", {tilted, tilted, tilted}, {3, 0, 4}, -4},
    {"against the winding, seen from behind", {against, against, against}, {1, 2, -2}, -4},
    {"two along and one against", {up, up, against}, {3, 0, 4}, 4},
};

}  // namespace

TEST_CASE("given normals are used as they are, in the course format and in our own") {
  for (const Case& each : cases) {
    for (const bool winds_back : {false, true}) {
      INFO(each.what << (winds_back ? ", wound the other way" : ""));
      const Rgbd expected = by_hand(each);
      check_near(rendered(parse_test_format(course_text(each, winds_back), "sail.test")), expected);
      check_near(rendered(parse_scene(own_text(each, winds_back), "sail.toml")), expected);
    }
  }
}

TEST_CASE("what is dull is lit as its normals say, too") {
  // Without a highlight: a light behind shows only where the normal turns to it.
  Case dull{"", {down, down, down}, {0, 0, -1}, 4};
  std::string text = course_text(dull, false);
  text.replace(text.find("specular 0.5 0.5 0.5"), 20, "specular 0 0 0      ");
  check_near(rendered(parse_test_format(text, "sail.test")), Rgbd(ambient) + light * diffuse);
  dull.to_light = up;
  text = course_text(dull, false);
  text.replace(text.find("specular 0.5 0.5 0.5"), 20, "specular 0 0 0      ");
  check_near(rendered(parse_test_format(text, "sail.test")), Rgbd(ambient));
}

TEST_CASE("normals go with the matrix of their triangle, mirrors included") {
  // Mirrored in x, the tilted normal leans to the other side; the corners' weights stay.
  Case mirrored{"", {Vec3d(-0.6, 0, 0.8), Vec3d(-0.6, 0, 0.8), Vec3d(-0.6, 0, 0.8)}, {3, 0, 4}, 4};
  Case given = mirrored;
  given.normals = {tilted, tilted, tilted};
  std::string text = course_text(given, false);
  text.insert(text.find("trinormal"), "scale -1 1 1\n");
  check_near(rendered(parse_test_format(text, "sail.test")), by_hand(mirrored));
  // Stretched in x by 3, (0.6, 0, 0.8) becomes (0.2, 0, 0.8).
  text = course_text(given, false);
  text.insert(text.find("trinormal"), "scale 3 1 1\n");
  mirrored.normals.fill(normalize(Vec3d(0.2, 0, 0.8)));
  check_near(rendered(parse_test_format(text, "sail.test")), by_hand(mirrored));
}

TEST_CASE("a material that faces the ray turns given normals to the winding's side and then to the eye, as ever") {
  Case against_it{"", {down, down, down}, {3, 0, 4}, 4};
  std::string text = own_text(against_it, false);
  text.replace(text.find(", normal = \"fixed\""), 18, "");
  Case facing = against_it;
  facing.normals.fill(up);
  check_near(rendered(parse_scene(text, "sail.toml")), by_hand(facing));
}
