// What several integrators can show they show alike, where one of them did not: normals of smooth meshes that bend
// light out again, lamps inside of what absorbs, the highlights of rough mirrors, spheres of light.

#include "io/scene_file.h"
#include "render/render.h"
#include "support/catch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace raywalk;

namespace {

std::vector<Rgbd> pixels_by(const std::string& text, Integrator integrator, int samples = 1) {
  auto document = parse_scene(text, "agree.toml");
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  document->scene.render.integrator = integrator;
  RenderSettings settings;
  settings.sampling.per_pixel = samples;
  const auto rendering = render(document->scene, settings);
  REQUIRE(rendering);
  const Film<double>& film = rendering->film_of<double>();
  std::vector<Rgbd> pixels;
  for (int y = 0; y < film.size().height; ++y)
    for (int x = 0; x < film.size().width; ++x) pixels.push_back(film.at(x, y));
  return pixels;
}

Rgbd mean(const std::vector<Rgbd>& pixels) {
  Rgbd sum(0.0);
  for (const Rgbd& pixel : pixels) sum += pixel;
  return sum / static_cast<double>(pixels.size());
}

/// The largest difference of a channel in any pixel.
double farthest(const std::vector<Rgbd>& a, const std::vector<Rgbd>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Rgbd apart = absolute(a[i] - b[i]);
    most = std::max({most, apart.x, apart.y, apart.z});
  }
  return most;
}

void check_share(const Rgbd& found, const Rgbd& expected, double error) {
  CAPTURE(found.x, found.y, found.z, expected.x, expected.y, expected.z);
  for (int channel = 0; channel < 3; ++channel) CHECK(found[channel] == Approx(expected[channel]).epsilon(error));
}

}  // namespace

TEST_CASE("a smooth normal that would bend light back into the glass bends it out by all integrators") {
  // A sheet seen from inside at 69 degrees, where its own normal would reflect all, and the tilted one would not.
  const std::string sheet = R"(
background = 0.1
camera = { eye = [-2.8, 0, -1.075], look_at = [0, 0, 0], up = [0, 1, 0], fov = 0.02 }
image = { width = 3, height = 3 }
limits = { depth = 20 }
sky = { type = "gradient", horizon = [1, 0.2, 0], zenith = [0, 0.2, 1] }
[[object]]
name = "Sheet"
type = "mesh"
vertices = [[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]]
normals = [[0.5, 0, 0.866], [0.5, 0, 0.866], [0.5, 0, 0.866], [0.5, 0, 0.866]]
triangles = [[0, 1, 2], [0, 2, 3]]
material = { diffuse = 0, transmission = 1, ior = 1.5 }
)";
  const std::vector<Rgbd> rays = pixels_by(sheet, Integrator::whitted);
  CHECK(mean(rays).x > 0.3);  // the sky, not the background inside
  for (const Integrator other : {Integrator::path, Integrator::photons, Integrator::beams, Integrator::pencils})
    CHECK(farthest(pixels_by(sheet, other), rays) < 1e-3);
}

TEST_CASE("a lamp inside of what absorbs is dimmed by all of it, and by what absorbs alone, to cones too") {
  const auto scene = [](const std::string& eye, const std::string& lamp, const std::string& objects) {
    return "background = 0\nambient = 0\n[camera]\neye = " + eye +
           "\nlook_at = [0, 0, 0]\nfov = 20\n[image]\nwidth = 9\nheight = 9\n[limits]\ndepth = 12\n" +
           "[[light]]\nname = \"Lamp\"\ntype = \"point\"\nposition = " + lamp + "\nattenuation = [1, 0.1, 0.2]\n" +
           objects;
  };
  const auto glass = [](const std::string& name, const std::string& where, const std::string& absorption) {
    return "[[object]]\nname = \"" + name + "\"\ntype = \"sphere\"\n" + where +
           "\n[object.material]\ndiffuse = 0\ntransmission = [0.9, 1, 0.95]\nior = 1\nshadow = \"filtered\"\n" +
           "absorption = " + absorption + "\n";
  };
  const std::string ball =
                        "[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0.5, 0, 0]\nradius = 0.4\n"
                        "[object.material]\ndiffuse = 0.8\nspecular = 0\n",
                    floor =
                        "[[object]]\nname = \"Floor\"\ntype = \"plane\"\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\n"
                        "[object.material]\ndiffuse = 0.7\nspecular = 0\n";
  // All in one; the lamp in two, one inside of the other; the lamp where two overlap.
  for (const std::string& text : {scene("[-1, 0, 0.2]", "[0, 1.5, 0.3]",
                                        ball + glass("Sea", "centre = [0, 0, 0]\nradius = 5", "[0.3, 0.6, 0.1]")),
                                  scene("[-4, 0, 0.2]", "[0, 0, 2.5]",
                                        floor + glass("Outer", "centre = [0, 0, 2.5]\nradius = 0.8", "[0.5, 1, 2]") +
                                            glass("Inner", "centre = [0, 0, 2.5]\nradius = 0.4", "[2, 0.1, 0.5]")),
                                  scene("[-4, 0, 0.2]", "[0, 0, 2.5]",
                                        floor + glass("One", "centre = [0, 0, 2.2]\nradius = 0.8", "[0.5, 1, 2]") +
                                            glass("Other", "centre = [0, 0, 2.6]\nradius = 0.6", "[2, 0.1, 0.5]"))}) {
    const Rgbd expected = mean(pixels_by(text, Integrator::whitted, 16));
    CHECK(expected.y > 1e-3);
    check_share(mean(pixels_by(text, Integrator::cones)), expected, 0.03);
  }
}

TEST_CASE("a rough mirror shows the highlight of a lamp to beams as to rays, and the shadow of what is before it") {
  const std::string lit = R"(
background = 0
ambient = 0
camera = { eye = [-5, 0, 0], look_at = [0, 0, 0], fov = 25 }
image = { width = 15, height = 15 }
[[light]]
name = "Lamp"
type = "point"
position = [-4, 3, 0]
[[object]]
name = "Ball"
type = "sphere"
centre = [0, 0, 0]
radius = 1
material = { diffuse = 0, reflection = 0.8, roughness = 0.2 }
)";
  const std::string shaded = lit + R"(
[[object]]
name = "Shade"
type = "sphere"
centre = [-2.2, 1.4, 0]
radius = 0.2
material = { diffuse = 0 }
)";
  const Rgbd expected = mean(pixels_by(lit, Integrator::whitted, 64));
  CHECK(expected.x > 1e-3);
  check_share(mean(pixels_by(lit, Integrator::beams)), expected, 0.03);
  const Rgbd in_shadow = mean(pixels_by(shaded, Integrator::whitted, 64));
  CHECK(in_shadow.x < 0.7 * expected.x);
  CHECK(std::abs(mean(pixels_by(shaded, Integrator::beams)).x - in_shadow.x) < 0.03 * expected.x);
}

TEST_CASE("a lamp as near as it is wide lights by all of it that is above the horizon, not by its middle") {
  // A square of a matt floor, seen from above, where its light is the same to 0.1%; what is seen is the mean over the
  // lamp of kd cos / r^2.
  struct Lamp {
    const char* kind;
    double expected;
  };
  const Lamp lamp =
      GENERATE(Lamp{"\"rectangle\"\ncorner = [-1, -1, 0.6]\nu = [2, 0, 0]\nv = [0, 2, 0]", 0.6609},  // above it
               Lamp{"\"rectangle\"\ncorner = [1, -1, -1]\nu = [0, 2, 0]\nv = [0, 0, 2]",
                    0.2 * 2 * (std::asinh(1) - std::asinh(std::sqrt(0.5)))},                  // half below
               Lamp{"\"sphere\"\nposition = [1.2, 0, 0]\nradius = 0.6", 0.0772},              // half below
               Lamp{"\"sphere\"\nposition = [0, 0, 1.2]\nradius = 0.6", 0.8 / (1.2 * 1.2)});  // above it
  const std::string scene = fmt::format(
      "ambient = 0\n[camera]\neye = [0, 0, 20]\nlook_at = [0, 0, 0]\nup = [0, 1, 0]\nfov = 0.01\n[image]\nwidth = "
      "1\nheight = 1\n[[light]]\nname = \"Lamp\"\nattenuation = [0, 0, 1]\nsamples = 16\ntype = {}\n"
      "[[object]]\nname = \"Floor\"\ntype = \"flat_polygon\"\ncorners = [[-0.1, -0.1, 0], [0.1, -0.1, 0], [0.1, "
      "0.1, 0], [-0.1, 0.1, 0]]\n[object.material]\ndiffuse = 0.8\n",
      lamp.kind);
  CAPTURE(lamp.kind);
  for (const Integrator integrator : {Integrator::whitted, Integrator::cones, Integrator::beams}) {
    CAPTURE(name_of(integrator));
    CHECK(pixels_by(scene, integrator)[0].x == Approx(lamp.expected).epsilon(0.02));
  }
}

TEST_CASE("without random numbers, too, a sphere of light shines like its middle, to each side") {
  // Its points have the field of a charged shell (Newton's theorem); regular ones nearly so.
  const auto square = [](double z) {
    return fmt::format(
        "[[object]]\nname = \"At {0}\"\ntype = \"flat_polygon\"\n"
        "corners = [[-0.2, -0.2, {0}], [0.2, -0.2, {0}], [0.2, 0.2, {0}], [-0.2, 0.2, {0}]]\n"
        "[object.material]\ndiffuse = 1\n",
        z);
  };
  for (const int samples : {2, 3, 4, 16})
    for (const double side : {-2.0, 2.0}) {
      const std::string scene =
          fmt::format(
              "ambient = 0\n[camera]\neye = [0, 0, {}]\nlook_at = [0, 0, {}]\nup = [0, 1, 0]\nfov = "
              "1\n[image]\nwidth = 1\nheight = 1\n[[light]]\nname = \"Bulb\"\ntype = "
              "\"sphere\"\nposition = [0, 0, 0]\nradius = 0.8\nsamples = {}\nattenuation = [0, 0, "
              "1]\nstrength = 2\n",
              side / 2, side, samples) +
          square(-2) + square(2);
      for (const Integrator integrator :
           {Integrator::cast, Integrator::whitted, Integrator::beams, Integrator::pencils, Integrator::radiosity}) {
        CAPTURE(name_of(integrator), samples, side);
        const bool many = samples == 16 && integrator != Integrator::radiosity;  // which has a grid of its own
        CHECK(pixels_by(scene, integrator)[0].x == Approx(0.5).epsilon(many ? 0.02 : 0.06));
      }
    }
}
