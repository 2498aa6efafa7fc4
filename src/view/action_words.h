#pragma once
// The words of actions in text form, listed once for reading and writing. Included only by action_text.cpp.

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
inline constexpr std::pair<Tab, std::string_view> tab_words[] = {
    {Tab::image, "image"}, {Tab::tree, "tree"},         {Tab::stack, "stack"},           {Tab::legend, "legend"},
    {Tab::cost, "cost"},   {Tab::equation, "equation"}, {Tab::microscope, "microscope"}, {Tab::structure, "structure"}};
inline constexpr std::pair<CostPicture, std::string_view> cost_picture_words[] = {
    {CostPicture::split, "split"}, {CostPicture::difference, "difference"}};
inline constexpr std::pair<Heat, std::string_view> heat_words[] = {{Heat::none, "picture"},
                                                                   {Heat::rays, "rays"},
                                                                   {Heat::tests, "tests"},
                                                                   {Heat::time, "time"},
                                                                   {Heat::noise, "noise"}};
inline constexpr std::pair<Integrator, std::string_view> integrator_words[] = {
    {Integrator::automatic, integrator_name(Integrator::automatic)},
    {Integrator::cast, integrator_name(Integrator::cast)},
    {Integrator::whitted, integrator_name(Integrator::whitted)},
    {Integrator::distributed, integrator_name(Integrator::distributed)},
    {Integrator::path, integrator_name(Integrator::path)}};
inline constexpr std::pair<CostPage, std::string_view> cost_page_words[] = {{CostPage::tries, "tries"},
                                                                            {CostPage::effects, "effects"}};
inline constexpr std::pair<study::CostAxis, std::string_view> cost_axis_words[] = {
    {study::CostAxis::rays, "rays"}, {study::CostAxis::tests, "tests"}, {study::CostAxis::seconds, "seconds"}};
inline constexpr std::pair<Sampler, std::string_view> sampler_words[] = {
    {Sampler::random, "random"}, {Sampler::jittered, "jittered"}, {Sampler::sobol, "sobol"}};
inline constexpr std::pair<bool, std::string_view> precision_words[] = {{true, "float"}, {false, "double"}};
inline constexpr std::pair<Numerics, std::string_view> numerics_words[] = {
    {Numerics::robust, numerics_name(Numerics::robust)}, {Numerics::naive, numerics_name(Numerics::naive)}};
inline constexpr std::pair<AcceleratorKind, std::string_view> accelerator_words[] = {
    {AcceleratorKind::automatic, "automatic"}, {AcceleratorKind::none, "none"},
    {AcceleratorKind::spheres, "spheres"},     {AcceleratorKind::ellipsoids, "ellipsoids"},
    {AcceleratorKind::boxes, "boxes"},         {AcceleratorKind::bvh, "bvh"},
    {AcceleratorKind::grid, "grid"},           {AcceleratorKind::octree, "octree"},
    {AcceleratorKind::kdtree, "kdtree"}};
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
inline constexpr std::pair<StructurePage, std::string_view> structure_page_words[] = {{StructurePage::search, "search"},
                                                                                      {StructurePage::build, "build"}};
inline constexpr std::pair<bool, std::string_view> shown_words[] = {{true, "on"}, {false, "off"}};

/// The first word of each action; empty for those without text form.
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
inline constexpr std::string_view word_of<ShowGhosts> = "ghosts";
template <>
inline constexpr std::string_view word_of<SetTweens> = "tweens";
template <>
inline constexpr std::string_view word_of<SetImageSettings> = "image-settings";
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
inline constexpr std::string_view word_of<SetLanguage> = "language";
template <>
inline constexpr std::string_view word_of<SetUiScale> = "ui-scale";
template <>
inline constexpr std::string_view word_of<SetTab> = "tab";
template <>
inline constexpr std::string_view word_of<DismissNotice> = "dismiss";
template <>
inline constexpr std::string_view word_of<SetCostKnobs> = "cost-knobs";
template <>
inline constexpr std::string_view word_of<TryCost> = "cost-try";
template <>
inline constexpr std::string_view word_of<ForgetCosts> = "cost-forget";
template <>
inline constexpr std::string_view word_of<ChooseCost> = "cost-choose";
template <>
inline constexpr std::string_view word_of<ShowCosts> = "cost-show";
template <>
inline constexpr std::string_view word_of<ShowCostPage> = "cost-page";
template <>
inline constexpr std::string_view word_of<SetNumerics> = "numerics";
template <>
inline constexpr std::string_view word_of<Magnify> = "magnify";
template <>
inline constexpr std::string_view word_of<ChooseStructure> = "structure";
template <>
inline constexpr std::string_view word_of<ShowStructurePage> = "structure-page";
template <>
inline constexpr std::string_view word_of<GoInStructure> = "structure-go";
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
inline constexpr std::string_view word_of<ShowHands> = "hands";
template <>
inline constexpr std::string_view word_of<SetLessonOptions> = "lesson-options";
template <>
inline constexpr std::string_view word_of<ShowBugs> = "bugs";
template <>
inline constexpr std::string_view word_of<HuntBug> = "hunt-bug";
template <>
inline constexpr std::string_view word_of<MarkLine> = "mark-line";
template <>
inline constexpr std::string_view word_of<JudgeLine> = "judge-line";
template <>
inline constexpr std::string_view word_of<ShowCure> = "show-cure";
template <>
inline constexpr std::string_view word_of<MendBug> = "mend-bug";
template <>
inline constexpr std::string_view word_of<LeaveHunt> = "leave-hunt";
template <>
inline constexpr std::string_view word_of<AskExport> = "ask-export";
template <>
inline constexpr std::string_view word_of<Export> = "export";
template <>
inline constexpr std::string_view word_of<FinishExport> = "finish-export";
template <>
inline constexpr std::string_view word_of<Wait> = "wait";
template <>
inline constexpr std::string_view word_of<SetPredictions> = "predictions";
template <>
inline constexpr std::string_view word_of<GuessWay> = "guess-way";
template <>
inline constexpr std::string_view word_of<GuessEnd> = "guess-end";
template <>
inline constexpr std::string_view word_of<AskSavePredictions> = "ask-save-predictions";
template <>
inline constexpr std::string_view word_of<SavePredictions> = "save-predictions";

}  // namespace raywalk::action_text
