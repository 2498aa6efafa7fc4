#include "trace/world.h"

#include "scene/copied_meshes.h"
#include "trace/lobe_width.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace raywalk {

namespace {

template <class T>
typename World<T>::Surface surface_of(const Material& m, Integrator integrator, const EffectSwitches& on,
                                      std::vector<typename World<T>::Scattering>& scatterings) {
  const bool fixed = m.normal == ShadingNormal::fixed && !traits_of(integrator).is_global;  // trace/path.h
  const Rgbd extinction = m.absorption + m.scattering;
  const bool absorbs = m.transmits() && !is_black(extinction);
  typename World<T>::Surface surface{{Rgb<T>(extinction), static_cast<T>(m.ior), absorbs},
                                     {Rgb<T>(m.ambient), Rgb<T>(m.diffuse), Rgb<T>(m.specular), Rgb<T>(m.reflection),
                                      Rgb<T>(m.transmission), Rgb<T>(m.emission), static_cast<T>(m.shininess)},
                                     m.dielectric,
                                     m.transmits(),
                                     m.shadow == ShadowKind::filtered && m.transmits(),
                                     fixed,
                                     fixed && !is_black(m.specular),
                                     {},
                                     {}};
  if (m.texture && m.texture->pixels)
    surface.texture = {m.texture->pixels,
                       static_cast<T>(m.texture->width),
                       static_cast<T>(m.texture->height),
                       {m.texture->wrap, m.texture->wrap}};
  surface.priority = m.priority;
  if (integrator == Integrator::path && m.scatters_inside()) {
    constexpr T most = 1 - std::numeric_limits<T>::epsilon();
    surface.scattering = static_cast<std::int32_t>(scatterings.size());
    scatterings.push_back({Rgb<T>(m.scattering), std::clamp(static_cast<T>(m.anisotropy), -most, most)});
    const Rgbd all = m.dielectric ? m.reflection + m.transmission : m.transmission;
    surface.seamless = m.ior == 1 && all == Rgbd(1.0) && (m.dielectric || !m.reflects()) && is_black(m.diffuse) &&
                       is_black(m.specular) && !m.emits() && m.translucency == 0 && !m.is_mapped();
    // Where nothing is bent, lights are seen from inside.
    if (surface.seamless)
      surface.filters_shadows = true, surface.transmission = Rgb<T>(1), surface.reflection = Rgb<T>(0);
  }
  surface.filter = surface.transmission;
  if (has_extents(integrator)) {
    surface.gloss = lobe_width<T>(m.gloss);
    surface.translucency = lobe_width<T>(m.translucency);
  }
  const bool follows = traits_of(integrator).is_recursive;
  if (!follows || !on.reflection) surface.reflection = Rgb<T>(0);
  if (!follows || !on.refraction) {
    surface.transmission = Rgb<T>(0);
    surface.transmits = false;
  }
  if (!on.reflection || !on.refraction) surface.dielectric = false;
  if (m.checker) surface.checker = {Rgb<T>(m.checker->even), Rgb<T>(m.checker->odd), static_cast<T>(m.checker->size)};
  return surface;
}

/// With the maps of a material. Makes the surface, which is the first of a mask's materials, the most of both.
template <class T>
SurfaceMaps<T> maps_of(const Material& material, Integrator integrator, const EffectSwitches& on,
                       typename World<T>::Surface& surface) {
  const SurfaceValues<T> first = surface;
  SurfaceValues<T> second = first;
  if (material.mask) {
    std::vector<typename World<T>::Scattering> none;
    const auto its = surface_of<T>(second_of(material), integrator, on, none);
    second = its;
    const auto most = [](Rgb<T>& one, const Rgb<T>& other) {
      one = {std::max(one.x, other.x), std::max(one.y, other.y), std::max(one.z, other.z)};
    };
    most(surface.ambient, second.ambient), most(surface.diffuse, second.diffuse);
    most(surface.specular, second.specular), most(surface.reflection, second.reflection);
    most(surface.emission, second.emission);
    surface.lit_from_behind = surface.lit_from_behind || its.lit_from_behind;
  }
  return {material, first, second, has_extents(integrator), bends_normals(integrator)};
}

template <class T>
PreparedLight<T> prepared(const AnyLight& light) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> PreparedLight<T> { return typename Kind::template Prepared<T>(kind); },
      light);
}

template <class T>
typename World<T>::Light traced_light(int index, const Scene& scene, bool draws) {
  const Light& given = scene.lights[static_cast<std::size_t>(index)];
  const std::optional<Vec3d> middle = middle_of(given);
  const Attenuation attenuation = attenuation_of(given);
  const int grid = light_grid_of(scene, given);
  PreparedLight<T> kind = prepared<T>(given.kind);
  return {.index = index,
          .strength = Rgb<T>(given.strength),
          .is_distant = !middle,
          // Without random numbers, an area light with one sample is a point light at its centre.
          .is_delta = !is_area(given) || (!draws && grid == 1),
          .is_isotropic = std::visit([](const auto& its) { return its.isotropic; }, kind),
          .place = Vec3<T>(middle ? *middle : -normalize(*axis_of(given))),
          .constant = static_cast<T>(attenuation.constant),
          .linear = static_cast<T>(attenuation.linear),
          .quadratic = static_cast<T>(attenuation.quadratic),
          .reach = static_cast<T>(reach_of(given)),
          .kind = kind,
          .grid = grid,
          .sample_weight = T(1) / static_cast<T>(grid * grid)};
}

/// Flattens a scene's objects, with all instances expanded.
template <class T>
class Flattener {
 public:
  Flattener(const Scene& scene, World<T>& world, const BuildOptions& build)
      : world_(world),
        stop_(build.stop),
        copied_(scene),
        shares_(copied_.share(build.share_copies_from)),
        integrator_(integrator_of(scene)),
        switches_(scene.render.switches),
        shutter_open_(scene.camera.shutter_open),
        shutter_close_(scene.camera.shutter_close) {
    primitives_.set_shutter(scene.camera.shutter_open, scene.camera.shutter_close);
    for (const Kind kind : {Kind::shapes, Kind::meshes, Kind::copies}) {
      adds_ = kind;
      for (top_ = 0; top_ < static_cast<int>(scene.objects.size()); ++top_)
        add(scene.objects[static_cast<std::size_t>(top_)], Affine<double>{}, {}, false);
    }
    const bool any_copied = primitives_.size() > primitives_.own_size();
    if (any_copied) world_.first_copied = primitives_.own_size();
    // The most common case: each object is one shape.
    bool each_its_own = !any_copied && primitives_.size() == static_cast<int>(scene.objects.size());
    for (int id = 0; each_its_own && id < primitives_.size(); ++id)
      each_its_own = world_.object(id) == id && world_.surface_indices[static_cast<std::size_t>(id)] == id;
    if (each_its_own) world_.objects.clear(), world_.surface_indices.clear(), world_.ranges.clear();
  }

  [[nodiscard]] Primitives<T> take() { return std::move(primitives_); }

 private:
  /// In this order their ids follow each other.
  enum class Kind { shapes, meshes, copies };

  void add(const Object& object, const Affine<double>& outer, const Motion& outer_motion, bool moves) {
    stop_.check();
    moves = moves || !object.motion.empty();
    Affine<double> map = outer * affine_of(object.transform);
    Motion motion = moved_within(object.motion, outer, outer_motion);
    if (!motion.empty() && !moves_between(motion, shutter_open_, shutter_close_)) {
      map.move += offset_at(motion, shutter_open_);
      motion.clear();
    }
    const int first = primitives_.size();
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      if (!instance->content) return;
      ++nesting_;
      for (const Object& inner : instance->content->group.objects) add(inner, map, motion, moves);
      --nesting_;
    } else if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) {
      if (!mesh->mesh || adds_ == Kind::shapes) return;
      const bool copied = copied_.has(object, moves) && inverse(map);
      if (copied != (adds_ == Kind::copies)) return;
      begin_leaf(object, true);
      copied&& shares_ ? add_copy(object, *mesh, map) : add(object, *mesh, map);
    } else if (adds_ == Kind::shapes) {
      begin_leaf(object, false);
      std::visit([&](const auto& shape) { add_shape(shape, map); }, object.shape);
      note(1, surface_index(&object.material));
    }
    if (!std::holds_alternative<Instance>(object.shape)) primitives_.move(first, primitives_.size(), motion);
  }

  template <class S>
  void add_shape(const S& shape, const Affine<double>& map) {
    if constexpr (std::is_constructible_v<Shape<double>, const S&>) {
      // Readers and editors refuse singular maps; an object under one would be flat and is left untransformed.
      const auto place = map == Affine<double>{} ? std::nullopt : object_transform<T>(map);
      place ? primitives_.add(shape_cast<T>(Shape<double>(shape)), *place)
            : primitives_.add(shape_cast<T>(Shape<double>(shape)));
    }
  }

  void add(const Object& object, const MeshShape& shape, const Affine<double>& map) {
    const Mesh& mesh = *shape.mesh;
    primitives_.add(mesh, map, shape.smooth);
    const int own = surface_index(&object.material);
    if (!has_own_materials(shape)) return note(mesh.triangles.size(), own);
    for (const std::int32_t material : mesh.materials) note(1, surface_of_triangle(shape, material, own));
  }

  void add_copy(const Object& object, const MeshShape& shape, const Affine<double>& map) {
    primitives_.add_copy(shape.mesh, map, shape.smooth);
    const int own = surface_index(&object.material);
    typename World<T>::PrimitiveRange& range = world_.ranges.back();
    range.object = top_;
    if (!has_own_materials(shape)) {
      range.surface = own;
      return;
    }
    std::vector<std::int32_t>& surfaces = world_.copied_surfaces;
    const auto [entry, is_new] = surfaces_from_.try_emplace(&object, surfaces.size());
    if (is_new)
      for (const std::int32_t material : shape.mesh->materials)
        surfaces.push_back(surface_of_triangle(shape, material, own));
    range.surfaces = entry->second;
  }

  static bool has_own_materials(const MeshShape& shape) {
    return shape.file_materials && shape.materials && !shape.mesh->materials.empty();
  }
  int surface_of_triangle(const MeshShape& shape, std::int32_t material, int own) {
    return material < 0 ? own : surface_index(&(*shape.materials)[static_cast<std::size_t>(material)]);
  }

  void begin_leaf(const Object& object, bool mesh) {
    std::int32_t name = -1;
    if (nesting_ > 0) {
      const auto [entry, is_new] = name_of_.emplace(&object, static_cast<int>(world_.range_names.size()));
      if (is_new) world_.range_names.push_back(object.name);
      name = entry->second;
    }
    world_.ranges.push_back({primitives_.size(), name, mesh});
  }

  /// Instances of a group share the surfaces of its objects.
  int surface_index(const Material* material) {
    const auto [entry, is_new] = surface_of_.emplace(material, static_cast<int>(world_.surfaces.size()));
    if (is_new) {
      world_.surfaces.push_back(surface_of<T>(*material, integrator_, switches_, world_.scatterings));
      if (world_.effects.used(Effect::filtering)) world_.pattern_filters.push_back(filter_of(*material));
      if (world_.effects.used(Effect::microfacets)) world_.microsurfaces.emplace_back(*material);
      if (world_.effects.used(Effect::maps))
        world_.surface_maps.push_back(maps_of<T>(*material, integrator_, switches_, world_.surfaces.back()));
    }
    return entry->second;
  }
  PatternFilter filter_of(const Material& material) {
    PatternFilter filter;
    if (material.checker) filter.checker = material.checker->filter;
    if (!material.filters_texture() || !material.texture->pixels) return filter;
    filter.texture = material.texture->filter;
    const std::shared_ptr<const Image>& pixels = material.texture->pixels;
    std::shared_ptr<const TexturePyramid>& pyramid = pyramids_[pixels.get()];
    if (!pyramid) pyramid = std::make_shared<const TexturePyramid>(pixels);
    filter.pyramid = pyramid;
    return filter;
  }
  void note(std::size_t count, int surface) {
    world_.objects.insert(world_.objects.end(), count, top_);
    world_.surface_indices.insert(world_.surface_indices.end(), count, surface);
  }

  World<T>& world_;
  Stop stop_;
  CopiedMeshes copied_;
  bool shares_;  ///< copies share their triangles
  Integrator integrator_;
  EffectSwitches switches_;
  double shutter_open_, shutter_close_;
  Primitives<T> primitives_;
  std::unordered_map<const Material*, int> surface_of_;
  std::unordered_map<const Object*, int> name_of_;
  std::unordered_map<const Object*, std::size_t> surfaces_from_;                      ///< in World::copied_surfaces
  std::unordered_map<const Image*, std::shared_ptr<const TexturePyramid>> pyramids_;  ///< one of each image
  int nesting_ = 0;  ///< depth of instances around the current object
  Kind adds_ = Kind::shapes;
  int top_ = 0;
};

/// Light leaves all that scatters by the dipole: nothing is seen through it any more.
template <class T>
void prepare_dipoles(World<T>& world) {
  for (auto& its : world.surfaces) {  // in the order of their scatterings
    if (!its.scatters()) continue;
    const auto& how = world.scatterings[static_cast<std::size_t>(its.scattering)];
    Rgb<T> absorption = its.extinction - how.coefficient;
    for (int channel = 0; channel < 3; ++channel) absorption[channel] = std::max(absorption[channel], T(0));
    world.dipoles.emplace_back(absorption, how.coefficient, how.anisotropy, its.ior, its.dielectric);
    if (its.seamless) its.seamless = its.filters_shadows = false;
  }
}

/// What rough surfaces need to know of the whole world: glass, between its index and those of what may touch it: air,
/// and where bodies nest, the others.
template <class T>
void prepare_rough_surfaces(World<T>& world) {
  for (const Microsurface<T>& each : world.microsurfaces)
    world.has_rough_diffuse = world.has_rough_diffuse || each.matt.has_value();
  for (std::size_t i = 0; i < world.microsurfaces.size(); ++i) {
    const auto& its = world.surfaces[i];
    const SurfaceMaps<T>* maps = world.maps(its);
    const T alpha = world.microsurfaces[i].glass;
    if ((!(alpha > 0) && maps == nullptr) || !its.transmits || !its.dielectric) continue;
    std::vector<T> others{T(1)};
    for (const auto& other : world.surfaces)
      if (its.nests && other.transmits) others.push_back(other.ior);
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    if (maps != nullptr) {
      world.surface_maps[i].prepare_glass(its.ior, others);
      continue;
    }
    world.rough_dielectrics.resize(world.surfaces.size());
    for (const T other : others)
      if (RoughDielectric<T>::bends(its.ior, other))
        world.rough_dielectrics[i].push_back(rough_dielectric_of(alpha, its.ior, other));
  }
}

}  // namespace

template <class T>
World<T>::World(const Scene& scene, AcceleratorKind kind, std::optional<Fault> its_fault, const BuildOptions& build)
    : background(scene.background),
      ambient(scene.ambient),
      sky(scene.sky ? std::make_shared<const SkyLight>(*scene.sky, scene.background) : nullptr),
      depth(scene.limits.depth),
      threshold(static_cast<T>(scene.limits.threshold)),
      effects(effects_of(scene)),
      draws(draws_random(integrator_of(scene))),
      accelerator(Flattener<T>(scene, *this, build).take(), kind, build),
      fault(its_fault),
      numerics(fault ? Numerics::naive : scene.render.numerics),
      occludes(scene.render.switches.shadows),
      epsilon(static_cast<T>(scene.render.epsilon)) {
  absorbs = std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& each) { return each.absorbs; });
  if (absorbs)
    for (int id = 0; id < accelerator.primitives().own_size(); ++id) {
      Surface& its = surfaces[static_cast<std::size_t>(&surface(id) - surfaces.data())];
      its.endless = its.endless || (its.absorbs && !accelerator.primitives().box(id).bounded());
    }
  bodies = bodies_that_nest(*this, scene.camera);
  for (Surface& each : surfaces) each.nests = !bodies.empty();
  if (scene.render.subsurface == Subsurface::dipole && bodies.empty()) prepare_dipoles(*this);
  for (int id = 0; id < accelerator.primitives().own_size(); ++id) {
    if (!surface(id).filters_shadows) {
      shadow_roles.push_back(ShadowRole::stops);
      continue;
    }
    const int same = accelerator.primitives().first_equal(id);
    // Of two that filter in the same place, only the first counts.
    shadow_roles.push_back(same == id || !surface(same).filters_shadows ? ShadowRole::filters : ShadowRole::ignored);
  }
  const auto stops = [](ShadowRole role) { return role == ShadowRole::stops; };
  if (std::all_of(shadow_roles.begin(), shadow_roles.end(), stops)) shadow_roles.clear();
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (!is_black(scene.lights[i].strength)) lights.push_back(traced_light<T>(static_cast<int>(i), scene, draws));
  for (std::uint32_t dimension = 0; Light & light : lights) {
    light.first_dimension = dimension;
    dimension += 2 * static_cast<std::uint32_t>(light.samples());
  }
  prepare_rough_surfaces(*this);
}

template <class T>
auto World<T>::range_of(int primitive) const -> const PrimitiveRange* {
  const auto after = std::upper_bound(ranges.begin(), ranges.end(), primitive,
                                      [](int id, const PrimitiveRange& range) { return id < range.first; });
  return after == ranges.begin() ? nullptr : &*(after - 1);
}

template <class T>
auto World<T>::copied_surface(int primitive) const -> const Surface& {
  const PrimitiveRange& range = *range_of(primitive);
  const auto triangle = static_cast<std::size_t>(primitive - range.first);
  const std::int32_t at = range.surface < 0 ? copied_surfaces[range.surfaces + triangle] : range.surface;
  return surfaces[static_cast<std::size_t>(at)];
}

template <class T>
typename World<T>::Piece World<T>::piece(int primitive) const {
  const PrimitiveRange* range = range_of(primitive);
  if (range == nullptr) return {};
  return {range->mesh ? primitive - range->first : -1,
          range->name < 0 ? std::string() : range_names[static_cast<std::size_t>(range->name)]};
}

template struct World<float>;
template struct World<double>;

}  // namespace raywalk
