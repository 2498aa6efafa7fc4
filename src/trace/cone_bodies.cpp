#include "trace/cone_bodies.h"

#include "math/bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raywalk {

namespace {

/// Around a body; none where it has no end.
std::optional<ConeBall> around(const ConeBody& body) {
  if (const auto* ball = std::get_if<ConeBall>(&body.shape)) return *ball;
  const auto* faces = std::get_if<ConeFaces>(&body.shape);
  if (faces == nullptr) return std::nullopt;
  Bounds<double> box;
  for (const ConeFace& face : faces->faces)
    for (const Vec3d& corner : face.loops.front()) box.include(corner);
  return ConeBall{(box.min + box.max) / 2.0, length(box.max - box.min) / 2};
}

}  // namespace

ConeBodies::ConeBodies(std::vector<ConeBody> all) : all_(std::move(all)) {
  std::vector<std::pair<ConeBall, int>> waiting;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (const auto ball = around(all_[i]))
      waiting.push_back({*ball, static_cast<int>(i)});
    else
      endless_.push_back(static_cast<int>(i));
  }
  if (!waiting.empty()) build(waiting, 0, waiting.size());
}

void ConeBodies::build(std::vector<std::pair<ConeBall, int>>& waiting, std::size_t begin, std::size_t end) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({waiting[begin].first, waiting[begin].second});
  if (end - begin == 1) return;
  Bounds<double> box;
  for (std::size_t i = begin; i < end; ++i) box.include(waiting[i].first.centre);
  const Vec3d size = box.max - box.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto place = [&](std::size_t i) { return waiting.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(place(begin), place(middle), place(end), [axis](const auto& a, const auto& b) {
    return std::pair(a.first.centre[axis], a.second) < std::pair(b.first.centre[axis], b.second);
  });
  ConeBall ball{(box.min + box.max) / 2.0, 0};
  for (std::size_t i = begin; i < end; ++i)
    ball.radius = std::max(ball.radius, length(waiting[i].first.centre - ball.centre) + waiting[i].first.radius);
  build(waiting, begin, middle);
  nodes_[node] = {ball, 0, static_cast<int>(nodes_.size())};
  build(waiting, middle, end);
}

/// Rather too often: by far more than rounding.
bool ConeBodies::may_meet(const RayCone& cone, const ConeBall& ball, double depth) {
  const Vec3d to = ball.centre - cone.origin;
  const double slack = 1e-9 * (length(to) + ball.radius + cone.radius) * (1 + std::abs(cone.spread));
  const double along = dot(to, cone.axis), reach = ball.radius + slack;
  const double from = std::max(along - reach, 0.0), until = std::min(along + reach, depth);
  if (until + slack < from) return false;
  const double off = cone.flat ? std::abs(dot(to, cone.right)) : length(to - along * cone.axis);
  const double widest = std::max(std::abs(cone.radius_at(from)), std::abs(cone.radius_at(until)));
  return !(off > widest + reach);
}

std::vector<int> ConeBodies::near(const RayCone& cone, double depth) const {
  std::vector<int> found = endless_, waiting;
  if (!nodes_.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const int index = waiting.back();
    waiting.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (!may_meet(cone, node.ball, depth)) continue;
    if (node.second == 0) {
      found.push_back(node.first);
    } else {
      waiting.push_back(node.second);
      waiting.push_back(index + 1);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace raywalk
