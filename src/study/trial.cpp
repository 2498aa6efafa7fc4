#include "study/trial.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>

namespace raywalk::study {

namespace {

std::string columns_line(const Columns& columns) {
  return fmt::format("round,method,{},{},{},rays,nodes,tests,draws,seconds\n", columns.knob, columns.error,
                     columns.other);
}

/// A value as RFC 4180 wants it: in quotes where it holds a comma or a quote, which is doubled.
std::string csv_value(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// The next value of a line, without its quotes, and the comma behind it.
std::string next_value(std::string_view& line) {
  std::string value;
  bool in_quotes = false;
  std::size_t i = 0;
  for (; i < line.size() && (in_quotes || line[i] != ','); ++i)
    if (line[i] != '"')
      value += line[i];
    else if (in_quotes && line.substr(i + 1).starts_with('"'))
      value += line[i++];
    else
      in_quotes = !in_quotes;
  line.remove_prefix(std::min(i + 1, line.size()));
  return value;
}

/// strtod depends on the locale only for the decimal point, and no locale is set.
bool read(std::string_view& line, double& value) {
  const std::string word = next_value(line);
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0';
}

bool read(std::string_view& line, std::uint64_t& value) {
  const std::string word = next_value(line);
  char* end = nullptr;
  value = std::strtoull(word.c_str(), &end, 10);
  return !word.empty() && *end == '\0';
}

}  // namespace

Cost cost_of(const Statistics& statistics, double seconds) {
  std::uint64_t rays = 0;
  for (const std::uint64_t formed : statistics.rays) rays += formed;
  return {rays, statistics.tests.nodes, statistics.tests.primitives, statistics.random_draws(), seconds};
}

std::string csv_of(const std::vector<Trial>& trials, const Columns& columns, const std::string& heading) {
  std::string text = heading + columns_line(columns);
  for (const Trial& t : trials)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{:.6g}\n", t.round, csv_value(t.method), t.knob, t.error, t.other,
                        t.cost.rays, t.cost.nodes, t.cost.tests, t.cost.draws, t.cost.seconds);
  return text;
}

std::vector<Trial> trials_of(std::string_view csv, const Columns& columns, const std::string& heading) {
  const std::string begin = heading + columns_line(columns);
  if (!csv.starts_with(begin)) return {};
  csv.remove_prefix(begin.size());
  std::vector<Trial> trials;
  while (!csv.empty()) {
    const std::size_t end = csv.find('\n');
    if (end == std::string_view::npos) return {};
    std::string_view line = csv.substr(0, end);
    csv.remove_prefix(end + 1);
    Trial t;
    double round = 0;
    if (!read(line, round) || !(round >= 0 && round < 1e9) || round != std::floor(round)) return {};
    t.round = static_cast<int>(round);
    t.method = next_value(line);
    const bool understood = read(line, t.knob) && read(line, t.error) && read(line, t.other) &&
                            read(line, t.cost.rays) && read(line, t.cost.nodes) && read(line, t.cost.tests) &&
                            read(line, t.cost.draws) && read(line, t.cost.seconds) && line.empty();
    if (!understood) return {};
    trials.push_back(t);
  }
  return trials;
}

double thread_seconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0)
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace raywalk::study
