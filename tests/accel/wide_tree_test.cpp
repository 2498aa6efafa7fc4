// The tree of a BVH: everything once, inside of every box above it.

#include "accel/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "accel/float_slabs.h"
#include "meshes.h"
#include "shape/numbers.h"
#include "shape/triangle.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

bool holds(const Bounds<float>& outer, const Bounds<float>& inner) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(outer.min[axis] <= inner.min[axis] && inner.max[axis] <= outer.max[axis])) return false;
  return true;
}

// The ids of all leaves below a node, whose box is `box`; counts what is wrong.
void gather(const WideTree& tree, std::uint32_t index, const Bounds<float>& box, const std::vector<TreeItem>& items,
            std::vector<int>& ids, int& wrong) {
  const WideNode& node = tree.nodes()[index];
  wrong += node.count < 1 || node.count > tree_width;
  for (unsigned lane = 0; lane < tree_width; ++lane) {
    if (lane >= node.count) {
      wrong += !node.box(lane).empty();
      continue;
    }
    const Bounds<float> own = node.box(lane);
    const TreeChild child = node.children[lane];
    wrong += !holds(box, own);
    if (!child.is_leaf()) {
      gather(tree, child.index(), own, items, ids, wrong);
      continue;
    }
    const std::int32_t* of = child.is_pack() ? tree.pack(child.index()).ids : tree.listed(child.index());
    bool packed = false;
    for (unsigned i = 0; i < child.count(); ++i) {
      const TreeItem& item = items[static_cast<std::size_t>(of[i])];
      ids.push_back(item.id);
      wrong += !holds(own, item.box);
      packed = packed || item.packed != 0;
    }
    wrong += packed != child.is_pack();
    wrong += !child.is_pack() && child.count() > 4;
  }
}

std::vector<TreeItem> scattered(int count, int every_other, double size) {
  std::mt19937 engine{5};
  const auto real = [&](double low, double high) {
    return low + (high - low) * double(engine() >> 8) / double(1 << 24);
  };
  std::vector<TreeItem> items;
  for (int i = 0; i < count; ++i) {
    const Vec3d at(real(-1, 1), real(-1, 1), real(-1, 1));
    const Bounds<double> box{at, at + Vec3d(real(0, size))};
    items.push_back({rounded_out(box), i, every_other > 0 && i % every_other == 0 ? 0 : 1});
  }
  return items;
}

void check(const std::vector<TreeItem>& items, BuildQuality quality) {
  CAPTURE(items.size(), name_of(quality));
  const WideTree tree(items, {.quality = quality});
  std::vector<int> ids;
  int wrong = 0;
  Bounds<float> whole;
  for (const TreeItem& item : items) whole.include(item.box);
  gather(tree, 0, whole, items, ids, wrong);
  CHECK(wrong == 0);
  std::sort(ids.begin(), ids.end());
  REQUIRE(ids.size() == items.size());
  for (std::size_t i = 0; i < ids.size(); ++i) CHECK(ids[i] == static_cast<int>(i));
  CHECK(tree.item_count() == items.size());
  CHECK(static_cast<std::size_t>(tree.depth()) <= WideTree::most_levels);
}
void check(const std::vector<TreeItem>& items) {
  for (const BuildQuality quality : {BuildQuality::fast, BuildQuality::good}) check(items, quality);
}

// Triangles through each other, of all sizes and slants.
struct Soup {
  std::vector<std::array<Vec3d, 3>> triangles;
  std::vector<TreeItem> items;
  explicit Soup(int count) {
    Numbers next(11);
    for (int i = 0; i < count; ++i) {
      // Most are small, some are thin.
      const Vec3d at = next.in_box<double>(1);
      const double size = std::pow(next.real(0.1, 1), 4) * 0.4;
      const Vec3d a = at + size * next.unit<double>();
      triangles.push_back({at, a, i % 5 == 0 ? a + 0.001 * next.unit<double>() : at + size * next.unit<double>()});
      Bounds<double> box;
      for (const Vec3d& corner : triangles.back()) box.include(corner);
      items.push_back({rounded_out(box), i, 1});
    }
  }
  [[nodiscard]] WideTree tree(BuildQuality quality) const {
    return WideTree(items, {.quality = quality},
                    [this](std::int32_t id) { return triangles[static_cast<std::size_t>(id)]; });
  }
};

// Whether `id` is listed where `point` is inside of all boxes.
bool finds(const WideTree& tree, std::uint32_t index, const Vec3d& point, std::int32_t id) {
  const WideNode& node = tree.nodes()[index];
  for (unsigned lane = 0; lane < node.count; ++lane) {
    const Bounds<float> box = node.box(lane);
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside = inside && static_cast<double>(box.min[axis]) <= point[axis] &&
               point[axis] <= static_cast<double>(box.max[axis]);
    if (!inside) continue;
    const TreeChild child = node.children[lane];
    if (!child.is_leaf()) {
      if (finds(tree, child.index(), point, id)) return true;
      continue;
    }
    const std::int32_t* of = child.is_pack() ? tree.pack(child.index()).ids : tree.listed(child.index());
    if (std::find(of, of + child.count(), id) != of + child.count()) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("where space is split, each point of a triangle is where the triangle is listed", "[accel]") {
  const Soup soup(5000);
  const WideTree fast = soup.tree(BuildQuality::fast), good = soup.tree(BuildQuality::good),
                 best = soup.tree(BuildQuality::best);
  CHECK(good.item_count() == soup.items.size());
  CHECK(best.item_count() > soup.items.size());
  CHECK(best.item_count() <= soup.items.size() * 3 / 2);
  CHECK(best.expected_cost() < 0.9 * good.expected_cost());
  CHECK(good.expected_cost() < fast.expected_cost());
  CAPTURE(best.item_count());
  Numbers next(3);
  int lost = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto& [a, b, c] = soup.triangles[i];
    for (int point = 0; point < 20; ++point) {
      // At corners, on edges, inside.
      const double u = point < 3 ? point / 2 : next.real(0, 1), v = point < 12 ? point % 2 : next.real(0, 1);
      const double s = std::min(u, v), t = std::max(u, v) - s;
      lost += !finds(best, 0, a + s * (b - a) + t * (c - a), static_cast<std::int32_t>(i));
    }
  }
  CHECK(lost == 0);
}

TEST_CASE("a better quality costs no more", "[accel]") {
  const auto costs = [](const Mesh& mesh) {
    std::vector<std::array<Vec3d, 3>> triangles;
    std::vector<TreeItem> items;
    for (const Mesh::Corners& of : mesh.triangles) {
      const auto at = [&](std::size_t corner) { return mesh.positions[static_cast<std::size_t>(of[corner])]; };
      triangles.push_back({at(0), at(1), at(2)});
      items.push_back({rounded_out(bounds(Triangle<double>{at(0), at(1), at(2)})), static_cast<int>(items.size()), 1});
    }
    std::vector<double> all;
    for (const BuildQuality quality : {BuildQuality::fast, BuildQuality::good, BuildQuality::best})
      all.push_back(WideTree(items, {.quality = quality}, [&](std::int32_t id) {
                      return triangles[static_cast<std::size_t>(id)];
                    }).expected_cost());
    return all;
  };
  const auto better = [&](const char* name, const Mesh& mesh) {
    const std::vector<double> all = costs(mesh);
    CAPTURE(name, all);
    CHECK(all[1] < all[0]);
    CHECK(all[2] <= all[1]);
  };
  // In which plain splits along one axis do better than along three.
  Mesh room = icosphere(4, Vec3d(0.0), 0.3);
  const auto first = static_cast<std::int32_t>(room.positions.size());
  for (int corner = 0; corner < 8; ++corner)
    room.positions.emplace_back(2 * (corner & 1) - 1, 2 * (corner >> 1 & 1) - 1, 2 * (corner >> 2) - 1);
  for (const auto& [a, b, c, d] :
       {std::array{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    room.triangles.push_back({first + a, first + b, first + c});
    room.triangles.push_back({first + a, first + c, first + d});
  }
  better("a ball in a room", room);
  better("a ball", icosphere(5));
  Mesh several;
  Numbers next(7);
  for (int i = 0; i < 60; ++i) {
    const Mesh ball = icosphere(2, next.in_box<double>(3), next.real(0.1, 1));
    const auto from = static_cast<std::int32_t>(several.positions.size());
    several.positions.insert(several.positions.end(), ball.positions.begin(), ball.positions.end());
    for (const auto& [a, b, c] : ball.triangles) several.triangles.push_back({from + a, from + b, from + c});
  }
  better("balls through each other", several);
}

TEST_CASE("where nothing overlaps, the best tree splits no space and is the good one", "[accel]") {
  std::vector<std::array<Vec3d, 3>> hills;
  std::vector<TreeItem> items;
  const auto at = [](int x, int y) { return Vec3d(x, y, std::sin(0.3 * x) * std::cos(0.2 * y)); };
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y)
      for (const Vec3d& third : {at(x + 1, y), at(x, y + 1)}) {
        hills.push_back({at(x, y), at(x + 1, y + 1), third});
        Bounds<double> box;
        for (const Vec3d& corner : hills.back()) box.include(corner);
        items.push_back({rounded_out(box), static_cast<std::int32_t>(items.size()), 1});
      }
  const auto tree = [&](BuildQuality quality, BuildRecord& record) {
    return WideTree(items, {.watcher = &record, .quality = quality},
                    [&](std::int32_t id) { return hills[static_cast<std::size_t>(id)]; });
  };
  BuildRecord of_good, of_best;
  const WideTree good = tree(BuildQuality::good, of_good), best = tree(BuildQuality::best, of_best);
  REQUIRE(best.node_count() == good.node_count());
  CHECK(best.item_count() == items.size());
  CHECK(std::memcmp(best.nodes(), good.nodes(), good.node_count() * sizeof(WideNode)) == 0);
  CHECK(of_best.steps_made == of_good.steps_made);
}

TEST_CASE("how well a tree is built follows how many rays are expected", "[accel]") {
  const auto quality = [](BuildQuality wanted, double rays) {
    return BuildOptions{.quality = wanted, .expected_rays = rays}.quality_for(1000);
  };
  CHECK(quality(BuildQuality::automatic, 0) == BuildQuality::good);
  CHECK(quality(BuildQuality::automatic, 1000) == BuildQuality::fast);
  CHECK(quality(BuildQuality::automatic, 50'000) == BuildQuality::good);
  CHECK(quality(BuildQuality::automatic, 1e6) == BuildQuality::good);
  for (const BuildQuality each : {BuildQuality::fast, BuildQuality::good, BuildQuality::best})
    CHECK(quality(each, 1000) == each);
}

TEST_CASE("a tree lists everything once, inside of all boxes above", "[accel]") {
  for (const int count : {1, 2, 4, 5, 8, 9, 100, 3000}) {
    CAPTURE(count);
    check(scattered(count, 0, 0.1));    // triangles
    check(scattered(count, 1, 0.1));    // other things
    check(scattered(count, 3, 0.1));    // both
    check(scattered(count, 2, 1e-30));  // points
  }
}

TEST_CASE("a tree of a thousand things in one place, or at the ends of float's range", "[accel]") {
  std::vector<TreeItem> items = scattered(1000, 2, 0.1);
  for (TreeItem& item : items) item.box = items[0].box;
  check(items);
  items = scattered(1000, 2, 0.1);
  for (TreeItem& item : items)
    item.box = rounded_out(Bounds<double>{1e300 * Vec3d(item.box.min), 1e300 * Vec3d(item.box.max)});
  check(items);
  // Each twice as far as the one before: no split parts them evenly.
  for (int i = 0; i < 240; ++i)
    items[static_cast<std::size_t>(i)].box = {Vec3<float>(std::ldexp(1.0F, i - 120)),
                                              Vec3<float>(std::ldexp(1.01F, i - 120))};
  items.resize(240);
  check(items);
  CHECK(WideTree(std::vector<TreeItem>{}).empty());
}

TEST_CASE("boxes are rounded outward", "[accel]") {
  constexpr double ulp = std::numeric_limits<float>::epsilon();
  for (const double x : {1.0, -1.0, 0.1, -0.1, 1e-30, -3e20, 3.4e38, 1e-37}) {
    CHECK(static_cast<double>(rounded_up(x)) >= x + 3 * ulp * std::abs(x));
    CHECK(static_cast<double>(rounded_up(x)) <= x + 17 * ulp * std::abs(x) + (x > 3e38 ? infinity<double> : 0));
  }
  CHECK(rounded_up(0.0) == 0);
  CHECK(rounded_up(1e-46) > 0);
  CHECK(rounded_up(-1e-46) == 0);
  CHECK(rounded_up(1e300) == infinity<float>);
  CHECK(rounded_up(-1e300) == -std::numeric_limits<float>::max());
}

TEST_CASE("a tree's child knows what it is", "[accel]") {
  const TreeChild node = TreeChild::node(TreeChild::most), pack = TreeChild::pack(123456, 8),
                  list = TreeChild::list(7, 1);
  CHECK_FALSE(node.is_leaf());
  CHECK(node.index() == TreeChild::most);
  CHECK((pack.is_leaf() && pack.is_pack()));
  CHECK((pack.index() == 123456 && pack.count() == 8));
  CHECK((list.is_leaf() && !list.is_pack()));
  CHECK((list.index() == 7 && list.count() == 1));
}

TEST_CASE("packs know whether they hold the corners of all triangles unrounded", "[accel]") {
  std::vector<TreeItem> items;
  for (int id = 0; id < 20; ++id) {
    const auto at = static_cast<float>(id);
    items.push_back({{{at, 0, 0}, {at + 1, 1, 1}}, id, 1});
  }
  const int between = GENERATE(-1, 0, 13, 19), nothing = GENERATE(-1, 5);
  WideTree tree(items);
  tree.fill_packs({}, [&](std::int32_t id) -> std::optional<std::array<Vec3d, 3>> {
    if (id == nothing) return std::nullopt;
    const double at = id == between ? id + 0x1p-30 : id;
    return std::array{Vec3d(at, 0, 0), Vec3d(at, 1, 0.5), Vec3d(id + 0.25, -0.0, 1)};
  });
  // The first triangle lies where floats are dense enough.
  CHECK(tree.packs_are_exact() == (between <= 0));
}
