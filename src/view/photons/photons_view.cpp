#include "trace/photon_pass.h"
#include "view/plan/painter.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace raywalk {

namespace {

/// Dots that fall into one small square of the pane are drawn as one: however many photons there are, what is drawn
/// stays little.
class Dots {
 public:
  Dots(Painter& painter, double cell)
      : painter_(painter),
        cell_(cell),
        columns_(static_cast<std::size_t>(painter.viewport.width / cell) + 1),
        taken_(columns_ * (static_cast<std::size_t>(painter.viewport.height / cell) + 1), 0) {}

  void add(const Vec3d& position, bool caustic) {
    const Vec2d at = painter_.pixels(Vec2d(position));
    if (!(at.x >= 0 && at.y >= 0 && at.x < painter_.viewport.width && at.y < painter_.viewport.height)) return;
    const std::size_t place =
        static_cast<std::size_t>(at.y / cell_) * columns_ + static_cast<std::size_t>(at.x / cell_);
    std::uint8_t& taken = taken_[place];
    const std::uint8_t mark = caustic ? 2 : 1;
    if (taken >= mark) return;
    taken = mark;
    (caustic ? caustic_ : other_).push_back(at);
  }
  [[nodiscard]] std::size_t count() const { return caustic_.size() + other_.size(); }

  void draw() {
    const double radius = 1.6 * painter_.sizes.unit;
    for (const Vec2d& at : other_) painter_.add(CircleItem{at, radius, painter_.colours.dim_text, std::nullopt});
    for (const Vec2d& at : caustic_) painter_.add(CircleItem{at, radius, painter_.colours.light, std::nullopt});
  }

 private:
  Painter& painter_;
  double cell_;
  std::size_t columns_;
  std::vector<std::uint8_t> taken_;
  std::vector<Vec2d> caustic_, other_;
};

void draw_dots(Painter& painter, const Timeline& timeline, int position) {
  const auto fill = [&](Dots& dots) {
    for (const Timeline::StoredPhoton& photon : timeline.stored_photons())
      if (photon.stored_at <= position) dots.add(photon.position, photon.history == PhotonHistory::caustic);
    if (position < timeline.all_photons_at() || timeline.photons() == nullptr) return;
    for (const Photon& photon : timeline.photons()->other.photons()) dots.add(Vec3d(photon.position), false);
    for (const Photon& photon : timeline.photons()->caustic.photons()) dots.add(Vec3d(photon.position), true);
  };
  constexpr std::size_t most = 6000;
  for (double cell = 1.5;; cell *= 2) {
    Dots dots(painter, cell * painter.sizes.unit);
    fill(dots);
    if (dots.count() > most && cell < 12) continue;
    return dots.draw();
  }
}

void draw_circle(Painter& painter, const PhotonsFound& found, const PhotonCircle& circle, Colour colour) {
  if (!(circle.radius > 0)) return;
  const Vec2d centre = painter.pixels(Vec2d(found.position));
  const double radius = painter.pixels(circle.radius);
  painter.add(CircleItem{centre, radius, std::nullopt, painter.stroke(colour, 1.6)});
  // On its way there.
  for (const double share : {0.33, 0.66})
    painter.add(
        CircleItem{centre, share * radius, std::nullopt, painter.stroke(mix(painter.colours.plan, colour, 0.4))});
}

}  // namespace

void PhotonRoom::draw_in_plan(Painter& painter) {
  const Timeline& timeline = *painter.state.walk.timeline;
  if (!timeline.of_photons()) return;
  const int position = painter.state.walk.position;
  draw_dots(painter, timeline, position);
  // The circle stays while its light is added.
  for (int back = 0; back < 2 && position - back > 0; ++back)
    if (const auto* found = std::get_if<PhotonsFound>(&timeline.event(position - 1 - back).detail)) {
      draw_circle(painter, *found, found->other, painter.colours.ink);
      draw_circle(painter, *found, found->caustic, painter.colours.light);
    }
  if (timeline.is_flat()) draw_flat_note(painter, "plan.flat");
}

}  // namespace raywalk
