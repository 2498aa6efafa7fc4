// A picture by beams as polygons: they are the picture, whole and once, with the colours that pixels have.

#include "render/beam_drawing.h"

#include "image/srgb.h"
#include "io/scene_file.h"
#include "trace/beam_scene.h"
#include "trace/space_beam_kernel.h"
#include "trace/window_places.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "support/catch.h"

using namespace raywalk;
using raywalk::test::inside_by;

namespace {

Scene two_boxes() {
  Scene scene;
  scene.title = "Two <boxes> & a floor";
  scene.background = {0.2, 0.4, 0.8};
  scene.ambient = Rgbd(1.0);
  scene.camera.eye = {0, -6, 1};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.camera.screen = {1, 1, 1};
  scene.render.integrator = Integrator::beams;
  Material red, grey;
  red.ambient = {1, 0, 0};
  red.diffuse = Rgbd(0.0);
  grey.ambient = Rgbd(0.1);
  grey.diffuse = Rgbd(0.8);
  scene.lights = {{"Lamp", Rgbd(0.9), PointLight{{-2, -3, 4}, {}}}};
  scene.objects = {{"Red Box", Box<double>{{-1, -1, -1}, {0, 0, 0.4}}, red},
                   {"Grey Box", Box<double>{{0.2, 0, -1}, {1.2, 1, 0}}, grey},
                   {"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, grey}};
  return scene;
}

/// A polygon of a drawing, and its colour, encoded: 0 to 1.
struct Painted {
  WindowPiece corners;
  Rgbd colour{0.0};
};

double attribute_hex(const std::string& text, std::size_t at) {
  return std::stoi(text.substr(at, 2), nullptr, 16) / 255.0;
}

/// What stands between two marks, and where it ends.
std::string between(const std::string& text, const std::string& before, const std::string& after, std::size_t from) {
  const std::size_t start = text.find(before, from) + before.size();
  return text.substr(start, text.find(after, start) - start);
}

/// The polygons of a path.
std::vector<WindowPiece> polygons_of(const std::string& path) {
  std::vector<WindowPiece> polygons(1);
  std::istringstream in(path);
  for (char command = 0; in >> command;) {
    if (command == 'Z') {
      polygons.emplace_back();
      continue;
    }
    Vec2d corner;
    REQUIRE(in >> corner.x >> corner.y);
    polygons.back().push_back(corner);
  }
  polygons.pop_back();
  return polygons;
}

/// All that is drawn with strokes, in their order; or without, above that.
std::vector<Painted> painted(const std::string& svg, bool strokes) {
  std::vector<std::vector<Painted>> paths;
  for (std::size_t at = svg.find("<path "); at != std::string::npos; at = svg.find("<path ", at + 1)) {
    const std::string path = between(svg, "<path ", "/>", at);
    REQUIRE(between(path, "id=\"p", "\"", 0) == std::to_string(paths.size()));
    const std::size_t hex = path.find("color=\"#") + 8;
    const Rgbd colour(attribute_hex(path, hex), attribute_hex(path, hex + 2), attribute_hex(path, hex + 4));
    paths.emplace_back();
    for (const WindowPiece& polygon : polygons_of(between(path, " d=\"", "\"", 0)))
      paths.back().push_back({polygon, colour});
  }
  std::vector<Painted> all;
  std::size_t used = 0;
  for (std::size_t at = svg.find("<use "); at != std::string::npos; at = svg.find("<use ", at + 1), ++used) {
    const auto index = strokes ? used : std::stoul(between(svg, "href=\"#p", "\"", at));
    all.insert(all.end(), paths.at(index).begin(), paths.at(index).end());
  }
  CHECK(used == paths.size());
  return all;
}

double area_of_all(const std::vector<Painted>& all) {
  double sum = 0;
  for (const Painted& each : all) sum += area_of(each.corners);
  return sum;
}

/// What the last of those that lie there shows.
Rgbd colour_at(const std::vector<Painted>& all, const Vec2d& place) {
  const auto last =
      std::find_if(all.rbegin(), all.rend(), [&](const Painted& one) { return inside_by(one.corners, place) >= 0; });
  REQUIRE(last != all.rend());
  return last->colour;
}

/// How a program draws it in a pixel: each covers of what is there as much as it covers of the pixel.
Rgbd composed(const std::vector<Painted>& all, const Rgbd& below, const Vec2d& pixel) {
  Rgbd colour = below;
  for (const Painted& each : all) {
    WindowPiece piece = each.corners;
    for (const WindowLine& side : {WindowLine{1, 0, -pixel.x}, WindowLine{-1, 0, pixel.x + 1},
                                   WindowLine{0, 1, -pixel.y}, WindowLine{0, -1, pixel.y + 1}})
      if (!piece.empty()) piece = halves_of(piece, side).inside;
    if (piece.size() >= 3) colour += area_of(piece) * (each.colour - colour);
  }
  return colour;
}

/// A wall seen straight on, a unit of which is a pixel.
Scene wall(ImageSize size) {
  Scene scene;
  scene.ambient = Rgbd(1.0);
  scene.camera.eye = {0, -10, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.camera.screen = {10, static_cast<double>(size.width), 1};
  scene.render.integrator = Integrator::beams;
  scene.encoding = Encoding::truncated;
  Material white;
  white.ambient = Rgbd(0.8);
  white.diffuse = Rgbd(0.0);
  scene.objects = {{"Wall", Plane<double>{{0, 0, 0}, {0, -1, 0}}, white}};
  return scene;
}

/// Of places all over the picture, the share where its drawing is not within 16 of 255 of what is seen there.
double share_drawn_wrong(const Scene& scene, ImageSize size) {
  BeamDrawingSettings settings;
  settings.size = size;
  const auto drawing = beam_drawing(scene, settings);
  REQUIRE(drawing.has_value());
  std::vector<Painted> all = painted(drawing->svg, false);
  std::erase_if(all, [](const Painted& each) { return area_of(each.corners) < 1e-3; });  // rounded to a line or a point
  const World<double> world(scene);
  const BeamFaces faces = beam_faces_of(scene);
  const RayGenerator<double> camera(scene, size, size);
  int places = 0, wrong = 0;
  for (double y = 0.37; y < size.height; y += 0.81)
    for (double x = 0.29; x < size.width; x += 0.77) {
      // A window as small as a point sees one part.
      const auto seen = parts_of_picture(world, faces, camera, {x, y}, {x + 1e-6, y + 1e-6});
      if (seen.size() != 1) continue;
      const Rgbd drawn = colour_at(all, {x, y}), right = seen[0].shade;
      double most = 0;
      for (int i = 0; i < 3; ++i)
        most = std::max(most, std::abs(255 * drawn[i] - to_byte(static_cast<float>(right[i]), scene.encoding)));
      ++places;
      wrong += most > 16 ? 1 : 0;
    }
  CHECK(places > size.width * size.height);
  return static_cast<double>(wrong) / places;
}

}  // namespace

TEST_CASE("a drawing by beams is polygons that are the picture, by objects with their names") {
  BeamDrawingSettings settings;
  settings.size = {100, 70};
  double done = 0;
  settings.progress = [&](const Progress& progress) { done = progress.done; };
  const auto drawing = beam_drawing(two_boxes(), settings);
  REQUIRE(drawing.has_value());
  CHECK(drawing->finished);
  CHECK(done == 1);
  CHECK(drawing->polygons > 50);
  for (const bool strokes : {true, false})
    CHECK(area_of_all(painted(drawing->svg, strokes)) == Approx(100 * 70).epsilon(1e-4));
  CHECK(drawing->svg.find("viewBox=\"0 0 100 70\"") != std::string::npos);
  CHECK(drawing->svg.find("<title>Two &lt;boxes&gt; &amp; a floor</title>") != std::string::npos);
  for (const char* name : {"Red Box", "Grey Box", "Floor"})
    CHECK(drawing->svg.find("<g><title>" + std::string(name) + "</title>") != std::string::npos);
  // The red box has one colour, and needs no more polygons than its outline does.
  CHECK(drawing->svg.find("color=\"#ff0000\"") != std::string::npos);
  // Where colours change they are cut finer, and less so where that is asked for.
  settings.tolerance = 60;
  CHECK(beam_drawing(two_boxes(), settings)->polygons < drawing->polygons);
}

TEST_CASE("a drawing shows the squares of a checker, however small beside what is looked at as a whole") {
  Scene scene = wall({64, 64});
  const double square = 1.92;
  Checker checker;
  checker.even = Rgbd(1.0), checker.odd = Rgbd(0.0), checker.size = square;
  scene.objects[0].material.checker = checker;
  BeamDrawingSettings settings;
  settings.size = {64, 64};
  const auto drawing = beam_drawing(scene, settings);
  REQUIRE(drawing.has_value());
  const std::vector<Painted> all = painted(drawing->svg, false);
  const World<double> world(scene);
  const BeamFaces faces = beam_faces_of(scene);
  const RayGenerator<double> camera(scene, settings.size, settings.size);
  int light = 0, places = 0;
  for (double y = 0.37; y < 64; y += 0.81)
    for (double x = 0.29; x < 64; x += 0.77) {
      // A window as small as a point sees one part.
      const auto seen = parts_of_picture(world, faces, camera, {x, y}, {x + 1e-6, y + 1e-6});
      const Vec2d near(x, y);
      if (seen.size() != 1) continue;
      if (std::abs(std::remainder(x - 32, square)) < 0.01 || std::abs(std::remainder(y - 32, square)) < 0.01) continue;
      ++places;
      light += seen[0].shade.x > 0.4 ? 1 : 0;
      REQUIRE(std::abs(colour_at(all, near).x - seen[0].shade.x) < 0.01);
    }
  CHECK(places > 6000);
  CHECK(std::abs(light - places / 2) < places / 20);
}

TEST_CASE("a drawing shows what is small between the middles of beams, and edges where they are") {
  // A spot of light on a wall, 3 pixels in radius, lies far from the middles of wide beams.
  Scene scene = wall({64, 64});
  scene.objects[0].material.ambient = Rgbd(0.0);
  scene.objects[0].material.diffuse = Rgbd(0.9);
  for (const Vec2d& place : {Vec2d(3.5, -4.5), Vec2d(8, 8), Vec2d(-13, 21), Vec2d(-24, -24)}) {
    SpotLight spot;
    spot.position = {place.x, -30, place.y};
    spot.look_at = {place.x, 0, place.y};
    spot.angle = spot.inner_angle = 2 * std::atan(0.1) * 180 / pi_v<double>;
    scene.lights = {{"Lamp", Rgbd(1.0), spot}};
    CHECK(share_drawn_wrong(scene, {64, 64}) < 0.0035);  // half of what the spot is of the wall
  }
  for (const char* name : {"flat_glass", "beams"}) {
    const auto read = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml");
    REQUIRE(read);
    INFO(name);
    CHECK(share_drawn_wrong(read->scene, {160, 120}) < 0.012);
  }
}

TEST_CASE("wires of a drawing darken a pixel by as much as they cover of it") {
  Scene scene = wall({64, 64});
  Material dark;
  dark.ambient = Rgbd(0.1);
  dark.diffuse = Rgbd(0.0);
  const double thickness = 0.2;
  for (int i = 0; i < 10; ++i) {
    const double x = -28.9 + 6.3 * i;
    scene.objects.push_back({"Wire " + std::to_string(i), Box<double>{{x, -1e-3, -40}, {x + thickness, 0, 40}}, dark});
  }
  BeamDrawingSettings settings;
  settings.size = {64, 64};
  const auto drawing = beam_drawing(scene, settings);
  REQUIRE(drawing.has_value());
  // With strokes the wall comes last, so that it is what shows where neighbours leave a seam.
  const std::vector<Painted> below = painted(drawing->svg, true), all = painted(drawing->svg, false);
  CHECK(below.back().colour.x == Approx(0.8).margin(0.005));
  CHECK(below.front().colour.x == Approx(0.1).margin(0.005));
  const double right = 0.8 - 0.7 * thickness * 10 / 64;
  double mean = 0;
  for (int column = 0; column < 64; ++column) mean += composed(all, Rgbd(0.8), {column, 13}).x / 64;
  CHECK(mean == Approx(right).margin(0.002).epsilon(0));
}

TEST_CASE("a drawing that is cancelled is none") {
  Stopper stopper;
  stopper.raised = true;
  BeamDrawingSettings settings;
  settings.stop = Stop(stopper);
  const auto drawing = beam_drawing(two_boxes(), settings);
  REQUIRE(drawing.has_value());
  CHECK_FALSE(drawing->finished);
  CHECK(drawing->svg.empty());
}
