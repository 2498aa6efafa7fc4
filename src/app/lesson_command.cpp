#include "app/lesson_command.h"

#include "app/scene_lookup.h"
#include "io/spelling.h"
#include "lesson/play.h"
#include "lesson/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace raywalk {

namespace {

std::string lessons_dir() { return data_dir() + "/lessons"; }

/// A person names lesson 5 as "5", "05" or by its folder; or gives the path of a lesson's folder of their own.
Result<std::string> folder_of(const std::string& name, const std::vector<std::string>& known) {
  const std::string padded = name.size() == 1 ? "0" + name : name;
  for (const std::string& each : known)
    if (each == name || each.starts_with(padded + "-")) return lessons_dir() + "/" + each;
  if (name.find('/') != std::string::npos) return name;
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
    for (const Language language : all_languages)
      if (lesson) titles += (titles.empty() ? "" : " | ") + lesson->words.find(language)->second.title;
    text += fmt::format("{:<28}{}\n", name, titles);
  }
  return text;
}

/// A lesson as its presenter reads it, with the numbers of the trace filled in: plain Markdown.
std::string script_text(const Lesson& lesson, const PlayedLesson& played, Language language) {
  const LessonWords& words = lesson.words.find(language)->second;
  std::string script = "# " + words.title + "\n\n" + words.summary.text + "\n";
  for (std::size_t i = 0; i < played.steps.size(); ++i) {
    const StepWords* said = words.find(lesson.steps[i].id);
    if (said == nullptr) continue;
    const auto said_at = [&](const Passage& passage, int position) {
      return filled(played, i, position, passage, language).value_or(passage.text);
    };
    const auto add = [&](const char* before, const std::string& what, const char* after) {
      if (!what.empty()) script += before + what + after;
    };
    const int asked = played.steps[i].asked, shown = played.steps[i].shown;
    const ScriptParts presenter = parts_of_script(said_at(said->presenter, shown));
    script += fmt::format("\n## {}. {}\n", i + 1, said->heading);
    add("\n", presenter.before, "\n");
    add("\n> ", said_at(said->question, asked), "\n");
    for (const Passage& choice : said->choices) add("> - ", said_at(choice, asked), "\n");
    add("\n", said_at(said->reveal, shown), "\n");
    add("\n", presenter.after, "\n");
    add("\n*", said_at(said->teacher, shown), "*\n");
  }
  if (!words.teacher.empty()) script += "\n---\n\n" + words.teacher.text + "\n";
  return script;
}

}  // namespace

ExitCode lesson_list_command() {
  const auto names = lesson_names(lessons_dir());
  if (names.empty())
    return fail({lessons_dir(), 0, 0, "there are no lessons here (expected folders with a lesson.toml)", ""});
  const auto printed = print(list_text(names));
  return printed ? ExitCode::done : fail(printed.error());
}

ExitCode lesson_check_command(const std::vector<std::string>& names) {
  const auto known = lesson_names(lessons_dir());
  std::vector<std::string> folders;
  for (const std::string& name : names.empty() ? known : names) {
    const auto folder = folder_of(name, known);
    if (!folder) return refuse(folder.error());
    folders.push_back(*folder);
  }
  if (folders.empty())
    return fail({lessons_dir(), 0, 0, "there are no lessons here (expected folders with a lesson.toml)", ""});
  std::size_t wrong = 0;
  for (const std::string& folder : folders) {
    const auto lesson = read_lesson(folder);
    const std::vector<Error> errors =
        lesson ? check_lesson(*lesson, data_dir() + "/scenes") : std::vector<Error>{lesson.error()};
    for (const Error& error : errors) fail(error);
    wrong += errors.empty() ? 0U : 1U;
    if (!errors.empty()) continue;
    std::size_t questions = 0, claims = 0;
    for (const LessonStep& step : lesson->steps) {
      questions += step.question ? 1U : 0U;
      claims += step.checks.size();
    }
    const auto printed =
        print(fmt::format("{:<28}{} steps, {} predictions, {} claims hold, in {} languages\n", lesson->name,
                          lesson->steps.size(), questions, claims, lesson->words.size()));
    if (!printed) return fail(printed.error());
  }
  if (wrong == 0) return ExitCode::done;
  return fail({"", 0, 0, fmt::format("{} of {} lessons say what is not so", wrong, folders.size()),
               "lessons/README.md explains how a lesson is written"});
}

ExitCode lesson_script_command(const std::string& name, Language language) {
  const auto folder = folder_of(name, lesson_names(lessons_dir()));
  if (!folder) return refuse(folder.error());
  const auto lesson = read_lesson(*folder);
  if (!lesson) return fail(lesson.error());
  const PlayedLesson played = play_lesson(*lesson, data_dir() + "/scenes");
  if (!played.errors.empty()) return fail(played.errors.front());
  const auto printed = print(script_text(*lesson, played, language));
  return printed ? ExitCode::done : fail(printed.error());
}

void declare_lesson(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("lesson", "List the lessons, or play them all and check what they claim");
  command.require_subcommand(1);
  CLI::App& list = *command.add_subcommand("list", "Name the lessons");
  list.callback([&run] { run = [] { return lesson_list_command(); }; });
  CLI::App& check = *command.add_subcommand("check", "Play lessons without a window, in every language");
  const auto names = std::make_shared<std::vector<std::string>>();
  check.add_option("NAME", *names, "Lessons, such as 5 or 05-refraction, or folders; left out: all")->type_name("");
  check.footer(
      "A lesson fails on a step that cannot be reached, a claim that the trace does not bear out, a text that is\n"
      "missing in a language, and a number in a text that nothing checks. Exits with 1 when one fails.\n\n"
      "Examples:\n"
      "  raywalk lesson check\n"
      "  raywalk lesson check 5\n"
      "  raywalk lesson check my/lesson");
  CLI::App& script = *command.add_subcommand("script", "Write out a lesson for its presenter, to be printed");
  const auto name = std::make_shared<std::string>();
  const auto language = std::make_shared<std::optional<Language>>();
  script.add_option("NAME", *name, "A lesson, such as 5 or 05-refraction, or a folder")->required()->type_name("");
  add_choice(script, "--language", *language, all_languages, language_code, "Of the script; left out: en");
  script.callback([name, language, &run] {
    run = [name, language] { return lesson_script_command(*name, language->value_or(Language::english)); };
  });
  check.callback([names, &run] { run = [names] { return lesson_check_command(*names); }; });
}

}  // namespace raywalk
