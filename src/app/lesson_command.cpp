#include "app/lesson_command.h"

#include "app/scene_lookup.h"
#include "app/texts.h"
#include "lesson/check.h"
#include "text/file.h"
#include "text/file_path.h"
#include "text/spelling.h"
#include "view/export/lesson_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace raywalk {

namespace {

std::string lessons_dir() { return data_dir() + "/lessons"; }

/// Lesson 5 is given as "5", "05" or by its folder; other lessons by the path of their folder.
Result<std::string> folder_of(const std::string& name, const std::vector<std::string>& known) {
  const std::string padded = name.size() == 1 ? "0" + name : name;
  for (const std::string& each : known)
    if (each == name || each.starts_with(padded + "-")) return lessons_dir() + "/" + each;
  std::error_code failed;
  if (std::filesystem::is_regular_file(name, failed))
    return tl::unexpected(Error{name, 0, 0, "this is a file (expected the folder of a lesson)",
                                "name the folder in which lesson.toml stands"});
  if (name.find('/') != std::string::npos || std::filesystem::is_directory(name, failed)) return name;
  const std::string meant = nearest_word(name, {known.begin(), known.end()});
  return tl::unexpected(Error{"", 0, 0,
                              fmt::format("raywalk lesson: there is no lesson \"{}\" (expected {}, or a folder)", name,
                                          one_of({known.begin(), known.end()})),
                              meant.empty() ? "raywalk lesson list names them" : "did you mean " + meant + "?"});
}

std::string list_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    const auto lesson = read_lesson(lessons_dir() + "/" + name);
    std::string titles = lesson ? "" : "(cannot be read: raywalk lesson check " + name + " says why)";
    if (lesson)
      for (const auto& [code, words] : lesson->words) titles += (titles.empty() ? "" : " | ") + words.title;
    text += fmt::format("{:<28}{}\n", name, titles);
  }
  return text;
}

/// "; not in es": interface languages in which a lesson falls back to English.
std::string not_told(const Lesson& lesson) {
  std::string codes;
  for (const Language language : texts().languages->all())
    if (lesson.told_in(language) != language)
      codes += (codes.empty() ? "; not in " : ", ") + std::string(language.code());
  return codes;
}

std::string counted(std::size_t count, const std::string& one, const std::string& other = {}) {
  return fmt::format("{} {}", count, count == 1 ? one : !other.empty() ? other : one + "s");
}

std::string summary_of(const Lesson& lesson) {
  std::size_t questions = 0, claims = 0;
  const auto count = [&](const std::vector<Saying>& says) {
    for (const Saying& saying : says) claims += saying.claims.size();
  };
  count(lesson.says);
  for (const LessonStep& step : lesson.steps) {
    questions += step.question ? 1U : 0U;
    claims += step.checks.size();
    count(step.says);
  }
  return fmt::format("{:<28}{}, {}, {}, in {}{}\n", lesson.name, counted(lesson.steps.size(), "step"),
                     counted(questions, "prediction"), counted(claims, "claim holds", "claims hold"),
                     counted(lesson.words.size(), "language"), not_told(lesson));
}

bool is_page(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".html" || ending == ".htm";
}

/// How far the numbers that depend on random ones spread.
std::string spreads_of(const LessonCheck& found, int seeds) {
  std::string text;
  for (const SeedRange& spread : found.spreads) {
    const std::string theory = spread.theory ? fmt::format("; by theory {:.4g}", *spread.theory) : "";
    text += fmt::format("  {}: {} is {:.4g} to {:.4g} with {} seeds{}\n", spread.step, spread.formula, spread.least,
                        spread.most, seeds + 1, theory);
  }
  return text;
}

/// Which texts of the interface each language lacks, which then appear in English, and which are unused.
std::string texts_report() {
  std::string report;
  const auto list = [&](Language language, const std::vector<std::string>& ids, const std::string& what) {
    if (ids.empty()) return;
    report += fmt::format("{}.toml: {} {}:\n", language.code(), ids.size(), what);
    for (const std::string& id : ids) report += "  " + id + "\n";
  };
  for (const Language language : texts().languages->all()) {
    list(language, language.catalogue().missing(), "texts are missing and said in English");
    list(language, language.catalogue().unknown(), "texts have ids that nothing asks for");
  }
  return report;
}

}  // namespace

ExitCode lesson_list_command() {
  const auto names = lesson_names(lessons_dir());
  if (names.empty())
    return fail({lessons_dir(), 0, 0, "there are no lessons here (expected folders with a lesson.toml)", ""});
  const auto printed = print(list_text(names));
  return printed ? ExitCode::done : fail(printed.error());
}

ExitCode lesson_check_command(const std::vector<std::string>& names, int seeds) {
  const auto known = lesson_names(lessons_dir());
  std::vector<std::string> folders;
  for (const std::string& name : names.empty() ? known : names) {
    const auto folder = folder_of(name, known);
    if (!folder) return refuse(folder.error());
    folders.push_back(*folder);
  }
  if (folders.empty())
    return fail({lessons_dir(), 0, 0, "there are no lessons here (expected folders with a lesson.toml)", ""});
  std::size_t wrong = 0, unread = 0;
  for (const std::string& folder : folders) {
    const auto lesson = read_lesson(folder);
    const LessonCheck found = lesson ? check_lesson(*lesson, {data_dir() + "/scenes", lessons_dir() + "/words", seeds})
                                     : LessonCheck{{lesson.error()}, {}};
    for (const Error& error : found.errors) fail(error);
    unread += lesson ? 0U : 1U;
    wrong += lesson && !found.errors.empty() ? 1U : 0U;
    const auto printed = print((found.errors.empty() ? summary_of(*lesson) : "") + spreads_of(found, seeds));
    if (!printed) return fail(printed.error());
  }
  if (const auto printed = print(texts_report()); !printed) return fail(printed.error());
  for (const Error& error : texts().broken) fail(error);
  if (wrong + unread == 0) return texts().broken.empty() ? ExitCode::done : ExitCode::failed;
  std::string what = wrong > 0 ? fmt::format("{} of {} lessons say what is not so", wrong, folders.size()) : "";
  if (unread > 0)
    what += fmt::format("{}{} of {} lessons cannot be read", wrong > 0 ? "; " : "", unread, folders.size());
  return fail({"", 0, 0, what, "lessons/README.md explains how a lesson is written"});
}

ExitCode lesson_script_command(const std::string& name, Language language, const std::optional<std::string>& path) {
  const auto folder = folder_of(name, lesson_names(lessons_dir()));
  if (!folder) return refuse(folder.error());
  const auto lesson = read_lesson(*folder);
  if (!lesson) return fail(lesson.error());
  if (path)
    if (const auto claimed = claim_output(*path); !claimed) return fail(claimed.error());
  const PlayedLesson played = play_lesson(*lesson, data_dir() + "/scenes");
  if (!played.errors.empty()) return fail(played.errors.front());
  if (const auto claims = detail::check_claims(played); !claims.empty()) return fail(claims.front());
  const bool page = path && is_page(*path);
  const std::string script = lesson_script(played, language, page ? ScriptForm::page : ScriptForm::markdown);
  const auto written = path ? write_file_atomically(*path, script) : print(script);
  return written ? ExitCode::done : fail(written.error());
}

void declare_lesson(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("lesson", "List the lessons, or play them all and check what they claim");
  command.require_subcommand(1);
  command.footer("Examples:\n  raywalk lesson list\n  raywalk lesson check 5");
  CLI::App& list = *command.add_subcommand("list", "Name the lessons");
  list.footer("Example:\n  raywalk lesson list");
  list.callback([&run] { run = [] { return lesson_list_command(); }; });
  CLI::App& check = *command.add_subcommand("check", "Play lessons without a window, in every language");
  const auto names = std::make_shared<std::vector<std::string>>();
  check.add_option("NAME", *names, "Lessons, such as 5 or 05-refraction, or folders; left out: all")->type_name("");
  const auto seeds = std::make_shared<int>(LessonCheckSettings{}.seeds);
  add_whole(
      check, "--seeds", *seeds, 0, 1000,
      fmt::format("With how many other random numbers claims have to hold too, where some are drawn ({} when left out)",
                  *seeds));
  check.footer(
      "A lesson fails on a step that cannot be reached, a claim that the trace does not bear out, a text that is\n"
      "missing in a language, a number in a text that nothing checks, and words such as \"half\" or \"twice\" that no\n"
      "claim bears out. Exits with 1 when one fails.\n"
      "Below the lessons stands what each language of the window lacks.\n\n"
      "Examples:\n"
      "  raywalk lesson check\n"
      "  raywalk lesson check 5\n"
      "  raywalk lesson check my/lesson");
  CLI::App& script = *command.add_subcommand("script", "Write out a lesson for its presenter, to be printed");
  const auto name = std::make_shared<std::string>();
  const auto language = std::make_shared<std::optional<Language>>();
  script.add_option("NAME", *name, "A lesson, such as 5 or 05-refraction, or a folder")->required()->type_name("");
  add_language(script, *language, "Of the script; left out: en");
  const auto path = std::make_shared<std::optional<std::string>>();
  const auto ending = [](const std::string& file) {
    // /dev/stdout has none.
    if (const std::string is = ending_of(file); is.empty() || is == ".md" || is_page(file)) return std::string();
    return file + ": no script is written as \"" + ending_of(file) + "\" (expected .html or .md)";
  };
  add_file(script, "-o,--output", *path, "FILE",
           "The file: .html, a page to print or to read on a telephone, or .md; left out: printed here",
           to_standard_output)
      ->check(CLI::Validator(ending, "", "ending"));
  script.footer(
      "The script holds what stands on the screen, what to say and to ask, the answers, and when each step begins.\n\n"
      "Examples:\n"
      "  raywalk lesson script 5 -o refraction.html\n"
      "  raywalk lesson script 5 --language pt");
  script.callback([name, language, path, &run] {
    run = [name, language, path] {
      warn_of_broken_texts();
      return lesson_script_command(*name, language->value_or(texts().languages->english()), *path);
    };
  });
  check.callback([names, seeds, &run] { run = [names, seeds] { return lesson_check_command(*names, *seeds); }; });
}

}  // namespace raywalk
