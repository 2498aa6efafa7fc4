#pragma once
// What a search through an accelerator tells whoever watches it.

#include "math/bounds.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace raywalk {

/// A box of either precision in double.
template <class T>
[[nodiscard]] Bounds<double> wide(const Bounds<T>& box) {
  return {wide(box.min), wide(box.max)};
}

/// Why a node was not entered.
enum class Skip {
  missed,  ///< the ray passes it
  behind,  ///< it lies behind the ray's origin
  beyond,  ///< the ray reaches it only behind the nearest hit so far, or behind the light
};

/// Why a search ended.
enum class SearchEnd {
  all_seen,  ///< no node, cell or primitive is left
  blocked,   ///< a shadow ray needs no second blocker
  beyond,    ///< the next cell begins behind the nearest hit, or behind the light
  left,      ///< the ray has left the grid
};

/// One thing that a search did. Places are in scene units, t in the ray's own.
struct SearchEvent {
  enum class Kind {
    entered,  ///< a node or cell, which counts
    opened,   ///< a leaf of a BVH, which does not: its box was met together with the other three of its node
    skipped,  ///< a node or cell
    tested,   ///< a primitive
    passed,   ///< a primitive that has been tested for this ray already
    ended,
  };
  enum class Test {
    missed,
    nearest,  ///< hit, nearer than all before; of a shadow ray: blocked
    farther,  ///< hit, but behind the nearest one
    filters,  ///< a shadow ray goes through, weakened
  };
  Kind kind = Kind::entered;
  Bounds<double> box{};        ///< of the node; of `tested` and `passed` that which lists the primitive, empty for none
  double t_in = 0, t_out = 0;  ///< the ray's stretch in the box
  bool leaf = false;           ///< entered: it lists primitives and no further nodes
  int items = 0;               ///< entered, opened: primitives listed, or children
  Skip skip = Skip::missed;
  SearchEnd end = SearchEnd::all_seen;
  int primitive = -1;  ///< tested, passed: its id
  Test test = Test::missed;
  double t = 0;              ///< tested, unless missed: of the crossing
  bool outside = false;      ///< tested: it is hit, but in a later cell than the one that lists it
  bool again = false;        ///< tested: not for the first time
  double reach = 0;          ///< of the nearest hit after this, or of the light; infinite for neither
  int nodes = 0, tests = 0;  ///< entered and made up to here
};

/// The stretch of a whole line, origin + t direction, in a box; none where it passes.
[[nodiscard]] std::optional<std::array<double, 2>> line_in_box(const Vec3d& origin, const Vec3d& direction,
                                                               const Bounds<double>& box);

/// The events of one search, in their order.
class SearchRecord {
 public:
  /// Of a ray that looks no farther than `reach`. More than `most` events are counted, but not kept.
  SearchRecord(const Vec3d& origin, const Vec3d& direction, double reach, std::size_t most = 20000)
      : origin_(origin), direction_(direction), reach_(reach), most_(most) {}

  [[nodiscard]] const std::vector<SearchEvent>& events() const { return events_; }
  [[nodiscard]] bool complete() const { return complete_; }
  /// The test that found what is nearest so far, or what blocks; none: nothing was found.
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
  /// Why, the ray itself tells. `counted`: it counts as one that was entered.
  template <class T>
  void skipped(const Bounds<T>& box, bool counted = false) {
    skip(wide(box), counted);
  }
  void tested(int primitive, std::optional<double> t, bool filters);
  void passed(int primitive);
  /// The first one counts.
  void ended(SearchEnd why);

 private:
  void enter(SearchEvent::Kind kind, const Bounds<double>& box, bool leaf, int items);
  void skip(const Bounds<double>& box, bool counted);
  void add(SearchEvent event);

  Vec3d origin_, direction_;
  double reach_;
  std::size_t most_;
  std::vector<SearchEvent> events_;
  std::vector<int> seen_;  ///< primitives tested
  Bounds<double> box_{};   ///< the node under way
  double t_out_ = std::numeric_limits<double>::infinity();
  int nodes_ = 0, tests_ = 0;
  bool complete_ = true, over_ = false;
  std::optional<SearchEvent> nearest_;
};

/// A query that wants to be told of nodes. The renderer's queries are none, so that no hook of theirs is compiled.
template <class Query>
concept Watching = requires(const Query& query) { query.record(); };

/// Room for what only a watched search keeps: a T, or nothing.
template <class Query, class T>
struct Kept {};
template <Watching Query, class T>
struct Kept<Query, T> {
  T value{};
};

}  // namespace raywalk
