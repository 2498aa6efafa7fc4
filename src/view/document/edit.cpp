#include "io/textures.h"
#include "scene/schema.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace raywalk {

namespace {

Material material_of(action::ObjectKind kind) {
  Material material;
  material.ambient = Rgbd(0.01);
  material.specular = Rgbd(0.1);
  switch (kind) {
    case action::ObjectKind::solid_sphere:
      material.ambient = Rgbd(0.05, 0.03, 0.01);
      material.diffuse = Rgbd(0.55, 0.30, 0.06);
      material.reflection = Rgbd(0.15);
      return material;
    case action::ObjectKind::transparent_sphere:
      material.diffuse = Rgbd(0.03);
      material.reflection = Rgbd(0.1);
      material.transmission = Rgbd(0.75);
      material.shadow = ShadowKind::filtered;
      return material;
    case action::ObjectKind::polygon:
      material.diffuse = Rgbd(0.12, 0.35, 0.25);
      material.reflection = Rgbd(0.3);
      return material;
    case action::ObjectKind::light:
      return material;
  }
  return material;
}

/// Bounding circles of the bodies of the plan, which a new object avoids.
struct Disc {
  Vec2d centre;
  double radius;
};

std::vector<Disc> occupied(const State& state) {
  const Scene& scene = state.scene();
  std::vector<Disc> discs{{plan(scene.camera.eye), 0}};
  for (const Light& light : scene.lights)
    discs.push_back({light_place(state.scene(), light, state.plan.camera, state.plan.viewport), 0});
  for (const Object& object : scene.objects) {
    if (!object.transform.empty()) continue;
    if (const auto* sphere = std::get_if<Sphere<double>>(&object.shape))
      discs.push_back({plan(sphere->centre), plan_radius(*sphere)});
    if (const auto* prism = std::get_if<Prism<double>>(&object.shape)) {
      Disc disc{centroid(*prism), 0};
      for (const Vec2d& corner : prism->corners) disc.radius = std::max(disc.radius, length(corner - disc.centre));
      discs.push_back(disc);
    }
  }
  return discs;
}

/// A place near the middle of the view where a disc of this radius overlaps nothing; the middle if there is none.
Vec2d free_place(const State& state, double radius) {
  const std::vector<Disc> discs = occupied(state);
  const double reach =
      0.5 * std::min(state.plan.viewport.width, state.plan.viewport.height) / state.plan.camera.pixels_per_unit;
  for (int i = 0; i < 200; ++i) {
    // A sunflower spiral covers the view evenly from the middle outwards.
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec2d place =
        state.plan.camera.centre + std::sqrt(i / 200.0) * reach * Vec2d(std::cos(angle), std::sin(angle));
    const bool is_free = std::none_of(discs.begin(), discs.end(), [&](const Disc& disc) {
      return length(disc.centre - place) < 1.15 * (disc.radius + radius);
    });
    if (is_free) return place;
  }
  return state.plan.camera.centre;
}

Vec2d to_grid(const Vec2d& place, double grid) {
  return {std::round(place.x / grid) * grid, std::round(place.y / grid) * grid};
}

/// An irregular quadrilateral, so that its turning can be seen.
Prism<double> new_polygon(const Vec2d& centre, double size) {
  Prism<double> prism;
  for (const Vec2d& corner : {Vec2d(-1, -0.7), Vec2d(0.8, -0.8), Vec2d(1, 0.5), Vec2d(-0.5, 0.9)})
    prism.corners.push_back(centre + size * corner);
  prism.height = 2 * size;
  return prism;
}

std::string_view name_of(action::ObjectKind kind) {
  switch (kind) {
    case action::ObjectKind::solid_sphere:
      return "name.Solid Sphere";
    case action::ObjectKind::transparent_sphere:
      return "name.Transparent Sphere";
    case action::ObjectKind::polygon:
      return "name.Polygon";
    case action::ObjectKind::light:
      return "name.Light Source";
  }
  return "name.Solid Sphere";
}

Prism<double>* prism_of(Scene& scene, int object) {
  if (object < 0 || object >= static_cast<int>(scene.objects.size())) return nullptr;
  Object& found = scene.objects[static_cast<std::size_t>(object)];
  return found.transform.empty() ? std::get_if<Prism<double>>(&found.shape) : nullptr;
}

}  // namespace

void action::AddObject::apply(State& state) const {
  const double seen =
      std::min(state.plan.viewport.width, state.plan.viewport.height) / state.plan.camera.pixels_per_unit;
  const double grid = grid_step(state.plan.camera);
  const double size = std::max(std::round(0.09 * seen / grid), 1.0) * grid;
  const Vec2d place = to_grid(free_place(state, kind == ObjectKind::light ? size / 2 : size), grid);

  Scene next = state.scene();
  const Language language = state.appearance.language;
  const std::string name = unique_name(next, std::string(text(name_of(kind), language.others().english())), language);
  next.translated.push_back(name);
  Target added;
  if (kind == ObjectKind::light) {
    added = {TargetKind::light, static_cast<int>(next.lights.size())};
    next.lights.push_back({name, Rgbd(0.6), PointLight{Vec3d(place, 0), {}}});
  } else {
    added = {TargetKind::object, static_cast<int>(next.objects.size())};
    Shape<double> shape = Sphere<double>{Vec3d(place, 0), size};
    if (kind == ObjectKind::polygon) shape = new_polygon(place, size);
    next.objects.push_back({name, shape, material_of(kind)});
  }
  const bool is_light = added.kind == TargetKind::light;
  if (!commit_if_valid(state, std::move(next), is_light ? -1 : added.index, is_light ? added.index : -1)) return;
  state.walk.mode = Mode::move;
  state.walk.playing = false;
  state.plan.selected = added;
}

void action::RemoveSelected::apply(State& state) const {
  const Target target = state.plan.selected;
  if (!exists(state, target)) return;
  Scene next = state.scene();
  switch (target.kind) {
    case TargetKind::corner:
      return RemoveCorner{target.index, target.part}.apply(state);
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::edge:
    case TargetKind::rotation:
      next.objects.erase(next.objects.begin() + target.index);
      break;
    case TargetKind::light:
    case TargetKind::light_radius:
      next.lights.erase(next.lights.begin() + target.index);
      break;
    case TargetKind::nothing:
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
    case TargetKind::cell:
    case TargetKind::ray:
      return inform(state, std::string(text("notice.select_first", state.appearance.language)));
  }
  state.plan.selected = {};
  state.plan.hovered = {};  // something else is now under the pointer
  commit(state, std::move(next));
}

void action::InsertCorner::apply(State& state) const {
  Scene next = state.scene();
  Prism<double>* prism = prism_of(next, object);
  if (prism == nullptr || edge < 0 || edge >= prism->sides()) return;
  // On the edge itself, so that the shape is unchanged; not too near its ends.
  const Vec2d first = prism->corner(edge), along = prism->corner_after(edge) - first;
  const double t = dot(at - first, along) / dot(along, along);
  const Vec2d corner = first + std::clamp(std::isfinite(t) ? t : 0.5, 0.05, 0.95) * along;
  prism->corners.insert(prism->corners.begin() + edge + 1, corner);
  if (commit_if_valid(state, std::move(next), object, -1)) state.plan.selected = {TargetKind::corner, object, edge + 1};
}

void action::RemoveCorner::apply(State& state) const {
  Scene next = state.scene();
  Prism<double>* prism = prism_of(next, object);
  if (prism == nullptr || corner < 0 || corner >= prism->sides()) return;
  if (prism->sides() <= 3)
    return complain(state, std::string(text("notice.refused_last_corners", state.appearance.language)));
  prism->corners.erase(prism->corners.begin() + corner);
  if (commit_if_valid(state, std::move(next), object, -1)) state.plan.selected = {TargetKind::object, object};
}

void action::Rename::apply(State& state) const {
  if (!exists(state, target)) return;
  const bool is_object = target.kind == TargetKind::object;
  if (!is_object && target.kind != TargetKind::light) return;
  Scene next = state.scene();
  const auto index = static_cast<std::size_t>(target.index);
  std::string& current = is_object ? next.objects[index].name : next.lights[index].name;
  if (name == current) return;
  const auto refuse = [&](std::string_view why, const TextArguments& arguments = {}) {
    complain(state, fill(why, state.appearance.language, arguments));
  };
  if (name.find_first_not_of(" \t") == std::string::npos) return refuse("notice.refused_name_empty");
  if (name.size() > schema::own_name.longest)
    return refuse("notice.refused_name_long", {{"bytes", name.size()}, {"most", schema::own_name.longest}});
  // What some fields make of characters that they cannot hold.
  constexpr std::string_view replacement = "\uFFFD";
  if (name.find(replacement) != std::string::npos && current.find(replacement) == std::string::npos)
    return refuse("notice.refused_name_letters");
  const std::string before = std::exchange(current, {});  // its own name is no other's
  if (is_taken(next, name, name, state.appearance.language))
    return refuse("notice.refused_name_taken", {{"name", name}});
  std::erase(next.translated, before);  // what a person calls a thing is called so in every language
  std::erase(next.translated, name);
  current = name;
  commit_if_valid(state, std::move(next), is_object ? target.index : -1, is_object ? -1 : target.index);
}

namespace {

/// Commits `next` as this edit, unless its object or light is invalid.
template <class Edit>
void commit_edit(State& state, const Edit& edit, Scene next, int object = -1, int light = -1) {
  commit_if_valid(state, std::move(next), object, light, {Action(edit).kind(), std::max(object, light)},
                  edit.continues);
}

}  // namespace

void action::SetMaterial::apply(State& state) const {
  if (!exists(state, {TargetKind::object, object})) return;
  Scene next = state.scene();
  Object& changed = next.objects[static_cast<std::size_t>(object)];
  bool loads =
      material.texture && (!changed.material.texture || changed.material.texture->file != material.texture->file);
  each_map(material, [&](const MapImage& map, bool /*colour*/) { loads |= !map.file.empty() && !map.pixels; });
  if (loads) {
    Scene alone;
    alone.objects = {{changed.name, Sphere<double>{{0, 0, 0}, 1}, material}};
    const std::string& path = state.document.contents.path;
    if (const auto loaded = load_textures(alone, path.substr(0, path.find_last_of('/') + 1)); !loaded)
      return complain(state, loaded.error().text());
    changed.material = alone.objects.front().material;
  } else {
    changed.material = material;
  }
  commit_edit(state, *this, std::move(next), object);
}

void action::SetShape::apply(State& state) const {
  if (!exists(state, {TargetKind::object, object})) return;
  Scene next = state.scene();
  next.objects[static_cast<std::size_t>(object)].shape = shape;
  commit_edit(state, *this, std::move(next), object);
}

void action::SetLight::apply(State& state) const {
  if (!exists(state, {TargetKind::light, light})) return;
  Scene next = state.scene();
  Light& changed = next.lights[static_cast<std::size_t>(light)];
  const std::string name = changed.name;  // a name changes through Rename, which keeps it unique
  changed = value;
  changed.name = name;
  commit_edit(state, *this, std::move(next), -1, light);
}

void action::SetCamera::apply(State& state) const {
  Scene next = state.scene();
  next.camera = camera;
  commit_edit(state, *this, std::move(next));
}

void action::SetLimits::apply(State& state) const {
  Scene next = state.scene();
  next.limits = limits;
  commit_edit(state, *this, std::move(next));
}

void action::SetNumerics::apply(State& state) const {
  Scene next = state.scene();
  next.render.numerics = numerics;
  next.render.epsilon = epsilon;
  commit_edit(state, *this, std::move(next));
}

void action::SetLightWays::apply(State& state) const {
  Scene next = state.scene();
  next.render.subsurface = subsurface;
  next.render.radiosity.as_ambient = as_ambient;
  commit_edit(state, *this, std::move(next));
}

void action::SetSurroundings::apply(State& state) const {
  Scene next = state.scene();
  next.background = background;
  next.ambient = ambient;
  next.sky = sky;
  commit_edit(state, *this, std::move(next));
}

}  // namespace raywalk
