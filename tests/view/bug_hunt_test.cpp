// Spot the bug without a window: choose, guess wrong, guess right, give up, leave.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "fixtures.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/bugs/bug_panel.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/code_panel.h"
#include "view/walk/fault.h"
#include "view/walk/status.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::string said_of(Fault fault, const std::string& what) {
  return fill("fault." + std::string(name_of(fault)) + "." + what, in_english);
}

// The busy scene, with work in it that is not saved, in a folder of its own.
State at_work(const TemporaryFolder& folder) {
  State state = saved_state(folder);
  state.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  make_dirty(state);
  return state;
}

State hunting(int number, bool surprise = false) {
  State state = busy_state();
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  update(state, action::HuntBug{number, surprise});
  REQUIRE(state.bugs.hunt);
  return state;
}

/// Of the same pseudocode.
Line another_line(Line line) {
  const auto& lines = pseudocode_with(line).lines;
  return lines.back().line == line ? lines.front().line : lines.back().line;
}

// The walk's shades as the strip has them.
std::vector<Rgbd> shades(const Timeline& timeline) {
  std::vector<Rgbd> all;
  for (const PixelRecord& pixel : timeline.pixels()) all.push_back(pixel.shade);
  return all;
}

std::size_t items_in(const State& state) { return plan_view(state, state.plan.viewport).size(); }

}  // namespace

TEST_CASE("each bug opens a shipped scene that it spoils, at the first pixel in which it is seen") {
  for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
    const State state = hunting(number);
    const Fault fault = values_of<Fault>[static_cast<std::size_t>(number - 1)];
    CAPTURE(name_of(fault));
    REQUIRE(state.walk.bug);
    CHECK(state.walk.bug->fault == fault);
    CHECK(fault_at_work(state) == fault);
    REQUIRE(state.walk.bug->other);
    const auto broken = shades(*state.walk.timeline), whole = shades(*state.walk.bug->other);
    CHECK(broken != whole);
    const int first = state.bugs.hunt->first_pixel;
    const auto off = [&](int i) {
      const Rgbd by = broken[static_cast<std::size_t>(i)] - whole[static_cast<std::size_t>(i)];
      return std::max({std::abs(by.x), std::abs(by.y), std::abs(by.z)});
    };
    for (int i = 0; i < first; ++i) CHECK(off(i) < 0.03);
    CHECK(off(first) >= 0.03);
    CHECK(state.walk.mode == Mode::trace);
    // The line at fault runs in the pixel where the walk stands; or the walk stands before the photons, where it does.
    const bool sends = fault == Fault::power_of_another_pass;
    const PixelRecord& pixel = state.walk.timeline->pixels()[static_cast<std::size_t>(first)];
    CHECK(state.walk.position == (sends ? 0 : pixel.begun_at));
    bool runs = false;
    for (int i = sends ? 0 : pixel.begun_at; i < pixel.done_at; ++i)
      runs = runs || state.walk.timeline->event(i).line == faulty_line(fault);
    CHECK(runs);
    CHECK(pictured_scene(state)->render.numerics == Numerics::naive);
    CHECK(broken_promise(state).empty());
    // Neither the number nor what is said before the end names the line or the fault.
    const BugPanel panel = bug_panel(state);
    for (const BugPassage& passage : panel.said)
      CHECK(passage.text.find(pseudocode_of(faulty_line(fault)).text) == std::string::npos);
    CHECK_FALSE(bug_banner(state).empty());
  }
}

TEST_CASE("a wrong guess says what the line did right, and a hint; a right one says what was wrong, and the cure") {
  for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
    State state = hunting(number);
    const Line right = faulty_line(state.walk.bug->fault), wrong = another_line(right);
    CHECK_FALSE(bug_panel(state).can_judge);
    update(state, action::JudgeLine{});
    CHECK(state.bugs.hunt->end == BugEnd::open);
    update(state, action::MendBug{true});
    CHECK_FALSE(state.walk.bug->mended);

    update(state, action::MarkLine{wrong});
    CHECK(marked_line(state) == wrong);
    CHECK(bug_panel(state).can_judge);
    update(state, action::JudgeLine{});
    CHECK(state.bugs.hunt->end == BugEnd::open);
    CHECK_FALSE(marked_line(state));
    BugPanel panel = bug_panel(state);
    CHECK_FALSE(panel.is_right);
    const std::string_view duty = duty_of(wrong);
    CHECK_THAT(panel.verdict, contains(std::string(duty.empty() ? pseudocode_of(wrong).text : text(duty, in_english))));
    REQUIRE(panel.learnt.size() == 1);
    CHECK(panel.learnt[0].text == said_of(state.walk.bug->fault, "hint"));
    CHECK(panel.tally.empty());

    update(state, action::MarkLine{right});
    CHECK(bug_panel(state).verdict.empty());
    update(state, action::JudgeLine{});
    panel = bug_panel(state);
    CHECK(panel.is_right);
    CHECK_THAT(panel.verdict, contains(std::string(pseudocode_of(right).text)));
    CHECK(panel.learnt[0].text == said_of(state.walk.bug->fault, "wrong"));
    CHECK(panel.learnt[1].text == said_of(state.walk.bug->fault, "cure"));
    CHECK(panel.tally == "1 of 16 found");
    // It is over: nothing more is asked.
    CHECK_FALSE(asks_for_line(state));
    update(state, action::MarkLine{wrong});
    update(state, action::ShowCure{});
    CHECK(state.bugs.hunt->end == BugEnd::found);
  }
}

TEST_CASE("giving up shows the line, counts as no find, and a later find counts") {
  State state = hunting(3);
  update(state, action::ShowCure{});
  CHECK(state.bugs.hunt->end == BugEnd::given_up);
  BugPanel panel = bug_panel(state);
  CHECK_FALSE(panel.is_right);
  CHECK_THAT(panel.verdict, contains("Form refract ray"));
  CHECK(panel.tally.empty());
  const auto blamed = [&] {
    std::vector<Line> lines;
    for (const CodeBox& box : code_panel(state).boxes)
      for (const CodeRow& row : box.rows)
        if (row.blame == Blame::at_fault) lines.push_back(row.line);
    return lines;
  };
  CHECK(blamed() == std::vector<Line>{Line::form_refract_ray});
  update(state, action::HuntBug{3});
  CHECK(blamed().empty());
  update(state, action::MarkLine{Line::form_refract_ray});
  update(state, action::JudgeLine{});
  CHECK(state.bugs.ends[2] == BugEnd::found);
  update(state, action::HuntBug{3});
  update(state, action::ShowCure{});
  CHECK(state.bugs.ends[2] == BugEnd::found);
}

TEST_CASE("once it is known the bug can be mended and made again, and the other rays stand beside") {
  for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
    State state = hunting(number);
    CAPTURE(number);
    const auto broken = shades(*state.walk.timeline), whole = shades(*state.walk.bug->other);
    const std::uint64_t picture = state.picture.revision;
    const std::size_t before = items_in(state);
    update(state,
           action::Jump{state.walk.timeline->pixels()[static_cast<std::size_t>(state.bugs.hunt->first_pixel)].done_at});
    const std::size_t alone = items_in(state);
    CHECK(alone > before);
    update(state, action::ShowCure{});
    // Where rays go elsewhere, the others are drawn too, and it is said what they are. Where only numbers differ, there
    // is nothing to draw, and where only rays are too many, nothing before they are mended.
    constexpr std::array only{Fault::attenuation_forgotten, Fault::emission_not_weighted, Fault::emitter_area_forgotten,
                              Fault::photons_from_behind,   Fault::power_of_another_pass, Fault::pi_forgotten,
                              Fault::reflectance_forgotten};
    const bool only_numbers = std::find(only.begin(), only.end(), state.walk.bug->fault) != only.end();
    const bool nothing = only_numbers || state.walk.bug->fault == Fault::depth_not_counted;
    CHECK(other_rays(state).empty() == nothing);
    CHECK((items_in(state) == alone) == nothing);
    CHECK(bug_panel(state).learnt.size() == (nothing || shows_lines(state) ? 2 : 3));
    update(state, action::MendBug{true});
    update(state,
           action::Jump{state.walk.timeline->pixels()[static_cast<std::size_t>(state.bugs.hunt->first_pixel)].done_at});
    // A path that goes on where the bug ends it, or is lit where it was not, has no other rays once it is whole.
    const bool is_shorter =
        state.walk.bug->fault == Fault::cosine_counted_twice || state.walk.bug->fault == Fault::second_side_black;
    CHECK(other_rays(state).empty() == (only_numbers || is_shorter));
    CHECK(shades(*state.walk.timeline) == whole);
    CHECK(shades(*state.walk.bug->other) == broken);
    CHECK_FALSE(fault_at_work(state));
    CHECK(state.picture.revision > picture);
    CHECK(bug_banner(state) == text("bug.banner_mended", in_english));
    CHECK(broken_promise(state).empty());
    update(state, action::MendBug{false});
    CHECK(shades(*state.walk.timeline) == broken);
    CHECK(fault_at_work(state) == state.walk.bug->fault);
  }
}

TEST_CASE("dotted rays are spoken of where they are to be seen, and too short ones are called that") {
  int too_short = 0;
  for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
    State state = hunting(number);
    update(state, action::ShowCure{});
    update(state,
           action::Jump{state.walk.timeline->pixels()[static_cast<std::size_t>(state.bugs.hunt->first_pixel)].done_at});
    update(state, action::MendBug{true});
    const std::vector<BugPassage> learnt = bug_panel(state).learnt;
    const auto says = [&](std::string_view id) {
      return std::any_of(learnt.begin(), learnt.end(),
                         [&](const BugPassage& one) { return one.text == text(id, in_english); });
    };
    double longest = 0;
    for (const RayRecord& ray : other_rays(state))
      longest = std::max(longest, ray.endless ? 1e9 : length(plan(ray.end) - plan(ray.origin)));
    CAPTURE(number, longest);
    CHECK(says("bug.other_rays_broken") == (longest > 0.1 && !shows_lines(state)));
    CHECK(says("bug.other_rays_short") == (longest < 1e-3 && !other_rays(state).empty()));
    if (says("bug.other_rays_short")) ++too_short;
  }
  CHECK(too_short > 0);
}

TEST_CASE("each line is told apart from all others of its pseudocode, in every language") {
  State state = classic_state();
  for (const Language language : all_languages()) {
    state.appearance.language = language;
    for (const Pseudocode& each : pseudocodes) {
      std::set<std::string> told;
      for (const PseudocodeLine& one : each.lines) {
        CAPTURE(language.code(), one.text);
        CHECK(told.insert(line_told(state, one.line)).second);
      }
    }
  }
  state.appearance.language = in_english;
  CHECK(line_told(state, Line::find_refract_intersect) == "Find closest intersect (If transparent)");
  CHECK(line_told(state, Line::shade_refract).find('(') == line_told(state, Line::shade_refract).rfind('('));
}

TEST_CASE("a bug that is mended and planted again keeps the place, before the first pixel, too") {
  for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
    State state = hunting(number);
    update(state, action::Jump{4});
    const int pixel = state.walk.timeline->current_pixel(4);
    const Line line = state.walk.timeline->just_run(4)->line;
    for (const bool mended : {true, false}) {
      update(state, action::MendBug{mended});
      CAPTURE(number, mended, state.walk.position, state.walk.timeline->steps());
      CHECK(state.walk.position < 10);
      CHECK(state.walk.timeline->current_pixel(state.walk.position) == pixel);
      CHECK(state.walk.timeline->just_run(state.walk.position)->line == line);
    }
  }
}

TEST_CASE("leaving a hunt gives back scene, unsaved work, undo and place, whatever was done in it") {
  const TemporaryFolder folder;
  State state = at_work(folder);
  update(state, action::Step{});
  const State before = state;
  for (const Action& leave : {Action(action::LeaveHunt{}), Action(action::ShowBugs{false}), Action(action::Undo{})}) {
    update(state, action::HuntBug{2});
    REQUIRE(state.bugs.hunt);
    CHECK(state.scene() != before.scene());
    if (!leave.is<action::Undo>()) {
      update(state, action::MarkLine{Line::form_shadow_ray});
      make_dirty(state);
      update(state, action::Undo{});
      update(state, action::Undo{});  // once too often: what is marked stays
      CHECK(state.bugs.hunt->marked == Line::form_shadow_ray);
      make_dirty(state);
    }
    update(state, action::SetTheme{Theme::projector});
    update(state, action::Tick{60});
    update(state, leave);
    CHECK_FALSE(state.bugs.hunt);
    CHECK_FALSE(state.walk.bug);
    CHECK(state.scene() == before.scene());
    CHECK(state.document.path == before.document.path);
    CHECK(state.document.dirty);
    CHECK(state.document.undo.size() == before.document.undo.size());
    CHECK(state.walk.position == before.walk.position);
    CHECK(state.walk.pixel == before.walk.pixel);
    CHECK(shades(*state.walk.timeline) == shades(*before.walk.timeline));
    CHECK(state.appearance.theme == Theme::projector);
    CHECK(state.document.revision != before.document.revision);  // the picture is rendered anew
    CHECK(pictured_scene(state)->render.numerics == Numerics::robust);
    CHECK(broken_promise(state).empty());
  }
}

TEST_CASE("CLEAR starts the walk of a bug over, and does not mend it") {
  State state = hunting(1);
  update(state, action::Clear{});
  CHECK(state.walk.position == 0);
  CHECK(fault_at_work(state) == Fault::shadow_ray_misaimed);
}

TEST_CASE("a hunt's scene is not autosaved: unsaved work is, before the hunt, and kept") {
  const TemporaryFolder folder;
  State state = at_work(folder);
  update(state, action::HuntBug{1});
  const std::string autosave = state.document.state_dir + "/" + state.document.autosave_file;
  REQUIRE(std::filesystem::exists(autosave));
  const auto written = std::filesystem::last_write_time(autosave);
  make_dirty(state);
  CHECK_FALSE(wants_autosave(state));
  update(state, action::Tick{60});
  update(state, action::Undo{});  // the scene of the hunt is as it was: that forgets no autosave
  CHECK(std::filesystem::exists(autosave));
  CHECK(std::filesystem::last_write_time(autosave) == written);
}

TEST_CASE("what is done to the person's own scene leaves the hunt first") {
  const TemporaryFolder folder;
  State state = at_work(folder);
  const Scene mine = state.scene();
  const std::string path = state.document.path;
  update(state, action::HuntBug{1});
  update(state, action::Quit{});
  REQUIRE(state.document.question);
  CHECK(state.scene() == mine);
  update(state, action::AnswerQuestion{action::Answer::cancel});
  CHECK_FALSE(state.document.quit);
  update(state, action::HuntBug{4});
  update(state, action::Save{});
  CHECK_FALSE(state.bugs.hunt);
  CHECK(read_document(path).scene == mine);
  update(state, action::HuntBug{4});
  update(state, action::New{});
  CHECK_FALSE(state.bugs.hunt);
  CHECK_FALSE(state.walk.bug);
}

TEST_CASE("a hunt within a lesson leads back into it, and the panes do not share their place") {
  State state = busy_state();
  state.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  update(state, action::OpenLesson{"01-ray-casting"});
  REQUIRE(state.lessons.at() != nullptr);
  const int position = state.walk.position;
  update(state, action::HuntBug{5});
  CHECK(state.bugs.shown);
  CHECK_FALSE(state.lessons.shown);
  update(state, action::ShowBugs{false});
  CHECK(state.lessons.shown);
  CHECK(state.lessons.at() != nullptr);
  CHECK(state.walk.position == position);
  update(state, action::HuntBug{5});
  update(state, action::LeaveHunt{});
  CHECK(state.bugs.shown);
  CHECK_FALSE(state.lessons.shown);
  update(state, action::ShowLessons{true});
  CHECK_FALSE(state.bugs.shown);
}

TEST_CASE("one hunt after the other: the way back is the first one's") {
  State state = busy_state();
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  const Scene mine = state.scene();
  update(state, action::HuntBug{1});
  update(state, action::HuntBug{8});
  CHECK(state.walk.bug->fault == Fault::epsilon_too_small);
  update(state, action::HuntBug{0});
  update(state, action::HuntBug{17});
  CHECK(state.walk.bug->fault == Fault::epsilon_too_small);
  update(state, action::LeaveHunt{});
  CHECK(state.scene() == mine);
}

TEST_CASE("without the scenes that ship there is no hunt, and it is said why") {
  State state = busy_state();
  const Scene mine = state.scene();
  update(state, action::HuntBug{1});
  CHECK_FALSE(state.bugs.hunt);
  CHECK_FALSE(state.walk.bug);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK(state.scene() == mine);
}

TEST_CASE("a surprise is a bug that is not found yet, and its number is not told before the end") {
  BugRoom bugs;
  std::set<int> drawn;
  for (unsigned draw = 0; draw < 40; ++draw) drawn.insert(surprising_bug(bugs, draw));
  CHECK(drawn.size() == values_of<Fault>.size());
  for (std::size_t i = 0; i < bugs.ends.size(); ++i)
    if (i != 4) bugs.ends[i] = BugEnd::found;
  for (unsigned draw = 0; draw < 40; ++draw) CHECK(surprising_bug(bugs, draw) == 5);
  bugs.ends[4] = BugEnd::found;
  for (unsigned draw = 0; draw < 40; ++draw) {
    CHECK(surprising_bug(bugs, draw) >= 1);
    CHECK(surprising_bug(bugs, draw) <= static_cast<int>(values_of<Fault>.size()));
  }
  State state = hunting(6, true);
  CHECK(bug_panel(state).heading == text("bug.surprise_title", in_english));
  update(state, action::ShowCure{});
  CHECK(bug_panel(state).heading == "Bug 6");
}

TEST_CASE("what is chosen and copied during a hunt stays when it is left") {
  State state = hunting(1);
  update(state, action::SetTweens{true});
  update(state, action::SetTouch{true});
  update(state, action::SetEnglishCode{true});
  update(state, action::SetTab{TreeRoom::tab});
  update(state, action::CopyLink{});
  const int copies = state.link.copies;
  const std::string copied = state.link.copied;
  REQUIRE_FALSE(copied.empty());
  update(state, action::LeaveHunt{});
  CHECK(state.walk.tweens);
  CHECK(state.appearance.touch);
  CHECK(state.appearance.english_code);
  CHECK(state.appearance.tab == PictureRoom::tab);  // as before the hunt
  CHECK(state.link.copies == copies);
  CHECK(state.link.copied == copied);
}
