#include "view/export/lesson_script.h"

#include "lesson/script.h"
#include "text/markup.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// The role of a passage for the presenter.
enum class Role { screen, say, ask, answer, teacher, change };

std::string_view name_of(Role role) {
  switch (role) {
    case Role::screen:
      return "lesson.script_screen";
    case Role::say:
      return "lesson.script_say";
    case Role::ask:
      return "lesson.script_ask";
    case Role::answer:
      return "lesson.reveal";
    case Role::teacher:
      return "lesson.teacher";
    case Role::change:
      return "lesson.change";
  }
  return {};
}

struct ScriptLine {
  Role role;
  std::string text;  ///< as in a passage: paragraphs, list items begin with "- "
};
struct ScriptStep {
  std::string heading, time;
  std::vector<ScriptLine> lines;  ///< none is empty
};

std::vector<ScriptStep> steps_of(const PlayedLesson& played, const LessonWords& words, Language language) {
  std::vector<ScriptStep> steps;
  for (std::size_t i = 0; i < played.steps.size(); ++i) {
    const PlayedStep& step = played.steps[i];
    const StepWords* said = words.find(step.step->id);
    if (said == nullptr) continue;
    const auto filled_at = [&](const Passage& passage, int position) {
      return filled(played, i, position, passage, language).value_or(passage.text);
    };
    const ScriptTime time = script_time(*played.lesson, words, i);
    const ScriptParts script = parts_of_script(filled_at(said->presenter, step.shown));
    ScriptStep written{with_quotes(said->heading, language),
                       step.step->extra ? std::string(text("lesson.extra", language))
                                        : minutes_text(time.begin) + "\u2013" + minutes_text(time.end),
                       {{Role::screen, filled_at(said->text, step.asked)},
                        {Role::say, script.before},
                        {Role::ask, step.step->question ? question_with_answer(played, i, *said, language) : ""},
                        {Role::answer, filled_at(said->reveal, step.shown)},
                        {Role::say, script.after},
                        {Role::teacher, filled_at(said->teacher, step.shown)},
                        {Role::change, filled_at(said->change, step.shown)}}};
    std::erase_if(written.lines, [](const ScriptLine& line) { return line.text.empty(); });
    steps.push_back(std::move(written));
  }
  return steps;
}

/// Words with `code` in backquotes and *emphasis* as HTML. An asterisk between blanks, or alone, stays.
std::string inline_html(std::string_view text) {
  const std::string words = escaped(text);
  std::string html;
  for (std::size_t at = 0; at < words.size();) {
    const char sign = words[at];
    const bool is_code = sign == '`', opens = is_code || (sign == '*' && words.substr(at + 1, 1) != " ");
    const std::size_t close = opens ? words.find(sign, at + 1) : std::string::npos;
    if (close == std::string::npos) {
      html += words[at++];
      continue;
    }
    html += fmt::format("<{0}>{1}</{0}>", is_code ? "code" : "em", words.substr(at + 1, close - at - 1));
    at = close + 1;
  }
  return html;
}

/// Where the words of a list item ("- word" or "2. word") begin, or 0.
std::size_t item_at(std::string_view line) {
  if (line.starts_with("- ")) return 2;
  return line.size() > 3 && line[0] >= '1' && line[0] <= '9' && line.substr(1, 2) == ". " ? 3 : 0;
}

std::string passage_html(std::string_view passage) {
  std::string html;
  std::string_view list;  // the tag of the current list
  while (!passage.empty()) {
    const std::size_t end = std::min(passage.find('\n'), passage.size());
    const std::string_view line = passage.substr(0, end);
    passage.remove_prefix(std::min(end + 1, passage.size()));
    const std::size_t item = item_at(line);
    const std::string_view wanted = item == 0 ? "" : line[0] == '-' ? "ul" : "ol";
    if (wanted != list && !list.empty()) html += fmt::format("</{}>", list);
    if (wanted != list && !wanted.empty()) html += fmt::format("<{}>", wanted);
    list = wanted;
    if (item > 0)
      html += "<li>" + inline_html(line.substr(item)) + "</li>";
    else if (!line.empty())
      html += "<p>" + inline_html(line) + "</p>";
  }
  return html + (list.empty() ? "" : fmt::format("</{}>", list));
}

std::string markdown(const LessonWords& words, const std::vector<ScriptStep>& steps, Language language) {
  std::string all = "# " + words.title + "\n\n" + words.summary.text + "\n\n" +
                    std::string(text("lesson.script_keys", language)) + "\n";
  for (std::size_t i = 0; i < steps.size(); ++i) {
    all += fmt::format("\n## {}. {} ({})\n", i + 1, steps[i].heading, steps[i].time);
    for (const ScriptLine& line : steps[i].lines)
      all += fmt::format("\n**{}**\n\n{}\n", text(name_of(line.role), language), line.text);
  }
  for (const auto& [name, passage] : {std::pair{"lesson.teacher", words.teacher}, {"lesson.sources", words.sources}})
    if (!passage.empty()) all += fmt::format("\n## {}\n\n{}\n", text(name, language), passage.text);
  return all;
}

// Spoken words are largest: they are read at arm's length. Printed steps are not broken over pages.
constexpr std::string_view script_style = R"(
body{max-width:46rem;margin:1.5rem auto;padding:0 1rem;color:#111;background:#fff;
font:17px/1.45 Inter,Helvetica,Arial,sans-serif}
h1{font-size:1.6rem;margin:0 0 .3rem}h2{font-size:1.2rem;margin:0;display:flex;justify-content:space-between;gap:1rem}
time,.keys,.summary{color:#555;font-weight:normal}time{white-space:nowrap;font-size:1rem}
section{border-top:2px solid #111;margin-top:1.4rem;padding-top:.6rem;break-inside:avoid}
div{display:grid;grid-template-columns:7.5rem 1fr;gap:0 1rem;margin-top:.5rem}
h3{font-size:.8rem;margin:.3rem 0;color:#555;text-transform:uppercase;letter-spacing:.03em}
p,ul,ol{margin:.15rem 0}ul,ol{padding-left:1.4rem}code{font-family:'JetBrains Mono',Menlo,Consolas,monospace;font-size:.9em}
.say{font-size:1.15rem}.ask{font-weight:600}.screen,.teacher,.change{color:#444}
@media(max-width:34rem){div{grid-template-columns:1fr}h2{display:block}}
@media print{body{margin:0;font-size:12px}}
)";

constexpr const char* class_of(Role role) {
  switch (role) {
    case Role::screen:
      return "screen";
    case Role::say:
      return "say";
    case Role::ask:
      return "ask";
    case Role::answer:
      return "answer";
    case Role::teacher:
      return "teacher";
    case Role::change:
      return "change";
  }
  return "";
}

std::string page(const LessonWords& words, const std::vector<ScriptStep>& steps, Language language) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n<style>{}</style>"
      "</head>\n<body><h1>{}</h1>\n<p class=\"summary\">{}</p>\n<p class=\"keys\">{}</p>\n",
      language.code(), escaped(words.title), script_style, escaped(words.title), inline_html(words.summary.text),
      inline_html(text("lesson.script_keys", language)));
  const auto row = [&](const char* kind, std::string_view name, const std::string& passage) {
    return fmt::format("<div class=\"{}\"><h3>{}</h3><span>{}</span></div>\n", kind, escaped(text(name, language)),
                       passage_html(passage));
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    html += fmt::format("<section><h2>{}. {}<time>{}</time></h2>\n", i + 1, escaped(steps[i].heading), steps[i].time);
    for (const ScriptLine& line : steps[i].lines) html += row(class_of(line.role), name_of(line.role), line.text);
    html += "</section>\n";
  }
  html += "<section>" + row("teacher", "lesson.teacher", words.teacher.text) +
          row("teacher", "lesson.sources", words.sources.text) + "</section>\n";
  return html + "</body></html>\n";
}

}  // namespace

std::string lesson_script(const PlayedLesson& played, Language language, ScriptForm form) {
  const Language told_in = played.lesson->told_in(language);
  LessonWords words = played.lesson->told(language);
  for (Passage* const passage : {&words.summary, &words.teacher, &words.sources})
    passage->text = with_quotes(passage->text, told_in);
  if (told_in != language)
    words.summary.text =
        fill("lesson.in_english", language, {{"language", language.name()}}) + "\n\n" + words.summary.text;
  const std::vector<ScriptStep> steps = steps_of(played, words, told_in);
  return form == ScriptForm::page ? page(words, steps, told_in) : markdown(words, steps, told_in);
}

}  // namespace raywalk
