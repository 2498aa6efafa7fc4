// Draws a hit under the numerical microscope: everything is relative to the point itself, so that no digits are lost at
// any magnification.

#include "view/microscope/microscope.h"

#include "view/microscope/room.h"
#include "view/plan/labels_place.h"
#include "view/plan/painter.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

constexpr double widest_cell = 34;  // pixels at scale 1 at the highest magnification

double pixels_per_unit(const State& state, const Viewport& pane) {
  return fit(state.scene(), pane, Sizes(state).unit).pixels_per_unit;
}

class Drawing {
 public:
  Drawing(const State& state, const Specimen& specimen, const Viewport& pane)
      : painter_(state, pane),
        specimen_(specimen),
        scale_(pixels_per_unit(state, pane) * magnification(state, specimen, pane)),
        middle_(pane.width / 2, pane.height / 2),
        unit_(painter_.sizes.unit) {}

  [[nodiscard]] DisplayList draw() {
    const Vec2d& size = 2.0 * middle_;
    painter_.add(PolygonItem{{Vec2d(0.0), {size.x, 0}, size, {0, size.y}}, painter_.colours.plan, std::nullopt});
    draw_numbers();
    draw_surfaces();
    draw_error_box();
    draw_ray();
    draw_leaving(specimen_.robust, false);
    draw_leaving(specimen_.naive, true);
    draw_scale();  // before the labels, which avoid it
    draw_gap();
    draw_marks();
    draw_factor();
    return std::move(painter_.list);
  }

 private:
  enum class Sign { robust, naive, naive_start, crossing };
  struct PointMark {
    Vec2d at;
    Sign sign;
    bool joins = true;            ///< shares the label of one that it covers
    std::optional<double> off{};  ///< from the true surface, scene units
  };

  /// Of a start also on which side of the surface it is, unless that is not `told`.
  [[nodiscard]] std::string name_of(const PointMark& mark, bool told = true) const {
    const Language language = painter_.state.appearance.language;
    switch (mark.sign) {
      case Sign::robust:
        return fill("microscope.robust", language);
      case Sign::naive:
        return fill("microscope.naive", language);
      case Sign::naive_start:
        if (!told || !mark.off || *mark.off == 0) return fill("microscope.naive_start", language);
        return fill(*mark.off > 0 ? "microscope.naive_start_outside" : "microscope.naive_start_inside", language);
      case Sign::crossing:
        return fill("microscope.crossing", language);
    }
    return {};
  }
  [[nodiscard]] Vec2d flat(const Vec3d& v) const { return {v[specimen_.axes[0]], v[specimen_.axes[1]]}; }
  [[nodiscard]] Vec2d pixels(const Vec2d& from_focus) const {
    return middle_ + scale_ * Vec2d(from_focus.x, -from_focus.y);
  }
  [[nodiscard]] Vec2d place_of(const Vec3d& point) const { return pixels(flat(point - specimen_.focus)); }
  [[nodiscard]] double across() const { return 2 * (middle_.x + middle_.y); }
  [[nodiscard]] bool in_sight(const Vec2d& at, double margin) const {
    const Vec2d off(std::abs(at.x - middle_.x), std::abs(at.y - middle_.y));
    return off.x <= middle_.x - margin && off.y <= middle_.y - margin;
  }
  [[nodiscard]] double cell(int axis) const {
    return specimen_.spacing[specimen_.axes[static_cast<std::size_t>(axis)]] * scale_;
  }

  void draw_numbers();
  void draw_surfaces();
  void draw_error_box();
  void draw_ray();
  void draw_leaving(const std::optional<Reading>& reading, bool naive);
  void draw_gap();
  void draw_marks();
  void draw_scale();
  void draw_factor();
  void draw_sign(const PointMark& mark);
  void point_at(const PointMark& mark);
  void label(const Vec2d& at, double clear, const std::string& words);

  Painter painter_;
  const Specimen& specimen_;
  double scale_;  ///< pixels per scene unit
  Vec2d middle_;  ///< where the focus is, pixels
  PixelRect scale_box_{};
  double unit_;
};

/// Lines through the representable numbers, and a dot at each representable point.
void Drawing::draw_numbers() {
  const double least = 5 * unit_;
  constexpr std::size_t most = 512;
  std::array<std::vector<double>, 2> lines;
  for (const int axis : {0, 1}) {
    if (cell(axis) < least) continue;
    const double x = specimen_.focus[specimen_.axes[static_cast<std::size_t>(axis)]];
    lines[static_cast<std::size_t>(axis)] = numbers_about(x, middle_[axis] / scale_, specimen_.precision, most);
    const double seen = std::clamp(cell(axis) / (20 * unit_), 0.3, 1.0);
    const Stroke stroke{painter_.colours.dim_text.with_alpha(static_cast<int>(90 * seen)), unit_};
    for (const double number : lines[static_cast<std::size_t>(axis)]) {
      const double at = axis == 0 ? middle_.x + scale_ * number : middle_.y - scale_ * number;
      painter_.add(axis == 0 ? LineItem{{at, 0}, {at, 2 * middle_.y}, stroke}
                             : LineItem{{0, at}, {2 * middle_.x, at}, stroke});
    }
  }
  if (std::min(cell(0), cell(1)) < 16 * unit_) return;
  for (const double x : lines[0])
    for (const double y : lines[1])
      painter_.add(CircleItem{pixels({x, y}), 1.8 * unit_, painter_.colours.dim_text, std::nullopt});
}

/// Outlines hatched on the inner side, as in technical drawings.
void Drawing::draw_surfaces() {
  constexpr double line_apart = 2.5, tick_apart = 13;  // pixels at scale 1
  const std::array<int, 2> lines{static_cast<int>(2 * middle_.x / (line_apart * unit_)) + 2,
                                 static_cast<int>(2 * middle_.y / (line_apart * unit_)) + 2};
  const int met = specimen_.object();
  const std::string name = object_name(painter_.state, met);
  const double room = std::max(50 * unit_, text_width(name, painter_.sizes.text) / 2 + 4 * unit_);
  std::optional<Vec2d> name_at;
  double farthest = 0;
  for (const SurfaceCut& cut :
       specimen_.surfaces->cut(specimen_.focus, specimen_.axes, 1.02 / scale_ * middle_, lines)) {
    const bool own = cut.object == met;
    PolylineItem line{{}, painter_.stroke(painter_.colours.ink, own ? 2 : 1.2)};
    double since = tick_apart * unit_ / 2;
    for (std::size_t i = 0; i < cut.points.size(); ++i) {
      const Vec2d at = pixels(cut.points[i]), inwards(-cut.outwards[i].x, cut.outwards[i].y);
      if (!line.points.empty()) {
        since += length(at - line.points.back());
        painter_.prominent.push_back({line.points.back(), at});
      }
      line.points.push_back(at);
      if (since >= tick_apart * unit_) {
        const Vec2d along(-inwards.y, inwards.x);
        painter_.add(LineItem{
            at, at + 7 * unit_ * (inwards + 0.7 * along), {painter_.colours.ink.with_alpha(own ? 170 : 90), unit_}});
        since = 0;
      }
      const Vec2d words = at + 24 * unit_ * inwards;
      if (own && in_sight(words, room) && length(at - middle_) > farthest) {
        farthest = length(at - middle_);
        name_at = words;
      }
    }
    painter_.add(line);
  }
  if (name_at && farthest > 60 * unit_) painter_.note(*name_at, name);
}

void Drawing::draw_error_box() {
  const Vec2d half = scale_ * flat(specimen_.error_box);
  if (!specimen_.robust || std::max(half.x, half.y) < 8 * unit_ || length(half) > across()) return;
  const Vec2d at = place_of(specimen_.robust->point);
  const std::array<Vec2d, 4> corners{at - half, at + Vec2d(half.x, -half.y), at + half, at + Vec2d(-half.x, half.y)};
  const Stroke stroke{painter_.colours.text, 1.4 * unit_, painter_.scaled({{3, 4}, 2})};
  painter_.add(PolygonItem{{corners.begin(), corners.end()}, painter_.colours.text.with_alpha(18), std::nullopt});
  for (std::size_t i = 0; i < 4; ++i) painter_.add_clipped({corners[i], corners[(i + 1) % 4], stroke});
  if (std::min(half.x, half.y) < 14 * unit_) return;
  const std::string words(text("microscope.error_box", painter_.state.appearance.language));
  const Vec2d below(corners[3].x + text_width(words, painter_.sizes.text) / 2,
                    corners[3].y + 0.8 * painter_.sizes.text);
  if (in_sight(below, 20 * unit_)) painter_.note(below, words);
}

/// From the border of the view to the true intersection.
void Drawing::draw_ray() {
  const Vec2d along = Vec2d(1, -1) * flat(specimen_.direction);
  if (!(length(along) > 1e-9 * length(specimen_.direction))) return;
  const Vec2d towards = along / length(along), to = pixels(flat(specimen_.crossing.value_or(specimen_.on_ray)));
  const Vec2d origin = place_of(specimen_.origin);
  const Vec2d from = length(origin - to) < across() ? origin : to - across() * towards;
  const RayStyle& style = ray_style(painter_.state.appearance.theme, specimen_.kind);
  const Vec2d end = specimen_.passed < 0 ? to : to + across() * towards;
  painter_.add_clipped({from, end, {style.colour, 2.6 * unit_, painter_.scaled(style.dash)}, 12 * unit_, 0.6});
  painter_.prominent.push_back({from, end});
}

/// One ray of each kind; naive ones if they start elsewhere. One that hits its own surface at once is cut off.
void Drawing::draw_leaving(const std::optional<Reading>& reading, bool naive) {
  if (!reading || hides_rays_to_come(painter_.state)) return;
  for (const SpawnedRays& rays : reading->spawned) {
    const Vec2d at = place_of(rays.origin), along = Vec2d(1, -1) * flat(rays.direction);
    const double size = length(along);
    if (!(size > 1e-9 * length(rays.direction)) || length(at - middle_) > across()) continue;
    if (naive && specimen_.robust && length(at - place_of(specimen_.robust->point)) < 6 * unit_ && rays.hit_own == 0)
      continue;
    const RayStyle& style = ray_style(painter_.state.appearance.theme, rays.kind);
    const Stroke stroke{style.colour, (naive ? 1.6 : 2.0) * unit_, painter_.scaled(style.dash)};
    const Vec2d towards = along / size;
    if (rays.hit_own > 0) {
      const Vec2d stopped = at + 34 * unit_ * towards;
      painter_.add_clipped({at, stopped, stroke});
      draw_blocked(painter_, stopped, towards, stroke);
      continue;
    }
    const double far = rays.kind == RayKind::shadow ? std::min(size * scale_, across()) : across();
    painter_.add_clipped({at, at + far * towards, stroke, 9 * unit_, 0.7});
    painter_.prominent.push_back({at, at + far * towards});
  }
}

/// Naive is a triangle, its ray origin a diamond, robust a disc, the truth a cross: distinguishable without colour.
void Drawing::draw_sign(const PointMark& mark) {
  const Vec2d& at = mark.at;
  const Stroke naive{painter_.colours.error, 2.4 * unit_}, thin{painter_.colours.text, 1.8 * unit_};
  switch (mark.sign) {
    case Sign::robust:
      painter_.add(CircleItem{at, 5.5 * unit_, painter_.colours.hovered, Stroke{painter_.colours.plan, 1.5 * unit_}});
      return;
    case Sign::naive: {
      const double r = 11 * unit_;
      painter_.add(PolygonItem{
          {at + Vec2d(0, -r), at + Vec2d(0.87 * r, 0.5 * r), at + Vec2d(-0.87 * r, 0.5 * r)}, std::nullopt, naive});
      return;
    }
    case Sign::naive_start: {
      const double r = 8 * unit_;
      painter_.add(
          PolygonItem{{at + Vec2d(0, -r), at + Vec2d(r, 0), at + Vec2d(0, r), at + Vec2d(-r, 0)}, std::nullopt, naive});
      return;
    }
    case Sign::crossing:
      for (const double turn : {1.0, -1.0})
        painter_.add(LineItem{at - 6 * unit_ * Vec2d(1, turn), at + 6 * unit_ * Vec2d(1, turn), thin});
  }
}

/// An arrow at the border, towards a point beyond it.
void Drawing::point_at(const PointMark& mark) {
  const Vec2d way = mark.at - middle_, room = middle_ - Vec2d(26 * unit_);
  const double part = std::min(room.x / std::max(std::abs(way.x), 1e-9), room.y / std::max(std::abs(way.y), 1e-9));
  const Vec2d towards = way / length(way), arrow = 24 * unit_ * towards;
  Vec2d tip = middle_ + part * way;
  const auto crosses_scale = [&] {
    const Vec2d centre = tip - arrow / 2.0, half = Vec2d(std::abs(arrow.x), std::abs(arrow.y)) / 2.0 + Vec2d(6 * unit_);
    return scale_box_.overlap({centre - half, centre + half}) > 0;
  };
  while (crosses_scale() && length(tip - middle_) > 2 * length(arrow)) tip -= 4 * unit_ * towards;
  const Stroke stroke{painter_.colours.error, 2.4 * unit_};
  painter_.add(LineItem{tip - arrow, tip, stroke, 11 * unit_});
  painter_.keep_free(tip - arrow / 2.0, 12 * unit_);
  label(tip - arrow / 2.0, 16 * unit_,
        fill("microscope.off_sight", painter_.state.appearance.language,
             {{"point", name_of(mark)},
              {"ulps", ulps_text(specimen_.in_ulps(mark.off ? std::abs(*mark.off) : length(way) / scale_),
                                 painter_.state.appearance.language)}}));
}

/// Between a sphere and the ray that passes it.
void Drawing::draw_gap() {
  const Vec2d at = pixels(flat(specimen_.on_ray));
  if (specimen_.passed < 0 || length(at - middle_) < 3 * unit_ || !in_sight(at, 0)) return;
  painter_.add(LineItem{middle_, at, {painter_.colours.error, 2 * unit_}});
  const Language language = painter_.state.appearance.language;
  label((at + middle_) / 2.0, 8 * unit_,
        fill("microscope.bar", language,
             {{"length", number_text(specimen_.gap, language)},
              {"ulps", ulps_text(specimen_.in_ulps(specimen_.gap), language)}}));
}

void Drawing::draw_marks() {
  std::vector<PointMark> marks;
  if (specimen_.robust) marks.push_back({place_of(specimen_.robust->point), Sign::robust});
  if (specimen_.naive) {
    marks.push_back({place_of(specimen_.naive->point), Sign::naive});
    for (const SpawnPoint& start : specimen_.naive->starts)
      marks.push_back({place_of(start.place), Sign::naive_start, true, start.off});
  }
  if (specimen_.crossing) marks.push_back({pixels(flat(*specimen_.crossing)), Sign::crossing, false});
  struct LabelGroup {
    Vec2d at;
    std::vector<PointMark> marks;
  };
  std::vector<LabelGroup> groups;
  const double margin = 14 * unit_;
  for (const PointMark& mark : marks) {
    if (!in_sight(mark.at, margin)) continue;
    painter_.keep_free(mark.at, 11 * unit_);
    if (mark.sign == Sign::naive_start && specimen_.naive) {
      const Vec2d from = place_of(specimen_.naive->point);
      painter_.add_clipped({from, mark.at, {painter_.colours.error, 1.4 * unit_, painter_.scaled({{2, 4}, 2})}});
    }
    const auto near = std::find_if(groups.begin(), groups.end(),
                                   [&](const LabelGroup& group) { return length(group.at - mark.at) < margin; });
    if (near == groups.end())
      groups.push_back({mark.at, {mark}});
    else if (mark.joins)
      near->marks.push_back(mark);
  }
  for (const PointMark& mark : marks)
    if (mark.sign == Sign::naive && in_sight(mark.at, margin)) draw_sign(mark);
  for (const PointMark& mark : marks)
    if (mark.sign != Sign::naive && in_sight(mark.at, margin) &&
        (mark.joins || std::none_of(groups.begin(), groups.end(), [&](const LabelGroup& group) {
           return group.at != mark.at && length(group.at - mark.at) < 4 * unit_;
         })))
      draw_sign(mark);
  for (const LabelGroup& group : groups) {
    const bool two_starts = std::count_if(group.marks.begin(), group.marks.end(),
                                          [](const PointMark& mark) { return mark.sign == Sign::naive_start; }) > 1;
    std::vector<std::string> names;
    for (const PointMark& mark : group.marks) names.push_back(name_of(mark, !two_starts));
    names.erase(std::unique(names.begin(), names.end()), names.end());
    label(group.at, 13 * unit_, fmt::format("{}", fmt::join(names, ", ")));
  }
  // If rays start at the point itself, one arrow is enough.
  std::optional<Vec2d> before;
  for (const PointMark& mark : marks) {
    if (!mark.joins || in_sight(mark.at, margin)) continue;
    if (!before || length(*before - mark.at) > margin) point_at(mark);
    before = mark.at;
  }
}

/// In the free place nearest to `at`, `clear` pixels away; in two lines where the pane is narrower than one.
void Drawing::label(const Vec2d& at, double clear, const std::string& words) {
  const double size = painter_.sizes.text;
  const std::vector<NameLines> ways = letterings(words, size);
  const NameLines& letters = ways.front().half.x > middle_.x ? ways.back() : ways.front();
  const Vec2d half(letters.half.x + 0.2 * size, letters.half.y);
  const PixelRect pane = painter_.pane();
  std::optional<Vec2d> best;
  double least = 0, least_cost = 0;
  for (const double farther : {1.0, 2.2, 3.6})
    for (const Vec2d& side : {Vec2d(1, 0), Vec2d(1, -1), Vec2d(1, 1), Vec2d(-1, 0), Vec2d(-1, -1), Vec2d(-1, 1),
                              Vec2d(0, -1), Vec2d(0, 1)}) {
      Vec2d middle = at + side * (half + Vec2d(farther * clear));
      for (const int axis : {0, 1})  // whole, where the pane is large enough for that
        if (half[axis] <= middle_[axis])
          middle[axis] = std::clamp(middle[axis], half[axis], 2 * middle_[axis] - half[axis]);
      const PixelRect box{middle - half, middle + half};
      double covered = 4 * half.x * half.y - box.overlap(pane);
      covered *= 10;
      for (const PixelRect& kept : painter_.kept_free) covered += box.overlap(kept);
      const bool lies_on_line = std::any_of(painter_.prominent.begin(), painter_.prominent.end(),
                                            [&](const auto& line) { return box.meets(line[0], line[1]); });
      // If equal, the nearest.
      const double cost = covered + (lies_on_line ? half.x * half.y : 0) + farther;
      if (best && cost >= least_cost) continue;
      best = middle, least = covered, least_cost = cost;
    }
  // In a small pane the table says which sign is whose; letters over letters say nothing.
  constexpr double most = 0.3;  // of the label, covered
  if (least > most * 4 * half.x * half.y + 4) return;
  const PixelRect box{*best - half, *best + half};
  painter_.kept_free.push_back(box);
  draw_letters(painter_, *best, letters, painter_.colours.text, painter_.halo());
}

/// The scale bar, in the lower left corner.
void Drawing::draw_scale() {
  const double size = painter_.sizes.text;
  const double cells = specimen_.ulp * scale_;
  const auto axis_name = [&](int i) { return std::string(1, "xyz"[specimen_.axes[static_cast<std::size_t>(i)]]); };
  const auto spacing = [&](int i) {
    return number_text(specimen_.spacing[specimen_.axes[static_cast<std::size_t>(i)]],
                       painter_.state.appearance.language);
  };
  const Vec2d at(12 * unit_, 2 * middle_.y - 12 * unit_);
  double bar = cells;
  std::string words;
  if (cells >= 14 * unit_) {
    const bool alike = cell(0) == cell(1);
    words = alike ? fill("microscope.one_cell", painter_.state.appearance.language, {{"ulp", spacing(0)}})
                  : fill("microscope.two_cells", painter_.state.appearance.language,
                         {{"first", axis_name(0)},
                          {"first_ulp", spacing(0)},
                          {"second", axis_name(1)},
                          {"second_ulp", spacing(1)}});
  } else {
    const double most = 130 * unit_ / scale_;
    double length = std::pow(10.0, std::floor(std::log10(most)));
    if (5 * length <= most)
      length *= 5;
    else if (2 * length <= most)
      length *= 2;
    bar = length * scale_;
    const Language language = painter_.state.appearance.language;
    words = fill("microscope.bar", language,
                 {{"length", number_text(length, language)}, {"ulps", ulps_text(specimen_.in_ulps(length), language)}});
    // In a small pane the half of it: what is in the middle is looked at.
    if (at.x + text_width(words, size) > middle_.x) words = number_text(length, language);
  }
  const double width = std::max(bar, text_width(words, size)) + 0.6 * size;
  painter_.add(PolygonItem{{at + Vec2d(-6 * unit_, -1.7 * size), at + Vec2d(width, -1.7 * size),
                            at + Vec2d(width, 6 * unit_), at + Vec2d(-6 * unit_, 6 * unit_)},
                           painter_.colours.plan.with_alpha(225),
                           std::nullopt});
  scale_box_ = {at + Vec2d(-6 * unit_, -1.7 * size), at + Vec2d(width, 6 * unit_)};
  painter_.kept_free.push_back(scale_box_);
  const Stroke stroke{painter_.colours.text, 2 * unit_};
  painter_.add(LineItem{at, at + Vec2d(bar, 0), stroke});
  for (const double end : {0.0, bar})
    painter_.add(LineItem{at + Vec2d(end, -4 * unit_), at + Vec2d(end, 4 * unit_), stroke});
  painter_.add(TextItem{at + Vec2d(0, -0.95 * size), words, size, painter_.colours.text, TextAnchor::start});
}

/// The magnification, in the upper left corner if that is free.
void Drawing::draw_factor() {
  const double size = painter_.sizes.text;
  const std::string factor = magnification_text(magnification(painter_.state, specimen_, painter_.viewport),
                                                painter_.state.appearance.language);
  const Vec2d half(text_width(factor, size) / 2 + 0.2 * size, 0.6 * size);
  const Vec2d at(12 * unit_ + half.x, 0.9 * size + 4 * unit_);
  if (!painter_.covers_kept({at - half, at + half})) painter_.note(at, factor);
}

}  // namespace

double magnification(const State& state, const Specimen& specimen, const Viewport& pane) {
  const double whole = pixels_per_unit(state, pane), cell = widest_cell * Sizes(state).unit;
  const double most = std::log10(cell / (whole * specimen.ulp));
  // Near 0, numbers are as close as exponents allow; nothing is drawn that small.
  constexpr double max_decades = 17;
  return std::pow(10.0, state.microscope.magnified * std::clamp(most, 0.0, max_decades));
}

DisplayList microscope_view(const State& state, const Specimen& specimen, const Viewport& pane) {
  return Drawing(state, specimen, pane).draw();
}

std::shared_ptr<const Specimen> specimen_of(Microscope& microscope, const State& state) {
  return microscope.look(state.walk.timeline, state.walk.position, *walked_scene(state),
                         state.picture.settings.single_precision ? Precision::float_ : Precision::double_);
}

void action::Magnify::apply(State& state) const { state.microscope.magnified = std::clamp(part, 0.0, 1.0); }

}  // namespace raywalk
