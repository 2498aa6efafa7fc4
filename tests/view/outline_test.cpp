// The window in words: whoever cannot see it can do by its outline what others do by pointing.
#include "view/outline.h"

#include "lesson_state.h"
#include "support/catch.h"
#include "support/effort.h"
#include "text/file.h"
#include "view/action_text.h"
#include "view/document/document.h"
#include "view/lesson/typed_number.h"
#include "view/link/link.h"
#include "view/plan/plan_geometry.h"
#include "view/text/shown.h"
#include "view/walk/code_panel.h"
#include "view/walk/status.h"

#include <set>

using namespace raywalk;
using namespace raywalk::test;
using Role = OutlineItem::Role;

namespace {

void each_item(const std::vector<OutlineItem>& items, const auto& visit) {
  for (const OutlineItem& item : items) {
    visit(item);
    each_item(item.items, visit);
  }
}

std::vector<OutlineItem> items_with(const State& state, const auto& fits) {
  std::vector<OutlineItem> found;
  each_item(outline(state), [&](const OutlineItem& item) {
    if (fits(item)) found.push_back(item);
  });
  return found;
}

std::optional<OutlineItem> named(const State& state, Role role, std::string_view name) {
  const auto found = items_with(state, [&](const OutlineItem& item) { return item.role == role && item.name == name; });
  return found.empty() ? std::nullopt : std::optional(found.front());
}

/// Presses the button, or types into the field, of this name.
void use(State& state, Role role, std::string_view name, std::string_view typed = {}) {
  const auto item = named(state, role, name);
  INFO(name);
  REQUIRE(item);
  REQUIRE(item->enabled);
  const auto action = outlined_action(state, item->does, typed);
  REQUIRE(action);
  update(state, *action);
}

/// Whether whatever can be pressed has an action, and no two siblings have the same key.
std::string faults(const std::vector<OutlineItem>& items) {
  std::string wrong;
  std::set<std::string> keys;
  for (const OutlineItem& item : items) {
    if (!keys.insert(item.key).second) wrong += "twice " + item.key + "\n";
    if (item.name.empty()) wrong += "unnamed " + item.key + "\n";
    const bool is_field = item.role == Role::number || item.role == Role::words || item.role == Role::path;
    const std::size_t gap = item.does.find("{}");
    if (is_field != (gap != std::string::npos)) wrong += "field " + item.key + "\n";
    if ((item.role == Role::button || is_field) &&
        !parse_action(is_field ? item.does.substr(0, gap) + "1" + item.does.substr(gap + 2) : item.does))
      wrong += item.key + ": " + item.does + "\n";
    wrong += faults(item.items);
  }
  return wrong;
}

}  // namespace

TEST_CASE("the outline has the code with its current line, the sentence, and the step to go to") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  for (const int position : {0, 1, 7, 40, state.walk.timeline->steps()}) {
    update(state, action::Jump{position});
    CHECK(faults(outline(state)) == "");
    const auto current = items_with(state, [](const OutlineItem& item) { return item.current; });
    for (const CodeBox& box : code_panel(state).boxes)
      for (const CodeRow& row : box.rows) {
        const auto lines = items_with(state, [&](const OutlineItem& item) {
          return item.role == Role::entry && item.name.starts_with(row.text);
        });
        CHECK(!lines.empty());
        if (row.just_run) CHECK((!current.empty() && current.front().name.starts_with(row.text)));
      }
    CHECK(named(state, Role::news, sentence(state)));
    CHECK(named(state, Role::number, "Go to step")->value == std::to_string(position));
  }
  use(state, Role::number, "Go to step", "12");
  CHECK(state.walk.position == 12);
}

TEST_CASE("every lesson can be walked to its end by its outline alone") {
  State state = state_with_lessons();
  update(state, action::SetLessonOptions{});
  const auto rows = lesson_panel(state).rows;
  REQUIRE(!rows.empty());
  std::size_t number = 0;
  for (const LessonRow& row : rows) {
    INFO(row.name);
    if (left_out(number++, 4)) {
      state.lessons.done[row.name] = row.steps;  // else the next would be locked
      continue;
    }
    const auto lesson = items_with(state, [&](const OutlineItem& item) { return item.key == row.name; });
    REQUIRE(lesson.size() == 1);
    use(state, Role::button, lesson.front().name);
    for (int step = 1; state.lessons.at() != nullptr; ++step) {
      INFO(step);
      CHECK(faults(outline(state)) == "");
      const LessonPanel panel = lesson_panel(state);
      REQUIRE(panel.step == step);
      CHECK(named(state, Role::news, panel.heading));
      if (panel.asks != Asks::nothing) {
        CHECK(named(state, Role::news, "Predict: " + panel.question));
        CHECK_FALSE(named(state, Role::button, "Reveal")->enabled);
        switch (panel.asks) {
          case Asks::choice:
            use(state, Role::button, "2  " + panel.choices[1].text);
            break;
          case Asks::number:
            use(state, Role::number, panel.unit.empty() ? "Your number" : "Your number, in " + panel.unit, "1.5");
            break;
          case Asks::arrow:
            use(state, Role::number, "Direction in degrees: 0 to the right, 90 up", "60");
            break;
          case Asks::line: {
            const auto lines = items_with(state, [](const OutlineItem& item) { return item.key == "mark"; });
            REQUIRE(!lines.empty());
            use(state, Role::button, lines.front().name);
            break;
          }
          case Asks::nothing:
            break;
        }
        use(state, Role::button, "Reveal");
        REQUIRE(state.lessons.revealed);
        CHECK(items_with(state, [](const OutlineItem& item) { return item.key == "verdict"; }).size() == 1);
      }
      use(state, Role::button, panel.is_last ? "Finish" : "Next");
    }
    CHECK(state.lessons.done[row.name] == row.steps);
  }
}

TEST_CASE("a thing of the plan is moved by numbers, and only in Move mode") {
  State state = busy_state();
  update(state, action::SetMode{Mode::move});
  for (const auto& field : items_with(state, [](const OutlineItem& item) { return item.role == Role::number; })) {
    if (!field.does.starts_with("place")) continue;
    State moved = state;
    const double before = typed_numbers(field.value).front();
    use(moved, Role::number, field.name, std::to_string(before + 0.01));
    CAPTURE(field.name, moved.document.notice ? moved.document.notice->text : "");
    CHECK(moved.scene() != state.scene());
    CHECK(moved.document.undo.size() == 1);
  }
  update(state, action::Place{{TargetKind::object, 0}, {1, 2}});
  CHECK(length(place_of(state, {TargetKind::object, 0}, state.plan.viewport) - Vec2d(1, 2)) < 1e-12);
  update(state, action::Place{{TargetKind::object, 1000}, {1, 2}});
  update(state, action::SetMode{Mode::trace});
  CHECK_FALSE(named(state, Role::number, "x of EYE"));
}

TEST_CASE("a typed number is read in any notation, and what is none is refused in words") {
  State state = classic_state();
  CHECK(outlined_action(state, "jump {}", "x").error().message == "This is not a number: type one such as 12");
  const auto place = outlined_action(state, "place eye -1 -1 {} 2", "\u22121,5");
  REQUIRE(place);
  CHECK(write_action(*place) == "place eye -1 -1 -1.5 2");
  CHECK(write_action(*outlined_action(state, "save-as {}", "1.toml")) == "save-as 1.toml");
}

TEST_CASE("the properties of a thing are in the outline, and changed there") {
  State state = state_of(read_scene(RAYWALK_SOURCE_DIR "/scenes/classic.toml")->scene);
  state.appearance.language = test::in_english;
  const Scene before = state.scene();
  const std::string ball = object_name(state, 0);
  CHECK_FALSE(named(state, Role::words, "Radius"));
  use(state, Role::button, "Properties of " + ball);
  CHECK(faults(outline(state)) == "");
  CHECK(named(state, Role::button, "Properties of " + ball)->chosen == true);
  CHECK(named(state, Role::region, ball));
  use(state, Role::words, "Radius", "0,75");
  CHECK(std::get<Sphere<double>>(state.scene().objects[0].shape).radius == 0.75);
  CHECK(named(state, Role::words, "Radius")->value == "0.75");
  use(state, Role::words, "Diffuse (kd)", "0.25 0.5 1");
  CHECK(state.scene().objects[0].material.diffuse == Rgbd(0.25, 0.5, 1));
  const bool checkered = state.scene().objects[0].material.checker.has_value();
  use(state, Role::button, "Checker");
  CHECK(state.scene().objects[0].material.checker.has_value() != checkered);
  CHECK(named(state, Role::button, "Checker")->chosen == !checkered);
  use(state, Role::words, "Name", "Football");
  CHECK(state.scene().objects[0].name == "Football");
  CHECK(outlined_action(state, named(state, Role::words, "Name")->does, "").error().text() == "Type a name");
  CHECK_FALSE(state.document.notice);
  use(state, Role::words, "Radius", "-1");
  REQUIRE(state.document.notice);
  CHECK(named(state, Role::warning, state.document.notice->text));
  use(state, Role::button, "Properties of EYE");
  CHECK(faults(outline(state)) == "");
  use(state, Role::words, "Background", "0.5");
  CHECK(state.scene().background == Rgbd(0.5));
  for (int i = 0; i < 5; ++i) update(state, action::Undo{});
  CHECK(state.scene() == before);
  update(state, action::SetMode{Mode::trace});
  CHECK_FALSE(named(state, Role::words, "Background"));
}

TEST_CASE("a question and a prompt are in the outline with all their answers") {
  State state = state_with_lessons();
  make_dirty(state);
  update(state, action::New{});
  REQUIRE(state.document.question);
  CHECK(faults(outline(state)) == "");
  use(state, Role::button, "Cancel");
  CHECK_FALSE(state.document.question);
  update(state, action::AskSaveAs{});
  CHECK(named(state, Role::path, "File")->hint == "Save");
  use(state, Role::button, "Cancel");
  CHECK(state.document.prompt == PathPrompt::none);
  update(state, action::AskNew{});
  CHECK(faults(outline(state)) == "");
  use(state, Role::button,
      fill("gallery.mirrors.title", in_english) + ": " + fill("gallery.mirrors.sentence", in_english));
  REQUIRE(state.document.question);  // there is unsaved work
  use(state, Role::button, "Don't save");
  CHECK(state.document.path == shipped_path(state, "mirrors"));
  CHECK(state.document.prompt == PathPrompt::none);
  update(state, action::AskNew{});
  use(state, Role::button, "A new scene");
  CHECK(state.document.path.empty());
  CHECK(state.document.prompt == PathPrompt::none);
}

TEST_CASE("while an answer is waited for, what has no effect is not offered") {
  State state = classic_state();
  make_dirty(state);
  const auto regions = [&] {
    std::string keys;
    for (const OutlineItem& item : outline(state)) keys += item.key + " ";
    return keys;
  };
  update(state, action::AskSaveAs{});
  CHECK(regions() == "prompt ");
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("there.toml"), ""));
  update(state, action::SaveAs{folder.file("there.toml")});
  CHECK(regions() == "question ");
  update(state, action::AnswerQuestion{action::Answer::cancel});
  CHECK(regions() == "prompt ");
}

TEST_CASE("the name that a dialog offers can be taken as it is") {
  const TemporaryFolder folder;
  State state = saved_state(folder, "mine.toml");
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  const auto offered = [&](const Action& asks) {
    update(state, asks);
    const auto field = named(state, Role::path, "File");
    REQUIRE(field);
    const Result<Action> taken = outlined_action(state, field->does, field->value);
    REQUIRE(taken);
    update(state, *taken);
    CHECK(state.document.prompt == PathPrompt::none);
    return field->value;
  };
  CHECK(offered(action::AskSaveAs{}) == folder.file("mine.toml"));
  CHECK(offered(action::AskExport{}) == folder.file("mine.html"));
  CHECK(std::filesystem::exists(folder.file("mine.html")));
  // What is made of a shipped scene does not go among those.
  state.document.path = shipped_path(state, "glass");
  update(state, action::AskSaveAs{});
  CHECK(named(state, Role::path, "File")->value == "glass.toml");
}

TEST_CASE("a bug is hunted, found, fixed and broken again by the outline") {
  State state = state_with_lessons();
  update(state, action::ShowBugs{true});
  use(state, Role::button, "Bug 2");
  REQUIRE(state.bugs.hunt);
  CHECK_FALSE(named(state, Role::button, "Is it this line?")->enabled);
  CHECK_FALSE(named(state, Role::button, "Fix the bug"));
  use(state, Role::button, "Mark “Form shadow ray”");
  use(state, Role::button, "Is it this line?");
  CHECK(state.bugs.hunt->end == BugEnd::open);
  use(state, Role::button, "Mark “Form reflect ray”");
  use(state, Role::button, "Is it this line?");
  CHECK(state.bugs.hunt->end == BugEnd::found);
  CHECK_FALSE(named(state, Role::button, "Show the fix"));
  use(state, Role::button, "Fix the bug");
  CHECK(state.walk.bug->mended);
  use(state, Role::button, "Break it again");
  CHECK_FALSE(state.walk.bug->mended);
  CHECK(faults(outline(state)) == "");
  use(state, Role::button, "All bugs");
  use(state, Role::button, "Bug 3");
  use(state, Role::button, "Show the fix");
  CHECK(state.bugs.hunt->end == BugEnd::given_up);
}

TEST_CASE("predictions are made by the outline") {
  State state = classic_state();
  update(state, action::SetPredictions{true});
  bool way = false, end = false;
  for (int position = 0; position < state.walk.timeline->steps() && !(way && end); ++position) {
    update(state, action::Jump{position});
    const auto asked = prediction_asked(state);
    if (!asked) continue;
    if (asked->what == PredictionKind::way) {
      way = true;
      use(state, Role::number, "Direction in degrees: 0 to the right, 90 up", "90");
      REQUIRE(state.predictions.open);
      CHECK(length(state.predictions.open->arrow - Vec2d(0, 1)) < 1e-12);
    } else {
      end = true;
      use(state, Role::button, "nothing");
      REQUIRE(state.predictions.open);
      CHECK_FALSE(state.predictions.open->met);
    }
  }
  CHECK(way);
  CHECK(end);
}

TEST_CASE("a field of words that is left empty asks for words, and ink takes them back") {
  State state = classic_state();
  for (const char* line : {"open {}", "save-as {}", "save-predictions {}", "export {}"})
    CHECK(outlined_action(state, line, "").error().message == "Type the name of a file");
  const auto nothing = outlined_action(state, "ink-type {}", "");
  REQUIRE(nothing);
  REQUIRE(nothing->as<action::TypeInk>() != nullptr);
  CHECK(nothing->as<action::TypeInk>()->text.empty());
}

TEST_CASE("where the walk stops can be chosen in the outline") {
  State state = classic_state();
  CHECK(faults(outline(state)) == "");
  use(state, Role::number, "At DEPTH (0: none)", "2");
  use(state, Role::number, "At pixel (-1: none)", "7");
  use(state, Role::button, "Total internal reflection");
  const std::string object = state.scene().objects[1].name;
  use(state, Role::button, "At a hit of: " + object);
  const Breakpoints& now = state.walk.breakpoints;
  CHECK((now.depth == 2 && now.pixel == 7 && now.total_internal_reflection && now.object == object));
  CHECK(named(state, Role::button, "At a hit of: " + object)->chosen == true);
  CHECK(named(state, Role::number, "At pixel (-1: none)")->value == "7");
  use(state, Role::button, "At a hit of: nowhere");
  CHECK(now.object.empty());
  use(state, Role::button, "Remove all");
  CHECK_FALSE(now.any());
  CHECK_FALSE(named(state, Role::button, "Remove all")->enabled);
}

TEST_CASE("the settings of the 3-D image can be chosen in the outline") {
  State state = classic_state();
  use(state, Role::button, "Integrator: path");
  use(state, Role::button, "Accelerator: octree");
  use(state, Role::number, "Samples per pixel", "64");
  use(state, Role::number, "Samples walked", "4");
  use(state, Role::button, "Precision: float");
  use(state, Role::button, "Heat map: time");
  CHECK(faults(outline(state)) == "");
  CHECK(state.picture.settings == ImageSettings{AcceleratorKind::octree, true, 64, Integrator::path, 4, Heat::time});
  CHECK(named(state, Role::button, "Heat map: time")->chosen == true);
  CHECK(named(state, Role::button, "Heat map: none")->chosen == false);
  use(state, Role::number, "Maximum depth", "3");
  use(state, Role::number, "Minimum contribution", "0.25");
  use(state, Role::button, "Numerics: naive");
  use(state, Role::number, "Epsilon", "0.5");
  const Scene& scene = state.scene();
  CHECK((scene.limits == TraceLimits{3, 0.25} && scene.render.numerics == Numerics::naive));
  CHECK(scene.render.epsilon == 0.5);
  CHECK(state.document.undo.size() == 4);
  CHECK_FALSE(named(state, Role::button, "Radiosity as ambient light"));
  use(state, Role::button, "Integrator: whitted");
  use(state, Role::button, "Radiosity as ambient light");
  CHECK(state.scene().render.radiosity.as_ambient);
}

TEST_CASE("what Cost tries can be chosen in the outline, and what it has found is told there") {
  State state = classic_state();
  CHECK(faults(outline(state)) == "");
  // The settings of the 3-D image have fields of the same names.
  const auto in_knobs = [&](std::string_view key) {
    const Outline all = outline(state);
    const auto region = std::find_if(all.begin(), all.end(), [](const auto& item) { return item.key == "cost-knobs"; });
    REQUIRE(region != all.end());
    const auto item = std::find_if(region->items.begin(), region->items.end(),
                                   [&](const auto& each) { return each.key == key || each.name == key; });
    REQUIRE(item != region->items.end());
    return *item;
  };
  const auto choose = [&](std::string_view key, std::string_view typed = {}) {
    const auto action = outlined_action(state, in_knobs(key).does, typed);
    REQUIRE(action);
    update(state, *action);
  };
  choose("samples", "16");
  choose("threshold", "0,25");
  choose("Sampler: sobol");
  choose("Numerics: naive");
  choose("epsilon", "0.5");
  CHECK(cost_knobs(state).samples == 16);
  CHECK(cost_knobs(state).threshold == 0.25);
  CHECK(cost_knobs(state).sampler == Sampler::sobol);
  CHECK(cost_knobs(state).numerics == Numerics::naive);
  CHECK(cost_knobs(state).epsilon == 0.5);
  CHECK(in_knobs("Sampler: sobol").chosen == true);
  const std::vector<study::Attempt> none;
  const CostFindings nothing{none};
  const auto has_costs = [&](const CostFindings* found) {
    const Outline outlined = outline(state, found);
    return std::find_if(outlined.begin(), outlined.end(), [](const OutlineItem& item) { return item.key == "cost"; }) !=
           outlined.end();
  };
  CHECK_FALSE(has_costs(&nothing));
  update(state, action::SetTab{CostRoom::tab});
  CHECK(has_costs(&nothing));
  CHECK_FALSE(has_costs(nullptr));
  update(state, action::TryCost{});
  const Outline outlined = outline(state, &nothing);
  CHECK(faults(outlined) == "");
  int tries = 0;
  each_item(outlined, [&](const OutlineItem& item) {
    if (item.key != "try-0") return;
    CHECK(item.name == attempt_text(state, nothing, 0));
    CHECK(item.current);
    ++tries;
  });
  CHECK(tries == 1);

  update(state, action::ShowCostPage{CostPage::effects});
  CostFindings found{none};
  const auto told = [&] {
    std::vector<std::string> texts;
    for (const OutlineItem& region : outline(state, &found))
      if (region.key == "cost")
        for (const OutlineItem& item : region.items) texts.push_back(item.name);
    return texts;
  };
  found.surveyed = 0.25;
  CHECK(told() == std::vector<std::string>{"measuring: 25%"});
  found.survey.emplace();
  found.survey->whole.rays = 1000, found.survey->whole.seconds = 0.5, found.survey->shadow_rays = 250;
  found.survey->effects = {{Effect::penumbra, {}, 0.5, 0.25, 0.2, 0.3}};
  CHECK(faults(outline(state, &found)) == "");
  std::vector<std::string> expected = effect_texts(*found.survey, state.appearance.language);
  expected.push_back(survey_text(found.survey, 0.25, state.appearance.language));
  CHECK(told() == expected);
}

TEST_CASE("the dialog of a link is in the outline: its address, or why there is none, and what can be done") {
  State state = classic_state();
  state.link.own_page = "https://own.example/";
  update(state, action::ShowLink{true});
  CHECK(faults(outline(state)) == "");
  CHECK(named(state, Role::text, address_shown(state)));
  const std::string page = "Address of a page that shows Raywalk";
  use(state, Role::words, page, "https://a.example/");
  CHECK(named(state, Role::text, address_shown(state))->name.starts_with("https://a.example/#"));
  use(state, Role::words, page, "");
  CHECK(page_of_links(state) == "https://own.example/");
  use(state, Role::button, "Copy link");
  CHECK(state.link.copies == 1);
  CHECK_FALSE(state.link.shown);

  Scene many = state.scene();
  many.objects.resize(1100, many.objects.front());
  commit(state, many);
  update(state, action::CopyLink{});
  CHECK(faults(outline(state)) == "");
  CHECK(named(state, Role::warning, state.link.why_not));
  CHECK(named(state, Role::button, "Save as\u2026"));
  use(state, Role::button, "Close");
  CHECK_FALSE(state.link.shown);
}
