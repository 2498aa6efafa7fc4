#pragma once
// What a watched search through an accelerator records.

#include "math/bounds.h"
#include "math/transform.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace raywalk {

/// A box of either precision, in double.
template <class T>
[[nodiscard]] Bounds<double> wide(const Bounds<T>& box) {
  return {wide(box.min), wide(box.max)};
}

/// Why a node was not entered.
enum class Skip {
  missed,  ///< the ray misses it
  behind,  ///< it lies behind the ray's origin
  beyond,  ///< the ray reaches it only beyond the nearest hit so far, or beyond the light
};

/// Why a search ended.
enum class SearchEnd {
  all_seen,  ///< no node, cell or primitive is left
  blocked,   ///< a shadow ray needs no second blocker
  beyond,    ///< the next cell begins beyond the nearest hit, or beyond the light
  left,      ///< the ray has left the grid
};

/// One step of a search. Positions are in scene units, t in the ray's own.
struct SearchEvent {
  enum class Kind {
    entered,  ///< a node or cell, which is counted
    opened,   ///< a leaf of a BVH, which is not counted: its box was tested together with the others of its node
    skipped,  ///< a node or cell
    tested,   ///< a primitive
    passed,   ///< a primitive already tested for this ray
    ended,
  };
  enum class Test {
    missed,
    nearest,  ///< hit, nearer than all before; of a shadow ray: blocked
    farther,  ///< hit, but beyond the nearest one
    filters,  ///< a shadow ray passes through, attenuated
  };
  Kind kind = Kind::entered;
  Bounds<double> box{};        ///< of the node; for `tested` and `passed` of the node that lists the primitive, empty
                               ///< for none
  double t_in = 0, t_out = 0;  ///< the ray's interval in the box
  bool leaf = false;           ///< entered: it lists primitives, not nodes
  int items = 0;               ///< entered, opened: primitives listed, or children
  Skip skip = Skip::missed;
  SearchEnd end = SearchEnd::all_seen;
  int primitive = -1;  ///< tested, passed: its id
  Test test = Test::missed;
  double t = 0;              ///< tested, unless missed: of the crossing
  bool outside = false;      ///< tested: hit, but outside the cell that lists it
  bool again = false;        ///< tested before
  double t_far = 0;          ///< t of the nearest hit after this, or of the light; infinite for neither
  int nodes = 0, tests = 0;  ///< nodes entered and tests made so far
};

/// The interval of a whole line, origin + t direction, in a box; none where it misses.
[[nodiscard]] std::optional<std::array<double, 2>> line_in_box(const Vec3d& origin, const Vec3d& direction,
                                                               const Bounds<double>& box);

/// The events of one search, in order.
class SearchRecord {
 public:
  /// For a ray that ends at `t_far`. Events beyond `most` are counted, but not kept.
  SearchRecord(const Vec3d& origin, const Vec3d& direction, double t_far, std::size_t most = 20000)
      : origin_(origin), direction_(direction), t_far_(t_far), most_(most) {}

  [[nodiscard]] const std::vector<SearchEvent>& events() const { return events_; }
  [[nodiscard]] bool complete() const { return complete_; }
  /// The test that found the nearest hit so far, or the blocker; none: nothing was found.
  [[nodiscard]] const std::optional<SearchEvent>& nearest() const { return nearest_; }

  template <class T>
  void entered(const Bounds<T>& box, bool leaf, std::size_t items) {
    ++nodes_;
    enter(SearchEvent::Kind::entered, wide(box), leaf, static_cast<int>(items));
  }
  template <class T>
  void opened(const Bounds<T>& box, std::size_t items) {
    enter(SearchEvent::Kind::opened, wide(box), true, static_cast<int>(items));
  }
  /// The reason follows from the ray. `counted`: it counts as entered.
  template <class T>
  void skipped(const Bounds<T>& box, bool counted = false) {
    skip(wide(box), counted);
  }
  /// What follows is in the space that `to_world` maps from, until the frame is left.
  void enter_frame(const Affine<double>& to_world) { to_world_ = to_world; }
  void leave_frame() { to_world_.reset(); }
  void tested(int primitive, std::optional<double> t, bool filters);
  void passed(int primitive);
  /// Only the first call counts.
  void ended(SearchEnd why);

 private:
  void enter(SearchEvent::Kind kind, const Bounds<double>& given, bool leaf, int items);
  void skip(const Bounds<double>& given, bool counted);
  /// A box in world space.
  [[nodiscard]] Bounds<double> placed(const Bounds<double>& box) const {
    return to_world_ ? image_of(*to_world_, box) : box;
  }
  void add(SearchEvent event);

  Vec3d origin_, direction_;
  double t_far_;
  std::size_t most_;
  std::vector<SearchEvent> events_;
  std::vector<int> seen_;  ///< primitives tested
  Bounds<double> box_{};   ///< the current node
  std::optional<Affine<double>> to_world_;
  double t_out_ = std::numeric_limits<double>::infinity();
  int nodes_ = 0, tests_ = 0;
  bool complete_ = true, over_ = false;
  std::optional<SearchEvent> nearest_;
};

/// A query that records nodes. The renderer's queries do not, so no hook is compiled for them.
template <class Query>
concept Watching = requires(const Query& query) { query.record(); };

/// What only a watched search stores: a T, or nothing.
template <class Query, class T>
struct WatchedOnly {};
template <Watching Query, class T>
struct WatchedOnly<Query, T> {
  T value{};
};

}  // namespace raywalk
