#pragma once
// The arguments of actions in text form, listed once for reading and writing. Included only by action_text.cpp.

#include "view/action_words.h"

namespace raywalk::action_text {

// The arguments of each action, in order; actions without any need no entry.
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
void arguments(F& f, ShowGhosts& a) {
  f.choice(a.shown, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, SetTweens& a) {
  f.choice(a.on, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, SetImageSettings& a) {
  f.choice(a.settings.accelerator, Words<AcceleratorKind>(accelerator_words));
  f.choice(a.settings.single_precision, Words<bool>(precision_words));
  f.number(a.settings.samples);
  f.number(a.settings.walk_samples);
  f.choice(a.settings.heat, Words<Heat>(heat_words));
  f.maybe_choice(a.settings.integrator, Words<Integrator>(integrator_words));
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
void arguments(F& f, ShowHands& a) {
  f.number(a.choice);
  f.number(a.hands);
}
template <class F>
void arguments(F& f, Export& a) {
  f.rest(a.path);
}
template <class F>
void arguments(F& f, FinishExport& a) {
  f.rest(a.why_not);
}
template <class F>
void arguments(F& f, Wait& a) {
  f.number(a.seconds);
}
template <class F>
void arguments(F& f, SetPredictions& a) {
  f.choice(a.on, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, GuessWay& a) {
  arguments(f, a.towards);
}
template <class F>
void arguments(F& f, GuessEnd& a) {
  arguments(f, a.met);
}
template <class F>
void arguments(F& f, SavePredictions& a) {
  f.rest(a.path);
}
template <class F>
void arguments(F& f, SetLessonOptions& a) {
  f.flag(a.presenter, "presenter");
  f.flag(a.unlocked, "unlocked");
  f.flag(a.without_notes, "without-notes");
}
template <class F>
void arguments(F& f, ShowBugs& a) {
  f.choice(a.shown, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, HuntBug& a) {
  f.number(a.number);
  f.flag(a.surprise, "surprise");
}
template <class F>
void arguments(F& f, MarkLine& a) {
  f.line(a.line);
}
template <class F>
void arguments(F& f, MendBug& a) {
  f.choice(a.mended, Words<bool>(shown_words));
}
template <class F>
void arguments(F& f, SetTheme& a) {
  f.choice(a.theme, Words<Theme>(theme_words));
}
template <class F>
void arguments(F& f, SetLanguage& a) {
  f.rest(a.code);
}
template <class F>
void arguments(F& f, SetUiScale& a) {
  f.number(a.scale);
}
template <class F>
void arguments(F& f, SetTab& a) {
  f.choice(a.tab, Words<Tab>(tab_words));
}
template <class F>
void arguments(F& f, SetNumerics& a) {
  f.choice(a.numerics, Words<Numerics>(numerics_words));
  f.number(a.epsilon);
}
template <class F>
void arguments(F& f, Magnify& a) {
  f.number(a.part);
}
template <class F>
void arguments(F& f, SetCostKnobs& a) {
  f.number(a.knobs.samples);
  f.choice(a.knobs.sampler, Words<Sampler>(sampler_words));
  f.number(a.knobs.light_grid);
  f.number(a.knobs.depth);
  f.number(a.knobs.threshold);
  f.choice(a.knobs.single_precision, Words<bool>(precision_words));
  f.choice(a.knobs.accelerator, Words<AcceleratorKind>(accelerator_words));
  f.number(a.knobs.tolerance);
  f.choice(a.knobs.numerics, Words<Numerics>(numerics_words));
  f.number(a.knobs.epsilon);
}
template <class F>
void arguments(F& f, TryCost& a) {
  f.flag(a.ladder, "ladder");
}
template <class F>
void arguments(F& f, ChooseCost& a) {
  f.number(a.index);
  f.flag(a.against, "against");
}
template <class F>
void arguments(F& f, ShowCosts& a) {
  f.choice(a.picture, Words<CostPicture>(cost_picture_words));
  f.choice(a.axis, Words<study::CostAxis>(cost_axis_words));
  f.number(a.split);
}
template <class F>
void arguments(F& f, ShowCostPage& a) {
  f.choice(a.page, Words<CostPage>(cost_page_words));
}

template <class F>
void arguments(F& f, ChooseStructure& a) {
  f.choice(a.kind, Words<AcceleratorKind>(accelerator_words));
}
template <class F>
void arguments(F& f, ShowStructurePage& a) {
  f.choice(a.page, Words<StructurePage>(structure_page_words));
}
template <class F>
void arguments(F& f, GoInStructure& a) {
  f.number(a.step);
}

}  // namespace raywalk::action_text
