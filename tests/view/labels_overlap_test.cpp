// Texts of the plan and their leaders in every step of every lesson and in every shipped scene: none over another, nor
// over SCREEN, EYE, a light, a handle, or the sky and its curve.
#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "lesson_state.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/languages.h"
#include "view/space/lines_view.h"
#include "view/text/shown.h"
#include "view/text/text.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct Box {
  Vec2d min, max;
  [[nodiscard]] bool meets(const Box& other) const {
    return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
  }
  [[nodiscard]] bool meets(const Vec2d& from, const Vec2d& to) const {
    constexpr int pieces = 64;
    for (int i = 0; i <= pieces; ++i) {
      const Vec2d at = from + static_cast<double>(i) / pieces * (to - from);
      if (at.x > min.x && at.x < max.x && at.y > min.y && at.y < max.y) return true;
    }
    return false;
  }
};

/// Around the letters: text_width() is generous, and lines have air above and below.
struct Words {
  std::string text;
  Box box;
  bool whole = true;  ///< in the pane
};

std::vector<Words> texts_in(const DisplayList& list, const Viewport& pane) {
  std::vector<Words> all;
  const TextItem* before = nullptr;
  for (const DisplayItem& item : list) {
    const auto* text = std::get_if<TextItem>(&item.shape);
    if (text == nullptr) {
      continue;
    }
    const double width = 0.72 * text_width(text->text, text->size), half = 0.38 * text->size;
    const double left = text->at.x - (text->anchor == TextAnchor::middle ? width / 2
                                      : text->anchor == TextAnchor::end  ? width
                                                                         : 0);
    const Box box{{left, text->at.y - half}, {left + width, text->at.y + half}};
    const bool second = before != nullptr && before->at.x == text->at.x && before->anchor == text->anchor &&
                        std::abs(text->at.y - before->at.y - text->size) < 1e-6;
    if (second) {
      Box& whole = all.back().box;
      whole = {{std::min(whole.min.x, box.min.x), whole.min.y}, {std::max(whole.max.x, box.max.x), box.max.y}};
      all.back().text += " " + text->text;
    } else {
      all.push_back({text->text, box});
    }
    before = text;
  }
  for (Words& each : all)
    each.whole =
        each.box.min.x >= 0 && each.box.min.y >= 0 && each.box.max.x <= pane.width && each.box.max.y <= pane.height;
  return all;
}

/// Those that state a number, such as "t = 2.05".
std::vector<Words> numbers_of(const DisplayList& list, const Viewport& pane) {
  std::vector<Words> all = texts_in(list, pane);
  std::erase_if(all, [](const Words& words) { return words.text.find(" = ") == std::string::npos; });
  return all;
}

/// Whether a line, which is thinner than samples are apart, runs through a box.
bool runs_through(const DisplayItem& item, const Box& box) {
  if (const auto* line = std::get_if<LineItem>(&item.shape)) return box.meets(line->from, line->to);
  if (const auto* curve = std::get_if<PolylineItem>(&item.shape))
    for (std::size_t i = 0; i + 1 < curve->points.size(); ++i)
      if (box.meets(curve->points[i], curve->points[i + 1])) return true;
  return false;
}

bool covers(const DisplayItem& item, const Box& box) {
  if (runs_through(item, box)) return true;
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 4; ++j)
      if (distance_to(item, box.min + Vec2d(i / 16.0, j / 4.0) * (box.max - box.min)) == 0) return true;
  return false;
}

bool lies_on(const DisplayItem& item, const Box& box) {
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 4; ++j)
      if (distance_to(item, box.min + Vec2d(i / 16.0, j / 4.0) * (box.max - box.min)) > 0) return false;
  return true;
}

/// The unshot light of a patch.
bool is_bar(const State& state, const DisplayItem& item) {
  const auto* line = std::get_if<LineItem>(&item.shape);
  const Sizes sizes(state);
  return line != nullptr && !item.target && state.walk.timeline->of_radiosity() &&
         line->stroke.colour == palette(state.appearance.theme).light && length(line->to - line->from) > 8 * sizes.unit;
}

/// The borders of the sky, and the curve beside it.
bool is_sky(const DisplayItem& item) {
  const auto* curve = std::get_if<PolylineItem>(&item.shape);
  return curve != nullptr && !item.target && curve->points.size() > 100;
}

/// From a text to what it is of.
bool is_leader(const State& state, const DisplayItem& item) {
  const auto* line = std::get_if<LineItem>(&item.shape);
  return line != nullptr && !item.target && line->arrow == 0 &&
         line->stroke.colour == palette(state.appearance.theme).text.with_alpha(190);
}

bool leads_over(const LineItem& leader, const DisplayItem& item) {
  constexpr int pieces = 64;
  for (int i = 0; i <= pieces; ++i)
    if (distance_to(item, leader.from + static_cast<double>(i) / pieces * (leader.to - leader.from)) == 0) return true;
  return false;
}

bool cross_each_other(const LineItem& a, const LineItem& b) {
  const auto sides = [](const LineItem& line, const LineItem& of) {
    const Vec2d along = line.to - line.from;
    return cross(along, of.from - line.from) * cross(along, of.to - line.from) < 0;
  };
  return sides(a, b) && sides(b, a);
}

/// What a test met.
struct Met {
  int texts = 0, over_ray = 0, leaders = 0;
};

void check_leaders(const State& state, const DisplayList& list, const std::vector<Words>& words, Met& met) {
  for (const DisplayItem& item : list) {
    if (!is_leader(state, item)) continue;
    ++met.leaders;
    const auto& leader = std::get<LineItem>(item.shape);
    // Its own text is the one that it begins at.
    const auto distance = [&](const Words& each) {
      const Vec2d nearest(std::clamp(leader.from.x, each.box.min.x, each.box.max.x),
                          std::clamp(leader.from.y, each.box.min.y, each.box.max.y));
      return length(nearest - leader.from);
    };
    const auto own = std::min_element(words.begin(), words.end(),
                                      [&](const Words& a, const Words& b) { return distance(a) < distance(b); });
    REQUIRE(own != words.end());
    INFO("the leader of \"" << own->text << '"');
    for (const Words& each : words) {
      INFO("over \"" << each.text << '"');
      CHECK((each.text == own->text || !each.box.meets(leader.from, leader.to)));
    }
    for (const DisplayItem& other : list)
      if (is_leader(state, other)) CHECK_FALSE(cross_each_other(leader, std::get<LineItem>(other.shape)));
    for (const DisplayItem& under : list)
      if (under.target.kind == TargetKind::cell || under.target.kind == TargetKind::eye ||
          under.target.kind == TargetKind::light) {
        INFO("over " << name_of(under.target.kind));
        CHECK_FALSE(leads_over(leader, under));
      }
  }
}

/// That no text and no leader lies over what it should not lie on.
void check(const State& state, Met& met) {
  const DisplayList list = plan_view(state);
  const std::vector<Words> words = texts_in(list, state.plan.viewport);
  for (std::size_t a = 0; a < words.size(); ++a) {
    INFO('"' << words[a].text << '"');
    CHECK(words[a].whole);
    for (std::size_t b = a + 1; b < words.size(); ++b) {
      INFO("and \"" << words[b].text << '"');
      CHECK_FALSE(words[a].box.meets(words[b].box));
    }
    bool over_ray = false;
    for (const DisplayItem& item : list) {
      switch (item.target.kind) {
        case TargetKind::cell:
        case TargetKind::eye:
        case TargetKind::light:
        case TargetKind::light_radius:
        case TargetKind::radius:
        case TargetKind::corner:
        case TargetKind::rotation:
        case TargetKind::view_direction:
        case TargetKind::screen_height:
        case TargetKind::screen_distance: {
          INFO("over " << name_of(item.target.kind));
          CHECK_FALSE(covers(item, words[a].box));
          break;
        }
        case TargetKind::ray:
          if (const auto* line = std::get_if<LineItem>(&item.shape))
            over_ray = over_ray || words[a].box.meets(line->from, line->to);
          break;
        case TargetKind::nothing: {
          INFO("over the sky, or over a bar");
          CHECK_FALSE(((is_sky(item) || is_bar(state, item)) && covers(item, words[a].box)));
          break;
        }
        case TargetKind::object:
        case TargetKind::edge:
          break;
      }
    }
    ++met.texts;
    met.over_ray += over_ray;
  }
  check_leaders(state, list, words, met);
  // What a lesson speaks of most has its name, wherever it stands.
  const Vec2d eye = to_pixels(state.plan.camera, state.plan.viewport, plan(state.scene().camera.eye));
  const bool in_sight =
      eye.x > 0 && eye.y > 0 && eye.x < state.plan.viewport.width && eye.y < state.plan.viewport.height;
  const std::string name(text("object.eye", state.appearance.language));
  INFO("EYE at " << eye.x << ", " << eye.y);
  CHECK((!in_sight || std::any_of(words.begin(), words.end(), [&](const Words& each) { return each.text == name; })));
}

/// In space, where names lie on what they name, and buttons on the pane. Returns how many there are.
std::size_t check_in_space(const State& state) {
  const Viewport& pane = state.plan.viewport;
  const Vec2d buttons = Sizes(state).unit * Vec2d(100, 42);
  const Box covered{{pane.width - buttons.x, 0.0}, {pane.width, buttons.y}};
  const std::vector<Words> words = texts_in(lines_view(state, pane, buttons), pane);
  for (std::size_t a = 0; a < words.size(); ++a) {
    INFO('"' << words[a].text << '"');
    CHECK(words[a].whole);
    CHECK_FALSE(words[a].box.meets(covered));
    for (std::size_t b = a + 1; b < words.size(); ++b) {
      INFO("and \"" << words[b].text << '"');
      CHECK_FALSE(words[a].box.meets(words[b].box));
    }
  }
  return words.size();
}

/// What the layout leaves for the plan, in units at scale 1: of a window of 1280x720 in both themes, of 1920x1080, of
/// that at scale 2, of 2560x1440 at scale 3, where everything is drawn somewhat smaller, of 768x1024 upright, and of
/// scales 2 and 3 again with the projector's theme and long pseudocode.
struct Window {
  Viewport alone, beside_lesson;
  double scale;
};
constexpr std::array windows{Window{{857, 497}, {526, 497}, 1},   Window{{676, 330}, {345, 316}, 1},
                             Window{{1359, 857}, {1028, 857}, 1}, Window{{537, 317}, {289, 317}, 2},
                             Window{{460, 290}, {240, 290}, 2.8}, Window{{768, 310}, {437, 300}, 1},
                             Window{{400, 155}, {243, 198}, 2},   Window{{326, 197}, {246, 203}, 2.6}};

void show_in(State& state, const Viewport& units, double scale, Theme theme) {
  update(state, action::SetUiScale{scale});
  update(state, action::SetTheme{theme});
  const double unit = Sizes(state).unit;
  update(state, action::ResizePlan{{units.width * unit, units.height * unit}});
  update(state, action::FitView{});
}

}  // namespace

TEST_CASE("no text of the plan lies over what it could hide: every shipped scene") {
  Met met;
  unsigned turn = 0;
  for (const std::string& path : shipped_scenes()) {
    State state = make_state(read_document(path));
    const int middle = state.scene().camera.screen.cells / 2;
    for (const Window& window : windows)
      for (const Theme theme : {Theme::dark, Theme::projector}) {
        if (left_out(turn++, 10)) continue;
        show_in(state, window.alone, window.scale, theme);
        INFO(path << ", " << window.alone.width << " wide, " << name_of(theme));
        update(state, action::SetMode{Mode::move});
        check(state, met);
        for (const int cell : {0, middle}) {
          update(state, action::JumpToCell{cell});
          update(state, action::Step{true, Grain::pixel});
          check(state, met);
        }
      }
  }
  std::printf("scenes: %d texts, %d over a ray, %d leaders\n", met.texts, met.over_ray, met.leaders);
  CHECK(met.texts > (sanitized ? 100 : 1000));
  CHECK(met.leaders > (sanitized ? 10 : 100));
}

TEST_CASE("no text of the plan lies over what it could hide: every step of every lesson") {
  Met met;
  State state = state_with_lessons();
  unsigned turn = 0, tried = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps; ++step) {
      update(state, action::GoToLessonStep{step});
      if (state.lessons.at() == nullptr || shows_lines(state)) continue;
      const int asked = state.lessons.at()->asked, shown = state.lessons.at()->shown;
      for (const Window& window : windows) {
        if (const unsigned now = turn++; left_out(now, 20) || left_to_all(now, 3)) continue;
        const unsigned now = tried++;
        // Languages and themes in turn, so that each meets every window.
        state.appearance.language = all_languages()[now % all_languages().size()];
        show_in(state, window.beside_lesson, window.scale, now / 2 % 2 == 0 ? Theme::dark : Theme::projector);
        for (const int position : {asked, shown})
          for (const Tab tab : {PictureRoom::tab, EquationRoom::tab}) {
            update(state, action::Jump{position});
            update(state, action::SetTab{tab});
            INFO(entry.name << ", step " << step + 1 << " at " << position << ", " << state.plan.viewport.width
                            << " wide, " << name_of(state.appearance.theme) << ", " << state.appearance.language.code()
                            << ", " << tab.word);
            check(state, met);
          }
      }
    }
  }
  std::printf("lessons: %d texts, %d over a ray, %d leaders\n", met.texts, met.over_ray, met.leaders);
  CHECK(met.texts > (sanitized ? 100 : 1000));
  CHECK(met.leaders > (sanitized ? 10 : 100));
}

TEST_CASE("each thing of a scene has its name in the plan, however small the plan is") {
  std::size_t named = 0;
  unsigned turn = 0;
  for (const char* name : {"beams", "caustic", "classic", "cones", "filters", "glass", "milk", "mirrors", "penumbra"}) {
    State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml"));
    const int middle = state.scene().camera.screen.cells / 2;
    for (const Window& window : windows)
      for (const Language language : all_languages()) {
        if (left_out(turn++, 7)) continue;
        state.appearance.language = language;
        show_in(state, window.alone, window.scale, turn % 2 == 0 ? Theme::dark : Theme::projector);
        for (const int cell : {0, middle}) {
          update(state, action::JumpToCell{cell});
          update(state, action::Step{true, Grain::pixel});
          const DisplayList list = plan_view(state);
          const std::vector<Words> words = texts_in(list, state.plan.viewport);
          std::vector<std::string> wanted{std::string(text("object.screen", language))};
          for (const Light& light : state.scene().lights) wanted.push_back(shown_name(state, light.name));
          for (const DisplayItem& item : list)
            if (item.target.kind == TargetKind::object) wanted.push_back(object_name(state, item.target.index));
          for (const std::string& each : wanted) {
            INFO(each << " of " << name << ", " << state.plan.viewport.width << " wide, " << language.code());
            CHECK(std::any_of(words.begin(), words.end(), [&](const Words& shown) { return shown.text == each; }));
            ++named;
          }
        }
      }
  }
  CHECK(named > (sanitized ? 100U : 1000U));
}

TEST_CASE("floor and ceiling of a room have their names inside of it") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"14-radiosity"});
  update(state, action::GoToLessonStep{0});
  int named = 0;
  for (const Window& window : windows) {
    show_in(state, window.beside_lesson, window.scale, Theme::projector);
    const DisplayList list = plan_view(state);
    for (const Words& words : texts_in(list, state.plan.viewport)) {
      if (words.text != "Floor" && words.text != "Ceiling") continue;
      INFO(words.text << ", " << window.beside_lesson.width << " wide");
      ++named;
      CHECK(std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
        return item.target.kind == TargetKind::object && object_name(state, item.target.index) == words.text &&
               lies_on(item, words.box);
      }));
      CHECK(std::none_of(list.begin(), list.end(), [&](const DisplayItem& item) {
        return !item.target && std::get_if<LineItem>(&item.shape) != nullptr && runs_through(item, words.box);
      }));
    }
  }
  CHECK(named > 8);
}

TEST_CASE("in space no name lies over another or below the buttons, in any lesson and on a telephone") {
  State state = state_with_lessons();
  const Window telephone{{411, 155}, {411, 155}, 0.875};
  std::size_t names = 0;
  unsigned turn = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps; ++step) {
      update(state, action::GoToLessonStep{step});
      if (state.lessons.at() == nullptr || !shows_lines(state)) continue;
      for (const Language language : all_languages())
        for (const Theme theme : {Theme::dark, Theme::projector})
          for (const Window& window : {windows[0], windows[3], windows[4], windows[5], telephone}) {
            if (const unsigned now = turn++; left_out(now, 7) || left_to_all(now, 7)) continue;
            state.appearance.language = language;
            show_in(state, window.beside_lesson, window.scale, theme);
            INFO(entry.name << ", step " << step + 1 << ", " << state.plan.viewport.width << " x "
                            << state.plan.viewport.height << ", " << language.code() << ", " << name_of(theme));
            names += check_in_space(state);
          }
    }
  }
  CHECK(names > (!sanitized && thorough() ? 1000U : 100U));
}

TEST_CASE("hardly a number beside a hit lies on the outline of a body, in the lessons that read them from the plan") {
  int seen = 0, crossed = 0;
  State state = state_with_lessons();
  for (const char* lesson : {"05-refraction", "09-numbers-lie"}) {
    update(state, action::OpenLesson{lesson});
    for (int step = 0; step < 3; ++step) {
      update(state, action::GoToLessonStep{step});
      REQUIRE(state.lessons.at() != nullptr);
      for (const Window& window : {windows[0], windows[2]})
        for (const int position : {state.lessons.at()->asked, state.lessons.at()->shown}) {
          show_in(state, window.beside_lesson, window.scale, Theme::dark);
          update(state, action::Jump{position});
          update(state, action::SetTab{EquationRoom::tab});
          const DisplayList list = plan_view(state);
          for (const Words& words : numbers_of(list, state.plan.viewport)) {
            ++seen;
            // Wholly on each body, or wholly beside it.
            crossed += std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
              return item.target.kind == TargetKind::object && std::get_if<PolylineItem>(&item.shape) == nullptr &&
                     covers(item, words.box) && !lies_on(item, words.box);
            });
          }
        }
    }
  }
  std::printf("numbers: %d, %d over an outline\n", seen, crossed);
  CHECK(seen > 20);
  CHECK(10 * crossed <= seen);
}

TEST_CASE("EYE and the lights keep off the sky and the curve beside it") {
  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/open_air.toml"));
  int met = 0;
  for (const Window& window : windows)
    for (const Mode mode : {Mode::move, Mode::trace}) {
      show_in(state, window.alone, window.scale, Theme::projector);
      update(state, action::SetMode{mode});
      const DisplayList list = plan_view(state);
      for (const DisplayItem& curve : list) {
        if (!is_sky(curve)) continue;
        const auto* line = std::get_if<PolylineItem>(&curve.shape);
        for (const DisplayItem& symbol : list)
          if (symbol.target.kind == TargetKind::eye || symbol.target.kind == TargetKind::light) {
            INFO(window.alone.width << " wide, " << name_of(symbol.target.kind));
            ++met;
            CHECK(std::none_of(line->points.begin(), line->points.end(),
                               [&](const Vec2d& at) { return distance_to(symbol, at) == 0; }));
          }
      }
    }
  CHECK(met > 100);
}

TEST_CASE("hardly a name lies on the edge of a beam") {
  int seen = 0, crossed = 0;
  State state = make_state(read_document(RAYWALK_SOURCE_DIR "/scenes/beams.toml"));
  const int middle = state.scene().camera.screen.cells / 2;
  unsigned turn = 0;
  for (const Window& window : windows)
    for (const Language language : all_languages()) {
      state.appearance.language = language;
      show_in(state, window.alone, window.scale, turn++ % 2 == 0 ? Theme::dark : Theme::projector);
      const Colour edge = ray_style(state.appearance.theme, RayKind::beam).colour;
      for (const int cell : {0, middle}) {
        update(state, action::JumpToCell{cell});
        update(state, action::Step{true, Grain::pixel});
        const DisplayList list = plan_view(state);
        for (const Words& words : texts_in(list, state.plan.viewport)) {
          ++seen;
          crossed += std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
            const auto* line = std::get_if<LineItem>(&item.shape);
            return line != nullptr && line->stroke.colour.with_alpha(255) == edge &&
                   words.box.meets(line->from, line->to);
          });
        }
      }
    }
  std::printf("beams: %d texts, %d over an edge\n", seen, crossed);
  CHECK(25 * crossed < seen);
}
