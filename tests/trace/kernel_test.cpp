// Invariants 2 and 4: watching changes nothing, unused effects cost nothing, and the kernels agree.

#include <map>
#include <tuple>

#include "support/catch.h"
#include "support/effort.h"
#include "trace/kernel_of.h"
#include "trace/pictures.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// The busy scene without what the set leaves out.
Scene scene_for(const HitEffects& set) {
  Scene scene = busy_scene();
  for (Object& one : scene.objects) {
    Material& material = one.material;
    if (!set.reflection) material.reflection = Rgbd(0.0);
    if (!set.refraction) material.transmission = Rgbd(0.0);
    if (!set.textures) material.checker = std::nullopt;
    if (set.filtering && material.checker) material.checker->filter = CheckerFilter::closed;
    if (set.lobes) material.gloss = 4, material.translucency = 3;
  }
  if (set.microfacets) {
    // The ones of the busy scene that are no glass.
    for (Object& one : scene.objects)
      if (!one.material.transmits()) one.material.mirror = MirrorKind::copper;
    scene.objects[1].material.gloss = 0, scene.objects[1].material.roughness = 0.2;
    for (Object& one : scene.objects) one.material.diffuse_roughness = 0.6;
  }
  if (set.maps) {
    const Image shares{2, 2, {Rgb<float>(0.2F), Rgb<float>(0.9F), Rgb<float>(0.6F), Rgb<float>(0.4F)}};
    const auto pixels = std::make_shared<const Image>(shares);
    for (Object& one : scene.objects) {
      one.material.maps = {{{"shares.png", 0.7, 0.9, pixels}, MappedParameter::diffuse, MapChannel::red},
                           {{"shares.png", 0.4, 0.6, pixels}, MappedParameter::roughness, MapChannel::red}};
      one.material.bump_map = BumpMap{{"shares.png", 1, 1, pixels}, 0.05, MapChannel::red};
    }
  }
  if (set.nesting) {
    Object bubble = scene.objects[2];
    bubble.name = "Bubble";
    bubble.material.ior = 1.2;
    std::get<Sphere<double>>(bubble.shape).radius = 0.5;
    scene.objects.push_back(bubble);
  }
  if (set.sky) scene.sky = Sky{GradientSky{}};
  if (set.penumbra) {
    scene.lights[0].kind = SphereLight{{-3, 3, 2}, 0.7, 2, {0.5, 0.1, 0.05}};
    scene.lights.push_back({"Panel", Rgbd(0.5), RectangleLight{{-2, -3, 1}, {1, 0, 0}, {0, 0, 1}, 1, {}}});
  }
  return scene;
}

constexpr HitEffects with(bool reflection, bool refraction, bool textures, bool penumbra, bool lobes, bool nesting,
                          bool sky = false, bool filtering = false, bool microfacets = false, bool maps = false) {
  return {reflection, refraction, textures,  penumbra,    lobes, true,  nesting, true,
          false,      sky,        filtering, microfacets, maps,  false, false};
}
constexpr HitEffects sets[] = {with(false, false, false, false, false, false),
                               with(false, false, true, true, false, false),
                               with(true, false, false, true, true, false),
                               with(true, false, true, false, false, false),
                               with(true, true, false, false, true, false),
                               with(true, true, false, true, false, false),
                               with(true, true, true, false, false, false),
                               with(true, true, false, false, false, true),
                               with(true, true, true, true, true, true),
                               with(false, false, false, false, false, false, true),
                               with(true, true, true, true, true, true, true),
                               with(false, false, true, false, false, false, false, true),
                               with(true, true, true, false, false, true, false, true),
                               with(true, false, false, false, false, false, false, false, true),
                               with(true, true, true, true, true, true, true, false, true),
                               with(true, true, true, true, true, true, true, true, true),
                               with(false, false, false, false, false, false, false, false, false, true),
                               with(true, true, true, true, true, true, true, true, true, true)};

struct Counter final : Observer {
  std::uint64_t events = 0;
  void record(Event&&) override { ++events; }
};

}  // namespace

TEMPLATE_TEST_CASE("watched and unwatched give the same bits and the same counts", "", float, double) {
  using T = TestType;
  constexpr int width = sanitized ? 31 : 63, height = sanitized ? 23 : 45;
  std::size_t number = 0;
  for (const HitEffects& set : sets) {
    const Scene scene = scene_for(set);
    ++number;
    for (const Sampling sampling : {Sampling{1, 0}, Sampling{5, 42}}) {
      if (left_out(number++, 2)) continue;  // each set has one of them
      Counter counter;
      const auto plain = picture<T>(scene, width, height, sampling);
      const auto watched = watched_picture<T>(scene, width, height, counter, sampling);
      CHECK(same_bits(plain, watched));
      CHECK(same_counts(plain.statistics, watched.statistics));
      CHECK(counter.events > plain.pixels.size() * 5);
    }
  }
}

TEMPLATE_TEST_CASE("each kernel gives the bits of the kernel with every effect", "", float, double) {
  using T = TestType;
  for (const HitEffects& set : sets) {
    CAPTURE(set.reflection, set.refraction, set.textures, set.penumbra, set.lobes, set.nesting, set.sky);
    const Scene scene = scene_for(set);
    REQUIRE(hit_effects(effects_of(scene), scene.lights.size(), !World<double>(scene).bodies.empty()) == set);
    const auto fitting = picture<T>(scene, 63, 45);
    const auto all = picture_by<T>(scene, 63, 45, {}, [](const auto&... arguments) {
      return detail::run_kernel<T, all_hit_effects>(arguments...);
    });
    CHECK(same_bits(fitting, all));
    CHECK(same_counts(fitting.statistics, all.statistics));
  }
}

TEST_CASE("the kernels are different ones") {
  // Each drops what a scene that needs it would miss: the fitting kernel differs from every smaller one.
  const Scene scene = scene_for(all_hit_effects);
  const auto full = picture<double>(scene, 45, 31);
  const auto by = [&](auto run) { return picture_by<double>(scene, 45, 31, {}, run); };
  CHECK(same_bits(full, by([](const auto&... a) { return detail::run_kernel<double, all_hit_effects>(a...); })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, true, false, true, true}>(a...);
                        })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, false, true, true, true, true, false}>(
                              a...);
                        })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, true, true, false, true}>(a...);
                        })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, true, true, true, false}>(a...);
                        })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, true, true, true, true, false}>(a...);
                        })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) {
                          return detail::run_kernel<double, HitEffects{true, true, true, true, true, true, false}>(
                              a...);
                        })));
  CHECK_FALSE(
      same_bits(full, by([](const auto&... a) { return detail::run_kernel<double, HitEffects{.sky = false}>(a...); })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) { return detail::run_kernel<double, no_filtering>(a...); })));
  CHECK_FALSE(same_bits(full, by([](const auto&... a) { return detail::run_kernel<double, no_maps>(a...); })));
}

TEST_CASE("effects that are not called for fire no ray and draw no number") {
  for (const HitEffects& set : sets) {
    const Statistics statistics = picture<double>(scene_for(set), 45, 31).statistics;
    CHECK((statistics.formed(RayKind::reflect) > 0) == set.reflection);
    CHECK((statistics.formed(RayKind::refract) > 0) == set.refraction);
    CHECK((statistics.ends(Ending::total_internal_reflection) > 0) == set.refraction);
    CHECK((statistics.drawn(Effect::penumbra) > 0) == set.penumbra);
    CHECK((statistics.drawn(Effect::gloss) > 0) == set.lobes);
    CHECK((statistics.drawn(Effect::translucency) > 0) == (set.lobes && set.refraction));
    CHECK((statistics.drawn(Effect::microfacets) > 0) == set.microfacets);
    CHECK(statistics.random_draws() == statistics.drawn(Effect::penumbra) + statistics.drawn(Effect::gloss) +
                                           statistics.drawn(Effect::translucency) +
                                           statistics.drawn(Effect::microfacets));
    CHECK(statistics.formed(RayKind::shadow) > 0);
  }
  Scene dark = busy_scene();
  for (Light& light : dark.lights) light.strength = Rgbd(0.0);
  const Statistics statistics = picture<double>(dark, 45, 31).statistics;
  CHECK(statistics.formed(RayKind::shadow) == 0);
  CHECK(statistics.ends(Ending::facing_away) == 0);
}

TEST_CASE("switching an effect on changes no pixel whose rays never meet it") {
  // The sphere's material changes; pixels whose trees never met the sphere keep every bit.
  Scene plain = busy_scene();
  plain.objects[0].material.reflection = Rgbd(0.0);
  for (int effect = 0; effect < 3; ++effect) {
    Scene changed = plain;
    Material& material = changed.objects[0].material;
    if (effect == 0) material.reflection = Rgbd(0.5);
    if (effect == 1) material.transmission = Rgbd(0.5);
    if (effect == 2) material.checker = Checker{Rgbd(0.2), Rgbd(0.9), 0.1};
    Recording recording;
    const auto before = watched_picture<double>(plain, 45, 31, recording);
    const auto after = picture<double>(changed, 45, 31);
    int met = 0, differing = 0, spared = 0;
    bool meets = false;
    for (const Event& event : recording.events) {
      if (std::holds_alternative<PixelBegun>(event.detail)) meets = false;
      if (const auto* found = std::get_if<Found>(&event.detail)) meets = meets || found->object == 0;
      if (const auto* put = std::get_if<PixelPut>(&event.detail)) {
        const bool same = before.at(put->column, put->row) == after.at(put->column, put->row);
        met += meets;
        if (!meets) ++spared, differing += !same;
      }
    }
    CHECK(differing == 0);
    CHECK(met > 50);
    CHECK(spared > 500);
    CHECK_FALSE(same_bits(before, after));
  }
}

TEMPLATE_TEST_CASE("blocks and strides cut the picture without changing it", "", float, double) {
  using T = TestType;
  const Scene scene = busy_scene();
  const auto whole = picture<T>(scene, 31, 23);
  const World<T> world(scene);
  const RayGenerator<T> camera(scene, {31, 23}, {31, 23});
  std::vector<Rgb<T>> pixels(31 * 23, Rgb<T>(-1));
  const PutPixel<T> put = [&](const Pixel& pixel, const Rgb<T>& shade) {
    Rgb<T>& cell = pixels[static_cast<std::size_t>(pixel.row * 31 + pixel.column)];
    CHECK(cell.x == -1);  // each pixel once
    cell = shade;
  };
  Statistics sum;
  for (int row = 0; row < 23; row += 8)
    for (int column = 0; column < 31; column += 10)
      sum += trace(world, camera, {column, std::min(column + 10, 31), row, std::min(row + 8, 23), 0}, put);
  CHECK((pixels == whole.pixels));
  CHECK(same_counts(sum, whole.statistics));

  int visited = 0;
  const PutPixel<T> count = [&](const Pixel& pixel, const Rgb<T>& shade) {
    ++visited;
    CHECK(pixel.column % 4 == 1);
    CHECK(pixel.row % 4 == 2);
    CHECK(shade == whole.at(pixel.column, pixel.row));
  };
  static_cast<void>(trace(world, camera, {1, 31, 2, 23, 0, 4}, count));
  CHECK(visited == 8 * 6);
  // Nothing in nothing.
  static_cast<void>(trace(world, camera, {5, 5, 0, 23, 0}, count));
  static_cast<void>(trace(world, camera, {0, 31, 7, 7, 0}, count));
  CHECK(visited == 8 * 6);
}

TEST_CASE("accelerators make the same picture, bit for bit") {
  const Scene scene = busy_scene();
  const auto by = [&](AcceleratorKind kind) {
    const World<double> world(scene, kind);
    const RayGenerator<double> camera(scene, {45, 31}, {45, 31});
    Picture<double> traced{45, 31, std::vector<Rgbd>(45 * 31), {}};
    traced.statistics = trace(world, camera, {0, 45, 0, 31, 0}, [&](const Pixel& pixel, const Rgbd& shade) {
      traced.pixels[static_cast<std::size_t>(pixel.row * 45 + pixel.column)] = shade;
    });
    return traced;
  };
  const auto expected = by(AcceleratorKind::none);
  for (const auto kind :
       {AcceleratorKind::spheres, AcceleratorKind::ellipsoids, AcceleratorKind::boxes, AcceleratorKind::bvh,
        AcceleratorKind::grid, AcceleratorKind::octree, AcceleratorKind::kdtree}) {
    const auto got = by(kind);
    CHECK(same_bits(got, expected));
    CHECK(got.statistics.rays == expected.statistics.rays);
    CHECK(got.statistics.ended == expected.statistics.ended);
  }
}

TEST_CASE("all samples of a pixel before the next one are the samples of all pixels, one after the other") {
  Scene scene = scene_for({true, true, true, true, true});
  scene.camera.aperture = 0.1;
  for (const Sampler sampler : {Sampler::random, Sampler::jittered, Sampler::sobol}) {
    scene.render.sampler = sampler;
    const World<double> world(scene);
    const Sampling sampling{7, 3};
    const RayGenerator<double> camera(scene, {23, 17}, {23, 17}, sampling);
    using Place = std::tuple<int, int, int>;
    std::map<Place, Rgbd> one_by_one, together;
    const auto into = [](std::map<Place, Rgbd>& shades) {
      return [&shades](const Pixel& pixel, const Rgbd& shade) {
        CHECK(shades.emplace(Place(pixel.column, pixel.row, pixel.sample), shade).second);
      };
    };
    Statistics one_by_one_counts;
    for (int sample = 0; sample < 7; ++sample)
      one_by_one_counts += trace(world, camera, PixelBlock{0, 23, 0, 17, sample}, into(one_by_one));
    Statistics together_counts = trace(world, camera, PixelBlock{0, 23, 0, 17, 0, 1, 4}, into(together));
    together_counts += trace(world, camera, PixelBlock{0, 23, 0, 17, 4, 1, 3}, into(together));
    CHECK(together.size() == 7 * 23 * 17);
    CHECK((one_by_one == together));
    CHECK(same_counts(one_by_one_counts, together_counts));
  }
}
