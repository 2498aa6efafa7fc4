#include "app/check_command.h"

#include <memory>

#if RAYWALK_CHECK
#include "app/interrupt.h"
#include "app/part_file.h"
#include "app/progress_bar.h"
#include "check/suite.h"
#include "text/file.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#endif

namespace raywalk {

#if RAYWALK_CHECK

namespace {

/// The number in goal A, and a hundredth of it.
constexpr std::uint64_t full_rays = 100'000'000, default_rays = 1'000'000;
constexpr const char* default_state = "raywalk-numerics.state";

/// The families of these names, in the table's order; all if none is named.
Result<std::vector<check::Family>> chosen(const std::vector<std::string>& names) {
  std::vector<check::Family> all = check::all_families();
  std::vector<std::string_view> known;
  for (const check::Family& family : all) known.push_back(family.name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = nearest_word(name, known);
    return tl::unexpected(
        Error{"", 0, 0, "there is no family \"" + name + "\" (expected " + one_of(known) + ")",
              meant.empty() ? "raywalk check numerics --list names them all" : "did you mean " + meant + "?"});
  }
  std::vector<check::Family> some;
  for (check::Family& family : all)
    if (names.empty() || std::find(names.begin(), names.end(), family.name) != names.end())
      some.push_back(std::move(family));
  return some;
}

}  // namespace

ExitCode check_numerics_command(const CheckOptions& options) {
  const auto families = chosen(options.names);
  if (!families) return refuse(families.error());
  if (options.list) {
    std::string names;
    for (const check::Family& family : *families) names += family.name + "\n";
    const auto printed = print(names);
    return printed ? ExitCode::done : fail(printed.error());
  }
  check::SuiteOptions suite;
  suite.rays = options.rays > 0 ? static_cast<std::uint64_t>(options.rays) : options.full ? full_rays : default_rays;
  suite.seed = options.seed;
  suite.threads = options.threads;
  suite.state = options.state.empty() && options.full ? default_state : options.state;
  if (!suite.state.empty())
    if (const auto program = read_file("/proc/self/exe", std::size_t{1} << 30)) suite.program = checksum(*program);
  const Interrupt interrupt(Patience::brief);
  suite.stop = interrupt.stop();
  Result<check::SuiteResult> result;
  {
    ProgressBar bar;
    suite.progress = [&bar](double done, double seconds_left) { bar.show(done, seconds_left); };
    result = check::run_suite(*families, suite);
    interrupt.heeded();
  }
  if (!result) return fail(result.error());
  if (const auto printed = print(check::table_text(*families, *result)); !printed) return fail(printed.error());
  if (!result->finished) {
    std::error_code unreadable;
    return fail({"", 0, 0, "interrupted; the table is of what was done",
                 suite.state.empty() ? "with --state FILE, a run goes on where it was stopped"
                 : std::filesystem::exists(suite.state, unreadable)
                     ? "the same command goes on from here, by " + suite.state
                     : "no part was finished that " + suite.state + " could keep; let it run longer"});
  }
  if (!result->good()) {
    const auto broken = std::count_if(result->lines.begin(), result->lines.end(),
                                      [](const check::Tested& line) { return !line.broken.empty(); });
    return fail({"", 0, 0, fmt::format("{} of {} lines break a goal", broken, result->lines.size()),
                 "the lines marked BROKEN say which"});
  }
  return ExitCode::done;
}

#else

ExitCode check_numerics_command(const CheckOptions& /*options*/) {
  return fail({"", 0, 0, "this build has no exact oracle (expected GMP when Raywalk was built)",
               "install libgmp-dev and build again"});
}

#endif

void declare_check(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("check", "Check Raywalk itself");
  command.require_subcommand(1);
  command.footer("Example:\n  raywalk check numerics sphere");
  CLI::App& numerics =
      *command.add_subcommand("numerics", "Aim rays at what is hard to decide, and judge each by exact arithmetic");
  const auto options = std::make_shared<CheckOptions>();
  CheckOptions& to = *options;
  numerics.add_option("NAME", to.names, "Only these families; left out: all")->type_name("");
  numerics.add_flag("--full", to.full, "100 million rays a family instead of a million; can be stopped and goes on");
  numerics.add_flag("--list", to.list, "Only name the families");
  constexpr int max_rays = 1 << 30, max_threads = 1024;
  add_whole(numerics, "--rays", to.rays, 1, max_rays, "Rays a family, over its lines; each gets at least 20");
  add_parsed(numerics, "--seed", to.seed, parse_seed, "N", "a whole number from 0 to 2^64 - 1",
             "Which rays (1 when left out)");
  add_whole(numerics, "--threads", to.threads, 0, max_threads,
            "Threads; 0, as when left out: as many as the machine runs at once");
  add_file(numerics, "--state", to.state, "FILE",
           "Keep what is done here, and go on from it (--full: raywalk-numerics.state)");
  numerics.footer(
      "Prints a table: missed and false decisions, self-hits, near sheets missed, answers that had to be the same\n"
      "bits and differ, the worst error of t in ulps in the exact tier and in the fast one (there also divided by the\n"
      "condition number kappa), and the share of rays that needed exact arithmetic. Exits with 1 when a goal is "
      "broken.\n\n"
      "Examples:\n"
      "  raywalk check numerics sphere\n"
      "  raywalk check numerics --full --threads 4");
  numerics.callback([options, &run] { run = [options] { return check_numerics_command(*options); }; });
}

}  // namespace raywalk
