#include "app/study_command.h"

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

namespace raywalk {

namespace {

using study::Experiment;

/// By name or number: "samples", "e3".
Result<std::vector<Experiment>> chosen(const std::vector<std::string>& names, study::Effort effort) {
  std::vector<Experiment> all = study::all_experiments(effort);
  if (names.empty()) return all;
  const auto is_named = [](const Experiment& e, std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::string number = e.number;
    for (char& c : number) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word == e.name || word == number;
  };
  std::vector<std::string_view> known;
  for (const Experiment& e : all) known.push_back(e.name);
  for (const std::string& name : names) {
    if (std::any_of(all.begin(), all.end(), [&](const Experiment& e) { return is_named(e, name); })) continue;
    const std::string meant = nearest_word(name, known);
    return tl::unexpected(Error{"", 0, 0, "there is no experiment \"" + name + "\" (expected " + one_of(known) + ")",
                                meant.empty() ? "raywalk study --list names them all" : "did you mean " + meant + "?"});
  }
  std::vector<Experiment> some;
  for (Experiment& e : all)
    if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return is_named(e, name); }))
      some.push_back(std::move(e));
  return some;
}

std::string command_text(const StudyCommandOptions& options) {
  std::string text = "raywalk study";
  for (const std::string& name : options.names) text += " " + name;
  return text + " -o DIR" + (options.quick ? " --quick" : "");
}

std::string expected_text(const study::Law& law) {
  const std::string number = fmt::format("{:.4g}", shown(law, law.expected));
  if (law.kind == study::LawKind::at_most) return "<= " + number;
  if (law.kind == study::LawKind::at_least) return ">= " + number;
  return number;
}

std::string verdict_text(const study::StudyResult& result) {
  std::string text;
  for (const study::Concluded& c : result.concluded)
    for (std::size_t i = 0; i < c.verdicts.size(); ++i) {
      const study::Law& law = c.report.laws[i];
      const study::Verdict& v = c.verdicts[i];
      const std::string reach =
          law.kind == study::LawKind::exact
              ? std::string("exact")
              : fmt::format("{:.4g} to {:.4g}", shown(law, v.interval.low), shown(law, v.interval.high));
      text += fmt::format("{:<3} {:<13} {:<22} expected {:>10}  measured {:>9.4g}  {:<22} {}\n", c.experiment.number,
                          c.experiment.name, law.name, expected_text(law), shown(law, law.measured.value), reach,
                          v.holds ? "holds" : "DOES NOT HOLD");
    }
  return text;
}

}  // namespace

ExitCode study_command(const StudyCommandOptions& options) {
  const study::Effort effort = options.quick ? study::Effort::quick : study::Effort::full;
  const auto experiments = chosen(options.names, effort);
  if (!experiments) return refuse(experiments.error());
  if (options.list) {
    std::string names;
    for (const Experiment& e : *experiments) names += fmt::format("{:<14} {} {}\n", e.name, e.number, e.title);
    const auto printed = print(names);
    return printed ? ExitCode::done : fail(printed.error());
  }
  if (options.folder.empty())
    return refuse({"", 0, 0, "raywalk study: -o DIR is required", "name a folder for the results"});
  study::StudyOptions to{options.folder,        effort,
                         options.threads,       study::machine_text() + ", raywalk " RAYWALK_VERSION,
                         command_text(options), options.share};
  const Interrupt interrupt(
      Patience::brief, "interrupted; experiments that were finished are kept: the same command goes on from them\n");
  to.stop = interrupt.stop();
  Result<study::StudyResult> result;
  {
    ProgressBar bar;
    to.progress = [&bar](const std::string& /*experiment*/, double done, double seconds_left) {
      bar.show(done, seconds_left);
    };
    result = study::run_study(*experiments, to);
    interrupt.heeded();
  }
  if (!result) return fail(result.error());
  if (!result->finished)
    return fail({options.folder, 0, 0, "interrupted; the experiments that were finished are kept there",
                 "the same command goes on from them"});
  if (options.share) {
    const auto printed = print(fmt::format("part {} of {} is in {}; once all are there, {} makes the page of them\n",
                                           options.share->part, options.share->of, options.folder, to.command));
    return printed ? ExitCode::done : fail(printed.error());
  }
  const std::string page = (std::filesystem::path(options.folder) / "index.html").string();
  if (const auto printed = print(verdict_text(*result) + page + "\n"); !printed) return fail(printed.error());
  const std::vector<std::string> broken = result->broken();
  if (broken.empty()) return ExitCode::done;
  std::string names;
  for (const std::string& name : broken) names += (names.empty() ? "" : "; ") + name;
  return fail({"", 0, 0, fmt::format("{} of {} laws do not hold: {}", broken.size(), result->laws(), names),
               page + " explains each"});
}

void declare_study(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("study", "Measure what accuracy costs: tables, plots and a page");
  const auto options = std::make_shared<StudyCommandOptions>();
  StudyCommandOptions& to = *options;
  command.add_option("NAME", to.names, "Only these experiments, by name or number; left out: all")->type_name("");
  add_file(command, "-o,--output", to.folder, "DIR", "The folder for the results, made when it does not exist");
  command.add_flag("--quick", to.quick, "Fewer samples, in less time; intervals are wider");
  command.add_flag("--list", to.list, "Only name the experiments");
  constexpr int max_threads = 1024;
  add_whole(command, "--threads", to.threads, 0, max_threads,
            "Rounds at a time; 0, as when left out: as many as the machine runs at once");
  add_part(command, to.share, "Measure only this share of the rounds of each experiment, for a study on many machines");
  command.footer(
      "Writes for each experiment NAME.csv with every trial and NAME-1.svg and so on, and index.html, which explains\n"
      "them all and says of each expected law whether it holds. Seeds are fixed: all but the times is the same in "
      "each\n"
      "run. Exits with 1 when a law does not hold. Ctrl-C keeps what was measured, and the same command goes on.\n\n"
      "Machines of one kind can share the rounds and the folder: each measures its --part, and then the same command\n"
      "without it makes the page, and measures what is missing.\n\n"
      "Examples:\n"
      "  raywalk study -o study --quick\n"
      "  raywalk study samples e6 -o study\n"
      "  raywalk study -o study --part 3/7");
  command.callback([options, &run] { run = [options] { return study_command(*options); }; });
}

}  // namespace raywalk
