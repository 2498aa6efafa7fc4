// Why rays end or are not formed, the limits, and the books: every ray that was formed ended.

#include "support/catch.h"
#include "trace/pictures.h"

#include <set>

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::uint64_t rays_formed(const Statistics& statistics) {
  std::uint64_t sum = 0;
  for (const auto rays : statistics.rays) sum += rays;
  return sum;
}

std::uint64_t rays_ended(const Statistics& statistics) {
  return statistics.ends(Ending::hit) + statistics.ends(Ending::missed) + statistics.ends(Ending::blocked) +
         statistics.ends(Ending::reached_light) + statistics.ends(Ending::scattered);
}

// Two facing mirrors, 10 apart, one of them with a light source between them out of the way.
Scene facing_mirrors(const Rgbd& reflection) {
  Material mirror = black();
  mirror.reflection = reflection;
  Scene scene;
  scene.objects = {object("Left", Plane<double>{{-5, 0, 0}, {1, 0, 0}}, mirror),
                   object("Right", Plane<double>{{5, 0, 0}, {-1, 0, 0}}, mirror)};
  return scene;
}

Statistics count(const Scene& scene) { return picture<double>(scene, 1, 1).statistics; }

}  // namespace

TEST_CASE("names of endings and ray kinds are those of the statistics file") {
  std::set<std::string_view> names;
  for (int i = 0; i < ending_count; ++i) names.insert(name_of(static_cast<Ending>(i)));
  CHECK(names == std::set<std::string_view>{"hit", "missed", "blocked", "reached_light", "depth", "threshold",
                                            "total_internal_reflection", "path_length", "facing_away", "outside_cone",
                                            "wrong_side", "scattered"});
  std::set<std::string_view> kinds;
  for (int i = 0; i < ray_kind_count; ++i) kinds.insert(name_of(static_cast<RayKind>(i)));
  CHECK(kinds == std::set<std::string_view>{"primary", "shadow", "reflect", "refract", "photon", "beam"});
}

TEST_CASE("a primary ray hits or misses") {
  Scene scene = looking({}, {0, 0, 0}, {1, 0, 0});
  CHECK(count(scene).ends(Ending::missed) == 1);
  CHECK(count(scene).ends(Ending::hit) == 0);
  scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, black())};
  CHECK(count(scene).ends(Ending::hit) == 1);
  CHECK(count(scene).ends(Ending::missed) == 0);
  CHECK(count(scene).formed(RayKind::primary) == 1);
}

TEST_CASE("a shadow ray reaches the light, is blocked, or is not formed") {
  Scene scene = looking({}, {0, 0, 0}, {1, 0, 0});
  scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, {})};
  scene.lights = {lamp({0, 4, 0}), lamp({9, 0, 0}), {"Sun", Rgbd(1.0), DirectionalLight{{-1, 0, 0}}}};
  Statistics statistics = count(scene);
  CHECK(statistics.formed(RayKind::shadow) == 2);
  CHECK(statistics.ends(Ending::reached_light) == 2);
  CHECK(statistics.ends(Ending::facing_away) == 1);
  CHECK(statistics.ends(Ending::blocked) == 0);
  scene.objects.push_back(object("Behind", Sphere<double>{{-3, 0, 0}, 1}, {}));
  statistics = count(scene);
  CHECK(statistics.ends(Ending::blocked) == 1);
  CHECK(statistics.ends(Ending::reached_light) == 1);
  // A light exactly level with the surface is behind it.
  scene.lights = {lamp({4, 3, 0})};
  CHECK(count(scene).ends(Ending::facing_away) == 1);
}

TEST_CASE("the primary ray's SHADE has depth 1, and N is the deepest") {
  for (const int depth : {1, 2, 3, 10, 50}) {
    Scene scene = looking(facing_mirrors(Rgbd(1.0)), {0, 0, 0}, {5, 0, 0});
    scene.limits.depth = depth;
    const Statistics statistics = count(scene);
    CHECK(statistics.ends(Ending::hit) == static_cast<std::uint64_t>(depth));
    CHECK(statistics.formed(RayKind::reflect) == static_cast<std::uint64_t>(depth - 1));
    CHECK(statistics.ends(Ending::depth) == 1);
    const Recording recording = record_along(scene, {0, 0, 0}, {5, 0, 0});
    int deepest = 0;
    for (const Event& event : recording.events) deepest = std::max(deepest, event.depth);
    CHECK(deepest == depth);
  }
}

TEST_CASE("a ray whose share of the pixel is below the threshold is not formed") {
  Scene scene = looking(facing_mirrors({0.5, 0.25, 0.125}), {0, 0, 0}, {5, 0, 0});
  scene.limits.depth = 100;
  // The largest channel decides: shares 1/2, 1/4, 1/8, 1/16.
  scene.limits.threshold = 0.125;
  Statistics statistics = count(scene);
  CHECK(statistics.formed(RayKind::reflect) == 3);
  CHECK(statistics.ends(Ending::threshold) == 1);
  CHECK(statistics.ends(Ending::depth) == 0);
  scene.limits.threshold = std::nextafter(0.125, 1.0);
  CHECK(count(scene).formed(RayKind::reflect) == 2);
  // At the depth limit, depth is the reason.
  scene.limits.depth = 1;
  scene.limits.threshold = 0.9;
  statistics = count(scene);
  CHECK(statistics.ends(Ending::depth) == 1);
  CHECK(statistics.ends(Ending::threshold) == 0);
  // 0 stops nothing, not even a black share of a ray.
  scene.limits.threshold = 0;
  scene.limits.depth = 2000;
  CHECK(count(scene).formed(RayKind::reflect) == 1999);
}

TEST_CASE("a ray that a facet would send into its surface is no ray below the threshold") {
  Material rough;
  rough.diffuse = Rgbd(0.0), rough.reflection = Rgbd(1.0), rough.roughness = 1;
  Scene scene = looking({}, {0, 0, 1}, {4, 0, 0});
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, rough)};
  scene.render.integrator = Integrator::distributed;
  scene.limits.threshold = 0;
  const Statistics statistics = picture<double>(scene, 16, 16).statistics;
  CHECK(statistics.ends(Ending::threshold) == 0);
  CHECK(statistics.ends(Ending::wrong_side) > 0);
  CHECK(statistics.formed(RayKind::reflect) + statistics.ends(Ending::wrong_side) == statistics.ends(Ending::hit));
}

TEST_CASE("a ray not formed is shown as where it would have gone") {
  Scene scene = facing_mirrors({0.5, 0.25, 0.125});
  scene.limits.depth = 1;
  scene.lights = {lamp({7, 0, 0})};
  const auto missing = record_along(scene, {0, 0, 0}, {5, 0, 0}).all<RayNotFormed>();
  REQUIRE(missing.size() == 2);
  CHECK(missing[0].kind == RayKind::shadow);
  CHECK(missing[0].why == Ending::facing_away);
  CHECK(missing[0].direction == Vec3d(2, 0, 0));
  CHECK(missing[0].light == 0);
  CHECK(missing[1].kind == RayKind::reflect);
  CHECK(missing[1].why == Ending::depth);
  CHECK(missing[1].origin == Vec3d(5, 0, 0));
  CHECK(missing[1].direction == Vec3d(-1, 0, 0));
  CHECK(missing[1].throughput == Rgbd(0.5, 0.25, 0.125));
  CHECK(missing[1].parent == 0);
}

TEMPLATE_TEST_CASE("rays formed = hit + missed + blocked + reached_light", "", float, double) {
  for (const int depth : {1, 2, 6}) {
    Scene scene = busy_scene();
    scene.limits.depth = depth;
    const Picture<TestType> traced = picture<TestType>(scene, 41, 29, {2, 1});
    CHECK(rays_formed(traced.statistics) == rays_ended(traced.statistics));
    CHECK(traced.statistics.formed(RayKind::primary) == 41 * 29 * 2);
    CHECK(traced.statistics.random_draws() == 41 * 29 * 2 * 2);
    CHECK(traced.statistics.not_finite == 0);
    CHECK(traced.statistics.ends(Ending::path_length) == 0);
    CHECK(traced.statistics.tests.primitives > 0);
  }
}

TEST_CASE("the recording tells the same story as the statistics") {
  Recording recording;
  const auto traced = watched_picture<double>(busy_scene(), 17, 13, recording);
  std::uint64_t ended[ending_count] = {}, formed[ray_kind_count] = {};
  std::vector<RayFormed> rays;
  int next = 0;
  for (const Event& event : recording.events) {
    if (const auto* one = std::get_if<RayFormed>(&event.detail)) {
      ++formed[static_cast<std::size_t>(one->kind)];
      CHECK(one->ray == next++);
      CHECK(one->parent < one->ray);
      CHECK((one->parent == -1) == (one->kind == RayKind::primary));
      rays.push_back(*one);
    } else if (const auto* found = std::get_if<Found>(&event.detail)) {
      ++ended[static_cast<std::size_t>(found->ending)];
      const RayFormed& ray = rays.at(static_cast<std::size_t>(found->ray));
      const bool met = found->ending == Ending::hit || found->ending == Ending::blocked;
      CHECK((found->object >= 0) == met);
      CHECK((found->ending == Ending::blocked || found->ending == Ending::reached_light) ==
            (ray.kind == RayKind::shadow));
      if (met) {
        CHECK(length(ray.origin + found->t * ray.direction - found->point) < 1e-9 * (1 + found->t));
        CHECK(length(found->normal) == Approx(1));
        CHECK(found->numbers.index() != 0);
      }
    } else if (const auto* missing = std::get_if<RayNotFormed>(&event.detail)) {
      ++ended[static_cast<std::size_t>(missing->why)];
    } else if (const auto* decided = std::get_if<Decided>(&event.detail)) {
      if (decided->why) ++ended[static_cast<std::size_t>(*decided->why)];
      if (event.depth > 0) CHECK(decided->holds == !is_black(decided->weight));
    } else if (const auto* sum = std::get_if<ShadeComputed>(&event.detail)) {
      Rgbd total = sum->ambient + sum->emission + sum->reflect + sum->refract;
      CHECK(sum->lights.size() == 2);  // the dark one is left out
      for (const LightTerm& term : sum->lights) total += term.diffuse + term.specular;
      CHECK(length(total - sum->total) < 1e-12);
    } else if (const auto* put = std::get_if<PixelPut>(&event.detail)) {
      CHECK(put->shade == traced.at(put->column, put->row));
    }
  }
  for (std::size_t i = 0; i < ending_count; ++i) CHECK(ended[i] == traced.statistics.ended[i]);
  for (std::size_t i = 0; i < ray_kind_count; ++i) CHECK(formed[i] == traced.statistics.rays[i]);
}

TEST_CASE("a blocked shadow ray is told up to its nearest blocker") {
  Scene scene;
  scene.objects = {object("Table", Plane<double>{}, {}), object("Far", Sphere<double>{{0, 0, 6}, 0.5}, {}),
                   object("Near", Sphere<double>{{0, 0, 2}, 0.5}, {}),
                   object("Mid", Sphere<double>{{0, 0, 4}, 0.5}, {})};
  scene.lights = {lamp({0, 0, 10})};
  for (const Found& found : record_along(scene, {3, 0, 1}, {0, 0, 0}).all<Found>())
    if (found.ending == Ending::blocked) {
      CHECK(found.object == 2);
      CHECK(found.t == Approx(0.15));
      CHECK(length(found.point - Vec3d(0, 0, 1.5)) < 1e-12);
      return;
    }
  FAIL("no blocked ray");
}

TEST_CASE("the lines of a pixel come in the order of the pseudocode") {
  Scene scene;
  scene.objects = {object("Table", Plane<double>{}, {})};
  scene.lights = {lamp({0, 0, 10}), lamp({0, 0, -10})};
  std::vector<Line> lines;
  for (const Event& event : record_along(scene, {3, 0, 1}, {0, 0, 0}).events) lines.push_back(event.line);
  CHECK((lines == std::vector<Line>{Line::for_each_pixel, Line::form_primary_ray, Line::find_closest_intersection,
                                    Line::if_intersect_something, Line::shade_final, Line::form_shadow_ray,
                                    Line::find_intersection, Line::form_shadow_ray, Line::if_reflective,
                                    Line::if_transparent, Line::compute_rtnshade, Line::put_final_shade}));
}
