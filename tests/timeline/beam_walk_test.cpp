// The walk through BEAM TRACING: what the timeline and the messages make of its events, and the strip that it fills.

#include "math/random.h"
#include "timeline/message.h"
#include "timeline/recorder.h"
#include "trace/beam_kernel.h"
#include "trace/kernel.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "messages.h"
#include "support/catch.h"
#include "width_scenes.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// A mirror, round and straight things, of one shade each.
Scene shades() {
  Scene scene = plain_scene(Integrator::beams);
  Material mirror = shining(Rgbd(0.05));
  mirror.reflection = {0.9, 0.8, 0.7};
  scene.objects = {{"Red", Prism<double>{{{-2, -0.3}, {-0.5, -1.2}, {-2, -1.7}}, 1}, shining({1, 0, 0})},
                   {"Green", Sphere<double>{{-1.3, 1.1, 0}, 0.8}, shining({0, 1, 0})},
                   {"Blue", Box<double>{{0, 0.4, -1}, {3, 3, 1}}, shining({0, 0, 1})},
                   {"White", Sphere<double>{{2.5, -0.8, 0}, 0.9}, shining(Rgbd(1.0))},
                   {"Mirror", Prism<double>{{{-3, -3}, {2, -2.6}, {2, -3.4}}, 1}, mirror}};
  return scene;
}

/// Straight things in the light of a sun, so that each is as bright as another of its side, or in shadow.
Scene sunlit() {
  Scene scene = shades();
  Material matt;
  matt.diffuse = {0.2, 0.7, 0.3};
  matt.ambient = Rgbd(0.1);
  scene.objects[0].material = scene.objects[2].material = matt;
  scene.objects.push_back({"Back", Box<double>{{4, -9, -1}, {5, 9, 1}}, matt});
  scene.lights = {{"Sun", Rgbd(0.8), DirectionalLight{{-1, 0.7, 0}}}};
  return scene;
}

/// Of one shade, that a checker can be on.
Material dyed(double share) {
  Material material;
  material.ambient = Rgbd(share);
  material.diffuse = Rgbd(0.0);
  return material;
}

/// Checkers on all that is straight, round or endless, some in sunlight, and in a mirror.
Scene chequered() {
  Scene scene = sunlit();
  scene.ambient = Rgbd(1.0);
  for (const std::size_t i : {1U, 3U}) scene.objects[i].material = dyed(0.9);
  const auto checker = [](double size) { return Checker{{0.9, 0.8, 0.1}, {0.1, 0.2, 0.4}, size, {}}; };
  scene.objects[0].material.checker = checker(0.3);
  scene.objects[1].material.checker = checker(0.2);
  scene.objects[2].material.checker = checker(0.7);
  scene.objects[3].material.checker = checker(0.45);
  scene.objects[5].material.checker = checker(1.1);
  Material far = dyed(0.6);
  far.checker = checker(3);
  scene.objects.push_back({"Wall", Plane<double>{{14, 0.3, 0}, {-4, 3, 0}}, far});
  return scene;
}

/// From within a round room: its checker, in the light of a spot in the middle that ends at once.
Scene round_room() {
  Scene scene = plain_scene(Integrator::beams);
  Material matt;
  matt.diffuse = {0.6, 0.7, 0.3};
  matt.ambient = Rgbd(0.1);
  matt.checker = Checker{{0.9, 0.8, 0.1}, {0.1, 0.2, 0.4}, 1.3, {}};
  scene.objects = {{"Room", Sphere<double>{{0.5, 0.2, 0}, 7}, matt},
                   {"Post", Box<double>{{2, -1, -1}, {2.2, -0.7, 1}}, shining({1, 0, 0})}};
  scene.lights = {{"Spot", Rgbd(0.9), SpotLight{{0.5, 0.2, 0}, {3, -0.4, 0}, 50, 50, {}}}};
  return scene;
}

/// With lights, glass and round mirrors as well.
Scene lit() {
  Scene scene = shades();
  Material matt, chrome, glass;
  matt.diffuse = {0.2, 0.7, 0.3};
  matt.specular = Rgbd(0.4);
  chrome.diffuse = glass.diffuse = Rgbd(0.05);
  chrome.reflection = Rgbd(0.8);
  glass.transmission = Rgbd(0.9);
  glass.dielectric = true;
  scene.objects[1].material = matt;
  scene.objects[2].material = glass;
  scene.objects[3].material = chrome;
  scene.objects.push_back({"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matt});
  scene.lights = {{"Lamp", Rgbd(0.9), PointLight{{-3, 4, 0}, {1, 0, 0}}},
                  {"Sun", Rgbd(0.2), DirectionalLight{{-1, -0.4, 0}}}};
  return scene;
}

struct Sampled {
  std::vector<Rgbd> means, squares;  // of the pixels
};

/// A strip by the tracer itself: columns so fine that `samples` of them make a pixel.
Sampled sampled(const Scene& scene, int pixels, int samples) {
  const int strata = samples * pixels;
  Scene rays = scene;
  rays.render.integrator = Integrator::whitted;
  const World<double> world(rays);
  const RayGenerator<double> camera(rays, {strata, 1}, rays.image);
  Sampled of{std::vector<Rgbd>(static_cast<std::size_t>(pixels), Rgbd(0.0)), {}};
  of.squares = of.means;
  static_cast<void>(trace(world, camera, {0, strata, 0, 1}, [&](const Pixel& pixel, const Rgbd& shade) {
    const auto i = static_cast<std::size_t>(pixel.column / samples);
    of.means[i] += shade / static_cast<double>(samples);
    of.squares[i] += shade * shade / static_cast<double>(samples);
  }));
  return of;
}

double largest(const Rgbd& off) { return std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}); }

double unit(int index, std::uint32_t dimension) {
  RandomKey key;
  key.seed = 18;
  key.sample = static_cast<std::uint32_t>(index);
  key.dimension = dimension;
  return random_unit<double>(key);
}

}  // namespace

TEST_CASE("a walk of beams: each is cut into parts, whose coverages are those of its pixel") {
  const Scene scene = lit();
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_beams());
  CHECK(timeline.is_flat());
  CHECK_FALSE(timeline.of_paths());
  CHECK(timeline.pixels().size() == 16);
  for (std::size_t pixel = 0; pixel < timeline.pixels().size(); ++pixel) {
    const auto [first, last] = timeline.rays_of_pixel(static_cast<int>(pixel));
    double sum = 0;
    for (int i = first; i < last; ++i) {
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
      if (ray.parent == first) sum += timeline.beams()[static_cast<std::size_t>(ray.beam)].coverage;
      if (ray.kind == RayKind::beam && ray.parent >= 0 && ray.formed) CHECK(ray.beam >= 0);
      if (ray.kind == RayKind::shadow || ray.kind == RayKind::refract) CHECK(timeline.part_of(i) == ray.parent);
    }
    CHECK(sum == Approx(1).epsilon(1e-14));
    CHECK(timeline.stack(timeline.pixels()[pixel].done_at).empty());
  }
}

TEST_CASE("watching beams changes nothing") {
  for (const Scene& scene : {shades(), lit()}) {
    const World<double> world(scene);
    const std::vector<Outline> outlines = outlines_of(scene);
    const RayGenerator<double> camera(scene, {16, 1}, scene.image);
    const std::vector<Rgbd> watched = shades_of_strip(scene);
    int put = 0;
    static_cast<void>(trace_beams(world, outlines, camera, {0, 16, 0, 1}, [&](const Pixel& pixel, const Rgbd& shade) {
      CHECK(shade == watched[static_cast<std::size_t>(pixel.column)]);
      ++put;
    }));
    CHECK(put == 16);
  }
}

TEST_CASE("where parts have one shade each, beams are the mean of a million samples") {
  const Scene scene = GENERATE(shades(), sunlit(), chequered(), round_room());
  const std::vector<Rgbd> strip = shades_of_strip(scene);
  constexpr int pixels = 16, samples = 1 << 16;
  const Sampled rays = sampled(scene, pixels, samples);
  bool mixed = false;
  for (std::size_t i = 0; i < pixels; ++i) {
    const Rgbd mean = rays.means[i];
    // Each outline that crosses a pixel can put one sample of its row on the wrong side.
    CAPTURE(i);
    CHECK(largest(strip[i] - mean) < 24.0 / samples);
    const Rgbd spread = rays.squares[i] - mean * mean;
    mixed = mixed || spread.x + spread.y + spread.z > 0.01;
  }
  CHECK(mixed);
}

TEST_CASE(
    "where a part has more than one shade, the walk says by how much, and the mean of a million samples is near") {
  // A spot's light on a straight wall is as bright nowhere as elsewhere, and falls off at its rim.
  Scene scene = sunlit();
  Material matt;
  matt.diffuse = Rgbd(0.8);
  matt.checker = Checker{{0.9, 0.8, 0.1}, {0.1, 0.2, 0.4}, 1.3, {}};
  scene.objects = {{"Wall", Box<double>{{2, -20, -1}, {3, 20, 1}}, matt}};
  scene.lights = {{"Spot", Rgbd(1.2), SpotLight{{-1, 0.6, 0}, {2, -0.4, 0}, 80, 50, {}}}};
  const Timeline timeline = record_strip(scene);
  const Sampled rays = sampled(scene, 16, 1 << 16);
  int told = 0, at = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const PixelRecord& pixel = timeline.pixels()[i];
    double bound = 0;
    for (; at < pixel.done_at; ++at)
      if (const auto* added = std::get_if<PartAdded>(&timeline.event(at).detail)) bound += added->share * added->off;
    CAPTURE(i, bound);
    CHECK(largest(pixel.shade - rays.means[i]) < bound / 4 + 24.0 / (1 << 16));
    CHECK(bound < 0.35);
    told += bound > 0.001;
  }
  CHECK(told > 4);
  // Squares that are too many to be cut are their mean, and said to differ.
  scene.lights.clear();
  scene.ambient = Rgbd(1.0);
  scene.objects[0].material = dyed(1);
  scene.objects[0].material.checker = Checker{Rgbd(1.0), Rgbd(0.0), 0.001, {}};
  const Timeline fine = record_strip(scene);
  int means = 0;
  for (int step = 0; step < fine.steps(); ++step)
    if (const auto* added = std::get_if<PartAdded>(&fine.event(step).detail)) {
      CHECK(added->shade.x == 0.5);
      CHECK(added->off == 0.5);
      ++means;
    }
  CHECK(means == 16);
}

TEST_CASE("where light varies along a part, its middle stands for it: near the mean, and the same for equal shades") {
  for (const Rgbd& shade : shades_of_strip(lit())) CHECK(std::isfinite(shade.x + shade.y + shade.z));
  // In a round mirror the light varies more than the middle of what it shows can tell.
  Scene scene = lit();
  scene.objects[3].material = scene.objects[1].material;
  const std::vector<Rgbd> strip = shades_of_strip(scene);
  const Sampled rays = sampled(scene, 16, 1 << 10);
  double off = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    CAPTURE(i, largest(strip[i] - rays.means[i]));
    CHECK(largest(strip[i] - rays.means[i]) < 0.04);
    off += largest(strip[i] - rays.means[i]) / 16;
  }
  CAPTURE(off);
  CHECK(off < 0.006);
  Scene plain = plain_scene(Integrator::beams);
  plain.objects = {{"One", Box<double>{{0, -9, -1}, {1, 0.1, 1}}, shining(Rgbd(0.7))},
                   {"Two", Box<double>{{0, 0.1, -1}, {1, 9, 1}}, shining(Rgbd(0.7))}};
  for (const Rgbd& shade : shades_of_strip(plain)) CHECK(shade == Rgbd(0.7));
}

namespace {

/// A slab of glass before chequered walls.
Scene slab(double ior) {
  Scene scene = chequered();
  scene.limits.depth = 4;
  scene.objects[4].material = scene.objects[0].material;
  Material glass;
  glass.diffuse = glass.specular = Rgbd(0.0);
  glass.ambient = Rgbd(0.0);
  glass.transmission = Rgbd(1.0);
  glass.ior = ior;
  glass.shadow = ShadowKind::filtered;
  scene.objects.push_back({"Glass", Prism<double>{{{-3.5, -2.4}, {-3.0, -2.5}, {-2.6, 2.2}, {-3.1, 2.3}}, 1}, glass});
  return scene;
}

}  // namespace

TEST_CASE("through flat glass of index 1 beams go straight on, and see what they see without it") {
  Scene without = slab(1);
  without.objects.pop_back();
  const std::vector<Rgbd> bare = shades_of_strip(without);
  const Timeline timeline = record_strip(slab(1));
  int formed = 0;
  for (int at = 0; at < timeline.steps(); ++at) {
    CHECK(timeline.event(at).line != Line::form_middle_ray);
    const auto* beam = std::get_if<BeamFormed>(&timeline.event(at).detail);
    if (beam == nullptr || !beam->snell) continue;
    CHECK(beam->off == 0);
    CHECK(length(beam->apex - slab(1).camera.eye) < 1e-14);
    ++formed;
  }
  CHECK(formed > 20);
  for (std::size_t i = 0; i < bare.size(); ++i) CHECK(largest(timeline.pixels()[i].shade - bare[i]) < 1e-12);
}

TEST_CASE("beyond flat glass the middle of a beam goes as Snell's law says, and its ends are as far off as it says") {
  const auto beside = [](int cells) {
    Scene scene = slab(1.5);
    scene.camera.screen = {2, 3.0, cells};
    const Timeline timeline = record_strip(scene);
    int formed = 0;
    double sum = 0;
    for (int at = 0; at < timeline.steps(); ++at) {
      const auto* beam = std::get_if<BeamFormed>(&timeline.event(at).detail);
      if (beam == nullptr || !beam->snell) continue;
      // The part that it comes of, as it was cut.
      const BeamPiece* from = nullptr;
      for (int before = 0; before < at; ++before)
        if (const auto* cut = std::get_if<BeamCut>(&timeline.event(before).detail))
          for (const BeamPiece& piece : cut->pieces)
            if (piece.ray == beam->parent) from = &piece;
      REQUIRE(from != nullptr);
      const Vec3d comes = normalize(from->point - from->origin), goes = normalize(from->point - beam->apex);
      CHECK(length(cross(comes, from->normal)) * beam->snell->n1 ==
            Approx(length(cross(goes, from->normal)) * beam->snell->n2).epsilon(1e-9));
      CHECK(dot(comes, goes) > 0.5);
      CHECK(beam->snell->n1 != beam->snell->n2);
      // It starts where the part ends.
      for (std::size_t i = 0; i < beam->area.starts.size(); ++i) {
        const Vec3d start = beam->area.starts[i], way = beam->area.ends[i] - start;
        CHECK(dot(start - from->point, from->normal) == Approx(0).margin(1e-12));
        CHECK(std::abs(cross(plan(start - beam->apex), plan(way))) < 1e-9 * length(way));
      }
      sum += beam->off;
      ++formed;
    }
    CHECK(formed > 10);
    return sum / formed;
  };
  const double wide = beside(8), narrow = beside(64);
  CAPTURE(wide, narrow);
  CHECK(wide > 1e-4);
  CHECK(wide < 0.1);
  CHECK(narrow < wide / 4);
  // And what is seen beyond is as rays see it, the nearer the narrower pixels are.
  const auto off = [](int cells) {
    Scene scene = slab(1.5);
    scene.camera.screen = {2, 3.0, cells};
    const std::vector<Rgbd> strip = shades_of_strip(scene);
    const Sampled rays = sampled(scene, cells, 1 << 10);
    double sum = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) sum += largest(strip[i] - rays.means[i]) / cells;
    return sum;
  };
  const double eight = off(8), many = off(64);
  CAPTURE(eight, many);
  CHECK(eight < 0.03);
  CHECK(many < 0.006);
}

TEST_CASE("at the critical angle a beam in glass is cut: on one side all of it is reflected") {
  Scene scene = slab(1.5);
  scene.objects.back().shape = Prism<double>{{{-9, -5}, {-5, -5}, {-5, 5}, {-9, 5}}, 1};  // with EYE in it
  scene.camera.screen = {0.5, 4.2, 16};
  const Timeline timeline = record_strip(scene);
  std::set<int> edges;
  int bent = 0, total = 0;
  for (int at = 0; at < timeline.steps(); ++at) {
    const auto* cut = std::get_if<BeamCut>(&timeline.event(at).detail);
    if (cut == nullptr) continue;
    for (std::size_t i = 0; i + 1 < cut->pieces.size(); ++i) {
      const BeamPiece &one = cut->pieces[i], &other = cut->pieces[i + 1];
      if (one.object != 7 || other.object != 7 || length(one.normal - other.normal) > 1e-9) continue;
      const Vec3d edge = normalize(one.area.ends.back() - one.area.starts.back());
      if (length(one.area.ends.back() - one.area.ends.front()) == 0) continue;
      CHECK(length(cross(edge, one.normal)) == Approx(1 / 1.5).epsilon(1e-12));
      edges.insert(at);
    }
  }
  for (int at = 0; at < timeline.steps(); ++at) {
    const Event& event = timeline.event(at);
    const auto* decided = std::get_if<Decided>(&event.detail);
    if (decided == nullptr || event.depth != 1) continue;
    bent += event.line == Line::if_flat_glass && decided->holds;
    total += event.line == Line::if_flat_mirror && decided->holds;
  }
  CHECK(edges.size() >= 2);
  CHECK(bent > 3);
  CHECK(total > 3);
}

TEST_CASE("beams are followed only where every outline is known") {
  Scene scene = lit();
  CHECK(why_no_beams(scene).empty());
  scene.objects.push_back({"Egg", Sphere<double>{{0, 0, 0}, 1}, Material{}});
  scene.objects.back().transform.push_back({Scale{{1, 2, 1}}});
  CHECK(why_no_beams(scene) == "Egg is transformed");
  CHECK(object_against_beams(scene) == "Egg");
  CHECK_FALSE(record_strip(scene).of_beams());
  // One whose name begins with another's.
  scene.objects.push_back(scene.objects.back());
  scene.objects.back().name = "Egg 2";
  scene.objects[scene.objects.size() - 2].transform.clear();
  CHECK(why_no_beams(scene) == "Egg 2 is transformed");
  CHECK(object_against_beams(scene) == "Egg 2");
  scene.objects.back().transform.clear();
  scene.camera.eye.z = 1;
  CHECK(why_no_beams(scene) == "the eye does not lie in z = 0");
  CHECK(object_against_beams(scene).empty());
}

TEST_CASE("random plans of beams have finite shades and whole walks") {
  for (int number = 0; number < 60; ++number) {
    Scene scene = lit();
    scene.limits.depth = 4;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const double x = 4 * unit(number, static_cast<std::uint32_t>(3 * i)) - 2,
                   y = 4 * unit(number, static_cast<std::uint32_t>(3 * i + 1)) - 2;
      if (auto* sphere = std::get_if<Sphere<double>>(&scene.objects[i].shape)) sphere->centre += Vec3d(x, y, 0);
      if (auto* prism = std::get_if<Prism<double>>(&scene.objects[i].shape))
        for (Vec2d& corner : prism->corners) corner += Vec2d(x, y);
      if (unit(number, static_cast<std::uint32_t>(3 * i + 2)) < 0.4) scene.objects[i].material.reflection = Rgbd(0.5);
    }
    CAPTURE(number);
    const Timeline timeline = record_strip(scene);
    for (const PixelRecord& pixel : timeline.pixels())
      CHECK(std::isfinite(pixel.shade.x + pixel.shade.y + pixel.shade.z));
    for (int position = 1; position <= timeline.steps(); ++position)
      CHECK_FALSE(describe(scene, timeline, position).id.empty());
  }
}

TEST_CASE("every line and every message of beam tracing is reached") {
  std::set<std::string_view> messages;
  std::set<Line> lines;
  Scene alone = plain_scene(Integrator::beams);
  alone.objects = {shades().objects[1]};
  Scene shallow = lit(), faint = lit();
  Scene air = lit();
  air.objects[2].material.ior = 1;
  shallow.limits.depth = 1;
  faint.limits.threshold = 0.95;
  for (const Scene& scene : {lit(), alone, shallow, faint, air}) {
    const Timeline timeline = record_strip(scene);
    REQUIRE(timeline.of_beams());
    for (int position = 1; position <= timeline.steps(); ++position) {
      messages.insert(describe(scene, timeline, position).id);
      lines.insert(timeline.event(position - 1).line);
    }
  }
  const Timeline pixel = record_pixel(lit(), {16, 11}, 3, 5);
  for (int position = 1; position <= pixel.steps(); ++position) messages.insert(describe(lit(), pixel, position).id);
  CHECK(lines.size() == beam_line_count);
  for (const std::string_view id : test::beam_messages) {
    INFO(id);
    CHECK(messages.count(id) == 1);
  }
}

namespace {

/// A light's width above a matt wall along x, which is seen from below, and something between them.
Scene penumbra(const ObjectShape& blocker, const AnyLight& light) {
  Scene scene = plain_scene(Integrator::beams);
  Material matt;
  matt.diffuse = Rgbd(1.0);
  matt.ambient = Rgbd(0.0);
  scene.camera.eye = {0, -1.5, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.objects = {{"Wall", Box<double>{{-20, 0, -1}, {20, 1, 1}}, matt}, {"Blocker", blocker, shining(Rgbd(0.0))}};
  scene.lights = {{"Tube", Rgbd(1.0), light}};
  return scene;
}

/// Of each part of the wall, where its middle is and how much of the light is said to be uncovered.
std::vector<std::pair<double, double>> uncovered_along(const Timeline& timeline) {
  std::vector<std::pair<double, double>> found;
  for (const RayRecord& ray : timeline.rays())
    if (ray.kind == RayKind::shadow && ray.formed) found.emplace_back(ray.origin.x, max_component(ray.transmittance));
  return found;
}

}  // namespace

TEST_CASE("a light's width behind an edge and behind a circle is seen as closed forms say") {
  // The light from (-3, -6) to (-1, -6); what is between stands at y = -3, halfway from the wall.
  const RectangleLight tube{{-3, -6, -1}, {2, 0, 0}, {0, 0, 2}, 4, {}};
  int partly = 0;
  SECTION("an edge") {
    // Everything left of x = -1.2 is hidden: of the light, what is left of 2 (-1.2) - x.
    const Timeline timeline = record_strip(penumbra(Box<double>{{-30, -3, -1}, {-1.2, -2.999999, 1}}, tube));
    for (const auto& [x, seen] : uncovered_along(timeline)) {
      CAPTURE(x);
      const double expected = std::clamp((-1 - (2 * -1.2 - x)) / 2, 0.0, 1.0);
      CHECK(seen == Approx(expected).epsilon(0).margin(1e-6));
      partly += expected > 0 && expected < 1;
    }
  }
  SECTION("a circle") {
    const Vec2d centre{-1.3, -3};
    const double radius = 0.4;
    const Timeline timeline = record_strip(penumbra(Sphere<double>{{centre.x, centre.y, 0}, radius}, tube));
    for (const auto& [x, seen] : uncovered_along(timeline)) {
      CAPTURE(x);
      // The tangents from (x, 0), and where they meet the light's line.
      const double away = length(centre - Vec2d(x, 0)), half = std::asin(radius / away);
      const double towards = std::atan2(centre.x - x, -centre.y);
      const double low = x + 6 * std::tan(towards - half), high = x + 6 * std::tan(towards + half);
      const double hidden = std::max(std::min(high, -1.0) - std::max(low, -3.0), 0.0) / 2;
      CHECK(seen == Approx(1 - hidden).epsilon(0).margin(1e-12));
      partly += hidden > 0 && hidden < 1;
    }
  }
  CHECK(partly > 3);
}

TEST_CASE("inside of a circle its outline hides the lights outside, and no light that is inside, too") {
  Scene scene = penumbra(Sphere<double>{{9, 0, 0}, 0.1}, SphereLight{{-5, 0, 0}, 0.5, 1, {}});
  scene.objects[0] = {"Room", Sphere<double>{{0, 0, 0}, 2}, scene.objects[0].material};
  for (const double x : {-5.0, 0.5})
    for (const bool tube : {true, false}) {
      CAPTURE(x, tube);
      scene.lights[0].kind = SphereLight{{x, 0, 0}, 0.2, 1, {}};
      if (!tube) scene.lights[0].kind = RectangleLight{{x, -0.2, -1}, {0, 0.4, 0}, {0, 0, 2}, 1, {}};
      for (const Rgbd& shade : shades_of_strip(scene)) CHECK((shade.x > 0.05) == (x > 0));
    }
}

TEST_CASE("a light that sinks into the plane of a surface lights it by what lies before it") {
  // Along y from -1 to 2, and the wall is seen from below y = 0.
  const RectangleLight post{{4, -1, -1}, {0, 3, 0}, {0, 0, 2}, 4, {}};
  Scene scene = penumbra(Box<double>{{-30, -3, -1}, {-29, -2.9, 1}}, post);
  for (const bool shadows : {true, false}) {
    scene.render.switches.shadows = shadows;
    const Timeline timeline = record_strip(scene);
    const auto found = uncovered_along(timeline);
    CHECK(found.size() > 3);
    for (const auto& [x, seen] : found) CHECK(seen == Approx(1.0 / 3).epsilon(1e-12));
    for (const RayRecord& ray : timeline.rays())
      if (ray.kind == RayKind::shadow && ray.formed)
        CHECK(ray.direction.y == Approx(-0.5 - ray.origin.y).epsilon(1e-9));
  }
}

TEST_CASE("of a light with an extent the walk says how much is uncovered, and draws its width") {
  const RectangleLight tube{{-3, -6, -1}, {2, 0, 0}, {0, 0, 2}, 4, {}};
  const Scene scene = penumbra(Box<double>{{-30, -3, -1}, {-1.2, -2.9, 1}}, tube);
  const Timeline timeline = record_strip(scene);
  std::set<std::string_view> said;
  for (int position = 0; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    said.insert(message.id);
    if (message.id == "walk.light_partly") CHECK(std::get<std::string>(message.arguments.front().value) == "Tube");
  }
  for (const std::string_view id : {"walk.light_partly", "walk.light_uncovered", "walk.light_covered_by"})
    CHECK(said.contains(id));
  for (const RayRecord& ray : timeline.rays())
    if (ray.kind == RayKind::shadow && ray.formed) CHECK(ray.end_radius > 0);
}

TEST_CASE("a pixel of the picture is walked by beams, too, to the shade that it has there") {
  Scene scene = lit();
  const Timeline timeline = record_pixel(scene, {16, 12}, 9, 6);
  REQUIRE(timeline.of_beams());
  CHECK_FALSE(timeline.is_flat());
  const auto [first, last] = timeline.rays_of_pixel(0);
  double sum = 0;
  for (int i = first; i < last; ++i) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
    if (ray.kind == RayKind::beam && ray.parent == first)
      sum += timeline.beams()[static_cast<std::size_t>(ray.beam)].coverage;
  }
  CHECK(sum == Approx(1).epsilon(1e-12));
  std::set<std::string_view> said;
  for (int position = 0; position <= timeline.steps(); ++position) said.insert(describe(scene, timeline, position).id);
  CHECK(said.contains("walk.image_beam_formed"));
  CHECK(said.contains("walk.part_added") + said.contains("walk.last_part_added") > 0);
  scene.objects[0].motion = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
  CHECK_FALSE(record_pixel(scene, {16, 12}, 9, 6).of_beams());
}

TEST_CASE("in space, too, a part of a curved mirror says how far rays near its border are off") {
  Scene scene = plain_scene(Integrator::beams);
  Material mirror = shining(Rgbd(0.0));
  mirror.reflection = Rgbd(0.9);
  scene.background = Rgbd(0.0);
  scene.camera.eye = {0, -6, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.objects = {{"Mirror", Sphere<double>{{0, 0, 0}, 1}, mirror},
                   {"Wall", Box<double>{{0.3, -30, -30}, {30, -12, 30}}, shining(Rgbd(1.0))}};
  int alike = 0, differ = 0, flat = 0;
  for (int column = 0; column < 16; ++column) {
    const Timeline timeline = record_pixel(scene, {16, 12}, column, 6);
    for (int i = 0; i < timeline.steps(); ++i) {
      const auto* added = std::get_if<PartAdded>(&timeline.event(i).detail);
      if (added == nullptr) continue;
      CAPTURE(column, added->off);
      const bool curved = max_component(added->reflect) > 0 || added->off > 0;
      if (added->off == 0) (curved ? alike : flat) += 1;
      if (added->off > 0) ++differ;
      // Each ray sees the wall, or nothing.
      CHECK((added->off == 0 || added->off == Approx(0.9)));
    }
  }
  CHECK(alike > 0);
  CHECK(differ > 0);
  CHECK(flat > 0);
}
