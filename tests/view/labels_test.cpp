// Names in the plan: that they can be read, and whom they name.
#include "contrast.h"
#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::optional<Colour> fill_of(const DisplayItem& item) {
  if (const auto* circle = std::get_if<CircleItem>(&item.shape)) return circle->fill;
  if (const auto* polygon = std::get_if<PolygonItem>(&item.shape)) return polygon->fill;
  return std::nullopt;
}

/// What the items before `end` paint there, their lines left out.
Colour painted(const State& state, const DisplayList& list, std::size_t end, const Vec2d& at) {
  Colour seen = palette(state.appearance.theme).plan;
  for (std::size_t i = 0; i < end; ++i)
    if (const auto fill = fill_of(list[i]); fill && distance_to(list[i], at) == 0)
      seen = mix(seen, fill->with_alpha(255), fill->a / 255.0);
  return seen;
}

/// A name in one line or two.
struct Name {
  std::string text;
  std::size_t item;  ///< its first line's place in the list
  Vec2d min, max;    ///< of its letters: text_width() is generous
};

std::vector<Name> names_of(const DisplayList& list) {
  std::vector<Name> names;
  const TextItem* before = nullptr;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto* text = std::get_if<TextItem>(&list[i].shape);
    if (text != nullptr && text->anchor == TextAnchor::middle) {
      const Vec2d half(0.36 * text_width(text->text, text->size), 0.4 * text->size);
      const Vec2d min = text->at - half, max = text->at + half;
      const bool second =
          before != nullptr && before->at.x == text->at.x && std::abs(text->at.y - before->at.y - text->size) < 1e-6;
      if (second) {
        Name& name = names.back();
        name = {name.text + " " + text->text,
                name.item,
                {std::min(name.min.x, min.x), name.min.y},
                {std::max(name.max.x, max.x), max.y}};
      } else {
        names.push_back({text->text, i, min, max});
      }
    }
    before = text;
  }
  return names;
}

double distance_between(const DisplayItem& item, const Name& name) {
  double least = 1e300;
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 4; ++j)
      least = std::min(least, distance_to(item, name.min + Vec2d(i / 16.0, j / 4.0) * (name.max - name.min)));
  return least;
}

/// The scene in some windows' panes, in both themes, at both scales.
template <class See>
void in_every_pane(const std::string& path, See see) {
  for (const Viewport& pane : {Viewport{858, 480}, Viewport{1360, 840}, Viewport{640, 300}})
    for (const Theme theme : {Theme::dark, Theme::projector})
      for (const Mode mode : {Mode::move, Mode::trace}) {
        State state = make_state(read_document(path));
        update(state, action::ResizePlan{pane});
        update(state, action::SetTheme{theme});
        update(state, action::SetUiScale{pane.width > 1000 ? 2.0 : 1.0});
        update(state, action::SetMode{mode});
        INFO(path << ", " << pane.width << " wide, theme " << static_cast<int>(theme) << ", mode "
                  << static_cast<int>(mode));
        see(state, plan_view(state));
      }
}

}  // namespace

TEST_CASE("every name of the plan stands out from what it stands on") {
  std::size_t seen = 0;
  for (const std::string& path : shipped_scenes())
    in_every_pane(path, [&](const State& state, const DisplayList& list) {
      for (const Name& name : names_of(list)) {
        const auto& letters = std::get<TextItem>(list[name.item].shape);
        for (const double part : {0.1, 0.5, 0.9}) {
          INFO(name.text);
          const Vec2d at = name.min + Vec2d(part, 0.5) * (name.max - name.min);
          Colour ground = painted(state, list, name.item, at);
          if (letters.halo) ground = mix(ground, letters.halo->with_alpha(255), letters.halo->a / 255.0);
          CHECK(contrast(letters.colour, ground) >= 4.5);
          ++seen;
        }
      }
    });
  CHECK(seen > 1000);
}

TEST_CASE("the name on a footprint can be read whatever the body's colour") {
  const std::vector<ObjectShape> shapes{Ellipsoid<double>{{1, 1, 1}}, Disk<double>{{0, 0, 0}, {0, 0, 1}, 1},
                                        Triangle<double>{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}},
                                        Sphere<double>{{0, 0, 5}, 1}, Sphere<double>{{0, 0, 0}, 1}};
  int seen = 0;
  for (const Theme theme : {Theme::dark, Theme::projector})
    for (const ObjectShape& shape : shapes)
      for (int colour = 0; colour < 27; ++colour) {
        Scene scene;
        Material material;
        material.diffuse = Rgbd(colour % 3, colour / 3 % 3, colour / 9) / 2.0;
        scene.objects.push_back({"X", shape, material});
        State state = state_of(scene);
        update(state, action::SetTheme{theme});
        const DisplayList list = plan_view(state);
        for (const Name& name : names_of(list)) {
          if (name.text != "X") continue;
          const Colour ground = painted(state, list, name.item, (name.min + name.max) / 2.0);
          INFO("shape " << shape.index() << ", colour " << colour);
          CHECK(contrast(std::get<TextItem>(list[name.item].shape).colour, ground) >= 4.5);
          ++seen;
        }
      }
  CHECK(seen == 2 * 27 * static_cast<int>(shapes.size()));
}

TEST_CASE("a name is nearer to its own body than to any other, or a line leads to it, and none covers another") {
  std::size_t beside = 0, led = 0;
  for (const std::string& path : shipped_scenes())
    in_every_pane(path, [&](const State& state, const DisplayList& list) {
      const std::vector<Name> names = names_of(list);
      for (std::size_t a = 0; a < names.size(); ++a)
        for (std::size_t b = a + 1; b < names.size(); ++b) {
          INFO(names[a].text << " and " << names[b].text);
          CHECK((names[a].min.x >= names[b].max.x || names[b].min.x >= names[a].max.x ||
                 names[a].min.y >= names[b].max.y || names[b].min.y >= names[a].max.y));
        }
      for (const Name& name : names) {
        const auto& objects = state.scene().objects;
        const auto object =
            std::find_if(objects.begin(), objects.end(), [&](const Object& o) { return o.name == name.text; });
        if (object == objects.end()) continue;
        const int index = static_cast<int>(object - objects.begin());
        const Target own{TargetKind::object, index};
        double to_own = 1e300, to_other = 1e300;
        for (const DisplayItem& item : list)
          if (item.target.kind == TargetKind::object && fill_of(item)) {
            double& least = item.target == own ? to_own : to_other;
            least = std::min(least, distance_between(item, name));
          }
        if (to_own == 1e300 || to_own <= to_other) {
          ++beside;
          continue;
        }
        // A line from the name that ends on the body.
        const auto body = items_of(list, own);
        const bool has_line = std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
          const auto* line = std::get_if<LineItem>(&item.shape);
          return line != nullptr && !item.target && distance_between(item, name) < 16 * Sizes(state).unit &&
                 std::any_of(
                     body.begin(), body.end(),
                     [&](const DisplayItem& part) { return fill_of(part) && distance_to(part, line->to) < 1e-6; });
        });
        INFO(name.text << ": " << to_own << " from its own body, " << to_other << " from another");
        CHECK(has_line);
        ++led;
      }
    });
  CHECK(beside > 100);
  CHECK(led > 0);
}

TEST_CASE("the arrow of the view does not cross the name of SCREEN") {
  int met = 0;
  for (const std::string& path : shipped_scenes())
    in_every_pane(path, [&](const State& state, const DisplayList& list) {
      if (state.walk.mode != Mode::move) return;
      for (const Name& name : names_of(list)) {
        if (name.text != "SCREEN") continue;
        for (const DisplayItem& item : list)
          if (const auto* line = std::get_if<LineItem>(&item.shape);
              line != nullptr && line->arrow > 0 && !item.target) {
            CHECK(distance_between(item, name) > 0);
            ++met;
          }
      }
    });
  CHECK(met > 100);
}
