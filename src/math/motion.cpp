#include "math/motion.h"

#include <algorithm>

namespace raywalk {

bool is_at_rest(const Motion& motion) {
  return std::all_of(motion.begin(), motion.end(),
                     [&](const MotionKey& key) { return key.offset == motion.front().offset; });
}

bool moves_between(const Motion& motion, double open, double close) {
  const Vec3d first = offset_at(motion, open);
  const auto elsewhere = [&](const MotionKey& key) {
    return open < key.time && key.time < close && key.offset != first;
  };
  return offset_at(motion, close) != first || std::any_of(motion.begin(), motion.end(), elsewhere);
}

Vec3d offset_at(const Motion& motion, double time) {
  if (motion.empty()) return Vec3d(0.0);
  const auto next = std::upper_bound(motion.begin(), motion.end(), time,
                                     [](double at, const MotionKey& key) { return at < key.time; });
  if (next == motion.begin()) return motion.front().offset;
  if (next == motion.end()) return motion.back().offset;
  const MotionKey &a = *(next - 1), &b = *next;
  return a.offset + (time - a.time) / (b.time - a.time) * (b.offset - a.offset);
}

Motion moved_within(const Motion& inner, const Affine<double>& outer, const Motion& whole) {
  std::vector<double> times;
  for (const Motion* motion : {&inner, &whole})
    for (const MotionKey& key : *motion) times.push_back(key.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  Motion both;
  for (const double time : times)
    both.push_back({time, outer.direction(offset_at(inner, time)) + offset_at(whole, time)});
  return both;
}

}  // namespace raywalk
