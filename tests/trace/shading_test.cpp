// Each term of the sum by itself, against the formula.

#include "support/catch.h"
#include "trace/pictures.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// The plane z = 0, seen and lit from above.
Scene table(const Material& material, const std::vector<Light>& lights) {
  Scene scene;
  scene.objects = {object("Table", Plane<double>{}, material)};
  scene.lights = lights;
  return scene;
}

Material lambert(const Rgbd& diffuse = Rgbd(1.0)) {
  Material material;
  material.diffuse = diffuse;
  return material;
}

bool near(const Rgbd& a, const Rgbd& b, double tolerance = 1e-14) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("a ray that meets nothing brings the background") {
  Scene scene;
  scene.background = {0.25, 0.5, 0.75};
  CHECK(shade_along(scene, {0, 0, 0}, {1, 2, 3}) == scene.background);
}

TEST_CASE("ambient light and emission") {
  Material material = black();
  material.ambient = {0.5, 0.25, 1};
  material.emission = {1, 2, 3};
  Scene scene = table(material, {});
  scene.ambient = {0.5, 1, 2};
  CHECK(shade_along(scene, {0, 0, 5}, {1, 0, 0}) == Rgbd(1.25, 2.25, 5));
}

TEST_CASE("diffuse light falls with the cosine, whatever the distance, unless attenuated") {
  for (const double height : {0.5, 3.0, 40.0}) {
    const Scene scene = table(lambert({1, 0.5, 0.25}), {lamp({height, 0, height}, 2)});
    const Rgbd expected = 2 * std::sqrt(0.5) * Rgbd(1, 0.5, 0.25);
    CHECK(near(shade_along(scene, {-3, 1, 2}, {0, 0, 0}), expected));
  }
  const Scene sunny = table(lambert(), {{"Sun", {1, 2, 3}, DirectionalLight{{0, 3, 4}}}});
  CHECK(near(shade_along(sunny, {5, 5, 5}, {7, 1, 0}), 0.8 * Rgbd(1, 2, 3)));
}

TEST_CASE("lights add up, each in its colour") {
  const Light red{"Red", {1, 0, 0}, PointLight{{0, 0, 3}, {}}}, blue{"Blue", {0, 0, 1}, PointLight{{0, 0, 5}, {}}};
  CHECK(near(shade_along(table(lambert(), {red, blue}), {1, 1, 1}, {0, 0, 0}), {1, 0, 1}));
}

TEST_CASE("attenuation is 1 / (c0 + c1 r + c2 r^2)") {
  const auto lit = [](const Attenuation& attenuation, double r) {
    return shade_along(table(lambert(), {lamp({0, 0, r}, 1, attenuation)}), {1, 1, 1}, {0, 0, 0}).x;
  };
  CHECK(lit({1, 0, 0}, 3) == Approx(1));
  CHECK(lit({2, 0, 0}, 3) == Approx(0.5));
  CHECK(lit({0, 1, 0}, 3) == Approx(1.0 / 3));
  CHECK(lit({0, 0, 1}, 3) == Approx(1.0 / 9));
  CHECK(lit({0.5, 0.25, 2}, 3) == Approx(1 / (0.5 + 0.75 + 18)));
  CHECK(lit({0, 0, 1}, 1e-6) == Approx(1e12));
}

TEST_CASE("the highlight is Blinn's: ks (n.h)^s, not weighted by n.l") {
  Material shiny = black();
  shiny.specular = {0.5, 0.25, 1};
  shiny.shininess = GENERATE(0.0, 1.0, 10.0, 200.0);
  const Vec3d eye(-4, 0, 3), light(1, 2, 2);
  const Vec3d v = normalize(eye), l = normalize(light), h = normalize(v + l);
  const Rgbd expected = std::pow(h.z, shiny.shininess) * 3 * shiny.specular;
  CHECK(near(shade_along(table(shiny, {lamp(light, 3)}), eye, {0, 0, 0}), expected, 1e-13));
  // Brightest in the mirror's direction.
  CHECK(near(shade_along(table(shiny, {lamp({4, 0, 3}, 3)}), eye, {0, 0, 0}), 3.0 * shiny.specular, 1e-12));
}

TEST_CASE("the shading normal faces the ray: both sides of a plane are lit from their own side") {
  const Scene above = table(lambert(), {lamp({0, 0, 2})}), below = table(lambert(), {lamp({0, 0, -2})});
  CHECK(near(shade_along(above, {1, 0, 1}, {0, 0, 0}), Rgbd(1.0)));
  CHECK(near(shade_along(above, {1, 0, -1}, {0, 0, 0}), Rgbd(0.0)));
  CHECK(near(shade_along(below, {1, 0, -1}, {0, 0, 0}), Rgbd(1.0)));
  CHECK(near(shade_along(below, {1, 0, 1}, {0, 0, 0}), Rgbd(0.0)));
}

TEST_CASE("a ray that just touches a sphere from outside sees its outside") {
  Scene scene;
  scene.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 1}, lambert())};
  scene.lights = {lamp({0, 4, 0})};
  // Along y = 1 the ray touches the sphere in (0, 1, 0), right below the light.
  CHECK(near(shade_along(scene, {-5, 1, 0}, {5, 1, 0}), Rgbd(1.0)));
}

TEST_CASE("what stands before a light shadows, what stands behind it or is not between does not") {
  Scene scene = table(lambert(), {lamp({0, 0, 4})});
  const auto with = [&](const Vec3d& centre) {
    Scene changed = scene;
    changed.objects.push_back(object("Blocker", Sphere<double>{centre, 0.5}, black()));
    return shade_along(changed, {3, 0, 1}, {0, 0, 0}).x;
  };
  CHECK(with({0, 0, 2}) == 0);
  CHECK(with({0, 0, 5}) == Approx(1));
  CHECK(with({2, 0, 3}) == Approx(1));
  CHECK(with({0, 0, 4.2}) == 0);  // the light is inside it
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};
  CHECK(with({0, 0, 1e6}) == 0);
}

TEST_CASE("the squares of a checker change at whole multiples, on both sides of zero") {
  Material material = lambert({0.5, 0.5, 0.5});
  material.ambient = Rgbd(0.25);
  material.checker = Checker{{1, 0.5, 0.25}, {0, 0, 1}, 2};
  Scene scene = table(material, {lamp({0, 0, 1e9})});
  const Rgbd even = 0.75 * Rgbd(1, 0.5, 0.25), odd = 0.75 * Rgbd(0, 0, 1);
  const auto square = [&](double x, double y) { return shade_along(scene, {x, y, 1}, {x, y, 0}); };
  for (int i = -4; i < 4; ++i)
    for (int j = -4; j < 4; ++j) {
      CAPTURE(i, j);
      const Rgbd expected = (i + j) % 2 == 0 ? even : odd;
      CHECK(near(square(2 * i + 0.01, 2 * j + 0.01), expected, 1e-9));
      CHECK(near(square(2 * i + 1.99, 2 * j + 1.99), expected, 1e-9));
    }
  // The pattern hangs on the plane's point.
  std::get<Plane<double>>(scene.objects[0].shape).point = {2, 0, 0};
  CHECK(near(square(0.5, 0.5), odd, 1e-9));
}

TEST_CASE("the reflected shade is weighted by kr and mirrored about the normal") {
  Material mirror = black();
  mirror.reflection = {0.5, 0.25, 1};
  Scene scene = table(mirror, {});
  Material glow = black();
  glow.emission = Rgbd(8.0);
  scene.objects.push_back(object("Lamp", Sphere<double>{{3, 0, 3}, 0.1}, glow));
  CHECK(shade_along(scene, {-3, 0, 3}, {0, 0, 0}) == Rgbd(4, 2, 8));
  scene.background = Rgbd(1.0);
  CHECK(shade_along(scene, {-3, 0, 3.3}, {0, 0, 0}) == Rgbd(0.5, 0.25, 1));
}

TEST_CASE("the refracted shade is weighted by kt and bent by Snell's law") {
  Material water = black();
  water.transmission = {0.5, 0.25, 1};
  water.ior = 1.25;
  Scene scene = table(water, {});
  // Below the surface a ray with sine 3/5 goes on with 12/25.
  Material glow = black();
  glow.emission = Rgbd(8.0);
  const double sine = 0.48, cosine = std::sqrt(1 - sine * sine);
  scene.objects.push_back(object("Lamp", Sphere<double>{{10 * sine, 0, -10 * cosine}, 1e-6}, glow));
  CHECK(shade_along(scene, {-3, 0, 4}, {0, 0, 0}) == Rgbd(4, 2, 8));
  // And the way back, from below.
  scene.objects[1].shape = Sphere<double>{{-3, 0, 4}, 1e-6};
  CHECK(shade_along(scene, {10 * sine, 0, -10 * cosine}, {0, 0, 0}) == Rgbd(4, 2, 8));
}

TEST_CASE("float and double agree on what a single ray brings") {
  const Scene scene = busy_scene();
  int compared = 0;
  const auto coarse = picture<float>(scene, 45, 31);
  const auto fine = picture<double>(scene, 45, 31);
  int far = 0;
  for (std::size_t i = 0; i < coarse.pixels.size(); ++i) {
    ++compared;
    far += length(Rgbd(coarse.pixels[i]) - fine.pixels[i]) > 1e-3;
  }
  // A few pixels lie on edges and fall on either side.
  CHECK(compared == 45 * 31);
  CHECK(far <= compared / 100);
}
