// A picture by beams as polygons: they are the picture, whole and once, with the colours that pixels have.

#include "render/beam_drawing.h"

#include <cmath>
#include <sstream>

#include "support/catch.h"

using namespace raywalk;

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

/// The area of all polygons of all paths.
double area_of_paths(const std::string& svg) {
  double sum = 0;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 4)) {
    const std::string d = svg.substr(at + 4, svg.find('"', at + 4) - at - 4);
    std::vector<Vec2d> corners;
    std::istringstream in(d);
    for (char command = 0; in >> command;) {
      if (command == 'Z') {
        double twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
        sum += std::abs(twice) / 2;
        corners.clear();
        continue;
      }
      Vec2d corner;
      REQUIRE(in >> corner.x >> corner.y);
      corners.push_back(corner);
    }
  }
  return sum;
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
  CHECK(area_of_paths(drawing->svg) == Approx(100 * 70).epsilon(1e-4));
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
