// Scenes that come with Raywalk, converted and rendered by POV-Ray: nearly the same pictures.

#include "image/image_file.h"
#include "io/pov_writer.h"
#include "io/scene_file.h"
#include "png.h"
#include "render/render.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/file.h"

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Share of the pixels of which a channel is off by more than 2 of 255.
double share_off(const Picture& a, const Picture& b) {
  int off = 0;
  for (std::size_t i = 0; i < a.bytes.size(); i += 3) {
    int most = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel)
      most = std::max(most, std::abs(int{a.bytes[channel]} - int{b.bytes[channel]}));
    if (most > 2) ++off;
  }
  return 3.0 * off / static_cast<double>(a.bytes.size());
}

/// A folder for the scenes and pictures of one test.
class Workshop {
 public:
  /// Share of the pixels in which POV-Ray's picture of the converted scene is another one.
  double share_off_converted(Scene scene) const {
    scene.image = {160, 120};
    const auto rendering = render(scene);
    REQUIRE(rendering);
    const Picture ours = decode_png(*encode_png(rendering->image()));
    REQUIRE(write_file_atomically(folder_.file("scene.pov"), format_pov(scene).text));
    const std::string command = "cd '" + folder_.path() +
                                "' && povray +Iscene.pov +Oscene.png +W160 +H120 -A +WT1 -D -GA >log 2>&1 || "
                                "{ cat log >&2; exit 1; }";
    REQUIRE(std::system(command.c_str()) == 0);
    const auto bytes = read_file(folder_.file("scene.png"), std::size_t{1} << 26);
    REQUIRE(bytes);
    const Picture theirs = decode_png(*bytes);
    REQUIRE(theirs.bytes.size() == ours.bytes.size());
    return share_off(ours, theirs);
  }

 private:
  TemporaryFolder folder_;
};

bool has_povray() { return std::system("command -v povray >/dev/null 2>&1") == 0; }

/// One thing on a floor under one light.
Scene still_life(const Light& light, const ObjectShape& shape, const Material& material) {
  Scene scene;
  scene.background = {0.1, 0.2, 0.4};
  scene.ambient = Rgbd(0.1);
  scene.camera.eye = {-7, -2, 3};
  scene.camera.screen.width.reset();
  scene.camera.fov = FieldOfView{40, FovAxis::x};
  scene.render.integrator = Integrator::whitted;
  scene.limits.depth = 8;
  Material floor;
  floor.ambient = Rgbd(0.3);
  floor.diffuse = Rgbd(0.7);
  floor.checker = Checker{Rgbd(0.9), {0.2, 0.4, 0.2}, 0.7};
  scene.lights = {light};
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1.2}, {0, 0, 1}}, floor}, {"Thing", shape, material}};
  return scene;
}

const Light lamp{"Lamp", Rgbd(1.0), PointLight{{-3, 3, 6}, {}}};
const Sphere<double> ball{{0, 0, 0}, 1};

Material matte() {
  Material material;
  material.ambient = Rgbd(0.3);
  material.diffuse = Rgbd(0.5);
  material.reflection = Rgbd(0.2);
  return material;
}

Material clear(double transmission, double reflection = 0) {
  Material material;
  material.diffuse = Rgbd(0.0);
  material.transmission = Rgbd(transmission);
  material.reflection = Rgbd(reflection);
  material.ior = 1.5;
  return material;
}

}  // namespace

TEST_CASE("each kind of light shines in POV-Ray as it does here") {
  if (!has_povray()) RAYWALK_SKIP("povray is not installed");
  const Workshop workshop;
  const Vec3d at{-3, 3, 4}, look_at{0, 0, 0};
  struct Lit {
    std::string name;
    Light light;
    double most_off;
  };
  for (const Lit& each : std::vector<Lit>{
           {"point", {"L", Rgbd(1.0), PointLight{at, {}}}, 0.001},
           {"fading with the square", {"L", Rgbd(20.0), PointLight{at, {1, 0, 1}}}, 0.001},
           {"fading with the distance", {"L", Rgbd(3.0), PointLight{at, {0.5, 0.5, 0}}}, 0.001},
           {"sun", {"L", Rgbd(1.0), DirectionalLight{{-0.3, 0.5, 1}}}, 0.001},
           {"spot", {"L", Rgbd(1.0), SpotLight{at, look_at, 30, 15, {}}}, 0.001},
           {"spot with a sharp edge", {"L", Rgbd(1.0), SpotLight{at, look_at, 30, 30, {}}}, 0.001},
           {"rectangle", {"L", Rgbd(1.0), RectangleLight{at, {1, 0, 0}, {0, 1.5, 0}, 4, {}}}, 0.02},
           {"rectangle's middle", {"L", Rgbd(1.0), RectangleLight{at, {1, 0, 0}, {0, 1.5, 0}, 1, {}}}, 0.001},
           {"sphere, there a disk", {"L", Rgbd(1.0), SphereLight{at, 0.6, 4, {}}}, 0.1}}) {
    INFO(each.name);
    CHECK(workshop.share_off_converted(still_life(each.light, ball, matte())) <= each.most_off);
  }
}

TEST_CASE("each shape stands in POV-Ray as it does here") {
  if (!has_povray()) RAYWALK_SKIP("povray is not installed");
  const Workshop workshop;
  const Polygon<double> face{{{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 0}, {0, -1, 1}}, {}};
  const std::vector<Shape<double>> shapes{ball,
                                          Box<double>{{-1, -1, -1}, {1, 1, 1}},
                                          Disk<double>{{0, 0, 0}, {1, 0, 0.3}, 1.2},
                                          Triangle<double>{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}},
                                          Prism<double>{{{-1, -1}, {1, -1}, {0.2, 0}, {1, 1}, {-1, 1}}, 1.4},
                                          face,
                                          Ellipsoid<double>{{1, 0.7, 0.5}},
                                          EllipticParaboloid<double>{{1, 1, 1}, -1, 0.8, true},
                                          Cone<double>{{1, 1, 1}, -1, 0.8, true},
                                          Cylinder<double>{{0.7, 0.7, 1}, -1, 1, true},
                                          Cylinder<double>{{0.7, 0.7, 1}, -1, 1, false},
                                          HyperboloidOneSheet<double>{{0.5, 0.5, 1}, -1, 1, true},
                                          HyperboloidTwoSheets<double>{{0.3, 0.3, 0.3}, -1, 1, true}};
  for (const Shape<double>& shape : shapes) {
    INFO(shape_name(ObjectShape(shape)));
    Scene scene = still_life(lamp, shape, matte());
    scene.objects[1].transform = {TransformStep{Rotate{{1, 2, 3}, 30}}, TransformStep{Scale{{1, 0.8, 1.2}}}};
    CHECK(workshop.share_off_converted(scene) <= 0.001);
  }
}

TEST_CASE("mirrors and glass look in POV-Ray as they do here, but for what is said") {
  if (!has_povray()) RAYWALK_SKIP("povray is not installed");
  const Workshop workshop;
  Material gold = matte(), plain = clear(0.85, 0.15), dielectric = clear(1), absorbing = clear(1), stained = clear(1);
  gold.reflection = {0.9, 0.6, 0.2};
  dielectric.dielectric = true;
  absorbing.absorption = {0.1, 0.5, 1};
  stained.transmission = {0.9, 0.5, 0.4};
  stained.shadow = ShadowKind::filtered;
  for (const Material& material : {gold, plain, dielectric, absorbing, stained})
    CHECK(workshop.share_off_converted(still_life(lamp, ball, material)) <= 0.001);
  // What POV-Ray has no words for stands in the file, and on the terminal.
  Material lossy = clear(0.8);
  lossy.dielectric = true;
  lossy.absorption = Rgbd(0.2);
  const Scene scene = still_life(lamp, ball, lossy);
  const PovText pov = format_pov(scene);
  CHECK(pov.left_out.size() == 2);
  for (const std::string& loss : pov.left_out)
    CHECK_THAT(pov.text, contains("// POV-Ray renders without: " + loss + "\n"));
  CHECK(workshop.share_off_converted(scene) > 0.01);
  CHECK(format_pov(still_life(lamp, ball, dielectric)).left_out.empty());
  dielectric.priority = 1;
  CHECK(format_pov(still_life(lamp, ball, dielectric)).left_out.size() == 1);
}

TEST_CASE("POV-Ray renders converted scenes to nearly the same pictures") {
  if (!has_povray()) RAYWALK_SKIP("povray is not installed");
  struct Converted {
    std::string scene;
    double most_off;   ///< share of the pixels
    std::string rest;  ///< what the others come from
  };
  const std::vector<Converted> scenes{
      {"classic", 0.01, "edges"},
      {"whitted", 0.01, "edges, where one pixel's ray just hits and the other's just misses"},
      {"mirrors", 0.02, "edges, many times mirrored"},
      {"shadows", 0.02, "edges"},
      {"quadrics", 0.02, "edges"},
      {"sphereflake", 0.03, "edges, many times mirrored"},
      {"mesh", 0.02, "edges"},
      {"glass", 0.2, "light that the prism loses where it reflects totally: the file says so"},
  };
  const Workshop workshop;
  for (const Converted& each : scenes) {
    INFO(each.scene);
    const auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + each.scene + ".toml");
    REQUIRE(document);
    const double off = workshop.share_off_converted(document->scene);
    INFO("off by more than 2/255: " << 100 * off << "% (" << each.rest << ")");
    CHECK(off <= each.most_off);
  }
}
