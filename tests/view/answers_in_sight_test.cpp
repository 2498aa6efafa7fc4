// Nothing on the screen tells the answer of a lesson's question before it is given.

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>

#include "lesson_state.h"
#include "scene/names.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/legend/legend.h"
#include "view/microscope/microscope.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/stack/stack_panel.h"
#include "view/structure/structure.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/code_panel.h"
#include "view/walk/equation.h"
#include "view/walk/status.h"

using namespace raywalk;

namespace {

constexpr std::array all_tabs{PictureRoom::tab,  TreeRoom::tab, StackRoom::tab,      LegendRoom::tab,
                              EquationRoom::tab, CostRoom::tab, MicroscopeRoom::tab, StructureRoom::tab};

/// Words on the screen, and where.
struct Said {
  std::string where, text;
};

void note_down(std::vector<Said>& said, const std::string& where, const std::string& text) {
  if (!text.empty()) said.push_back({where, text});
}

/// What the lesson's own pane says: to a student, and to a presenter with notes.
std::vector<Said> said_by_lesson(State state) {
  std::vector<Said> said;
  update(state, action::SetLessonOptions{true, true});
  const LessonPanel panel = lesson_panel(state);
  for (const std::string& text :
       {panel.heading, panel.summary, panel.text, panel.question, panel.marked, panel.presenter, panel.verdict,
        panel.reveal, panel.change, panel.teacher, panel.notes})
    note_down(said, "lesson", text);
  return said;
}

/// What the walk's panes say, whichever of them is open, and the tooltips.
std::vector<Said> said_by_panes(State state) {
  std::vector<Said> said;
  note_down(said, "sentence", sentence(state));
  for (const CodeBox& box : code_panel(state).boxes) note_down(said, "code", box.badge);
  for (const TreeNode& node : tree_panel(state).nodes) {
    note_down(said, "tree", node.label);
    note_down(said, "tree", node_text(state, node));
  }
  for (const StackRow& row : stack_panel(state).rows)
    for (const std::string& text : {row.ray, row.object, row.waiting}) note_down(said, "stack", text);
  for (const EquationRow& row : equation_panel(state).rows) note_down(said, "equation", row.text);
  Microscope microscope;
  if (const auto specimen = specimen_of(microscope, state)) {
    const MicroscopeTable table = microscope_table(state, *specimen);
    note_down(said, "microscope", table.title);
    note_down(said, "microscope", table.sentence);
    for (const MicroscopeTable::Row& row : table.rows) note_down(said, "microscope", row.robust);
  }
  for (const Tab tab : all_tabs) {
    update(state, action::SetTab{tab});
    const DisplayList plan = plan_view(state);
    for (const DisplayItem& item : plan) {
      if (const auto* text = std::get_if<TextItem>(&item.shape)) note_down(said, "plan", text->text);
      if (item.target.kind == TargetKind::ray) note_down(said, "tooltip", target_text(state, item.target));
    }
    if (tab != StructureRoom::tab) continue;
    // Every step that one can go to there.
    for (int step = 0; step <= structure_steps(state); ++step) {
      update(state, action::GoInStructure{step});
      const StructurePanel panel = structure_panel(state);
      for (const std::string& text : {panel.sentence, panel.so_far, panel.counter, panel.summary})
        note_down(said, "structure", text);
      for (const StructureRow& row : panel.rows)
        for (const std::string& number : row.numbers) note_down(said, "structure", number);
    }
  }
  return said;
}

/// The numbers of a text, as its language writes them.
std::vector<double> numbers_in(const std::string& text, Language language) {
  std::vector<double> numbers;
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!digit(at) || (at > 0 && (std::isalpha(static_cast<unsigned char>(text[at - 1])) != 0))) continue;
    std::string number;
    for (bool decimals = false; digit(at) || (!decimals && text[at] == language.decimal_mark() && digit(at + 1));
         ++at) {
      decimals = decimals || !digit(at);
      number += digit(at) ? text[at] : '.';
    }
    numbers.push_back(std::strtod(number.c_str(), nullptr));
  }
  return numbers;
}

std::string in_lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}
bool holds_words(const std::string& text, const std::string& words) {
  return !words.empty() && in_lower(text).find(in_lower(words)) != std::string::npos;
}

/// A text without its questions, which state nothing.
std::string without_questions(const std::string& text) {
  std::string kept;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(".!?\n", begin), text.size() - 1);
    if (text[end] != '?') kept += text.substr(begin, end + 1 - begin);
    begin = end + 1;
  }
  return kept;
}

/// The names in quotes of a choice's formula as the panes write them: objects, and how rays end.
std::vector<std::string> names_in(const Formula& formula, const Scene& scene, Language language) {
  std::vector<std::string> names;
  for (std::size_t at = formula.text.find('"'); at != std::string::npos; at = formula.text.find('"', at + 1)) {
    const std::size_t end = formula.text.find('"', at + 1);
    const std::string name = formula.text.substr(at + 1, end - at - 1);
    bool is_ending = false;
    for (int i = 0; i < ending_count; ++i)
      if (name_of(static_cast<Ending>(i)) == name) {
        names.emplace_back(text(static_cast<Ending>(i), language));
        is_ending = true;
      }
    const bool before_is = formula.text.substr(0, at).ends_with("object == ");
    if (!is_ending && before_is) names.push_back(shown_name(scene, name, language));
    at = end;
  }
  return names;
}

/// What was found on the screen, and why it tells no answer: numbers that are given for the answer to be thought out
/// of, and such as are something else.
struct Coincidence {
  std::string lesson, step, where, what;
  const char* why;
};
const std::vector<Coincidence> coincidences{
    {"02-ray-meets-sphere", "grow", "equation", "7", "where EYE stands"},
    {"04-reflection", "meets", "tree", "the Solid Sphere", "what blocks the shadow ray, which is another ray"},
    {"04-reflection", "meets", "tree", "a esfera s\u00f3lida", "the same"},
    {"04-reflection", "meets", "tree", "la esfera s\u00f3lida", "the same"},
    {"04-reflection", "share", "stack", "9", "the number of the pixel"},
    {"04-reflection", "share", "tooltip", "9", "the number of the pixel"},
    {"06-when-does-it-end", "dark", "lesson", "threshold", "its value is given, to be compared with the share"},
    {"06-when-does-it-end", "dark", "lesson", "limiar", "the same"},
    {"06-when-does-it-end", "dark", "lesson", "umbral", "the same"},
};

std::set<std::string> needed;  // of the list above

bool is_coincidence(const std::string& lesson, const std::string& step, const std::string& where,
                    const std::string& what) {
  for (const Coincidence& each : coincidences)
    if (each.lesson == lesson && each.step == step && each.where == where && what == each.what) {
      needed.insert(each.lesson + each.step + each.where + each.what);
      return true;
    }
  return false;
}

/// The question of the step that is open, with the answer that its trace has.
struct Asked {
  const PlayedStep& step;
  const StepWords& words;
  std::optional<double> number;
  int right = -1;  ///< of choices
};

Asked asked_of(const State& state) {
  const LessonRoom& sitting = state.lessons;
  const PlayedStep& step = *sitting.at();
  Asked asked{step, *sitting.open->lesson.told(state.appearance.language).find(step.step->id), std::nullopt};
  const auto value = [&](const Expression& formula) {
    return value_at(sitting.open->played, static_cast<std::size_t>(sitting.step), step.shown, formula).value();
  };
  if (const auto* number = std::get_if<NumberQuestion>(&*step.step->question))
    asked.number = std::get<double>(value(number->answer.expression));
  if (const auto* choice = std::get_if<ChoiceQuestion>(&*step.step->question))
    for (std::size_t i = 0; i < choice->choices.size(); ++i)
      if (holds(value(choice->choices[i].expression))) asked.right = static_cast<int>(i);
  return asked;
}

void look_for_number(const std::string& lesson, const State& state, const Asked& asked, const Said& said) {
  const auto& question = std::get<NumberQuestion>(*asked.step.step->question);
  for (const double number : numbers_in(said.text, state.appearance.language)) {
    if (std::abs(number - *asked.number) > question.tolerance + 1e-9) continue;
    if (is_coincidence(lesson, asked.step.step->id, said.where, fmt::format("{}", number))) continue;
    FAIL_CHECK(fmt::format("{} {} {}: {} shows {} (the answer is {}): {}", lesson, asked.step.step->id,
                           state.appearance.language.code(), said.where, number, *asked.number, said.text));
  }
}

void look_for_choice(const std::string& lesson, const State& state, const Asked& asked, const Said& said) {
  const auto& choices = std::get<ChoiceQuestion>(*asked.step.step->question).choices;
  const auto tells = [&](std::size_t i) {
    constexpr std::size_t short_word = 4;  // yes, no, sim: they stand in any text
    if (said.where == "lesson" && asked.words.choices[i].text.size() <= short_word) return false;
    if (said.where == "lesson") return holds_words(without_questions(said.text), asked.words.choices[i].text);
    if (said.where == "plan") return false;  // which has the names of all
    const auto names = names_in(choices[i], asked.step.walk->document.scene, state.appearance.language);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return holds_words(said.text, name); });
  };
  const auto right = static_cast<std::size_t>(asked.right);
  if (!tells(right)) return;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (i != right && tells(i)) return;  // two of them are named: neither is told
  if (is_coincidence(lesson, asked.step.step->id, said.where, asked.words.choices[right].text)) return;
  FAIL_CHECK(fmt::format("{} {} {}: {} tells \"{}\": {}", lesson, asked.step.step->id, state.appearance.language.code(),
                         said.where, asked.words.choices[right].text, said.text));
}

/// No line that leaves the place of the arrow points where it has to go.
void look_for_arrow(const std::string& lesson, State state, const Asked& asked) {
  const double tolerance = std::get<ArrowQuestion>(*asked.step.step->question).tolerance;
  const auto& formed = std::get<RayFormed>(asked.step.walk->timeline.event(asked.step.shown - 1).detail);
  const Vec2d truth(formed.direction.x, -formed.direction.y);
  for (const Tab tab : all_tabs) {
    update(state, action::SetTab{tab});
    const Vec2d origin = test::to_pixels(state, *arrow_origin(state));
    for (const DisplayItem& item : plan_view(state)) {
      const auto* line = std::get_if<LineItem>(&item.shape);
      if (line == nullptr || length(line->to - line->from) < 8) continue;
      const bool leaves = length(line->from - origin) < 3, comes = length(line->to - origin) < 3;
      const Vec2d along = leaves ? line->to - line->from : line->from - line->to;
      if ((leaves || comes) && degrees_between(along, truth) <= tolerance &&
          !is_coincidence(lesson, asked.step.step->id, "plan", "line"))
        FAIL_CHECK(fmt::format("{} {}: a line of the plan points where the arrow has to", lesson, asked.step.step->id));
    }
  }
}

void look_for_line(const std::string& lesson, const State& state, const Asked& asked, const std::vector<Said>& said) {
  const std::string& answer = std::get<LineQuestion>(*asked.step.step->question).answer;
  for (const Said& each : said)
    if (holds_words(each.text, answer))
      FAIL_CHECK(fmt::format("{} {}: {} names the line: {}", lesson, asked.step.step->id, each.where, each.text));
  for (const CodeBox& box : code_panel(state).boxes)
    for (const CodeRow& row : box.rows) CHECK(row.blame == Blame::none);
}

}  // namespace

TEST_CASE("no step shows its answer before it is given, in any language") {
  needed.clear();
  State state = test::state_with_lessons();
  for (const LessonEntry& entry : std::vector(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    REQUIRE(state.lessons.at() != nullptr);
    for (int step = 0; step < entry.steps; ++step) {
      update(state, action::GoToLessonStep{step});
      REQUIRE(state.lessons.step == step);
      if (!state.lessons.at()->step->question) continue;
      for (const Language language : test::all_languages()) {
        update(state, action::SetLanguage{std::string(language.code())});
        const Asked asked = asked_of(state);
        const LessonQuestion& question = *asked.step.step->question;
        CHECK(state.walk.position == asked.step.asked);
        std::vector<Said> said = said_by_lesson(state);
        const std::vector<Said> by_panes = said_by_panes(state);
        said.insert(said.end(), by_panes.begin(), by_panes.end());
        if (std::holds_alternative<LineQuestion>(question))
          look_for_line(entry.name, state, asked, said_by_lesson(state));
        if (std::holds_alternative<ArrowQuestion>(question)) look_for_arrow(entry.name, state, asked);
        for (const Said& each : said) {
          if (asked.number) look_for_number(entry.name, state, asked, each);
          if (asked.right >= 0) look_for_choice(entry.name, state, asked, each);
        }
      }
    }
    update(state, action::LeaveLesson{});
  }
  for (const Coincidence& each : coincidences) {
    INFO(each.lesson << " " << each.step << " " << each.where << ": " << each.what << " is not met any more");
    CHECK(needed.contains(each.lesson + each.step + each.where + each.what));
  }
}

TEST_CASE("a question about a picture has none beside it") {
  for (const std::string& name : lesson_names(RAYWALK_SOURCE_DIR "/lessons")) {
    const auto lesson = read_lesson(RAYWALK_SOURCE_DIR "/lessons/" + name);
    REQUIRE(lesson);
    LessonBeside beside = LessonBeside::picture;  // as the window opens
    for (const LessonStep& step : lesson->steps) {
      if (step.pane != LessonBeside::unchanged) beside = step.pane;
      const auto* choice = step.question ? std::get_if<ChoiceQuestion>(&*step.question) : nullptr;
      for (std::size_t i = 0; choice != nullptr && i < choice->choices.size(); ++i) {
        CAPTURE(name, step.id);
        // Whether two colours are equal to the last bit nobody can see.
        const std::string& formula = choice->choices[i].text;
        const bool of_picture =
            formula.find("pixel(") != std::string::npos && formula.find("shade") == std::string::npos;
        const bool of_pixel = step.pixel && formula.find("object") != std::string::npos;
        if (of_picture || of_pixel || formula.find("brightest(total)") != std::string::npos)
          CHECK(beside != LessonBeside::picture);
      }
    }
  }
}

TEST_CASE("while a lesson asks, no search is stepped through") {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{"10-fewer-tests"});
  while (state.lessons.at()->step->id != "inside") update(state, action::GoToLessonStep{state.lessons.step + 1});
  REQUIRE(shows_structure(state));
  CHECK(structure_steps(state) == 0);
  CHECK(structure_panel(state).rows.empty());
  update(state, action::GuessChoice{0});
  update(state, action::RevealLesson{});
  CHECK(structure_steps(state) > 0);
  CHECK(structure_panel(state).rows.size() == 5);
  const std::string reveal = lesson_panel(state).reveal;
  const std::vector<std::string> numbers = structure_panel(state).rows.front().numbers;  // nodes, tests, saved
  CHECK_THAT(reveal, test::contains("Against " + numbers[1]));
  CHECK_THAT(reveal, test::contains(numbers[0] + " node"));
}
