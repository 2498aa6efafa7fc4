// The walk through PENCIL TRACING: its shades are whitted's, and its matrices the derivatives of its rays.

#include "inspect/pencil_walk.h"
#include "io/scene_file.h"
#include "timeline/event_json.h"
#include "timeline/message.h"
#include "timeline/recorder.h"
#include "trace/scene_kernel.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "support/catch.h"
#include "timeline/messages.h"
#include "trace/pencil_derivatives.h"

using namespace raywalk;
using test::Derivatives;
using test::difference;

namespace {

Scene shipped(const std::string& name, Integrator integrator = Integrator::pencils) {
  Scene scene = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml")->scene;
  scene.render.integrator = integrator;
  return scene;
}

/// Alike to the last bit, all NaNs alike.
bool same(const Rgbd& one, const Rgbd& other) {
  const auto alike = [](double a, double b) { return a == b || (a != a && b != b); };
  return alike(one.x, other.x) && alike(one.y, other.y) && alike(one.z, other.z);
}

/// The shades of a picture, watched or not.
template <class T>
std::vector<Rgbd> shades(const Scene& scene, bool watched) {
  struct Deaf final : Observer {
    void record(Event&& /*event*/) override {}
  };
  const World<T> world(scene);
  const SceneKernel<T> kernel(scene, world);
  const RayGenerator<T> camera(scene, scene.image, scene.image, {2});
  std::vector<Rgbd> all;
  const PutPixel<T> put = [&](const Pixel&, const Rgb<T>& shade) { all.push_back(Rgbd(shade)); };
  PixelBlock block{0, scene.image.width, 0, scene.image.height};
  block.samples = 2;
  Deaf deaf;
  if (watched)
    kernel.watched(camera, block, deaf, put);
  else
    kernel(camera, block, put);
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("pencils have the shades of whitted's rays, bit for bit, watched or not", "", float, double) {
  for (const std::string name : {"classic", "mirrors", "glass", "glass_in_water", "whitted", "pencils", "penumbra",
                                 "gloss", "filters", "metals"}) {
    Scene scene = shipped(name);
    scene.image = {21, 15};
    const std::vector<Rgbd> pencils = shades<TestType>(scene, true), unwatched = shades<TestType>(scene, false);
    scene.render.integrator = Integrator::whitted;
    const std::vector<Rgbd> rays = shades<TestType>(scene, false);
    CAPTURE(name);
    REQUIRE(pencils.size() == rays.size());
    REQUIRE(unwatched.size() == rays.size());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) differ += !same(pencils[i], rays[i]) || !same(unwatched[i], rays[i]);
    CHECK(differ == 0);
  }
}

TEST_CASE("a walk of pencils is that of rays, with a step for each matrix") {
  for (const std::string name : {"classic", "glass", "pencils"})
    for (const Numerics numerics : {Numerics::robust, Numerics::naive}) {
      Scene scene = shipped(name);
      scene.render.numerics = numerics;
      const Timeline pencils = record_strip(scene);
      scene.render.integrator = Integrator::whitted;
      const Timeline rays = record_strip(scene);
      CAPTURE(name);
      REQUIRE(pencils.of_pencils());
      CHECK_FALSE(rays.of_pencils());
      CHECK_FALSE(pencils.has_width());
      REQUIRE(pencils.rays().size() == rays.rays().size());
      int step = 0, own = 0;
      for (int i = 0; i < pencils.steps(); ++i) {
        if (std::holds_alternative<PencilChanged>(pencils.event(i).detail)) {
          ++own;
          continue;
        }
        REQUIRE(step < rays.steps());
        CHECK(without_pencil(pencils.event(i).line) == rays.event(step).line);
        CHECK(with_pencil(rays.event(step).line) == pencils.event(i).line);
        CHECK(pencils.event(i).detail.index() == rays.event(step).detail.index());
        ++step;
      }
      CHECK(step == rays.steps());
      CHECK(own > 20);
      for (std::size_t i = 0; i < rays.pixels().size(); ++i)
        CHECK(same(pencils.pixels()[i].shade, rays.pixels()[i].shade));
    }
}

TEST_CASE("after each step the matrix is the derivative of the rays beside the axis, in the plan and in space") {
  int transfers = 0, mirrored = 0, refracted = 0, curved = 0, mixed = 0;
  const auto follow = [&](const Scene& scene, const Timeline& timeline) {
    const World<double> world(scene);
    const auto camera = camera_of<double>(scene, timeline);
    const auto& primitives = world.accelerator.primitives();
    struct Met {
      Hit<double> hit;
      SurfacePoint<double> point;
    };
    std::vector<std::optional<Derivatives>> beside(timeline.rays().size());
    std::vector<std::optional<Met>> met(timeline.rays().size());
    std::vector<std::optional<PencilSystem>> systems(timeline.rays().size());
    for (int i = 0; i < timeline.steps(); ++i) {
      const Event& event = timeline.event(i);
      const int index = timeline.current_ray(i + 1);
      const auto at = static_cast<std::size_t>(std::max(index, 0));
      if (const auto* formed = std::get_if<RayFormed>(&event.detail); formed && formed->kind == RayKind::primary) {
        beside[at].emplace(normalize(formed->direction));
        systems[at] = PencilSystem{};
      }
      const auto* changed = std::get_if<PencilChanged>(&event.detail);
      if (changed == nullptr) continue;
      const RayRecord& ray = timeline.rays()[at];
      const Vec3d axis = normalize(ray.direction);
      CAPTURE(i, index);
      REQUIRE(changed->system);
      // Of a strip, whose rays may leave the plan where a surface leans.
      const bool in_plan = timeline.of_strip() && ray.origin.z == 0 && ray.direction.z == 0;
      CHECK((!in_plan || changed->system->is_unmixed()));
      mixed += !changed->system->is_unmixed();
      if (event.line == Line::transfer_pencil) {
        // By what the walk itself met.
        const Ray<double> again{ray.origin, axis,
                                ray.parent < 0 ? Departure{}
                                               : Departure{met[static_cast<std::size_t>(ray.parent)]->hit.primitive,
                                                           met[static_cast<std::size_t>(ray.parent)]->hit.part},
                                0};
        const auto found = find_surface(world, again);
        REQUIRE(found);
        met[at] = Met{found->hit, found->point};
        beside[at]->each([&](const auto& one) { return transfer(one, axis, found->hit.t, found->point.normal); });
        ++transfers;
        CHECK(difference(*changed->system, beside[at]->system(axis)) < 1e-10);
        if (in_plan)
          CHECK(difference({step_of(*changed, event.line) * systems[at]->plan, changed->system->across},
                           *changed->system) < 1e-14);
        systems[at] = changed->system;
        continue;
      }
      const RayRecord& before = timeline.rays()[static_cast<std::size_t>(ray.parent)];
      const Vec3d came = normalize(before.direction);
      const Met& left = *met[static_cast<std::size_t>(ray.parent)];
      const double side = dot(came, left.point.normal) <= 0 ? 1 : -1;
      const Vec3d normal = side * left.point.normal;
      Derivatives next = *beside[static_cast<std::size_t>(ray.parent)];
      next.each([&](const RayDerivative<double>& one) {
        const Vec3d turn =
            side * primitives.normal_derivative(left.hit.primitive, left.point, left.hit.part, 0.0, one.dP);
        if (event.line == Line::reflect_pencil) return reflect(one, came, normal, turn);
        return refract(one, came, normal, turn, refraction_at(came, normal, changed->snell->n1, changed->snell->n2));
      });
      (event.line == Line::reflect_pencil ? mirrored : refracted) += 1;
      curved += changed->curvature != 0;
      CHECK(difference(*changed->system, next.system(axis)) < 1e-10);
      beside[at] = next;
      if (in_plan) {
        const PencilMatrix step = step_of(*changed, event.line);
        CHECK(difference({step * systems[static_cast<std::size_t>(ray.parent)]->plan, changed->system->across},
                         *changed->system) < 1e-14);
        // The pencil that the plan draws has the same matrix.
        const std::vector<PencilStage> stages = pencil_of(world, camera, timeline, index);
        REQUIRE_FALSE(stages.empty());
        CHECK(difference({stages.back().start, stages.back().start_across}, *changed->system) < 1e-10);
      }
      systems[at] = changed->system;
    }
  };
  for (const std::string name : {"classic", "mirrors", "glass", "glass_in_water", "whitted", "pencils"}) {
    CAPTURE(name);
    const Scene scene = shipped(name);
    follow(scene, record_strip(scene, {Precision::double_}));
    for (const int row : {4, 7, 11})
      for (int column = 1; column < 21; column += 2) {
        CAPTURE(column, row);
        follow(scene, record_pixel(scene, {21, 15}, column, row, {Precision::double_}));
      }
  }
  CAPTURE(transfers, mirrored, refracted, curved, mixed);
  CHECK(transfers > 300);
  CHECK(mirrored > 100);
  CHECK(refracted > 150);
  CHECK(curved > 150);
  CHECK(mixed > 100);
}

TEST_CASE("a pencil is not followed where a relief sends its axis elsewhere than the surface itself would") {
  Scene scene = shipped("maps");
  for (Object& object : scene.objects) object.material.reflection = Rgbd(0.5);
  int lost = 0, followed = 0;
  for (int column = 0; column < 21; ++column) {
    const Timeline timeline = record_pixel(scene, {21, 15}, column, 7);
    for (int position = 1; position <= timeline.steps(); ++position) {
      const auto* changed = std::get_if<PencilChanged>(&timeline.event(position - 1).detail);
      if (changed == nullptr) continue;
      CHECK((describe(scene, timeline, position).id == "walk.pencil_lost") == !changed->system);
      (changed->system ? followed : lost) += 1;
    }
  }
  CHECK(lost > 20);
  CHECK(followed > 20);
}

TEST_CASE("a pencil of a ball lens meets where its image of EYE is") {
  // Of the scene's ball, n = 1.5 and radius 1 about the origin; EYE is 4.5 before it, and its image 2.25 behind.
  const Scene scene = shipped("pencils");
  const Timeline timeline = record_strip(scene, {Precision::double_});
  int in_the_middle = 0;
  for (int i = 0; i < timeline.steps(); ++i) {
    const Event& event = timeline.event(i);
    const RayRecord* ray = timeline.current_ray(i + 1) < 0
                               ? nullptr
                               : &timeline.rays()[static_cast<std::size_t>(timeline.current_ray(i + 1))];
    if (event.line != Line::refract_pencil || ray->depth != 2 || std::abs(ray->origin.y) > 1e-12) continue;
    const auto& changed = std::get<PencilChanged>(event.detail);
    const auto focus = focus_of_point(changed.system->plan);
    REQUIRE(focus);
    CHECK(ray->origin.x + *focus == Approx(2.25).epsilon(1e-10));
    CHECK(*focus_of_parallel(changed.system->plan) + 1 == Approx(1.5 * 2 / (4 * 0.5)).epsilon(1e-10));
    ++in_the_middle;
  }
  CHECK(in_the_middle == 1);
}

TEST_CASE("every line and every sentence of pencils is walked") {
  std::set<Line> lines;
  std::set<std::string_view> messages;
  const auto walk = [&](const Scene& scene, const Timeline& timeline) {
    REQUIRE(timeline.of_pencils());
    for (int position = 1; position <= timeline.steps(); ++position) {
      const std::string_view id = describe(scene, timeline, position).id;
      CHECK_FALSE(id.empty());
      messages.insert(id);
      const auto* changed = std::get_if<PencilChanged>(&timeline.event(position - 1).detail);
      if (changed != nullptr)
        CHECK(event_json(scene, timeline.event(position - 1)).contains("matrix") == changed->system.has_value());
      lines.insert(timeline.event(position - 1).line);
    }
  };
  for (const char* name : {"classic", "mirrors", "glass", "pencils"}) {
    const Scene scene = shipped(name);
    walk(scene, record_strip(scene));
  }
  for (const char* name : {"glass", "mirrors", "pencils"}) {
    const Scene scene = shipped(name);
    for (int row = 1; row < 15; row += 3)
      for (int column = 0; column < 21; ++column) walk(scene, record_pixel(scene, {21, 15}, column, row));
  }
  Scene dented = shipped("maps");
  dented.objects[2].material.reflection = Rgbd(0.5);
  for (int column = 5; column < 15; ++column) walk(dented, record_pixel(dented, {21, 15}, column, 7));
  // From the focus of a hollow mirror, to first order: rays leave side by side.
  Scene hollow = shipped("mirrors");
  Material mirror;
  mirror.reflection = Rgbd(1.0);
  hollow.camera.eye = {1, 0, 0}, hollow.camera.look_at = {5, 0, 0};
  hollow.camera.screen = {1, 0.2, 3};
  hollow.objects = {{"Hollow", Sphere<double>{{0, 0, 0}, 2}, mirror}};
  hollow.limits.depth = 2;
  walk(hollow, record_strip(hollow, {Precision::double_}));
  walk(hollow, record_pixel(hollow, {1, 3}, 0, 1, {Precision::double_}));
  CHECK(lines.size() == pencil_line_count);
  for (const std::string_view id : test::pencil_messages) {
    INFO(id);
    CHECK(messages.count(id) == 1);
  }
}
