#pragma once

#include "accel/build_record.h"
#include "accel/search_record.h"
#include "accel/slabs.h"
#include "math/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace raywalk {

/// Uniform grid (A. Fujimoto, T. Tanaka and K. Iwata, "ARTS", 1986), walked by a 3-D DDA (J. Amanatides and A. Woo
/// 1987). The planes between cells are computed from their integer index each time: accumulating steps would skip
/// cells. A primitive in several cells is tested once per ray (mailboxing); a hit counts as nearest only when the walk
/// has reached its cell.
template <class T>
class Grid {
 public:
  explicit Grid(const PrimitiveBounds<T>& boxes, const BuildOptions& build = {}) {
    if (boxes.bounded.empty()) return;
    box_ = boxes.whole;
    const Vec3<T> size = box_.max - box_.min;
    // About `density` cells per primitive, as close to cubes as the box allows (flat boxes get one layer).
    const T longest = max_component(size);
    const T count = static_cast<T>(boxes.bounded.size());
    T volume = 1;
    int extended = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (size[axis] > longest * T(1e-4)) volume *= size[axis], ++extended;
    const T cell = extended > 0 ? portable::pow(volume / (density * count), T(1) / static_cast<T>(extended)) : T(1);
    for (int axis = 0; axis < 3; ++axis) {
      const T cells = size[axis] > longest * T(1e-4) ? std::ceil(size[axis] / cell) : T(1);
      cells_[axis] = static_cast<int>(std::clamp(cells, T(1), T(max_cells)));
    }
    // Where most primitives reach into most cells, larger ones: they would list them more often than memory holds.
    const std::size_t most = std::max(most_listed, most_listed_each * boxes.bounded.size());
    while (listed(boxes, build.stop) > most && cells_ != glm::vec<3, int>(1))
      for (int axis = 0; axis < 3; ++axis) cells_[axis] = (cells_[axis] + 1) / 2;
    fill(boxes, build.stop);
    if (build.watcher != nullptr) record_build(*build.watcher, boxes);
  }

  template <class AnyRay, class Query>
  void search(const AnyRay& ray, const Primitives<T>& primitives, Query& query) const {
    if (starts_.empty()) return;
    const RayInterval<T> inside = clip(slabs_of(ray, primitives), box_, {0, query.t_far()});
    if (inside.empty()) {
      if constexpr (Watching<Query>) query.record().skipped(box_);
      return;
    }
    const Vec3<T> entry = ray.at(inside.in);
    std::array<int, 3> at{}, step{};
    std::array<double, 3> leave{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      at[a] = cell_of(entry[axis], axis);
      step[a] = std::signbit(ray.direction[axis]) ? -1 : 1;
      leave[a] = leave_at(ray, axis, at[a]);
    }
    std::array<int, mailbox_size> mailbox;
    mailbox.fill(-1);
    while (true) {
      query.enter_node();
      const std::size_t cell = index(at[0], at[1], at[2]);
      if constexpr (Watching<Query>) query.record().entered(cell_box(at), true, starts_[cell + 1] - starts_[cell]);
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const int id = ids_[i];
        int& box = mailbox[static_cast<std::size_t>(id) % mailbox_size];
        if (box == id) {
          if constexpr (Watching<Query>) query.record().passed(id);
          continue;
        }
        box = id;
        if (query.test(primitives, id)) return;
      }
      // Exit through the nearest of the three planes.
      const std::size_t axis = leave[0] <= leave[1] ? (leave[0] <= leave[2] ? 0 : 2) : (leave[1] <= leave[2] ? 1 : 2);
      if (leave[axis] > static_cast<double>(query.t_far())) {
        if constexpr (Watching<Query>) query.record().ended(SearchEnd::beyond);
        return;
      }
      at[axis] += step[axis];
      if (at[axis] < 0 || at[axis] >= cells_[static_cast<int>(axis)]) {
        if constexpr (Watching<Query>) query.record().ended(SearchEnd::left);
        return;
      }
      leave[axis] = leave_next(ray, static_cast<int>(axis), at[axis], leave[axis]);
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    if (starts_.empty()) return;
    for (int z = 0; z < cells_.z; ++z)
      for (int y = 0; y < cells_.y; ++y)
        for (int x = 0; x < cells_.x && nodes.size() < most; ++x) {
          const std::size_t cell = index(x, y, z);
          nodes.push_back({cell_box({x, y, z}), 0, true, static_cast<int>(starts_[cell + 1] - starts_[cell])});
        }
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {starts_.empty() ? 0 : starts_.size() - 1, ids_.size(), 0,
            starts_.size() * sizeof(std::uint32_t) + ids_.size() * sizeof(int)};
  }

 private:
  static constexpr T density = 4;
  static constexpr int max_cells = 256;
  static constexpr std::size_t most_listed = std::size_t{1} << 26, most_listed_each = 32;
  static constexpr std::size_t mailbox_size = 64;

  [[nodiscard]] double plane(int axis, int i) const {
    const double low = box_.min[axis], high = box_.max[axis];
    return low + (high - low) * i / cells_[axis];
  }
  [[nodiscard]] Bounds<double> cell_box(const std::array<int, 3>& at) const {
    Bounds<double> box;
    for (int axis = 0; axis < 3; ++axis) {
      const int i = at[static_cast<std::size_t>(axis)];
      box.min[axis] = plane(axis, i), box.max[axis] = plane(axis, i + 1);
    }
    return box;
  }
  [[nodiscard]] int cell_of(T place, int axis) const {
    const T extent = box_.max[axis] - box_.min[axis];
    const T cell = extent > 0 ? (place - box_.min[axis]) / extent * static_cast<T>(cells_[axis]) : T(0);
    return static_cast<int>(std::clamp(std::floor(cell), T(0), static_cast<T>(cells_[axis] - 1)));
  }
  /// t at which the ray leaves column `i` of an axis; infinite without slope.
  template <class AnyRay>
  [[nodiscard]] double leave_at(const AnyRay& ray, int axis, int i) const {
    const double slope = ray.direction[axis];
    if (slope == 0) return infinity<double>;
    return (plane(axis, slope > 0 ? i + 1 : i) - static_cast<double>(ray.origin[axis])) / slope;
  }
  /// The same for the next column after one that it leaves at `before`.
  [[nodiscard]] double leave_next(const Ray<T>& ray, int axis, int i, double /*before*/) const {
    return leave_at(ray, axis, i);
  }
  /// Accumulated, in the scalar type.
  [[nodiscard]] double leave_next(const NaiveRay<T>& ray, int axis, int /*i*/, double before) const {
    const T width = (box_.max[axis] - box_.min[axis]) / static_cast<T>(cells_[axis]);
    return static_cast<double>(static_cast<T>(before) + width / std::abs(ray.direction[axis]));
  }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(x);
  }

  /// The first and last column that the box overlaps, widened by a fraction of a cell against rounding.
  [[nodiscard]] std::array<int, 2> columns_of(const Bounds<T>& box, int axis) const {
    const T sliver = T(1e-3);
    const T margin = sliver * (box_.max[axis] - box_.min[axis]) / static_cast<T>(cells_[axis]);
    return {cell_of(box.min[axis] - margin, axis), cell_of(box.max[axis] + margin, axis)};
  }
  /// Calls `visit(cell)` for every cell that the box overlaps.
  template <class Visit>
  void for_cells(const Bounds<T>& box, Visit visit) const {
    const auto xs = columns_of(box, 0), ys = columns_of(box, 1), zs = columns_of(box, 2);
    for (int z = zs[0]; z <= zs[1]; ++z)
      for (int y = ys[0]; y <= ys[1]; ++y)
        for (int x = xs[0]; x <= xs[1]; ++x) visit(index(x, y, z));
  }
  /// How many primitives all cells list together.
  [[nodiscard]] std::size_t listed(const PrimitiveBounds<T>& boxes, const Stop& stop) const {
    std::size_t sum = 0;
    for (const int id : boxes.bounded) {
      stop.check();
      std::size_t cells = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const auto columns = columns_of(boxes.box(id), axis);
        cells *= static_cast<std::size_t>(columns[1] - columns[0] + 1);
      }
      sum += cells;
    }
    return sum;
  }

  /// Counts first, then fills: the lists of all cells are contiguous.
  void fill(const PrimitiveBounds<T>& boxes, const Stop& stop) {
    starts_.assign(index(cells_.x - 1, cells_.y - 1, cells_.z - 1) + 2, 0);
    for (const int id : boxes.bounded) {
      stop.check();
      for_cells(boxes.box(id), [&](std::size_t cell) { ++starts_[cell + 1]; });
    }
    for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    ids_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const int id : boxes.bounded) {
      stop.check();
      for_cells(boxes.box(id), [&](std::size_t cell) { ids_[next[cell]++] = id; });
    }
  }

  void record_build(BuildRecord& watcher, const PrimitiveBounds<T>& boxes) const {
    BuildStep layout{.kind = BuildStep::Kind::cells, .box = wide(box_)};
    layout.items = static_cast<int>(boxes.bounded.size());
    layout.cells = {cells_.x, cells_.y, cells_.z};
    watcher.add(std::move(layout));
    for (const int id : boxes.bounded) {
      BuildStep step{.kind = BuildStep::Kind::listed, .box = wide(boxes.box(id))};
      step.primitive = id;
      for_cells(boxes.box(id), [&](std::size_t) { ++step.items; });
      watcher.add(std::move(step));
    }
  }

  Bounds<T> box_;
  glm::vec<3, int> cells_{1};
  std::vector<std::uint32_t> starts_;  ///< cell i holds ids_[starts_[i], starts_[i + 1])
  std::vector<int> ids_;
};

}  // namespace raywalk
