#include "check/suite.h"

#include "text/file.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>

namespace raywalk::check {

namespace {

constexpr std::uint64_t chunk_rays = 1 << 12;
constexpr std::uint64_t least_rays = 20;  // of a line: not every ray that is aimed can be formed
constexpr std::size_t max_state_bytes = 1 << 24;

const Tested* find(const std::vector<Tested>& lines, const Family& family, const TableLine& line) {
  for (const Tested& one : lines)
    if (one.family == family.name && one.line == line.name && one.scalar == line.scalar) return &one;
  return nullptr;
}

/// Calls body(0) .. body(count - 1), each once, in up to `threads` threads; 0: one per hardware thread.
void in_parallel(std::uint64_t count, int threads, const std::function<void(std::uint64_t)>& body) {
  const std::uint64_t most = threads > 0 ? static_cast<std::uint64_t>(threads) : std::thread::hardware_concurrency();
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < count; i = next++) body(i);
  };
  std::vector<std::thread> helpers;
  try {
    for (std::uint64_t i = 1; i < std::min(most, count); ++i) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // The system refuses more threads; those that there are do all of the work.
  }
  work();
  for (std::thread& helper : helpers) helper.join();
}

/// The line's tests 0..rays - 1, summed in order of their chunks; none if stopped.
std::optional<Tally> run_line(const TableLine& line, std::uint64_t rays, const SuiteOptions& options,
                              const std::function<void(std::uint64_t)>& advance) {
  const std::uint64_t chunks = (rays + chunk_rays - 1) / chunk_rays;
  constexpr std::uint64_t at_once = 64;
  Tally sum;
  for (std::uint64_t from = 0; from < chunks; from += at_once) {
    if (options.stop.asked()) return std::nullopt;
    const std::uint64_t count = std::min(at_once, chunks - from);
    std::vector<Tally> rows(count);
    in_parallel(count, options.threads, [&](std::uint64_t i) {
      if (options.stop.asked()) return;
      const std::uint64_t first = (from + i) * chunk_rays;
      rows[i] = line.run(options.seed, first, std::min(chunk_rays, rays - first));
    });
    if (options.stop.asked()) return std::nullopt;
    for (const Tally& tally : rows) sum += tally;
    advance(std::min(rays, (from + count) * chunk_rays));
  }
  return sum;
}

}  // namespace

bool SuiteResult::good() const {
  return finished && std::all_of(lines.begin(), lines.end(), [](const Tested& line) { return line.broken.empty(); });
}

Result<SuiteResult> run_suite(const std::vector<Family>& families, const SuiteOptions& options) {
  std::vector<Tested> kept;
  if (!options.state.empty())
    if (const auto claimed = claim_output(options.state, OutputUse::kept); !claimed)
      return tl::unexpected(claimed.error());
  std::error_code none;
  if (!options.state.empty() && std::filesystem::exists(options.state, none)) {
    const auto text = read_file(options.state, max_state_bytes);
    if (!text) return tl::unexpected(text.error());
    auto read = read_state(options.state, *text, options);
    if (!read) return tl::unexpected(read.error());
    kept = std::move(*read);
  }
  std::uint64_t to_do = 0;
  const auto rays_of = [&](const Family& family) {
    return std::max(least_rays, options.rays / std::max<std::size_t>(1, family.lines.size()));
  };
  for (const Family& family : families)
    for (const TableLine& line : family.lines)
      if (!find(kept, family, line)) to_do += rays_of(family);

  SuiteResult result;
  std::uint64_t done = 0;
  const auto start = std::chrono::steady_clock::now();
  for (const Family& family : families) {
    for (const TableLine& line : family.lines) {
      if (const Tested* earlier = find(kept, family, line)) {
        result.lines.push_back(*earlier);
        result.lines.back().broken = broken_goal(line.goals, earlier->tally);
        continue;
      }
      const auto tally = run_line(line, rays_of(family), options, [&](std::uint64_t of_line) {
        if (!options.progress) return;
        const double share = static_cast<double>(done + of_line) / static_cast<double>(to_do);
        const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        options.progress(share, spent / share - spent);
      });
      if (!tally) {
        result.finished = false;
        return result;
      }
      done += rays_of(family);
      result.lines.push_back({family.name, line.name, line.scalar, *tally, broken_goal(line.goals, *tally)});
      if (!options.state.empty()) {
        kept.push_back(result.lines.back());
        if (const auto written = write_file_atomically(options.state, state_text(options, kept)); !written)
          return tl::unexpected(written.error());
      }
    }
  }
  return result;
}

}  // namespace raywalk::check
