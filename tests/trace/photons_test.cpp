// Photon mapping against closed forms: in a hollow ball the light that has bounced is rho mean(E) / (1 - rho) whatever
// the pattern of the first light; in a cup the caustic is a sum of 1 / |J|; and against path tracing.

#include "support/catch.h"
#include "trace/paths.h"
#include "trace/photon_limits.h"
#include "trace/photon_scenes.h"

#include <algorithm>
#include <cstring>
#include <numbers>

using namespace raywalk;
using namespace raywalk::test;

namespace {

using std::numbers::pi;
constexpr double wall_albedo = 0.6, ball_radius = 2;
constexpr Attenuation law_of_square{0, 0, 1}, law_of_distance{0, 1, 0}, no_law{1, 0, 0};

bool check_near(const Means& found, double truth, double share) {
  INFO("mean " << found.mean << " +- " << found.error << ", truth " << truth);
  CHECK(found.error < share * truth);
  CHECK(std::abs(found.mean - truth) < 4 * found.error + 1e-3 * truth);
  return true;
}

/// What an eye in the hollow ball sees on average, by shadow rays alone.
double shadow_rays_alone(Scene scene, int width, int height, bool flat) {
  scene.render.photons.count = 1;
  scene.render.photons.radius = 1e-9;
  return mean_of_pictures(scene, width, height, 1, 2, flat).mean;
}

}  // namespace

TEST_CASE("in a hollow ball bounced light is that of all patterns, by any law of attenuation", "[odds]") {
  for (const bool gather : {false, true})
    for (const Vec3d& lamp : {Vec3d(0.0), Vec3d(0.7, -0.4, 0.3)}) {
      Scene scene = by_photons(hollow_ball(ball_radius, wall_albedo, lamp, law_of_square), 40000, 200);
      scene.render.photons.gather = gather;
      CAPTURE(gather, lamp.x);
      // The flux 4 pi pi L over the area: mean(E) = pi L / R^2. Radiance is kd / pi times irradiance.
      const double bounced = wall_albedo * wall_albedo / (ball_radius * ball_radius) / (1 - wall_albedo);
      check_near(mean_of_pictures(scene, 12, 12, gather ? 8 : 1, 12), shadow_rays_alone(scene, 12, 12, false) + bounced,
                 0.01);
    }
  // A lamp in the middle that does not weaken: its light on the wall is pi L at any distance.
  const Scene constant = by_photons(hollow_ball(ball_radius, wall_albedo, {0, 0, 0}, no_law), 40000, 200);
  check_near(mean_of_pictures(constant, 12, 12, 1, 12), wall_albedo / (1 - wall_albedo), 0.01);
}

TEST_CASE("in a flat world the same holds for lengths") {
  // On a circle, as opposed to a sphere, bounced light is even only where the first light is.
  const Scene scene = by_photons(hollow_ball(ball_radius, wall_albedo, {0, 0, 0}, law_of_distance), 20000, 100);
  const double bounced = wall_albedo * wall_albedo / ball_radius / (1 - wall_albedo);
  check_near(mean_of_pictures(scene, 40, 1, 1, 12, true), shadow_rays_alone(scene, 40, 1, true) + bounced, 0.01);
}

TEST_CASE("photons bring what they were sent with: each bounce the albedo of it") {
  for (const bool flat : {false, true}) {
    const Scene scene = by_photons(
        hollow_ball(ball_radius, wall_albedo, {0.7, -0.4, 0}, flat ? law_of_distance : law_of_square), 100000, 60);
    const World<double> world(scene);
    const Emitters<double> emitters(world);
    PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene, flat));
    static_cast<void>(kernel.send(5, 0, 1));
    double power = 0;
    for (const Photon& photon : kernel.maps()[0].other.photons()) power += static_cast<double>(photon.power.x);
    const double sent = flat ? 2 * pi * 2 : 4 * pi * pi;
    CAPTURE(flat, power / sent);
    CHECK(power == Approx(sent * wall_albedo / (1 - wall_albedo)).epsilon(0.02));
  }
}

TEST_CASE("a ball that glows inside is as bright everywhere as what it emits over 1 - rho", "[odds]") {
  for (const bool gather : {false, true}) {
    Scene scene = by_photons(hollow_ball(ball_radius, wall_albedo, {0, 0, 0}, law_of_square), 40000, 200);
    scene.lights.clear();
    scene.objects[0].material.emission = Rgbd(0.3);
    scene.render.photons.gather = gather;
    check_near(mean_of_pictures(scene, 12, 12, gather ? 8 : 4, 12), 0.3 / (1 - wall_albedo), 0.01);
    if (!gather) check_near(mean_of_pictures(scene, 30, 1, 4, 12, true), 0.3 / (1 - wall_albedo), 0.01);
  }
}

TEST_CASE("a lamp's law goes by the whole way of its photons, past clear glass and mirrors too") {
  // A lamp above a floor, with a pane between them that bends nothing, or below a mirror, in which it stands once more.
  const Attenuation law = GENERATE(no_law, law_of_distance, law_of_square);
  const bool mirrored = GENERATE(false, true);
  Material pane = matt(0);
  (mirrored ? pane.reflection : pane.transmission) = Rgbd(1.0);
  pane.ior = 1;
  Scene scene;
  scene.objects = {{"Floor", Disk<double>{{0, 0, 0}, {0, 0, 1}, 0.8}, matt(0.8)},
                   {"Pane", Disk<double>{{0, 0, mirrored ? 3.0 : 1.5}, {0, 0, 1}, 1.5}, pane}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, mirrored ? 1.5 : 3}, law}}};
  scene.camera.eye = {0.4, -0.4, 0.5};
  scene.camera.look_at = {0.4, 0, 0};
  scene.camera.screen = {1, 0.1, 6};
  scene = by_photons(scene, 400000, 10000);
  scene.render.photons.radius = 0.15;
  scene.render.photons.gather = false;
  const auto brought = [&](double height) {
    const double distance = std::hypot(height, 0.4);
    return 0.8 * height / distance / (law.constant + law.linear * distance + law.quadratic * distance * distance);
  };
  const double truth = mirrored ? brought(1.5) + brought(4.5) : brought(3);
  const Means found = mean_of_pictures(scene, 4, 4, 1, 8);
  INFO("mean " << found.mean << " +- " << found.error << ", truth " << truth);
  CHECK(found.error < 0.03 * truth);
  CHECK(std::abs(found.mean - truth) < 4 * found.error + 0.01 * truth);
}

TEST_CASE("photons that a sheet scatters to the side bring what it shines there") {
  // Sunlight comes straight down on a sheet. It is seen as brightly by each eye below whose ray, refracted, is within
  // 80 degrees of it: by what comes in, over the solid angle of the cone. A floor beside it is in the shade.
  const double ior = GENERATE(1.0, 1.5);
  constexpr double sheet_radius = 0.3;
  const double aside = ior == 1 ? 1.5 : 0.5;
  Scene scene;
  Material sheet = matt(0);
  sheet.transmission = Rgbd(1.0);
  sheet.ior = ior;
  sheet.translucency = 80;
  scene.objects = {{"Floor", Disk<double>{{aside, 0, 0}, {0, 0, 1}, 0.4}, matt(1)},
                   {"Shade", Disk<double>{{aside, 0, 1.6}, {0, 0, 1}, ior == 1 ? 0.7 : 0.19}, matt(0)},
                   {"Sheet", Disk<double>{{0, 0, 1}, {0, 0, 1}, sheet_radius}, sheet}};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};
  scene.camera.eye = {aside, 0, 0.5};
  scene.camera.look_at = {aside, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.screen = {1, 0.1, 6};
  scene = by_photons(scene, 1500000, 10000);
  scene.render.photons.radius = ior == 1 ? 0.2 : 0.1;
  scene.render.photons.gather = false;
  // A light of strength 1 brings the irradiance pi; both cosines are 1 over the distance.
  const double cone = 2 * pi * (1 - std::cos(80 * pi / 180)), radiance = pi / cone;
  double truth = 0;
  constexpr int rings = 40, around = 40;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double r = sheet_radius * std::sqrt((i + 0.5) / rings), turn = 2 * pi * (k + 0.5) / around;
      const Vec3d way = Vec3d(aside, 0, 0) - Vec3d(r * std::cos(turn), r * std::sin(turn), 1);
      const double sine = std::hypot(way.x, way.y) / length(way);
      if (ior * sine > std::sin(80 * pi / 180)) continue;
      truth += radiance / pi * (pi * sheet_radius * sheet_radius) / (rings * around) / std::pow(dot(way, way), 2);
    }
  const Means found = mean_of_pictures(scene, 6, 6, 1, 8);
  INFO("mean " << found.mean << " +- " << found.error << ", truth " << truth);
  CHECK(found.error < 0.03 * truth);
  CHECK(std::abs(found.mean - truth) < 4 * found.error);
}

TEST_CASE("photons and paths agree: mirrors, glass with something matt inside, an emitter, a highlight", "[odds]") {
  Scene scene = hollow_ball(3, 0.5, {0, 0, 1.5}, law_of_square);
  scene.objects[0].material.diffuse = {0.6, 0.5, 0.3};
  Material glass = matt(0), mirror = matt(0.2), shiny = matt(0.3);
  glass.transmission = Rgbd(0.9);
  glass.reflection = Rgbd(0.1);
  glass.dielectric = true;
  mirror.reflection = Rgbd(0.7);
  shiny.specular = Rgbd(0.4);
  shiny.shininess = 20;
  scene.objects.push_back({"Glass", Sphere<double>{{1.4, 0.3, 0}, 0.7}, glass});
  scene.objects.push_back({"Core", Sphere<double>{{1.4, 0.3, 0}, 0.3}, matt(0.7)});
  scene.objects.push_back({"Mirror", Sphere<double>{{1.2, -1.3, 0}, 0.5}, mirror});
  scene.objects.push_back({"Shiny", Sphere<double>{{1.2, 1.5, -0.6}, 0.5}, shiny});
  scene.objects.push_back({"Glow", Sphere<double>{{0.2, 0.2, 2}, 0.4}, matt(0, 3)});
  scene.camera.screen = {1, 2.4, 8};
  scene.lights.clear();
  scene = by_photons(scene, 60000, 40);
  check_against_paths(scene, path_estimates(scene, 10, 10, 400));
}

TEST_CASE("the caustic in a cup is a nephroid: the sum of 1 / |J| over all rays that arrive", "[odds]") {
  // Parallel light slants into a cup that is a mirror inside, over the rim before it. Met at the angle t from the
  // middle, the wall sends it on at the angle t to its normal; on the way s a beam becomes 1 - 2 s / (R cos t) times as
  // wide. On the axis at x the ray of the middle arrives, with s = R - x, and behind the cusp at R / 2 a pair with cos
  // t = R / 2 x and s = x.
  constexpr double slope = 1, R = 1;
  Scene scene;
  Material mirror = matt(0);
  mirror.reflection = Rgbd(1.0);
  Cylinder<double> cup;
  cup.radii = {R, R, 1};
  cup.z_min = -0.5;
  cup.z_max = 1.25 * slope;
  scene.objects = {{"Cup", cup, mirror}, {"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(1)}};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{-1, 0, slope}}}};
  scene.camera.up = {0, 1, 0};
  scene = by_photons(scene, 1000000, 60);
  const World<double> world(scene);
  const Emitters<double> emitters(world);
  PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene));
  static_cast<void>(kernel.send(1, 0, 1));
  const PhotonMap& caustic = kernel.maps().front().caustic;
  REQUIRE(caustic.size() > 10000);
  const double level = pi * slope / std::sqrt(1 + slope * slope);  // of the floor without the cup
  const auto irradiance = [&](double x, int k) {
    const PhotonsNear near = caustic.nearest({x, 0, 0}, Vec3d(0, 0, 1), k, 0.05);
    return near.power.x * photon_density(near.squared_radius, false) / level;
  };
  for (const double x : {0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.65, 0.7}) {
    double truth = 1 / std::abs(2 * x / R - 1);
    if (x > R / 2) truth += 2 / (4 * x * x / (R * R) - 1);
    CAPTURE(x, irradiance(x, 300), truth);
    CHECK(irradiance(x, 300) == Approx(truth).epsilon(0.2));
  }
  double brightest = 0, at = 0;
  for (double x = 0.3; x < 0.8; x += 0.005)
    if (irradiance(x, 60) > brightest) brightest = irradiance(x, 60), at = x;
  CHECK(at == Approx(R / 2).margin(0.02));
}

TEST_CASE("watching photons changes nothing, whoever sends them in whatever order") {
  Scene scene = by_photons(hollow_ball(ball_radius, wall_albedo, {0.2, 0, 0}, law_of_square), 20000, 50);
  const World<double> world(scene);
  const Emitters<double> emitters(world);
  const PhotonSettings settings = photon_settings_of(scene);
  PhotonKernel<double> one(scene, world, emitters, settings), other(scene, world, emitters, settings);
  const Statistics first = one.send(3, 0, 1);
  const Statistics second = other.send(3, 0, 1, {}, [](int count, const std::function<void(int)>& body) {
    for (int i = count; i-- > 0;) body(i);
  });
  CHECK(same_counts(first, second));
  const auto same = [](const PhotonMap& a, const PhotonMap& b) {
    return a.size() == b.size() && std::memcmp(a.photons().data(), b.photons().data(), a.size() * sizeof(Photon)) == 0;
  };
  CHECK(one.maps()[0].other.size() > 10000);
  CHECK(same(one.maps()[0].other, other.maps()[0].other));
  Recording recording;
  one.watch_photons(100, recording);
  std::vector<PhotonStored> stored = recording.all<PhotonStored>();
  CHECK(stored.size() > 100);
  int found = 0, kept = 0;
  for (const PhotonStored& each : stored) {
    if (each.history == PhotonHistory::direct) CHECK_FALSE(each.kept);
    if (!each.kept) continue;
    ++kept;
    for (const Photon& photon : one.maps()[0].other.photons())
      if (photon.position == Vec3<float>(each.position) && photon.power == Rgb<float>(each.power)) {
        ++found;
        break;
      }
  }
  CHECK(kept > 50);
  CHECK(found == kept);
  CHECK(recording.all<PhotonBegun>().back().others == 19900);
  // Pixels.
  const RayGenerator<double> camera(scene, {6, 6}, {6, 6}, {1, 3});
  std::vector<Rgbd> plain, watched;
  const auto into = [](std::vector<Rgbd>& to) {
    return PutPixel<double>([&to](const Pixel&, const Rgbd& shade) { to.push_back(shade); });
  };
  const Statistics counted = one(camera, {0, 6, 0, 6}, into(plain));
  CHECK(same_counts(counted, one.watched(camera, {0, 6, 0, 6}, recording, into(watched))));
  CHECK(std::memcmp(plain.data(), watched.data(), plain.size() * sizeof(Rgbd)) == 0);
  CHECK(counted.formed(RayKind::primary) + counted.formed(RayKind::shadow) ==
        counted.ends(Ending::hit) + counted.ends(Ending::missed) + counted.ends(Ending::blocked) +
            counted.ends(Ending::reached_light));
  CHECK(first.formed(RayKind::photon) == first.ends(Ending::hit) + first.ends(Ending::missed));
}

TEST_CASE("a background lights a floor beside which there is nothing") {
  Scene scene = by_photons({}, 1000, 50);
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(0.5)}};
  scene.background = Rgbd(2.0);
  scene = looking(scene, {0, 0, 2}, {3, 0, -3});
  CHECK(mean_of_pictures(scene, 4, 4, 1, 2).mean == Approx(1));
}

TEST_CASE("photons fly all the time that the shutter is open: a shadow that moves is everywhere on its way") {
  Scene scene = by_photons({}, 20000, 50);
  scene.objects = {{"Floor", Box<double>{{-1, -1, -1}, {1, 1, 0}}, matt(0.5)},
                   {"Shade", Box<double>{{-1, -1, 1}, {0, 1, 2}}, matt(0)}};
  scene.objects[1].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};
  scene.render.photons.gather = true;  // photons straight from the sun are kept
  const World<double> world(scene);
  const Emitters<double> emitters(world);
  PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene));
  static_cast<void>(kernel.send(1, 0, 1));
  double left = 0, right = 0;
  for (const Photon& photon : kernel.maps()[0].other.photons())
    (photon.position.x < 0 ? left : right) += static_cast<double>(photon.power.x);
  // pi over each half, of which half is in the shade on average.
  CHECK(left == Approx(pi).epsilon(0.05));
  CHECK(right == Approx(pi).epsilon(0.05));
}

TEST_CASE("what photons leave out is said by the names of the objects") {
  Scene scene = by_photons({}, 1000, 50);
  Cylinder<double> tube;
  tube.z_min = -1, tube.z_max = 1;
  const Polygon<double> dented{{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, {}};
  Prism<double> star;
  star.corners = {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  scene.objects = {{"Ball", Sphere<double>{}, matt(0, 1)},
                   {"Box", Box<double>{}, matt(0.5, 1)},
                   {"Tube", tube, matt(0, 1)},
                   {"Dented", dented, matt(0, 1)},
                   {"Star", star, matt(0, 1)},
                   {"Moving", Sphere<double>{}, matt(0, 1)},
                   {"Floor", Plane<double>{}, matt(0.5)}};
  scene.objects[5].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  scene.camera.shutter_close = 1;
  scene.render.samples = 4;
  const auto names = [&] {
    std::string all;
    for (const std::string& loss : photon_losses(scene)) all += loss.substr(0, loss.find(' ')) + " ";
    return all;
  };
  CHECK(names() == "\"Tube\" \"Dented\" \"Star\" \"Moving\" ");
  // The sides of the star shine, its caps do not; nothing of the others does.
  for (const std::string& loss : photon_losses(scene)) {
    CAPTURE(loss);
    const bool is_star = loss.find("Star") != std::string::npos;
    CHECK((loss.find("lights nothing") != std::string::npos) == !is_star);
    CHECK((loss.find("does not light all that it should") != std::string::npos) == is_star);
  }
  scene.background = Rgbd(1.0);
  CHECK(names() == "\"Tube\" \"Dented\" \"Star\" \"Moving\" \"Floor\" ");
  scene.render.integrator = Integrator::path;
  CHECK(names().empty());
}

TEST_CASE("where nothing shines no photon is sent, and sending can be cancelled") {
  Scene dark = by_photons(hollow_ball(ball_radius, wall_albedo, {0, 0, 0}, law_of_square), 1000, 50);
  const World<double> world(dark);
  const Emitters<double> emitters(world);
  PhotonKernel<double> kernel(dark, world, emitters, photon_settings_of(dark));
  Stopper stopper;
  stopper.raised = true;
  CHECK_THROWS_AS(kernel.send(0, 0, 1, Stop(stopper)), Stopped);
  dark.lights.clear();
  const World<double> night(dark);
  PhotonKernel<double> nothing(dark, night, emitters, photon_settings_of(dark));
  CHECK(nothing.send(0, 0, 1).formed(RayKind::photon) == 0);
  CHECK(nothing.maps()[0].other.empty());
}

TEST_CASE("progressive: circles shrink so that alpha of what is added stays, and each sample has its photons") {
  PhotonSettings settings;
  settings.radius = 2;
  CHECK(settings.squared_radius(0) == 4);
  CHECK(settings.squared_radius(1) == Approx(4 * (1 + 2.0 / 3) / 2));
  CHECK(settings.squared_radius(2) == Approx(4 * (1 + 2.0 / 3) / 2 * (2 + 2.0 / 3) / 3));
  Scene scene = by_photons(hollow_ball(ball_radius, wall_albedo, {0, 0, 0}, law_of_square), 4000, 50);
  scene.render.photons.progressive = true;
  scene.render.photons.radius = 0.5;
  const double bounced = wall_albedo * wall_albedo / (ball_radius * ball_radius) / (1 - wall_albedo);
  check_near(mean_of_pictures(scene, 8, 8, 8, 12), shadow_rays_alone(scene, 8, 8, false) + bounced, 0.02);
}
