#include "view/action_text.h"

#include <set>
#include <string>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;

TEST_CASE("a line that was written reads back as the same action") {
  using namespace action;
  const std::vector<std::pair<Action, std::string>> lines{
      {SetMode{Mode::trace}, "mode trace"},
      {Step{true, Grain::ray}, "step forward ray"},
      {Step{false, {}}, "step back"},
      {Jump{12}, "jump 12"},
      {JumpToRay{3}, "jump-to-ray 3"},
      {JumpToCell{4}, "jump-to-cell 4"},
      {RunToLine{Line::form_shadow_ray}, "run-to-line 7"},
      {PlayPause{}, "play-pause"},
      {SetSpeed{2.5}, "speed 2.5"},
      {SetGrain{Grain::pixel}, "grain pixel"},
      {Step{true, Grain::over}, "step forward over"},
      {Step{false, Grain::out}, "step back out"},
      {RunOn{false}, "run-on back"},
      {ToggleBreakpoint{Line::form_shadow_ray}, "breakpoint 7"},
      {action::Hold{true}, "hold forward"},
      {Release{}, "let-go"},
      {Clear{}, "clear"},
      {Tick{0.1}, "tick 0.1"},
      {ResizePlan{{640, 480}}, "resize 640 480"},
      {PointerMoved{{1.5, -2}, {true, false, true}}, "pointer 1.5 -2 shift alt"},
      {PointerPressed{{3, 4}, Button::right, {false, true, false}, true}, "press 3 4 right double control"},
      {PointerReleased{{3, 4}, {}}, "release 3 4"},
      {PointerLeft{}, "pointer-left"},
      {CancelDrag{}, "cancel-drag"},
      {Zoom{{1, 2}, 0.5}, "zoom 1 2 0.5"},
      {Pan{{-3, 4}}, "pan -3 4"},
      {FitView{}, "fit"},
      {WalkPixel{3, 4, {63, 47}}, "walk-pixel 3 4 63 47"},
      {WalkStrip{}, "walk-strip"},
      {Orbit{SpaceView::image, {0.5, -0.25}}, "orbit image 0.5 -0.25"},
      {Shift{SpaceView::lines, {0.125, 0.5}}, "shift lines 0.125 0.5"},
      {Approach{SpaceView::image, 1.5}, "approach image 1.5"},
      {ResetView{SpaceView::lines}, "reset-view lines"},
      {UseImageCamera{}, "use-camera"},
      {ShowLines{true}, "lines on"},
      {ShowGhosts{true}, "ghosts on"},
      {SetTweens{true}, "tweens on"},
      {SetImageSettings{{AcceleratorKind::grid, true, 64, Integrator::path, 8, Heat::noise}},
       "image-settings grid float 64 8 noise path"},
      {HoverRay{-1}, "hover-ray -1"},
      {HoverLine{std::nullopt}, "hover-line none"},
      {HoverLine{Line::for_each_pixel}, "hover-line 1"},
      {Select{{TargetKind::corner, 2, 1}}, "select corner 2 1"},
      {AddObject{ObjectKind::transparent_sphere}, "add transparent-sphere"},
      {RemoveSelected{}, "remove"},
      {InsertCorner{1, 2, {0.5, 0.25}}, "insert-corner 1 2 0.5 0.25"},
      {RemoveCorner{1, 2}, "remove-corner 1 2"},
      {Rename{{TargetKind::light, 0, -1}, "North Star"}, "rename light 0 -1 North Star"},
      {Nudge{{1, 0}, true}, "nudge 1 0 coarse"},
      {Undo{}, "undo"},
      {Redo{}, "redo"},
      {New{}, "new"},
      {AskNew{}, "ask-new"},
      {ListLessons{}, "list-lessons"},
      {ShowNotesWindow{true}, "notes-window on"},
      {ShowTreeBeside{false}, "tree-beside off"},
      {ShowFront{Front::lesson}, "front lesson"},
      {ExchangePanes{}, "exchange"},
      {Open{"a file.toml"}, "open a file.toml"},
      {Save{}, "save"},
      {SaveAs{"b.toml"}, "save-as b.toml"},
      {AskOpen{}, "ask-open"},
      {AskSaveAs{}, "ask-save-as"},
      {CancelPrompt{}, "cancel-prompt"},
      {AnswerQuestion{Answer::discard}, "answer discard"},
      {Quit{}, "quit"},
      {SetTheme{Theme::projector}, "theme projector"},
      {SetUiScale{1.25}, "ui-scale 1.25"},
      {SetTab{LegendRoom::tab}, "tab legend"},
      {ShowLessons{true}, "lessons on"},
      {OpenLesson{"05-refraction"}, "open-lesson 05-refraction"},
      {LeaveLesson{}, "leave-lesson"},
      {GoToLessonStep{3}, "lesson-step 3"},
      {GuessChoice{1}, "guess-choice 1"},
      {GuessNumber{41.8}, "guess-number 41.8"},
      {RevealLesson{}, "reveal"},
      {SetLessonOptions{true, false}, "lesson-options presenter"},
      {SetLessonOptions{true, true, true}, "lesson-options presenter unlocked without-notes"},
      {SetLanguage{"pt"}, "language pt"},
      {ShowBugs{true}, "bugs on"},
      {HuntBug{4}, "hunt-bug 4"},
      {HuntBug{2, true}, "hunt-bug 2 surprise"},
      {MarkLine{Line::form_shadow_ray}, "mark-line 7"},
      {JudgeLine{}, "judge-line"},
      {ShowCure{}, "show-cure"},
      {MendBug{true}, "mend-bug on"},
      {LeaveHunt{}, "leave-hunt"},
      {DismissNotice{}, "dismiss"},
      {SetCostKnobs{{8, Sampler::sobol, 2, 4, 0.25, true, AcceleratorKind::grid, 0.5, Numerics::naive, 0.001}},
       "cost-knobs 8 sobol 2 4 0.25 float grid 0.5 naive 0.001"},
      {TryCost{true}, "cost-try ladder"},
      {ForgetCosts{}, "cost-forget"},
      {ChooseCost{2, true}, "cost-choose 2 against"},
      {ShowCosts{CostPicture::difference, study::CostAxis::seconds, 0.25}, "cost-show difference seconds 0.25"},
      {ShowCostPage{CostPage::effects}, "cost-page effects"},
      {SetNumerics{Numerics::naive, 0.001}, "numerics naive 0.001"},
      {SetLimits{{3, 0.25}}, "limits 3 0.25"},
      {StopAt{2, 4, true, -1}, "stop-at 2 4 on -1"},
      {RemoveBreakpoints{}, "remove-breakpoints"},
      {SetLightWays{Subsurface::dipole, true}, "light-ways dipole on"},
      {ChooseStructure{AcceleratorKind::octree}, "structure octree"},
      {ShowStructurePage{StructurePage::build}, "structure-page build"},
      {GoInStructure{7}, "structure-go 7"},
      {Magnify{0.5}, "magnify 0.5"},
      {ShowHands{1, -2}, "hands 1 -2"},
      {SetPredictions{true}, "predictions on"},
      {GuessWay{{1.5, -2}}, "guess-way 1.5 -2"},
      {GuessAngle{22.5}, "guess-angle 22.5"},
      {TurnGuess{-5}, "turn-guess -5"},
      {NextGuess{-1}, "next-guess -1"},
      {ChooseLesson{2}, "choose-lesson 2"},
      {ChooseBug{-1}, "choose-bug -1"},
      {GuessEnd{{TargetKind::object, 2, -1}}, "guess-end object 2 -1"},
      {AskSavePredictions{}, "ask-save-predictions"},
      {SavePredictions{"a file.csv"}, "save-predictions a file.csv"},
      {AskExport{}, "ask-export"},
      {Export{"a walk.gif"}, "export a walk.gif"},
      {FinishExport{"no room"}, "finish-export no room"},
      {Wait{0.5}, "wait 0.5"},
      {SetLiveRays{LiveRays::strip}, "live-rays strip"},
      {ChooseLiveCell{4}, "live-cell 4"},
      {ShowEarlier{Earlier::hidden}, "earlier hidden"},
      {ShowRays{RayKind::shadow, false}, "rays shadow off"},
      {SetFocus{true}, "focus on"},
      {ShowBand{true}, "band on"},
      {ShowPencils{true}, "pencils on"},
      {ShowNeighbours{true}, "neighbours on"},
      {ShowEffects{true}, "effects on"},
      {SwitchEffect{Effect::shadows, false}, "effect shadows off"},
      {LimitDepth{3}, "depth 3"},
      {SetInk{true}, "ink on"},
      {ChooseInkTool{InkTool::protractor}, "ink-tool protractor"},
      {ChooseInkColour{InkColour::green}, "ink-colour green"},
      {TypeInk{"n = 1.5"}, "ink-type n = 1.5"},
      {FinishInk{}, "ink-finish"},
      {LeaveInk{}, "ink-leave"},
      {ClearInk{}, "ink-clear"},
      {KeepInk{true}, "ink-keep on"},
      {SetEnglishCode{true}, "english-code on"},
      {SetTouch{true}, "touch on"},
      {SetFitted{true}, "fitted on"},
      {CopyLink{}, "copy-link"},
      {ShowLink{true}, "show-link on"},
      {SetLinkPage{"https://a.example/"}, "link-page https://a.example/"},
      {OpenLink{"#v=1/scene=glass"}, "open-link #v=1/scene=glass"},
  };
  for (const auto& [action, line] : lines) {
    INFO(line);
    CHECK(write_action(action) == line);
    const Result<Action> read = parse_action(line);
    REQUIRE(read.has_value());
    CHECK(read->kind() == action.kind());
    CHECK(write_action(*read) == line);
  }
  CHECK(lines.size() > action_kinds - 6);
}

TEST_CASE("numbers keep their last bit") {
  const Result<Action> read = parse_action(write_action(action::SetSpeed{0.1 + 0.2}));
  REQUIRE(read.has_value());
  CHECK(read->as<action::SetSpeed>()->lines_per_second == 0.1 + 0.2);
}

TEST_CASE("a whole value has no line") { CHECK(write_action(action::SetMaterial{0, Material{}}).empty()); }

TEST_CASE("a line that is none says what was expected") {
  const auto message = [](const std::string& line) {
    const Result<Action> read = parse_action(line);
    INFO(line);
    REQUIRE_FALSE(read.has_value());
    return read.error().message;
  };
  CHECK_THAT(message("stride forward"), raywalk::test::contains("'stride' is no action"));
  CHECK_THAT(message(""), raywalk::test::contains("no action"));
  CHECK_THAT(message("mode fly"), raywalk::test::contains("one of move, trace, help"));
  CHECK_THAT(message("jump"), raywalk::test::contains("the line ends where a whole number"));
  CHECK_THAT(message("jump 1.5"), raywalk::test::contains("'1.5' stands where a whole number"));
  CHECK_THAT(message("jump 99999999999"), raywalk::test::contains("a whole number"));
  CHECK_THAT(message("speed fast"), raywalk::test::contains("a number"));
  CHECK_THAT(message("run-to-line 999"), raywalk::test::contains("from 1 to "));
  CHECK_THAT(message("undo twice"), raywalk::test::contains("nothing more"));
  CHECK_THAT(message("open"), raywalk::test::contains("a text"));
}

TEST_CASE("the list of actions names each that can be read, once, with its arguments") {
  const std::string help = demo_help();
  const std::string list = help.substr(help.find("\n\n") + 2);
  std::set<std::string> words;
  for (std::size_t at = 0; at < list.size(); at = list.find('\n', at) + 1) {
    const std::string line = list.substr(at, list.find('\n', at) - at), word = line.substr(0, line.find(' '));
    INFO(line);
    CHECK(words.insert(word).second);
    // What stands alone is read alone; what wants more says so, and no longer that there is no such action.
    const Result<Action> alone = parse_action(word);
    const bool wants_more = line.find_first_of("|ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string::npos;
    if (!wants_more || line.find('[') == word.size() + 1) CHECK(alone.has_value());
    if (!alone) CHECK(alone.error().message.find("is no action") == std::string::npos);
  }
  CHECK(words.size() > 60);
  CHECK_THAT(list, test::contains("step forward|back [line|ray|pixel|") && test::contains("\ntheme dark|projector\n"));
}

TEST_CASE("a demo is a list of lines with comments; errors name file and line") {
  const auto demo = parse_demo("# a walk\n\nstep forward\r\n  step back  \nopen my#file.toml", "walk.demo");
  REQUIRE(demo.has_value());
  REQUIRE(demo->size() == 3);
  CHECK((*demo)[2].as<action::Open>()->path == "my#file.toml");
  const auto bad = parse_demo("step forward\n\nhop\n", "walk.demo");
  REQUIRE_FALSE(bad.has_value());
  CHECK(bad.error().file == "walk.demo");
  CHECK(bad.error().line == 3);
  CHECK(parse_demo("", "empty").has_value());
}
