#include "app/check_command.h"

#if RAYWALK_CHECK
#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "check/suite.h"
#include "io/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#endif

namespace raywalk {

#if RAYWALK_CHECK

namespace {

/// Goal A's count, and a hundredth of it.
constexpr std::uint64_t full_rays = 100'000'000, usual_rays = 1'000'000;
constexpr const char* usual_state = "raywalk-numerics.state";

/// The families of these names, in the table's order; all where there is no name.
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
  suite.rays = options.rays > 0 ? static_cast<std::uint64_t>(options.rays) : options.full ? full_rays : usual_rays;
  suite.seed = options.seed;
  suite.threads = options.threads;
  suite.state = options.state.empty() && options.full ? usual_state : options.state;
  const Interrupt interrupt(Patience::brief);
  suite.stop = interrupt.stop();
  Result<check::SuiteResult> result;
  {
    ProgressBar bar;
    suite.progress = [&bar](double done, double seconds_left) {
      Progress progress{};
      progress.done = done;
      progress.seconds_left = seconds_left;
      bar.show(progress);
    };
    result = check::run_suite(*families, suite);
    interrupt.heeded();
  }
  if (!result) return fail(result.error());
  if (const auto printed = print(check::table_text(*families, *result)); !printed) return fail(printed.error());
  if (!result->finished)
    return fail({"", 0, 0, "interrupted; the table is of what was done",
                 suite.state.empty() ? "with --state FILE, a run goes on where it was stopped"
                                     : "the same command goes on from here, by " + suite.state});
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

}  // namespace raywalk
