// The Microscope panel without a window: its drawing, its table, and the scene's numerics.
#include "view/microscope/microscope.h"

#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr Viewport pane{480, 400};

void set_precision(State& state, bool single) {
  ImageSettings settings = state.picture.settings;
  settings.single_precision = single;
  update(state, action::SetImageSettings{settings});
}

State walking(const std::string& name, bool single = true) {
  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml"));
  update(state, action::SetMode{Mode::trace});
  set_precision(state, single);
  return state;
}

/// Goes to the first hit at which `fits` of the specimen holds.
template <class Fits>
std::shared_ptr<const Specimen> find(State& state, Fits fits) {
  Microscope microscope;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    const auto seen = specimen_of(microscope, state);
    if (seen && fits(*seen)) return seen;
  }
  return nullptr;
}

std::vector<std::string> texts_of(const DisplayList& list) {
  std::vector<std::string> texts;
  for (const DisplayItem& item : list)
    if (const auto* words = std::get_if<TextItem>(&item.shape)) texts.push_back(words->text);
  return texts;
}
bool says(const DisplayList& list, const std::string& words) {
  const auto texts = texts_of(list);
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& each) { return each.find(words) != std::string::npos; });
}

bool acne(const Specimen& seen) {
  return seen.naive && std::any_of(seen.naive->spawned.begin(), seen.naive->spawned.end(),
                                   [](const SpawnedRays& rays) { return rays.hit_own > 0; });
}

}  // namespace

TEST_CASE("numerics are an edit of the scene: the walk has them, and undo takes them back") {
  State state = walking("classic");
  const auto robust = state.walk.timeline;
  const std::uint64_t revision = state.document.revision;
  update(state, action::SetNumerics{Numerics::naive, 0});
  CHECK(state.scene().render.numerics == Numerics::naive);
  CHECK(state.scene().render.epsilon == 0);
  CHECK(state.document.dirty);
  CHECK(state.document.revision != revision);
  CHECK(pictured_scene(state)->render.numerics == Numerics::naive);
  // Rays that meet the surface they leave: this walk is another one.
  CHECK(state.walk.timeline->steps() != robust->steps());
  update(state, action::Undo{});
  CHECK(state.scene().render.numerics == Numerics::robust);
  CHECK(state.walk.timeline->steps() == robust->steps());
  update(state, action::Redo{});
  CHECK(state.scene().render.numerics == Numerics::naive);

  const std::size_t entries = state.document.undo.size();
  for (const double epsilon : {1e-4, 1e-3, 1e-2})
    update(state, action::SetNumerics{Numerics::naive, epsilon, epsilon > 1e-4});
  CHECK(state.document.undo.size() == entries + 1);
  for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) update(state, action::SetNumerics{Numerics::naive, bad});
  CHECK(state.scene().render.epsilon == 1e-2);
}

TEST_CASE("magnification stays between the whole scene and single numbers") {
  State state = walking("classic");
  update(state, action::Magnify{7});
  CHECK(state.microscope.magnified == 1);
  update(state, action::Magnify{std::nan("")});
  CHECK(state.microscope.magnified == 1);
  update(state, action::Magnify{-1});
  CHECK(state.microscope.magnified == 0);
}

TEST_CASE("the drawing is finite and within reason at every magnification, in every scene") {
  for (const std::string& path : shipped_scenes()) {
    CAPTURE(path);
    State state = make_state(read_document(path));
    update(state, action::SetMode{Mode::trace});
    for (const bool single : {false, true}) {
      set_precision(state, single);
      Microscope microscope;
      const int steps = state.walk.timeline->steps();
      for (int i = 1; i <= 6; ++i) {
        update(state, action::Jump{steps * i / 6});
        const auto seen = specimen_of(microscope, state);
        if (!seen) continue;
        for (const double part : {0.0, 0.5, 1.0}) {
          update(state, action::Magnify{part});
          const DisplayList list = microscope_view(state, *seen, pane);
          CHECK(is_finite(list));
          CHECK(list.size() < 8000);
        }
        const MicroscopeTable table = microscope_table(state, *seen);
        CHECK((seen->passed >= 0 || table.rows.size() >= 4));
        CHECK_FALSE(table.sentence.empty());
        CHECK(table.sentence.find('{') == std::string::npos);
        for (const MicroscopeTable::Row& row : table.rows) {
          CHECK_FALSE(row.robust.empty());
          CHECK_FALSE(row.naive.empty());
        }
      }
    }
  }
}

TEST_CASE("fully magnified a cell is an ulp, and says so; at the whole scene nothing is magnified") {
  for (const bool single : {false, true}) {
    State state = walking("classic", single);
    const auto seen = find(state, [](const Specimen& s) { return s.robust && s.spacing.x == s.spacing.y; });
    REQUIRE(seen);
    update(state, action::Magnify{0});
    CHECK(magnification(state, *seen, pane) == 1);
    update(state, action::Magnify{1});
    const DisplayList list = microscope_view(state, *seen, pane);
    CHECK(says(list, "1 cell = 1 ulp = " + std::string(single ? "2.38 · 10⁻⁷" : "4.44 · 10⁻¹⁶")));
    // Upright lines of the grid stand one spacing apart.
    std::set<double> upright;
    for (const DisplayItem& item : list)
      if (const auto* line = std::get_if<LineItem>(&item.shape);
          line != nullptr && line->from.x == line->to.x && line->from.y == 0 && line->to.y == pane.height)
        upright.insert(line->from.x);
    REQUIRE(upright.size() > 5);
    const double scale =
        magnification(state, *seen, pane) * fit(state.scene(), pane, Sizes(state).unit).pixels_per_unit;
    for (auto next = std::next(upright.begin()); next != upright.end(); ++next)
      CHECK(std::abs(*next - *std::prev(next) - scale * seen->spacing.x) < 1e-6);
  }
}

TEST_CASE("naive and robust marks differ in shape, and what is out of sight is pointed at") {
  State state = walking("classic");
  update(state, action::Magnify{1});
  const auto seen = find(state, [](const Specimen& s) {
    return s.robust && s.naive && s.in_ulps(length(s.naive->point - s.robust->point)) < 3;
  });
  REQUIRE(seen);
  const DisplayList list = microscope_view(state, *seen, pane);
  CHECK(says(list, "robust"));
  CHECK(says(list, "naive"));
  // Epsilon is hundreds of ulps.
  CHECK(says(list, " ulp that way"));
  const auto discs = std::count_if(list.begin(), list.end(), [](const DisplayItem& item) {
    const auto* circle = std::get_if<CircleItem>(&item.shape);
    return circle != nullptr && circle->radius > 5;
  });
  const auto triangles = std::count_if(list.begin(), list.end(), [](const DisplayItem& item) {
    const auto* polygon = std::get_if<PolygonItem>(&item.shape);
    return polygon != nullptr && polygon->points.size() == 3 && polygon->stroke && !polygon->fill;
  });
  CHECK(discs == 1);
  CHECK(triangles == 1);
}

TEST_CASE("in a pane narrower than its words they stand in two lines, whole, in every language") {
  constexpr Viewport narrow{208, 170};
  State state = walking("classic", false);
  for (const Language language : all_languages()) {
    int of_two = 0;
    for (const double part : {0.2, 0.4, 1.0}) {
      state.appearance.language = language;
      update(state, action::Magnify{part});
      const auto seen = find(state, [](const Specimen& s) { return s.robust && s.naive; });
      REQUIRE(seen);
      const TextItem* before = nullptr;
      const DisplayList list = microscope_view(state, *seen, narrow);
      for (const DisplayItem& item : list) {
        const auto* words = std::get_if<TextItem>(&item.shape);
        if (words == nullptr || words->anchor != TextAnchor::middle) continue;
        of_two += before != nullptr && before->at.x == words->at.x &&
                  std::abs(words->at.y - before->at.y - words->size) < 1e-6;
        before = words;
        INFO(language.code() << ", " << part << ": " << words->text);
        const double half = 0.36 * text_width(words->text, words->size);  // text_width() is generous
        CHECK(words->at.x - half >= 0);
        CHECK(words->at.x + half <= narrow.width);
        CHECK(words->at.y - 0.38 * words->size >= 0);
        CHECK(words->at.y + 0.38 * words->size <= narrow.height);
      }
    }
    INFO(language.code());
    CHECK(of_two > 0);
  }
}

TEST_CASE("acne is called acne, and robust numerics are said to leave") {
  State state = walking("classic");
  update(state, action::SetNumerics{Numerics::robust, 0});
  const auto seen = find(state, acne);
  REQUIRE(seen);
  const MicroscopeTable table = microscope_table(state, *seen);
  CHECK(table.sentence.find("acne") != std::string::npos);
  const auto row = std::find_if(table.rows.begin(), table.rows.end(), [](const MicroscopeTable::Row& each) {
    return each.naive.find("itself") != std::string::npos;
  });
  REQUIRE(row != table.rows.end());
  CHECK(row->wrong);
  CHECK(row->robust == "leaves");
}

TEST_CASE("where the surface is not known to the ulp, the sentence says how far naive rays start, as the table does") {
  const State state = classic_state();
  Specimen specimen;
  specimen.ulp = 0.25;
  specimen.robust = Reading{};
  specimen.robust->object = 0;
  specimen.robust->starts = {{}};
  specimen.naive = specimen.robust;
  specimen.naive->point = {16, 0, 0};
  specimen.naive->starts = {{{18, 0, 0}}};
  const MicroscopeTable table = microscope_table(state, specimen);
  CHECK(table.sentence.find("64 ulp apart") != std::string::npos);
  CHECK(table.sentence.find("Naive rays start 8.0 ulp away") != std::string::npos);
}

TEST_CASE("what leaves a point is not shown while it is to be predicted") {
  State state = walking("classic");
  const auto seen = find(state, [](const Specimen& each) { return each.robust && !each.robust->spawned.empty(); });
  REQUIRE(seen);
  const std::size_t rows = microscope_table(state, *seen).rows.size(),
                    items = microscope_view(state, *seen, pane).size();
  state.predictions.on = true;
  const MicroscopeTable table = microscope_table(state, *seen);
  CHECK(table.rows.size() + seen->robust->spawned.size() == rows);
  CHECK(table.sentence == text("microscope.predict_first", in_english));
  CHECK(microscope_view(state, *seen, pane).size() < items);
}

TEST_CASE("a t near 0 keeps its power of ten") {
  State state = walking("classic", false);
  const auto seen = find(state, [](const Specimen& each) { return each.robust && each.naive; });
  REQUIRE(seen);
  Specimen near = *seen;
  near.robust->t = 1.2345678901234567e-5;
  near.naive->t = 9.8765432109876543e-123;
  const MicroscopeTable table = microscope_table(state, near);
  const auto row = std::find_if(table.rows.begin(), table.rows.end(), [](const MicroscopeTable::Row& each) {
    return each.robust == "1.23456\u20268 · 10⁻⁵";
  });
  REQUIRE(row != table.rows.end());
  CHECK(row->naive == "9.87654\u2026 · 10⁻¹²³");
}

TEST_CASE("numbers of ulps are short") {
  CHECK(ulps_text(0.25, in_english) == "0.2");
  CHECK(ulps_text(3, in_english) == "3.0");
  CHECK(ulps_text(1678.2, in_english) == "1678");
  CHECK(ulps_text(4.5e11, in_english) == "4.5 · 10¹¹");
}
