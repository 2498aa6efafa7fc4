#include "view/space/lines_names.h"

#include "view/plan/labels_place.h"
#include "view/text/shown.h"

#include <algorithm>
#include <limits>

namespace raywalk {

namespace {

/// With more objects than this, none is named.
constexpr std::size_t few_named = 40;

/// An object with its name, and possible places for it.
struct Named {
  std::string text;
  PixelRect seen;             ///< around its visible part
  std::vector<Vec2d> places;  ///< on the object, the middle first
  bool flat = false;          ///< like a wall
  [[nodiscard]] double area() const {
    const Vec2d size = seen.max - seen.min;
    return size.x * size.y;
  }
};

std::optional<Named> named(const State& state, const Projection& seen, const Object& object) {
  const Bounds<double> box = bounds(object.shape);
  if (box.empty() || !box.bounded()) return std::nullopt;
  const Affine<double> place = affine_of(object.transform);
  const Vec3d size = box.max - box.min;
  const auto at = [&](double x, double y, double z) {
    return seen.point(place.point(box.min + Vec3d(x * size.x, y * size.y, z * size.z)));
  };
  const auto middle = at(0.5, 0.5, 0.5);
  if (!middle) return std::nullopt;
  Named thing{shown_name(state, object.name), {*middle, *middle}, {*middle}};
  for (int corner = 0; corner < 8; ++corner)
    if (const auto p = at(corner & 1, corner >> 1 & 1, corner >> 2))
      thing.seen = {{std::min(thing.seen.min.x, p->x), std::min(thing.seen.min.y, p->y)},
                    {std::max(thing.seen.max.x, p->x), std::max(thing.seen.max.y, p->y)}};
  // On flat objects anywhere, on others below or above the middle, where they are widest.
  const double flat = 0.02 * length(size);
  thing.flat = size.x < flat || size.y < flat || size.z < flat;
  for (const double x : {0.5, 0.3, 0.7, 0.15, 0.85})
    for (const double y : {0.5, 0.3, 0.7, 0.15, 0.85})
      for (const double z : {0.5, 0.3, 0.7, 0.15, 0.85}) {
        if (!thing.flat && (x != 0.5 || y != 0.5)) continue;
        if (const auto p = at(x, y, z)) thing.places.push_back(*p);
      }
  return thing;
}

void put(Painter& painter, const Vec2d& at, const NameLines& letters) {
  const Vec2d half = letters.half + Vec2d(4 * painter.sizes.unit, 0);
  const PixelRect box{at - half, at + half};
  painter.kept_free.push_back(box);
  painter.add(PolygonItem{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}},
                          painter.colours.plan.with_alpha(150),
                          std::nullopt});
  draw_letters(painter, at, letters, painter.colours.text);
}

/// How easily a name on another thing is mistaken for that one's, 0..1. On a small thing before a wall, certainly; the
/// boxes of a room's walls overlap in places that are on neither.
double mistakable(const Named& own, const Named& other) {
  if (other.area() < 0.6 * own.area()) return 1;
  if (other.area() > 2 * own.area()) return 0;
  return other.flat ? 0.05 : 0.6;
}

void name_one(Painter& painter, const Named& thing, const std::vector<Named>& all,
              const std::vector<std::array<Vec2d, 2>>& lines) {
  struct NamePlace {
    double cost = std::numeric_limits<double>::infinity();
    Vec2d at;
    NameLines letters;
  } best;
  const double gap = 4 * painter.sizes.unit;
  for (const NameLines& letters : letterings(thing.text, painter.sizes.text)) {
    const Vec2d half = letters.half + Vec2d(gap, 0);
    const double area = 4 * half.x * half.y;
    std::vector<Vec2d> places = thing.places;
    const Vec2d middle = (thing.seen.min + thing.seen.max) / 2.0, out = (thing.seen.max - thing.seen.min) / 2.0 + half;
    for (const Vec2d& way : {Vec2d(0, 1), Vec2d(0, -1), Vec2d(1, 0), Vec2d(-1, 0)})
      places.push_back(middle + way * out);
    for (const Vec2d& at : places) {
      const PixelRect box{at - half, at + half};
      double cost = 4 * (1 - box.overlap(painter.pane()) / area) + (letters.lines.size() > 1 ? 0.15 : 0);
      for (const PixelRect& taken : painter.kept_free) cost += 100 * box.overlap(taken) / area;
      for (const Named& other : all)
        if (&other != &thing) cost += mistakable(thing, other) * box.overlap(other.seen) / area;
      const auto crosses = [&](const auto& ends) { return box.meets(ends[0], ends[1]); };
      if (cost < best.cost && std::any_of(lines.begin(), lines.end(), crosses)) cost += 0.5;
      cost += 0.4 * length(at - thing.places.front()) / (half.x + length(out));
      if (cost < best.cost) best = {cost, at, letters};
    }
  }
  if (best.cost < 3) put(painter, best.at, best.letters);
}

}  // namespace

void draw_name(Painter& painter, const std::string& what, const Vec2d& of, const Vec2d& away,
               const std::vector<std::array<Vec2d, 2>>& lines) {
  if (what.empty()) return;
  const NameLines letters = letterings(what, painter.sizes.text).front();
  const Vec2d beside(length(away) + letters.half.x, 0);
  for (const bool on_lines : {false, true})
    for (const Vec2d& at : {of + away, of - away, of + beside, of - beside}) {
      const PixelRect box{at - letters.half, at + letters.half};
      if (box.overlap(painter.pane()) < 0.999 * 4 * letters.half.x * letters.half.y) continue;
      if (!on_lines &&
          std::any_of(lines.begin(), lines.end(), [&](const auto& ends) { return box.meets(ends[0], ends[1]); }))
        continue;
      if (painter.covers_kept(box)) continue;
      return put(painter, at, letters);
    }
}

void draw_object_names(Painter& painter, const Projection& seen, const std::vector<std::array<Vec2d, 2>>& lines) {
  if (painter.scene().objects.size() > few_named) return;
  std::vector<Named> things;
  for (const Object& object : painter.scene().objects)
    if (auto thing = named(painter.state, seen, object); thing && !thing->text.empty())
      things.push_back(std::move(*thing));
  // Small ones first: those around and behind them have more room.
  std::stable_sort(things.begin(), things.end(), [](const Named& a, const Named& b) { return a.area() < b.area(); });
  for (const Named& thing : things) name_one(painter, thing, things, lines);
}

}  // namespace raywalk
