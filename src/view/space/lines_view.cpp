#include "view/space/lines_view.h"

#include "view/plan/painter.h"
#include "view/space/lines_crowd.h"
#include "view/space/lines_names.h"
#include "view/space/orbit.h"
#include "view/space/outlines.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/lit.h"
#include "view/walk/tween.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace raywalk {

namespace {

/// With more objects than this, those that no ray has hit are simplified.
constexpr std::size_t detailed_objects = 300;

class Lines {
 public:
  Lines(const State& state, const Viewport& viewport, const Vec2d& buttons)
      : painter_(state, viewport),
        scene_(state.scene()),
        crowd_(crowd_of(state)),
        room_(crowd_ ? crowd_->room : room_of(scene_)),
        seen_(lines_camera(state, viewport), viewport),
        reach_(2 * length(room_.max - room_.min)) {
    if (buttons.x > 0) painter_.kept_free.push_back({{viewport.width - buttons.x, 0.0}, {viewport.width, buttons.y}});
  }

  DisplayList draw() {
    draw_objects();
    draw_camera();
    draw_lights();
    for (const StructureEdge& edge : structure_edges(painter_)) line(edge.from, edge.to, edge.stroke);
    draw_object_names(painter_, seen_, whole_walk());  // below the rays, which are more important
    draw_rays();
    return std::move(painter_.list);
  }

 private:
  void line(const Vec3d& from, const Vec3d& to, const Stroke& stroke, const Target& target = {}) {
    if (const auto ends = seen_.segment(from, to)) painter_.add_clipped({(*ends)[0], (*ends)[1], stroke}, target);
  }

  void draw_objects() {
    const std::vector<int> met = met_objects();
    const auto is_met = [&](int object) { return std::binary_search(met.begin(), met.end(), object); };
    if (!crowd_) {
      const bool detailed = scene_.objects.size() <= detailed_objects;
      for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) draw_object(i, detailed || is_met(i));
      return;
    }
    std::size_t drawn = met.size();
    for (const int i : crowd_->drawn) {
      if (is_met(i) || drawn >= max_drawn) continue;
      draw_object(i, false);
      ++drawn;
    }
    for (const int i : met) draw_object(i, true);
    say_how_many(drawn);
  }

  void draw_object(int index, bool in_full) {
    const Object& object = scene_.objects[static_cast<std::size_t>(index)];
    const Target target{TargetKind::object, index};
    const bool endless = !bounds(object.shape).bounded();
    const Colour body = body_colour(scene_, object.material).with_alpha(255);
    const Colour ground = painter_.colours.plan;
    // Visible on the background, whatever the body's colour.
    const Colour colour = mix(mix(ground, painter_.colours.ink, 0.45), body, 0.5);
    if (!in_full && !endless) return draw_simply(object, target, painter_.outline(target, colour.with_alpha(120), 0.6));
    const std::vector<Polyline> curves = outline_of(object, room_);
    constexpr std::size_t many_curves = 200;  // of a mesh, which would hide what is behind it
    const bool many = curves.size() > many_curves, is_group = std::holds_alternative<Instance>(object.shape);
    const bool faint = endless || (many && !is_group);
    const Stroke stroke = painter_.outline(target, colour.with_alpha(faint ? 70 : many ? 130 : 190), faint ? 0.6 : 1);
    for (const Polyline& curve : curves)
      for (std::size_t k = 1; k < curve.size(); ++k) line(curve[k - 1], curve[k], stroke, target);
  }

  /// A simplified object: a sphere as its silhouette, others as their box.
  void draw_simply(const Object& object, const Target& target, const Stroke& stroke) {
    const Bounds<double> own = bounds(object.shape);
    if (own.empty()) return;
    const Bounds<double> box = image_of(affine_of(object.transform), own);
    if (std::holds_alternative<Sphere<double>>(object.shape)) {
      const Vec3d middle = box.min + (box.max - box.min) / 2.0;
      const auto at = seen_.point(middle);
      if (!at) return;
      const double radius = length(box.max - box.min) / (2 * std::sqrt(3.0)) * seen_.pixels_per_unit(middle);
      const PixelRect around{*at - radius, *at + radius};
      if (around.overlap(painter_.pane()) > 0)
        painter_.add(CircleItem{*at, std::max(radius, 0.5), std::nullopt, stroke}, target);
      return;
    }
    const auto corner = [&](int i) {
      return Vec3d((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                   (i & 4) != 0 ? box.max.z : box.min.z);
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if ((i & bit) == 0) line(corner(i), corner(i | bit), stroke, target);
  }

  void say_how_many(std::size_t drawn) {
    const auto digits = [&](std::size_t count) {
      std::string all = std::to_string(count);
      const char mark = painter_.state.appearance.language.decimal_mark() == '.' ? ',' : '.';
      for (std::size_t at = all.size(); at > 3; at -= 3) all.insert(at - 3, 1, mark);
      return all;
    };
    const double unit = painter_.sizes.unit, size = painter_.sizes.text;
    const std::string said = fill("plan.objects_drawn", painter_.state.appearance.language,
                                  {{"drawn", digits(drawn)}, {"all", digits(scene_.objects.size())}});
    const Vec2d at(14 * unit, painter_.viewport.height - 14 * unit);
    painter_.kept_free.push_back({at - Vec2d(0, size / 2), at + Vec2d(text_width(said, size), size / 2)});
    painter_.add(TextItem{at, said, size, painter_.colours.dim_text});
  }

  /// Objects hit by the drawn rays, ascending.
  [[nodiscard]] std::vector<int> met_objects() const {
    std::vector<int> met;
    for (const RayRecord& ray : painter_.state.walk.timeline->rays_at(painter_.state.walk.position))
      if (ray.object >= 0 && ray.object < static_cast<int>(scene_.objects.size())) met.push_back(ray.object);
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    return met;
  }

  /// The view frustum from EYE, and the current pixel on it.
  void draw_camera() {
    const State& state = painter_.state;
    const Camera& camera = state.walk.pixel && state.walk.pixel->camera ? *state.walk.pixel->camera : scene_.camera;
    const ImageSize size = state.walk.pixel ? state.walk.pixel->size : scene_.image;
    const Vec3d forward = normalize(camera.look_at - camera.eye);
    const Vec3d right = normalize(cross(forward, camera.up)), up = cross(right, forward);
    const double aspect = static_cast<double>(size.width) / size.height;
    const double half =
        camera.screen.distance * camera.half_extent() * (camera.extent_axis() == FovAxis::y ? aspect : 1);
    const Vec3d middle = camera.eye + camera.screen.distance * forward;
    const auto on_screen = [&](double x, double y) { return middle + half * x * right + half / aspect * y * up; };
    const Stroke ink = painter_.stroke(painter_.colours.ink, 1.2);
    const Stroke faint = painter_.stroke(painter_.colours.ink.with_alpha(90), 0.8);
    std::vector<std::array<Vec2d, 2>> frustum;
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) {
        line(camera.eye, on_screen(x, y), faint, {TargetKind::eye});
        if (const auto ends = seen_.segment(camera.eye, on_screen(x, y))) frustum.push_back(*ends);
      }
    const auto rectangle = [&](double x0, double y0, double x1, double y1, const Stroke& stroke) {
      line(on_screen(x0, y0), on_screen(x1, y0), stroke);
      line(on_screen(x1, y0), on_screen(x1, y1), stroke);
      line(on_screen(x1, y1), on_screen(x0, y1), stroke);
      line(on_screen(x0, y1), on_screen(x0, y0), stroke);
    };
    rectangle(-1, -1, 1, 1, ink);
    if (const int pixel = state.walk.timeline->current_pixel(state.walk.position); pixel >= 0) {
      const PixelRecord& record = state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)];
      const double x = (2.0 * record.column + 1) / state.walk.timeline->image().width - 1;
      const double y = state.walk.pixel ? 1 - (2.0 * record.row + 1) / size.height : 0;
      // A pixel of a large picture would be too small to see.
      const double w = std::max(1.0 / state.walk.timeline->image().width, 0.03), h = w * aspect;
      rectangle(x - w, y - h, x + w, y + h, painter_.stroke(painter_.colours.next, 1.8));
    }
    if (const auto at = seen_.point(camera.eye)) {
      painter_.add(CircleItem{*at, 4 * painter_.sizes.unit, painter_.colours.ink, std::nullopt}, {TargetKind::eye});
      draw_name(painter_, std::string(text("object.eye", painter_.state.appearance.language)), *at,
                Vec2d(0, 16 * painter_.sizes.unit), frustum);
    }
  }

  void draw_lights() {
    for (int i = 0; i < static_cast<int>(scene_.lights.size()); ++i) {
      const Light& light = scene_.lights[static_cast<std::size_t>(i)];
      const std::optional<Vec3d> middle = place_of(light);
      if (!middle) continue;
      const Target target{TargetKind::light, i};
      const Stroke stroke = painter_.outline(target, painter_.colours.light, 1.4);
      if (!is_in_pane(*middle)) {
        point_to(light, *middle, target, stroke);
        continue;
      }
      const std::vector<Vec3d> corners = outline_of(light);
      for (std::size_t k = 0; k < corners.size(); ++k)
        line(corners[k], corners[(k + 1) % corners.size()], stroke, target);
      const Vec2d at = *seen_.point(*middle);
      const double least = 6 * painter_.sizes.unit;
      const double radius = corners.empty() ? std::max(reach_of(light) * seen_.pixels_per_unit(*middle), least) : least;
      painter_.add(CircleItem{at, least, painter_.colours.light, std::nullopt}, target);
      if (radius > least) painter_.add(CircleItem{at, radius, std::nullopt, stroke}, target);
      constexpr int beams = 8;
      for (int k = 0; k < beams; ++k) {
        const double angle = 2 * 3.14159265358979323846 * k / beams;
        const Vec2d out(std::cos(angle), std::sin(angle));
        painter_.add_clipped({at + 1.4 * least * out, at + 2 * least * out, stroke}, target);
      }
      draw_name(painter_, shown_name(painter_.state, light.name), at, Vec2d(0, -3.4 * least));
    }
  }

  [[nodiscard]] bool is_in_pane(const Vec3d& point) const {
    const auto at = seen_.point(point);
    return at && at->x >= 0 && at->y >= 0 && at->x <= painter_.viewport.width && at->y <= painter_.viewport.height;
  }
  /// Its middle; of a sun, a place beyond everything else. None of a light that is on no side.
  [[nodiscard]] std::optional<Vec3d> place_of(const Light& light) const {
    const auto* sun = std::get_if<DirectionalLight>(&light.kind);
    if (sun == nullptr) return raywalk::middle_of(light);
    return room_.min + (room_.max - room_.min) / 2.0 + 10 * reach_ * normalize(sun->direction);
  }

  /// A light out of sight: an arrow at the pane's border, where to turn to see it, with its name.
  void point_to(const Light& light, const Vec3d& middle, const Target& target, const Stroke& stroke) {
    const double unit = painter_.sizes.unit, least = 5 * unit, border = 26 * unit;
    const Vec2d centre = Vec2d(painter_.viewport.width, painter_.viewport.height) / 2.0;
    const Vec2d half = centre - border;
    if (half.x <= 0 || half.y <= 0) return;
    const auto at = seen_.point(middle);
    const Vec2d way = at ? (*at - centre) / std::max(length(*at - centre), 1e-9) : seen_.towards(middle);
    const double far = std::min(half.x / std::max(std::abs(way.x), 1e-9), half.y / std::max(std::abs(way.y), 1e-9));
    Vec2d place = centre + far * way;
    // Beside another one that is in the same direction, and off the buttons.
    const Vec2d along = half.x / std::max(std::abs(way.x), 1e-9) < half.y / std::max(std::abs(way.y), 1e-9)
                            ? Vec2d(0, place.y > centre.y ? -1 : 1)
                            : Vec2d(place.x > centre.x ? -1 : 1, 0);
    const auto is_taken = [&] { return painter_.covers_kept({place - 3 * least, place + 3 * least}); };
    constexpr int tries = 40;
    for (int i = 0; i < tries && is_taken(); ++i) place += 3 * least * along;
    painter_.add(CircleItem{place, least, painter_.colours.light, std::nullopt}, target);
    painter_.add(LineItem{place + 1.5 * least * way, place + 4 * least * way, stroke, 7 * unit, 1.0}, target);
    painter_.keep_free(place, 2 * least);
    draw_name(painter_, shown_name(painter_.state, light.name), place,
              Vec2d(0, place.y < centre.y ? 3.6 * least : -3.6 * least));
  }

  /// A beam in space, with a line to each of its corners, until it is cut; then its parts, each with what it sees of a
  /// face in that body's colour; of cones, as round as they are there. Those of a strip are drawn in the plan.
  void draw_beam(int index, const RayRecord& ray, const RayLook& look) {
    const Timeline& timeline = *painter_.state.walk.timeline;
    const BeamRecord& beam = timeline.beams()[static_cast<std::size_t>(ray.beam)];
    const bool is_part = timeline.part_of(index) == index;
    if (beam.area.corner_ends.empty() || (!is_part && ray.found_at <= painter_.state.walk.position)) return;
    const Target target{TargetKind::ray, index};
    const std::vector<Vec3d>&starts = beam.area.corner_starts, &ends = beam.area.corner_ends;
    Stroke stroke = ray_stroke(painter_, ray, look);
    if (is_part && ray.object >= 0) {
      const bool strong = look.hovered || look.prominence == Prominence::current;
      PolygonItem seen{{}, body_colour(scene_, scene_.objects[static_cast<std::size_t>(ray.object)].material), stroke};
      seen.fill->a = strong ? 170 : 90;
      for (const Vec3d& end : ends)
        if (const auto at = seen_.point(end)) seen.points.push_back(*at);
      if (seen.points.size() == ends.size()) painter_.add(std::move(seen), target);
    }
    stroke.width = std::min(stroke.width, 0.9 * painter_.sizes.unit);
    stroke.colour.a = static_cast<std::uint8_t>(stroke.colour.a * 0.6);
    // Of a cone's rim, a few.
    const std::size_t every = timeline.of_cones() ? std::max<std::size_t>(ends.size() / 4, 1) : 1;
    for (std::size_t i = 0; i < ends.size(); i += every) line(starts[i], ends[i], stroke, target);
  }

  void draw_ray(int index, const RayLook& look) {
    const State& state = painter_.state;
    const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(index)];
    if (ray.beam >= 0) return draw_beam(index, ray, look);
    const Target target{TargetKind::ray, index};
    const Stroke stroke = ray_stroke(painter_, ray, look);
    const bool known = ray.found_at <= state.walk.position;
    const Vec3d along = normalize(ray.direction);
    if (!ray.formed) {
      const double size = 24 * painter_.sizes.unit / std::max(seen_.pixels_per_unit(ray.origin), 1e-9);
      const auto ends = seen_.segment(ray.origin, ray.origin + size * along);
      if (!ends || !(length((*ends)[1] - (*ends)[0]) > 0)) return;
      return draw_stub(painter_, (*ends)[0], normalize_flat((*ends)[1] - (*ends)[0]), stroke, target);
    }
    const std::optional<Growth> growth = growth_of(state, index);
    Vec3d end = end_of(ray, known);
    if (growth) {
      const Vec3d start = growth->from_start ? ray.origin : end_of(ray, false);
      end = start + growth->part * (end - start);
    }
    const auto ends = seen_.segment(ray.origin, end);
    if (!ends || !(length((*ends)[1] - (*ends)[0]) > 0)) return;
    const auto [from, to] = *ends;
    if (look.hovered)
      painter_.add_clipped({from, to, {painter_.colours.hovered.with_alpha(90), 8 * painter_.sizes.unit}});
    LineItem item{from, to, stroke, ray_arrow(painter_, look), ends_seen(ray, known) ? 0.55 : 0.2};
    item.arrow = std::min(item.arrow, length(to - from) / 3);
    painter_.add_clipped(item, target);
    if (known && ray.ending == Ending::blocked && !growth)
      draw_blocked(painter_, to, normalize_flat(to - from), stroke);
  }

  /// Whether the ray's end is drawn, at a position where it may not be known yet.
  [[nodiscard]] bool ends_seen(const RayRecord& ray, bool known) const {
    return known ? !ray.endless : ends_at_light(ray);
  }
  [[nodiscard]] Vec3d end_of(const RayRecord& ray, bool known) const {
    if (!ends_seen(ray, known)) return ray.origin + reach_ * normalize(ray.direction);
    return known ? ray.end : ray.origin + ray.direction;
  }

  static Vec2d normalize_flat(const Vec2d& v) { return v / length(v); }

  [[nodiscard]] bool ends_at_light(const RayRecord& ray) const {
    return ray.light >= 0 && ray.light < static_cast<int>(scene_.lights.size()) &&
           raywalk::middle_of(scene_.lights[static_cast<std::size_t>(ray.light)]).has_value();
  }

  /// All rays of the walk of a picture's pixel, formed or not: names stay where they are while it goes on. None of a
  /// long one.
  [[nodiscard]] std::vector<std::array<Vec2d, 2>> whole_walk() const {
    constexpr std::size_t most = 200;
    const State& state = painter_.state;
    const std::vector<RayRecord>& rays = state.walk.timeline->rays();
    std::vector<std::array<Vec2d, 2>> lines;
    if (!state.walk.pixel || rays.size() > most || hides_rays_to_come(state)) return lines;
    for (const RayRecord& ray : rays)
      if (const auto ends = seen_.segment(ray.origin, end_of(ray, true))) lines.push_back(*ends);
    return lines;
  }

  /// Rays of earlier pixels first, then the current pixel's, then the current ray and the hovered one.
  void draw_rays() {
    const State& state = painter_.state;
    const Timeline& timeline = *state.walk.timeline;
    const auto count = static_cast<int>(timeline.rays_at(state.walk.position).size());
    const RaysShown shown = rays_shown(state);
    const int pixel = shown.pixel, current = shown.current;
    for (int index = 0; index < count; ++index) {
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
      if (index == current || is_lit(state, index)) continue;
      if (ray.pixel != pixel && !ray.formed) continue;
      if (const auto prominence = prominence_of(state, shown, index)) draw_ray(index, {*prominence, false});
    }
    for (int index = 0; index < count; ++index) {
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
      if (ray.pixel != pixel || ray.ending != Ending::hit || !ray.formed || ray.found_at > state.walk.position)
        continue;
      if (growth_of(state, index) || !state.legend.shows(ray.kind)) continue;
      const double size = 26 * painter_.sizes.unit / std::max(seen_.pixels_per_unit(ray.end), 1e-9);
      if (const auto ends = seen_.segment(ray.end, ray.end + size * ray.outward_shading_normal()))
        painter_.add_clipped({(*ends)[0], (*ends)[1], painter_.stroke(painter_.colours.normal),
                              std::min(5 * painter_.sizes.unit, length((*ends)[1] - (*ends)[0]) / 2)});
    }
    if (current >= 0 && current < count && !is_lit(state, current) && prominence_of(state, shown, current))
      draw_ray(current, {Prominence::current, false});
    for (int index = 0; index < count; ++index)
      if (is_lit(state, index)) draw_ray(index, {index == current ? Prominence::current : Prominence::of_pixel, true});
  }

  Painter painter_;
  const Scene& scene_;
  std::shared_ptr<const Crowd> crowd_;  ///< for very many objects
  Bounds<double> room_;
  Projection seen_;
  double reach_;  ///< drawn length of infinite things
};

}  // namespace

Camera lines_camera(const State& state, const Viewport& viewport) {
  if (state.space.lines_camera) return *state.space.lines_camera;
  const auto crowd = crowd_of(state);
  return crowd ? overlooking(state.scene(), viewport, crowd->at_first) : overlooking(state.scene(), viewport);
}

DisplayList lines_view(const State& state, const Viewport& viewport, const Vec2d& buttons) {
  return Lines(state, viewport, buttons).draw();
}

Target pick_in_lines(const State& state, const Viewport& viewport, const Vec2d& at) {
  const double reach = Sizes(state).reach;
  const auto rank = [](TargetKind kind) { return kind == TargetKind::ray ? 2 : kind == TargetKind::object ? 0 : 1; };
  Target best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const DisplayItem& item : lines_view(state, viewport)) {
    if (!item.target) continue;
    const double distance = distance_to(item, at);
    if (distance > reach) continue;
    const bool better = !best || rank(item.target.kind) > rank(best.kind) ||
                        (rank(item.target.kind) == rank(best.kind) && distance < nearest);
    if (!better) continue;
    best = item.target;
    nearest = distance;
  }
  return best;
}

}  // namespace raywalk
