#include "trace/patch_elements.h"

#include <algorithm>

namespace raywalk {

namespace {

double difference(const Rgbd& a, const Rgbd& b) { return std::max(max_component(a - b), max_component(b - a)); }

}  // namespace

PatchElements::PatchElements(const Patches& patches, int patch, const std::vector<int>& sources, const Rgbd& bounced) {
  const Patch& whole = patches[patch];
  const auto light_at = [&](const Vec3d& point) {
    constexpr double within = 0.999;  // not on an edge, where the next surface may begin
    return patches.straight_light(patch, whole.centre + within * (point - whole.centre), sources);
  };
  struct Waiting {
    std::size_t element;
    int depth;
  };
  std::vector<Waiting> waiting{{0, 0}};
  elements_.push_back({whole, {}});
  for (std::size_t i = 0; i < static_cast<std::size_t>(whole.corners); ++i)
    elements_[0].light[i] = light_at(whole.corner[i]);
  while (!waiting.empty()) {
    const auto [index, depth] = waiting.back();
    waiting.pop_back();
    const Element element = elements_[index];
    const auto corners = static_cast<std::size_t>(element.piece.corners);
    const auto& corner = element.piece.corner;
    Vec3d middle(0.0);
    Rgbd mean(0.0);
    for (std::size_t i = 0; i < corners; ++i) middle += corner[i], mean += element.light[i];
    middle /= static_cast<double>(corners), mean /= static_cast<double>(corners);
    // Is light between the corners what it would be if it changed evenly?
    std::array<Vec3d, 4> half;
    std::array<Rgbd, 4> half_light;
    const Rgbd middle_light = light_at(middle);
    double off = difference(middle_light, mean), most = max_component(middle_light);
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = (i + 1) % corners;
      half[i] = 0.5 * (corner[i] + corner[next]);
      half_light[i] = light_at(half[i]);
      off = std::max(off, difference(half_light[i], 0.5 * (element.light[i] + element.light[next])));
      most = std::max({most, max_component(half_light[i]), max_component(element.light[i])});
    }
    constexpr double seen = 0.02;
    if (depth >= least_depth && !(off > seen * (most + max_component(bounced)))) continue;

    elements_[index].quarters = elements_.size();
    const auto add = [&](const std::array<Vec3d, 4>& at, const std::array<Rgbd, 4>& light) {
      if (depth + 1 < most_depth) waiting.push_back({elements_.size(), depth + 1});
      Element quarter{element.piece, light};
      quarter.piece.corner = at;
      quarter.piece.area /= 4;
      elements_.push_back(quarter);
    };
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t before = (i + corners - 1) % corners;
      if (corners == 4)
        add({corner[i], half[i], middle, half[before]},
            {element.light[i], half_light[i], middle_light, half_light[before]});
      else
        add({corner[i], half[i], half[before]}, {element.light[i], half_light[i], half_light[before]});
    }
    if (corners == 3) add({half[0], half[1], half[2]}, {half_light[0], half_light[1], half_light[2]});
  }
}

Rgbd PatchElements::straight_light_at(const Vec3d& point) const {
  std::size_t index = 0;
  while (elements_[index].quarters != 0) {
    const std::size_t first = elements_[index].quarters;
    double best = -infinity<double>;
    for (std::size_t quarter = first; quarter < first + 4; ++quarter)
      if (const double inside = inside_by(elements_[quarter].piece, point); inside > best)
        best = inside, index = quarter;
  }
  const Element& element = elements_[index];
  const std::array<double, 4> weights = mean_value_weights(element.piece, point);
  Rgbd sum(0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * element.light[i];
  return sum;
}

}  // namespace raywalk
