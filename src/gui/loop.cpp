#include "gui/loop.h"

#include "gui/animation.h"
#include "gui/awaited.h"
#include "gui/command.h"
#include "gui/fallback_fonts.h"
#include "gui/interface.h"
#include "gui/live_costs.h"
#include "gui/loading.h"
#include "gui/mirror.h"
#include "gui/notes.h"
#include "gui/platform.h"
#include "gui/report.h"
#include "gui/shown_picture.h"
#include "gui/structure_workers.h"
#include "gui/style.h"
#include "text/file.h"
#include "view/document/document.h"
#include "view/opening.h"
#include "view/outline.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

// After an event, ImGui needs a few frames until all its effects are on the screen.
constexpr int frames_to_settle = 3;
constexpr double shortest_wait = 1.0 / 60;  // seconds
constexpr double least_of_a_row = 0.25;     // seconds
constexpr double image_slice = 14;          // milliseconds of work on the 3-D image between polls of events
constexpr double smoothing_every = 0.3;     // seconds, once only noise is being reduced
constexpr double image_every = 0.08;        // seconds between updates of a 3-D image that is being refined
constexpr double notice_lasts = 6;          // seconds, unless it reports an error

/// Whether the action writes a file of the user's.
bool writes_file(const Action& action) {
  return action.is<action::Export>() || action.is<action::FinishExport>() || action.is<action::Save>() ||
         action.is<action::SaveAs>() || action.is<action::SavePredictions>() || action.is<action::AnswerQuestion>();
}

}  // namespace

class Loop::Parts {
 public:
  Parts(GuiOptions options, State state, Window& window, Attention& attention, Demo demo, Clock::time_point begun)
      : options_(std::move(options)),
        state_(std::move(state)),
        window_(window),
        attention_(attention),
        interface_(options_.data_dir + "/scenes"),
        demo_(std::move(demo)),
        begun_(begun),
        settings_(settings_of(state_)),
        fonts_found_(find_fonts(font_folders(options_.data_dir))) {
    find_fallbacks(fonts_found_, font_folders(options_.data_dir),
                   letters_beyond(state_.appearance.language.others(), state_.lessons.folder));
    state_.document.stop = Stop(attention_);
    ImGui::GetIO().ConfigDragClickToInputText = true;
  }

  [[nodiscard]] bool turn() {
    if (window_.wait(window_.minimised() ? until_due(false) : patience())) frames_due_ = frames_to_settle;
    pass_time();
    for (const KeyPress& key : window_.minimised() ? window_.drop_keys() : window_.take_keys()) press(key);
    if (window_.take_key_release()) let_go();
    open_dropped();
    if (window_.take_close_request()) close();
    if (!broken_ && !window_.minimised()) {
      work_on_structures();
      if (frames_due_ > 0 && structures_.patience() == 0) frame(nullptr);
      if (broken_) return false;
      work_on_image();
      work_on_costs();
      work_on_export();
      if (wants_picture() && settled()) return false;
    }
    if (!broken_) show_notes();
    return !state_.document.quit;
  }

  Result<void> end() {
    if (wants_picture() && !broken_ && settled()) return take_picture();
    if (wants_picture() && outcome_)
      return tl::unexpected(Error{options_.screenshot_path, 0, 0,
                                  "not written: the window was closed before its picture was whole",
                                  "a demo for a screenshot needs no \"quit\": the program ends with the picture"});
    if (!wants_picture()) keep_settings();
    return outcome_;
  }

  // Seconds until something must be done; negative: indefinitely.
  [[nodiscard]] double patience() const {
    const bool works = !image_.rests(state_) ? !image_.waits() : !costs_.rests(state_) && !costs_.waits(state_);
    if (works || state_.exports.window) return 0;
    if (frames_due_ > 0) return structures_.patience();
    return until_due();
  }

  void act(const Action& action) {
    if (broken_) return;
    frames_due_ = frames_to_settle;
    const std::optional<Awaited> awaited = awaited_by(state_, action);
    const std::optional<State> before = awaited ? std::optional(state_) : std::nullopt;
    bool told = false, cancelled = false;
    const Attention::Watch watch(attention_, Attention::To::closing);
    if (awaited)
      attention_.tell([&](double seconds) {
        tell_of(*awaited, seconds);
        told = true;
        return cancelled = escape_pressed();
      });
    try {
      update(state_, action);
      if (told) {  // nobody was asked while the scene took its place, though that it can be cancelled was still said
        static_cast<void>(window_.look(false));
        cancelled = escape_pressed() || cancelled;
      }
    } catch (const Stopped&) {
      if (!cancelled) {
        // Closed during a change. What was changed is kept for the next start; nothing else is asked of this state.
        autosave(state_, autosave_every);
        broken_ = true;
        state_.document.quit = true;
        return;
      }
    }
    if (cancelled) {
      // The autosave may be gone, with its name.
      std::string autosave_file = std::move(state_.document.autosave_file);
      auto autosave_hold = std::move(state_.document.autosave_hold);
      state_ = *before;
      state_.document.autosave_file = std::move(autosave_file);
      state_.document.autosave_hold = std::move(autosave_hold);
      state_.document.autosaved_revision = 0;
      state_.document.notice = Notice{
          Notice::Kind::info, fill("notice.reading_cancelled", state_.appearance.language, {{"file", awaited->name}})};
    }
    if (!options_.demo_path.empty()) note_failure(action);
  }

  // What is being typed is work too, which the question about it must know of.
  void close() {
    if (broken_) return;
    if (window_.minimised()) return act_from_outside(action::Quit{});  // no frame would come
    if (animation_) finish_animation();
    interface_.act_after_typing(action::Quit{});
    frames_due_ = frames_to_settle;
    apply();
  }

  // What is being typed is work too, as for `close`.
  void open_dropped() {
    const std::vector<std::string> dropped = window_.take_dropped();
    if (broken_ || dropped.empty()) return;
    if (animation_) finish_animation();
    for (const Action& action : opening_among(state_, dropped)) interface_.act_after_typing(action);
    frames_due_ = frames_to_settle;
    apply();
  }

  // An animation in the making would show what is done meanwhile: it ends here.
  void act_from_outside(const Action& action) {
    if (animation_) finish_animation();
    act(action);
  }

  Result<void> act_by_outline(std::string_view does, std::string_view typed) {
    if (broken_) return {};
    if (animation_) finish_animation();
    if (does == choosing_files) {
      platform::choose_files();
      act(action::CancelPrompt{});
      return {};
    }
    constexpr std::string_view by_name = "command ";
    if (does.starts_with(by_name)) {
      const std::string_view name = does.substr(by_name.size());
      for (const Command* each : commands())
        if (each->name == name) interface_.run(state_, fonts_, unit(), dpi(), *each);
      frames_due_ = frames_to_settle;
      apply();
      return {};
    }
    const Result<Action> action = outlined_action(state_, does, typed);
    if (!action) return tl::unexpected(action.error());
    const auto* open = action->as<action::Open>();
    for (const Action& each : open != nullptr ? opening_of(state_, open->path) : std::vector{*action}) act(each);
    return {};
  }

  void autosave_now() {
    if (!broken_) autosave(state_, autosave_every);
  }

  void draw_again() {
    window_.draw_again();
    shown_image_.show_again(image_.preview().size(), image_.preview().rgba());
    shown_costs_.show_again(costs_.size(), costs_.rgba());
    gallery_.forget();
    frames_due_ = frames_to_settle;
  }

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] CostFindings costs() const {
    CostFindings findings = findings_of(costs_.bench());
    findings.survey = costs_.survey();
    findings.surveyed = costs_.surveyed();
    return findings;
  }

  [[nodiscard]] bool types_number() const { return interface_.types_number(); }
  [[nodiscard]] bool holds_at(float x, float y) const {
    return std::any_of(commands().begin(), commands().end(), [&](const Command* each) {
      const auto item = interface_.items().find(each->name);
      return each->held != nullptr && item != interface_.items().end() && item->second.contains(x, y);
    });
  }

 private:
  // Whether Escape is among the keys that were pressed; drops them all. Return may be among them: it would begin anew.
  bool escape_pressed() {
    const std::vector<KeyPress> keys = window_.drop_keys();
    return std::any_of(keys.begin(), keys.end(), [](const KeyPress& key) { return key.key == "Escape"; });
  }

  // Shows what is awaited, and for how long.
  void tell_of(const Awaited& awaited, double seconds) {
    const int whole = static_cast<int>(seconds);
    show_loading(window_, fonts_, state_.appearance.theme, awaited.words,
                 fill("files.reading_cancel", state_.appearance.language, {{"seconds", whole}}), seconds);
  }

  // After each frame, and not only at the end, which may be abrupt.
  void keep_settings() {
    const Settings now = settings_of(state_);
    if (now == settings_) return;
    write_settings(state_.document.state_dir, settings_, now);
    settings_ = now;
  }

  [[nodiscard]] float unit() const { return shrink() * wished_unit(); }
  [[nodiscard]] float wished_unit() const {
    return window_.scale() * static_cast<float>(state_.appearance.ui_scale * theme_scale(state_.appearance.theme));
  }
  /// In a small window everything is drawn smaller, rather than cut off.
  [[nodiscard]] float shrink() const {
    const auto [width, height] = window_.extent();
    const bool lesson = state_.lessons.shown || state_.bugs.shown;
    return shrink_to_fit(width, height, wished_unit(), lesson);
  }
  [[nodiscard]] float dpi() const { return shrink() * window_.scale(); }
  [[nodiscard]] bool wants_picture() const { return !options_.screenshot_path.empty(); }
  [[nodiscard]] bool settled() const {
    return frames_due_ == 0 && image_.rests(state_) && costs_.rests(state_) && demo_.over() && !state_.walk.playing &&
           !state_.walk.hold && !state_.walk.tween && !state_.exports.window && !waits_for_structures();
  }
  [[nodiscard]] bool waits_for_structures() const {
    return state_.structure.walks && (state_.structure.walks->waits() || state_.structure.awaited);
  }

  // `patience` for timed work; unless it is `seen`, for what is done in a minimised window too.
  [[nodiscard]] double until_due(bool seen = true) const {
    double wait = -1;
    const auto at_most = [&](double seconds) {
      wait = std::max(wait < 0 ? seconds : std::min(wait, seconds), shortest_wait);
    };
    if (wants_autosave(state_)) at_most(state_.document.autosave_in);
    if (notes_) at_most(1);
    if (!seen) return wait;
    if (state_.walk.hold || state_.walk.tween) at_most(shortest_wait);
    if (state_.walk.playing) at_most((1 - state_.walk.owed) / state_.walk.lines_per_second);
    if (!demo_.over()) at_most(0.1);
    if (state_.document.notice && state_.document.notice->kind == Notice::Kind::info)
      at_most(notice_lasts - notice_seen_);
    if (interface_.next_frame_in() >= 0) at_most(interface_.next_frame_in());
    return wait;
  }

  // The demo may run unattended: if it fails to write a file or to open a lesson, it ends as a failure, with a message.
  void note_failure(const Action& action) {
    if (!outcome_ || !state_.document.notice) return;
    const auto* lesson = action.as<action::OpenLesson>();
    const auto& open = state_.lessons.open;
    const bool failed = lesson != nullptr
                            ? !state_.document.question && (!open || open->lesson.name != lesson->name)
                            : writes_file(action) && state_.document.notice->kind == Notice::Kind::error &&
                                  !state_.document.notice->lasts;
    if (failed) outcome_ = tl::unexpected(Error{options_.demo_path, 0, 0, state_.document.notice->text, ""});
  }

  // One key press holds STEP once: if a breakpoint ends that, the key must be released first.
  void press(const KeyPress& key) {
    if (broken_ || (key.repeated && key_holds_)) return;
    if (animation_) {
      if (key.key == "Escape") finish_animation();
      return;
    }
    interface_.press(state_, fonts_, unit(), dpi(), key);
    apply();
    key_holds_ = key.repeated && state_.walk.hold;
  }
  void let_go() {
    if (std::exchange(key_holds_, false)) act(action::Release{});
  }

  void apply() {
    for (const Action& action : interface_.take_actions()) act(action);
    if (interface_.take_full_screen()) window_.toggle_full_screen();
    if (std::exchange(copies_, state_.link.copies) != state_.link.copies)
      ImGui::SetClipboardText(state_.link.copied.c_str());
  }

  void pass_time() {
    const Clock::time_point now = Clock::now();
    const double seconds = seconds_between(last_, now);
    last_ = now;
    const int position = state_.walk.position;
    const bool playing = state_.walk.playing, moving = state_.walk.tween.has_value();
    const auto notice = [&] { return state_.document.notice ? state_.document.notice->text : std::string(); };
    const std::string said = notice();
    update(state_, action::Tick{seconds});
    if (state_.walk.position != position || state_.walk.playing != playing || moving || notice() != said)
      frames_due_ = std::max(frames_due_, 1);
    // An export shows the moment of its request.
    if (state_.document.question && demo_.ignores_question()) {
      outcome_ = tl::unexpected(Error{options_.demo_path, 0, 0,
                                      "the window asks a question, and the demo does not answer it (expected \"answer "
                                      "save\", \"answer discard\" or \"answer cancel\" next)",
                                      "before it replaces a file or drops changes the window asks"});
      state_.document.quit = true;
    } else if (const Action* action = state_.exports.window ? nullptr : demo_.due(seconds)) {
      act(*action);
    }

    if (notice() != seen_notice_) {
      seen_notice_ = notice();
      notice_seen_ = 0;
    } else if (state_.document.notice && state_.document.notice->kind == Notice::Kind::info) {
      notice_seen_ += seconds;
      if (notice_seen_ >= notice_lasts) act(action::DismissNotice{});
    }
    if (interface_.next_frame_in() >= 0) {
      tooltip_in_ = tooltip_in_ < 0 ? interface_.next_frame_in() : tooltip_in_ - seconds;
      if (tooltip_in_ <= 0) frames_due_ = std::max(frames_due_, 1);
    } else {
      tooltip_in_ = -1;
    }
  }

  // Seconds that a row may take: if long, it gives way to what is due, but not at once; it is then restarted.
  [[nodiscard]] double longest_row() const {
    const double due = frames_due_ > 0 ? 0 : until_due();
    return due < 0 ? due : std::max(due, least_of_a_row);
  }

  void work_on_image() {
    if (frames_drawn_ == 0 || image_.rests(state_)) return;
    bool more = true;
    try {
      const Attention::Watch watch(attention_, Attention::To::input);
      if (image_.follow(state_, Stop(attention_))) return show_image(false);
    } catch (const Stopped&) {
      return;  // interrupted: it begins again after the input
    }
    {
      const Attention::Watch watch(attention_, Attention::To::input, longest_row());
      more = image_.work(state_, image_slice, Stop(attention_));
    }
    show_image(more);
  }

  void show_image(bool more) {
    const Preview& now = image_.preview();
    const double every = now.has_every_pixel() ? smoothing_every : image_every;
    if (shown_image_.show(now.revision(), now.size(), now.rgba(), more, every)) frames_due_ = std::max(frames_due_, 1);
  }

  void work_on_costs() {
    // The visible picture comes first.
    if (frames_drawn_ == 0 || !image_.rests(state_) || costs_.rests(state_)) return;
    {
      const Attention::Watch watch(attention_, Attention::To::input, longest_row());
      costs_.work(state_, image_slice, Stop(attention_));
    }
    if (shown_costs_.show(costs_.revision(), costs_.size(), costs_.rgba(), !costs_.rests(state_), image_every))
      frames_due_ = std::max(frames_due_, 1);
  }

  void work_on_structures() {
    // Workers are begun after the first frame, which waits for nothing.
    if (frames_drawn_ > 0 && structures_.serve(state_)) frames_due_ = frames_to_settle;
  }

  // After each turn, and once a second for its clock.
  void show_notes() {
    if (!state_.lessons.notes_window) return notes_.reset();
    if (!notes_) notes_ = std::make_unique<NotesWindow>(window_, fonts_found_);
    if (!notes_->show(state_)) act(action::ShowNotesWindow{false});
  }

  // A picture is taken once all its contents are complete; an animation advances by one frame between polls of events.
  void work_on_export() {
    if (!state_.exports.window || frames_due_ > 0) return;
    if (!animation_ && !(image_.rests(state_) && costs_.rests(state_) && !waits_for_structures())) return;
    Image picture;
    if (state_.exports.window->kind == ExportKind::picture) {
      frame(&picture);
      const auto written = write_image(state_.exports.window->path, picture);
      return act(action::FinishExport{written ? "" : written.error().text()});
    }
    if (!animation_) animation_.emplace(state_);
    act(action::Jump{animation_->position()});
    work_on_structures();
    if (waits_for_structures()) return;
    frame(nullptr, false);
    frame(&picture);
    if (!animation_->take(picture)) finish_animation();
  }

  void finish_animation() {
    const int back = animation_->begun_at();
    const Result<void> written = animation_->write(state_.exports.window->path);
    animation_.reset();
    act(action::Jump{back});
    act(action::FinishExport{written ? "" : written.error().text()});
  }

  // Fonts and spacing for the current scale and theme.
  void rescale() {
    const float now = unit(), density = window_.density();
    if (const bool fitted = shrink() < 1; fitted != state_.appearance.is_fitted)
      update(state_, action::SetFitted{fitted});
    if (now != styled_unit_ || state_.appearance.theme != styled_theme_)
      set_style(ImGui::GetStyle(), state_.appearance.theme, now);
    // Small buttons reach a little beyond their edges for a finger, and not into their neighbours.
    ImGui::GetStyle().TouchExtraPadding = state_.appearance.touch ? ImVec2{2 * now, 4 * now} : ImVec2{0, 0};
    if (now != styled_unit_ || density != fonts_.density || fonts_.text == nullptr) {
      ImGuiIO& io = ImGui::GetIO();
      fonts_ = build_fonts(*io.Fonts, fonts_found_, now, density, state_.appearance.language.others());
      io.FontGlobalScale = 1 / density;
      window_.upload_fonts();
    }
    styled_unit_ = now;
    styled_theme_ = state_.appearance.theme;
  }

  void frame(Image* picture, bool seen = true) {
    rescale();
    --frames_due_;
    window_.begin_frame(!wants_picture() && !state_.exports.window);
    const ImageSize size = image_.preview().size();
    const PictureView shown{shown_image_.texture(),
                            size.width,
                            size.height,
                            image_.preview().done(),
                            image_.preview().has_every_pixel(),
                            image_.preview().finished(),
                            image_.seconds_left(),
                            image_.preview().hottest(),
                            &costs_,
                            shown_costs_.texture(),
                            &gallery_};
    interface_.draw(state_, fonts_, unit(), dpi(), shown);
    const Colour ground = palette(state_.appearance.theme).window;
    if (seen) {
      window_.end_frame(
          {static_cast<float>(ground.r) / 255, static_cast<float>(ground.g) / 255, static_cast<float>(ground.b) / 255},
          picture);
    } else {
      window_.end_frame_unseen();
    }
    if (frames_drawn_++ == 0) first_frame_ = seconds_between(begun_, Clock::now());
    apply();
    // An animation's progress is shown outside of the picture.
    std::string title = document_title(state_);
    if (animation_)
      title = fill("export.animation_progress", state_.appearance.language,
                   {{"frame", animation_->taken() + 1}, {"frames", animation_->frames()}});
    if (title += " \u2013 Raywalk"; title != title_) {
      window_.set_title(title);
      title_ = title;
    }
    if (frames_due_ > 0) return;
    if (!wants_picture()) keep_settings();
    write_report();
  }

  void write_report() {
    if (options_.report_path.empty()) return;
    const ImVec2 extent = ImGui::GetIO().DisplaySize;
    const WindowReport window{frames_drawn_,
                              first_frame_,
                              extent.x,
                              extent.y,
                              patience() != 0 && !state_.walk.playing,
                              ImGui::GetIO().WantTextInput};
    const std::string text = report(state_, interface_, image_.preview(), costs_, dpi(), window);
    if (Result<void> written = write_file_atomically(options_.report_path, text); !written && outcome_) {
      outcome_ = tl::unexpected(written.error());
      state_.document.quit = true;
    }
  }

  Result<void> take_picture() {
    Image picture;
    frames_due_ = 1;
    frame(&picture);
    const Result<void> written = write_image(options_.screenshot_path, picture);
    return written ? outcome_ : written;
  }

  const GuiOptions options_;
  State state_;
  Window& window_;
  Attention& attention_;
  Interface interface_;
  Demo demo_;
  std::optional<WalkAnimation> animation_;  ///< in progress
  LiveImage image_;
  LiveCosts costs_;
  StructureWorkers structures_{platform::workers()};
  ShownPicture shown_image_, shown_costs_;
  GalleryPictures gallery_;
  Clock::time_point begun_, last_ = Clock::now();
  Settings settings_;  ///< as last saved
  FontFiles fonts_found_;
  Fonts fonts_;
  std::unique_ptr<NotesWindow> notes_;  ///< while it is open
  float styled_unit_ = 0;
  Theme styled_theme_ = Theme::dark;
  int frames_due_ = frames_to_settle, frames_drawn_ = 0;
  bool broken_ = false;     ///< closed during a change: the state may be between two others
  bool key_holds_ = false;  ///< STEP or BACK
  int copies_ = 0;          ///< that are in the clipboard
  double first_frame_ = 0, notice_seen_ = 0, tooltip_in_ = -1;
  std::string title_, seen_notice_;
  Result<void> outcome_;
};

Loop::Loop(GuiOptions options, State state, Window& window, Attention& attention, Demo demo,
           std::chrono::steady_clock::time_point begun)
    : parts_(new Parts(std::move(options), std::move(state), window, attention, std::move(demo), begun)) {}

Loop::~Loop() = default;

bool Loop::turn() { return parts_->turn(); }

double Loop::patience() const { return parts_->patience(); }

void Loop::act(const Action& action) { parts_->act_from_outside(action); }

Result<void> Loop::act_by_outline(std::string_view does, std::string_view typed) {
  return parts_->act_by_outline(does, typed);
}

bool Loop::holds_at(float x, float y) const { return parts_->holds_at(x, y); }

bool Loop::types_number() const { return parts_->types_number(); }

void Loop::draw_again() { parts_->draw_again(); }

void Loop::autosave_now() { parts_->autosave_now(); }

const State& Loop::state() const { return parts_->state(); }
CostFindings Loop::costs() const { return parts_->costs(); }

Result<void> Loop::end() { return parts_->end(); }

}  // namespace raywalk
