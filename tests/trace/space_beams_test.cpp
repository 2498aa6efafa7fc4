// Beams in space: the parts of a pixel are the pixel, each sees what rays see, and they cover what exact areas say.

#include "trace/space_beam_kernel.h"

#include "scene/beam_limits.h"
#include "trace/beam_scene.h"
#include "trace/pictures.h"
#include "trace/window_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "support/catch.h"
#include "support/effort.h"

namespace raywalk::space_beams_test {

using namespace raywalk::test;

namespace {

Material glowing(const Rgbd& colour, double mirror = 0) {
  Material material;
  material.ambient = colour;
  material.diffuse = Rgbd(0.0);
  material.specular = Rgbd(0.0);
  material.reflection = Rgbd(mirror);
  return material;
}

Material matt(double diffuse) {
  Material material = glowing(Rgbd(0.0));
  material.diffuse = Rgbd(diffuse);
  return material;
}

Scene empty_scene() {
  Scene scene;
  scene.ambient = Rgbd(1.0);
  scene.background = Rgbd(0.0);
  scene.camera.eye = {0, -5, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.camera.screen = {1, 2, 1};
  scene.render.integrator = Integrator::beams;
  scene.limits.depth = 4;
  scene.limits.threshold = 0;
  return scene;
}

/// Every pixel's parts, against rays through `fine` x `fine` places of it. Returns how many places are compared.
int compare_with_rays(const Scene& scene, int width, int height, int fine, double tolerance = 1e-9) {
  REQUIRE(why_no_space_beams(scene).empty());
  const World<double> world(scene);
  const BeamFaces faces = beam_faces_of(scene);
  Scene by_rays = scene;
  by_rays.render.integrator = Integrator::whitted;
  const auto rays = picture_by<double>(by_rays, width * fine, height * fine, {},
                                       [](const auto& its, const auto& camera, const auto& block, const auto& put) {
                                         return trace(its, camera, block, put);
                                       });
  const ImageSize size{width, height};
  const RayGenerator<double> camera(scene, size, size);
  int compared = 0, wrong = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Vec2d from(column, row);
      const std::vector<ShadedPiece<double>> parts = parts_of_picture(world, faces, camera, from, from + Vec2d(1, 1));
      double whole = 0;
      for (const ShadedPiece<double>& part : parts) {
        whole += area_of(part.window);
        const Rgbd& shade = part.shade;
        wrong += !(std::isfinite(shade.x) && std::isfinite(shade.y) && std::isfinite(shade.z));
      }
      if (!(std::abs(whole - 1) < 1e-12)) {
        UNSCOPED_INFO("pixel " << column << ", " << row << " has parts of " << whole);
        ++wrong;
      }
      for (int y = 0; y < fine; ++y)
        for (int x = 0; x < fine; ++x) {
          const Vec2d place = from + Vec2d(x + 0.5, y + 0.5) / static_cast<double>(fine);
          const auto part = std::find_if(parts.begin(), parts.end(), [&](const ShadedPiece<double>& each) {
            return inside_by(each.window, place) > 1e-7;
          });
          if (part == parts.end()) continue;  // on an edge
          ++compared;
          const Rgbd ray = rays.at(column * fine + x, row * fine + y), difference = part->shade - ray;
          const double off = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
          if (off <= tolerance) continue;
          if (++wrong < 5)
            UNSCOPED_INFO("at " << place.x << ", " << place.y << ": " << part->shade.x << " " << part->shade.y << " "
                                << part->shade.z << ", by a ray " << ray.x << " " << ray.y << " " << ray.z);
        }
    }
  CHECK(wrong == 0);
  return compared;
}

template <class T>
Picture<T> picture_of(const Scene& scene, int width, int height, Sampling sampling = {}) {
  const BeamFaces faces = beam_faces_of(scene);
  return picture_by<T>(scene, width, height, sampling,
                       [&](const auto& world, const auto& camera, const auto& block, const auto& put) {
                         return trace_space_beams(world, faces, camera, block, put);
                       });
}

Triangle<double> random_triangle(Draw& next, double size) {
  const Vec3d middle = next.place(1.5);
  return {middle + next.place(size), middle + next.place(size), middle + next.place(size)};
}

}  // namespace

TEST_CASE("the parts of a pixel are the pixel, and each sees what rays see, through faces that cross each other") {
  for (int seed = 0; seed < rounds(8); ++seed) {
    CAPTURE(seed);
    Draw next(seed);
    Scene scene = empty_scene();
    for (int i = 0; i < 30; ++i)
      scene.objects.push_back(
          {"T" + std::to_string(i), random_triangle(next, 0.8), glowing({next(0, 1), next(0, 1), next(0, 1)})});
    CHECK(compare_with_rays(scene, 16, 12, 9) > 16 * 12 * 60);
  }
}

TEST_CASE("flat mirrors show by beams what rays see in them, mirrors in mirrors too") {
  for (int seed = 0; seed < rounds(8); ++seed) {
    CAPTURE(seed);
    Draw next(100 + seed);
    Scene scene = empty_scene();
    for (int i = 0; i < 14; ++i)
      scene.objects.push_back({"T" + std::to_string(i), random_triangle(next, 0.9),
                               glowing({next(0, 1), next(0, 1), next(0, 1)}, i % 2 == 0 ? 0.6 : 0)});
    scene.objects.push_back({"Wall", Box<double>{{-3, 2, -3}, {3, 2.5, 3}}, glowing({0.1, 0, 0}, 0.7)});
    scene.objects.push_back({"Floor", Plane<double>{{0, 0, -1.2}, {0.1, 0, 1}}, glowing({0, 0.1, 0}, 0.5)});
    CHECK(compare_with_rays(scene, 12, 9, 9) > 12 * 9 * 50);
  }
}

TEST_CASE("a disc is one face, whose corners lie on its rim, wherever it is moved") {
  Scene scene = empty_scene();
  scene.objects = {{"Disc", Disk<double>{{1, 2, 3}, {0, 0, -2}, 0.7}, glowing({1, 0, 0})}};
  scene.objects[0].transform = {{Scale{{2, 1, 1}}}, {Translate{{0, 0.5, 0.25}}}};
  const BeamFaces faces = beam_faces_of(scene);
  REQUIRE(faces.size() == 1);
  const BeamFace& face = faces[0];
  CHECK(face.is_flat);
  CHECK(face.outline.size() == 64);
  double twice = 0;
  detail::for_each_side(face, [&](const Vec3d& from, const Vec3d& to) {
    twice += dot(cross(from, to), face.plane.normal);
    CHECK(face.plane.above(from) == Approx(0).epsilon(0).margin(1e-12));
    CHECK(length((from - Vec3d(2, 2.5, 3.25)) / Vec3d(2, 1, 1)) == Approx(0.7).epsilon(1e-12));
  });
  CHECK(twice / 2 == Approx(2 * 32 * 0.49 * std::sin(2 * std::numbers::pi / 64)).epsilon(1e-12));
}

TEST_CASE("the shadows of points and directions are cut where rays find their edges") {
  for (int seed = 0; seed < rounds(8); ++seed) {
    CAPTURE(seed);
    Draw next(200 + seed);
    Scene scene = empty_scene();
    scene.lights = {{"Sun", Rgbd(0.7), DirectionalLight{{0.3, -0.4, 1}}}};
    for (int i = 0; i < 14; ++i)
      scene.objects.push_back({"T" + std::to_string(i), random_triangle(next, 0.7), matt(next(0.2, 1))});
    scene.objects.push_back({"Floor", Plane<double>{{0, 0, -1.2}, {0, 0, 1}}, matt(0.8)});
    scene.objects.push_back({"Box", Box<double>{{-0.5, -0.5, -1.2}, {0.4, 0.4, -0.2}}, matt(0.5)});
    CHECK(compare_with_rays(scene, 12, 9, 9) > 12 * 9 * 50);
  }
}

TEST_CASE("the squares of a checker are cut, in mirrors too, and far away they have their mean") {
  Scene scene = empty_scene();
  scene.camera.eye = {0.3, -3, 4};
  scene.camera.screen = {1, 0.9, 1};
  Material squares = glowing(Rgbd(1.0), 0.2);
  squares.checker = Checker{Rgbd(0.9), {0.1, 0.3, 0.2}, 0.57};
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, squares},
                   {"Box", Box<double>{{-1, 0, -1}, {0, 1, 0.3}}, squares},
                   {"Tile", Triangle<double>{{0.5, -0.5, -0.7}, {1.9, 0.4, -0.2}, {0.6, 0.8, 0.6}}, squares},
                   {"Mirror", Box<double>{{-9, 3, -9}, {9, 3.1, 9}}, glowing({0.1, 0, 0}, 0.8)}};
  CHECK(compare_with_rays(scene, 16, 12, 9) > 16 * 12 * 60);
  // Towards the horizon.
  scene.objects.resize(1);
  scene.objects[0].material.reflection = Rgbd(0.0);
  scene.camera.eye = {0, -4, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 2, 1};
  const auto far = picture_of<double>(scene, 9, 9);
  for (int column = 0; column < 9; ++column)
    CHECK(far.at(column, 4).y == Approx((0.9 + 0.3) / 2 / 2).epsilon(0).margin(1e-9));
  // Squares so small and far from the first that their numbers have no next ones.
  scene.camera.eye = {50, 46, 0};
  scene.camera.look_at = {50, 50, 0};
  scene.objects[0].material.checker->size = 1e-15;
  const auto dust = picture_of<double>(scene, 9, 9);
  for (int column = 0; column < 9; ++column)
    CHECK(dust.at(column, 7).y == Approx((0.9 + 0.3) / 2).epsilon(0).margin(1e-9));
}

TEST_CASE("inside of what is round its walls hide the lights outside, and no light that is inside, too") {
  Scene scene = empty_scene();
  scene.camera.eye = {0, -0.5, 0};
  scene.objects = {{"Room", Sphere<double>{{0, 0, 0}, 2}, matt(1)}};
  const auto brightest_and_darkest = [&](const AnyLight& kind) {
    scene.lights = {{"Lamp", Rgbd(1.0), kind}};
    const auto picture = picture_of<double>(scene, 16, 16);
    double most = 0, least = infinity<double>;
    for (const Rgbd& pixel : picture.pixels) most = std::max(most, pixel.x), least = std::min(least, pixel.x);
    return std::pair(most, least);
  };
  CHECK(brightest_and_darkest(PointLight{{-5, 0, 0}, {}}).first == 0);
  CHECK(brightest_and_darkest(RectangleLight{{-5, -1, -1}, {0, 2, 0}, {0, 0, 2}, 1, {}}).first == 0);
  CHECK(brightest_and_darkest(PointLight{{0.3, 0.2, 0.1}, {}}).second > 0.1);
  CHECK(brightest_and_darkest(RectangleLight{{0.3, -0.1, -0.1}, {0, 0.2, 0}, {0, 0, 0.2}, 1, {}}).second > 0.1);
}

TEST_CASE("a point light's shadow on a floor is as large as that of its triangle") {
  Scene scene = empty_scene();
  scene.camera.eye = {0, 0, 6};
  scene.camera.up = {0, 1, 0};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, 2}, {}}}};
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(1)},
                   {"Blocker", Triangle<double>{{-0.5, -0.5, 1}, {0.6, -0.4, 1}, {0.1, 0.5, 1}}, glowing(Rgbd(0.0))}};
  const World<double> world(scene);
  const BeamFaces faces = beam_faces_of(scene);
  const ImageSize size{1, 1};
  const RayGenerator<double> camera(scene, size, size);
  double dark = 0;
  for (const ShadedPiece<double>& part : parts_of_picture(world, faces, camera, {0, 0}, {1, 1}))
    if (part.object == 0 && part.shade.x == 0) dark += area_of(part.window);
  // The window is 2 x 2 at distance 1, the floor at 6; eye and lamp stand above one another.
  const double shadow = 4 * 0.52, unit = 12.0 * 12.0;
  // The triangle itself, seen from 6 above at height 1, covers this much of the floor.
  const double hidden = 0.52 * (6.0 / 5) * (6.0 / 5);
  CHECK(dark == Approx((shadow - hidden) / unit).epsilon(1e-12));
}

TEST_CASE("a triangle covers of each pixel what clipping its corners says") {
  Draw next(7);
  for (int round = 0; round < rounds(40); ++round) {
    Scene scene = empty_scene();
    const Triangle<double> triangle{
        {next(-2, 2), 0, next(-2, 2)}, {next(-2, 2), next(0, 1), next(-2, 2)}, {next(-2, 2), 0, next(-2, 2)}};
    scene.objects = {{"Triangle", triangle, glowing(Rgbd(1.0))}};
    constexpr int side = 8;
    const auto seen = picture_of<double>(scene, side, side);
    // On the screen in pixels: 5 before the origin, and as wide as it is far.
    std::vector<Vec2d> corners;
    for (const Vec3d& at : {triangle.a, triangle.b, triangle.c})
      corners.push_back({side / 2.0 * (1 + at.x / (at.y + 5)), side / 2.0 * (1 - at.z / (at.y + 5))});
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        std::vector<Vec2d> clipped = corners;
        const auto clip = [&](auto inside) {
          std::vector<Vec2d> kept;
          for (std::size_t i = 0; i < clipped.size(); ++i) {
            const Vec2d a = clipped[i], b = clipped[(i + 1) % clipped.size()];
            const double at_a = inside(a), at_b = inside(b);
            if (at_a >= 0) kept.push_back(a);
            if ((at_a < 0) != (at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
          }
          clipped = kept;
        };
        clip([&](const Vec2d& p) { return p.x - column; });
        clip([&](const Vec2d& p) { return column + 1 - p.x; });
        clip([&](const Vec2d& p) { return p.y - row; });
        clip([&](const Vec2d& p) { return row + 1 - p.y; });
        CHECK(seen.at(column, row).x == Approx(area_of(clipped)).margin(2e-9));
      }
  }
}

TEST_CASE("hard views: an eye in a face's plane, on an edge, a mirror seen end on, faces in one place, the horizon") {
  Scene scene = empty_scene();
  SECTION("an eye in a plane and on an edge") {
    scene.objects = {
        {"Level", Polygon<double>{{{-1, -6, 0}, {1, -6, 0}, {1, 2, 0}, {-1, 2, 0}}, {}}, glowing({1, 0, 0})},
        {"From the eye", Triangle<double>{{0, -5, 0}, {1, 0, 1}, {-1, 0, 1}}, glowing({0, 1, 0})},
        {"Behind", Box<double>{{-2, 1, -2}, {2, 2, 2}}, glowing({0, 0, 1})}};
  }
  SECTION("a mirror seen end on") {
    scene.objects = {
        {"Mirror", Polygon<double>{{{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}, {}}, glowing({1, 0, 0}, 1)},
        {"Behind", Box<double>{{-2, 2, -2}, {2, 3, 2}}, glowing({0, 0, 1}, 0.5)}};
  }
  SECTION("faces in one place") {
    const Box<double> box{{-0.7, 0, -0.7}, {0.7, 1, 0.7}};
    scene.objects = {{"First", box, glowing({1, 0, 0}, 0.3)},
                     {"Second", box, glowing({0, 1, 0})},
                     {"On it", Polygon<double>{{{-0.3, 0, -0.3}, {0.3, 0, -0.3}, {0.3, 0, 0.3}, {-0.3, 0, 0.3}}, {}},
                      glowing({0, 0, 1})}};
  }
  SECTION("the horizon, and a box that stands on the floor") {
    scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, glowing({1, 0, 0}, 0.4)},
                     {"Box", Box<double>{{-0.5, 0, -1}, {0.5, 1, 0.5}}, glowing({0, 1, 0})},
                     {"Ceiling", Plane<double>{{0, 0, 3}, {0, 0, -1}}, glowing({0, 0, 1})}};
  }
  SECTION("edges through the corners of pixels") {
    // Pixels are a quarter of the half at distance 5.
    scene.objects = {
        {"Square", Polygon<double>{{{-1.25, 0, -1.25}, {1.25, 0, -1.25}, {1.25, 0, 1.25}, {-1.25, 0, 1.25}}, {}},
         glowing({1, 0, 0})},
        {"Beside", Polygon<double>{{{1.25, 0, -1.25}, {2.5, 0, -1.25}, {2.5, 0, 1.25}, {1.25, 0, 1.25}}, {}},
         glowing({0, 1, 0})}};
  }
  compare_with_rays(scene, 8, 8, 9);
  compare_with_rays(scene, 7, 5, 9);
}

TEST_CASE("a rectangle of light behind an edge is seen as the closed form says") {
  // From the floor's middle, of a light 2 x 2 at height 2 the half x > edge is hidden by a wall at height 1.
  Scene scene = empty_scene();
  scene.camera.eye = {0, 0, 0.5};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.screen = {1, 1e-6, 1};
  for (const double edge : {-0.4, 0.0, 0.1, 0.35}) {
    CAPTURE(edge);
    scene.lights = {{"Sky", Rgbd(1.0), RectangleLight{{-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, 8, {}}}};
    scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(1)},
                     {"Wall", Polygon<double>{{{edge, -9, 1}, {9, -9, 1}, {9, 9, 1}, {edge, 9, 1}}, {}}, matt(0)}};
    const auto seen = picture_of<double>(scene, 1, 1);
    // The mean of cos over the open part of the light, times its share of the light: by a fine sum.
    double expected = 0;
    constexpr int fine = 400;
    for (int i = 0; i < fine; ++i)
      for (int j = 0; j < fine; ++j) {
        const double x = -1 + 2 * (i + 0.5) / fine, y = -1 + 2 * (j + 0.5) / fine;
        if (x < 2 * edge) expected += 2 / std::sqrt(x * x + y * y + 4) / (fine * fine);
      }
    CHECK(seen.at(0, 0).x == Approx(expected).epsilon(4e-3));
  }
}

TEST_CASE("a ball is its polygons to an eighth of a percent of its radius, and shaded as a ball") {
  Scene scene = empty_scene();
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, 1.5}, glowing(Rgbd(1.0))}};
  const auto seen = picture_of<double>(scene, 1, 1);
  // The disc that a ball is seen as at distance 1, of a window 2 x 2.
  const double radius = 1.5 / std::sqrt(25 - 1.5 * 1.5), disc = std::numbers::pi * radius * radius / 4;
  CHECK(seen.at(0, 0).x < disc);
  CHECK(seen.at(0, 0).x > disc * (1 - 2 * 0.0013) * (1 - 2 * 0.0013));
}

TEST_CASE("which pixels are traced together, and in which precision, changes no edge") {
  Draw next(12);
  Scene scene = empty_scene();
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{1, -3, 3}, {}}}};
  for (int i = 0; i < 12; ++i)
    scene.objects.push_back({"T" + std::to_string(i), random_triangle(next, 0.9), matt(0.7)});
  const auto whole = picture_of<double>(scene, 12, 12);
  const auto in_float = picture_of<float>(scene, 12, 12);
  for (std::size_t i = 0; i < whole.pixels.size(); ++i)
    CHECK(std::abs(whole.pixels[i].x - static_cast<double>(in_float.pixels[i].x)) < 1e-4);
  const BeamFaces faces = beam_faces_of(scene);
  const World<double> world(scene);
  const ImageSize size{12, 12};
  const RayGenerator<double> camera(scene, size, size);
  PixelBlock block;
  block.column_begin = 5, block.column_end = 6, block.row_begin = 7, block.row_end = 8;
  static_cast<void>(trace_space_beams<double>(world, faces, camera, block, [&](const Pixel& pixel, const Rgbd& shade) {
    CHECK(shade == whole.at(pixel.column, pixel.row));
  }));
}

TEST_CASE("several beams of a pixel see together what one does where shades do not change") {
  Draw next(13);
  Scene scene = empty_scene();
  for (int i = 0; i < 8; ++i)
    scene.objects.push_back({"T" + std::to_string(i), random_triangle(next, 0.9), glowing(Rgbd(next(0, 1)))});
  const auto one = picture_of<double>(scene, 6, 6);
  const BeamFaces faces = beam_faces_of(scene);
  const World<double> world(scene);
  const ImageSize size{6, 6};
  for (const int samples : {2, 3, 4, 6, 7}) {
    CAPTURE(samples);
    std::vector<Rgbd> sums(36, Rgbd(0.0)), squares(36, Rgbd(0.0));
    const RayGenerator<double> camera(scene, size, size, {samples});
    PixelBlock block;
    block.column_end = 6, block.row_end = 6, block.samples = samples;
    static_cast<void>(
        trace_space_beams<double>(world, faces, camera, block, [&](const Pixel& pixel, const Rgbd& shade) {
          const auto at = static_cast<std::size_t>(pixel.row * 6 + pixel.column);
          sums[at] += shade / static_cast<double>(samples), squares[at] += shade * shade / static_cast<double>(samples);
        }));
    int differ = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      CHECK(sums[i].x == Approx(one.pixels[i].x).epsilon(0).margin(1e-9));
      differ += squares[i].x > sums[i].x * sums[i].x + 1e-6;
    }
    CHECK(differ > 5);  // each sees a part of its own
  }
}

TEST_CASE("watching beams in space changes no bit, and tells of parts that are the pixel") {
  Draw next(14);
  Scene scene = empty_scene();
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{1, -3, 3}, {}}},
                  {"Panel", Rgbd(0.5), RectangleLight{{-1, -1, 3}, {1, 0, 0}, {0, 1, 0}, 2, {}}}};
  for (int i = 0; i < 12; ++i)
    scene.objects.push_back({"T" + std::to_string(i), random_triangle(next, 0.9), matt(0.7)});
  scene.objects[0].material.reflection = scene.objects[1].material.reflection = Rgbd(0.6);
  scene.objects.push_back({"Chrome", Sphere<double>{{0.5, 0, 0}, 0.6}, glowing(Rgbd(0.1), 0.8)});
  const auto whole = picture_of<double>(scene, 6, 6);
  const BeamFaces faces = beam_faces_of(scene);
  Recording recording;
  const auto watched = picture_by<double>(
      scene, 6, 6, {}, [&](const auto& world, const auto& camera, const auto& block, const auto& put) {
        return trace_space_beams_watched(world, faces, camera, block, put, recording);
      });
  CHECK(same_bits(whole, watched));
  CHECK(same_counts(whole.statistics, watched.statistics));
  // Of each beam, the parts are what it is of its pixel.
  std::map<int, double> areas;
  for (const BeamFormed& formed : recording.all<BeamFormed>()) areas[formed.ray] = formed.end - formed.begin;
  for (const BeamCut& cut : recording.all<BeamCut>()) {
    double sum = 0;
    for (const BeamPiece& piece : cut.pieces) sum += piece.coverage;
    CHECK(sum == Approx(areas.at(cut.ray)).epsilon(1e-9));
  }
  CHECK(areas.size() > 36);
}

TEST_CASE("watched beams say by how much the shades near the border of a part differ from its one") {
  const auto off = [](const Scene& scene) {
    const BeamFaces faces = beam_faces_of(scene);
    Recording recording;
    static_cast<void>(picture_by<double>(
        scene, 1, 1, {}, [&](const auto& world, const auto& camera, const auto& block, const auto& put) {
          return trace_space_beams_watched(world, faces, camera, block, put, recording);
        }));
    double most = 0;
    for (const PartAdded& added : recording.all<PartAdded>()) most = std::max(most, added.off);
    return most;
  };
  Scene scene = empty_scene();
  Material white = matt(1);
  scene.objects = {{"Wall", Plane<double>{{0, 0, 0}, {0, -1, 0}}, white}};
  scene.lights = {{"Sun", Rgbd(0.8), DirectionalLight{{0, -1, 0}}}};
  CHECK(off(scene) == 0);
  // The edge of a shadow is cut.
  scene.objects.push_back({"Blind", Box<double>{{0.5, -9, -20}, {30, -8, 20}}, white});
  CHECK(off(scene) == 0);
  scene.objects.pop_back();
  // The rim of a spot is not, nor are squares beyond counting.
  SpotLight spot;
  spot.position = {0, -5, 0}, spot.look_at = {0, 0, 0}, spot.angle = spot.inner_angle = 90;
  scene.lights = {{"Spot", Rgbd(0.8), spot}};
  CHECK(off(scene) == Approx(0.8));
  scene.lights = {{"Sun", Rgbd(0.8), DirectionalLight{{0, -1, 0}}}};
  scene.objects[0].material.checker = Checker{Rgbd(1.0), Rgbd(0.0), 0.17};
  CHECK(off(scene) == Approx(0.4));
}

TEST_CASE("a scene looks alike by beams however large it is") {
  const auto at_scale = [](double scale) {
    Scene scene = empty_scene();
    scene.camera.eye = {-6 * scale, 0, scale};
    scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-3 * scale, 4 * scale, 6 * scale}, {}}}};
    Material squares = matt(0.7);
    squares.checker = Checker{{0.9, 0.9, 0.9}, {0.1, 0.1, 0.1}, scale};
    scene.objects = {{"Floor", Plane<double>{{0, 0, -scale}, {0, 0, 1}}, squares},
                     {"Box", Box<double>{{-scale, -scale, -scale}, {scale, scale, scale}}, matt(0.7)}};
    return picture_of<double>(scene, 16, 12);
  };
  const auto small = at_scale(1);
  for (const double scale : {0x1p-40, 0x1p37, 0x1p45}) {
    CAPTURE(scale);
    const auto scaled = at_scale(scale);
    for (std::size_t i = 0; i < small.pixels.size(); ++i)
      CHECK(scaled.pixels[i].x == Approx(small.pixels[i].x).epsilon(0).margin(1e-6));
  }
}

TEST_CASE("beams through an empty scene see the background") {
  Scene scene = empty_scene();
  scene.background = {0.1, 0.2, 0.3};
  CHECK(picture_of<double>(scene, 2, 2).at(1, 1) == scene.background);
}

TEST_CASE("what beams cannot follow is refused by name") {
  Scene scene = empty_scene();
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, 1}, matt(1)}};
  CHECK(why_no_space_beams(scene).empty());
  scene.objects[0].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  CHECK(why_no_space_beams(scene) == "Ball moves");
  scene.objects[0].motion.clear();
  scene.objects[0].material.normal = ShadingNormal::fixed;
  CHECK(why_no_space_beams(scene) == "Ball has a fixed normal");
  scene.objects[0].material.normal = ShadingNormal::facing;
  scene.objects[0].shape = Quadric<double, QuadricKind::elliptic_paraboloid>{};
  CHECK(why_no_space_beams(scene) == "Ball is endless");
}

TEST_CASE("beams count the faces that polygons and prisms are cut into") {
  // A comb whose teeth all end at other heights: each of them is cut at all of them.
  const auto comb = [](int corners) {
    Prism<double> prism;
    for (int i = 0; i < corners; ++i) prism.corners.push_back({1.0 * i, i % 2 == 0 ? -1 - 0.001 * i : 1 + 0.001 * i});
    prism.corners.push_back({1.0 * corners, -10});
    prism.corners.push_back({-1, -10});
    return prism;
  };
  Scene scene = empty_scene();
  scene.objects = {{"Comb", comb(600), matt(1)}};
  REQUIRE(beam_faces_of(scene).size() > 80000);
  CHECK(why_no_space_beams(scene).empty());
  scene.objects[0].shape = comb(1000);
  REQUIRE(beam_faces_of(scene).size() > 200000);
  CHECK(why_no_space_beams(scene) == "the scene has more than 200,000 faces, and Comb the most of them");
  Polygon<double> polygon;
  for (const Vec2d& corner : comb(1000).corners) polygon.outline.push_back({corner, 0});
  scene.objects[0].shape = polygon;
  CHECK(beam_faces_of(scene).size() < 200000);  // along its first side they are fewer
  CHECK(why_no_space_beams(scene).empty());
  // Many corners alone are no reason; nor are many triangles of one face each.
  Prism<double> round;
  for (int i = 0; i < 5000; ++i) round.corners.push_back({std::cos(i * 6.283 / 5000), std::sin(i * 6.283 / 5000)});
  scene.objects = {{"Round", round, matt(1)}};
  CHECK(why_no_space_beams(scene).empty());
  scene.objects.assign(40000, {"Triangle", Triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, matt(1)});
  CHECK(why_no_space_beams(scene).empty());
}

}  // namespace raywalk::space_beams_test
