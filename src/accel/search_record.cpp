#include "accel/search_record.h"

#include <algorithm>
#include <utility>

namespace raywalk {

std::optional<std::array<double, 2>> line_in_box(const Vec3d& origin, const Vec3d& direction,
                                                 const Bounds<double>& box) {
  if (box.empty()) return std::nullopt;
  std::array<double, 2> stretch{-infinity<double>, infinity<double>};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.min[axis] - origin[axis]) / direction[axis];
    const double b = (box.max[axis] - origin[axis]) / direction[axis];
    stretch[0] = std::max(stretch[0], std::min(a, b));
    stretch[1] = std::min(stretch[1], std::max(a, b));
  }
  if (!(stretch[0] <= stretch[1])) return std::nullopt;
  return stretch;
}

void SearchRecord::add(SearchEvent event) {
  event.t_far = t_far_;
  event.nodes = nodes_;
  event.tests = tests_;
  if (events_.size() < most_)
    events_.push_back(event);
  else
    complete_ = false;
}

void SearchRecord::enter(SearchEvent::Kind kind, const Bounds<double>& given, bool leaf, int items) {
  const Bounds<double> box = placed(given);
  const auto line = line_in_box(origin_, direction_, box);
  SearchEvent event;
  event.kind = kind;
  event.box = box_ = box;
  // A box that is touched within rounding is entered, although the computed line misses it.
  event.t_in = line ? std::max((*line)[0], 0.0) : 0;
  event.t_out = t_out_ = line ? (*line)[1] : infinity<double>;
  event.leaf = leaf;
  event.items = items;
  add(event);
}

void SearchRecord::skip(const Bounds<double>& given, bool counted) {
  const Bounds<double> box = placed(given);
  if (counted) ++nodes_;
  SearchEvent event;
  event.kind = SearchEvent::Kind::skipped;
  event.box = box;
  if (const auto line = line_in_box(origin_, direction_, box)) {
    event.t_in = (*line)[0];
    event.t_out = (*line)[1];
    event.skip = event.t_out < 0 ? Skip::behind : event.t_in >= t_far_ ? Skip::beyond : Skip::missed;
  }
  add(event);
}

void SearchRecord::tested(int primitive, std::optional<double> t, bool filters) {
  SearchEvent event;
  event.kind = SearchEvent::Kind::tested;
  event.box = box_;
  event.primitive = primitive;
  const auto place = std::lower_bound(seen_.begin(), seen_.end(), primitive);
  event.again = place != seen_.end() && *place == primitive;
  if (!event.again) seen_.insert(place, primitive);
  if (t) {
    constexpr double rounding = 1e-6;  // of a float ray and of the box
    event.t = *t;
    event.outside = !box_.empty() && *t > t_out_ * (1 + rounding);
    event.test = filters ? SearchEvent::Test::filters
                 : *t < t_far_ || (nearest_ && *t == nearest_->t && primitive < nearest_->primitive)
                     ? SearchEvent::Test::nearest
                     : SearchEvent::Test::farther;
    if (event.test == SearchEvent::Test::nearest) t_far_ = *t, nearest_ = event;
  }
  ++tests_;
  add(event);
}

void SearchRecord::passed(int primitive) {
  SearchEvent event;
  event.kind = SearchEvent::Kind::passed;
  event.box = box_;
  event.primitive = primitive;
  add(event);
}

void SearchRecord::ended(SearchEnd why) {
  if (std::exchange(over_, true)) return;
  SearchEvent event;
  event.kind = SearchEvent::Kind::ended;
  event.end = why;
  add(event);
}

}  // namespace raywalk
