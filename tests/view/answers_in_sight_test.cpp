// Nothing on the screen tells the answer of a lesson's question before it is given: no number, no name of a choice, and
// no sentence with the words that the right choice alone has.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "lesson_state.h"
#include "scene/names.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/band/band.h"
#include "view/legend/legend.h"
#include "view/microscope/microscope.h"
#include "view/outline.h"
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

void note_down_all(std::vector<Said>& said, const std::vector<OutlineItem>& items) {
  for (const OutlineItem& item : items) {
    note_down(said, "outline", item.name);
    note_down(said, "outline", item.value);
    note_down_all(said, item.items);
  }
}

/// What is read out to whoever cannot see the window, and not said already: all but the lesson, the code, which is the
/// same in every step, and what offers whatever there is, all alike: the things of the plan, and what can be chosen.
void note_down_outline(std::vector<Said>& said, const State& state) {
  constexpr std::array<std::string_view, 6> elsewhere{"lesson",      "code",       "plan",
                                                      "breakpoints", "cost-knobs", "image-settings"};
  std::vector<Said> read_out;
  for (const OutlineItem& region : outline(state))
    if (std::find(elsewhere.begin(), elsewhere.end(), region.key) == elsewhere.end())
      note_down_all(read_out, region.items);
  for (Said& each : read_out)
    if (std::none_of(said.begin(), said.end(), [&](const Said& before) { return before.text == each.text; }))
      said.push_back(std::move(each));
}

std::vector<std::string> legend_texts(const State& state) {
  std::vector<std::string> texts;
  const Legend signs = legend(state);
  for (const LegendRow& row : signs.rays) texts.push_back(row.name + ": " + row.meaning);
  for (const LegendSign& sign : signs.signs) texts.push_back(sign.meaning);
  return texts;
}

/// What the legend says here and not at the walk's start: of all that can happen it tells nothing.
void note_down_legend(std::vector<Said>& said, State state) {
  const std::vector<std::string> now = legend_texts(state);
  state.walk.position = 0;
  const std::vector<std::string> before = legend_texts(state);
  for (const std::string& text : now)
    if (std::find(before.begin(), before.end(), text) == before.end()) note_down(said, "legend", text);
}

/// What the walk's panes say, whichever of them is open, and the tooltips.
std::vector<Said> said_by_panes(State state) {
  std::vector<Said> said;
  for (const DisplayItem& item : band_view(state, 1200, band_height, 1, -1))
    if (const auto* text = std::get_if<TextItem>(&item.shape)) note_down(said, "band", text->text);
  note_down_legend(said, state);
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
    std::string names;  // of all that is drawn
    for (const DisplayItem& item : plan) {
      if (const auto* text = std::get_if<TextItem>(&item.shape)) {
        note_down(said, "plan", text->text);
        names += text->text + ' ';
      }
      if (item.target.kind == TargetKind::ray) note_down(said, "tooltip", target_text(state, item.target));
    }
    note_down(said, "names", names);
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
  note_down_outline(said, state);
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

/// The words of a text in small letters, and its numbers. What is not ASCII is taken for a letter.
std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : in_lower(text) + ' ') {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

/// Whether two words say the same: "scatters" and "scattered".
bool alike(const std::string& a, const std::string& b) {
  if (std::isdigit(static_cast<unsigned char>(a[0])) != 0) return a == b;
  const auto common = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
  const auto longer = std::ssize(a.size() < b.size() ? b : a);
  return a == b || (common >= 4 && 10 * common >= 7 * longer);
}

bool has_alike(const std::vector<std::string>& words, const std::string& word) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& each) { return alike(each, word); });
}

/// The words that stand in a third of all lessons or more: they tell nothing.
std::set<std::string> everyday_words(Language language) {
  const std::string folder = RAYWALK_SOURCE_DIR "/lessons";
  std::map<std::string, std::size_t> lessons_with;
  const std::vector<std::string> names = lesson_names(folder);
  for (const std::string& name : names) {
    const std::vector<std::string> words =
        words_in(read_file(fmt::format("{}/{}/{}.md", folder, name, language.code()), 1 << 20).value());
    for (const std::string& word : std::set<std::string>(words.begin(), words.end())) ++lessons_with[word];
  }
  std::set<std::string> everyday;
  for (const auto& [word, count] : lessons_with)
    if (3 * count >= names.size()) everyday.insert(word);
  return everyday;
}

/// The sentences that state something, each by itself.
std::vector<std::string> sentences_in(const std::string& text) {
  std::vector<std::string> sentences;
  const std::string statements = without_questions(text);
  for (std::size_t begin = 0, at = 0; at < statements.size(); ++at) {
    const bool ends = at + 1 == statements.size() || statements[at] == '\n' ||
                      (std::strchr(".!:;", statements[at]) != nullptr && statements[at + 1] == ' ');
    if (ends) sentences.push_back(statements.substr(std::exchange(begin, at + 1), at + 1 - begin));
  }
  return sentences;
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
    {"02-ray-meets-sphere", "from-inside", "lesson", "started", "where the ray starts is given"},
    {"02-ray-meets-sphere", "from-inside", "lesson", "partida", "the same"},
    {"02-ray-meets-sphere", "grow", "equation", "7", "where EYE stands"},
    {"04-reflection", "meets", "tree", "the Solid Sphere", "what blocks the shadow ray, which is another ray"},
    {"04-reflection", "meets", "tree", "a esfera s\u00f3lida", "the same"},
    {"04-reflection", "meets", "tree", "la esfera s\u00f3lida", "the same"},
    {"04-reflection", "meets", "outline", "the Solid Sphere", "the same, read out"},
    {"04-reflection", "meets", "outline", "a esfera s\u00f3lida", "the same"},
    {"04-reflection", "meets", "outline", "la esfera s\u00f3lida", "the same"},
    {"04-reflection", "share", "stack", "9", "the number of the pixel"},
    {"04-reflection", "share", "tooltip", "9", "the number of the pixel"},
    {"06-when-does-it-end", "dark", "lesson", "threshold", "its value is given, to be compared with the share"},
    {"06-when-does-it-end", "dark", "lesson", "limiar", "the same"},
    {"06-when-does-it-end", "dark", "lesson", "umbral", "the same"},
    {"14-radiosity", "strings", "lesson", "cross", "what the four strings do is given"},
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
  /// Of each choice: its words that no other choice has.
  std::vector<std::vector<std::string>> own_words;
};

std::vector<std::vector<std::string>> own_words_of(const std::vector<std::vector<std::string>>& choices,
                                                   const std::set<std::string>& everyday) {
  constexpr std::size_t short_word = 4;  // in bytes; yes, no, sim
  std::vector<std::vector<std::string>> own(choices.size());
  for (std::size_t i = 0; i < choices.size(); ++i)
    for (const std::string& word : choices[i]) {
      if (everyday.contains(word) || (word.size() < short_word && std::isdigit(word[0]) == 0)) continue;
      bool elsewhere = false;
      for (std::size_t k = 0; k < choices.size(); ++k) elsewhere = elsewhere || (k != i && has_alike(choices[k], word));
      if (!elsewhere) own[i].push_back(word);
    }
  return own;
}

Asked asked_of(const State& state, const std::set<std::string>& everyday) {
  const LessonRoom& sitting = state.lessons;
  const PlayedStep& step = *sitting.at();
  Asked asked{step, *sitting.open->lesson.told(state.appearance.language).find(step.step->id), std::nullopt, -1, {}};
  const auto value = [&](const Expression& formula) {
    return value_at(sitting.open->played, static_cast<std::size_t>(sitting.step), step.shown, formula).value();
  };
  if (const auto* number = std::get_if<NumberQuestion>(&*step.step->question))
    asked.number = std::get<double>(value(number->answer.expression));
  if (const auto* choice = std::get_if<ChoiceQuestion>(&*step.step->question)) {
    std::vector<std::vector<std::string>> words;
    for (const LessonChoice& each : lesson_panel(state).choices) words.push_back(words_in(each.text));
    asked.own_words = own_words_of(words, everyday);
    for (std::size_t i = 0; i < choice->choices.size(); ++i)
      if (holds(value(choice->choices[i].expression))) asked.right = static_cast<int>(i);
  }
  return asked;
}

void look_for_number(const std::string& lesson, const State& state, const Asked& asked, const Said& said) {
  if (said.where == "outline" || said.where == "band" || said.where == "names") return;  // they count steps and pixels
  const auto& question = std::get<NumberQuestion>(*asked.step.step->question);
  for (const double number : numbers_in(said.text, state.appearance.language)) {
    if (std::abs(number - *asked.number) > question.tolerance + 1e-9) continue;
    if (is_coincidence(lesson, asked.step.step->id, said.where, fmt::format("{}", number))) continue;
    FAIL_CHECK(fmt::format("{} {} {}: {} shows {} (the answer is {}): {}", lesson, asked.step.step->id,
                           state.appearance.language.code(), said.where, number, *asked.number, said.text));
  }
}

/// Whether the right choice is named, and no other.
bool look_for_choice(const std::string& lesson, const State& state, const Asked& asked, const Said& said) {
  const auto& choices = std::get<ChoiceQuestion>(*asked.step.step->question).choices;
  const auto tells = [&](std::size_t i) {
    constexpr std::size_t short_word = 4;  // yes, no, sim: they stand in any text
    if (said.where == "lesson" && asked.words.choices[i].text.size() <= short_word) return false;
    if (said.where == "lesson") return holds_words(without_questions(said.text), asked.words.choices[i].text);
    if (said.where == "plan") return false;  // which has the names of all: they are looked at together
    const auto names = names_in(choices[i], asked.step.walk->document.scene, state.appearance.language);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return holds_words(said.text, name); });
  };
  const auto right = static_cast<std::size_t>(asked.right);
  if (!tells(right)) return false;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (i != right && tells(i)) return false;  // two of them are named: neither is told
  if (is_coincidence(lesson, asked.step.step->id, said.where, asked.words.choices[right].text)) return true;
  FAIL_CHECK(fmt::format("{} {} {}: {} tells \"{}\": {}", lesson, asked.step.step->id, state.appearance.language.code(),
                         said.where, asked.words.choices[right].text, said.text));
  return true;
}

/// No sentence has words of the right choice and none of the others.
void look_for_words(const std::string& lesson, const State& state, const Asked& asked, const Said& said) {
  if (said.where == "names" || said.where == "plan") return;  // which has the names of all
  for (const std::string& statement : sentences_in(said.text)) {
    const std::vector<std::string> words = words_in(statement);
    std::size_t choices = 0;
    std::string found;
    for (std::size_t i = 0; i < asked.own_words.size(); ++i) {
      const auto& own = asked.own_words[i];
      const auto met =
          std::find_if(own.begin(), own.end(), [&](const std::string& word) { return has_alike(words, word); });
      if (met == own.end()) continue;
      ++choices;
      if (static_cast<int>(i) == asked.right) found = *met;
    }
    if (choices != 1 || found.empty()) continue;
    if (is_coincidence(lesson, asked.step.step->id, said.where, found)) continue;
    FAIL_CHECK(fmt::format("{} {} {}: {} has \"{}\", a word of the right choice: {}", lesson, asked.step.step->id,
                           state.appearance.language.code(), said.where, found, statement));
  }
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
  std::map<std::string, std::set<std::string>> everyday;
  for (const Language language : test::all_languages())
    everyday[std::string(language.code())] = everyday_words(language);
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
        const Asked asked = asked_of(state, everyday[std::string(language.code())]);
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
          if (asked.right < 0) continue;
          if (!look_for_choice(entry.name, state, asked, each)) look_for_words(entry.name, state, asked, each);
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

TEST_CASE("the 3-D image waits for the answer where the question is about pictures that are not shown") {
  State state = raywalk::test::state_with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"13-whitted-to-path-tracing"});
  int held = 0;
  for (int step = 0; state.lessons.at() != nullptr; update(state, action::GoToLessonStep{++step})) {
    const bool about_pictures = !state.lessons.at()->step->pictures.empty();
    if (!image_tells_answer(state)) continue;
    ++held;
    CHECK(about_pictures);
    update(state, action::RevealLesson{});
    CHECK_FALSE(image_tells_answer(state));
  }
  CHECK(held >= 2);
  // What is asked about a picture that is shown stays in sight.
  update(state, action::OpenLesson{"11-noise"});
  update(state, action::GoToLessonStep{1});
  REQUIRE(state.lessons.at()->step->id == "four-times");
  CHECK_FALSE(image_tells_answer(state));
}

TEST_CASE("the 3-D image does not mark the pixel that a lesson asks about, unless the step shows the image") {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::GoToLessonStep{2});
  REQUIRE(state.lessons.at()->step->id == "between");
  CHECK(mark_tells_answer(state));
  update(state, action::SetMode{Mode::move});
  CHECK(mark_tells_answer(state));
  update(state, action::SetMode{Mode::trace});
  update(state, action::RevealLesson{});
  CHECK_FALSE(mark_tells_answer(state));
  update(state, action::GoToLessonStep{4});
  REQUIRE(state.lessons.at()->step->pane == LessonBeside::picture);
  CHECK_FALSE(mark_tells_answer(state));
}
