// A watched search is the search that the renderer makes: same hit, same counts; what it tells adds up.

#include <algorithm>
#include <random>
#include <set>

#include "accel/watched.h"
#include "meshes.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

constexpr AcceleratorKind searches[] = {AcceleratorKind::none,   AcceleratorKind::spheres, AcceleratorKind::ellipsoids,
                                        AcceleratorKind::boxes,  AcceleratorKind::bvh,     AcceleratorKind::grid,
                                        AcceleratorKind::octree, AcceleratorKind::kdtree};

struct RayNumbers {
  std::mt19937 engine{11};
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 8) / double(1 << 24);
  }
};

// Balls of two sizes in a flat room, and a floor without end.
template <class T>
std::vector<Shape<T>> room(int balls) {
  RayNumbers random;
  std::vector<Shape<T>> all{Plane<T>{Vec3<T>(0, 0, -2), Vec3<T>(0, 0, 1)}};
  for (int i = 0; i < balls; ++i) {
    const T x = static_cast<T>(random(-6, 6)), y = static_cast<T>(random(-4, 4)), z = static_cast<T>(random(-1, 1));
    all.push_back(Sphere<T>{Vec3<T>(x, y, z), i % 9 == 0 ? T(0.9) : T(0.25)});
  }
  return all;
}

template <class T>
std::vector<Ray<T>> probes(int count) {
  RayNumbers random;
  std::vector<Ray<T>> all;
  const auto point = [&](double size) {
    const T x = static_cast<T>(random(-size, size)), y = static_cast<T>(random(-size, size));
    return Vec3<T>(x, y, static_cast<T>(random(-1, 1)));
  };
  for (int i = 0; i < count; ++i) {
    Ray<T> ray{point(i % 3 == 0 ? 20 : 5), point(1)};
    if (i % 6 == 0) ray.direction[i / 6 % 3] = 0;
    if (ray.direction == Vec3<T>(0)) ray.direction.x = 1;
    all.push_back(ray);
  }
  return all;
}

int count_of(const SearchRecord& record, SearchEvent::Kind kind) {
  return static_cast<int>(
      std::count_if(record.events().begin(), record.events().end(), [&](const auto& e) { return e.kind == kind; }));
}

// The same among a ball of 320 triangles and one that moves.
template <class T>
Primitives<T> furnished() {
  Primitives<T> all(room<T>(20));
  all.add(test::icosphere(2, {1, 0, 0}, 2), {}, false);
  const int first = all.size();
  all.add(test::icosphere(0, {-3, 1, 0}, 0.7), {}, false);
  all.move(first, all.size(), {{0, Vec3d(0.0)}, {1, Vec3d(0, 1, 0)}});
  return all;
}

template <class T, class AnyRay>
void compare(AcceleratorKind kind, Primitives<T> primitives) {
  const Accelerator<T> accelerator(std::move(primitives), kind);
  const WatchedAccelerator<T> watching(accelerator.primitives(), kind, 0);
  const std::vector<ShadowRole> none;
  int differing = 0, hits = 0;
  for (const Ray<T>& each : probes<T>(600)) {
    const AnyRay ray{each};
    TestCounts plain, watched;
    SearchRecord record(wide(ray.origin), wide(ray.direction), infinity<double>);
    const auto expected = accelerator.closest(ray, infinity<T>, plain);
    const auto found = watching.closest(ray, infinity<T>, watched, record);
    differing += expected.has_value() != found.has_value();
    if (expected && found) differing += expected->t != found->t || expected->primitive != found->primitive;
    differing += plain.nodes != watched.nodes || plain.primitives != watched.primitives;

    // Every node and test that is counted is told, and the last event knows the sum.
    const SearchEvent& last = record.events().back();
    differing += last.kind != SearchEvent::Kind::ended || count_of(record, SearchEvent::Kind::ended) != 1;
    differing += last.nodes != static_cast<int>(plain.nodes) || last.tests != static_cast<int>(plain.primitives);
    differing += count_of(record, SearchEvent::Kind::tested) != static_cast<int>(plain.primitives);
    // The nearest hit that was told is the one that was found.
    const SearchEvent* nearest = nullptr;
    for (const SearchEvent& event : record.events())
      if (event.kind == SearchEvent::Kind::tested && event.test == SearchEvent::Test::nearest) nearest = &event;
    differing += (nearest != nullptr) != found.has_value();
    if (nearest != nullptr && found)
      differing += nearest->t != static_cast<double>(found->t) || last.t_far != nearest->t;
    hits += found.has_value();

    // To a light at a bit more than the hit, and a bit less.
    for (const T t_far : {T(0.5), T(8)}) {
      TestCounts any, any_watched;
      SearchRecord shadow(wide(ray.origin), wide(ray.direction), static_cast<double>(t_far));
      const bool blocked = accelerator.occluded(ray, t_far, any);
      differing += watching.occluded(ray, t_far, any_watched, none, shadow) != blocked;
      differing += any.nodes != any_watched.nodes || any.primitives != any_watched.primitives;
      differing += (shadow.events().back().end == SearchEnd::blocked) != blocked;
    }
  }
  CHECK(differing == 0);
  CHECK(hits > 100);
}

}  // namespace

TEST_CASE("a watched search finds and costs what the same search costs that nobody watches") {
  for (const AcceleratorKind kind : searches) {
    INFO(name_of(kind));
    compare<double, Ray<double>>(kind, Primitives<double>(room<double>(60)));
    compare<double, Ray<double>>(kind, furnished<double>());
    compare<float, Ray<float>>(kind, Primitives<float>(room<float>(60)));
    compare<float, Ray<float>>(kind, furnished<float>());
    compare<double, NaiveRay<double>>(kind, Primitives<double>(room<double>(60)));
    compare<double, NaiveRay<double>>(kind, furnished<double>());
    compare<float, NaiveRay<float>>(kind, Primitives<float>(room<float>(60)));
    compare<float, NaiveRay<float>>(kind, furnished<float>());
  }
}

TEST_CASE("triangles that are ruled out together are told one by one, as missed") {
  const Primitives<float> primitives = furnished<float>();
  const WatchedAccelerator<float> accelerator(primitives, AcceleratorKind::bvh, 0);
  int leaves = 0, wrong = 0, far = 0;
  for (const Ray<float>& ray : probes<float>(600)) {
    SearchRecord record(wide(ray.origin), wide(ray.direction), infinity<double>);
    TestCounts counts;
    static_cast<void>(accelerator.closest(ray, infinity<float>, counts, record));
    int expected = 0;  // tests that follow a leaf
    for (const SearchEvent& event : record.events()) {
      if (event.kind == SearchEvent::Kind::tested) {
        if (!event.box.empty()) --expected;
        const auto alone = primitives.intersect(event.primitive, ray, infinity<float>);
        wrong += alone.has_value() != (event.test != SearchEvent::Test::missed);
        far += event.test == SearchEvent::Test::farther;
        continue;
      }
      wrong += expected != 0;
      expected = event.kind == SearchEvent::Kind::opened ? event.items : 0;
      leaves += event.kind == SearchEvent::Kind::opened;
    }
  }
  CHECK(wrong == 0);
  CHECK(leaves > 200);
  CHECK(far > 0);
}

TEST_CASE("filters are told as such, and what stops is told last") {
  std::vector<Shape<double>> row;
  for (int i = 0; i < 12; ++i) row.push_back(Sphere<double>{Vec3d(2 * i + 2, 0, 0), 0.5});
  std::vector<ShadowRole> roles(row.size(), ShadowRole::filters);
  roles[3] = ShadowRole::ignored, roles[7] = ShadowRole::stops;
  for (const AcceleratorKind kind : searches) {
    INFO(name_of(kind));
    const Accelerator<double> accelerator(Primitives<double>(row), kind);
    const WatchedAccelerator<double> watching(accelerator.primitives(), kind, 0);
    const Ray<double> ray{Vec3d(0, 0.125, 0), Vec3d(1, 0, 0)};
    SearchRecord record(ray.origin, ray.direction, 100);
    TestCounts counts, plain;
    std::vector<int> filters;
    CHECK(watching.occluded(ray, 100, counts, roles, record));
    CHECK(accelerator.occluded_or_filtered(ray, 100, plain, roles, filters));
    CHECK(counts.primitives == plain.primitives);
    const auto& events = record.events();
    REQUIRE(events.size() >= 2);
    CHECK(events[events.size() - 2].primitive == 7);
    CHECK(events.back().end == SearchEnd::blocked);
    for (const SearchEvent& event : events)
      if (event.kind == SearchEvent::Kind::tested)
        CHECK((event.test == SearchEvent::Test::filters) == (roles[std::size_t(event.primitive)] != ShadowRole::stops));
  }
}

TEST_CASE("a skipped box is truly missed, behind or beyond, and each of these occurs in each tree") {
  for (const AcceleratorKind kind : {AcceleratorKind::bvh, AcceleratorKind::octree, AcceleratorKind::kdtree}) {
    INFO(name_of(kind));
    const Primitives<double> primitives(room<double>(60));
    const WatchedAccelerator<double> accelerator(primitives, kind, 0);
    std::set<Skip> reasons;
    int wrong = 0;
    for (const Ray<double>& ray : probes<double>(600)) {
      SearchRecord record(ray.origin, ray.direction, infinity<double>);
      TestCounts counts;
      static_cast<void>(accelerator.closest(ray, infinity<double>, counts, record));
      for (const SearchEvent& event : record.events()) {
        if (event.kind != SearchEvent::Kind::skipped) continue;
        reasons.insert(event.skip);
        const auto line = line_in_box(ray.origin, ray.direction, event.box);
        switch (event.skip) {
          case Skip::missed:  // or touched within rounding
            wrong += line && (*line)[1] - (*line)[0] > 1e-9;
            break;
          case Skip::behind:
            wrong += !line || (*line)[1] >= 0;
            break;
          case Skip::beyond:
            wrong += !line || (*line)[0] < event.t_far;
            break;
        }
      }
    }
    CHECK(reasons == std::set{Skip::missed, Skip::behind, Skip::beyond});
    CHECK(wrong == 0);
  }
}

TEST_CASE("a grid passes by what it has tested, and sees hits in later cells") {
  // One long body over many cells, small ones around it.
  std::vector<Shape<double>> shapes{Box<double>{Vec3d(-5, -0.2, -0.2), Vec3d(5, 0.2, 0.2)}};
  for (int i = 0; i < 40; ++i) shapes.push_back(Sphere<double>{Vec3d(i % 10 - 4.5, i / 10 - 1.5, 0), 0.15});
  const Primitives<double> primitives(shapes);
  const WatchedAccelerator<double> grid(primitives, AcceleratorKind::grid, 0);
  bool passed = false, outside = false;
  std::set<SearchEnd> ends;
  for (int i = 0; i < 200; ++i) {
    const Ray<double> ray{Vec3d(-6, 3 - 0.03 * i, 0.05), Vec3d(1, -0.3 + 0.001 * i, 0)};
    SearchRecord record(ray.origin, ray.direction, infinity<double>);
    TestCounts counts;
    static_cast<void>(grid.closest(ray, infinity<double>, counts, record));
    ends.insert(record.events().back().end);
    std::set<int> tested;
    for (const SearchEvent& event : record.events()) {
      if (event.kind == SearchEvent::Kind::passed) {
        passed = true;
        CHECK(tested.contains(event.primitive));
      }
      if (event.kind != SearchEvent::Kind::tested) continue;
      CHECK_FALSE(event.again);
      tested.insert(event.primitive);
      if (event.outside) {
        outside = true;
        CHECK(event.t > event.t_far * 0.999);
      }
    }
  }
  CHECK(passed);
  CHECK(outside);
  CHECK(ends.contains(SearchEnd::left));
  CHECK(ends.contains(SearchEnd::beyond));
}

TEST_CASE("a record that is full goes on counting") {
  const Primitives<double> primitives(room<double>(60));
  const WatchedAccelerator<double> accelerator(primitives, AcceleratorKind::none, 0);
  const Ray<double> ray{Vec3d(-20, 0, 0), Vec3d(1, 0, 0)};
  SearchRecord record(ray.origin, ray.direction, infinity<double>, 5);
  TestCounts counts;
  static_cast<void>(accelerator.closest(ray, infinity<double>, counts, record));
  CHECK(record.events().size() == 5);
  CHECK_FALSE(record.complete());
  CHECK(counts.primitives == 61);
}

TEST_CASE("a BVH joins four boxes over shapes and small meshes, and eight over other meshes") {
  const auto most_joined = [](const Primitives<double>& primitives) {
    const WatchedAccelerator<double> accelerator(primitives, AcceleratorKind::bvh, 100000);
    int most = 0, inner = 0;
    for (const BuildStep& step : accelerator.build().steps)
      if (step.kind == BuildStep::Kind::joined) most = std::max(most, step.items), ++inner;
    CHECK(inner == static_cast<int>(accelerator.statistics().nodes));
    return most;
  };
  const auto ball = [](int subdivisions, int balls) {
    Primitives<double> all(room<double>(balls));
    all.add(test::icosphere(subdivisions, Vec3d(0.0), 1), {}, false);
    return all;
  };
  CHECK(most_joined(Primitives<double>(room<double>(300))) == 4);
  CHECK(most_joined(ball(0, 0)) == 4);    // 20 triangles
  CHECK(most_joined(ball(1, 300)) == 4);  // 80, among more shapes
  CHECK(most_joined(ball(1, 0)) == 8);
  CHECK(most_joined(furnished<double>()) == 8);
}

TEST_CASE("the steps of a build are those of the structure that stands in the end") {
  for (const AcceleratorKind kind :
       {AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree, AcceleratorKind::kdtree}) {
    INFO(name_of(kind));
    const Accelerator<double> renderers(Primitives<double>(room<double>(60)), kind);
    const WatchedAccelerator<double> accelerator(renderers.primitives(), kind, 100000);
    const BuildRecord& record = accelerator.build();
    CHECK(record.steps.size() == record.steps_made);
    CHECK(accelerator.statistics().nodes == renderers.statistics().nodes);
    CHECK(accelerator.statistics().bytes == renderers.statistics().bytes);
    const std::vector<StructureNode> nodes = accelerator.nodes(100000);
    const auto count = [&](BuildStep::Kind step) {
      return std::count_if(record.steps.begin(), record.steps.end(), [&](const auto& s) { return s.kind == step; });
    };
    const auto leaves = std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.leaf; });
    const auto inner = static_cast<std::ptrdiff_t>(nodes.size()) - leaves;
    std::ptrdiff_t references = 0;
    for (const StructureNode& node : nodes) references += node.leaf ? node.items : 0;
    CHECK(references == static_cast<std::ptrdiff_t>(accelerator.statistics().references));
    if (kind == AcceleratorKind::grid) {
      CHECK(count(BuildStep::Kind::cells) == 1);
      CHECK(count(BuildStep::Kind::listed) == 60);
      CHECK(leaves == static_cast<std::ptrdiff_t>(accelerator.statistics().nodes));
      std::ptrdiff_t listed = 0;
      for (const BuildStep& step : record.steps) listed += step.kind == BuildStep::Kind::listed ? step.items : 0;
      CHECK(listed == references);
      continue;
    }
    CHECK(leaves == count(BuildStep::Kind::leaf));
    if (kind == AcceleratorKind::bvh) {
      CHECK(inner == count(BuildStep::Kind::joined));
      CHECK(inner == static_cast<std::ptrdiff_t>(accelerator.statistics().nodes));
      CHECK(leaves == count(BuildStep::Kind::split) + 1);  // of a binary tree
    } else {
      CHECK(nodes.size() == accelerator.statistics().nodes);
      CHECK(inner == count(kind == AcceleratorKind::octree ? BuildStep::Kind::eight : BuildStep::Kind::split));
    }
    for (const BuildStep& step : record.steps) {
      // A split is made where it is cheaper, or where too much is left for a leaf.
      if (step.kind == BuildStep::Kind::split && kind == AcceleratorKind::bvh && step.items <= 4)
        CHECK(step.split_cost < step.leaf_cost);
      if (step.kind == BuildStep::Kind::leaf && step.why == LeafReason::split_costs_more &&
          kind == AcceleratorKind::bvh)
        CHECK(step.split_cost >= step.leaf_cost);
      if (step.kind == BuildStep::Kind::split && step.axis >= 0) {
        CHECK(step.plane >= step.box.min[step.axis]);
        CHECK(step.plane <= step.box.max[step.axis]);
      }
      int parts = 0;
      for (const BuildStep::Part& part : step.parts) parts += part.items;
      if (step.kind == BuildStep::Kind::split)
        CHECK((kind == AcceleratorKind::bvh ? parts == step.items : parts >= step.items));
    }
  }
}

TEST_CASE("nothing to search is searched without complaint") {
  for (const AcceleratorKind kind : searches) {
    const Primitives<double> none, one_plane({Plane<double>{Vec3d(0, 0, -1), Vec3d(0, 0, 1)}});
    const WatchedAccelerator<double> empty(none, kind, 10), floor(one_plane, kind, 10);
    CHECK(empty.build().steps.empty());
    const Ray<double> ray{Vec3d(0.0), Vec3d(0, 0, -1)};
    SearchRecord nothing(ray.origin, ray.direction, infinity<double>), one(ray.origin, ray.direction, infinity<double>);
    TestCounts counts;
    CHECK_FALSE(empty.closest(ray, infinity<double>, counts, nothing));
    CHECK(nothing.events().size() == 1);
    CHECK(empty.nodes(10).empty());
    CHECK(floor.closest(ray, infinity<double>, counts, one));
    REQUIRE(one.events().size() == 2);
    CHECK(one.events()[0].box.empty());
    CHECK(one.events()[0].test == SearchEvent::Test::nearest);
  }
}
