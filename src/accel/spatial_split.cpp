#include "accel/spatial_split.h"

#include "accel/float_slabs.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

constexpr std::size_t slabs = 16;

/// Slabs of equal width across a box.
struct Slabs {
  Slabs(const Bounds<float>& box, int axis) : low(box.min[axis]), width((box.max[axis] - low) / slabs) {}

  /// Whether the box has an extent there.
  [[nodiscard]] bool any() const { return width > 0 && std::isfinite(width); }
  [[nodiscard]] float begin(std::size_t i) const { return low + width * static_cast<float>(i); }
  [[nodiscard]] std::size_t of(float x) const {
    return static_cast<std::size_t>(std::clamp((x - low) / width, 0.0F, static_cast<float>(slabs - 1)));
  }

  float low, width;
};

/// Bounds the parts of an item in each of some slabs, about: what a plane costs need not be exact.
void chop(const TreeItem& item, const std::array<Lanes, 3>& corners, const Slabs& all, int axis,
          std::array<LaneBox, slabs>& boxes) {
  const LaneBox whole(item.box);
  const std::size_t first = all.of(item.box.min[axis]), last = all.of(item.box.max[axis]);
  if (first == last) return boxes[first].include(whole);
  std::array<LaneBox, slabs> parts;
  const auto along = static_cast<std::size_t>(axis);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool rises = corners[i][along] <= corners[(i + 1) % 3][along];
    const Lanes low = corners[rises ? i : (i + 1) % 3], high = corners[rises ? (i + 1) % 3 : i];
    const std::size_t from = all.of(low[along]), to = all.of(high[along]);
    parts[from].include_point(low);
    parts[to].include_point(high);
    const float inverse = 1 / (high[along] - low[along]);
    for (std::size_t plane = std::max(from, first) + 1; plane <= std::min(to, last); ++plane) {
      const Lanes crossing = low + all_lanes((all.begin(plane) - low[along]) * inverse) * (high - low);
      parts[plane - 1].include_point(crossing);
      parts[plane].include_point(crossing);
    }
  }
  for (std::size_t i = first; i <= last; ++i) {
    parts[i].min = max(parts[i].min, whole.min), parts[i].max = min(parts[i].max, whole.max);
    boxes[i].include(parts[i]);
  }
}

}  // namespace

Bounds<float> SpatialSplitter::clipped(const TreeItem& item, int axis, float low, float high) const {
  // Rounded out as all boxes are: a ray that meets the item at the plane meets the boxes of both sides.
  Bounds<float> box = item.box;
  box.min[axis] = std::max(box.min[axis], -rounded_up(-static_cast<double>(low)));
  box.max[axis] = std::min(box.max[axis], rounded_up(static_cast<double>(high)));
  if (item.packed == 0) return box;
  Bounds<double> part;
  const std::array<Vec3d, 3> corners = corners_(item.id);
  const double planes[] = {static_cast<double>(low), static_cast<double>(high)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % 3];
    if (planes[0] <= a[axis] && a[axis] <= planes[1]) part.include(a);
    for (const double plane : planes) {
      if ((a[axis] < plane) == (b[axis] < plane)) continue;
      const Vec3d crossing = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
      Vec3d slack;
      for (int each = 0; each < 3; ++each)
        slack[each] = 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a[each]), std::abs(b[each]));
      part.include(crossing - slack);
      part.include(crossing + slack);
    }
  }
  if (part.empty()) return {};
  const Bounds<float> out = rounded_out(part);
  for (int each = 0; each < 3; ++each) {
    box.min[each] = std::max(box.min[each], out.min[each]);
    box.max[each] = std::min(box.max[each], out.max[each]);
  }
  return box.empty() ? Bounds<float>{} : box;
}

SpatialPlane SpatialSplitter::cheapest(std::span<const TreeItem> items, const Bounds<float>& box) const {
  const std::array<Slabs, 3> all{Slabs(box, 0), Slabs(box, 1), Slabs(box, 2)};
  std::array<std::array<LaneBox, slabs>, 3> boxes;
  std::array<std::array<ItemCounts, slabs>, 3> begun, ended;
  for (const TreeItem& item : items) {
    std::array<Lanes, 3> corners;
    if (item.packed != 0) {
      const std::array<Vec3d, 3> exact = corners_(item.id);
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] =
            Lanes{static_cast<float>(exact[i].x), static_cast<float>(exact[i].y), static_cast<float>(exact[i].z), 0};
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Slabs& own = all[static_cast<std::size_t>(axis)];
      if (!own.any()) continue;
      const auto at = static_cast<std::size_t>(axis);
      const std::size_t first = own.of(item.box.min[axis]), last = own.of(item.box.max[axis]);
      begun[at][first] += ItemCounts::of(item);
      ended[at][last] += ItemCounts::of(item);
      if (item.packed != 0) {
        chop(item, corners, own, axis, boxes[at]);
        continue;
      }
      for (std::size_t i = first; i <= last; ++i) {
        Bounds<float> part = item.box;
        if (i > first) part.min[axis] = own.begin(i);
        if (i < last) part.max[axis] = own.begin(i + 1);
        boxes[at][i].include(LaneBox(part));
      }
    }
  }
  SpatialPlane best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!all[axis].any()) continue;
    std::array<Bin, slabs> above;  // slabs i and up
    Bin side;
    for (std::size_t i = slabs; i-- > 1;) {
      side.box.include(boxes[axis][i]), side.count += ended[axis][i];
      above[i] = side;
    }
    side = {};
    for (std::size_t i = 1; i < slabs; ++i) {
      side.box.include(boxes[axis][i - 1]), side.count += begun[axis][i - 1];
      // Each side has to be rid of something.
      if (side.count.all() == 0 || above[i].count.all() == 0) continue;
      const float of_both = cost(side.box, side.count) + cost(above[i].box, above[i].count);
      if (of_both < best.cost) best = {of_both, static_cast<int>(axis), all[axis].begin(i)};
    }
  }
  return best;
}

SpatialSplitter::Sides SpatialSplitter::part(std::span<const TreeItem> items, const SpatialPlane& plane) const {
  Sides sides;
  struct Straddling {
    TreeItem whole, left, right;
  };
  std::vector<Straddling> both;
  const auto add = [](const TreeItem& item, std::vector<TreeItem>& list, Bin& side) {
    list.push_back(item);
    side.box.include(LaneBox(item.box)), side.count += ItemCounts::of(item);
  };
  for (const TreeItem& item : items) {
    if (item.box.max[plane.axis] <= plane.at) {
      add(item, sides.left_items, sides.left);
    } else if (item.box.min[plane.axis] >= plane.at) {
      add(item, sides.right_items, sides.right);
    } else {
      Straddling parts{item, item, item};
      parts.left.box = clipped(item, plane.axis, -infinity<float>, plane.at);
      parts.right.box = clipped(item, plane.axis, plane.at, infinity<float>);
      if (parts.right.box.empty())
        add(item, sides.left_items, sides.left);
      else if (parts.left.box.empty())
        add(item, sides.right_items, sides.right);
      else
        both.push_back(parts);
    }
  }
  for (const Straddling& each : both) {
    sides.left.box.include(LaneBox(each.left.box)), sides.left.count += ItemCounts::of(each.left);
    sides.right.box.include(LaneBox(each.right.box)), sides.right.count += ItemCounts::of(each.right);
  }
  for (const Straddling& each : both) {
    const auto with = [&](const Bin& side) {
      LaneBox box = side.box;
      box.include(LaneBox(each.whole.box));
      return box;
    };
    const auto without = [&](const Bin& side) {
      ItemCounts count = side.count;
      return count -= ItemCounts::of(each.whole);
    };
    // One by one, for a single item rarely fills another pack.
    const auto cost = [&](const LaneBox& box, const ItemCounts& count) {
      return chance_(box) * static_cast<float>(count.all());
    };
    const float split = cost(sides.left.box, sides.left.count) + cost(sides.right.box, sides.right.count);
    const float all_left = cost(with(sides.left), sides.left.count) + cost(sides.right.box, without(sides.right));
    const float all_right = cost(sides.left.box, without(sides.left)) + cost(with(sides.right), sides.right.count);
    if (split <= std::min(all_left, all_right)) {
      sides.left_items.push_back(each.left);
      sides.right_items.push_back(each.right);
    } else if (all_left <= all_right) {
      sides.left.box = with(sides.left), sides.right.count = without(sides.right);
      sides.left_items.push_back(each.whole);
    } else {
      sides.right.box = with(sides.right), sides.left.count = without(sides.left);
      sides.right_items.push_back(each.whole);
    }
  }
  return sides;
}

}  // namespace raywalk
