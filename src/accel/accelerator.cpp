#include "accel/search.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace raywalk {

namespace {

/// Testing two or three spheres is faster than entering a structure; beyond that a BVH is never far from the best.
/// Other shapes are so much more expensive to test that even a single one is better kept in a box.
template <class T>
AcceleratorKind resolve(AcceleratorKind kind, const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives) {
  if (kind != AcceleratorKind::automatic) return kind;
  if (!primitives.triangles().copies().empty()) return AcceleratorKind::bvh;
  const auto sphere = [&](int id) { return primitives.template plain<Sphere<T>>(id) != nullptr; };
  const bool few = boxes.bounded.size() <= 3 && std::all_of(boxes.bounded.begin(), boxes.bounded.end(), sphere);
  return few ? AcceleratorKind::none : AcceleratorKind::bvh;
}

}  // namespace

template <class T>
Accelerator<T>::Accelerator(Primitives<T> primitives, AcceleratorKind kind, const BuildOptions& build)
    : primitives_(std::move(primitives)) {
  const auto begin = std::chrono::steady_clock::now();
  const bool knows_copies = kind == AcceleratorKind::automatic || kind == AcceleratorKind::bvh;
  PrimitiveBounds<T> boxes(primitives_, !knows_copies, build.stop);
  primitives_.find_equals(boxes.boxes, build.stop);
  kind_ = resolve(kind, boxes, primitives_);
  structure_ = std::make_shared<const Structure>(Structure{build_structure(kind_, boxes, primitives_, build)});
  if (kind_ == AcceleratorKind::none)
    boxes_ = std::move(boxes.boxes);
  else
    unbounded_ = std::move(boxes.unbounded);
  statistics_ = std::visit([](const auto& structure) { return structure.statistics(); }, structure_->any);
  statistics_.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class T>
bool Accelerator<T>::within(const Shaft& shaft, Departure departure, std::vector<int>& ids) const {
  if (kind_ != AcceleratorKind::none) return false;
  ids.clear();
  for (int id = 0; id < primitives_.size(); ++id)
    if (may_cross(shaft, primitives_, boxes_[static_cast<std::size_t>(id)], id, departure)) ids.push_back(id);
  return true;
}

template <class T>
bool Accelerator<T>::knows_packets() const {
  return std::holds_alternative<MeshBvh<T>>(structure_->any);
}

/// `tell(i, query)`: when the search for ray i is over.
template <class T>
template <class Query, class Tell, class... Accept>
void Accelerator<T>::search_batch(std::span<const Ray<T>> rays, std::span<const T> t_max, TestCounts& counts,
                                  const Tell& tell, Accept... accept) const {
  const auto* tree = std::get_if<MeshBvh<T>>(&structure_->any);
  std::array<std::optional<Query>, RayPacket::most> queries;
  for (std::size_t first = 0; first < rays.size(); first += queries.size()) {
    const std::size_t count = std::min(queries.size(), rays.size() - first);
    for (const Ray<T>& later : rays.subspan(first + count, std::min(queries.size(), rays.size() - first - count)))
      __builtin_prefetch(&later);
    for (std::size_t i = 0; i < count; ++i) {
      queries[i].emplace(rays[first + i], t_max[first + i], counts, accept...);
      if (tree == nullptr) {
        search(rays[first + i], *queries[i]);
      } else {
        for (const int id : unbounded_)
          if (queries[i]->test(primitives_, id)) break;
      }
    }
    if (tree != nullptr) tree->search(std::span(queries).first(count), primitives_);
    for (std::size_t i = 0; i < count; ++i) tell(first + i, *queries[i]);
  }
}

template <class T>
void Accelerator<T>::closest(std::span<const Ray<T>> rays, std::span<const T> t_max,
                             std::span<std::optional<Hit<T>>> hits, TestCounts& counts) const {
  search_batch<ClosestQuery<T, AnyPrimitive, Ray<T>>>(
      rays, t_max, counts, [&](std::size_t i, const auto& query) { hits[i] = query.nearest(); }, AnyPrimitive{});
}

template <class T>
void Accelerator<T>::occluded(std::span<const Ray<T>> rays, std::span<const T> t_max, std::span<bool> occluded,
                              TestCounts& counts) const {
  search_batch<OcclusionQuery<T, Ray<T>>>(rays, t_max, counts,
                                          [&](std::size_t i, const auto& query) { occluded[i] = query.found(); });
}

template class Accelerator<float>;
template class Accelerator<double>;

RAYWALK_SEARCHES(double, Ray)

}  // namespace raywalk
