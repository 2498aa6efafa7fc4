// Places each name where a reader looks for it: on its body, else beside it, in two lines or at the end of a leader
// line if one line beside it would cover something or seem to name a neighbour.

#include "view/plan/labels_place.h"

#include "view/plan/ray_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace raywalk {

namespace {

PixelRect box_of(const Vec2d& middle, const Vec2d& half) { return {middle - half, middle + half}; }

/// The distance of two boxes, 0 if they touch.
double apart(const PixelRect& a, const PixelRect& b) {
  const double dx = std::max({a.min.x - b.max.x, b.min.x - a.max.x, 0.0});
  const double dy = std::max({a.min.y - b.max.y, b.min.y - a.max.y, 0.0});
  return std::hypot(dx, dy);
}

struct Filled {
  PixelRect box;
  Colour fill;
};

std::optional<Filled> filled(const Shape2d& shape) {
  if (const auto* circle = std::get_if<CircleItem>(&shape); circle != nullptr && circle->fill)
    return Filled{box_of(circle->centre, Vec2d(circle->radius)), *circle->fill};
  const auto* polygon = std::get_if<PolygonItem>(&shape);
  if (polygon == nullptr || !polygon->fill || polygon->points.empty()) return std::nullopt;
  PixelRect box{polygon->points.front(), polygon->points.front()};
  for (const Vec2d& p : polygon->points)
    box = {{std::min(box.min.x, p.x), std::min(box.min.y, p.y)}, {std::max(box.max.x, p.x), std::max(box.max.y, p.y)}};
  return Filled{box, *polygon->fill};
}

/// Whether a place lies on a body: first a look at its box, for an outline may have many corners.
bool holds(const DrawnBody& body, const Vec2d& at) { return body.box.holds(at) && covers(body.item, at); }

constexpr int columns = 8, rows = 2, samples = (columns + 1) * (rows + 1);  // of a label's box

/// Fraction of a label's box that a body covers, by samples: of all of it, or, of a body that could slip through
/// between these, of what the two boxes share. Not more than `most` of them are counted.
double covered(const DrawnBody& body, const PixelRect& label, int most = samples) {
  const double shared = body.box.overlap(label);
  if (shared <= 0) return 0;
  const Vec2d whole = label.max - label.min, own = body.box.max - body.box.min;
  const bool is_small = own.x < 2 * whole.x / columns || own.y < 2 * whole.y / rows;
  const PixelRect part = is_small
                             ? PixelRect{{std::max(label.min.x, body.box.min.x), std::max(label.min.y, body.box.min.y)},
                                         {std::min(label.max.x, body.box.max.x), std::min(label.max.y, body.box.max.y)}}
                             : label;
  const Vec2d size = part.max - part.min;
  int inside = 0;
  for (int i = 0; i <= columns && inside < most; ++i)
    for (int j = 0; j <= rows && inside < most; ++j) {
      const Vec2d sample = part.min + Vec2d(size.x * i / columns, size.y * j / rows);
      inside += holds(body, sample) ? 1 : 0;
    }
  return static_cast<double>(inside) / samples * (size.x * size.y) / (whole.x * whole.y);
}

/// Distance in pixels from a label's box to a body's drawing, 0 if they touch; any value above `most` if it exceeds
/// that.
double distance_to_box(const DrawnBody& body, const PixelRect& label, double most) {
  if (const double least = apart(body.box, label); least > most) return least;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= columns; ++i)
    for (const double y : {label.min.y, (label.min.y + label.max.y) / 2, label.max.y})
      least = std::min(least, distance_to(body.item, {label.min.x + (label.max.x - label.min.x) * i / columns, y}));
  return least;
}

/// A label's distance from its own body, and from the nearest other one.
struct Distances {
  double own = 0, other = std::numeric_limits<double>::infinity();
};

/// Whether a name may lie on this body: it is its own, or what is named stands on it, or is surrounded by it, as by a
/// floor.
bool is_ground(const Labelled& thing, const DrawnBody& body) {
  if (body.item.target == thing.body) return true;
  if (!thing.body && holds(body, thing.at)) return true;
  const Vec2d low = thing.at - thing.half, high = thing.at + thing.half;
  const Vec2d size = body.box.max - body.box.min, own = high - low;
  const double slack = thing.body ? 0.5 : 0;  // a ceiling lies over its floor
  const bool around = body.box.min.x <= low.x + slack && body.box.min.y <= low.y + slack &&
                      body.box.max.x >= high.x - slack && body.box.max.y >= high.y - slack;
  const bool larger = size.x * size.y > 2 * own.x * own.y;
  const bool same = thing.body && std::abs(size.x - own.x) < 1 && std::abs(size.y - own.y) < 1;
  // A bracket is around what lies in its hollow, but not below it.
  return around && (larger || same) && holds(body, thing.at);
}

/// `left_out`: of each body, whether it does not count unless it is the thing's own; none: all count.
Distances distances(const std::vector<DrawnBody>& bodies, const Labelled& thing, const PixelRect& label, double crowded,
                    const std::vector<bool>& left_out = {}) {
  Distances all;
  if (thing.body) all.own = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DrawnBody& body = bodies[i];
    const bool is_own = thing.body && body.item.target == thing.body;
    if (!is_own && !left_out.empty() && left_out[i]) continue;
    double& least = is_own ? all.own : all.other;
    least = std::min(least, distance_to_box(body, label, is_own ? least : std::min(least, crowded)));
  }
  if (!std::isfinite(all.own)) all.own = 0;
  return all;
}

/// From the edge of a label into a body, far enough that the body is unambiguous.
std::array<Vec2d, 2> line_to(const DrawnBody& body, const Vec2d& middle, const PixelRect& label, double unit) {
  const Vec2d from(std::clamp(middle.x, label.min.x, label.max.x), std::clamp(middle.y, label.min.y, label.max.y));
  const Vec2d way = middle - from;
  const double whole = length(way);
  constexpr int steps = 64;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (!holds(body, from + t * way)) continue;
    return {from, from + std::min(t + (whole > 0 ? 5 * unit / whole : 0), 1.0) * way};
  }
  return {from, middle};
}

/// Whether a name needs a leader line to its thing: it is far away, or another body is nearly as near as its own.
bool is_ambiguous(const std::vector<DrawnBody>& bodies, const Labelled& thing, const PixelRect& label, double unit) {
  if (!thing.body) return apart(box_of(thing.at, thing.half), label) > 14 * unit;
  const Distances away = distances(bodies, thing, label, 60 * unit);
  // Letters are a little narrower than their box.
  return away.own > 14 * unit || away.other <= 1.5 * away.own + 2 * unit;
}

/// The line from a name to its thing: into a body, or to the edge of a symbol. None if it has a body that is not drawn.
std::optional<std::array<Vec2d, 2>> line_to(const std::vector<DrawnBody>& bodies, const Labelled& thing,
                                            const PixelRect& label, double unit) {
  if (thing.body) {
    const auto own =
        std::find_if(bodies.begin(), bodies.end(), [&](const DrawnBody& b) { return b.item.target == thing.body; });
    return own == bodies.end() ? std::nullopt : std::optional(line_to(*own, thing.at, label, unit));
  }
  const Vec2d from(std::clamp(thing.at.x, label.min.x, label.max.x), std::clamp(thing.at.y, label.min.y, label.max.y));
  const Vec2d way = thing.at - from;
  if (thing.strip) {
    constexpr int steps = 64;
    const auto at = [&](int step) { return from + static_cast<double>(step) / steps * way; };
    // Up to just before it.
    int i = 0;
    while (i < steps && distance_to({*thing.strip}, at(i + 1)) > unit) ++i;
    return std::array{from, at(i)};
  }
  const Vec2d reach = thing.half + 6 * unit;
  const double inside =
      std::min({1.0, reach.x / std::max(std::abs(way.x), 1e-9), reach.y / std::max(std::abs(way.y), 1e-9)});
  return std::array{from, thing.at - inside * way};
}

/// What a name keeps off beside bodies and symbols.
struct Neighbours {
  std::vector<PixelRect> names;                 ///< of the others
  std::vector<std::array<Vec2d, 2>> leaders{};  ///< of the others
};

class Places {
 public:
  Places(const Painter& painter, const std::vector<DrawnBody>& bodies, const RayCover& rays, const Labelled& thing,
         Neighbours neighbours)
      : painter_(painter),
        bodies_(bodies),
        rays_(rays),
        thing_(thing),
        neighbours_(std::move(neighbours)),
        unit_(painter.sizes.unit),
        letterings_(letterings(thing.text, painter.sizes.text)),
        area_(area(letterings_.front())) {
    ground_.reserve(bodies.size());
    for (const DrawnBody& body : bodies) ground_.push_back(is_ground(thing, body));
  }

  /// Its place on its own body, if it fits: in its middle, or, on a ground, where nothing stands.
  [[nodiscard]] LabelPlace on_body() {
    if (!thing_.body || !thing_.solid) return best_;
    for (const NameLines& letters : letterings_) {
      if (covers_own(box_of(thing_.at, letters.half + 2 * unit_)) == 1) consider({thing_.at, letters, true}, 0);
      if (best_.on_body && good()) return best_;
    }
    const NameLines& letters = letterings_.front();
    constexpr double ground = 3;  // times as large as the name
    const Vec2d room = thing_.half - letters.half - 4 * unit_;
    if (thing_.half.x < ground * letters.half.x || thing_.half.y < ground * letters.half.y) return best_;
    constexpr int steps = 4;
    for (const double y : {-1.0, 1.0, -0.5, 0.5})
      for (int i = 0; i <= steps; ++i) {
        const Vec2d at = thing_.at + Vec2d((2.0 * i / steps - 1) * room.x, y * room.y);
        const PixelRect box = box_of(at, letters.half + 2 * unit_);
        if (!is_crossed(box) && covers_own(box) == 1) consider({at, letters, true}, 0.05 * area_);
      }
    return best_;
  }

  [[nodiscard]] LabelPlace best() {
    if (on_body().on_body && good()) return best_;
    // Two lines and distant places only if nothing simpler is good.
    constexpr double near = 5;
    for (const double gap : {near, 4 * near, 8 * near, 12 * near})
      for (const NameLines& letters : letterings_) {
        if (good()) return best_;
        const double extra_cost = (letters.lines.size() > 1 ? 0.05 : 0) + (gap > near ? 0.1 + 0.006 * gap : 0);
        beside(letters, gap * unit_, extra_cost * area_, gap > near);
        if (!thing_.body) break;
      }
    // Farther away rather than not at all; and rather over rays than where it may not be.
    for (const double gap : {16 * near, 22 * near, 30 * near})
      for (const NameLines& letters : letterings_)
        if (!is_shown(thing_, best_shown_)) beside(letters, gap * unit_, (0.1 + 0.006 * gap) * area_, true);
    for (const NameLines& letters : letterings_)
      if (!is_shown(thing_, best_shown_)) anywhere(letters);
    return is_shown(thing_, best_) || !is_shown(thing_, best_shown_) ? best_ : best_shown_;
  }

 private:
  static double area(const NameLines& letters) { return 4 * letters.half.x * letters.half.y; }
  /// Nothing is covered, and no other body is near.
  [[nodiscard]] bool good() const { return best_.cost < 0.3 * area_; }

  /// By a line that names nothing, such as a patch of a wall.
  [[nodiscard]] bool is_crossed(const PixelRect& box) const {
    return std::any_of(painter_.list.begin(), painter_.list.end(), [&](const DisplayItem& item) {
      const auto* line = std::get_if<LineItem>(&item.shape);
      if (line == nullptr || item.target) return false;
      const Vec2d thick(line->stroke.width / 2);
      return PixelRect{box.min - thick, box.max + thick}.meets(line->from, line->to);
    });
  }

  [[nodiscard]] double covers_own(const PixelRect& label) const {
    double most = 0;
    for (const DrawnBody& body : bodies_)
      if (body.item.target == thing_.body) most = std::max(most, covered(body, label));
    return most;
  }
  [[nodiscard]] bool is_off_own(const PixelRect& label) const {
    return std::none_of(bodies_.begin(), bodies_.end(), [&](const DrawnBody& body) {
      return body.item.target == thing_.body && covered(body, label, 1) > 0;
    });
  }

  /// Its area outside of the pane, on symbols and handles, and on other names.
  [[nodiscard]] double blocked_at(const PixelRect& box, double own_area) const {
    const PixelRect pane{painter_.pane().min + unit_, painter_.pane().max - unit_};
    double blocked = own_area - std::min(box.overlap(pane), own_area);
    for (const PixelRect& taken : painter_.kept_free) blocked += box.overlap(taken);
    for (const PixelRect& taken : painter_.unnamed) blocked += box.overlap(taken);
    for (const PixelRect& name : neighbours_.names) blocked += box.overlap(name);
    return blocked;
  }

  [[nodiscard]] static double cost_of_blocked(const LabelPlace& place) {
    return 8 * place.blocked * area(place.letters);
  }

  [[nodiscard]] double hidden_at(const LabelPlace& place) const {
    const PixelRect box = place.box();
    const double own_area = area(place.letters);
    double hidden = cost_of_blocked(place);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (const DrawnBody& body = bodies_[i]; !ground_[i] || (!place.on_body && body.item.target == thing_.body)) {
        hidden += 1.5 * own_area * covered(body, box);
        // A small thing covers little of a name, but the name may hide all of it.
        const Vec2d size = body.box.max - body.box.min;
        hidden += own_area * body.box.overlap(box) / std::max(size.x * size.y, 1.0);
      }
    return hidden;
  }

  /// How easily a label is mistaken for that of another body, 0..1: high if another is nearer than its own, low if
  /// another is near at all.
  [[nodiscard]] double mistakable(const PixelRect& label) const {
    const double crowded = 60 * unit_;
    const Distances away = distances(bodies_, thing_, label, crowded, ground_);
    const double enough = 2 * away.own + 4 * unit_;
    return std::max(away.other < enough ? 0.9 * (1 - away.other / enough) : 0.0,
                    0.3 * std::max(0.0, 1 - away.other / crowded));
  }

  /// The same at the end of a line, which is unambiguous unless the name almost touches another body.
  [[nodiscard]] double touching(const PixelRect& label) const {
    const double near = 12 * unit_;
    return 0.5 * std::max(0.0, 1 - distances(bodies_, thing_, label, near, ground_).other / near);
  }

  /// Whether its leader line crosses another body, which it would then seem to name.
  [[nodiscard]] bool crosses(const PixelRect& label) const {
    const auto line = line_to(bodies_, thing_, label, unit_);
    if (!line) return false;
    const auto [from, to] = *line;
    constexpr int steps = 12;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (ground_[k] || !bodies_[k].box.meets(from, to)) continue;
      for (int i = 0; i < steps; ++i)
        if (holds(bodies_[k], from + static_cast<double>(i) / steps * (to - from))) return true;
    }
    return false;
  }

  /// The cost of the rays under a name. That of a symbol stays near.
  [[nodiscard]] double lined(const PixelRect& box) const {
    return area_ * std::min(4 * rays_.of(box), thing_.body ? 0.75 : 0.4);
  }

  /// Whether another text's leader line would cross it.
  [[nodiscard]] bool struck_through(const PixelRect& box) const {
    const auto crossed = [&](const auto& line) { return box.meets(line[0], line[1]); };
    return std::any_of(neighbours_.leaders.begin(), neighbours_.leaders.end(), crossed) ||
           std::any_of(painter_.leaders.begin(), painter_.leaders.end(), crossed);
  }

  /// Whether its leader line crosses another name, another leader, or what is kept free.
  [[nodiscard]] bool strikes_through(const PixelRect& label) const {
    const auto line = line_to(bodies_, thing_, label, unit_);
    if (!line) return false;
    const auto crossed = [&](const PixelRect& taken) { return taken.meets((*line)[0], (*line)[1]); };
    // A symbol that stands in SCREEN has its middle in what is kept free around it too.
    const auto is_over = [&](const DisplayItem& item) {
      constexpr int steps = 32;
      for (int i = 0; i <= steps; ++i)
        if (distance_to(item, (*line)[0] + static_cast<double>(i) / steps * ((*line)[1] - (*line)[0])) <= unit_)
          return true;
      return false;
    };
    if (thing_.strip && std::any_of(painter_.list.begin(), painter_.list.end(), [&](const DisplayItem& item) {
          return (item.target.kind == TargetKind::light || item.target.kind == TargetKind::eye) && is_over(item);
        }))
      return true;
    // A symbol lies in what is kept free around it.
    const auto is_own = [&](const PixelRect& taken) {
      return !thing_.body && taken.min.x <= thing_.at.x && thing_.at.x <= taken.max.x && taken.min.y <= thing_.at.y &&
             thing_.at.y <= taken.max.y;
    };
    const auto is_across = [&](const auto& other) { return cross_each_other(*line, other); };
    return std::any_of(neighbours_.names.begin(), neighbours_.names.end(), crossed) ||
           std::any_of(neighbours_.leaders.begin(), neighbours_.leaders.end(), is_across) ||
           std::any_of(painter_.leaders.begin(), painter_.leaders.end(), is_across) ||
           std::any_of(painter_.kept_free.begin(), painter_.kept_free.end(),
                       [&](const PixelRect& taken) { return crossed(taken) && !is_own(taken); });
  }

  void consider(LabelPlace place, double extra_cost, bool led = false) {
    place.blocked = blocked_at(place.box(), area(place.letters)) / area(place.letters);
    // Most places are lost by what blocks them alone.
    place.cost = cost_of_blocked(place) + extra_cost;
    bool serves = is_shown(thing_, place);
    const auto loses = [&] { return place.cost >= best_.cost && (!serves || place.cost >= best_shown_.cost); };
    if (loses()) return;
    const double hidden = hidden_at(place);
    place.hidden = hidden / area(place.letters);
    place.cost = hidden + extra_cost;
    serves = is_shown(thing_, place);
    if (loses()) return;
    if (!place.on_body) place.cost += lined(place.box());
    if (!place.on_body) place.cost += area_ * (led ? touching(place.box()) : mistakable(place.box()));
    const auto misleads = [&](const PixelRect& box) {
      const bool leads = led || (!place.on_body && is_ambiguous(bodies_, thing_, box, unit_));
      return struck_through(box) || (leads && (crosses(box) || strikes_through(box)));
    };
    if (!loses() && misleads(place.box())) {
      place.cost += 2 * area_;
      place.hidden += 1;
    }
    constexpr double little = 0.15;
    if (place.cost < best_shown_.cost && is_shown(thing_, place) && place.hidden <= little) best_shown_ = place;
    if (place.cost < best_.cost) best_ = std::move(place);
  }

  /// The distance from the middle of its thing, in this direction, at which a label is clear of it, relative to that
  /// beside its bounding box. A slanted wall's box is mostly empty, so its label may be nearer.
  [[nodiscard]] double clear_at(const Vec2d& half, const Vec2d& way) const {
    if (!thing_.body) return 1;
    constexpr int steps = 16;
    constexpr double most = 1.5;
    for (int i = 0; i < most * steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      if (is_off_own(box_of(thing_.at + t * way, half))) return t;
    }
    return most;
  }

  /// Beside the thing, in order of preference: below or above, at the sides, with aligned edges, and at the corners.
  void beside(const NameLines& letters, double gap, double extra_cost, bool led) {
    const Vec2d half = letters.half;
    const double dx = thing_.half.x + half.x + gap, dy = thing_.half.y + half.y + gap;
    const double first = thing_.above ? -1 : 1;
    const double in_line_x = std::abs(thing_.half.x - half.x), in_line_y = std::abs(thing_.half.y - half.y);
    double order = 0;
    // At the end of a leader line all sides are nearly equal.
    const double weight = led ? 0.2 : 1;
    const auto try_all = [&](const std::vector<Vec2d>& ways, double more) {
      for (const Vec2d& way : ways)
        consider({thing_.at + clear_at(half + gap, way) * way, letters},
                 extra_cost + weight * (0.02 * ++order + more) * area_, led);
    };
    try_all({{0, first * dy}, {0, -first * dy}, {dx, 0}, {-dx, 0}}, 0);
    try_all({{in_line_x, first * dy},
             {-in_line_x, first * dy},
             {in_line_x, -first * dy},
             {-in_line_x, -first * dy},
             {dx, in_line_y},
             {dx, -in_line_y},
             {-dx, in_line_y},
             {-dx, -in_line_y}},
            0);
    if (led) try_all({{dx, 0.6 * dy}, {dx, -0.6 * dy}, {-dx, 0.6 * dy}, {-dx, -0.6 * dy}}, 0);
    // A name at a corner is easily read as the caption of what lies below or above it.
    try_all({{0.7 * dx, 0.8 * dy}, {-0.7 * dx, 0.8 * dy}, {0.7 * dx, -0.8 * dy}, {-0.7 * dx, -0.8 * dy}},
            thing_.body ? 0.1 : 0);
  }

  /// Wherever in the pane there is room, at the end of a leader line.
  void anywhere(const NameLines& letters) {
    const Vec2d low = painter_.pane().min + letters.half + 2 * unit_,
                high = painter_.pane().max - letters.half - 2 * unit_;
    if (low.x > high.x || low.y > high.y) return;
    constexpr int across = 16, down = 12;
    for (int row = 0; row <= down; ++row)
      for (int column = 0; column <= across; ++column) {
        const Vec2d at = low + Vec2d((high.x - low.x) * column / across, (high.y - low.y) * row / down);
        const double away = apart(box_of(at, letters.half), box_of(thing_.at, thing_.half)) / unit_;
        consider({at, letters}, (0.1 + 0.006 * away) * area_, true);
      }
  }

  const Painter& painter_;
  const std::vector<DrawnBody>& bodies_;
  const RayCover& rays_;
  const Labelled& thing_;
  Neighbours neighbours_;
  double unit_;
  std::vector<NameLines> letterings_;
  std::vector<bool> ground_{};  ///< of each body
  double area_;                 ///< of the name in one line, in pixels: the unit of costs
  LabelPlace best_;
  LabelPlace best_shown_;  ///< of those where it may be shown, and hides next to nothing
};

/// The leader line from a name to its thing, if it is ambiguous or far away.
std::optional<std::array<Vec2d, 2>> leader_of(const Painter& painter, const std::vector<DrawnBody>& bodies,
                                              const Labelled& thing, const LabelPlace& place) {
  const double unit = painter.sizes.unit;
  if (place.on_body || place.letters.lines.empty() || !is_ambiguous(bodies, thing, place.box(), unit))
    return std::nullopt;
  return line_to(bodies, thing, place.box(), unit);
}

}  // namespace

std::vector<NameLines> letterings(const std::string& text, double size) {
  std::vector<NameLines> all{{{text}, {width_of(text, size) / 2, size / 2}}};
  double narrowest = all.front().half.x;
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const std::string first = text.substr(0, at), second = text.substr(at + 1);
    const double half = std::max(width_of(first, size), width_of(second, size)) / 2;
    if (first.empty() || second.empty() || half >= narrowest) continue;
    narrowest = half;
    all.resize(1);
    all.push_back({{first, second}, {half, size}});
  }
  return all;
}

void draw_letters(Painter& painter, const Vec2d& middle, const NameLines& letters, Colour colour,
                  std::optional<Colour> halo) {
  const double size = painter.sizes.text;
  const auto count = static_cast<double>(letters.lines.size());
  double line = 0;
  for (const std::string& words : letters.lines)
    painter.add(
        TextItem{middle + Vec2d(0, (line++ - (count - 1) / 2) * size), words, size, colour, TextAnchor::middle, halo});
}

std::vector<DrawnBody> drawn_bodies(const DisplayList& list) {
  std::vector<DrawnBody> bodies;
  for (const DisplayItem& item : list)
    if (item.target.kind == TargetKind::object)
      if (const auto drawn = filled(item.shape)) bodies.push_back({item, drawn->box, drawn->fill});
  return bodies;
}

bool is_shown(const Labelled& thing, const LabelPlace& place) {
  constexpr double touching = 0.02;
  return !place.letters.lines.empty() &&
         (thing.wanted || (place.blocked <= touching && (place.on_body || place.hidden <= 0.6)));
}

std::vector<LabelPlace> place_labels(const Painter& painter, const std::vector<DrawnBody>& bodies,
                                     const std::vector<Labelled>& things) {
  const double margin = 2.5 * painter.sizes.unit;
  const RayCover rays(painter);
  // Two passes: in the first, the later places are not yet known.
  const auto placed = [&](const std::vector<std::size_t>& order) {
    std::vector<LabelPlace> places(things.size());
    const auto all_but = [&](std::size_t own) {
      Neighbours all;
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (k == own || !is_shown(things[k], places[k])) continue;
        all.names.push_back({places[k].box().min - margin, places[k].box().max + margin});
        if (places[k].leader) all.leaders.push_back(*places[k].leader);
      }
      return all;
    };
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round)
      for (const std::size_t i : order) {
        places[i] = Places(painter, bodies, rays, things[i], all_but(i)).best();
        places[i].leader = leader_of(painter, bodies, things[i], places[i]);
      }
    return places;
  };
  // Names that fit onto their bodies first, then long names, which have the fewest places.
  std::vector<std::size_t> order(things.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> turn;
  for (const Labelled& thing : things) {
    const bool fits = Places(painter, bodies, rays, thing, {}).on_body().on_body;
    turn.push_back(!thing.body ? -2e9 : fits ? -1e9 : -width_of(thing.text, painter.sizes.text));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return turn[a] < turn[b]; });
  std::vector<LabelPlace> best = placed(order);
  // Those that found no room come earlier, unless that leaves out as many: of a few, each name counts.
  constexpr std::size_t few = 12;
  constexpr int tries = 8;
  const auto is_left_out = [&](const std::vector<LabelPlace>& places) {
    return [&](std::size_t i) { return !is_shown(things[i], places[i]); };
  };
  // EYE, SCREEN and lights are spoken of most.
  const auto lack_of = [&](const std::vector<LabelPlace>& places) {
    std::size_t lack = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
      if (!is_shown(things[i], places[i])) lack += things[i].body ? 1 : few;
    return lack;
  };
  std::size_t left_out = lack_of(best);
  std::vector<LabelPlace> last = best;
  for (int i = 0; i < tries && left_out > 0 && things.size() <= few; ++i) {
    std::stable_partition(order.begin(), order.end(), is_left_out(last));
    last = placed(order);
    const std::size_t now = lack_of(last);
    if (now < left_out) best = last, left_out = now;
  }
  return best;
}

}  // namespace raywalk
