// Every button, menu entry and key asks for what it says.

#include <imgui_internal.h>

#include <set>

#include "gui/bench.h"
#include "gui/command.h"
#include "gui/fonts.h"
#include "gui/layout.h"
#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Presses a button of which nothing but what it asks for matters, and returns the one action.
template <class Kind>
Kind asked_by(Bench& bench, const std::string& item) {
  bench.obedient = false;
  bench.forget();
  bench.click(item);
  CAPTURE(item);
  const Kind* found = bench.last<Kind>();
  REQUIRE(found != nullptr);
  return *found;
}

State at(int position, Mode mode = Mode::trace) {
  State state = classic();
  update(state, action::Jump{position});
  update(state, action::SetMode{mode});
  return state;
}

// Opens a menu and one of its entries.
void choose(Bench& bench, const std::string& menu, const std::string& entry) {
  bench.click(menu);
  bench.click("menu/" + entry);
}

template <class Kind>
const Kind* chosen_from(Bench& bench, const std::string& menu, const std::string& entry) {
  bench.obedient = false;
  bench.forget();
  choose(bench, menu, entry);
  return bench.last<Kind>();
}

}  // namespace

TEST_CASE("the buttons of the walk") {
  Bench bench(at(40));
  CHECK(asked_by<action::Step>(bench, "step").forward);
  CHECK_FALSE(asked_by<action::Step>(bench, "step-back").forward);
  asked_by<action::PlayPause>(bench, "play");
  asked_by<action::Clear>(bench, "clear");
  CHECK(asked_by<action::Jump>(bench, "first").position == 0);
  CHECK(asked_by<action::Jump>(bench, "last").position == bench.state.walk.timeline->steps());
  CHECK(asked_by<action::SetGrain>(bench, "grain-line").grain == Grain::line);
  CHECK(asked_by<action::SetGrain>(bench, "grain-ray").grain == Grain::ray);
  CHECK(asked_by<action::SetGrain>(bench, "grain-pixel").grain == Grain::pixel);
  CHECK(asked_by<action::SetSpeed>(bench, "slower").lines_per_second == bench.state.walk.lines_per_second / 2);
  CHECK(asked_by<action::SetSpeed>(bench, "faster").lines_per_second == bench.state.walk.lines_per_second * 2);
}

TEST_CASE("the buttons of the modes and tabs") {
  Bench bench(at(40));
  CHECK(asked_by<action::SetMode>(bench, "mode-move").mode == Mode::move);
  CHECK(asked_by<action::SetMode>(bench, "mode-trace").mode == Mode::trace);
  CHECK(asked_by<action::SetMode>(bench, "mode-help").mode == Mode::help);
  CHECK(asked_by<action::SetTab>(bench, "tab-image").tab == PictureRoom::tab);
  CHECK(asked_by<action::SetTab>(bench, "tab-tree").tab == TreeRoom::tab);
  CHECK(asked_by<action::SetTab>(bench, "tab-stack").tab == StackRoom::tab);
  CHECK(asked_by<action::SetTab>(bench, "tab-legend").tab == LegendRoom::tab);
  CHECK(asked_by<action::SetTab>(bench, "tab-cost").tab == CostRoom::tab);
  CHECK(asked_by<action::SetTab>(bench, "tab-equation").tab == EquationRoom::tab);
}

TEST_CASE("the buttons of Move mode") {
  Bench bench(at(0, Mode::move));
  using action::ObjectKind;
  CHECK(asked_by<action::AddObject>(bench, "add-solid-sphere").kind == ObjectKind::solid_sphere);
  CHECK(asked_by<action::AddObject>(bench, "add-transparent-sphere").kind == ObjectKind::transparent_sphere);
  CHECK(asked_by<action::AddObject>(bench, "add-polygon").kind == ObjectKind::polygon);
  CHECK(asked_by<action::AddObject>(bench, "add-light").kind == ObjectKind::light);

  bench.obedient = true;
  bench.click("add-polygon");
  bench.click("undo");
  CHECK(bench.last<action::Undo>() != nullptr);
  bench.click("redo");
  CHECK(bench.last<action::Redo>() != nullptr);
  update(bench.state, action::Select{{TargetKind::object, 0}});
  bench.frames(2);
  asked_by<action::RemoveSelected>(bench, "remove");
  CHECK_FALSE(asked_by<action::Select>(bench, "deselect").target);
}

TEST_CASE("the entries of the menus") {
  Bench bench(at(40, Mode::move));
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  update(bench.state, action::Undo{});
  update(bench.state, action::Select{{TargetKind::object, 0}});
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  bench.state.document.redo.push_back(std::make_shared<const Undone>(bench.state.scene()));
  bench.state.appearance.ui_scale = 1.5;
  bench.frames(2);

  CHECK(chosen_from<action::AskNew>(bench, "menu-file", "new") != nullptr);
  CHECK(chosen_from<action::AskOpen>(bench, "menu-file", "open") != nullptr);
  CHECK(chosen_from<action::Save>(bench, "menu-file", "save") != nullptr);
  CHECK(chosen_from<action::AskSaveAs>(bench, "menu-file", "save-as") != nullptr);
  CHECK(chosen_from<action::Quit>(bench, "menu-file", "quit") != nullptr);
  CHECK(chosen_from<action::Undo>(bench, "menu-edit", "undo") != nullptr);
  CHECK(chosen_from<action::Redo>(bench, "menu-edit", "redo") != nullptr);
  CHECK(chosen_from<action::RemoveSelected>(bench, "menu-edit", "remove") != nullptr);
  CHECK(chosen_from<action::Select>(bench, "menu-edit", "select-next") != nullptr);
  CHECK(chosen_from<action::Select>(bench, "menu-edit", "select-previous") != nullptr);
  CHECK(chosen_from<action::FitView>(bench, "menu-view", "fit") != nullptr);
  CHECK(chosen_from<action::Zoom>(bench, "menu-view", "zoom-in")->factor > 1);
  CHECK(chosen_from<action::Zoom>(bench, "menu-view", "zoom-out")->factor < 1);
  CHECK(chosen_from<action::SetTheme>(bench, "menu-view", "theme")->theme == Theme::projector);
  CHECK(chosen_from<action::SetUiScale>(bench, "menu-view", "scale-up")->scale == 1.75);
  CHECK(chosen_from<action::SetUiScale>(bench, "menu-view", "scale-down")->scale == 1.25);
  CHECK(chosen_from<action::SetUiScale>(bench, "menu-view", "scale-reset")->scale == 1);
  CHECK(chosen_from<action::Step>(bench, "menu-walk", "step-ray")->grain == Grain::ray);
  CHECK(chosen_from<action::Step>(bench, "menu-walk", "step-pixel-back")->grain == Grain::pixel);
  choose(bench, "menu-view", "full-screen");
  CHECK(bench.interface().take_full_screen());
}

TEST_CASE("F10 opens one menu after the other") {
  Bench bench(at(0, Mode::move));
  bench.frames(2);
  for (const std::string entry : {"menu/open", "menu/undo", "menu/fit", "menu/step", "menu/magnify", "menu/open"}) {
    bench.key("F10");
    CAPTURE(entry);
    CHECK(bench.has(entry));
  }
}

TEST_CASE("arrows go from one open menu to its neighbours") {
  Bench bench(at(0, Mode::move));
  bench.frames(2);
  const auto arrow = [&](const std::string& key, ImGuiKey_ nav) {
    bench.hold(nav, true);
    bench.key(key);
    bench.hold(nav, false);
  };
  bench.key("F10");
  REQUIRE(bench.has("menu/open"));
  arrow("Left", ImGuiKey_LeftArrow);
  CHECK(bench.has("menu/magnify"));
  arrow("Right", ImGuiKey_RightArrow);
  CHECK(bench.has("menu/open"));
  arrow("Right", ImGuiKey_RightArrow);
  CHECK(bench.has("menu/undo"));
}

TEST_CASE("a menu that fits below its bar does not scroll, at any scale") {
  for (const float unit : {0.90625f, 0.96875f, 1.0f, 1.25f}) {
    Bench bench(at(0, Mode::move), 400 * unit, 844);
    bench.unit = bench.dpi = unit;
    for (int menu = 0; menu < menu_count; ++menu) {
      bench.key("F10");
      int open = 0;
      for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        if (!each->Active || (each->Flags & ImGuiWindowFlags_Popup) == 0) continue;
        CAPTURE(unit, menu, each->Size.x, each->Size.y);
        CHECK_FALSE(each->ScrollbarY);
        ++open;
      }
      CHECK(open == 1);
    }
  }
}

TEST_CASE("a recent file is opened from its menu") {
  Bench bench(at(0, Mode::move));
  bench.state.document.recent = {"/somewhere/a.toml", "/somewhere/b.toml"};
  bench.obedient = false;
  bench.click("menu-file");
  bench.click("menu/recent");
  bench.click("menu/recent/1");
  const auto* open = bench.last<action::Open>();
  REQUIRE(open != nullptr);
  CHECK(open->path == "/somewhere/b.toml");
}

TEST_CASE("what cannot be asked for is shown so and asks for nothing") {
  Bench bench(at(0, Mode::trace));
  bench.obedient = false;
  for (const std::string item : {"step-back", "clear", "first", "undo", "redo"}) {
    bench.forget();
    bench.click(item);
    CAPTURE(item);
    CHECK(bench.last<action::Step>() == nullptr);
    CHECK(bench.last<action::Clear>() == nullptr);
    CHECK(bench.last<action::Jump>() == nullptr);
    CHECK(bench.last<action::Undo>() == nullptr);
    CHECK(bench.last<action::Redo>() == nullptr);
  }
}

TEST_CASE("what is drawn smaller already is not made larger") {
  State state = classic();
  CHECK(enabled(command("scale-up"), state));
  update(state, action::SetFitted{true});
  CHECK_FALSE(enabled(command("scale-up"), state));
  update(state, action::SetFitted{false});
  CHECK(enabled(command("scale-up"), state));
}

TEST_CASE("every command has a name, a label and a hint of its own") {
  const State state = classic();
  std::set<std::string> names, hints;
  for (const Command* each : commands()) {
    CAPTURE(each->name);
    CHECK_FALSE(each->name.empty());
    CHECK_FALSE(command_label(*each, state).empty());
    CHECK_FALSE(command_hint(*each, in_english).empty());
    CHECK(names.insert(std::string(each->name)).second);
    CHECK(hints.insert(command_hint(*each, in_english)).second);
  }
}

TEST_CASE("AUTO is called PAUSE while it runs") {
  State state = classic();
  const std::string at_rest = command_label(command("play"), state);
  update(state, action::PlayPause{});
  REQUIRE(state.walk.playing);
  CHECK(command_label(command("play"), state) != at_rest);
}

TEST_CASE("lessons, the language and the length of a step are at hand in large letters and in upright windows") {
  const FontFiles files = find_fonts(font_folders(""));
  struct Size {
    float width, height, wished;
  };
  for (const Size& each : {Size{2560, 1440, 3},
                           {2560, 1440, 3.75f},
                           {1920, 1080, 2},
                           {1920, 1080, 2.5f},
                           {768, 1024, 1},
                           {768, 1024, 1.25f},
                           {360, 640, 1},
                           {414, 896, 1}}) {
    for (const Language language : all_languages()) {
      Bench bench(at(40, Mode::trace), each.width, each.height, files);
      bench.state.appearance.language = language;
      bench.unit = bench.dpi = each.wished * shrink_to_fit(each.width, each.height, each.wished);
      bench.resize(each.width, each.height);
      const std::string grain = bench.has("grain") ? "grain" : "grain-pixel";
      for (const std::string& item : {std::string("lessons"), std::string("language"), grain, std::string("step"),
                                      std::string("play"), std::string("clear"), std::string("mode-help")}) {
        CAPTURE(each.width, each.wished, language.code(), item);
        REQUIRE(bench.has(item));
        const Rect where = bench.rect(item);
        CHECK(where.x >= 0);
        CHECK(where.right() <= each.width + 0.5f);
        CHECK(where.bottom() <= each.height + 0.5f);
        CHECK_FALSE(bench.has(item + "/clipped"));
      }
      const std::string before = std::string(name_of(bench.state.walk.grain));
      bench.click(grain);
      CHECK(name_of(bench.state.walk.grain) != before);
    }
  }
}

TEST_CASE("on a telephone held upright what is pressed is as high as a finger needs, in every language") {
  const FontFiles files = find_fonts(font_folders(""));
  struct Size {
    float width, height, least;
  };
  for (const Size& each : {Size{390, 844, 44}, Size{360, 640, 40}}) {
    for (const Language language : all_languages()) {
      Bench bench(at(40, Mode::trace), each.width, each.height, files);
      bench.state.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
      bench.state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
      bench.state.appearance.language = language;
      bench.unit = bench.dpi = shrink_to_fit(each.width, each.height, 1);
      const auto check = [&](const std::vector<std::string>& items) {
        bench.resize(each.width, each.height);
        for (const std::string& item : items) {
          CAPTURE(each.width, language.code(), item);
          REQUIRE(bench.has(item));
          const Rect where = bench.rect(item);
          CHECK(where.height >= each.least - 0.5f);
          CHECK(where.x >= 0);
          CHECK(where.y >= 0);
          CHECK(where.right() <= each.width + 0.5f);
          CHECK(where.bottom() <= each.height + 0.5f);
          CHECK_FALSE(bench.has(item + "/clipped"));
        }
      };
      const std::vector<std::string> bar{"menu-file", "menu-panels", "mode-move", "mode-trace", "mode-help",
                                         "undo",      "redo",        "language",  "lessons"};
      const std::vector<std::string> walk{"step-back", "step", "play",  "clear",      "grain",
                                          "first",     "last", "scrub", "front-code", "front-tabs"};
      check(bar);
      check(walk);
      check({"only-pixel"});
      update(bench.state, action::ShowFront{Front::tabs});
      check({"tab-image", "tab-stack", "tab-structure", "exchange"});
      update(bench.state, action::SetMode{Mode::move});
      check(bar);
      check({"add-polygon", "add-light"});
      update(bench.state, action::SetMode{Mode::trace});
      update(bench.state, action::ShowLessons{true});
      update(bench.state, action::ShowFront{Front::lesson});
      check({"lesson/01-ray-casting", "lesson-close"});
      update(bench.state, action::OpenLesson{"01-ray-casting"});
      update(bench.state, action::GoToLessonStep{1});
      check(walk);
      check({"front-lesson", "lesson-list", "lesson-back", "lesson-reveal", "lesson-close"});
      CHECK(bench.rect("guess/1").height >= each.least - 0.5f);
    }
  }
}

TEST_CASE("on a telephone so are panels, forms and lists, and these stay in the window, in every language") {
  const FontFiles files = find_fonts(font_folders(""));
  struct Size {
    float width, height, least;
  };
  for (const Size& each : {Size{390, 844, 44}, Size{360, 640, 40}, Size{844, 390, 40}}) {
    for (const Language language : all_languages()) {
      Bench bench(at(40, Mode::trace), each.width, each.height, files);
      bench.state.appearance.language = language;
      bench.unit = bench.dpi = shrink_to_fit(each.width, each.height, 1);
      update(bench.state, action::SetTouch{true});
      update(bench.state, action::ShowFront{Front::tabs});
      const float reach = 4 * bench.unit;  // of a finger beyond the edges of what is in a form or shows a picture
      const auto check = [&](const std::string& item, float beyond = 0) {
        CAPTURE(each.width, language.code(), item);
        REQUIRE(bench.has(item));
        const Rect where = bench.rect(item);
        CHECK(where.height + 2 * beyond >= each.least - 0.5f);
        CHECK(where.x >= 0);
        CHECK(where.right() <= each.width + 0.5f);
        CHECK_FALSE(bench.has(item + "/clipped"));
      };
      const auto show = [&](Tab tab) {
        update(bench.state, action::SetTab{tab});
        bench.resize(each.width, each.height);
      };
      show(StructureRoom::tab);
      for (const char* item : {"structure/search", "structure/build", "structure-next", "structure/slider"})
        check(item);
      bench.click("structure/build");
      bench.frames(2);
      check("structure/bvh");
      show(CostRoom::tab);
      for (const char* item : {"cost-page", "cost-knobs", "cost-try"}) check(item);
      show(MicroscopeRoom::tab);
      for (const char* item : {"numerics-robust", "precision-float"}) check(item);
      show(TreeRoom::tab);
      check(bench.interface().items().lower_bound("node-")->first, reach);

      const auto check_popup = [&](const std::string& name, const std::vector<std::string_view>& fields) {
        bench.frames(2);
        CAPTURE(each.width, language.code(), name);
        REQUIRE(bench.has(name));
        const Rect popup = bench.rect(name);
        CHECK(popup.x >= 0);
        CHECK(popup.y >= 0);
        CHECK(popup.right() <= each.width + 0.5f);
        CHECK(popup.bottom() <= each.height + 0.5f);
        for (const std::string_view id : fields) {
          const std::string field = "property/" + std::string(text(id, language));
          check(field, reach);
          CHECK(bench.rect(field).right() <= popup.right());
        }
        bench.hold(ImGuiKey_Escape, true);
        bench.frames(2);
        bench.hold(ImGuiKey_Escape, false);
        bench.frames(2);
        CHECK_FALSE(bench.has(name));
      };
      show(PictureRoom::tab);
      bench.click("image-settings");
      check_popup("image-settings-popup", {"property.integrator", "property.samples", "property.heat"});
      show(CostRoom::tab);
      bench.click("cost-knobs");
      check_popup("cost-knobs-popup", {"property.samples", "property.sampler", "property.precision"});

      update(bench.state, action::SetMode{Mode::move});
      update(bench.state, action::Select{{TargetKind::object, 1}});
      update(bench.state, action::ShowFront{Front::code});
      bench.resize(each.width, each.height);
      check("deselect");
      const std::string radius = "property/" + std::string(text("property.radius", language));
      check(radius, reach);
      // A finger that is a little below it meets it, too.
      const Rect field = bench.rect(radius);
      const Scene before = bench.state.scene();
      bench.move_to(field.x + field.width / 2, field.bottom() + 0.7f * reach);
      bench.press();
      bench.move_to(field.x + field.width / 2 + 60, field.bottom() + 0.7f * reach);
      bench.release();
      CHECK_FALSE(bench.state.scene() == before);

      update(bench.state, action::AskSaveAs{});
      bench.resize(each.width, each.height);
      for (const char* item : {"browser-up", "browser-path", "browser-cancel", "browser-accept"}) check(item, reach);
    }
  }
}

TEST_CASE(
    "on a telephone so are the switches of effects, ink, the buttons over the view in space and what ends a notice") {
  const FontFiles files = find_fonts(font_folders(""));
  struct Size {
    float width, height, least;
  };
  for (const Size& each : {Size{390, 844, 44}, Size{360, 640, 40}, Size{844, 390, 40}}) {
    for (const Language language : all_languages()) {
      Bench bench(at(40, Mode::trace), each.width, each.height, files);
      bench.state.appearance.language = language;
      bench.unit = bench.dpi = shrink_to_fit(each.width, each.height, 1);
      update(bench.state, action::SetTouch{true});
      const auto check = [&](const std::vector<std::string>& items) {
        bench.resize(each.width, each.height);
        bench.frames(2);
        for (const std::string& item : items) {
          CAPTURE(each.width, language.code(), item);
          REQUIRE(bench.has(item));
          const Rect where = bench.rect(item);
          CHECK(where.height >= each.least - 0.5f);
          CHECK(where.x >= 0);
          CHECK(where.right() <= each.width + 0.5f);
          CHECK_FALSE(bench.has(item + "/clipped"));
        }
      };
      update(bench.state, action::ShowEffects{true});
      check({"effect/shadows", "effect/refraction", "effect/depth-less", "effect/depth-more"});
      update(bench.state, action::ShowEffects{false});

      update(bench.state, action::SetInk{true});
      const std::vector<std::string> tools{"ink-pen", "ink-eraser", "ink/red", "ink-clear", "ink-keep", "ink"};
      check(tools);
      for (const std::string& tool : tools) {
        CAPTURE(each.width, tool);
        CHECK(bench.rect(tool).width >= 0.8f * each.least);
        CHECK(bench.rect(tool).bottom() <= bench.interface().layout().plan.y + 0.5f);
      }
      update(bench.state, action::SetInk{false});

      update(bench.state, action::WalkPixel{10, 9, {21, 21}});
      update(bench.state, action::Orbit{SpaceView::lines, {0.1, 0}});
      check({"lines", "reset-view", "walk-strip"});
      update(bench.state, action::ShowLines{false});

      bench.state.document.notice = Notice{Notice::Kind::info, "Saved"};
      check({"dismiss-notice"});
      const Rect notice = bench.rect("notice"), cross = bench.rect("dismiss-notice");
      CHECK(cross.width >= each.least - 0.5f);
      CHECK(cross.right() <= notice.right() + 0.5f);
      CHECK(cross.bottom() <= notice.bottom() + 0.5f);
      bench.click("dismiss-notice");
      CHECK_FALSE(bench.state.document.notice);
    }
  }
}

TEST_CASE("a menu's heading is where it was while the menu is open") {
  for (const auto& [width, height] : {std::pair{1280.0f, 720.0f}, {390.0f, 844.0f}}) {
    Bench bench(at(0, Mode::move), width, height);
    bench.unit = bench.dpi = shrink_to_fit(width, height, 1);
    bench.resize(width, height);
    for (const std::string menu : {"menu-file", "menu-view", "menu-panels"}) {
      CAPTURE(width, menu);
      const Rect closed = bench.rect(menu);
      bench.click(menu);
      bench.frames(2);
      CHECK(bench.rect(menu) == closed);
      if (width > 1000 && bench.has("menu/rays")) {
        const Rect entry = bench.rect("menu/rays");
        bench.click("menu/rays");
        REQUIRE(bench.has("menu/rays-primary"));
        CHECK(bench.rect("menu/rays") == entry);
      }
      bench.click(menu);  // closed again
    }
  }
}

TEST_CASE("on a telephone on its side the bars are as high as a finger needs, once one has touched it") {
  const FontFiles files = find_fonts(font_folders(""));
  for (const auto& [width, height] : {std::pair{844.0f, 390.0f}, {740.0f, 360.0f}}) {
    for (const Language language : all_languages()) {
      Bench bench(at(40, Mode::trace), width, height, files);
      bench.state.appearance.language = language;
      bench.unit = bench.dpi = shrink_to_fit(width, height, 1);
      bench.resize(width, height);
      CHECK(bench.rect("step").height < 36);
      update(bench.state, action::SetTouch{true});
      bench.resize(width, height);
      for (const char* item : {"menu-file", "mode-move", "undo", "language", "lessons", "only-pixel", "focus", "step",
                               "play", "grain", "first", "scrub", "front-code", "front-tabs"}) {
        CAPTURE(width, language.code(), item);
        REQUIRE(bench.has(item));
        CHECK(bench.rect(item).height >= 37.5f);
        CHECK(bench.rect(item).bottom() <= height + 0.5f);
        CHECK_FALSE(bench.has(std::string(item) + "/clipped"));
      }
      CHECK(bench.rect("plan").height >= 0.36f * height);
      bench.state.appearance.embedded = true;
      bench.resize(width, height);
      CHECK(bench.rect("step").height >= 40);
    }
  }
}

TEST_CASE("the entries of a menu stand as far apart as a finger needs, and a menu that so is too long scrolls") {
  for (const auto& [width, height] : {std::pair{844.0f, 390.0f}, {390.0f, 844.0f}}) {
    for (const bool touch : {false, true}) {
      CAPTURE(width, touch);
      Bench bench(at(0, Mode::move), width, height);
      bench.unit = bench.dpi = shrink_to_fit(width, height, 1);
      update(bench.state, action::SetTouch{touch});
      bench.resize(width, height);
      bench.click("menu-view");
      const float apart = bench.rect("menu/zoom-in").y - bench.rect("menu/fit").y;
      CHECK((touch ? apart >= 44 : apart < 30));
      if (touch) CHECK(bench.rect("menu/full-screen").y > height);
    }
  }
}

TEST_CASE("every button that a mouse can press is in the window at 1280 x 720") {
  for (const Mode mode : {Mode::move, Mode::trace}) {
    Bench bench(at(40, mode));
    update(bench.state, action::Select{{TargetKind::object, 0}});
    bench.frames(2);
    for (const std::string item :
         {"mode-move", "mode-trace", "mode-help",   "undo",      "redo",       "step",    "step-back",
          "play",      "clear",      "first",       "last",      "scrub",      "speed",   "slower",
          "faster",    "grain-line", "grain-pixel", "tab-image", "tab-legend", "exchange"}) {
      const Rect where = bench.rect(item);
      CAPTURE(item, where.x, where.y, where.width, where.height);
      CHECK(where.x >= 0);
      CHECK(where.y >= 0);
      CHECK(where.right() <= 1280);
      CHECK(where.bottom() <= 720);
      CHECK(where.width >= 20);
      CHECK(where.height >= 20);
    }
  }
}
