// Builds of structures that nobody wants any more.

#include "accel/accelerator.h"
#include "meshes.h"
#include "support/asked.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr AcceleratorKind kinds[] = {AcceleratorKind::none,  AcceleratorKind::spheres, AcceleratorKind::boxes,
                                     AcceleratorKind::bvh,   AcceleratorKind::grid,    AcceleratorKind::octree,
                                     AcceleratorKind::kdtree};

constexpr int finer = sanitized ? 4 : 5;  // icosphere's: 5,120 or 20,480 triangles

template <class T>
Primitives<T> ball() {
  Primitives<T> primitives;
  primitives.add(icosphere(finer), Affine<double>{}, false);
  return primitives;
}

}  // namespace

TEMPLATE_TEST_CASE("a build asks from its beginning to its end whether it is wanted", "[accel]", float, double) {
  const Primitives<TestType> primitives = ball<TestType>();
  for (const AcceleratorKind kind : kinds) {
    CAPTURE(name_of(kind));
    Asked wanted;
    const Accelerator<TestType> whole(primitives, kind, {Stop(wanted)});
    const AcceleratorStatistics statistics = whole.statistics(),
                                unasked = Accelerator<TestType>(primitives, kind).statistics();
    CHECK(statistics.nodes == unasked.nodes);
    CHECK(statistics.references == unasked.references);
    CHECK(wanted.times > primitives.size());
    // Also close to its end.
    for (const int until : {1, wanted.times.load() / 2, wanted.times.load() - 1}) {
      Asked unwanted(until);
      CHECK_THROWS_AS(Accelerator<TestType>(primitives, kind, {Stop(unwanted)}), Stopped);
      CHECK(unwanted.times == until);
    }
  }
}

TEST_CASE("long lists are sorted as ever, or not to their end", "[accel]") {
  std::vector<int> numbers;
  for (int i = 0; i < 1 << 20; ++i) numbers.push_back(static_cast<int>(static_cast<unsigned>(i) * 2654435761U >> 4));
  std::vector<int> sorted = numbers, stopped = numbers;
  Asked wanted;
  Stop(wanted).sort(sorted.begin(), sorted.end(), std::less<>());
  CHECK(std::is_sorted(sorted.begin(), sorted.end()));
  CHECK(wanted.times > 100);
  Asked unwanted(20);
  CHECK_THROWS_AS(Stop(unwanted).sort(stopped.begin(), stopped.end(), std::less<>()), Stopped);
  std::vector<int> seen;
  CHECK_THROWS_AS(Stop(unwanted).each(numbers.begin(), numbers.end(), [&](int number) { seen.push_back(number); }),
                  Stopped);
  CHECK(seen.empty());
  Stop().each(numbers.begin(), numbers.end(), [&](int number) { seen.push_back(number); });
  CHECK(seen == numbers);
}
