// Implements the lesson actions.

#include "render/parallel.h"
#include "text/file.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/lesson/lesson_panel.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/fault.h"
#include "view/walk/walk.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace raywalk {

namespace {

constexpr std::size_t max_progress = 1 << 16;  // bytes

std::string progress_path(const State& state) { return state.document.state_dir + "/lessons.json"; }

void say_not_kept(State& state, const Error& why) {
  if (std::exchange(state.lessons.cannot_be_kept, true)) return;
  state.lessons.unsaid = fill("lesson.progress_not_kept", state.appearance.language, {{"why", why.text()}});
}

/// Of a file that holds no progress, such as one that was cut off: it may still be mended by hand.
void set_progress_aside(State& state) {
  const Result<std::string> kept = set_aside(progress_path(state));
  if (!kept) return say_not_kept(state, kept.error());
  state.lessons.unsaid = fill("lesson.progress_damaged", state.appearance.language, {{"file", *kept}});
}

/// What another window, or an earlier sitting, has written: adds what it has finished and predicted and where it was,
/// and takes over whether lessons are unlocked.
void read_progress(State& state) {
  if (state.document.state_dir.empty()) return;
  const std::string path = progress_path(state);
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return;  // none yet, or one that cannot be reached
  const auto bytes = read_file(path, max_progress);
  const auto json = bytes ? nlohmann::json::parse(*bytes, nullptr, false) : nlohmann::json();
  if (!json.is_object()) return set_progress_aside(state);
  const auto each_step = [&](const char* key, const auto& take) {
    if (const auto steps = json.find(key); steps != json.end() && steps->is_object())
      for (const auto& [name, step] : steps->items())
        if (step.is_number_integer()) take(name, std::clamp(step.template get<int>(), 0, 1000));
  };
  each_step("done", [&](const std::string& name, int steps) {
    int& own = state.lessons.done[name];
    own = std::max(own, steps);
  });
  each_step("left_at", [&](const std::string& name, int step) { state.lessons.left_at.try_emplace(name, step); });
  if (const auto tries = json.find("first_tries"); tries != json.end() && tries->is_object())
    for (const auto& [name, of] : tries->items())
      if (of.is_object() && !state.lessons.first_tries.contains(name))
        for (const auto& [step, right] : of.items()) {
          int number = 0;
          if (std::from_chars(step.data(), step.data() + step.size(), number).ec != std::errc()) continue;
          state.lessons.first_tries[name].by_step[number] =
              right.is_boolean() ? std::optional(right.get<bool>()) : std::nullopt;
        }
  if (const auto last = json.find("last"); last != json.end() && last->is_string() && state.lessons.last.empty())
    state.lessons.last = last->get<std::string>();
  if (const auto unlocked = json.find("unlocked"); unlocked != json.end() && unlocked->is_boolean())
    state.lessons.unlocked = unlocked->get<bool>();
}

/// Once it was read: what others have written meanwhile is part of it.
void write_progress(State& state) {
  if (state.document.state_dir.empty()) return;
  nlohmann::json tries = nlohmann::json::object();
  for (const auto& [name, of] : state.lessons.first_tries)
    for (const auto& [step, right] : of.by_step)
      tries[name][std::to_string(step)] = right ? nlohmann::json(*right) : nlohmann::json();
  const nlohmann::json json{{"done", state.lessons.done},
                            {"first_tries", tries},
                            {"left_at", state.lessons.left_at},
                            {"last", state.lessons.last},
                            {"unlocked", state.lessons.unlocked}};
  std::error_code error;
  std::filesystem::create_directories(state.document.state_dir, error);
  const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);  // names may be anything
  const Result<void> written = write_file_atomically(progress_path(state), text + "\n");
  if (!written) return say_not_kept(state, written.error());
  state.lessons.cannot_be_kept = false;
}

void read_list(State& state) {
  LessonRoom& sitting = state.lessons;
  if (!sitting.list.empty() || sitting.folder.empty()) return;
  read_progress(state);
  for (const std::string& name : lesson_names(sitting.folder)) {
    const auto lesson = read_lesson(sitting.folder + "/" + name);
    if (!lesson) {
      complain(state, lesson.error().text());
      continue;
    }
    LessonEntry entry;
    entry.name = name;
    entry.steps = static_cast<int>(lesson->steps.size());
    entry.scene = lesson->steps.empty() ? std::string() : lesson->steps.front().scene.value_or("");
    for (const auto& [code, words] : lesson->words) {
      entry.titles[code] = words.title;
      entry.summaries[code] = words.summary.text;
    }
    sitting.list.push_back(std::move(entry));
  }
}

/// The first pixel of this step's walk: its own, or that of an earlier step in the same walk.
int first_pixel(const LessonRoom& sitting) {
  const std::vector<PlayedStep>& steps = sitting.open->played.steps;
  for (int i = sitting.step; i >= 0; --i) {
    const PlayedStep& step = steps[static_cast<std::size_t>(i)];
    if (step.walk != sitting.at()->walk) break;
    if (step.step->pixel) return step.step->pixel->column;
  }
  return 0;
}

/// Opens the tab that a lesson names: of the same word, or the picture.
void show_beside(State& state, LessonBeside pane) {
  if (pane == LessonBeside::picture)
    state.appearance.tab = PictureRoom::tab;
  else
    state.appearance.tab = named<Tab>(name_of(pane)).value_or(state.appearance.tab);
}

/// Opens what the steps before the current one have left beside the plan: whoever comes from a later step, or straight
/// to this one, sees what others see here.
void show_as_left(State& state) {
  if (const LessonBeside left = left_before(state.lessons); left != LessonBeside::unchanged) show_beside(state, left);
}

/// As the step was written: what was chosen for an earlier one is not seen in it. The structure changes no picture.
void reset_settings(State& state) {
  const AcceleratorKind accelerator = state.picture.settings.accelerator;
  state.picture.settings = {};
  state.picture.settings.accelerator = accelerator;
}

/// Before the scene of the step gives way to one that was written: what was changed in it can be redone in this step.
void keep_changes(State& state) { state.lessons.changes[state.lessons.step] = all_undone(state.document); }

/// Whether the scene was changed in this step, and not only drawn over.
bool has_changes(const LessonRoom& sitting) {
  const auto kept = sitting.changes.find(sitting.step);
  return kept != sitting.changes.end() && std::any_of(kept->second.begin(), kept->second.end(), [](const auto& change) {
           return std::holds_alternative<Scene>(*change);
         });
}

/// Lets them be redone in the scene as it was written, which is shown now.
void offer_changes(State& state) {
  const auto kept = state.lessons.changes.find(state.lessons.step);
  if (kept != state.lessons.changes.end()) state.document.redo = kept->second;
  if (has_changes(state.lessons))
    inform_above(state, std::string(text("lesson.changes_here", state.appearance.language)));
}

/// Shows the step's walk, at the position of the question; `anew`: even where the same scene stands there.
void stage(State& state, bool anew = false) {
  const PlayedStep& step = *state.lessons.at();
  const LessonWalk& walk = *step.walk;
  const std::optional<PixelWalk> pixel = pixel_of(walk);
  const bool stays = !anew && is_staged(state) && !(state.walk.bug && state.walk.bug->mended);
  if (!stays) {
    state.walk.grain = Grain::line;  // the step's words are of lines
    forget_autosave(state);          // changes stay with their step
    reset_settings(state);
    EffectsRoom::close(state);
    show_document(state, walk.document, {});
    state.walk.pixel = pixel;
    if (pixel && !walk.fault) record_again(state);
    set_bug(state, walk.fault);
    offer_changes(state);
  }
  if (state.walk.bug) state.walk.bug->known = false;
  if (step.step->pixel || !stays) state.lessons.first_pixel = pixel ? 0 : first_pixel(state.lessons);
  state.lessons.guess = {};
  state.lessons.hands.clear();
  state.lessons.revealed = false;
  show_beside(state, step.step->pane);
  if (step.step->pane == LessonBeside::microscope)
    state.microscope.magnified = 0.42;  // in double, where a millionth of a scene unit is seen
  if (step.step->pencils) state.pencil.shown = !step.step->question;
  go_to(state, step.asked);
}

/// Renders the pictures that a step's answer is about: some take a second. Cancelled, nothing has changed.
void render_pictures(const State& state, const std::shared_ptr<const OpenedLesson>& opened, int step) {
  const auto& pictures = opened->played.steps[static_cast<std::size_t>(step)].pictures;
  if (pictures.empty()) return;
  run_detached(state.document.stop, [opened, &pictures] {
    for (const auto& [name, picture] : pictures) static_cast<void>(picture->rendering());
  });
}

/// Whether pictures of a step are spoken of as soon as it is reached: its answer is told at once, or its words before a
/// question have numbers of them.
bool needs_pictures(const State& state, const OpenedLesson& opened, int at) {
  const PlayedStep& step = opened.played.steps[static_cast<std::size_t>(at)];
  if (!step.step->question || state.lessons.presenter) return true;
  const StepWords* said = opened.lesson.told(state.appearance.language).find(step.step->id);
  return said != nullptr && std::any_of(step.pictures.begin(), step.pictures.end(), [&](const auto& picture) {
           const std::string before = said->text.text + said->question.text;
           return before.find(picture.first + ".") != std::string::npos ||
                  before.find("\"" + picture.first + "\"") != std::string::npos;
         });
}

void begin_lesson(State& state, const std::string& name) { open_lesson(state, name, std::nullopt); }

/// Back to the list, and to the previous scene.
void end_lesson(State& state, const std::string& /*name*/) {
  forget_autosave(state);
  const std::shared_ptr<const OwnScene> own = state.lessons.own;
  LessonRoom::close(state);
  if (!own) return;
  show_document(state, own->document, own->path);
  state.picture.settings = own->settings;
  state.appearance.tab = own->tab;
  if (state.lessons.shown) action::SetFocus{false}.apply(state);  // where the list could not be seen
  state.walk.mode = own->mode;
  state.walk.position = std::min(own->position, state.walk.timeline->steps());
}

}  // namespace

bool open_lesson(State& state, const std::string& name, std::optional<int> step) {
  LessonRoom& sitting = state.lessons;
  auto lesson = read_lesson(sitting.folder + "/" + name);
  if (!lesson) {
    complain(state, lesson.error().text());
    return false;
  }
  const Mode mode = state.walk.mode;
  const auto opened = std::make_shared<OpenedLesson>(std::move(*lesson));
  // Some play for seconds. Cancelled, the lesson is not opened, and what it then plays is dropped.
  run_detached(state.document.stop,
               [opened, folder = sitting.scenes_folder] { opened->played = play_lesson(opened->lesson, folder); });
  if (opened->played.steps.empty()) {
    complain(state, opened->played.errors.empty() ? name : opened->played.errors.front().text());
    return false;
  }
  const auto done = sitting.done.find(name);
  const int steps = static_cast<int>(opened->played.steps.size());
  const auto left = sitting.left_at.find(name);
  int at = left != sitting.left_at.end() ? left->second : done == sitting.done.end() ? 0 : done->second;
  if (at >= steps) at = 0;
  if (step) at = std::clamp(*step, 0, steps - 1);
  if (needs_pictures(state, *opened, at)) render_pictures(state, opened, at);
  forget_autosave(state);
  if (!sitting.open && saved_scene(state) != Scene{}) {
    // Unsaved work was asked about, and discarded.
    sitting.own =
        std::make_shared<const OwnScene>(OwnScene{saved_document(state), state.document.path, mode, state.walk.position,
                                                  state.picture.settings, state.appearance.tab});
  }
  sitting.open = opened;
  sitting.answered.clear();
  sitting.changes.clear();
  sitting.told_of_changes = false;
  read_progress(state);
  sitting.last = name;
  if (!sitting.left_at.contains(name)) sitting.first_tries.erase(name);  // it begins anew
  sitting.left_at[name] = at;
  write_progress(state);
  sitting.step = at;
  sitting.exchanged = {};
  sitting.shown = true;
  state.focus.tab = false;
  show_as_left(state);
  stage(state, true);
  action::FitView{}.apply(state);
  return true;
}

void LessonRoom::close(State& state) {
  if (state.lessons.open) set_bug(state, std::nullopt);
  state.lessons.open.reset();
  state.lessons.own.reset();
  state.lessons.changes.clear();
  state.lessons.guess = {};
  state.lessons.revealed = false;
}

/// After the action: a scene that it has opened has taken back what was said before.
void LessonRoom::follow(State& state, const Before& /*before*/) {
  if (state.lessons.unsaid.empty()) return;
  std::string words = std::exchange(state.lessons.unsaid, {});
  if (state.document.notice) words += "\n" + state.document.notice->text;
  complain(state, std::move(words));
}

void action::ShowLessons::apply(State& state) const {
  const bool opens = shown && !state.lessons.shown;
  state.lessons.shown = shown;
  state.lessons.chosen.reset();
  if (!shown) {
    // A fault without its lesson would be confusing.
    if (state.lessons.at() != nullptr) set_bug(state, std::nullopt);
    return;
  }
  state.bugs.shown = false;
  state.appearance.front = Front::lesson;
  // In Focus the list could not be seen.
  if (opens && state.lessons.at() == nullptr) SetFocus{false}.apply(state);
  if (opens && state.lessons.at() != nullptr && state.lessons.at()->walk->fault) {
    keep_changes(state);
    stage(state);
  }
  if (state.walk.mode == Mode::help) state.walk.mode = Mode::trace;
  read_list(state);
}

void action::ListLessons::apply(State& state) const { read_list(state); }

void action::OpenLesson::apply(State& state) const {
  ShowLessons{true}.apply(state);
  const std::vector<LessonRow> rows = lesson_rows(state.lessons, state.appearance.language);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const LessonRow& each) { return each.name == name; });
  if (row == rows.end()) return complain(state, fill("lesson.unknown", state.appearance.language, {{"name", name}}));
  if (row->locked) return inform(state, std::string(text("lesson.locked", state.appearance.language)));
  ask_or_do(state, {state.lessons.open ? "question.unsaved_lesson_open" : "question.unsaved_open", begin_lesson}, name);
}

void action::ChooseLesson::apply(State& state) const {
  if (!state.lessons.shown || state.lessons.at() != nullptr || state.lessons.list.empty()) return;
  const std::vector<LessonRow> rows = lesson_panel(state).rows;
  const auto now = std::find_if(rows.begin(), rows.end(), [](const LessonRow& row) { return row.next; });
  const int last = static_cast<int>(rows.size()) - 1, from = static_cast<int>(now - rows.begin());
  state.lessons.chosen = std::clamp(now == rows.end() && by > 0 ? by - 1 : from + by, 0, last);
}

void action::LeaveLesson::apply(State& state) const {
  if (state.lessons.open) ask_or_do(state, {"question.unsaved_lesson", end_lesson}, {});
}

void action::GoToLessonStep::apply(State& state) const {
  LessonRoom& sitting = state.lessons;
  if (!sitting.open || step < 0) return;
  const LessonPanel panel = lesson_panel(state);
  if (step > sitting.step && !panel.can_go_on) return;
  // The steps between may ask.
  const bool skips = sitting.unlocked || sitting.presenter;
  const int to = std::min(step, skips ? panel.steps : sitting.step + 1);
  if (to < panel.steps && needs_pictures(state, *sitting.open, to)) render_pictures(state, sitting.open, to);
  int& done = sitting.done[sitting.open->lesson.name];
  done = std::max(done, to);
  read_progress(state);
  if (to >= panel.steps)
    sitting.left_at.erase(sitting.open->lesson.name);
  else
    sitting.left_at[sitting.open->lesson.name] = to;
  write_progress(state);
  if (to >= panel.steps) return LeaveLesson{}.apply(state);
  const bool jumps = to < sitting.step || to > sitting.step + 1, asks_again = to == sitting.step || sitting.presenter;
  const bool was_changed = state.document.dirty;
  keep_changes(state);
  const int from = std::exchange(sitting.step, to);
  sitting.exchanged = {};
  state.focus.tab = false;
  reset_settings(state);
  if (state.document.notice && state.document.notice->kind == Notice::Kind::info) state.document.notice.reset();
  if (jumps) show_as_left(state);
  stage(state, to != from && has_changes(sitting));
  if (was_changed && !state.document.dirty && !state.document.notice && !std::exchange(sitting.told_of_changes, true))
    inform(state, fill("lesson.changes_kept", state.appearance.language, {{"step", from + 1}}));
  FitView{}.apply(state);  // a step speaks of the whole, wherever the one before it was looked at closely
  // Who looks back finds the answer that was there; a presenter asks another class.
  if (const auto answered = sitting.answered.find(to); answered != sitting.answered.end() && !asks_again) {
    sitting.guess = answered->second;
    RevealLesson{}.apply(state);
  }
}

void action::GuessChoice::apply(State& state) const {
  LessonRoom& sitting = state.lessons;
  const LessonPanel panel = lesson_panel(state);
  if (panel.asks != Asks::choice || sitting.revealed || choice < 0 || choice >= static_cast<int>(panel.choices.size()))
    return;
  sitting.guess.choice = choice;
}

void action::ShowHands::apply(State& state) const {
  constexpr int most = 999;
  LessonRoom& sitting = state.lessons;
  const LessonPanel panel = lesson_panel(state);
  if (sitting.revealed || choice < 0 || choice >= static_cast<int>(panel.choices.size())) return;
  sitting.hands.resize(panel.choices.size());
  int& up = sitting.hands[static_cast<std::size_t>(choice)];
  up = std::clamp(up + std::clamp(hands, -most, most), 0, most);
}

void action::GuessNumber::apply(State& state) const {
  if (lesson_panel(state).asks != Asks::number || state.lessons.revealed) return;
  state.lessons.guess.number = std::isfinite(number) ? std::optional(number) : std::nullopt;
}

void action::RevealLesson::apply(State& state) const {
  LessonRoom& sitting = state.lessons;
  if (!lesson_panel(state).can_reveal) {
    if (question_waits(state)) ask_to_predict(state);
    return;
  }
  render_pictures(state, sitting.open, sitting.step);
  sitting.revealed = true;
  sitting.answered[sitting.step] = sitting.guess;
  const auto verdict = judge(sitting);
  auto& tries = sitting.first_tries[sitting.open->lesson.name].by_step;
  if (tries.try_emplace(sitting.step, verdict ? std::optional(verdict->right) : std::nullopt).second) {
    read_progress(state);
    write_progress(state);
  }
  // A student may have walked elsewhere, or changed the scene.
  if (!is_staged(state)) {
    const LessonGuess guess = sitting.guess;
    const std::vector<int> hands = sitting.hands;
    keep_changes(state);
    stage(state);
    sitting.guess = guess;
    sitting.hands = hands;
    sitting.revealed = true;
  }
  if (state.walk.bug) state.walk.bug->known = true;
  // An answer over several pixels shows the rays of all.
  const PlayedStep& step = *sitting.at();
  if (state.walk.timeline->current_pixel(step.shown) != state.walk.timeline->current_pixel(step.asked))
    sitting.first_pixel = 0;
  show_beside(state, step.step->then);
  if (step.step->pencils) state.pencil.shown = true;
  go_to(state, step.shown);
}

void action::SetLessonOptions::apply(State& state) const {
  // Who changes something else, perhaps before the list was read, does not lock what an earlier sitting or another
  // window has unlocked.
  const bool changes_locks = unlocked != state.lessons.unlocked;
  read_list(state);
  read_progress(state);
  if (changes_locks) state.lessons.unlocked = unlocked;
  state.lessons.presenter = presenter;
  state.lessons.notes = !without_notes;
  if ((presenter || unlocked) && state.document.notice &&
      state.document.notice->text == text("lesson.locked", state.appearance.language))
    state.document.notice.reset();
  write_progress(state);
}

void action::ExchangePanes::apply(State& state) const {
  if (std::exchange(state.focus.tab, false) && state.focus.on) return;
  if (lesson_enlarges(state)) {
    bool& by_hand = state.lessons.exchanged[state.walk.mode == Mode::move ? 0 : 1];
    by_hand = !by_hand;
    return;
  }
  std::vector<Tab>& exchanged = state.appearance.exchanged;
  if (std::erase(exchanged, state.appearance.tab) == 0) exchanged.push_back(state.appearance.tab);
}

void action::ShowNotesWindow::apply(State& state) const {
  state.lessons.notes_window = shown;
  if (!shown) return;
  state.lessons.presenter = true;
  state.lessons.notes = false;  // the class sees none of it
}

}  // namespace raywalk
