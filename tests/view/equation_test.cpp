// The live equation, held against the trace: no number that is not the trace's own.
#include "view/walk/equation.h"

#include "fixtures.h"
#include "timeline/event_json.h"
#include "trace/microfacets.h"
#include "view/plan/plan_view.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using Json = nlohmann::ordered_json;

/// All numbers that stand in an event.
void gather(const Json& json, std::vector<double>& numbers) {
  if (json.is_number()) numbers.push_back(json.get<double>());
  if (json.is_structured())
    for (const Json& each : json) gather(each, numbers);
}

double degrees(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }

/// What the panel may show at a position: the numbers of the event and of the rays that it speaks of, and the angles,
/// lengths and products of these that the formulas name.
std::vector<double> allowed(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const Scene& scene = state.scene();
  std::vector<double> numbers{0,
                              1,
                              90,
                              scene.limits.threshold,
                              static_cast<double>(scene.limits.depth),
                              static_cast<double>(scene.camera.screen.cells - 1)};
  for (const Object& object : scene.objects) numbers.push_back(object.material.ior);
  const auto add_event = [&](int index) { gather(event_json(scene, timeline.event(index)), numbers); };
  add_event(state.walk.position - 1);
  const Event& event = *timeline.just_run(state.walk.position);
  numbers.push_back(event.depth);
  numbers.push_back(event.depth + 1);
  std::vector<Vec3d> directions, normals;
  for (int ray = timeline.current_ray(state.walk.position); ray >= 0;) {
    const RayRecord& record = timeline.rays()[static_cast<std::size_t>(ray)];
    add_event(record.formed_at - 1);
    if (record.found_at <= state.walk.position) add_event(record.found_at - 1);
    directions.push_back(record.direction);
    if (record.found_at <= state.walk.position && record.object >= 0) normals.push_back(record.normal);
    ray = record.parent;
  }
  if (const auto* formed = std::get_if<RayFormed>(&event.detail); formed != nullptr && formed->snell)
    for (const double cosine : {formed->snell->cos_in, formed->snell->cos_out}) numbers.push_back(degrees(cosine));
  // A small mirror that reflects the one direction into the other, and what its metal keeps.
  if (const auto* formed = std::get_if<RayFormed>(&event.detail);
      formed != nullptr && formed->kind == RayKind::reflect && directions.size() > 1) {
    const Vec3d half = normalize(directions[0] - directions[1]);
    for (const double part : {half.x, half.y, half.z}) numbers.push_back(part);
    numbers.push_back(dot(half, directions[1]));
    const int parent = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))].parent;
    const int object = timeline.rays()[static_cast<std::size_t>(parent)].object;
    const Microsurface<double> mirrors(scene.objects[static_cast<std::size_t>(object)].material);
    const Rgbd kept = mirrors.reflectance(std::abs(dot(half, directions[1])));
    for (const double part : {kept.x, kept.y, kept.z}) numbers.push_back(part);
  }
  for (const Vec3d& d : directions) numbers.push_back(length(d));
  for (const Vec3d& n : normals) {
    for (const double part : {n.x, n.y, n.z}) numbers.push_back(-part);
    for (const Vec3d& d : directions) {
      numbers.push_back(-std::abs(dot(n, d)));
      numbers.push_back(degrees(std::abs(dot(n, d)) / length(d)));
      numbers.push_back(180 - numbers.back());
    }
  }
  return numbers;
}

/// Arc cosines of nearly 1 keep half of the digits.
bool close(double a, double b) {
  return a == b || std::abs(a - b) <= std::max(1e-9 * std::max(std::abs(a), std::abs(b)), 3e-6);
}

State walking(const std::string& name) {
  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml"));
  update(state, action::SetMode{Mode::trace});
  return state;
}

const EquationRow* row_with(const EquationPanel& panel, const std::string& text) {
  for (const EquationRow& row : panel.rows)
    if (row.text.find(text) != std::string::npos) return &row;
  return nullptr;
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

double number_shown(std::string shown) {
  replace(shown, "\u2212", "-");
  if (const std::size_t power = shown.find(" \u00b7 10"); power != std::string::npos) {
    std::string exponent = shown.substr(power + std::string(" \u00b7 10").size());
    const std::string raised[]{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                               "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    replace(exponent, "\u207b", "-");
    for (std::size_t digit = 0; digit < 10; ++digit) replace(exponent, raised[digit], std::to_string(digit));
    shown = shown.substr(0, power) + "e" + exponent;
  }
  return std::stod(shown);
}

}  // namespace

TEST_CASE("a whole walk never shows a number that is not the trace's own") {
  for (const std::string name : {"classic", "glass", "glass_in_water"}) {
    State state = walking(name);
    int compared = 0;
    for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
      state.walk.position = position;
      const std::vector<double> known = allowed(state);
      const EquationPanel panel = equation_panel(state);
      INFO(name << ", position " << position << ", " << panel.title);
      REQUIRE_FALSE(panel.rows.empty());
      CHECK(panel.title == pseudocode_of(state.walk.timeline->just_run(position)->line).text);
      for (const EquationRow& row : panel.rows) {
        INFO(row.text);
        std::size_t at = 0;
        for (const double value : row.values) {
          REQUIRE(std::any_of(known.begin(), known.end(), [&](double each) { return close(each, value); }));
          // And the text shows it, in its place.
          const std::string shown = equation_number(value, in_english);
          at = row.text.find(shown, at);
          REQUIRE(at != std::string::npos);
          at += shown.size();
          REQUIRE(std::abs(number_shown(shown) - value) <= 5.1e-4 * std::abs(value));
          ++compared;
        }
      }
    }
    CHECK(compared > 2 * state.walk.timeline->steps());
  }
}

TEST_CASE("a quadratic is solved by the root that is taken, and the note says which") {
  State state = walking("classic");
  int first = 0, second = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    const auto* found = std::get_if<Found>(&state.walk.timeline->event(position - 1).detail);
    const auto* q = found == nullptr ? nullptr : std::get_if<QuadraticNumbers>(&found->numbers);
    if (q == nullptr || found->object < 0) continue;
    state.walk.position = position;
    const EquationPanel panel = equation_panel(state);
    const EquationRow* roots = row_with(panel, "t₀ = ");
    REQUIRE(roots != nullptr);
    for (const double t : roots->values) CHECK(std::abs(q->a * t * t + q->b * t + q->c) < 1e-9);
    const bool nearer = std::abs(found->t - roots->values[0]) < std::abs(found->t - roots->values[1]);
    CHECK((row_with(panel, nearer ? "t₀: " : "t₁: ") != nullptr));
    CHECK((row_with(panel, nearer ? "t₁: " : "t₀: ") == nullptr));
    (nearer ? first : second) += 1;
  }
  CHECK(first > 0);
  CHECK(second > 0);
}

TEST_CASE("where a surface is cut off the note says so, and a cap is a plane") {
  State state = walking("quadrics");
  int cut = 0, capped = 0;
  for (const auto& [column, row] : {std::pair{120, 180}, std::pair{780, 140}}) {
    update(state, action::WalkPixel{column, row, {961, 601}});
    for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
      const auto* found = std::get_if<Found>(&state.walk.timeline->event(position - 1).detail);
      if (found == nullptr || found->object < 0) continue;
      state.walk.position = position;
      const EquationPanel panel = equation_panel(state);
      if (const auto* q = std::get_if<QuadraticNumbers>(&found->numbers)) {
        const bool behind_cut = found->t > q->t0 + 1e-6 && q->t0 > 1e-6;
        CHECK((row_with(panel, "cut off") != nullptr) == behind_cut);
        CHECK((found->t == Approx(q->t0) || found->t == Approx(q->t1)));
        cut += behind_cut ? 1 : 0;
      } else if (const auto* p = std::get_if<PlaneNumbers>(&found->numbers)) {
        CHECK(found->t == Approx(p->numerator / p->denominator));
        capped += found->object == index_of_object(state.scene(), "Cylinder") ? 1 : 0;
      }
    }
  }
  CHECK(cut > 0);
  CHECK(capped > 0);
}

TEST_CASE("both sides of Snell's law are equal, and the mirror's angle is the one that it came with") {
  State state = walking("glass");
  int bent = 0, mirrored = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    state.walk.position = position;
    const EquationPanel panel = equation_panel(state);
    if (const EquationRow* law = row_with(panel, "° = "); law != nullptr) {
      const auto sine = [&](std::size_t i) { return std::sin(law->values[i] * std::numbers::pi / 180); };
      CHECK(law->values[0] * sine(1) == Approx(law->values[2] * sine(3)).epsilon(0).margin(1e-9));
      ++bent;
    }
    const auto* formed = std::get_if<RayFormed>(&state.walk.timeline->event(position - 1).detail);
    if (formed == nullptr || formed->kind != RayKind::reflect) continue;
    const RayRecord& ray =
        state.walk.timeline->rays()[static_cast<std::size_t>(state.walk.timeline->current_ray(position))];
    const RayRecord& parent = state.walk.timeline->rays()[static_cast<std::size_t>(ray.parent)];
    const EquationRow* angle = row_with(panel, "as far from the normal");
    REQUIRE(angle != nullptr);
    CHECK(angle->values[0] == Approx(degrees(std::abs(dot(parent.normal, parent.direction)))).epsilon(0).margin(1e-6));
    ++mirrored;
  }
  CHECK(bent > 3);
  CHECK(mirrored > 3);
}

TEST_CASE("a ray that depth forbids is beyond the depth, also where the effects bar limits it") {
  State state = walking("mirrors");
  REQUIRE(state.scene().limits.depth > 2);
  update(state, action::LimitDepth{2});
  int seen = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    const auto* stub = std::get_if<RayNotFormed>(&state.walk.timeline->event(position - 1).detail);
    if (stub == nullptr || stub->why != Ending::depth) continue;
    state.walk.position = position;
    const EquationPanel panel = equation_panel(state);
    const EquationRow* row = row_with(panel, " > ");
    REQUIRE(row != nullptr);
    CHECK(row->values == std::vector<double>{2, 1, 2});
    ++seen;
  }
  CHECK(seen > 0);
}

TEST_CASE("total internal reflection shows a sine above 1") {
  State state = walking("glass");
  int seen = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    const auto* decided = std::get_if<Decided>(&state.walk.timeline->event(position - 1).detail);
    if (decided == nullptr || !decided->why) continue;
    state.walk.position = position;
    const EquationPanel panel = equation_panel(state);
    const EquationRow* row = row_with(panel, " · sin ");
    REQUIRE(row != nullptr);
    CHECK(row->values[0] * std::sin(row->values[1] * std::numbers::pi / 180) / row->values[2] > 1);
    ++seen;
  }
  CHECK(seen > 0);
}

TEST_CASE("the terms of each SHADE add up to what it returns, and the last of them to the pixel") {
  State state = walking("classic");
  int sums = 0;
  Rgbd last{0.0};
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    state.walk.position = position;
    const EquationPanel panel = equation_panel(state);
    const EventDetail& detail = state.walk.timeline->event(position - 1).detail;
    if (std::holds_alternative<PixelPut>(detail)) {
      const Rgbd shade = panel.rows.back().light.value();
      CHECK(
          shade ==
          state.walk.timeline->pixels()[static_cast<std::size_t>(state.walk.timeline->current_pixel(position))].shade);
      if (sums > 0) CHECK((shade == last || shade == state.scene().background));
    }
    if (!std::holds_alternative<ShadeComputed>(detail)) continue;
    Rgbd sum{0.0}, passed{1.0};
    for (const EquationRow& row : panel.rows) {
      if (row.kind == EquationRow::Kind::term) sum += row.light.value();
      if (row.kind == EquationRow::Kind::note) passed = row.light.value();
    }
    last = panel.rows.back().light.value();
    REQUIRE(panel.rows.back().kind == EquationRow::Kind::total);
    for (int channel = 0; channel < 3; ++channel)
      CHECK(std::abs(sum[channel] * passed[channel] - last[channel]) < 1e-12);
    ++sums;
  }
  CHECK(sums > 20);
}

TEST_CASE("beside the hit stand its t and its angle while the equation is shown, and only then") {
  State state = walking("classic");
  while (hit_notes(state).angle.empty()) update(state, action::Step{});
  const auto& found = std::get<Found>(state.walk.timeline->event(state.walk.position - 1).detail);
  const HitNotes notes = hit_notes(state);
  CHECK(notes.t == "t = " + equation_number(found.t, in_english));
  const auto texts = [&] {
    std::vector<std::string> all;
    for (const DisplayItem& item : plan_view(state))
      if (const auto* text = std::get_if<TextItem>(&item.shape)) all.push_back(text->text);
    return all;
  };
  const auto shows = [&](const std::string& text) {
    const auto all = texts();
    return std::find(all.begin(), all.end(), text) != all.end();
  };
  CHECK_FALSE(shows(notes.t));
  update(state, action::SetTab{EquationRoom::tab});
  CHECK(shows(notes.t));
  CHECK(shows(notes.angle));
  CHECK(is_finite(plan_view(state)));
}

TEST_CASE("where a ray is bent or mirrored, the plan writes both angles to the normal, apart from each other") {
  State state = walking("glass");
  update(state, action::SetTab{EquationRoom::tab});
  int bent = 0, mirrored = 0, total = 0, placed = 0, written_down = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    const auto* formed = std::get_if<RayFormed>(&state.walk.timeline->event(position - 1).detail);
    const auto notes = bend_notes(state);
    const bool wanted = formed != nullptr && (formed->kind == RayKind::reflect || formed->kind == RayKind::refract);
    CAPTURE(position);
    if (notes && notes->angle_out.empty()) {  // of the ray that gets nowhere
      const auto* decided = std::get_if<Decided>(&state.walk.timeline->event(position - 1).detail);
      const auto* stub = std::get_if<RayNotFormed>(&state.walk.timeline->event(position - 1).detail);
      CHECK(((decided != nullptr && decided->why == Ending::total_internal_reflection) ||
             (stub != nullptr && stub->why == Ending::total_internal_reflection)));
      ++total;
      continue;
    }
    REQUIRE(notes.has_value() == wanted);
    if (!wanted) continue;
    CHECK(length(notes->at - formed->origin) < 1e-6);
    CHECK(dot(notes->normal, notes->back) > 0);
    CHECK((dot(notes->normal, notes->out) < 0) == (formed->kind == RayKind::refract));
    const auto written = [](const char* name, double cosine) {
      return name + fmt::format("{:.1f}", std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi) + "\u00b0";
    };
    if (formed->snell) {
      ++bent;
      CHECK(notes->angle_in == written("\u03b8\u2081 = ", formed->snell->cos_in));
      CHECK(notes->angle_out == written("\u03b8\u2082 = ", formed->snell->cos_out));
    } else {
      ++mirrored;
      CHECK(notes->angle_in.substr(notes->angle_in.find('=')) == notes->angle_out.substr(notes->angle_out.find('=')));
    }
    std::vector<TextItem> angles;
    std::vector<Vec2d> ways;  // from the hit to the text, or to where the line from it ends
    const DisplayList list = plan_view(state);
    const Vec2d at = to_pixels(state, plan(notes->at));
    for (std::size_t i = 1; i < list.size(); ++i) {
      const auto* text = std::get_if<TextItem>(&list[i].shape);
      if (text == nullptr || text->text.find("\u03b8") != 0) continue;
      const auto* leader = std::get_if<LineItem>(&list[i - 1].shape);
      const bool is_led = leader != nullptr && leader->arrow == 0 && length(leader->to - at) < 32;
      angles.push_back(*text);
      ways.push_back((is_led ? leader->to : text->at) - at);
    }
    if (angles.size() != 2) continue;  // a ray that leaves the plan has no angle there
    // Arcs are within their rays.
    const double unit = state.plan.camera.pixels_per_unit;
    const double longest = unit * std::max(notes->in_length, notes->out_length);
    for (const DisplayItem& item : list)
      if (const auto* arc = std::get_if<ArcItem>(&item.shape); arc != nullptr && length(arc->centre - at) < 1)
        CHECK(arc->radius <= 0.46 * longest);
    // On the side of the surface where its ray is, or beside it.
    const Vec2d normal(notes->normal.x, -notes->normal.y), out(notes->out.x, -notes->out.y);
    for (std::size_t i = 0; i < 2; ++i) {
      const bool is_inner = angles[i].text == notes->angle_out && notes->angle_in != notes->angle_out;
      const double side = is_inner && dot(out, normal) < 0 ? -1 : 1;
      placed += side * dot(ways[i], normal) > -0.35 * length(ways[i]);
      ++written_down;
    }
    const Vec2d apart = angles[0].at - angles[1].at;
    CHECK((std::abs(apart.x) > 20 || std::abs(apart.y) > 8));
  }
  CHECK(bent > 20);
  CHECK(mirrored > 20);
  CHECK(total > 5);
  CHECK(written_down > 50);
  CHECK(placed > 0.99 * written_down);  // the others are led to their arc from where there is room
}
