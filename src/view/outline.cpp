#include "view/outline.h"

#include "view/bugs/bug_panel.h"
#include "view/document/document.h"
#include "view/document/properties.h"
#include "view/document/question.h"
#include "view/ink/ink.h"
#include "view/lesson/lesson_panel.h"
#include "view/lesson/typed_number.h"
#include "view/link/link.h"
#include "view/outline_items.h"
#include "view/plan/plan_geometry.h"
#include "view/predict/predict.h"
#include "view/stack/stack_panel.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/asked.h"
#include "view/walk/code_panel.h"
#include "view/walk/equation.h"
#include "view/walk/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

using Role = OutlineItem::Role;

/// The parts of an outline, and how their items are made.
class Outliner {
 public:
  explicit Outliner(const State& state) : state_(state) {}

  [[nodiscard]] Outline take() && {
    leave_out_unsaid(regions_);
    return std::move(regions_);
  }

  void notice() {
    if (!state_.document.notice) return;
    const bool is_error = state_.document.notice->kind == Notice::Kind::error;
    regions_.push_back({is_error ? Role::warning : Role::news, "notice", state_.document.notice->text});
  }

  void question() {
    if (!state_.document.question) return;
    const QuestionPanel panel = question_panel(state_);
    OutlineItem& region = open("question", say("outline.asks"));
    add(region, Role::warning, "text", panel.text);
    for (const auto& [answer, label] : panel.choices)
      button(region, std::string(name_of(answer)), label, action::AnswerQuestion{answer});
  }

  void prompt() {
    const auto line = [&]() -> std::string {
      switch (state_.document.prompt) {
        case PathPrompt::none:
          return {};
        case PathPrompt::start:
        case PathPrompt::open:
          return "open {}";
        case PathPrompt::save_as:
          return "save-as {}";
        case PathPrompt::save_predictions:
          return "save-predictions {}";
        case PathPrompt::export_walk:
          return "export {}";
      }
      return {};
    }();
    if (line.empty() || state_.document.question) return;  // the dialog comes back after the question
    OutlineItem& region = open("prompt", say("outline.asks"));
    const bool opens = line == "open {}";
    field(region, Role::path, "path", say(opens ? "dialog.path_or_link" : "dialog.path"), line, offered_path(state_));
    region.items.back().hint = say(opens ? "command.open.label" : "command.save.label");
    if (opens) shipped(region);
    button(region, "cancel", say("answer.cancel"), action::CancelPrompt{});
  }

  /// What there is to open: in the window these are cards.
  void shipped(OutlineItem& region) {
    button(region, "new", say("scene.new_title"), action::New{});
    for (const std::string& name : shipped_names(state_)) {
      const std::string title = shipped_title(state_, name), *sentence = shipped_sentence(state_, name);
      button(region, name, sentence == nullptr ? title : title + ": " + *sentence,
             action::Open{shipped_path(state_, name)});
    }
  }

  void link() {
    if (!state_.link.shown) return;
    OutlineItem& region = open("link", say("link.title"));
    const std::string address = address_shown(state_);
    if (address.empty()) {
      add(region, Role::warning, "why", state_.link.why_not);
      button(region, "save", say("command.save_as.label"), action::AskSaveAs{});
    } else {
      add(region, Role::text, "address", address);
      field(region, Role::words, "page", say("link.page"), "link-page {}", state_.link.page);
      if (page_of_links(state_).empty()) add(region, Role::text, "no-page", say("link.no_page"));
      button(region, "copy", say("command.copy_link.label"), action::CopyLink{});
    }
    button(region, "close", say("dialog.close"), action::ShowLink{false});
  }

  void lesson() {
    if (!state_.lessons.shown) return;
    const LessonPanel panel = lesson_panel(state_);
    if (state_.lessons.at() == nullptr) return lessons(panel);
    OutlineItem& region = open("lesson", panel.lesson);
    add(region, Role::text, "step", fmt::format("{} / {}", panel.step, panel.steps));
    add(region, Role::news, "heading", panel.heading);
    paragraphs(region, "summary", panel.summary);
    paragraphs(region, "text", panel.text);
    ask(region, panel);
    if (!panel.verdict.empty())
      add(region, Role::news, "verdict", (panel.is_right ? "\u2713 " : "\u2717 ") + panel.verdict);
    paragraphs(region, "reveal", panel.reveal);
    if (!panel.change.empty()) paragraphs(region, "change", say("lesson.change") + ": " + panel.change);
    paragraphs(region, "presenter", panel.presenter);
    paragraphs(region, "teacher", panel.teacher);
    add(region, Role::text, "score", panel.unanswered.empty() ? panel.score : panel.unanswered);
    if (panel.asks == Asks::line) mend(region);
    if (panel.astray) button(region, "return", say("lesson.back_to_question"), action::GoToLessonStep{panel.step - 1});
    if (panel.asks != Asks::nothing && !state_.lessons.revealed) {
      button(region, "answer", say("lesson.reveal"), action::RevealLesson{}, panel.can_reveal);
    } else {
      button(region, "next", say(panel.is_last ? "lesson.finish" : "lesson.next"), action::GoToLessonStep{panel.step},
             panel.can_go_on);
    }
    button(region, "back", say("lesson.back"), action::GoToLessonStep{panel.step - 2}, panel.can_go_back);
    button(region, "leave", say("lesson.all_lessons"), action::LeaveLesson{});
  }

  void bugs() {
    if (!state_.bugs.shown) return;
    const BugPanel panel = bug_panel(state_);
    OutlineItem& region = open("bugs", panel.heading);
    add(region, Role::text, "tally", panel.tally);
    passages(region, "said", panel.said);
    if (!panel.verdict.empty())
      add(region, Role::news, "verdict", (panel.is_right ? "\u2713 " : "\u2717 ") + panel.verdict);
    passages(region, "learnt", panel.learnt);
    add(region, Role::news, "marked", panel.marked);
    for (const BugRow& row : panel.rows) {
      std::string name = say("bug.number", {{"number", row.number}});
      if (row.end == BugEnd::found) name += ": " + say("bug.found");
      if (row.end == BugEnd::given_up) name += ": " + say("bug.given_up");
      button(region, std::to_string(row.number), name, action::HuntBug{row.number});
    }
    if (panel.can_give_up) {
      button(region, "judge", say("bug.judge"), action::JudgeLine{}, panel.can_judge);
      button(region, "cure", say("bug.give_up"), action::ShowCure{});
    }
    mend(region);
    if (panel.hunting) button(region, "list", say("bug.all_bugs"), action::LeaveHunt{});
    button(region, "leave", say("bug.leave"), action::ShowBugs{false});
  }

  void walk() {
    OutlineItem& region = open("walk", say("menu.walk"));
    add(region, Role::news, "sentence", sentence(state_));
    add(region, Role::text, "status", status_line(state_));
    const bool own_question = state_.lessons.shown && is_open_question(state_.lessons);
    if (state_.predictions.on && !own_question) predictions(region);
    field(region, Role::number, "go-to", say("breakpoints.go_to_step"), "jump {}",
          std::to_string(state_.walk.position));
  }

  void code() {
    OutlineItem& region = open("code", say("outline.code"));
    const bool marks = asks_for_line(state_);
    int number = 0;
    for (const CodeBox& box : code_panel(state_).boxes) {
      OutlineItem& list = add(region, Role::list, std::to_string(++number),
                              box.badge.empty() ? box.title : box.title + ", " + box.badge);
      for (const CodeRow& row : box.rows) {
        std::string name = row.text;
        if (row.just_run) name += ", " + say("outline.has_run");
        if (row.next) name += ", " + say("outline.runs_next");
        if (row.breakpoint) name += ", " + say("outline.stops");
        const std::string key = std::to_string(static_cast<int>(row.line));
        OutlineItem& entry = add(list, Role::entry, key, name);
        entry.current = row.just_run;
        if (!marks) continue;
        button(entry, "mark", say("outline.mark", {{"line", row.text}}), action::MarkLine{row.line}).chosen =
            row.blame == Blame::marked;
      }
    }
  }

  void equation() {
    const EquationPanel panel = equation_panel(state_);
    if (panel.rows.empty()) return;
    OutlineItem& region = open("equation", say("command.tab_equation.label"), true);
    for (std::size_t i = 0; i < panel.rows.size(); ++i) {
      const EquationRow& row = panel.rows[i];
      std::string name = row.text;
      if (row.light) name += ": " + colour_text(*row.light, language());
      add(region, Role::text, std::to_string(i), name);
    }
  }

  void stack() {
    OutlineItem& region = open("stack", say("command.tab_stack.label"), true);
    const StackPanel panel = stack_panel(state_);
    if (panel.rows.empty()) return static_cast<void>(add(region, Role::text, "empty", panel.empty));
    OutlineItem& list = add(region, Role::list, "calls", region.name);
    for (std::size_t i = 0; i < panel.rows.size(); ++i) {
      const StackRow& row = panel.rows[i];
      std::string name = row.title;
      for (const std::string& more : {row.ray, row.object, row.waiting})
        if (!more.empty()) name += "; " + more;
      // The outermost call keeps its place.
      OutlineItem& entry = add(list, Role::entry, std::to_string(panel.rows.size() - i), name);
      entry.current = i == 0;
      for (std::size_t k = 0; k < row.returned.size(); ++k)
        add(entry, Role::text, std::to_string(k),
            row.returned[k].name + " = " + colour_text(row.returned[k].linear, language()));
    }
  }

  void tree() {
    OutlineItem& region = open("tree", say("command.tab_tree.label"), true);
    const TreePanel panel = tree_panel(state_);
    if (panel.nodes.empty()) return static_cast<void>(add(region, Role::text, "empty", say("tree.empty")));
    std::vector<std::vector<int>> rays_of(panel.nodes.size() + 1);
    for (std::size_t i = 0; i < panel.nodes.size(); ++i)
      if (!panel.nodes[i].future)
        rays_of[static_cast<std::size_t>(panel.nodes[i].parent + 1)].push_back(static_cast<int>(i));
    add_rays(add(region, Role::list, "rays", region.name), panel, rays_of, -1);
  }

  void plan() {
    OutlineItem& region = open("plan", say("plan.name"));
    OutlineItem& list = add(region, Role::list, "things", region.name);
    thing(list, {TargetKind::eye}, say("object.eye"));
    const Scene& scene = state_.scene();
    for (int i = 0; i < static_cast<int>(std::min(scene.lights.size(), most_outlined)); ++i) {
      const bool somewhere = middle_of(scene.lights[static_cast<std::size_t>(i)]).has_value();
      thing(list, {TargetKind::light, i}, light_name(state_, i), somewhere);
    }
    for (int i = 0; i < static_cast<int>(std::min(scene.objects.size(), most_outlined)); ++i)
      thing(list, {TargetKind::object, i}, object_name(state_, i));
    const std::size_t all = scene.lights.size() + scene.objects.size(), drawn = list.items.size() - 1;
    if (drawn < all) add(region, Role::text, "more", say("plan.objects_drawn", {{"drawn", drawn}, {"all", all}}));
  }

  void properties() {
    if (!shows_properties(state_)) return;
    outline_properties(state_, open("properties", properties_title(state_)));
  }

  /// The attempts of Cost, what each has cost, and how far off its picture is; or what each effect adds.
  void costs(const CostFindings& findings) {
    const CostRoom& cost = state_.cost;
    if (state_.appearance.tab != CostRoom::tab) return;
    OutlineItem& region = open("cost", say("command.tab_cost.label"));
    if (cost.page == CostPage::effects) {
      if (findings.survey)
        for (const std::string& each : effect_texts(*findings.survey, language()))
          add(region, Role::text, fmt::format("effect-{}", region.items.size()), each);
      add(region, Role::text, "whole", survey_text(findings.survey, findings.surveyed, language()));
      return;
    }
    if (cost.tried.empty()) return static_cast<void>(add(region, Role::text, "empty", say("cost.empty")));
    add(region, Role::text, "reference", reference_text(findings, language()));
    OutlineItem& list = add(region, Role::list, "tries", region.name);
    for (int i = 0; i < static_cast<int>(cost.tried.size()); ++i) {
      OutlineItem& entry = add(list, Role::entry, fmt::format("try-{}", i), attempt_text(state_, findings, i));
      entry.current = i == cost.chosen;
    }
  }

  void settings() {
    outline_breakpoints(state_, open("breakpoints", say("breakpoints.title"), true));
    outline_image_settings(state_, open("image-settings", say("image.settings_title"), true));
    outline_cost_knobs(state_, open("cost-knobs", say("cost.knobs"), true));
  }

  void ink() {
    const Ink& marks = state_.document.contents.ink;
    if (marks.empty() && !inks(state_)) return;
    OutlineItem& region = open("ink", say("command.ink.label"));
    if (const InkText* note = text_begun(state_)) {
      field(region, Role::words, "type", say("ink.type"), "ink-type {}", note->text);
      button(region, "finish", say("ink.finish"), action::FinishInk{});
    }
    OutlineItem& list = add(region, Role::list, "marks", say("ink.marks"));
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const std::string what(std::visit([](const auto& mark) { return shape_name(mark); }, marks[i].shape));
      const std::string reading = reading_of(marks[i], language());
      const std::string name(family_text("command", "ink_" + what + ".label", language()));
      add(list, Role::entry, std::to_string(i), reading.empty() ? name : name + ": " + reading);
    }
  }

  void help_text() {
    if (state_.walk.mode != Mode::help) return;
    OutlineItem& region = open("help", say("command.mode_help.label"));
    int number = 0;
    for (const HelpSection& section : help(language())) {
      OutlineItem& list = add(region, Role::list, std::to_string(++number), section.title);
      for (std::size_t i = 0; i < section.entries.size(); ++i) {
        const HelpEntry& entry = section.entries[i];
        add(list, Role::entry, std::to_string(i), entry.term.empty() ? entry.text : entry.term + ": " + entry.text);
      }
    }
  }

 private:
  [[nodiscard]] Language language() const { return state_.appearance.language; }
  [[nodiscard]] std::string say(std::string_view id, const TextArguments& arguments = {}) const {
    return fill(id, language(), arguments);
  }

  OutlineItem& open(std::string key, std::string name, bool folded = false) {
    regions_.push_back({Role::region, std::move(key), std::move(name)});
    regions_.back().folded = folded;
    return regions_.back();
  }
  /// What has no name has nothing to say.
  static void leave_out_unsaid(std::vector<OutlineItem>& items) {
    std::erase_if(items, [](const OutlineItem& item) { return item.name.empty(); });
    for (OutlineItem& item : items) leave_out_unsaid(item.items);
  }

  /// Those of a lesson's text, between empty lines.
  static void paragraphs(OutlineItem& parent, const std::string& key, std::string_view text) {
    for (int number = 0; !text.empty(); ++number) {
      const std::size_t end = std::min(text.find("\n\n"), text.size());
      add(parent, Role::text, fmt::format("{}-{}", key, number), std::string(text.substr(0, end)));
      text.remove_prefix(std::min(text.find_first_not_of('\n', end), text.size()));
    }
  }
  /// Once the bug is known.
  void mend(OutlineItem& region) {
    if (!state_.walk.bug || !state_.walk.bug->known) return;
    const bool mended = state_.walk.bug->mended;
    button(region, "mend", say(mended ? "bug.break_again" : "bug.mend"), action::MendBug{!mended});
  }

  static void passages(OutlineItem& parent, const std::string& key, const std::vector<BugPassage>& all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      paragraphs(parent, fmt::format("{}-{}", key, i),
                 all[i].heading.empty() ? all[i].text : all[i].heading + ": " + all[i].text);
  }

  void lessons(const LessonPanel& panel) {
    OutlineItem& region = open("lesson", say("lesson.lessons"));
    for (const LessonRow& row : panel.rows)
      button(region, row.name,
             fmt::format("{}, {} / {}", row.title, row.done, row.steps) + (row.next ? ", " + say("lesson.go_on") : ""),
             action::OpenLesson{row.name}, !row.locked);
    const LessonRoom& sitting = state_.lessons;
    button(region, "unlock", say("lesson.unlock"),
           action::SetLessonOptions{sitting.presenter, !sitting.unlocked, !sitting.notes})
        .chosen = sitting.unlocked;
    button(region, "leave", say("dialog.close"), action::ShowLessons{false});
  }

  void ask(OutlineItem& region, const LessonPanel& panel) {
    if (panel.asks == Asks::nothing) return;
    add(region, Role::news, "question", say("lesson.predict") + ": " + panel.question);
    for (std::size_t i = 0; i < panel.choices.size(); ++i) {
      const LessonChoice& choice = panel.choices[i];
      const std::string sign = state_.lessons.revealed && choice.right ? "\u2713 " : "";
      button(region, fmt::format("choice-{}", i), fmt::format("{}{}  {}", sign, i + 1, choice.text),
             action::GuessChoice{static_cast<int>(i)}, !state_.lessons.revealed)
          .chosen = choice.guessed;
    }
    if (state_.lessons.revealed) return;
    const LessonGuess& guess = state_.lessons.guess;
    if (panel.asks == Asks::number)
      field(region, Role::number, "number",
            panel.unit.empty() ? say("outline.your_number") : say("outline.your_number_in", {{"unit", panel.unit}}),
            "guess-number {}", guess.number ? number_text(*guess.number, language()) : "");
    if (panel.asks == Asks::arrow) degrees(region, guess.arrow);
    if (panel.asks == Asks::line) add(region, Role::news, "marked", panel.marked);
  }

  /// A direction as a number. What a mouse drags is `towards`, from the ray's origin.
  void degrees(OutlineItem& region, const std::optional<Vec2d>& towards) {
    std::string now;
    if (towards) now = number_text(std::atan2(towards->y, towards->x) * 180 / std::numbers::pi, language());
    field(region, Role::number, "degrees", say("outline.degrees"), "guess-angle {}", now);
  }

  void predictions(OutlineItem& region) {
    add(region, Role::news, "predict", prediction_sentence(state_));
    const auto asked = prediction_asked(state_);
    if (!asked) return;
    const auto& open = state_.predictions.open;
    if (asked->what == PredictionKind::way) return degrees(region, open ? std::optional(open->arrow) : std::nullopt);
    const auto offer = [&](const Target& met, const std::string& name) {
      const std::string key = fmt::format("met-{}-{}", name_of(met.kind), met.index);
      button(region, key, name, action::GuessEnd{met}).chosen = open && open->met == met;
    };
    for (int i = 0; i < static_cast<int>(std::min(state_.scene().objects.size(), most_outlined)); ++i)
      offer({TargetKind::object, i}, object_name(state_, i));
    for (int i = 0; i < static_cast<int>(std::min(state_.scene().lights.size(), most_outlined)); ++i)
      offer({TargetKind::light, i}, light_name(state_, i));
    offer({}, say("predict.nothing"));
  }

  /// `rays_of`: by parent, from -1 on, the nodes below it.
  void add_rays(OutlineItem& parent, const TreePanel& panel, const std::vector<std::vector<int>>& rays_of, int of) {
    for (const int i : rays_of[static_cast<std::size_t>(of + 1)]) {
      const TreeNode& node = panel.nodes[static_cast<std::size_t>(i)];
      std::string name = node_text(state_, node);
      for (char& c : name)
        if (c == '\n') c = ' ';
      OutlineItem& entry = add(parent, Role::entry, std::to_string(node.ray), name);
      entry.current = node.current;
      add_rays(entry, panel, rays_of, i);
    }
  }

  /// A thing of the plan, which in Move mode can be put elsewhere.
  void thing(OutlineItem& list, const Target& target, const std::string& name, bool somewhere = true) {
    const std::string key = fmt::format("{}-{}", name_of(target.kind), target.index);
    if (!somewhere) return static_cast<void>(add(list, Role::entry, key, name));
    const Vec2d at = place_of(state_, target, state_.plan.viewport);
    const std::string x = number_text(at.x, language()), y = number_text(at.y, language());
    OutlineItem& entry = add(list, Role::entry, key, fmt::format("{}: x {}, y {}", name, x, y));
    if (state_.walk.mode != Mode::move) return;
    const std::string place = fmt::format("place {} {} -1", name_of(target.kind), target.index);
    field(entry, Role::number, "x", say("outline.x_of", {{"name", name}}), fmt::format("{} {{}} {}", place, at.y), x);
    field(entry, Role::number, "y", say("outline.y_of", {{"name", name}}), fmt::format("{} {} {{}}", place, at.x), y);
    OutlineItem& select =
        button(entry, "select", say("outline.properties_of", {{"name", name}}), action::Select{target});
    select.chosen = state_.plan.selected.kind == target.kind && state_.plan.selected.index == target.index;
    select.leads_to = "properties";
  }

  const State& state_;
  Outline regions_;
};

}  // namespace

Outline outline(const State& state, const CostFindings* costs) {
  Outliner parts(state);
  parts.notice();
  parts.question();
  parts.prompt();
  if (waits_for_answer(state)) return std::move(parts).take();  // nothing else has an effect
  parts.link();
  parts.lesson();
  parts.bugs();
  parts.walk();
  parts.code();
  parts.equation();
  parts.tree();
  parts.stack();
  parts.plan();
  parts.properties();
  if (costs != nullptr) parts.costs(*costs);
  parts.ink();
  parts.settings();
  parts.help_text();
  return std::move(parts).take();
}

Result<Action> outlined_action(const State& state, std::string_view does, std::string_view typed) {
  const std::size_t gap = does.find("{}");
  if (gap == std::string_view::npos) return parse_action(does);
  const auto refused = [&](std::string_view why) {
    return tl::unexpected(Error{{}, 0, 0, fill(why, state.appearance.language), {}});
  };
  std::string value(typed);
  if (does.starts_with("ink-type")) {
    if (value.empty()) return Action(action::TypeInk{});  // what was written is taken back
  } else if (does.starts_with("link-page")) {
    if (value.empty()) return Action(action::SetLinkPage{});
  } else if (does.starts_with("open") || does.starts_with("save") || does.starts_with("export")) {
    if (value.empty()) return refused("outline.no_path");
  } else if (does.starts_with("set ")) {
    if (value.empty() && does.find(" name {}") != std::string_view::npos) return refused("outline.no_name");
  } else if (does.starts_with("guess-number")) {
    const auto guess = typed_guess(state.lessons, typed);
    if (!guess) return refused("lesson.not_a_number");
    value = fmt::format("{}", *guess);
  } else {
    const std::vector<double> meant = typed_numbers(typed);
    if (meant.empty()) return refused("lesson.not_a_number");
    value = fmt::format("{}", meant.front());
  }
  return parse_action(std::string(does.substr(0, gap)) + value + std::string(does.substr(gap + 2)));
}

}  // namespace raywalk
