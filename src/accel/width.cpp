#include "accel/width.h"

#include <algorithm>
#include <atomic>
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

std::atomic<LaneWidth>& width_in_use() {
  static std::atomic<LaneWidth> width{lane_widths().back()};
  return width;
}

}  // namespace

const std::vector<LaneWidth>& lane_widths() {
  static const std::vector<LaneWidth> widths = asked_of_processor();
  return widths;
}

LaneWidth lane_width() { return width_in_use().load(std::memory_order_relaxed); }

ForcedWidth::ForcedWidth(LaneWidth width) : before_(lane_width()) {
  assert(std::count(lane_widths().begin(), lane_widths().end(), width) == 1);
  width_in_use().store(width, std::memory_order_relaxed);
}

ForcedWidth::~ForcedWidth() { width_in_use().store(before_, std::memory_order_relaxed); }

}  // namespace raywalk
