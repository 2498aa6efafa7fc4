#include "study/study.h"

#include "render/parallel.h"
#include "text/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

namespace raywalk::study {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The heading that a folder's table must have to be continued.
std::string heading_of(const Experiment& experiment, const StudyOptions& options) {
  return fmt::format("# raywalk study {}: {}\n# effort {}, {} rounds\n# {}\n", experiment.name, experiment.title,
                     effort_name(options.effort), experiment.rounds, options.machine);
}

std::string table_path(const Experiment& experiment, const StudyOptions& options) {
  const std::string part =
      options.share ? fmt::format(".part-{}-of-{}", options.share->part, options.share->of) : std::string();
  return (fs::path(options.folder) / (experiment.name + part + ".csv")).string();
}

bool is_wanted(int round, const StudyOptions& options) {
  return !options.share || round % options.share->of == options.share->part - 1;
}

/// The tables of an experiment's parts that lie in the folder, in any order.
std::vector<std::string> part_tables(const Experiment& experiment, const StudyOptions& options) {
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(options.folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(experiment.name + ".part-", 0) == 0 && entry.path().extension() == ".csv")
      paths.push_back(entry.path().string());
  }
  return paths;
}

/// Of each wanted round that some table has, the trials.
std::vector<Trial> kept_trials(const Experiment& experiment, const StudyOptions& options) {
  std::vector<std::string> tables{table_path(experiment, options)};
  if (!options.share)
    for (std::string& path : part_tables(experiment, options)) tables.push_back(std::move(path));
  std::vector<Trial> kept;
  std::set<int> rounds;
  for (const std::string& path : tables) {
    constexpr std::size_t max_bytes = std::size_t{256} << 20;
    const auto csv = read_file(path, max_bytes);
    if (!csv) continue;
    std::set<int> here;
    for (Trial& trial : trials_of(*csv, experiment.columns, heading_of(experiment, options))) {
      if (!is_wanted(trial.round, options) || rounds.count(trial.round) > 0) continue;
      here.insert(trial.round);
      kept.push_back(std::move(trial));
    }
    rounds.merge(here);
  }
  return kept;
}

std::string figure_path(const Experiment& experiment, int number, const StudyOptions& options) {
  return (fs::path(options.folder) / fmt::format("{}-{}.svg", experiment.name, number)).string();
}

Result<void> keep(const Experiment& experiment, const StudyOptions& options, std::vector<Trial>& trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.round < b.round; });
  return write_file_atomically(table_path(experiment, options),
                               csv_of(trials, experiment.columns, heading_of(experiment, options)));
}

/// Refuses to replace a file that no study wrote: `mark` is near the beginning of those that did.
Result<void> check_own(const std::string& path, std::string_view mark) {
  std::ifstream file(path, std::ios::binary);
  std::string head(1024, '\0');
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())))
    head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty() || head.find(mark) != std::string::npos) return {};
  return tl::unexpected(Error{path, 0, 0, "this is not a file of a study (expected one that can be replaced)",
                              "choose another folder with -o"});
}

/// Reports the progress of all experiments, each weighted by its relative duration.
class StudyProgress {
 public:
  StudyProgress(const std::vector<Experiment>& experiments, const StudyOptions& options) : options_(options) {
    for (const Experiment& e : experiments) all_ += e.weight;
  }
  void skip(double weight) { done_ += weight, skipped_ += weight; }
  void add(const std::string& name, double weight) {
    done_ += weight;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count(), worked = done_ - skipped_;
    if (options_.progress) options_.progress(name, done_ / all_, worked > 0 ? seconds * (all_ - done_) / worked : 0);
  }

 private:
  const StudyOptions& options_;
  Clock::time_point start_ = Clock::now();
  double all_ = 0, done_ = 0, skipped_ = 0;
};

/// All trials, or fewer when stopped.
Result<std::vector<Trial>> measured(const Experiment& experiment, const StudyOptions& options, StudyProgress& clock) {
  const Stop& stop = options.stop;
  std::vector<Trial> trials = kept_trials(experiment, options);
  std::set<int> done;
  for (const Trial& trial : trials) done.insert(trial.round);
  std::vector<int> left;
  std::size_t wanted = 0;
  for (int round = 0; round < experiment.rounds; ++round) {
    if (!is_wanted(round, options)) continue;
    ++wanted;
    if (done.count(round) == 0) left.push_back(round);
  }
  const double weight = experiment.weight / static_cast<double>(std::max(wanted, std::size_t{1}));
  clock.skip(left.empty() ? experiment.weight : weight * static_cast<double>(done.size()));
  if (left.empty()) {
    // From parts: as one table.
    if (!options.share && !part_tables(experiment, options).empty())
      if (const auto kept = keep(experiment, options, trials); !kept) return tl::unexpected(kept.error());
    return trials;
  }
  // A round that is cut off is discarded below.
  const auto run = [&](int round) {
    try {
      return experiment.run(round, stop);
    } catch (const Stopped&) {
      return std::vector<Trial>();
    }
  };
  if (done.empty() && !stop.asked()) static_cast<void>(run(0));  // a warm-up round, discarded
  const std::size_t at_a_time = static_cast<std::size_t>(options.threads > 0 ? options.threads : hardware_threads());
  for (std::size_t from = 0; from < left.size() && !stop.asked(); from += at_a_time) {
    const std::size_t count = std::min(at_a_time, left.size() - from);
    std::vector<std::vector<Trial>> found(count);
    parallel_for(static_cast<int>(count), static_cast<int>(count), [&](int index) {
      const auto i = static_cast<std::size_t>(index);
      found[i] = run(left[from + i]);
    });
    if (stop.asked()) break;  // the unfinished round is discarded
    for (const std::vector<Trial>& round : found) trials.insert(trials.end(), round.begin(), round.end());
    if (const auto kept = keep(experiment, options, trials); !kept) return tl::unexpected(kept.error());
    clock.add(experiment.name, weight * static_cast<double>(count));
  }
  return trials;
}

bool is_complete(const std::vector<Trial>& trials, const Experiment& experiment, const StudyOptions& options) {
  std::set<int> done;
  for (const Trial& trial : trials) done.insert(trial.round);
  for (int round = 0; round < experiment.rounds; ++round)
    if (is_wanted(round, options) && done.count(round) == 0) return false;
  return true;
}

}  // namespace

std::string_view effort_name(Effort effort) {
  switch (effort) {
    case Effort::glance:
      return "glance";
    case Effort::quick:
      return "quick";
    case Effort::full:
      return "full";
  }
  return "";
}

std::string machine_text() {
  std::string processor = "processor unknown";
  constexpr std::size_t max_bytes = std::size_t{16} << 20;
  if (const auto info = read_file("/proc/cpuinfo", max_bytes)) {
    const std::size_t name = info->find("model name"), colon = info->find(": ", name), end = info->find('\n', name);
    if (name != std::string::npos && colon < end) processor = info->substr(colon + 2, end - colon - 2);
  }
#if defined(__clang__)
  const std::string compiler = fmt::format("clang {}", __clang_version__);
#else
  const std::string compiler = fmt::format("g++ {}", __VERSION__);
#endif
  return fmt::format("{}, {} threads, {}", processor, hardware_threads(), compiler);
}

int StudyResult::laws() const {
  int count = 0;
  for (const Concluded& c : concluded) count += static_cast<int>(c.verdicts.size());
  return count;
}

std::vector<std::string> StudyResult::broken() const {
  std::vector<std::string> names;
  for (const Concluded& c : concluded)
    for (std::size_t i = 0; i < c.verdicts.size(); ++i)
      if (!c.verdicts[i].holds) names.push_back(c.experiment.name + ": " + c.report.laws[i].name);
  return names;
}

Result<StudyResult> run_study(const std::vector<Experiment>& experiments, const StudyOptions& options) {
  if (const auto made = make_folder(options.folder); !made) return tl::unexpected(made.error());
  const auto page = (fs::path(options.folder) / "index.html").string();
  if (const auto own = check_own(page, page_title); !own) return tl::unexpected(own.error());
  for (const Experiment& experiment : experiments) {
    if (const auto own = check_own(table_path(experiment, options), "# raywalk study " + experiment.name); !own)
      return tl::unexpected(own.error());
    constexpr int most_figures = 9;
    constexpr std::string_view diagram = "' role='img'>\n<title>";  // as svg_of begins one
    for (int figure = 1; figure <= most_figures; ++figure)
      if (const auto own = check_own(figure_path(experiment, figure, options), diagram); !own)
        return tl::unexpected(own.error());
  }
  if (!options.share)
    if (const auto claimed = claim_output(page); !claimed) return tl::unexpected(claimed.error());
  for (const Experiment& experiment : experiments)
    if (const auto claimed = claim_output(table_path(experiment, options), OutputUse::kept); !claimed)
      return tl::unexpected(claimed.error());
  StudyResult result;
  StudyProgress clock(experiments, options);
  std::vector<Law> laws;
  for (const Experiment& experiment : experiments) {
    const auto trials = measured(experiment, options, clock);
    if (!trials) return tl::unexpected(trials.error());
    if (!is_complete(*trials, experiment, options)) {
      result.finished = false;
      return result;
    }
    if (options.share) continue;
    Concluded concluded{experiment, experiment.conclude(*trials), {}};
    for (std::size_t i = 0; i < concluded.report.figures.size(); ++i) {
      const auto written = write_file_atomically(figure_path(experiment, static_cast<int>(i) + 1, options),
                                                 svg_of(concluded.report.figures[i].plot));
      if (!written) return tl::unexpected(written.error());
    }
    laws.insert(laws.end(), concluded.report.laws.begin(), concluded.report.laws.end());
    result.concluded.push_back(std::move(concluded));
  }
  if (options.share) return result;
  const std::vector<Verdict> verdicts = judged(laws);
  std::size_t next = 0;
  for (Concluded& concluded : result.concluded)
    for (std::size_t i = 0; i < concluded.report.laws.size(); ++i) concluded.verdicts.push_back(verdicts[next++]);
  const auto written = write_file_atomically(page, page_of(result, options));
  if (!written) return tl::unexpected(written.error());
  return result;
}

}  // namespace raywalk::study
