#include "view/plan/painter.h"
#include "view/state.h"
#include "view/text/shown.h"
#include "view/walk/lit.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// A part has the colour of what it sees; the one at work is strong, those of the pixels before are faint. Of cones the
/// edges and the axis stay: which of its rays a part has, a cone does not know.
class BeamPainter {
 public:
  BeamPainter(Painter& painter, const RaysShown& shown)
      : painter_(painter),
        state_(painter.state),
        timeline_(*painter.state.walk.timeline),
        shown_(shown),
        style_(ray_style(painter.state.appearance.theme, RayKind::beam)),
        part_(timeline_.part_of(timeline_.current_ray(shown_.position))) {}

  void draw() {
    const auto count = static_cast<int>(timeline_.rays_at(shown_.position).size());
    for (int index = 0; index < count; ++index)
      if (ray(index).beam >= 0 && is_seen(index)) draw_beam(index);
    for (int index = 0; index < count; ++index)
      if (timeline_.of_cones() || ray(index).end_radius > 0) draw_edges(index);
    const int current = timeline_.current_ray(shown_.position);
    const int mirrored = part_ >= 0 && current != part_ && ray(current).beam >= 0 ? current
                         : part_ >= 0                                             ? ray(part_).parent
                                                                                  : -1;
    if (mirrored >= 0 && ray(mirrored).parent >= 0 && state_.legend.shows(RayKind::beam)) draw_backwards(mirrored);
    if (part_ >= 0 && part_ < count && decides_on_reflection() && state_.legend.shows(RayKind::reflect))
      draw_reflected(beam(part_).area);
    if (part_ >= 0 && part_ < count && state_.legend.shows(RayKind::beam) && beam(part_).added_at > shown_.position)
      note_coverage(part_);
  }

 private:
  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const BeamRecord& beam(int index) const {
    return timeline_.beams()[static_cast<std::size_t>(ray(index).beam)];
  }
  [[nodiscard]] bool is_whole(int index) const {
    const int parent = ray(index).parent;
    return parent < 0 || timeline_.part_of(parent) == parent;
  }
  /// A beam that has been cut is its parts.
  [[nodiscard]] bool is_seen(int index) const {
    if (is_lit(state_, index)) return true;
    if (!state_.legend.shows(RayKind::beam) || ray(index).pixel < shown_.first_pixel) return false;
    if (ray(index).pixel != shown_.pixel && (shown_.others == Earlier::hidden || is_far_cone(index))) return false;
    return !is_whole(index) || ray(index).found_at > shown_.position;
  }

  /// Of what an earlier pixel's cone has met, only what EYE sees: the others would cover the plan.
  [[nodiscard]] bool is_far_cone(int index) const {
    if (!timeline_.of_cones() || is_whole(index)) return timeline_.of_cones();
    return ray(index).object < 0 || ray(ray(index).parent).parent >= 0;
  }

  void draw_beam(int index) {
    const BeamArea& area = beam(index).area;
    std::vector<Vec2d> corners;
    for (const Vec3d& start : area.starts) add(corners, start);
    for (std::size_t i = area.ends.size(); i-- > 0;) add(corners, area.ends[i]);
    if (corners.size() < 3) return;
    const bool whole = is_whole(index), of_pixel = ray(index).pixel == shown_.pixel, lit = is_lit(state_, index);
    const bool at_work = index == part_ && beam(index).added_at > shown_.position;
    Colour fill = whole ? style_.colour : colour_of(index);
    fill.a = static_cast<std::uint8_t>(whole ? 46 : lit ? 190 : at_work ? 150 : of_pixel ? 84 : faint());
    const Target target = shown_.pointed_at ? Target{TargetKind::ray, index} : Target{};
    painter_.add(PolygonItem{corners, fill, std::nullopt}, target);
    // Its two sides: what is cut off between them and the next part's is nothing.
    Stroke stroke = painter_.stroke(style_.colour, lit || at_work ? 2.2 : 1.1);
    stroke.colour.a = static_cast<std::uint8_t>(lit || at_work ? 255 : of_pixel ? 150 : 50);
    for (const std::size_t side : {std::size_t{0}, area.starts.size() - 1})
      draw_line(painter_.pixels(plan(area.starts[side])), painter_.pixels(plan(area.ends[side])), stroke, at_work);
  }
  /// `kept_off`: by notes, where there is other room.
  void draw_line(const Vec2d& from, const Vec2d& to, const Stroke& stroke, bool kept_off) {
    painter_.add_clipped({from, to, stroke});
    if (kept_off) painter_.prominent.push_back({from, to});
  }
  void add(std::vector<Vec2d>& corners, const Vec3d& point) const {
    const Vec2d at = painter_.pixels(plan(point));
    if (corners.empty() || length(corners.back() - at) > 0) corners.push_back(at);
  }
  [[nodiscard]] int faint() const {
    return shown_.others == Earlier::faded && shown_.pixel - shown_.first_pixel > few_pixels ? 18 : 34;
  }
  /// Of what a part sees.
  [[nodiscard]] Colour colour_of(int index) const {
    const int object = ray(index).object;
    if (object < 0) return painter_.colours.dim_text;
    const Scene& scene = painter_.scene();
    return body_colour(scene, scene.objects[static_cast<std::size_t>(object)].material);
  }

  /// Of the cones of the pixel at work: to where the farthest part ends. Of its shadow cones, too.
  void draw_edges(int index) {
    const RayRecord& record = ray(index);
    if (record.pixel != shown_.pixel || !record.formed || !state_.legend.shows(record.kind)) return;
    if (record.kind == RayKind::shadow) return draw_shadow_edges(record);
    if (record.beam < 0 || !is_whole(index)) return;
    const BeamArea& area = beam(index).area;
    const Vec2d middle = (plan(area.starts.front()) + plan(area.starts.back())) / 2.0;
    const Vec2d far = (plan(area.ends.front()) + plan(area.ends.back())) / 2.0;
    double reach = record.found_at > shown_.position ? 1 : 0;
    for (int part = index + 1; reach < 1 && part < static_cast<int>(timeline_.rays().size()); ++part) {
      if (ray(part).parent != index || ray(part).beam < 0) continue;
      const BeamArea& ends = beam(part).area;
      const Vec2d end = (plan(ends.ends.front()) + plan(ends.ends.back())) / 2.0;
      reach = std::max(reach, std::min(dot(end - middle, far - middle) / dot(far - middle, far - middle), 1.0));
    }
    Stroke edge = painter_.stroke(style_.colour, 1.3);
    const auto line = [&](const Vec2d& from, const Vec2d& to, const Stroke& stroke) {
      draw_line(painter_.pixels(from), painter_.pixels(from + reach * (to - from)), stroke, true);
    };
    for (const std::size_t side : {std::size_t{0}, area.starts.size() - 1})
      line(plan(area.starts[side]), plan(area.ends[side]), edge);
    edge.dash = painter_.scaled({{9, 4, 2, 4}, 4});
    line(middle, far, edge);
  }

  /// From the width of the part to that of the light.
  void draw_shadow_edges(const RayRecord& shadow) {
    if (shadow.endless) return;
    const Vec2d from = plan(shadow.origin), to = plan(shadow.origin + shadow.direction), along = to - from;
    if (!(length(along) > 0)) return;
    const Vec2d across = Vec2d(-along.y, along.x) / length(along);
    const Colour colour = ray_style(state_.appearance.theme, RayKind::shadow).colour;
    for (const double side : {1.0, -1.0})
      painter_.add_clipped({painter_.pixels(from + side * shadow.radius * across),
                            painter_.pixels(to + side * shadow.end_radius * across), painter_.stroke(colour, 1.1)});
  }

  /// From where the rays of a mirrored beam seem to come.
  void draw_backwards(int index) {
    const BeamArea& area = beam(index).area;
    const Vec2d first = plan(area.starts.front()), last = plan(area.starts.back());
    const Vec2d back = first - plan(area.ends.front()), other = last - plan(area.ends.back());
    const double across = cross(back, other);
    if (!(std::abs(across) > 1e-9 * length(back) * length(other))) return;
    const double behind = cross(last - first, other) / across;
    const Vec2d apex = painter_.pixels(first + behind * back);
    // Where a cone converges, its own edges lead there.
    if (behind < 0)
      return painter_.add(CircleItem{apex, 5 * painter_.sizes.unit, std::nullopt, painter_.stroke(style_.colour, 1.6)});
    const Stroke dashed{style_.colour.with_alpha(170), painter_.sizes.unit, painter_.scaled({{3, 5}, 2})};
    painter_.add_clipped({painter_.pixels(first), apex, dashed});
    painter_.add_clipped({painter_.pixels(last), apex, dashed});
    painter_.add(CircleItem{apex, 5 * painter_.sizes.unit, std::nullopt, painter_.stroke(style_.colour, 1.6)});
  }

  /// The line just run decides whether what the part sees, which reflects, reflects it as a beam or by one ray.
  [[nodiscard]] bool decides_on_reflection() const {
    if (!timeline_.of_beams() || shown_.position == 0) return false;
    const Event& event = timeline_.event(shown_.position - 1);
    if (event.line != Line::if_flat_mirror && event.line != Line::if_curved_or_glass) return false;
    const auto* decided = std::get_if<Decided>(&event.detail);
    return decided != nullptr && !is_black(decided->weight) && decided->holds == (event.line != Line::if_flat_mirror);
  }

  /// Some rays of a part as a curved surface reflects them, and backwards from there, where they do not meet in one
  /// point.
  void draw_reflected(const BeamArea& area) {
    constexpr int some = 6;
    const auto last = static_cast<int>(area.ends.size()) - 1;
    const Colour colour = ray_style(state_.appearance.theme, RayKind::reflect).colour;
    const Stroke stroke = painter_.stroke(colour, 1.1);
    // Mostly on the body, which may be of any colour.
    const auto apart = [body = colour_of(part_)](Colour ink) {
      return std::abs(ink.r - body.r) + std::abs(ink.g - body.g) + std::abs(ink.b - body.b);
    };
    const Colour text = painter_.colours.text, ground = painter_.colours.plan;
    Stroke dashed = painter_.stroke(apart(text) > apart(ground) ? text : ground, 1.1);
    dashed.dash = painter_.scaled({{4, 2.5}, 2});
    const int rays = std::min(some, last - 1);
    for (int ray = 0; ray < rays; ++ray) {
      const auto i = static_cast<std::size_t>(rays == 1 ? 1 : 1 + ray * (last - 2) / (rays - 1));
      const Vec2d at = plan(area.ends[i]), before = plan(area.ends[i - 1]) - at, after = plan(area.ends[i + 1]) - at;
      // From the point to the middle of the circle through it and its neighbours.
      const double across = 2 * cross(before, after);
      if (!(std::abs(across) > 1e-9 * length(before) * length(after))) return;
      const Vec2d to_middle =
          (dot(before, before) * Vec2d(after.y, -after.x) - dot(after, after) * Vec2d(before.y, -before.x)) / across;
      const Vec2d normal = to_middle / length(to_middle), came = at - plan(area.starts[i]);
      const Vec2d goes = came / length(came) - 2 * dot(came, normal) / length(came) * normal;
      const double far = painter_.viewport.width + painter_.viewport.height;
      const Vec2d from = painter_.pixels(at), along = painter_.pixels(at + goes) - from;
      draw_line(from, from + far / length(along) * along, stroke, true);
      const Vec2d back = painter_.pixels(at - 1.3 * length(to_middle) * goes);
      painter_.add_clipped({from, back, dashed});
      // The name of the body would lie just there.
      painter_.unnamed.push_back(
          {{std::min(from.x, back.x), std::min(from.y, back.y)}, {std::max(from.x, back.x), std::max(from.y, back.y)}});
    }
  }

  void note_coverage(int index) {
    const BeamArea& area = beam(index).area;
    const auto middle = [](const std::vector<Vec3d>& points) { return (points.front() + points.back()) / 2.0; };
    const Vec2d from = painter_.pixels(plan(middle(area.starts))), to = painter_.pixels(plan(middle(area.ends)));
    const Vec2d along = to - from, across = length(along) > 0 ? Vec2d(-along.y, along.x) / length(along) : Vec2d(0, -1);
    // Where nothing else is, of what is seen of it.
    const Vec2d first = painter_.seen_end(to, from), last = painter_.seen_end(from, to);
    const auto at_part = [&](double part) { return first + part * (last - first); };
    Vec2d at = at_part(0.5);
    for (const double part : {0.5, 0.65, 0.8, 0.35}) {
      const Vec2d other = at_part(part);
      const auto holds = [&](const PixelRect& taken) { return taken.meets(other - 0.5, other + 0.5); };
      if (std::any_of(painter_.kept_free.begin(), painter_.kept_free.end(), holds)) continue;
      at = other;
      break;
    }
    painter_.note_beside(at, across.y > 0 ? -across : across, coverage_text(state_, beam(index)));
  }

  Painter& painter_;
  const State& state_;
  const Timeline& timeline_;
  RaysShown shown_;
  RayStyle style_;
  int part_;  ///< at work
};

/// The note on the flat world stands off the beams of all pixels, so that it stays where it is while they are walked.
void draw_flat_note_off_beams(Painter& painter, const Timeline& timeline) {
  std::vector<std::array<Vec2d, 2>> sides;
  for (const RayRecord& ray : timeline.rays()) {
    if (ray.beam < 0 || ray.parent >= 0) continue;
    const BeamArea& area = timeline.beams()[static_cast<std::size_t>(ray.beam)].area;
    for (const std::size_t side : {std::size_t{0}, area.starts.size() - 1})
      sides.push_back({painter.pixels(plan(area.starts[side])), painter.pixels(plan(area.ends[side]))});
  }
  std::swap(painter.prominent, sides);
  draw_flat_note(painter, timeline.of_beams() ? "plan.flat_beams" : "plan.flat_cones");
  std::swap(painter.prominent, sides);
}

}  // namespace

void draw_beams(Painter& painter, const RaysShown& shown) {
  const Timeline& timeline = *painter.state.walk.timeline;
  if (!timeline.has_width()) return;
  BeamPainter(painter, shown).draw();
  if (painter.state.walk.mode == Mode::trace && timeline.is_flat()) draw_flat_note_off_beams(painter, timeline);
}

}  // namespace raywalk
