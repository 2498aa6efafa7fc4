// Scenes that a mouse or a malicious file can make: nothing is NaN, nothing crashes, and the books still balance.

#include "shape/numbers.h"
#include "support/catch.h"
#include "trace/pictures.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

template <class T>
void trace_cleanly(const std::string& name, const Scene& scene) {
  INFO(name << (sizeof(T) == 4 ? ", float" : ", double"));
  const auto traced = picture<T>(scene, 21, 15);
  CHECK(traced.statistics.not_finite == 0);
  int negative = 0;
  for (const Rgb<T>& pixel : traced.pixels) negative += !(pixel.x >= 0 && pixel.y >= 0 && pixel.z >= 0);
  CHECK(negative == 0);
  std::uint64_t formed = 0;
  for (const auto rays : traced.statistics.rays) formed += rays;
  CHECK(formed == traced.statistics.ends(Ending::hit) + traced.statistics.ends(Ending::missed) +
                      traced.statistics.ends(Ending::blocked) + traced.statistics.ends(Ending::reached_light));
}

void trace_cleanly(const std::string& name, const Scene& scene) {
  trace_cleanly<double>(name, scene);
  trace_cleanly<float>(name, scene);
}

Sphere<double>& sphere(Scene& scene, int i) {
  return std::get<Sphere<double>>(scene.objects[static_cast<std::size_t>(i)].shape);
}
Vec3d& light(Scene& scene) { return std::get<PointLight>(scene.lights[0].kind).position; }

constexpr int matte = 0, mirror = 1, glass = 2, crystal = 3, floor_plane = 4;

}  // namespace

TEST_CASE("the eye on and inside things") {
  for (const int which : {matte, mirror, glass}) {
    Scene scene = busy_scene();
    sphere(scene, which).centre = scene.camera.eye;
    trace_cleanly("eye in the centre", scene);
    sphere(scene, which).centre = scene.camera.eye + Vec3d(sphere(scene, which).radius, 0, 0);
    trace_cleanly("eye on the surface, looking in", scene);
    sphere(scene, which).centre = scene.camera.eye - Vec3d(sphere(scene, which).radius, 0, 0);
    trace_cleanly("eye on the surface, looking out", scene);
    sphere(scene, which).radius = 1e-9;
    sphere(scene, which).centre = scene.camera.eye;
    trace_cleanly("eye in a speck", scene);
  }
  Scene scene = busy_scene();
  scene.camera.eye.z = -1;
  scene.camera.look_at.z = -1;
  trace_cleanly("eye on the floor, looking along it", scene);
  scene = busy_scene();
  const Vec2d corner = std::get<Prism<double>>(scene.objects[crystal].shape).corners[0];
  scene.camera.eye = {corner, 0};
  trace_cleanly("eye in a corner of the prism", scene);
  scene.camera.eye = {corner, 0.6};
  trace_cleanly("eye in a corner of its cap", scene);
}

TEST_CASE("lights on and inside things") {
  for (const int which : {matte, mirror, glass}) {
    Scene scene = busy_scene();
    light(scene) = sphere(scene, which).centre;
    trace_cleanly("light in the centre", scene);
    light(scene) = sphere(scene, which).centre + Vec3d(0, sphere(scene, which).radius, 0);
    trace_cleanly("light on the surface", scene);
    light(scene) = scene.camera.eye;
    trace_cleanly("light in the eye", scene);
  }
  Scene scene = busy_scene();
  light(scene) = {0, 0, -1};
  trace_cleanly("light on the floor", scene);
  std::get<PointLight>(scene.lights[0].kind).attenuation = {0, 0, 1};
  trace_cleanly("light on the floor, by the inverse square", scene);
  light(scene) = {std::get<Prism<double>>(scene.objects[crystal].shape).corners[1], 0};
  trace_cleanly("light in a corner of the prism", scene);
  scene.lights.assign(3, scene.lights[0]);
  trace_cleanly("three lights in one place", scene);
}

TEST_CASE("a light exactly where rays hit") {
  // The middle ray meets the floor in the light itself.
  Scene scene = busy_scene();
  scene.camera.look_at = {1, 0.5, -1};
  light(scene) = {1, 0.5, -1};
  for (const Attenuation& attenuation : {Attenuation{1, 0, 0}, Attenuation{0, 1, 0}, Attenuation{0, 0, 1}}) {
    std::get<PointLight>(scene.lights[0].kind).attenuation = attenuation;
    trace_cleanly("light where the middle ray hits the floor", scene);
  }
}

TEST_CASE("objects dragged onto each other") {
  Scene scene = busy_scene();
  for (int i : {matte, mirror, glass}) sphere(scene, i) = Sphere<double>{{0, 0, 0}, 1};
  trace_cleanly("three spheres in one place", scene);
  sphere(scene, glass).radius = 1 + 0x1p-52;
  trace_cleanly("spheres that differ in the last bit", scene);
  sphere(scene, glass).centre = {2, 0, 0};
  trace_cleanly("spheres that touch", scene);
  scene = busy_scene();
  Object second = scene.objects[crystal];
  second.name = "Second";
  scene.objects.push_back(second);
  trace_cleanly("prisms in one place", scene);
  // Faces that partly coincide: moved along an edge, and stacked.
  Prism<double>& prism = std::get<Prism<double>>(scene.objects.back().shape);
  const Vec2d edge = prism.corners[1] - prism.corners[0];
  for (Vec2d& corner : prism.corners) corner += 0.3 * edge;
  trace_cleanly("prisms with a common face plane", scene);
  scene = busy_scene();
  std::get<Prism<double>>(scene.objects[crystal].shape).height = 2;
  trace_cleanly("a prism that stands on the floor", scene);
  Object copy = scene.objects[floor_plane];
  copy.name = "Floor 2";
  copy.material = scene.objects[glass].material;
  scene.objects.push_back(copy);
  trace_cleanly("two floors in one place", scene);
}

TEST_CASE("huge, tiny and far scenes") {
  for (const double scale : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    Scene scene = busy_scene();
    scene.camera.eye *= scale;
    scene.camera.look_at *= scale;
    for (Object& one : scene.objects) {
      if (auto* ball = std::get_if<Sphere<double>>(&one.shape)) ball->centre *= scale, ball->radius *= scale;
      if (auto* plane = std::get_if<Plane<double>>(&one.shape)) plane->point *= scale;
      if (auto* prism = std::get_if<Prism<double>>(&one.shape)) {
        prism->height *= scale;
        for (Vec2d& corner : prism->corners) corner *= scale;
      }
    }
    light(scene) *= scale;
    trace_cleanly("scaled by " + std::to_string(scale), scene);
  }
  for (const double shift : {1e3, 1e6, 1e9}) {
    Scene scene = busy_scene();
    const Vec3d by(shift, -shift, 0);
    scene.camera.eye += by;
    scene.camera.look_at += by;
    for (Object& one : scene.objects) {
      if (auto* ball = std::get_if<Sphere<double>>(&one.shape)) ball->centre += by;
      if (auto* plane = std::get_if<Plane<double>>(&one.shape)) plane->point += by;
      if (auto* prism = std::get_if<Prism<double>>(&one.shape))
        for (Vec2d& corner : prism->corners) corner += plan(by);
    }
    light(scene) += by;
    trace_cleanly<double>("moved by " + std::to_string(shift), scene);
    if (shift <= 1e6) trace_cleanly<float>("moved by " + std::to_string(shift), scene);
  }
}

TEST_CASE("extreme materials") {
  Scene scene = busy_scene();
  for (const double ior : {1e-3, 0.5, 1.0, 1 + 0x1p-52, 1e3}) {
    for (Object& one : scene.objects) one.material.ior = ior;
    trace_cleanly("ior " + std::to_string(ior), scene);
  }
  scene = busy_scene();
  for (const double shininess : {0.0, 1e-3, 1e3, 1e6}) {
    for (Object& one : scene.objects) one.material.shininess = shininess;
    trace_cleanly("shininess " + std::to_string(shininess), scene);
  }
  for (const double size : {1e-6, 1e6}) {
    for (Object& one : scene.objects) one.material.checker = Checker{Rgbd(1.0), Rgbd(0.0), size};
    trace_cleanly("squares of " + std::to_string(size), scene);
  }
}

TEST_CASE("a corner of mirrors, and the way between parallel ones") {
  Material shine = black();
  shine.reflection = Rgbd(1.0);
  shine.emission = Rgbd(0.125);
  Scene scene;
  scene.limits.depth = 50;
  scene.camera.eye = {0, 0, 0};
  scene.camera.look_at = {3, 3, 0};  // straight into the corner
  scene.camera.screen = {1, 0.001, 21};
  scene.background = Rgbd(1.0);
  scene.objects = {object("East", Plane<double>{{3, 0, 0}, {-1, 0, 0}}, shine),
                   object("North", Plane<double>{{0, 3, 0}, {0, -1, 0}}, shine)};
  trace_cleanly("two mirrors", scene);
  // Whatever the column, two reflections turn the ray back the way it came; the corner itself may take one.
  for (const Rgbd& pixel : picture<double>(scene, 21, 15).pixels)
    if (std::abs(pixel.x - 1.25) > 1e-12 && std::abs(pixel.x - 1.125) > 1e-12) FAIL("shade " << pixel.x);
}

TEST_CASE("random scenes of everything, thrown together") {
  Numbers next(77);
  for (int round = 0; round < 60; ++round) {
    Scene scene = busy_scene();
    const std::vector<Object> kinds = scene.objects;
    scene.objects.clear();
    const double grid = round % 2 ? 0.5 : 1e-4;  // coarse: much coincides
    const auto place = [&] {
      const Vec3d p = next.in_box<double>(3);
      return Vec3d(std::round(p.x / grid) * grid, std::round(p.y / grid) * grid, std::round(p.z / grid) * grid);
    };
    for (int i = 0; i < 12; ++i) {
      Object one = kinds[static_cast<std::size_t>(next.integer(0, 5))];
      one.name += std::to_string(i);
      if (auto* ball = std::get_if<Sphere<double>>(&one.shape))
        ball->centre = place(), ball->radius = next.integer(1, 3) * 0.5;
      if (auto* plane = std::get_if<Plane<double>>(&one.shape)) plane->point = place();
      if (auto* prism = std::get_if<Prism<double>>(&one.shape)) {
        const Vec2d at = plan(place());
        prism->corners = {at, at + Vec2d(1, 0), at + Vec2d(1, 1.5), at + Vec2d(0.5, 0.5), at + Vec2d(0, 1.5)};
        prism->height = next.integer(1, 4) * 0.5;
      }
      scene.objects.push_back(one);
    }
    scene.camera.eye = place();
    scene.camera.look_at = scene.camera.eye + Vec3d(1, 0.25, 0.125);
    light(scene) = place();
    trace_cleanly("round " + std::to_string(round), scene);
  }
}

TEST_CASE("random scenes of lengths from 1e-15 to 1e15, all that the reader lets pass") {
  Numbers next(78);
  for (int round = 0; round < 300; ++round) {
    Scene scene = busy_scene();
    const std::vector<Object> kinds = scene.objects;
    scene.objects.clear();
    // Some scenes have one scale, some have all of them.
    const int scale = next.integer(-15, 15), spread = round % 3 == 0 ? 30 : round % 3;
    const auto size = [&] { return std::pow(10.0, std::clamp(scale + next.integer(-spread, spread), -15, 15)); };
    const auto place = [&] { return Vec3d(next.real() * size(), next.real() * size(), next.real() * size()); };
    for (int i = 0; i < 8; ++i) {
      Object one = kinds[static_cast<std::size_t>(next.integer(0, 5))];
      one.name += std::to_string(i);
      if (auto* ball = std::get_if<Sphere<double>>(&one.shape)) *ball = {place(), size()};
      if (auto* plane = std::get_if<Plane<double>>(&one.shape)) *plane = {place(), place()};
      if (auto* prism = std::get_if<Prism<double>>(&one.shape)) {
        const Vec2d at = plan(place());
        const double s = size();
        prism->corners = {at, at + s * Vec2d(1, 0), at + s * Vec2d(1, 1.5), at + s * Vec2d(0.5, 0.5)};
        prism->height = size();
        if (!why_not_polygon(prism->corners).empty()) continue;
      }
      if (i == 0) scene.camera.look_at = i % 2 ? place() : Vec3d(next.real() * size(), next.real() * size(), 0);
      scene.objects.push_back(one);
    }
    scene.camera.eye = scene.camera.look_at + Vec3d(size(), size(), 0);
    if (scene.camera.eye == scene.camera.look_at) continue;
    light(scene) = place();
    std::get<PointLight>(scene.lights[0].kind).attenuation = {0, 0, next.real(0.1, 1)};
    trace_cleanly("round " + std::to_string(round), scene);
  }
}
