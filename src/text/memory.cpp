#include "text/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <utility>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace raywalk {

#ifdef __linux__

namespace {

/// The first number of a small file; none if there is none ("max").
std::optional<double> number_in_file(const std::string& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

/// What the kernel would provide without swapping, and free swap.
std::optional<double> free_memory() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  double kib = 0, sum = 0;
  bool known = false;
  while (file >> key >> kib && std::getline(file, unit)) {
    if (key != "MemAvailable:" && key != "SwapFree:") continue;
    known = known || key == "MemAvailable:";
    sum += kib * 1024;
  }
  return known ? std::optional(sum) : std::nullopt;
}

std::optional<double> free_addresses() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const auto pages = number_in_file("/proc/self/statm");
  const double used = pages.value_or(0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(static_cast<double>(limit.rlim_cur) - used, 0.0);
}

/// Of our control group, set by a container or a batch system: version 2, then 1.
std::optional<double> free_in_group() {
  constexpr std::array<std::pair<const char*, const char*>, 2> files{
      {{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
       {"/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes"}}};
  for (const auto& [most, used] : files)
    if (const auto limit = number_in_file(most)) return std::max(*limit - number_in_file(used).value_or(0), 0.0);
  return std::nullopt;
}

}  // namespace

std::optional<MemoryLeft> memory_left() {
  std::optional<MemoryLeft> least;
  const auto take = [&](const std::optional<double>& bytes, std::string_view limit) {
    if (bytes && (!least || *bytes < least->bytes)) least = MemoryLeft{*bytes, limit};
  };
  take(free_memory(), "this machine has free");
  take(free_addresses(), "the address-space limit (ulimit -v) leaves");
  take(free_in_group(), "the control group of this program leaves");
  return least;
}

#else

std::optional<MemoryLeft> memory_left() { return std::nullopt; }

#endif

namespace {

std::string in_units(double bytes) {
  constexpr double mib = 1 << 20, gib = 1024 * mib, tib = 1024 * gib;
  if (bytes >= 1e6 * tib) return fmt::format("{:.1e} TiB", bytes / tib);
  if (bytes >= tib) return fmt::format("{:.1f} TiB", bytes / tib);
  return bytes >= gib ? fmt::format("{:.1f} GiB", bytes / gib) : fmt::format("{:.0f} MiB", bytes / mib);
}

}  // namespace

std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file) {
  constexpr double always_there = 64 << 20;
  if (need.bytes <= always_there) return std::nullopt;
  return why_too_large(need, file, memory_left());
}

std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file,
                                   const std::optional<MemoryLeft>& left) {
  if (!left || need.bytes <= left->bytes) return std::nullopt;
  return Error{
      file, 0, 0,
      fmt::format("{} would take about {} of memory, {} too much (expected at most {}, which {})", need.what,
                  in_units(need.bytes), in_units(need.bytes - left->bytes), in_units(left->bytes), left->limit),
      need.hint};
}

}  // namespace raywalk
