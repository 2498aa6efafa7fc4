// Radiosity against closed forms: areas of patches, closed rooms, hollow balls, lamps; and against path tracing.

#include "trace/radiosity_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.h"
#include "trace/photon_scenes.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using std::numbers::pi;

Scene of(std::vector<Object> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.camera.eye = {0, 0, 0};
  scene.background = Rgbd(0.0);
  scene.render.integrator = Integrator::radiosity;
  return scene;
}

double area_of(const Patches& patches, bool inner = false) {
  double area = 0;
  for (const Patch& patch : patches.all()) area += patch.inner == inner ? patch.area : 0;
  return area;
}

/// A body in the open, lit from afar on all sides.
Patches patches_of(Object object, double size, bool flat = false) {
  Scene scene = of({std::move(object)});
  scene.camera.eye = {100, 100, 100};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, -1}}}};
  return Patches(scene, PatchSettings{size, flat});
}

double sum_of_row(FormFactors& factors, int patch) {
  double sum = 0;
  for (const FormFactors::Entry& entry : factors.row(patch, {}, {})) sum += entry.exchange;
  return sum / factors.patches()[patch].area;
}

}  // namespace

TEST_CASE("patches have the area of what they are cut from, and face outwards") {
  const Material plain = matt(0.5);
  struct Case {
    Object object;
    double area, tolerance;
  };
  const std::vector<Case> cases{
      {{"Box", Box<double>{{0, 0, 0}, {1, 2, 3}}, plain}, 22, 1e-12},
      {{"L", Prism<double>{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1.5}, plain}, 8 * 1.5 + 2 * 3, 1e-12},
      {{"Clockwise", Prism<double>{{{0, 0}, {0, 1}, {1, 0}}, 1}, plain}, 2 + std::sqrt(2.0) + 1, 1e-12},
      {{"Ball", Sphere<double>{{1, 2, 3}, 2}, plain}, 16 * pi, 0.02},
      {{"Can", Cylinder<double>{{1, 1, 1}, -1, 1, true}, plain}, 6 * pi, 0.02},
      {{"Hat", Cone<double>{{1, 1, 1}, 0, 1, true}, plain}, pi * std::sqrt(2.0) + pi, 0.02},
      {{"Egg", Ellipsoid<double>{{1, 1, 1}}, plain}, 4 * pi, 0.02}};
  for (const Case& each : cases) {
    CAPTURE(each.object.name);
    const Patches patches = patches_of(each.object, 0.3);
    CHECK(area_of(patches) == Approx(each.area).epsilon(each.tolerance));
    // By Gauss, the volume: as negative as the sides are turned inwards.
    double volume = 0;
    Vec3d closed(0.0);
    for (const Patch& patch : patches.all()) {
      volume += patch.area * dot(patch.centre, patch.normal) / 3;
      closed += patch.area * patch.normal;
      CHECK(std::abs(length(patch.normal) - 1) < 1e-12);
      for (int i = 0; i < patch.corners; ++i)
        CHECK(length(patch.corner[static_cast<std::size_t>(i)] -
                     patch.corner[static_cast<std::size_t>((i + 1) % patch.corners)]) < 0.43);
    }
    CHECK(volume > 0);
    CHECK(length(closed) < 1e-9);
  }
  // Flat ones, with a hole, mirrored: front and back.
  Object sheet{"Sheet",
               Polygon<double>{{{0, 0, 1}, {3, 0, 1}, {3, 2, 1}, {0, 2, 1}},
                               {{{1, 0.5, 1}, {2, 0.5, 1}, {2, 1.5, 1}, {1, 1.5, 1}}}},
               plain};
  sheet.transform = {TransformStep{Scale{{-1, 1, 1}}}};
  const Patches both = patches_of(sheet, 0.4);
  CHECK(area_of(both) == Approx(5));
  CHECK(area_of(both, true) == Approx(5));
  const Patches disk = patches_of({"Disk", Disk<double>{{0, 0, 0}, {0, 1, 0}, 2}, plain}, 0.4);
  CHECK(area_of(disk) == Approx(4 * pi).epsilon(0.02));
  CHECK(disk[0].inner != (dot(disk[0].normal, {0, 1, 0}) > 0));
}

TEST_CASE("in the plane patches are the edges, and light leaves them outwards") {
  for (const Object& object : {Object{"Box", Box<double>{{0, 0, -1}, {1, 2, 1}}, matt(0.5)},
                               Object{"Clockwise", Prism<double>{{{0, 0}, {0, 2}, {1, 2}, {1, 0}}, 1}, matt(0.5)}}) {
    const Patches patches = patches_of(object, 0.5, true);
    CHECK(patches.size() == 12);
    CHECK(area_of(patches) == Approx(6));
    for (const Patch& patch : patches.all()) {
      const Edge edge = patch.edge();
      const Vec2d along = edge.b - edge.a, out(patch.normal);
      CHECK(along.x * out.y - along.y * out.x > 0);
      CHECK(dot(out, Vec2d(patch.centre) - Vec2d(0.5, 1)) > 0);
    }
  }
}

TEST_CASE("a patch reflects what its pattern does on average") {
  for (const double size : {1.0 / 6, 1.0 / 16}) {
    Scene scene = of({{"Floor", Polygon<double>{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {}}, matt(0.8)},
                      {"Piece", Triangle<double>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, matt(0.8)}});
    for (Object& object : scene.objects) object.material.checker = Checker{Rgbd(1.0), Rgbd(0.0), size};
    const Patches patches(scene, PatchSettings{2, false});
    for (const Patch& patch : patches.all()) CHECK(patch.reflectance.x == Approx(0.4).epsilon(0.08));
    CHECK(patches.size() >= 2);
  }
}

TEST_CASE("sides that no light reaches are left out") {
  // Walls of a room: their outsides face nothing, and nothing is inside of them.
  const Material plain = matt(0.5);
  const Scene room = of({{"A", Box<double>{{-2, -2, -1}, {-1.9, 2, 1}}, plain},
                         {"B", Box<double>{{1.9, -2, -1}, {2, 2, 1}}, matt(0, 1)}});
  const Patches walls(room, PatchSettings{10, true});
  REQUIRE(walls.size() == 2);
  CHECK(dot(walls[0].normal, {1, 0, 0}) == 1);
  CHECK(dot(walls[1].normal, {-1, 0, 0}) == 1);
  CHECK(walls[1].emission == Rgbd(2.0));
  // The eye in it: both sides of a ball, of which the outside faces nothing.
  const Patches inside(of({{"Ball", Sphere<double>{{0, 0, 0}, 1}, plain}}), PatchSettings{10, false});
  for (const Patch& patch : inside.all()) CHECK(patch.inner);
  CHECK(inside.size() == 16 * 8);
}

TEST_CASE("closed rooms of patches: every row sums to 1, and what stands in the way is found") {
  const Scene cube = of({{"Cube", Box<double>{{-1, -1, -1}, {1, 1, 1}}, matt(0.5)}});
  for (const bool flat : {false, true}) {
    const Patches patches(cube, PatchSettings{0.7, flat});
    FormFactors factors(patches);
    for (int patch = 0; patch < patches.size(); patch += 7)
      CHECK(std::abs(sum_of_row(factors, patch) - 1) < (flat ? 1e-12 : 1e-4));
  }
  // A ball in the middle: rows still sum to 1, but for what rays take for seen that is not, and the other way round.
  Scene with_ball = cube;
  with_ball.objects.push_back({"Ball", Sphere<double>{{0.1, 0, 0}, 0.5}, matt(0.5)});
  for (const bool flat : {false, true}) {
    const Patches patches(with_ball, PatchSettings{0.3, flat});
    FormFactors factors(patches);
    double mean = 0;
    int rows = 0;
    for (int patch = 0; patch < patches.size(); patch += flat ? 1 : 40, ++rows) mean += sum_of_row(factors, patch);
    CHECK(std::abs(mean / rows - 1) < (flat ? 2e-3 : 0.01));
    // Behind the ball.
    int hidden = 0;
    for (const Patch& patch : patches.all()) hidden += patch.object == 0 ? 1 : 0;
    const auto opposite = [&](double x) {
      for (int i = 0; i < patches.size(); ++i)
        if (patches[i].object == 0 && std::abs(patches[i].centre.x - x) < 1e-9 && std::abs(patches[i].centre.y) < 0.2 &&
            std::abs(patches[i].centre.z) < 0.2)
          return i;
      return -1;
    };
    const int left = opposite(-1), right = opposite(1);
    REQUIRE((left >= 0 && right >= 0));
    CHECK(patches.exchange(left, right).visible == 0);
    CHECK(patches.exchange(left, right).area > 0);
    CHECK(patches.exchange(left, right).visible == patches.exchange(right, left).visible);
    CHECK(hidden > 0);
  }
}

TEST_CASE("rays find the form factor of two disks") {
  const Accelerator<double> disk(Primitives<double>({Disk<double>{{0, 0, 1}, {0, 0, -1}, 1}}));
  TestCounts counts;
  constexpr int edge = 1000;
  int met = 0;
  for (int i = 0; i < edge * edge; ++i) {
    // A Hammersley-like set over the disk and the cosine's directions.
    const double u = (i + 0.5) / (edge * edge), golden = 0.6180339887498949, plastic = 0.7548776662466927,
                 other = 0.5698402909980532;
    const auto share = [](double x) { return x - std::floor(x); };
    const double radius = std::sqrt(u), angle = 2 * pi * share(i * golden);
    const double sine = std::sqrt(share(i * plastic)), around = 2 * pi * share(i * other);
    const Ray<double> ray{{radius * std::cos(angle), radius * std::sin(angle), 0},
                          {sine * std::cos(around), sine * std::sin(around), std::sqrt(1 - sine * sine)},
                          {},
                          0};
    met += disk.closest(ray, infinity<double>, counts) ? 1 : 0;
  }
  CHECK(std::abs(met / double(edge * edge) - 0.3819660) < 1e-3);
}

TEST_CASE("inside a ball irradiance is mean(E) / (1 - mean(rho)), whatever glows and whatever reflects", "[odds]") {
  // Polygons in place of a ball err as the square of their size: by so much less with more of them.
  const auto off_with = [](int around, std::vector<double>& shares) {
    const Scene scene = of({{"Ball", Sphere<double>{{0, 0, 0}, 2}, matt(0.5)}});
    Patches patches(scene, PatchSettings{4 * pi / around * (1 + 1e-9), false});
    REQUIRE(patches.size() == around * around / 2);
    Rgbd emitted(0.0), reflected(0.0), mean(0.0);
    double area = 0;
    for (int i = 0; i < patches.size(); ++i) {
      const Vec3d at = normalize(patches[i].centre);
      const Rgbd emission(1 + 0.9 * at.x, 2 + at.y * at.z, 1 + at.z),
          reflectance(0.5 + 0.4 * at.z, 0.5 - 0.4 * at.y, 0.7);
      patches.paint(i, emission, reflectance);
      emitted += patches[i].area * emission, reflected += patches[i].area * reflectance, area += patches[i].area;
    }
    FormFactors factors(patches);
    RadiositySettings settings;
    settings.tolerance = 1e-6;
    Shooting shooting;
    shooting.shot = [&](double share) { shares.push_back(share); };
    const RadiosityState state = shoot_light(factors, settings, shooting);
    CHECK(state.shots == static_cast<int>(shares.size()));
    for (int i = 0; i < patches.size(); ++i)
      mean += patches[i].area / area * state.lights[static_cast<std::size_t>(i)].irradiance;
    return mean / (emitted / area / (Rgbd(1.0) - reflected / area)) - Rgbd(1.0);
  };
  std::vector<double> shares, finer_shares;
  const Rgbd coarse = off_with(16, shares), fine = off_with(24, finer_shares);
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, coarse[c], fine[c]);
    CHECK(std::abs(fine[c]) < 2e-3);
    CHECK(std::abs(fine[c] + (fine[c] - coarse[c]) / (24.0 * 24 / 16 / 16 - 1)) < 1e-3);
  }
  // Unshot light falls with every shot.
  REQUIRE(shares.size() > 100);
  CHECK(shares.front() < 1);
  CHECK(std::adjacent_find(shares.begin(), shares.end(), std::less_equal<>()) == shares.end());
  CHECK(shares.back() <= 1e-6);
}

TEST_CASE("light is neither lost nor won: in a closed room all of it is absorbed in the end") {
  for (const bool flat : {false, true}) {
    Scene scene = of({{"Room", Box<double>{{-2, -1, -1}, {2, 1, 1}}, matt(0.6)},
                      {"Lamp", Box<double>{{-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}}, matt(0, 3)}});
    scene.camera.eye = {-1, 0.5, 0};
    const Patches patches(scene, PatchSettings{0.5, flat});
    FormFactors factors(patches);
    RadiositySettings settings;
    settings.patches.flat = flat;
    settings.tolerance = 1e-7;
    const RadiosityState state = shoot_light(factors, settings);
    double emitted = 0, absorbed = 0;
    for (int i = 0; i < patches.size(); ++i) {
      emitted += patches[i].area * patches[i].emission.x;
      absorbed +=
          patches[i].area * (1 - patches[i].reflectance.x) * state.lights[static_cast<std::size_t>(i)].irradiance.x;
    }
    CAPTURE(flat, absorbed / emitted);
    CHECK(emitted == Approx(flat ? 1.6 * 2 * 3 : 0.96 * pi * 3));
    CHECK(absorbed == Approx(emitted).epsilon(flat ? 2e-3 : 0.01));
  }
}

TEST_CASE("a lamp's light arrives once: straight, and what bounces as often as it does", "[odds]") {
  // A ball with a lamp in its middle: pi L / R^2 straight, over 1 - rho in all.
  constexpr double radius = 2, albedo = 0.5;
  Scene ball = hollow_ball(radius, albedo, {0, 0, 0}, Attenuation{0, 0, 1});
  ball.render.integrator = Integrator::radiosity;
  ball.render.radiosity.patch = 0.5;
  ball.render.radiosity.tolerance = 1e-4;
  CHECK(mean_of_pictures(ball, 8, 8, 1, 2).mean == Approx(albedo / (radius * radius) / (1 - albedo)).epsilon(0.03));
  // Black: shadow rays alone; a floor under a lamp.
  Scene floor = of({{"Floor", Polygon<double>{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {}}, matt(0.5)},
                    {"Roof", Polygon<double>{{{0, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}}, {}}, matt(0)}});
  floor.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, 1}, {0, 0, 1}}}};
  const Patches patches(floor, PatchSettings{0.1, false});
  int lit = 0, dark = 0;
  for (int i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i];
    if (patch.object != 0 || patch.inner) continue;
    const double square = dot(patch.centre, patch.centre) + 1 - 0;
    const double truth = patch.centre.x < 0 ? pi / (square * std::sqrt(square)) : 0;
    CHECK(patches.light_of_lamps(i).x == Approx(truth).epsilon(0.01).margin(1e-12));
    ++(truth > 0 ? lit : dark);
  }
  CHECK(lit == 200);
  CHECK(dark == 200);
}

TEST_CASE("a ball that glows sends as much light as its own area does, outwards") {
  Scene scene = of({{"Ball", Sphere<double>{{5, 0, 0}, 2}, matt(0, 1)}});
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};  // all sides are kept
  for (const bool flat : {false, true}) {
    const Patches patches(scene, PatchSettings{4, flat});
    double power = 0;
    for (const Patch& patch : patches.all()) power += patch.inner ? 0 : patch.area * patch.emission.x;
    CHECK(power == Approx(flat ? 2 * 2 * pi * 2 : pi * 4 * pi * 4).epsilon(1e-3));
  }
}

TEST_CASE("a lamp with an extent lights the side that only some of it is in front of") {
  Scene scene = of({{"Floor", Box<double>{{-2, -2, -0.01}, {2, 2, 0}}, matt(0.5)}});
  for (const double z : {-0.05, 0.0}) {
    scene.lights = {{"Lamp", Rgbd(1.0), SphereLight{{0, 0, z}, 0.5, 1, {0, 0, 1}}}};
    const Patches patches(scene, PatchSettings{4, false});
    const auto upper = std::find_if(patches.all().begin(), patches.all().end(),
                                    [](const Patch& patch) { return !patch.inner && patch.normal.z > 0.9; });
    REQUIRE(upper != patches.all().end());
    CHECK(patches.light_of_lamps(static_cast<int>(upper - patches.all().begin())).x > 0.1);
  }
}

TEST_CASE("of a lamp with an extent arrives what its mean brings: half of it, where half is below the horizon") {
  Scene scene = of({{"Floor", Box<double>{{-3, -3, -0.01}, {3, 3, 0}}, matt(0.8)}});
  const Vec3d middle = GENERATE(Vec3d(1.2, 0, 0), Vec3d(1, 0, 0.7));
  constexpr double radius = 0.6;
  scene.lights = {{"Lamp", Rgbd(1.0), SphereLight{middle, radius, 1, {0, 0, 1}}}};
  const Patches patches(scene, PatchSettings{4, false});
  const auto upper = std::find_if(patches.all().begin(), patches.all().end(),
                                  [](const Patch& patch) { return !patch.inner && patch.normal.z > 0.9; });
  REQUIRE(upper != patches.all().end());
  // The mean of z / |x|^3 over the lamp's surface, where that is above 0, by rows of equal area; a light of strength 1
  // brings the irradiance pi.
  double truth = 0;
  constexpr int rows = 400;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < rows; ++k) {
      const double up = 2 * (i + 0.5) / rows - 1, around = 2 * pi * (k + 0.5) / rows, aside = std::sqrt(1 - up * up);
      const Vec3d place = middle + radius * Vec3d(aside * std::cos(around), aside * std::sin(around), up);
      truth += pi * std::max(place.z, 0.0) / std::pow(length(place), 3) / (rows * rows);
    }
  const double found = patches.straight_light(static_cast<int>(upper - patches.all().begin()), {0, 0, 0}, {}).x;
  CHECK(found == Approx(truth).epsilon(0.03));
}

TEST_CASE("in a furnace every pixel is E / (1 - rho), in the plane and in space, in float and double") {
  Scene furnace = of({{"Room", Box<double>{{-1, -2, -1}, {3, 1, 1}}, matt(0.6, 0.3)}});
  furnace.camera.eye = {0, 0, 0};
  furnace.camera.look_at = {1, 0.3, 0};
  furnace.camera.up = {0, 0, 1};
  furnace.camera.screen = {1, 2, 8};
  furnace.render.radiosity.patch = 1.3;
  furnace.render.radiosity.tolerance = 1e-7;
  for (const bool flat : {false, true}) {
    CHECK(mean_of_pictures(furnace, 9, flat ? 1 : 9, 1, 2, flat).mean == Approx(0.3 / 0.4).epsilon(1e-4));
  }
  const World<float> world(furnace);
  const SceneKernel<float> kernel(furnace, world);
  const PutPixel<float> put = [](const Pixel&, const Rgb<float>& shade) { CHECK(std::abs(shade.x - 0.75F) < 1e-4F); };
  static_cast<void>(kernel(RayGenerator<float>(furnace, {3, 3}, {3, 3}), PixelBlock{0, 3, 0, 3}, put));
}

TEST_CASE("shadows have edges inside of patches") {
  // A floor of four patches under a shade and a small lamp: everything else is black.
  const Scene scene = of(
      {{"Floor", Polygon<double>{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {}}, matt(0.5)},
       {"Shade", Polygon<double>{{{-0.3, -0.3, 0.5}, {0.3, -0.3, 0.5}, {0.3, 0.3, 0.5}, {-0.3, 0.3, 0.5}}, {}},
        matt(0)},
       {"Lamp", Polygon<double>{{{-0.1, -0.1, 2}, {-0.1, 0.1, 2}, {0.1, 0.1, 2}, {0.1, -0.1, 2}}, {}}, matt(0, 50)}});
  const Patches patches(scene, PatchSettings{1 + 1e-9});
  FormFactors factors(patches);
  RadiositySettings settings;
  const RadiosityState state = shoot_light(factors, settings);
  const PatchIrradiance irradiance(factors, state.lights);
  std::vector<int> sources;
  for (int i = 0; i < patches.size(); ++i)
    if (!is_black(patches[i].emission)) sources.push_back(i);
  double squares = 0, most = 0;
  int dark = 0, count = 0;
  constexpr int points = 40;
  for (int i = 0; i < points * points; ++i) {
    const Vec3d at(2 * (i % points + 0.5) / points - 1, 2 * (i / points + 0.5) / points - 1, 0);
    const Patches::Place place = patches.place_of(0, at, {0, 0, 1});
    REQUIRE(place.patch >= 0);
    const double truth = patches.straight_light(place.patch, at, sources).x, found = irradiance.at(place).x;
    squares += (found - truth) * (found - truth), most = std::max(most, truth);
    dark += found < 0.01 * most ? 1 : 0, ++count;
  }
  // The penumbra is as wide as the smallest elements. Between the corners of patches the error would be 0.3.
  CHECK(std::sqrt(squares / count) < 0.06 * most);
  // The umbra is the square of 0.7333 that no point of the lamp is seen from.
  CHECK(4.0 * dark / count == Approx(0.7333 * 0.7333).epsilon(0.25));
}

TEST_CASE("shots run in threads or not, with the same bits") {
  Scene scene = of({{"Room", Box<double>{{-2, -1, -1}, {2, 1, 1}}, matt(0.6)},
                    {"Lamp", Sphere<double>{{0.5, 0, 0}, 0.3}, matt(0, 3)}});
  scene.camera.eye = {-1, 0.5, 0};
  const Patches patches(scene, PatchSettings{0.6, false});
  Shooting backwards;
  backwards.run_all = [](int count, const std::function<void(int)>& body) {
    for (int i = count; i-- > 0;) body(i);
  };
  FormFactors one(patches), other(patches);
  const RadiosityState a = shoot_light(one, {}), b = shoot_light(other, {}, backwards);
  REQUIRE(a.lights.size() == b.lights.size());
  CHECK(a.shots == b.shots);
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    CHECK(a.lights[i].irradiance == b.lights[i].irradiance);
    CHECK(a.lights[i].unshot == b.lights[i].unshot);
  }
}

TEST_CASE("what radiosity cannot do is refused by name, what it leaves out is said") {
  Scene scene = of({{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matt(0.5)}});
  REQUIRE(why_no_patches(scene));
  CHECK_THAT(why_no_patches(scene)->text(), contains("\"Floor\"") && contains("endless") && contains("flat_polygon"));
  scene = of({{"Ball", Sphere<double>{{0, 0, 0}, 1}, matt(0.5)}});
  CHECK_FALSE(why_no_patches(scene));
  CHECK(patch_losses(scene).empty());
  scene.objects[0].material.diffuse_roughness = 0.5;
  REQUIRE(patch_losses(scene).size() == 1);
  CHECK_THAT(patch_losses(scene)[0], contains("\"Ball\"") && contains("smooth"));
  scene.objects[0].material.diffuse_roughness = 0;
  scene.objects[0].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  REQUIRE(why_no_patches(scene));
  CHECK_THAT(why_no_patches(scene)->text(), contains("\"Ball\"") && contains("moves"));
  scene.objects[0].motion.clear();
  scene.render.radiosity.patch = 0.001;
  REQUIRE(why_no_patches(scene));
  CHECK_THAT(why_no_patches(scene)->text(), contains("5000") && contains("patch ="));
  scene.objects[0].material.reflection = Rgbd(0.5);
  scene.background = Rgbd(0.2);
  const std::vector<std::string> losses = patch_losses(scene);
  REQUIRE(losses.size() == 2);
  CHECK_THAT(losses[0], contains("\"Ball\" absorbs"));
  CHECK_THAT(losses[1], contains("lights nothing"));
}

TEST_CASE("radiosity and paths agree in a room of matt walls, a block and a lamp with an extent", "[odds]") {
  Scene room = of({{"Room", Box<double>{{-1, -1, -1}, {1, 1, 1}}, matt(0.5)},
                   {"Block", Box<double>{{0.1, -0.2, -1.2}, {0.6, 0.4, -0.1}}, matt(0.7)},
                   {"Lamp", Box<double>{{-0.4, -0.4, 0.9}, {0.4, 0.4, 1.1}}, matt(0, 2)}});
  room.objects[0].material.diffuse = {0.6, 0.4, 0.2};
  room.camera.eye = {-0.95, 0.1, 0.1};
  room.camera.look_at = {1, 0, -1.2};  // the lamp itself is out of sight
  room.camera.up = {0, 0, 1};
  room.camera.screen = {1, 2, 8};
  Scene paths = room;
  paths.render.integrator = Integrator::path;
  room.render.radiosity.patch = 0.2;
  const double by_patches = mean_of_pictures(room, 16, 16, 4, 2).mean;
  const Means by_paths = mean_of_pictures(paths, 16, 16, 16, 8);
  CAPTURE(by_patches, by_paths.mean, by_paths.error);
  CHECK(by_paths.error < 0.01 * by_paths.mean);
  CHECK(std::abs(by_patches / by_paths.mean - 1) < 0.03);
}
