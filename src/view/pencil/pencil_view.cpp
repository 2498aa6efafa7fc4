#include "view/plan/painter.h"
#include "view/plan/plan_view.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

namespace action {

void ShowPencils::apply(State& state) const { state.pencil.shown = shown; }

void ShowNeighbours::apply(State& state) const {
  state.pencil.neighbours = shown;
  if (shown) state.pencil.shown = true;
}

}  // namespace action

namespace {

/// As long as rays that meet nothing are drawn.
constexpr double endless = 1000;

double end_of(const PencilStage& stage) { return std::min(stage.length, endless); }

Vec3d place(const PencilStage& stage, const ParaxialRay& ray, double along) {
  const Vec3d left(-stage.direction.y, stage.direction.x, 0);
  return stage.origin + along * stage.direction + (ray.offset + along * ray.slope) * left;
}

/// How far the true rays are from those of the pencil where the last stage ends, across it.
void compare(Pencil& pencil, const World<double>& world, double half_angle) {
  const PencilStage& last = pencil.stages.back();
  for (const double share : pencil_rays) {
    const double angle = share * half_angle;
    pencil.truly.push_back(true_neighbour(world, pencil.stages, angle, end_of(last)));
    const std::vector<Vec3d>& way = pencil.truly.back();
    if (std::isinf(last.length)) continue;
    if (way.size() != pencil.stages.size() + 1) {
      ++pencil.parted;
      continue;
    }
    const Vec3d from = way[way.size() - 2], along = normalize(way.back() - from);
    const Vec3d left(-last.direction.y, last.direction.x, 0), end = last.origin + last.length * last.direction;
    const double forward = dot(along, last.direction);
    if (!(forward > 0)) {
      ++pencil.parted;
      continue;
    }
    const Vec3d met = from + dot(end - from, last.direction) / forward * along;
    const ParaxialRay at = (pencil_transfer(last.length) * last.start)({0, angle});
    pencil.error = std::max(pencil.error, std::abs(dot(met - end, left) - at.offset));
  }
}

}  // namespace

namespace {

bool is_shown(const State& state, const Timeline& timeline) { return state.pencil.shown || timeline.of_pencils(); }

/// Whether the walk has come to the pencil of ray `i`. The matrix of a walked one follows its axis by a step.
bool is_there(const Timeline& timeline, int i, int position) {
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
  return ray.formed_at + (timeline.of_pencils() && ray.parent >= 0 ? 1 : 0) <= position;
}

}  // namespace

void PencilRoom::follow(State& state, const Before& /*before*/) {
  PencilRoom& room = state.pencil;
  const std::shared_ptr<const Timeline>& timeline = state.walk.timeline;
  const int position = state.walk.position;
  if (timeline == nullptr || !is_shown(state, *timeline) || !timeline->of_strip()) {
    room.of = nullptr, room.pencils.clear();
    return;
  }
  if (room.of == timeline && room.position == position && room.with_neighbours == room.neighbours) return;
  room.of = timeline, room.position = position, room.with_neighbours = room.neighbours;
  room.pencils.clear();
  const int pixel = timeline->current_pixel(position);
  if (pixel < 0 || timeline->has_width() || timeline->of_radiosity()) return;
  const auto scene = walked_scene(state);
  const auto world = state.document.worlds->of<double>(*scene, AcceleratorKind::automatic);
  const RayGenerator<double> camera = camera_of<double>(*scene, *timeline);
  const PixelRecord& of = timeline->pixels()[static_cast<std::size_t>(pixel)];
  const Vec3d left = normalize(camera.edge(of.column, of.row)), right = normalize(camera.edge(of.column + 1, of.row));
  room.half_angle = length(left - right) / length(left + right);
  const Timeline::Range range = timeline->rays_of_pixel(pixel);
  const int formed = static_cast<int>(timeline->rays_at(position).size());
  for (int i = range.first; i < std::min(range.last, formed); ++i) {
    if (!is_there(*timeline, i, position)) continue;
    Pencil pencil{i, pencil_of(*world, camera, *timeline, i)};
    if (pencil.stages.empty()) continue;
    if (room.neighbours) compare(pencil, *world, room.half_angle);
    room.pencils.push_back(std::move(pencil));
  }
}

namespace {

class PencilPainter {
 public:
  PencilPainter(Painter& painter, const PencilRoom& room) : painter_(painter), room_(room) {}

  void draw() {
    const State& state = painter_.state;
    const int current = state.walk.timeline->current_ray(state.walk.position);
    const Pencil* at_work = nullptr;
    for (const Pencil& pencil : room_.pencils) {
      const RayKind kind = ray_of(pencil).kind;
      if (!state.legend.shows(kind)) continue;
      draw(pencil, pencil.ray == current);
      if (pencil.ray == current) at_work = &pencil;
    }
    if (at_work != nullptr) say(*at_work);
  }

 private:
  [[nodiscard]] const RayRecord& ray_of(const Pencil& pencil) const {
    return painter_.state.walk.timeline->rays()[static_cast<std::size_t>(pencil.ray)];
  }
  [[nodiscard]] bool is_known(const Pencil& pencil) const {
    return ray_of(pencil).found_at <= painter_.state.walk.position;
  }
  [[nodiscard]] double length_of(const Pencil& pencil) const {
    return is_known(pencil) ? end_of(pencil.stages.back()) : endless;
  }

  void draw(const Pencil& pencil, bool strong) {
    const PencilStage& last = pencil.stages.back();
    const double end = length_of(pencil);
    const Colour colour = ray_style(painter_.state.appearance.theme, ray_of(pencil).kind).colour;
    for (std::size_t i = 0; i < std::size(pencil_rays); ++i) {
      const ParaxialRay at = last.start({0, pencil_rays[i] * room_.half_angle});
      painter_.add_clipped({painter_.pixels(plan(place(last, at, 0))), painter_.pixels(plan(place(last, at, end))),
                            Stroke{colour.with_alpha(strong ? 235 : 130), painter_.sizes.unit}});
      if (pencil.truly.empty() || !is_known(pencil)) continue;
      const std::vector<Vec3d>& way = pencil.truly[i];
      if (way.size() != pencil.stages.size() + 1) continue;
      painter_.add_clipped({painter_.pixels(plan(way[way.size() - 2])), painter_.pixels(plan(way.back())),
                            Stroke{painter_.colours.ink.with_alpha(strong ? 230 : 110), painter_.sizes.unit,
                                   painter_.scaled({{2, 3}, 2})}});
    }
    if (last.focus && std::abs(*last.focus) < endless && pencil.stages.size() > 1)
      draw_focus(pencil, *last.focus, strong);
    if (last.focus_across && std::abs(*last.focus_across) < endless && pencil.stages.size() > 1)
      draw_focus_across(pencil, *last.focus_across, strong);
  }

  /// Where the pencil folds: before its rays, or behind their start, from where they seem to come.
  void draw_focus(const Pencil& pencil, double focus, bool strong) {
    const PencilStage& last = pencil.stages.back();
    if (focus > length_of(pencil)) return;
    const Colour colour = ray_style(painter_.state.appearance.theme, ray_of(pencil).kind).colour;
    const Vec2d at = painter_.pixels(plan(last.origin + focus * last.direction));
    if (focus < 0 && !strong) return;
    if (focus < 0)
      for (const double share : {-1.0, 1.0}) {
        const ParaxialRay ray = last.start({0, share * room_.half_angle});
        painter_.add_clipped({painter_.pixels(plan(place(last, ray, 0))), at,
                              Stroke{colour.with_alpha(150), painter_.sizes.unit, painter_.scaled({{3, 5}, 2})}});
      }
    painter_.add(CircleItem{at, 5 * painter_.sizes.unit, std::nullopt, painter_.stroke(colour, strong ? 2.2 : 1.3)});
  }

  /// Where the rays above and below it meet: on a line in the plan, across the ray.
  void draw_focus_across(const Pencil& pencil, double focus, bool strong) {
    if (focus > length_of(pencil) || (focus < 0 && !strong)) return;
    const PencilStage& last = pencil.stages.back();
    const Vec2d at = painter_.pixels(plan(last.origin + focus * last.direction));
    const Vec2d along = painter_.pixels(plan(last.origin + (focus + 1) * last.direction)) - at;
    if (!(length(along) > 0)) return;
    const Vec2d half = 8 * painter_.sizes.unit / length(along) * Vec2d(-along.y, along.x);
    const Colour colour = ray_style(painter_.state.appearance.theme, ray_of(pencil).kind).colour;
    painter_.add_clipped({at - half, at + half, painter_.stroke(colour, strong ? 2.2 : 1.3)});
  }

  /// The matrix from EYE to where the ray ends or, if that is not known yet, starts; and how far off it is.
  void say(const Pencil& pencil) {
    const Language language = painter_.state.appearance.language;
    const PencilStage& last = pencil.stages.back();
    const bool ends = is_known(pencil) && std::isfinite(last.length);
    const PencilMatrix m = ends ? pencil_transfer(last.length) * last.start : last.start;
    const auto number = [&](double value) { return number_text(value, language); };
    std::string said = "[" + number(m.a) + "  " + number(m.b) + " ;  " + number(m.c) + "  " + number(m.d) + "]";
    const Vec2d from = painter_.pixels(plan(last.origin));
    const Vec2d to = painter_.pixels(plan(last.origin + length_of(pencil) * last.direction));
    const Vec2d along = to - from;
    const Vec2d across = length(along) > 0 ? Vec2d(-along.y, along.x) / length(along) : Vec2d(0, -1);
    painter_.note_along(from, to, said);
    if (pencil.truly.empty() || !ends) return;
    const int all = static_cast<int>(pencil.truly.size());
    std::string off = pencil.parted < all ? fill("plan.pencil_error", language, {{"error", number(pencil.error)}}) : "";
    if (pencil.parted > 0)
      off = fill("plan.pencil_parted", language, {{"parted", pencil.parted}, {"all", all}}) +
            (off.empty() ? "" : "; " + off);
    painter_.note_beside(painter_.seen_end(from, to), across.y > 0 ? across : -across, off);
  }

  Painter& painter_;
  const PencilRoom& room_;
};

}  // namespace

void PencilRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (state.walk.mode == Mode::move || state.pencil.of != state.walk.timeline || state.pencil.of == nullptr) return;
  PencilPainter(painter, state.pencil).draw();
}

}  // namespace raywalk
