#include "study/subjects.h"

#include <cmath>
#include <numbers>

namespace raywalk::study {

namespace {

constexpr double eye_above = 2, half_width = 1;

Material glow() {
  Material material;
  material.diffuse = Rgbd(0.0);
  material.emission = Rgbd(1.0);
  return material;
}

Subject subject(std::string name, bool only_edges) {
  Subject made{std::move(name), {}, {}, only_edges};
  made.scene.render.integrator = Integrator::distributed;
  made.scene.camera = looking_down(0, 0, eye_above, half_width);
  return made;
}

}  // namespace

Subject smooth_subject() {
  const Vec3d lamp(0.31, 0.17, 0.8);
  Subject made = subject("smooth", false);
  Material matte;
  matte.diffuse = Rgbd(1.0);
  made.scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matte}};
  made.scene.lights = {{"Lamp", Rgbd(1.0), PointLight{lamp, {0, 0, 1}}}};
  made.truth = [lamp](const Rectangle& pixel) { return solid_angle(pixel, lamp.x, lamp.y, lamp.z) / pixel.area(); };
  return made;
}

Subject edge_subject() {
  const double radius = 0.8137;
  Subject made = subject("edge", true);
  made.scene.objects = {{"Disk", Disk<double>{{0, 0, 0}, {0, 0, 1}, radius}, glow()}};
  made.truth = [radius](const Rectangle& pixel) { return disk_area_in(pixel, radius) / pixel.area(); };
  return made;
}

Subject lens_subject() {
  // From the point X of the floor, in focus, through the point l of the lens, a ray passes half way at (X + l) / 2.
  const double edge = 0.03, aperture = 0.5, far = 1e3;
  Subject made = subject("lens", true);
  made.scene.camera.aperture = aperture;
  made.scene.objects = {{"Sheet", Triangle<double>{{edge, -far, 1}, {far, 0, 1}, {edge, far, 1}}, glow()}};
  made.truth = [=](const Rectangle& pixel) {
    // The integral, from 1 on down, of the share of a unit disk beyond x: what a lens sees past an edge.
    const auto sum = [](double e) {
      if (e >= 1) return 0.0;
      if (e <= -1) return e;
      const double root = std::sqrt(1 - e * e);
      return e / 2 - (e * std::asin(e) + root - root * root * root / 3) / std::numbers::pi;
    };
    const double low = (2 * edge - pixel.x1) / aperture, high = (2 * edge - pixel.x0) / aperture;
    return (sum(high) - sum(low)) / (high - low);
  };
  return made;
}

Scene glowing_room(double albedo, bool mirror, int round) {
  Scene scene;
  Material wall;
  wall.emission = Rgbd(1.0);
  wall.diffuse = Rgbd(mirror ? 0.0 : albedo);
  wall.reflection = Rgbd(mirror ? albedo : 0.0);
  scene.objects = {{"Room", Sphere<double>{{0, 0, 0}, 2}, wall}};
  scene.camera.eye = {drawn_for(round, 0) - 0.5, drawn_for(round, 1) - 0.5, drawn_for(round, 2) - 0.5};
  scene.camera.look_at = {1, 0.2, 0.1};
  scene.camera.screen = {1, 2.0, 1};
  scene.render.integrator = mirror ? Integrator::whitted : Integrator::path;
  return scene;
}

Rectangle pixel_at(int column, int row, int edge) {
  const double width = 2 * half_width / edge;
  return {-half_width + width * column, -half_width + width * (column + 1), half_width - width * (row + 1),
          half_width - width * row};
}

void for_each_pixel(const Subject& subject, const Film<double>& film,
                    const std::function<void(double shown, double truth)>& visit) {
  const int edge = film.size().width;
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      const double truth = subject.truth(pixel_at(column, row, edge));
      constexpr double rounding = 1e-12;
      if (subject.only_edges && (truth <= rounding || truth >= 1 - rounding)) continue;
      visit(film.at(column, row).x, truth);
    }
}

}  // namespace raywalk::study
