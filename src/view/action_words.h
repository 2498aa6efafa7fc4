#pragma once
// The words and arguments of actions as lines of text, each named once for reading and writing. Included by
// action_text.cpp alone.

#include "view/action.h"

#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace raywalk::action_text {

using namespace action;

// The words of each choice, once, for reading and writing.
template <class Value>
using Words = std::span<const std::pair<Value, std::string_view>>;

inline constexpr std::pair<Mode, std::string_view> mode_words[] = {
    {Mode::move, "move"}, {Mode::trace, "trace"}, {Mode::help, "help"}};
inline constexpr std::pair<Grain, std::string_view> grain_words[] = {
    {Grain::line, "line"}, {Grain::ray, "ray"}, {Grain::pixel, "pixel"}, {Grain::over, "over"}, {Grain::out, "out"}};
inline constexpr std::pair<bool, std::string_view> direction_words[] = {{true, "forward"}, {false, "back"}};
inline constexpr std::pair<Button, std::string_view> button_words[] = {
    {Button::left, "left"}, {Button::middle, "middle"}, {Button::right, "right"}};
inline constexpr std::pair<Tab, std::string_view> tab_words[] = {{Tab::image, "image"},
                                                                 {Tab::tree, "tree"},
                                                                 {Tab::stack, "stack"},
                                                                 {Tab::legend, "legend"},
                                                                 {Tab::equation, "equation"}};
inline constexpr std::pair<Theme, std::string_view> theme_words[] = {{Theme::dark, "dark"},
                                                                     {Theme::projector, "projector"}};
inline constexpr std::pair<Answer, std::string_view> answer_words[] = {
    {Answer::save, "save"}, {Answer::discard, "discard"}, {Answer::recover, "recover"}, {Answer::cancel, "cancel"}};
inline constexpr std::pair<ObjectKind, std::string_view> object_words[] = {
    {ObjectKind::solid_sphere, "solid-sphere"},
    {ObjectKind::transparent_sphere, "transparent-sphere"},
    {ObjectKind::polygon, "polygon"},
    {ObjectKind::light, "light"}};
inline constexpr std::pair<TargetKind, std::string_view> target_words[] = {
    {TargetKind::nothing, "nothing"},
    {TargetKind::eye, "eye"},
    {TargetKind::view_direction, "view-direction"},
    {TargetKind::screen_height, "screen-height"},
    {TargetKind::screen_distance, "screen-distance"},
    {TargetKind::cell, "cell"},
    {TargetKind::object, "object"},
    {TargetKind::radius, "radius"},
    {TargetKind::corner, "corner"},
    {TargetKind::edge, "edge"},
    {TargetKind::rotation, "rotation"},
    {TargetKind::light, "light"},
    {TargetKind::ray, "ray"},
};

inline constexpr std::pair<SpaceView, std::string_view> view_words[] = {{SpaceView::image, "image"},
                                                                        {SpaceView::lines, "lines"}};
inline constexpr std::pair<bool, std::string_view> shown_words[] = {{true, "on"}, {false, "off"}};

/// What a demo line of each action begins with; empty for those that no line can hold.
template <class A>
inline constexpr std::string_view word_of = "";
template <>
inline constexpr std::string_view word_of<SetMode> = "mode";
template <>
inline constexpr std::string_view word_of<Step> = "step";
template <>
inline constexpr std::string_view word_of<Jump> = "jump";
template <>
inline constexpr std::string_view word_of<JumpToRay> = "jump-to-ray";
template <>
inline constexpr std::string_view word_of<JumpToCell> = "jump-to-cell";
template <>
inline constexpr std::string_view word_of<RunToLine> = "run-to-line";
template <>
inline constexpr std::string_view word_of<RunOn> = "run-on";
template <>
inline constexpr std::string_view word_of<ToggleBreakpoint> = "breakpoint";
template <>
inline constexpr std::string_view word_of<action::Hold> = "hold";
template <>
inline constexpr std::string_view word_of<Release> = "let-go";
template <>
inline constexpr std::string_view word_of<PlayPause> = "play-pause";
template <>
inline constexpr std::string_view word_of<SetSpeed> = "speed";
template <>
inline constexpr std::string_view word_of<SetGrain> = "grain";
template <>
inline constexpr std::string_view word_of<Clear> = "clear";
template <>
inline constexpr std::string_view word_of<Tick> = "tick";
template <>
inline constexpr std::string_view word_of<ResizePlan> = "resize";
template <>
inline constexpr std::string_view word_of<PointerMoved> = "pointer";
template <>
inline constexpr std::string_view word_of<PointerPressed> = "press";
template <>
inline constexpr std::string_view word_of<PointerReleased> = "release";
template <>
inline constexpr std::string_view word_of<PointerLeft> = "pointer-left";
template <>
inline constexpr std::string_view word_of<CancelDrag> = "cancel-drag";
template <>
inline constexpr std::string_view word_of<Zoom> = "zoom";
template <>
inline constexpr std::string_view word_of<Pan> = "pan";
template <>
inline constexpr std::string_view word_of<FitView> = "fit";
template <>
inline constexpr std::string_view word_of<WalkPixel> = "walk-pixel";
template <>
inline constexpr std::string_view word_of<WalkStrip> = "walk-strip";
template <>
inline constexpr std::string_view word_of<Orbit> = "orbit";
template <>
inline constexpr std::string_view word_of<Shift> = "shift";
template <>
inline constexpr std::string_view word_of<Approach> = "approach";
template <>
inline constexpr std::string_view word_of<ResetView> = "reset-view";
template <>
inline constexpr std::string_view word_of<UseImageCamera> = "use-camera";
template <>
inline constexpr std::string_view word_of<ShowLines> = "lines";
template <>
inline constexpr std::string_view word_of<HoverRay> = "hover-ray";
template <>
inline constexpr std::string_view word_of<HoverLine> = "hover-line";
template <>
inline constexpr std::string_view word_of<Select> = "select";
template <>
inline constexpr std::string_view word_of<AddObject> = "add";
template <>
inline constexpr std::string_view word_of<RemoveSelected> = "remove";
template <>
inline constexpr std::string_view word_of<InsertCorner> = "insert-corner";
template <>
inline constexpr std::string_view word_of<RemoveCorner> = "remove-corner";
template <>
inline constexpr std::string_view word_of<Rename> = "rename";
template <>
inline constexpr std::string_view word_of<Nudge> = "nudge";
template <>
inline constexpr std::string_view word_of<Undo> = "undo";
template <>
inline constexpr std::string_view word_of<Redo> = "redo";
template <>
inline constexpr std::string_view word_of<New> = "new";
template <>
inline constexpr std::string_view word_of<Open> = "open";
template <>
inline constexpr std::string_view word_of<Save> = "save";
template <>
inline constexpr std::string_view word_of<SaveAs> = "save-as";
template <>
inline constexpr std::string_view word_of<AskOpen> = "ask-open";
template <>
inline constexpr std::string_view word_of<AskSaveAs> = "ask-save-as";
template <>
inline constexpr std::string_view word_of<CancelPrompt> = "cancel-prompt";
template <>
inline constexpr std::string_view word_of<AnswerQuestion> = "answer";
template <>
inline constexpr std::string_view word_of<Quit> = "quit";
template <>
inline constexpr std::string_view word_of<SetTheme> = "theme";
template <>
inline constexpr std::string_view word_of<SetUiScale> = "ui-scale";
template <>
inline constexpr std::string_view word_of<SetTab> = "tab";
template <>
inline constexpr std::string_view word_of<DismissNotice> = "dismiss";
template <>
inline constexpr std::string_view word_of<ShowLessons> = "lessons";
template <>
inline constexpr std::string_view word_of<OpenLesson> = "open-lesson";
template <>
inline constexpr std::string_view word_of<LeaveLesson> = "leave-lesson";
template <>
inline constexpr std::string_view word_of<GoToLessonStep> = "lesson-step";
template <>
inline constexpr std::string_view word_of<GuessChoice> = "guess-choice";
template <>
inline constexpr std::string_view word_of<GuessNumber> = "guess-number";
template <>
inline constexpr std::string_view word_of<RevealLesson> = "reveal";
template <>
inline constexpr std::string_view word_of<SetLessonOptions> = "lesson-options";

// The arguments of each action, in the order of the line; actions without any need no entry.
template <class F, class A>
void arguments(F&, A&) {}
template <class F>
void arguments(F& f, SetMode& a) {
  f.choice(a.mode, Words<Mode>(mode_words));
}
template <class F>
void arguments(F& f, Step& a) {
  f.choice(a.forward, Words<bool>(direction_words));
  f.maybe_choice(a.grain, Words<Grain>(grain_words));
}
template <class F>
void arguments(F& f, Jump& a) {
  f.number(a.position);
}
template <class F>
void arguments(F& f, JumpToRay& a) {
  f.number(a.ray);
}
template <class F>
void arguments(F& f, JumpToCell& a) {
  f.number(a.cell);
}
template <class F>
void arguments(F& f, RunToLine& a) {
  f.line(a.line);
}
template <class F>
void arguments(F& f, RunOn& a) {
  f.choice(a.forward, Words<bool>(direction_words));
}
template <class F>
void arguments(F& f, ToggleBreakpoint& a) {
  f.line(a.line);
}
template <class F>
void arguments(F& f, action::Hold& a) {
  f.choice(a.forward, Words<bool>(direction_words));
}
template <class F>
void arguments(F& f, SetSpeed& a) {
  f.number(a.lines_per_second);
}
template <class F>
void arguments(F& f, SetGrain& a) {
  f.choice(a.grain, Words<Grain>(grain_words));
}
template <class F>
void arguments(F& f, Tick& a) {
  f.number(a.seconds);
}
template <class F>
void arguments(F& f, ResizePlan& a) {
  f.number(a.viewport.width);
  f.number(a.viewport.height);
}
template <class F>
void arguments(F& f, Vec2d& at) {
  f.number(at.x);
  f.number(at.y);
}
template <class F>
void arguments(F& f, Modifiers& a) {
  f.flag(a.shift, "shift");
  f.flag(a.control, "control");
  f.flag(a.alt, "alt");
}
template <class F>
void arguments(F& f, PointerMoved& a) {
  arguments(f, a.at);
  arguments(f, a.modifiers);
}
template <class F>
void arguments(F& f, PointerPressed& a) {
  arguments(f, a.at);
  f.choice(a.button, Words<Button>(button_words));
  f.flag(a.double_click, "double");
  arguments(f, a.modifiers);
}
template <class F>
void arguments(F& f, PointerReleased& a) {
  arguments(f, a.at);
  arguments(f, a.modifiers);
}
template <class F>
void arguments(F& f, Zoom& a) {
  arguments(f, a.at);
  f.number(a.factor);
}
template <class F>
void arguments(F& f, Pan& a) {
  arguments(f, a.by);
}
template <class F>
void arguments(F& f, WalkPixel& a) {
  f.number(a.column);
  f.number(a.row);
  f.number(a.size.width);
  f.number(a.size.height);
}
template <class F>
void arguments(F& f, Orbit& a) {
  f.choice(a.view, Words<SpaceView>(view_words));
  arguments(f, a.angles);
}
template <class F>
void arguments(F& f, Shift& a) {
  f.choice(a.view, Words<SpaceView>(view_words));
  arguments(f, a.parts);
}
template <class F>
void arguments(F& f, Approach& a) {
  f.choice(a.view, Words<SpaceView>(view_words));
  f.number(a.factor);
}
template <class F>
void arguments(F& f, ResetView& a) {
  f.choice(a.view, Words<SpaceView>(view_words));
}
template <class F>
void arguments(F& f, ShowLines& a) {
  f.choice(a.shown, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, HoverRay& a) {
  f.number(a.ray);
}
template <class F>
void arguments(F& f, HoverLine& a) {
  f.maybe_line(a.line);
}
template <class F>
void arguments(F& f, Target& a) {
  f.choice(a.kind, Words<TargetKind>(target_words));
  f.number(a.index);
  f.number(a.part);
}
template <class F>
void arguments(F& f, Select& a) {
  arguments(f, a.target);
}
template <class F>
void arguments(F& f, AddObject& a) {
  f.choice(a.kind, Words<ObjectKind>(object_words));
}
template <class F>
void arguments(F& f, InsertCorner& a) {
  f.number(a.object);
  f.number(a.edge);
  arguments(f, a.at);
}
template <class F>
void arguments(F& f, RemoveCorner& a) {
  f.number(a.object);
  f.number(a.corner);
}
template <class F>
void arguments(F& f, Rename& a) {
  arguments(f, a.target);
  f.rest(a.name);
}
template <class F>
void arguments(F& f, Nudge& a) {
  arguments(f, a.direction);
  f.flag(a.coarse, "coarse");
}
template <class F>
void arguments(F& f, Open& a) {
  f.rest(a.path);
}
template <class F>
void arguments(F& f, SaveAs& a) {
  f.rest(a.path);
}
template <class F>
void arguments(F& f, AnswerQuestion& a) {
  f.choice(a.answer, Words<Answer>(answer_words));
}
template <class F>
void arguments(F& f, ShowLessons& a) {
  f.choice(a.shown, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, OpenLesson& a) {
  f.rest(a.name);
}
template <class F>
void arguments(F& f, GoToLessonStep& a) {
  f.number(a.step);
}
template <class F>
void arguments(F& f, GuessChoice& a) {
  f.number(a.choice);
}
template <class F>
void arguments(F& f, GuessNumber& a) {
  f.number(a.number);
}
template <class F>
void arguments(F& f, SetLessonOptions& a) {
  f.flag(a.presenter, "presenter");
  f.flag(a.unlocked, "unlocked");
  f.rest(a.language);
}
template <class F>
void arguments(F& f, SetTheme& a) {
  f.choice(a.theme, Words<Theme>(theme_words));
}
template <class F>
void arguments(F& f, SetUiScale& a) {
  f.number(a.scale);
}
template <class F>
void arguments(F& f, SetTab& a) {
  f.choice(a.tab, Words<Tab>(tab_words));
}

}  // namespace raywalk::action_text
