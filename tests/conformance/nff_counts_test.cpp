// The numbers of rays that others counted in Haines's Standard Procedural Databases: 513 x 513 rays through the corners
// of 512 x 512 pixels, depth 5, every transmitter reflecting too.

#include "io/scene_file.h"
#include "render/render.h"
#include "support/catch.h"
#include "support/shared.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct Counts {
  std::string scene;
  double eye_hits, reflected, refracted, shadow;  ///< known to 6, 3, 3 and 4 digits
};

const std::vector<Counts>& known_counts() {
  static const std::vector<Counts> counts{
      {"balls", 263169, 175000, 0, 955000},
      {"tetra", 49950, 0, 0, 46261},
      {"tree", 169909, 0, 0, 1097800},
      {"mount", 173686, 356000, 356000, 414500},
  };
  return counts;
}

Statistics traced(Scene scene, int size, int depth, Precision precision = Precision::double_) {
  scene.limits.depth = depth;
  RenderSettings settings;
  settings.size = ImageSize{size, size};
  settings.sampling.corners = true;
  settings.precision = precision;
  const auto rendering = render(scene, settings);
  REQUIRE(rendering);
  return rendering->statistics;
}

#ifdef NDEBUG
constexpr int size = 512;
constexpr double eye_tolerance = 2, share_tolerance = 0.01;
#else
// With sanitizers a sixteenth of the rays has to do, whose numbers are less even.
constexpr int size = 128;
constexpr double eye_tolerance = 128, share_tolerance = 0.05;
#endif

void check_near(const char* what, double counted, double known) {
  INFO(what << ": " << counted << ", known " << known);
  const double corners = (size + 1.0) * (size + 1.0) / (513.0 * 513.0);
  CHECK(std::abs(counted - known * corners) <= known * corners * share_tolerance);
}

}  // namespace

TEST_CASE("ray counts of the standard databases are those that others counted") {
  for (const Counts& known : known_counts()) {
    const auto file = shared_file("data/" + known.scene + ".nff");
    if (!std::filesystem::exists(file)) RAYWALK_SKIP("no " << file.string());
    INFO(known.scene);
    const auto document = read_scene(file.string());
    REQUIRE(document);
    const Scene& scene = document->scene;
    CHECK(scene.limits.depth == 5);
    CHECK(scene.image == ImageSize{512, 512});

    const Statistics first = traced(scene, size, 1);
    const double eye_hits = static_cast<double>(first.ends(Ending::hit));
    const double corners = (size + 1.0) * (size + 1.0);
    CHECK(static_cast<double>(first.formed(RayKind::primary)) == corners);
    INFO("eye hits: " << eye_hits << ", known " << known.eye_hits);
    CHECK(std::abs(eye_hits - known.eye_hits * corners / (513.0 * 513.0)) <= eye_tolerance);

    const Statistics all = traced(scene, size, 5);
    check_near("reflected", static_cast<double>(all.formed(RayKind::reflect)), known.reflected);
    check_near("refracted", static_cast<double>(all.formed(RayKind::refract)), known.refracted);
    check_near("shadow", static_cast<double>(all.formed(RayKind::shadow)), known.shadow);
  }
}

TEST_CASE("each pixel of corner samples is the mean of its four corners, and the outermost rays span the angle") {
  // A glowing triangle whose left and upper edges run between the outermost corners and those next to them.
  Scene scene;
  scene.camera.look_at = {0, 0, -1};
  scene.camera.up = {0, 1, 0};
  scene.camera.fov = FieldOfView{90, FovAxis::y};
  scene.camera.screen.width.reset();
  scene.image = {4, 4};
  Material glow;
  glow.emission = Rgbd(1.0);
  const double left = -0.99, top = 0.99;
  scene.objects.push_back({"Glow", Triangle<double>{{left, top, -1}, {left, -900, -1}, {1000, top, -1}}, glow});
  RenderSettings settings;
  settings.sampling.corners = true;
  const auto rendering = render(scene, settings);
  REQUIRE(rendering);
  const Film<double>& film = rendering->film_of<double>();
  CHECK(film.size() == ImageSize{4, 4});
  CHECK(rendering->statistics.formed(RayKind::primary) == 25);
  CHECK(film.at(0, 0).x == 0.25);  // only its lower right corner lies on the triangle
  CHECK(film.at(1, 0).x == 0.5);
  CHECK(film.at(0, 1).x == 0.5);
  CHECK(film.at(1, 1).x == 1);
}
