// What maps make of a surface at a point: against closed forms, the normals of true reliefs, and tests of chi-square.

#include "trace/surface_maps.h"
#include "math/sampler.h"
#include "math/sampling.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/one_of_each.h"
#include "trace/bsdf.h"
#include "trace/chi_square.h"
#include "trace/map_images.h"
#include "trace/optics.h"
#include "trace/texture.h"

#include <numbers>
#include <optional>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material mirror() {
  Material material;
  material.diffuse = Rgbd(0.0);
  material.reflection = Rgbd(1.0);
  return material;
}

SurfaceMaps<double> reliefs_of(const Material& material) {
  return {material, SurfaceValues<double>{}, SurfaceValues<double>{}, true, true};
}

Material normal_mapped(const std::shared_ptr<const Image>& pixels, double width = 1, double height = 1,
                       double strength = 1) {
  Material material;
  material.normal_map = NormalMap{{"normals.png", width, height, pixels}, strength};
  return material;
}

Material bump_mapped(const std::shared_ptr<const Image>& pixels, double width, double height, double relief) {
  Material material;
  material.bump_map = BumpMap{{"heights.png", width, height, pixels}, relief, MapChannel::red};
  return material;
}

// A hit on the front of a shape, as seen from `eye` towards the middle of it.
struct HitOn {
  SurfacePoint<double> point;
  int part;
};
std::optional<HitOn> hit_on(const Primitives<double>& primitives, const Vec3d& eye, const Vec3d& target) {
  const Ray<double> ray{eye, normalize(target - eye)};
  const auto met = primitives.intersect(0, ray, infinity<double>);
  if (!met) return std::nullopt;
  return HitOn{primitives.surface_at(0, ray, *met), met->part};
}

Vec3d random_direction(std::uint32_t i, std::uint32_t which) {
  RandomKey key{};
  key.sample = i, key.dimension = 4 * which;
  const Vec2d u = draw_pair<double>(Sampler::random, key, Strata(1u << 20));
  const double z = 2 * u.x - 1, turn = 2 * pi_v<double> * u.y, sin = std::sqrt(1 - z * z);
  return {sin * std::cos(turn), sin * std::sin(turn), z};
}

}  // namespace

TEST_CASE("a map is bilinear in the shape's own lengths, and a number that of its channel") {
  const auto pixels = pixels_of(2, 1, {{0.2, 0.4, 0.6}, {0.8, 0.6, 0.0}});
  Material material;
  material.shininess = 100;
  material.maps = {{{"map.png", 4, 2, pixels}, MappedParameter::diffuse, MapChannel::red},
                   {{"map.png", 4, 2, pixels}, MappedParameter::shininess, MapChannel::blue}};
  SurfaceValues<double> own{};
  own.diffuse = Rgbd(1.0), own.shininess = 100;
  const SurfaceMaps<double> maps(material, own, own, true, true);
  const auto at = [&](double u) { return maps.mixed(maps.at({u, 0.3})); };
  CHECK(at(1).diffuse.y == Approx(0.4));
  CHECK(at(3).diffuse.y == Approx(0.6));
  CHECK(at(1.5).diffuse.x == Approx(0.35));
  CHECK(at(1.5).shininess == Approx(45));
  CHECK(at(5.5).shininess == Approx(45));  // it repeats
}

TEST_CASE("a map goes on beyond its first copy as it says, each way by itself") {
  // Rows from the top: the first copy has 1 2 3 over 4 5 6.
  const auto pixels = pixels_of(3, 2, {Rgbd(1), Rgbd(2), Rgbd(3), Rgbd(4), Rgbd(5), Rgbd(6)});
  // At the centre of a pixel, counted from the lower left of the first copy.
  const auto at = [&](double width, double height, ImageWrap wrap, std::optional<ImageWrap> wrap_v, int column,
                      int row) {
    Material material;
    material.maps = {{{"map.png", width, height, pixels, wrap, wrap_v}, MappedParameter::shininess, MapChannel::red}};
    SurfaceValues<double> own{};
    own.shininess = 1;
    const SurfaceMaps<double> maps(material, own, own, true, true);
    const Vec2d uv((column + 0.5) / 3 * std::abs(width), (row + 0.5) / 2 * std::abs(height));
    const double value = maps.at(uv).first.shininess;
    CHECK(value == Approx(std::round(value)).margin(1e-9));
    return static_cast<int>(std::round(value));
  };
  const auto row_of = [&](double width, double height, ImageWrap wrap, std::optional<ImageWrap> wrap_v, int row) {
    std::string numbers;
    for (int column = -5; column < 9; ++column) numbers += std::to_string(at(width, height, wrap, wrap_v, column, row));
    return numbers;
  };
  using enum ImageWrap;
  // Five columns before the first copy, its three, and six after it.
  CHECK(row_of(6, 1, repeat, {}, 0) == "56456456456456");
  CHECK(row_of(6, 1, clamp, {}, 0) == "44444456666666");
  CHECK(row_of(6, 1, mirror, {}, 0) == "56654456654456");
  CHECK(row_of(6, 1, clamp, {}, 7) == "11111123333333");
  CHECK(row_of(6, 1, clamp, {}, -7) == "44444456666666");
  CHECK(row_of(6, 1, mirror, {}, 2) == "23321123321123");  // above the upper row: that row again
  CHECK(row_of(6, 1, mirror, {}, -1) == "56654456654456");
  CHECK(row_of(6, 1, clamp, repeat, -1) == "11111123333333");
  CHECK(row_of(6, 1, repeat, clamp, -3) == "56456456456456");
  CHECK(row_of(6, 1, clamp, mirror, 3) == "44444456666666");
  // As glTF lays it, with v downward, and mirrored each way: between the same ends.
  CHECK(row_of(1, -1, clamp, {}, 0) == "11111123333333");
  CHECK(row_of(1, -1, clamp, {}, 1) == "44444456666666");
  CHECK(row_of(1, -1, clamp, {}, 5) == "44444456666666");
  CHECK(row_of(1, -1, mirror, {}, -1) == "23321123321123");
  CHECK(row_of(1, -1, mirror, {}, 2) == "56654456654456");
  CHECK(row_of(1, -1, repeat, clamp, -4) == "23123123123123");
  CHECK(row_of(-6, 1, clamp, {}, 0) == "66666654444444");
  CHECK(row_of(-6, 1, mirror, {}, 0) == "54456654456654");
}

TEST_CASE("a roughness between two that there are tables of is the mixture of them that has its alpha") {
  Material material = mirror();
  material.roughness = 0.8;
  const auto pixels = pixels_of(2, 1, {Rgbd(0.1), Rgbd(0.9)});
  material.maps = {{{"map.png", 2, 1, pixels}, MappedParameter::roughness, MapChannel::red}};
  SurfaceValues<double> own{};
  own.reflection = Rgbd(1.0);
  const SurfaceMaps<double> maps(material, own, own, true, true);
  int mixed = 0;
  for (double u = 0.5; u <= 1.5; u += 0.01) {
    const auto values = maps.mixed(maps.at({u, 0.5}));
    const auto facets = maps.facets(values, nullptr);
    REQUIRE(facets.mirror != nullptr);
    const double low = facets.mirror->facets->alpha();
    if (facets.rougher == nullptr) {
      CHECK(values.roughness == Approx(low));
      continue;
    }
    ++mixed;
    const double high = facets.rougher->facets->alpha();
    CHECK(values.roughness == Approx(low + facets.share * (high - low)));
    CHECK(std::sqrt(high) - std::sqrt(low) < 0.0626);
  }
  CHECK(mixed > 80);
  // Where it is 0, the mirror is sharp.
  MappedValues<double> smooth = maps.mixed(maps.at({0.5, 0.5}));
  smooth.roughness = 0;
  CHECK(maps.facets(smooth, nullptr).mirror == nullptr);
}

TEST_CASE("a mixture of two roughnesses sends directions as its density says, and white ones stay white") {
  Material material = mirror();
  material.roughness = 0.2;
  const Microsurface<double> smoother(material);
  material.roughness = 0.7;
  const Microsurface<double> rougher(material);
  using Glass = RoughDielectric<double>;
  const Glass glass(0.2, 1, 1.5), rougher_glass(0.6, 1, 1.5);
  for (const bool is_glass : {false, true})
    for (const double degrees : {10.0, 60.0}) {
      if (left_out(degrees > 30, 2)) continue;
      CAPTURE(is_glass, degrees);
      Bsdf<double> bsdf;
      bsdf.incident = {std::sin(degrees * (std::numbers::pi / 180)), 0, -std::cos(degrees * (std::numbers::pi / 180))};
      bsdf.shading_normal = bsdf.geometric_normal = {0, 0, 1};
      const double cos = std::cos(degrees * (std::numbers::pi / 180));
      if (is_glass) {
        bsdf.take_glass(glass, 1, cos, Rgbd(1.0));
        bsdf.mix_glass(rougher_glass, 0.3, cos);
        CHECK(bsdf.mirror.x + bsdf.transparent.x == Approx(1));
      } else {
        bsdf.mirror = Rgbd(1.0);
        bsdf.facets = &smoother, bsdf.rougher = &rougher, bsdf.rougher_share = 0.3;
      }
      bsdf.prepare(Rgbd(1.0));
      Bsdf<double> one = bsdf, other = bsdf;
      one.rougher = nullptr, one.rougher_glass = nullptr, one.rougher_share = 0;
      other.rougher = nullptr, other.rougher_glass = nullptr, other.rougher_share = 0;
      if (is_glass)
        other.glass = &rougher_glass;
      else
        other.facets = &rougher;
      for (const Vec3d& d : {Vec3d(0.1, 0.3, 0.9), Vec3d(-0.5, 0.2, 0.4), Vec3d(0.2, 0.1, -0.8)}) {
        const Vec3d at = normalize(d);
        CHECK(bsdf.evaluate(at).value.x ==
              Approx(0.7 * one.evaluate(at).value.x + 0.3 * other.evaluate(at).value.x).epsilon(1e-9));
        CHECK(bsdf.highlight_of_facets(at).x ==
              Approx(0.7 * one.highlight_of_facets(at).x + 0.3 * other.highlight_of_facets(at).x).epsilon(1e-9));
      }
      const auto draw = [&](const Vec2d& u, double chosen) { return bsdf.sample(bsdf.sample_lobe(chosen), u, chosen); };
      double sum = 0, weights = 0;
      constexpr std::uint32_t n = rounds(1 << 17);
      std::uint32_t i = 0;
      const double off = chi_square_deviation(
          n, [&](const Vec3d& d) { return bsdf.evaluate(d).pdf; },
          [&](const Vec2d& u) -> std::optional<Vec3d> {
            const BsdfSample<double> choice = draw(u, (i++ + 0.5) / n);
            sum += choice.weight.x, weights += choice.weight.x * choice.weight.x;
            if (!(choice.pdf > 0)) return std::nullopt;
            return choice.direction;
          });
      CHECK(off < 4.5);
      const double mean = sum / n, error = std::sqrt((weights / n - mean * mean) / n);
      CHECK(std::abs(mean - 1) < 4.5 * error + 2e-3);
    }
}

TEST_CASE("a flat normal map and a flat height are no maps, up to rounding") {
  for (const Shape<double>& shape : one_of_each()) {
    Primitives<double> primitives;
    primitives.add(shape);
    const auto hit = hit_on(primitives, {0.3, -0.4, 5}, {0.05, 0.02, 0});
    if (!hit) continue;
    const SurfacePoint<double>& point = hit->point;
    for (const Material& material : {normal_mapped(uniform({0.5, 0.5, 1})), bump_mapped(uniform(Rgbd(0.7)), 1, 1, 3)})
      CHECK(length(reliefs_of(material).bent(primitives, 0, point, hit->part, 0, point.normal) - point.normal) < 1e-12);
  }
}

TEST_CASE("red leans along u, green along v, on every shape and however it is placed") {
  int seen = 0;
  for (const Shape<double>& shape : one_of_each())
    for (const bool placed : {false, true}) {
      Primitives<double> primitives;
      Affine<double> map;
      map.x = {0.8, 0.3, 0}, map.y = {-0.3, 0.9, 0.1}, map.z = {0.1, 0, 1.2}, map.move = {0.1, 0, 0.2};
      if (placed)
        primitives.add(shape, *object_transform<double>(map));
      else
        primitives.add(shape);
      for (const Vec3d& eye : {Vec3d(0.3, -0.4, 5), Vec3d(4, 3, 0.1), Vec3d(-4, 1, 1)}) {
        const auto hit = hit_on(primitives, eye, {0.05, 0.02, 0.04});
        if (!hit) continue;
        ++seen;
        CAPTURE(shape.index(), placed, eye.x);
        const SurfacePoint<double>& at = hit->point;
        const auto leaning = [&](const Vec3d& normal, double width = 1, double height = 1) {
          const Vec3d bent = reliefs_of(normal_mapped(uniform(coded(normal)), width, height))
                                 .bent(primitives, 0, at, hit->part, 0, at.normal);
          CHECK(length(bent) == Approx(1));
          CHECK(dot(bent, at.normal) == Approx(0.8).epsilon(1e-6));
          const Vec3d along = bent - dot(bent, at.normal) * at.normal;
          return primitives.uv_derivative(0, at, hit->part, 0, along);
        };
        CHECK(leaning({0.6, 0, 0.8}).x > 0);
        CHECK(leaning({-0.6, 0, 0.8}).x < 0);
        CHECK(leaning({0, 0.6, 0.8}).y > 0);
        CHECK(leaning({0, -0.6, 0.8}).y < 0);
        CHECK(std::abs(leaning({0.6, 0, 0.8}).y) < 1e-9 + 0.9 * std::abs(leaning({0.6, 0, 0.8}).x));
        // Copies that lie upside down or mirrored lean the other way.
        CHECK(leaning({0, 0.6, 0.8}, 1, -1).y < 0);
        CHECK(leaning({0.6, 0, 0.8}, -1, 1).x < 0);
      }
    }
  CHECK(seen > 40);
}

TEST_CASE("strength is a factor of the slope") {
  Primitives<double> primitives;
  primitives.add(Shape<double>(Plane<double>{{0, 0, 0}, {0, 0, 1}}));
  const SurfacePoint<double> at{{0.3, 0.2, 0}, {0, 0, 1}};
  for (const double strength : {0.0, 0.5, 2.0}) {
    const Vec3d bent = reliefs_of(normal_mapped(uniform(coded({0.48, 0.36, 0.8})), 1, 1, strength))
                           .bent(primitives, 0, at, 0, 0, at.normal);
    CHECK(bent.x / bent.z == Approx(0.6 * strength));
    CHECK(bent.y / bent.z == Approx(0.45 * strength));
  }
}

TEST_CASE("a ramp of heights is a slope, the same all over") {
  constexpr int n = 64;
  const auto along_u = image_of(n, 1, [](double u, double) { return Rgbd(u); });
  const auto along_v = image_of(1, n, [](double, double v) { return Rgbd(v); });
  Primitives<double> primitives;
  primitives.add(Shape<double>(Plane<double>{{0, 0, 0}, {0, 0, 1}}));
  for (double place = 0.1; place < 0.9; place += 0.0371) {
    const SurfacePoint<double> at{{2 * place, 2 * place, 0}, {0, 0, 1}};
    const auto bent = [&](const std::shared_ptr<const Image>& heights, double relief) {
      return reliefs_of(bump_mapped(heights, 2, 2, relief)).bent(primitives, 0, at, 0, 0, at.normal);
    };
    // It climbs by the relief over one copy of 2.
    CHECK(length(bent(along_u, 0.5) - normalize(Vec3d(-0.25, 0, 1))) < 1e-5);
    CHECK(length(bent(along_v, 0.5) - normalize(Vec3d(0, -0.25, 1))) < 1e-5);
    CHECK(length(bent(along_u, -3) - normalize(Vec3d(1.5, 0, 1))) < 1e-5);
  }
}

TEST_CASE("a bump map has the normals of the relief that it says") {
  constexpr double relief = 2e-4, size = 0.01;  // so low that the shape's own curvature does not count
  const auto waves = image_of(96, 96, [](double u, double v) {
    return Rgbd(0.5 + 0.25 * std::sin(2 * pi_v<double> * u) + 0.25 * std::cos(2 * pi_v<double> * v));
  });
  const Material material = bump_mapped(waves, size, 1.3 * size, relief);
  const SurfaceMaps<double> maps = reliefs_of(material);
  int seen = 0;
  for (const Shape<double>& shape : one_of_each()) {
    Primitives<double> primitives;
    Affine<double> map;
    map.x = {0.8, 0.3, 0}, map.y = {-0.3, 0.9, 0.1}, map.z = {0.1, 0, 1.2};
    primitives.add(shape, *object_transform<double>(map));
    const auto hit = hit_on(primitives, {0.3, -0.4, 5}, {0.05, 0.02, 0.04});
    if (!hit) continue;
    ++seen;
    const SurfacePoint<double>& at = hit->point;
    // The relief itself: points of the surface about the hit, moved along their normals.
    const auto raised = [&](const Vec3d& aside) -> std::optional<Vec3d> {
      const Vec3d above = at.position + aside + 0.01 * at.normal;
      const Ray<double> down{above, -at.normal};
      const auto met = primitives.intersect(0, down, infinity<double>);
      if (!met) return std::nullopt;
      const SurfacePoint<double> there = primitives.surface_at(0, down, *met);
      const Vec2d uv = primitives.uv_at(0, there, met->part);
      const double height = static_cast<double>(texture_colour<double>(*waves, uv.x / size, uv.y / (1.3 * size)).x);
      return there.position + relief * height * there.normal;
    };
    const Basis<double> about(at.normal);
    constexpr double step = size / 96 / 2;
    const auto right = raised(step * about.s), left = raised(-step * about.s), up = raised(step * about.t),
               down = raised(-step * about.t);
    if (!right || !left || !up || !down) continue;
    const Vec3d truth = normalize(cross(*right - *left, *up - *down));
    const Vec3d bent = maps.bent(primitives, 0, at, hit->part, 0, at.normal);
    CAPTURE(shape.index());
    CHECK(length(bent - truth) < 0.01);
    CHECK(length(bent - at.normal) > 0.002);
  }
  CHECK(seen > 9);
}

TEST_CASE("a bent normal faces the ray, mirrors it above the surface, and changes without steps") {
  int kept = 0, clamped = 0;
  constexpr std::uint32_t n = rounds(20000);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec3d geometric(0, 0, 1);
    Vec3d incident = random_direction(i, 0);
    incident.z = -std::abs(incident.z) * (i % 3 == 0 ? 1e-4 : 1);
    incident = normalize(incident);
    const Vec3d bent = random_direction(i, 1);
    const Vec3d normal = clamped_shading_normal(incident, geometric, bent);
    CHECK(std::abs(length(normal) - 1) < 1e-9);
    CHECK(dot(normal, incident) < 0);
    CHECK(reflect(incident, normal).z > 0);
    CHECK(normal.z > 0);
    (normal == bent ? kept : clamped) += 1;
    CHECK(reflect(incident, normal).z > 0.999 * std::min(-incident.z, 0.05) - 1e-9);
    // No further than needed.
    if (normal != bent && bent.z > 0.1 && dot(bent, incident) < -0.1) CHECK(reflect(incident, normal).z < 0.0501);
    if (!(bent.z > 0.05) || !(incident.z < -0.05)) continue;
    const Vec3d near = normalize(bent + 1e-6 * random_direction(i, 2));
    CHECK(length(clamped_shading_normal(incident, geometric, near) - normal) < 1e-3);
  }
  CHECK(kept > rounds(2000));
  CHECK(clamped > rounds(2000));
}
