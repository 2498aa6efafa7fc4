#include "accel/width.h"

#include <algorithm>
#include <cassert>

namespace raywalk {

namespace {

std::vector<LaneWidth> asked_of_processor() {
  std::vector<LaneWidth> widths{LaneWidth::four};
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) widths.push_back(LaneWidth::eight);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
    widths.push_back(LaneWidth::eight_masked);
#endif
  return widths;
}

thread_local constinit std::optional<LaneWidth> forced_width;

}  // namespace

const std::vector<LaneWidth>& lane_widths() {
  static const std::vector<LaneWidth> widths = asked_of_processor();
  return widths;
}

LaneWidth lane_width() {
  static const LaneWidth widest = lane_widths().back();
  return forced_width.value_or(widest);
}

ForcedWidth::ForcedWidth(LaneWidth width) : before_(forced_width) {
  assert(std::count(lane_widths().begin(), lane_widths().end(), width) == 1);
  forced_width = width;
}

ForcedWidth::~ForcedWidth() { forced_width = before_; }

}  // namespace raywalk
