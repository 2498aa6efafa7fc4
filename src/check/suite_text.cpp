#include "check/suite.h"

#include <fmt/format.h>

#include <array>
#include <sstream>
#include <string_view>

namespace raywalk::check {

namespace {

/// A row's numbers, in the order in which a state file has them.
constexpr std::array counts{&Tally::rays,    &Tally::hits,       &Tally::missed,       &Tally::false_hits,
                            &Tally::leaks,   &Tally::self_hits,  &Tally::sheet_missed, &Tally::unequal,
                            &Tally::excused, &Tally::exact_path, &Tally::rationals};
constexpr std::array errors{&Tally::exact_ulps, &Tally::fast_ulps, &Tally::fast_ulps_by_condition};

std::string heading(const SuiteOptions& options) {
  return fmt::format("raywalk numerics, {} rays a family, seed {}{}{}", options.rays, options.seed,
                     options.program.empty() ? "" : ", program ", options.program);
}

std::string share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? "-" : fmt::format("{:.2f}%", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string ulps(double worst) { return worst == 0 ? "0" : fmt::format("{:.3g}", worst); }

}  // namespace

std::string table_text(const std::vector<Family>& families, const SuiteResult& result) {
  constexpr std::string_view layout =
      "{:<22} {:<22} {:<6} {:>10} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>9} {:>9} {:>8} {:>8}";
  std::string text = fmt::format(fmt::runtime(layout), "family", "stratum", "scalar", "rays", "missed", "false",
                                 "leaks", "self", "sheet", "differ", "ulp exact", "ulp fast", "/kappa", "exact");
  text += "\n";
  for (const Tested& line : result.lines) {
    const Tally& r = line.tally;
    text += fmt::format(fmt::runtime(layout), line.family, line.line, line.scalar, r.rays, r.missed, r.false_hits,
                        r.leaks, r.self_hits, r.sheet_missed, r.unequal, ulps(r.exact_ulps), ulps(r.fast_ulps),
                        ulps(r.fast_ulps_by_condition), share(r.exact_path, r.rays));
    text += line.broken.empty() ? "\n" : "  BROKEN: " + line.broken + "\n";
  }
  for (const Family& family : families)
    if (!family.instead.empty()) text += "\n" + family.name + ": " + family.instead + "\n";
  return text;
}

std::string state_text(const SuiteOptions& options, const std::vector<Tested>& lines) {
  std::string text = heading(options) + "\n";
  for (const Tested& line : lines) {
    text += line.family + "\t" + line.line + "\t" + line.scalar;
    for (const auto count : counts) text += fmt::format("\t{}", line.tally.*count);
    for (const auto error : errors) text += fmt::format("\t{}", line.tally.*error);
    text += "\n";
  }
  return text;
}

Result<std::vector<Tested>> read_state(const std::string& path, const std::string& text, const SuiteOptions& options) {
  std::istringstream in(text);
  std::string line;
  int number = 1;
  if (!std::getline(in, line) || line != heading(options))
    return tl::unexpected(Error{path, 1, 0, "this keeps another run (expected \"" + heading(options) + "\")",
                                "remove the file, or name another with --state"});
  std::vector<Tested> lines;
  while (std::getline(in, line)) {
    ++number;
    std::istringstream cells(line);
    Tested tested;
    bool read = std::getline(cells, tested.family, '\t') && std::getline(cells, tested.line, '\t') &&
                std::getline(cells, tested.scalar, '\t');
    for (const auto count : counts)  // one below 0 would be read as a large one
      read = read && (cells >> std::ws).peek() != '-' && cells >> tested.tally.*count;
    for (const auto error : errors) {
      std::string word;  // "inf" too, which a stream does not read as a number
      read = read && cells >> word;
      if (read) tested.tally.*error = std::strtod(word.c_str(), nullptr);
    }
    if (!read || !(cells >> std::ws).eof())
      return tl::unexpected(Error{path, number, 0, "this line is not one of a state file",
                                  "remove the file; the run then starts afresh"});
    lines.push_back(tested);
  }
  return lines;
}

}  // namespace raywalk::check
