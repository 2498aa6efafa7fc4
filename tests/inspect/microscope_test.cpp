// The numerical microscope, held against exact arithmetic and against the tracer.
#include "inspect/microscope.h"

#include "io/scene_file.h"
#include "timeline/recorder.h"

#include <cmath>
#include <string>

#include "support/catch.h"

using namespace raywalk;

namespace {

Scene scene_of(const std::string& name) {
  return read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml")->scene;
}

/// Every hit of a scene's strip.
struct Hits {
  Hits(const Scene& recorded, Precision its_precision, int samples = 1)
      : scene(recorded),
        precision(its_precision),
        timeline(std::make_shared<const Timeline>(record_strip(recorded, {its_precision, {samples}}))) {}

  template <class See>
  void each(See see) {
    int count = 0;
    for (const RayRecord& ray : timeline->rays()) {
      if (!ray.formed || ray.kind == RayKind::shadow || ray.ending != Ending::hit) continue;
      const auto specimen = microscope.look(timeline, ray.found_at, scene, precision);
      REQUIRE(specimen);
      see(*specimen, ray);
      ++count;
    }
    REQUIRE(count > 0);
  }

  Scene scene;
  Precision precision;
  std::shared_ptr<const Timeline> timeline;
  Microscope microscope;
};

Scene with_epsilon(Scene scene, double epsilon, Numerics numerics = Numerics::robust) {
  scene.render.epsilon = epsilon;
  scene.render.numerics = numerics;
  return scene;
}

int self_hits(const std::optional<Reading>& reading) {
  int sum = 0;
  if (reading)
    for (const SpawnedRays& rays : reading->spawned) sum += rays.hit_own;
  return sum;
}
int wrong(const std::optional<Reading>& reading) {
  int sum = 0;
  if (reading)
    for (const SpawnedRays& rays : reading->spawned) sum += rays.hit_own + rays.astray;
  return sum;
}

/// The sign of what is left of a sphere's or a plane's equation at a place, exactly; 2 for other shapes.
int exact_side(const Scene& scene, int object, const Vec3d& p, Precision precision) {
  const bool single = precision == Precision::float_;
  const auto stored = [&](double x) { return single ? static_cast<double>(static_cast<float>(x)) : x; };
  const ObjectShape& shape = scene.objects[static_cast<std::size_t>(object)].shape;
  if (const auto* s = std::get_if<Sphere<double>>(&shape)) {
    Expansion sum = -(Expansion(stored(s->radius)) * stored(s->radius));
    for (int axis = 0; axis < 3; ++axis) {
      const Expansion off = Expansion(p[axis]) - stored(s->centre[axis]);
      sum = sum + off * off;
    }
    return sum.sign();
  }
  if (const auto* plane = std::get_if<Plane<double>>(&shape)) {
    Expansion sum;
    for (int axis = 0; axis < 3; ++axis)
      sum = sum + (Expansion(p[axis]) - stored(plane->point[axis])) * stored(plane->normal[axis]);
    return sum.sign();
  }
  return 2;
}

const std::vector<std::string> scenes{
    "classic", "glass", "mirrors", "quadrics", "hard/far_from_origin", "hard/mirror_corner", "hard/tiny_beside_huge"};

}  // namespace

TEST_CASE("the numbers about a place are the neighbours that nextafter gives") {
  for (const double x : {1.0, -7.3819921, 0.1, 1073741824.0}) {
    const float single = static_cast<float>(x);
    CHECK(spacing_at(x, Precision::float_) ==
          static_cast<double>(std::nextafter(std::abs(single), 1e30f)) - static_cast<double>(std::abs(single)));
    CHECK(spacing_at(x, Precision::double_) == std::nextafter(std::abs(x), 1e300) - std::abs(x));

    const double middle = static_cast<double>(single);
    const auto numbers = numbers_about(middle, 5.5 * spacing_at(middle, Precision::float_), Precision::float_, 64);
    REQUIRE(numbers.size() >= 11);
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
      CHECK(std::nextafter(static_cast<float>(middle + numbers[i]), 1e30f) ==
            static_cast<float>(middle + numbers[i + 1]));
    CHECK(numbers_about(middle, 5.5 * spacing_at(middle, Precision::float_), Precision::float_, 4).empty());
  }
  // Next to 0 there is no end of them.
  CHECK(numbers_about(0, 1e-7, Precision::float_, 512).empty());
}

TEST_CASE("a hit is seen where the recording has it, between the numbers of its precision") {
  for (const std::string& name : scenes)
    for (const Precision precision : {Precision::float_, Precision::double_}) {
      CAPTURE(name);
      Hits(scene_of(name), precision).each([&](const Specimen& seen, const RayRecord& ray) {
        REQUIRE(seen.robust);
        CHECK(seen.robust->point == ray.end);
        CHECK(seen.robust->object == ray.object);
        CHECK(seen.focus == ray.end);
        for (int axis = 0; axis < 3; ++axis) CHECK(seen.spacing[axis] == spacing_at(seen.focus[axis], precision));
      });
      Hits(with_epsilon(scene_of(name), 1e-4, Numerics::naive), precision)
          .each([&](const Specimen& seen, const RayRecord& ray) {
            REQUIRE(seen.naive);
            CHECK(seen.naive->point == ray.end);
            CHECK(seen.naive->object == ray.object);
          });
    }
}

TEST_CASE("the surface passes through the robust point's error box, and on the side that was measured") {
  int measured = 0;
  for (const std::string& name : scenes)
    for (const Precision precision : {Precision::float_, Precision::double_}) {
      CAPTURE(name);
      Hits hits(scene_of(name), precision);
      hits.each([&](const Specimen& seen, const RayRecord&) {
        const Reading& robust = *seen.robust;
        const Object& object = hits.scene.objects[static_cast<std::size_t>(robust.object)];
        const int side = object.transform.empty() ? exact_side(hits.scene, robust.object, robust.point, precision) : 2;
        if (side == 2 || !robust.off || !seen.crossing) return;
        ++measured;
        CHECK(side == (*robust.off > 0) - (*robust.off < 0));
        double reach = 0;
        for (int axis = 0; axis < 3; ++axis) {
          reach += std::abs(seen.normal[axis]) * seen.error_box[axis];
          CHECK(std::abs((*seen.crossing)[axis]) <= seen.error_box[axis] * (1 + 1e-6) + 1e-300);
        }
        // Beyond the box on either side of the point, the exact equation has either sign; what lies between two
        // doubles cannot be asked, nor what is smaller than the spacing of floats.
        if (precision == Precision::double_ || seen.ulp > 0.01) return;
        const Vec3d out = 1.01 * reach * seen.normal;
        CHECK(exact_side(hits.scene, robust.object, robust.point + out, precision) >= 0);
        CHECK(exact_side(hits.scene, robust.object, robust.point - out, precision) <= 0);
      });
    }
  CHECK(measured > 100);
}

TEST_CASE("distances below an ulp are those of the exact equation") {
  const Scene scene = scene_of("classic");
  Hits hits(scene, Precision::double_);
  int measured = 0;
  hits.each([&](const Specimen& seen, const RayRecord& ray) {
    const auto* sphere = std::get_if<Sphere<double>>(&scene.objects[static_cast<std::size_t>(ray.object)].shape);
    if (sphere == nullptr) return;
    for (const double ulps : {-3.0, 0.0, 1.0, 40.0}) {
      const Vec3d place = seen.focus + ulps * seen.ulp * seen.normal;
      const double c =
          static_cast<double>(detail::exact_sphere_terms(place, Vec3d(1, 0, 0), sphere->centre, sphere->radius).c);
      const auto distance = seen.surfaces->distance(ray.object, place, seen.normal, seen.ulp);
      REQUIRE(distance);
      CHECK(std::abs(*distance - c / (2 * sphere->radius)) <= 1e-6 * std::abs(c) + 1e-6 * seen.ulp);
      ++measured;
    }
  });
  CHECK(measured > 20);
}

TEST_CASE("t is off by less than an ulp in float, and by what exact arithmetic says") {
  // A ray that leaves a surface is taken to start right there, and does so but for a rounding.
  Hits(scene_of("classic"), Precision::float_).each([](const Specimen& seen, const RayRecord& ray) {
    REQUIRE(seen.robust->t_error);
    if (ray.kind == RayKind::primary) CHECK(std::abs(*seen.robust->t_error) <= 0.5001);
  });
  double naive = 0, robust = 0;
  Hits(scene_of("classic"), Precision::double_).each([&](const Specimen& seen, const RayRecord& ray) {
    if (ray.kind != RayKind::primary || !seen.naive || !seen.naive->t_error) return;
    naive = std::max(naive, std::abs(*seen.naive->t_error));
    robust = std::max(robust, std::abs(*seen.robust->t_error));
  });
  CHECK(naive > 5);
  CHECK(robust < 4);
}

TEST_CASE("without epsilon naive rays hit their own surface in float, robust ones never do") {
  int naive = 0;
  for (const std::string name : {"classic", "mirrors", "glass"}) {
    Hits(with_epsilon(scene_of(name), 0), Precision::float_).each([&](const Specimen& seen, const RayRecord&) {
      naive += self_hits(seen.naive);
      CHECK(wrong(seen.robust) == 0);
      for (const SpawnPoint& start : seen.robust->starts) CHECK(start.place == seen.robust->point);
    });
  }
  CHECK(naive > 10);
  Hits(with_epsilon(scene_of("classic"), 1e-4), Precision::float_).each([](const Specimen& seen, const RayRecord&) {
    CHECK(self_hits(seen.naive) == 0);
    CHECK(seen.naive->starts.front().right_side());
  });
}

TEST_CASE("what is said of naive rays is what a naive walk does") {
  // A ray that meets its own surface at once is recorded with its blocker, or its next hit, right there.
  int compared = 0;
  Hits hits(with_epsilon(scene_of("classic"), 0, Numerics::naive), Precision::float_);
  hits.each([&](const Specimen& seen, const RayRecord& ray) {
    if (!seen.naive) return;
    const int own = static_cast<int>(&ray - hits.timeline->rays().data());
    int at_once = 0;
    for (const RayRecord& next : hits.timeline->rays())
      at_once += next.parent == own && next.formed && next.object == ray.object && !next.endless &&
                 length(next.end - next.origin) < 1e-3;
    CHECK(self_hits(seen.naive) == at_once);
    compared += at_once;
  });
  CHECK(compared > 3);
}

TEST_CASE("a drawing of the surfaces is right at every magnification") {
  const Scene scene = scene_of("classic");
  Hits hits(scene, Precision::double_);
  hits.each([&](const Specimen& seen, const RayRecord& ray) {
    const auto* sphere = std::get_if<Sphere<double>>(&scene.objects[static_cast<std::size_t>(ray.object)].shape);
    if (sphere == nullptr || seen.axes != DrawnAxes{0, 1}) return;
    for (const double reach : {1.0, 1e-6, 12 * seen.ulp}) {
      const auto cuts = seen.surfaces->cut(seen.focus, seen.axes, Vec2d(reach), {40, 40});
      bool own = false;
      for (const SurfaceCut& cut : cuts) {
        if (cut.object != ray.object) continue;
        own = true;
        for (const Vec2d& point : cut.points) {
          // |focus + point - centre|^2 - r^2 over 2 r, with all its digits.
          const Expansion x = Expansion(seen.focus.x) - sphere->centre.x + point.x,
                          y = Expansion(seen.focus.y) - sphere->centre.y + point.y,
                          z = Expansion(seen.focus.z) - sphere->centre.z;
          const double off =
              static_cast<double>((x * x + y * y + z * z - Expansion(sphere->radius) * sphere->radius).rounded());
          CHECK(std::abs(off / (2 * sphere->radius)) <= 1e-9 * reach + 1e-3 * seen.ulp);
        }
      }
      CHECK(own);
    }
  });
}

TEST_CASE("before anything is met there is nothing to see; a shadow ray is seen where it starts") {
  Hits hits(scene_of("classic"), Precision::double_);
  CHECK_FALSE(hits.microscope.look(hits.timeline, 0, hits.scene, hits.precision));
  CHECK_FALSE(hits.microscope.look(hits.timeline, 1, hits.scene, hits.precision));
  int shadows = 0;
  for (const RayRecord& ray : hits.timeline->rays()) {
    if (ray.kind != RayKind::shadow || !ray.formed) continue;
    const auto seen = hits.microscope.look(hits.timeline, ray.found_at, hits.scene, hits.precision);
    REQUIRE(seen);
    CHECK(seen->ray == ray.parent);
    ++shadows;
  }
  CHECK(shadows > 0);
}

TEST_CASE("drawn rays, and each of several samples, are formed again as they were") {
  for (const std::string name : {"distributed", "gloss", "penumbra", "cornell"}) {
    CAPTURE(name);
    Scene scene = scene_of(name);
    scene.camera.screen.cells = 5;
    Hits(scene, Precision::double_, 3).each([](const Specimen& seen, const RayRecord& ray) {
      REQUIRE(seen.robust);
      CHECK(seen.robust->point == ray.end);
      CHECK(seen.direction == ray.direction);
      CHECK(wrong(seen.robust) == 0);
    });
  }
}

TEST_CASE("what began at a light, or was scattered inside a body, is not formed again from the eye") {
  const auto count_unseen = [](Scene scene, const auto& is_meant) {
    scene.camera.screen.cells = 5;
    Hits hits(scene, Precision::double_);
    const auto& rays = hits.timeline->rays();
    int met = 0;
    for (const RayRecord& ray : rays) {
      if (!ray.formed || ray.kind == RayKind::shadow || ray.ending != Ending::hit || !is_meant(rays, ray)) continue;
      const auto seen = hits.microscope.look(hits.timeline, ray.found_at, hits.scene, hits.precision);
      CHECK((!seen || &rays[static_cast<std::size_t>(seen->ray)] != &ray));  // but one that led to it
      ++met;
    }
    return met;
  };
  const auto ancestor = [](const auto& rays, const RayRecord& ray, const auto& is) {
    for (int each = ray.parent; each >= 0; each = rays[static_cast<std::size_t>(each)].parent)
      if (is(rays[static_cast<std::size_t>(each)])) return true;
    return false;
  };
  Scene caustic = scene_of("caustic");
  caustic.render.integrator = Integrator::photons;
  CHECK(count_unseen(caustic, [&](const auto& rays, const RayRecord& ray) {
          const auto is_first = [](const RayRecord& each) { return each.parent < 0 && each.kind != RayKind::primary; };
          return is_first(ray) || ancestor(rays, ray, is_first);
        }) > 0);
  CHECK(count_unseen(scene_of("milk"), [&](const auto& rays, const RayRecord& ray) {
          return ancestor(rays, ray, [](const RayRecord& each) { return each.ending == Ending::scattered; });
        }) > 0);
}

TEST_CASE("moving and transformed surfaces are seen where they are") {
  for (const std::string name : {"motion_blur", "hard/mirrored_transform", "mesh"})
    for (const Precision precision : {Precision::float_, Precision::double_}) {
      CAPTURE(name);
      Hits(scene_of(name), precision).each([&](const Specimen& seen, const RayRecord&) {
        REQUIRE(seen.robust);
        REQUIRE(seen.robust->off);
        CHECK(std::abs(seen.in_ulps(*seen.robust->off)) < 64);
        CHECK(wrong(seen.robust) == 0);
      });
    }
}

TEST_CASE("a primary ray that misses is seen beside the sphere that it passes, a touching one on it") {
  Scene scene = scene_of("hard/tangent_ray");
  const auto seen = [&] {
    const auto timeline = std::make_shared<const Timeline>(record_cell(scene, 10));
    Microscope microscope;
    return microscope.look(timeline, timeline->steps(), scene, Precision::double_);
  };
  const auto touching = seen();
  REQUIRE(touching);
  CHECK(touching->robust.has_value());
  CHECK(touching->passed == -1);
  CHECK(touching->ulp == spacing_at(5, Precision::double_));  // the point is 0, 0, where numbers have no end
  std::get<Sphere<double>>(scene.objects[0].shape).centre.y += 1e-6;
  const auto passing = seen();
  REQUIRE(passing);
  CHECK_FALSE((passing->robust || passing->naive));
  CHECK(passing->passed == 0);
  CHECK(passing->object() == 0);
  CHECK(std::abs(passing->gap - 1e-6) < 1e-14);
  CHECK(passing->normal.y == -1);
  scene.objects[0].transform.push_back({});
  CHECK_FALSE(seen());
}
