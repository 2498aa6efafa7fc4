#pragma once
// What all accelerators share: how a primitive is tested, and how two hits are compared. An accelerator only chooses
// which primitives are tested and in which order; since every test and every comparison is made here, all of them
// return the same bits.

#include "accel/primitives.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace raywalk {

/// The nearest intersection among all primitives: a primitive's id is its index in the list it was built from.
template <class T>
struct Hit {
  T t;
  int primitive;
  int part;
};

/// The cost of queries. As the explainer of `intersect`, it counts the tests that exact arithmetic decided.
struct TestCounts : NoExplanation {
  std::uint64_t nodes = 0;            ///< nodes or cells of a structure entered
  std::uint64_t primitives = 0;       ///< ray-primitive tests made
  std::uint64_t exactly_decided = 0;  ///< those among them where rounding left a doubt

  void exact() { ++exactly_decided; }
  TestCounts& operator+=(const TestCounts& other) {
    nodes += other.nodes;
    primitives += other.primitives;
    exactly_decided += other.exactly_decided;
    return *this;
  }
};

/// Accepts every primitive.
struct AnyPrimitive {
  constexpr bool operator()(int /*primitive*/) const { return true; }
};

/// What a primitive does to shadow rays.
enum class ShadowRole : std::uint8_t {
  stops,
  filters,  ///< lets light through, weighted
  ignored   ///< an equal primitive in the same place filters already
};

/// `roles`: by primitive; all that come after them stop shadow rays.
[[nodiscard]] inline ShadowRole role_of(const std::vector<ShadowRole>& roles, int primitive) {
  const auto at = static_cast<std::size_t>(primitive);
  return at < roles.size() ? roles[at] : ShadowRole::stops;
}

/// Accepts the primitives that stop shadow rays.
struct StopsShadows {
  const std::vector<ShadowRole>& roles;
  bool operator()(int primitive) const { return role_of(roles, primitive) == ShadowRole::stops; }
};

/// Accepts the primitives of the selected bodies.
struct OfBodies {
  const std::vector<std::int32_t>& body_of;  ///< by primitive; -1: of no body, as are all that come after them
  const std::vector<std::uint8_t>& asked;    ///< by body
  bool operator()(int primitive) const {
    const auto at = static_cast<std::size_t>(primitive);
    const std::int32_t body = at < body_of.size() ? body_of[at] : -1;
    return body >= 0 && asked[static_cast<std::size_t>(body)] != 0;
  }
};

/// The test that a search makes of each primitive; its cost is added to `counts`. `AnyRay` is a Ray or a NaiveRay.
template <class T, class Accept, class AnyRay>
class Query {
 public:
  Query(const AnyRay& ray, T t_max, TestCounts& counts, Accept accept)
      : ray_(ray), t_max_(t_max), counts_(counts), accept_(accept) {}
  void enter_node() { ++counts_.nodes; }
  /// Counts nodes that were entered, and tests that ruled out a primitive before its own test was needed.
  void count(std::uint64_t nodes, std::uint64_t ruled_out) {
    counts_.nodes += nodes;
    counts_.primitives += ruled_out;
  }
  [[nodiscard]] const AnyRay& ray() const { return ray_; }
  [[nodiscard]] const TestCounts& counts() const { return counts_; }  ///< previous searches included

 protected:
  std::optional<Intersection<T>> intersect(const Primitives<T>& primitives, int id) {
    if (!accept_(id)) return std::nullopt;
    ++counts_.primitives;
    // The full t_max, not the nearest t so far: a tie must be seen to be decided.
    return primitives.intersect(id, ray_, t_max_, counts_, &sheared_);
  }
  /// The same for a triangle that neither moves nor is degenerate, given its coordinates (intersect_corners).
  template <class Coordinate>
  std::optional<Intersection<T>> intersect(const Primitives<T>& primitives, int id, const Coordinate& coordinate) {
    if (!accept_(id)) return std::nullopt;
    ++counts_.primitives;
    return primitives.intersect_triangle(id, coordinate, sheared(), ray_, t_max_, counts_);
  }
  /// The same for the triangle of a copy, given as it is placed.
  std::optional<Intersection<T>> intersect(const Primitives<T>& primitives, int id, const Triangle<T>& placed) {
    if (!accept_(id)) return std::nullopt;
    ++counts_.primitives;
    return primitives.intersect_copied(id, placed, sheared(), ray_, t_max_, counts_);
  }

  const ShearedRay<T>& sheared() {
    if (!sheared_) sheared_.emplace(ray_);
    return *sheared_;
  }

  const AnyRay& ray_;
  std::optional<ShearedRay<T>> sheared_;  ///< the ray as triangle tests need it, from the first of them on
  T t_max_;
  TestCounts& counts_;
  Accept accept_;
};

/// A search for the nearest accepted hit in (0, t_max); an exact tie in t goes to the lower id.
template <class T, class Accept, class AnyRay>
class ClosestQuery : public Query<T, Accept, AnyRay> {
 public:
  static constexpr bool shortens = true;  ///< each hit shortens t_far
  ClosestQuery(const AnyRay& ray, T t_max, TestCounts& counts, Accept accept)
      : Query<T, Accept, AnyRay>(ray, t_max, counts, accept), t_far_(t_max) {}

  /// Tests one primitive; true when the search is over. `triangle`: nothing, or what `cross` takes of a triangle.
  template <class... KnownTriangle>
  bool test(const Primitives<T>& primitives, int id, const KnownTriangle&... triangle) {
    const auto intersection = this->intersect(primitives, id, triangle...);
    if (!intersection || !(intersection->t < hit_.t || (intersection->t == hit_.t && id < hit_.primitive)))
      return false;
    constexpr T margin = 1 + 4096 * std::numeric_limits<T>::epsilon();
    hit_ = {intersection->t, id, intersection->part};
    t_far_ = intersection->t * margin;
    return false;
  }

  /// A box entered beyond this cannot contain a nearer hit. A computed t may err by more than a box's entry does (at
  /// grazing incidence), so the margin is generous; it costs a few visits and no correctness.
  [[nodiscard]] T t_far() const { return t_far_; }
  [[nodiscard]] static constexpr bool over() { return false; }  ///< another may be nearer
  [[nodiscard]] std::optional<Hit<T>> nearest() const {
    return hit_.primitive == no_primitive ? std::nullopt : std::optional(hit_);
  }

 private:
  static constexpr int no_primitive = std::numeric_limits<int>::max();
  T t_far_;
  Hit<T> hit_{infinity<T>, no_primitive, 0};
};

/// A search for any hit in (0, t_max).
template <class T, class AnyRay>
class OcclusionQuery : public Query<T, AnyPrimitive, AnyRay> {
 public:
  static constexpr bool shortens = false;
  OcclusionQuery(const AnyRay& ray, T t_max, TestCounts& counts)
      : Query<T, AnyPrimitive, AnyRay>(ray, t_max, counts, {}) {}

  template <class... KnownTriangle>
  bool test(const Primitives<T>& primitives, int id, const KnownTriangle&... triangle) {
    if (this->intersect(primitives, id, triangle...)) found_ = id;
    return found();
  }
  /// One that is certainly hit; false if it takes its test to tell.
  bool take(const Primitives<T>& primitives, int id) {
    if (!primitives.stands_apart(this->ray_.departure.primitive, id)) return false;
    ++this->counts_.primitives;
    found_ = id;
    return true;
  }
  [[nodiscard]] T t_far() const { return this->t_max_; }
  [[nodiscard]] bool found() const { return found_ >= 0; }
  [[nodiscard]] bool over() const { return found(); }
  [[nodiscard]] int found_id() const { return found_; }

 private:
  int found_ = -1;
};

/// A search for what a shadow ray hits in (0, t_max): anything that stops it or, if nothing does, all primitives that
/// filter it, possibly more than once each.
template <class T, class AnyRay>
class FilteredOcclusionQuery : public Query<T, AnyPrimitive, AnyRay> {
 public:
  static constexpr bool shortens = false;
  FilteredOcclusionQuery(const AnyRay& ray, T t_max, TestCounts& counts, const std::vector<ShadowRole>& roles,
                         std::vector<int>& filters)
      : Query<T, AnyPrimitive, AnyRay>(ray, t_max, counts, {}), roles_(roles), filters_(filters) {}

  template <class... KnownTriangle>
  bool test(const Primitives<T>& primitives, int id, const KnownTriangle&... triangle) {
    const ShadowRole role = role_of(roles_, id);
    if (role == ShadowRole::ignored || !this->intersect(primitives, id, triangle...)) return false;
    if (role == ShadowRole::filters) {
      filters_.push_back(id);
      return false;
    }
    stopped_by_ = id;
    return true;
  }
  /// One that is certainly hit; false if it takes its test to tell, or does not stop the ray.
  bool take(const Primitives<T>& primitives, int id) {
    if (role_of(roles_, id) != ShadowRole::stops || !primitives.stands_apart(this->ray_.departure.primitive, id))
      return false;
    ++this->counts_.primitives;
    stopped_by_ = id;
    return true;
  }
  [[nodiscard]] T t_far() const { return this->t_max_; }
  [[nodiscard]] bool found() const { return stopped_by_ >= 0; }
  [[nodiscard]] bool over() const { return found(); }
  [[nodiscard]] int found_id() const { return stopped_by_; }

 private:
  const std::vector<ShadowRole>& roles_;
  std::vector<int>& filters_;
  int stopped_by_ = -1;
};

}  // namespace raywalk
