#pragma once
// The one interface to all accelerators. They differ in cost, never in their answers.

#include "accel/build_record.h"
#include "accel/query.h"
#include "accel/shaft.h"
#include "math/stop.h"
#include "math/words.h"

#include <memory>
#include <span>

namespace raywalk {

/// `spheres`, `ellipsoids` and `boxes`: one around each object, no hierarchy.
enum class AcceleratorKind { automatic, none, spheres, ellipsoids, boxes, bvh, grid, octree, kdtree };
template <>
inline constexpr Word<AcceleratorKind> words_of<AcceleratorKind>[] = {
    {AcceleratorKind::automatic, "auto"},  {AcceleratorKind::none, "none"},
    {AcceleratorKind::spheres, "spheres"}, {AcceleratorKind::ellipsoids, "ellipsoids"},
    {AcceleratorKind::boxes, "boxes"},     {AcceleratorKind::bvh, "bvh"},
    {AcceleratorKind::grid, "grid"},       {AcceleratorKind::octree, "octree"},
    {AcceleratorKind::kdtree, "kdtree"}};

/// What is known about a shadow ray in advance. It changes the cost of the search, not its answer.
struct ShadowHints {
  /// The primitive with this id (-1: none) is tested first, and replaced by the one found: what occludes a light at one
  /// point often occludes it at the next (E. Haines and D. Greenberg, "The light buffer", 1986).
  int* last = nullptr;
  const std::vector<int>* candidates = nullptr;  ///< the only primitives that can be hit, as `within` found them
};

/// Primitives that can be searched by rays. A primitive's id is its index in the list it was built from. `AnyRay` is a
/// Ray, or a NaiveRay, whose result may depend on the structure.
template <class T>
class Accelerator {
 public:
  /// `build.stop` may cancel the build, which then throws Stopped.
  explicit Accelerator(Primitives<T> primitives, AcceleratorKind kind = AcceleratorKind::automatic,
                       const BuildOptions& build = {});

  /// The nearest accepted intersection in (0, t_max); an exact tie in t goes to the lower id. `Accept` is AnyPrimitive,
  /// StopsShadows or OfBodies.
  template <class AnyRay = Ray<T>, class Accept = AnyPrimitive>
  [[nodiscard]] std::optional<Hit<T>> closest(const AnyRay& ray, T t_max, TestCounts& counts, Accept accept = {}) const;
  /// The same, of all and with any t, for a ray that is likely to hit the primitive `likely` first: once that is
  /// tested, what lies beyond it is not searched.
  [[nodiscard]] std::optional<Hit<T>> closest_likely(const Ray<T>& ray, int likely, TestCounts& counts) const;

  /// Whether any primitive is hit in (0, t_max).
  template <class AnyRay = Ray<T>>
  [[nodiscard]] bool occluded(const AnyRay& ray, T t_max, TestCounts& counts, const ShadowHints& hints = {}) const;

  /// The same for many rays, each with its t_max, in order. Neighbours that are coherent are searched together
  /// (accel/packet_search.h). Each is told what it is told alone, and a node or test counts once for each ray that
  /// makes it.
  void closest(std::span<const Ray<T>> rays, std::span<const T> t_max, std::span<std::optional<Hit<T>>> hits,
               TestCounts& counts) const;
  void occluded(std::span<const Ray<T>> rays, std::span<const T> t_max, std::span<bool> occluded,
                TestCounts& counts) const;
  /// Whether any ever are.
  [[nodiscard]] bool knows_packets() const;

  /// The same for the primitives whose role is to stop shadow rays. If none is hit, `filters` receives the ids,
  /// ascending, of the filtering primitives that are hit. `roles`: by primitive.
  template <class AnyRay = Ray<T>>
  [[nodiscard]] bool occluded_or_filtered(const AnyRay& ray, T t_max, TestCounts& counts,
                                          const std::vector<ShadowRole>& roles, std::vector<int>& filters,
                                          const ShadowHints& hints = {}) const;

  /// Fills `ids`, ascending, with all primitives that rays through the shaft may hit. Returns false, and fills in
  /// nothing, where searching is cheaper: with any structure but a list.
  [[nodiscard]] bool within(const Shaft& shaft, Departure departure, std::vector<int>& ids) const;

  [[nodiscard]] const Primitives<T>& primitives() const { return primitives_; }
  /// What was built: never `automatic`.
  [[nodiscard]] AcceleratorKind kind() const { return kind_; }
  [[nodiscard]] AcceleratorStatistics statistics() const { return statistics_; }

 private:
  struct Structure;
  template <class AnyRay, class Query>
  bool found(Query& query, const AnyRay& ray, const ShadowHints& hints) const;
  template <class AnyRay, class Query>
  void search(const AnyRay& ray, Query& query) const;
  template <class Query, class Tell, class... Accept>
  void search_batch(std::span<const Ray<T>> rays, std::span<const T> t_max, TestCounts& counts, const Tell& tell,
                    Accept... accept) const;
  template <class AnyRay, class Query>
  void search_structure(const AnyRay& ray, Query& query) const;

  Primitives<T> primitives_;
  std::vector<int> unbounded_;    ///< ids of primitives that every ray is tested against
  std::vector<Bounds<T>> boxes_;  ///< by primitive, of a list
  AcceleratorKind kind_ = AcceleratorKind::none;
  std::shared_ptr<const Structure> structure_;  ///< over the bounded primitives; a list holds all
  AcceleratorStatistics statistics_;
};

extern template class Accelerator<float>;
extern template class Accelerator<double>;

}  // namespace raywalk
