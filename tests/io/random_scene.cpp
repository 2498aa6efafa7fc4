#include "random_scene.h"

#include <cmath>
#include <string_view>

#include "io/scene_values.h"

namespace raywalk::test {

namespace {

Vec3d random_point(Random& random) {
  return {random.number(), random.number(), random.chance(0.5) ? 0.0 : random.number()};
}

Vec3d random_direction(Random& random) {
  return {random.unit() - 0.5, random.chance(0.3) ? 0.0 : random.unit(), random.unit() + 0.01};
}

Rgbd random_colour(Random& random) {
  if (random.chance(0.3)) return Rgbd(random.unit());
  if (random.chance(0.2)) return Rgbd(static_cast<double>(random.below(3)) / 2);
  return {random.unit(), random.unit(), random.unit()};
}

/// Corners around a circle at rising angles: their edges cannot cross.
std::vector<Vec2d> random_corners(Random& random) {
  const std::size_t count = 3 + random.below(9);
  const Vec2d centre{random.unit() * 10, random.unit() * 10};
  std::vector<Vec2d> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = (static_cast<double>(i) + 0.8 * random.unit()) * 6.28 / static_cast<double>(count);
    corners.push_back(centre + (1 + random.unit()) * Vec2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

template <class Solid>
Solid random_quadric(Random& random) {
  Solid quadric{Vec3d(random.positive(), random.positive(), random.positive())};
  if (random.chance(0.3)) quadric.radii = Vec3d(random.positive());
  if (random.chance(0.5)) quadric.z_min = -1 - random.unit();
  if (random.chance(0.5)) quadric.z_max = 1 + random.unit();
  quadric.capped = random.chance(0.5);
  return quadric;
}

Polygon<double> random_polygon(Random& random) {
  const double z = random.unit();
  const auto loop = [&] {
    std::vector<Vec3d> corners;
    for (const Vec2d& corner : random_corners(random)) corners.emplace_back(corner, z);
    return corners;
  };
  Polygon<double> polygon{loop(), {}};
  for (std::size_t i = random.below(3); i > 0; --i) polygon.holes.push_back(loop());
  return polygon;
}

std::vector<TransformStep> random_transform(Random& random) {
  std::vector<TransformStep> steps;
  for (std::size_t i = random.below(4); i > 0; --i) {
    switch (random.below(6)) {
      case 0:
        steps.push_back({Translate{random_point(random)}});
        break;
      case 1:
        steps.push_back({Rotate{random_direction(random), 360 * random.unit()}});
        break;
      case 2:
        steps.push_back({Scale{Vec3d(1 + random.unit(), 0.5, -1)}});
        break;
      case 3:
        steps.push_back({Mirror{random_direction(random)}});
        break;
      case 4:
        steps.push_back({Shear{random.unit(), 0, 0, random.unit() / 2, 0, 0}});
        break;
      default:
        steps.push_back({Matrix{{1, random.unit() / 2, 0, 3, 0, 2, 0, random.unit(), 0, 0, 1, -1}}});
    }
  }
  return steps;
}

Shape<double> random_shape(Random& random) {
  switch (random.below(13)) {
    case 3: {
      const Vec3d corner = random_point(random);
      return Box<double>{corner, corner + Vec3d(random.unit(), random.unit(), 1)};
    }
    case 4:
      return random_quadric<Ellipsoid<double>>(random);
    case 5:
      return random_quadric<EllipticParaboloid<double>>(random);
    case 6:
      return random_quadric<Cone<double>>(random);
    case 7:
      return random_quadric<Cylinder<double>>(random);
    case 8:
      return random_quadric<HyperboloidOneSheet<double>>(random);
    case 9:
      return random_quadric<HyperboloidTwoSheets<double>>(random);
    case 10:
      return Disk<double>{random_point(random), random_direction(random), random.positive()};
    case 11:
      return random_polygon(random);
    case 12:
      return Triangle<double>{{0, 0, random.unit()}, {1, random.unit(), 0}, {random.unit(), 2, 0.1}};
    case 0:
      return Sphere<double>{random_point(random), random.positive()};
    case 1:
      return Plane<double>{random_point(random), random_direction(random)};
    default:
      return Prism<double>{random_corners(random), random.chance(0.3) ? 1.0 : random.positive()};
  }
}

void random_view(Camera& camera, Random& random) {
  camera.fov.reset();
  camera.screen.width.reset();
  if (random.chance(0.5))
    camera.fov = FieldOfView{1 + 178 * random.unit(), random.chance(0.5) ? FovAxis::x : FovAxis::y};
  else
    camera.screen.width = random.positive();
}

std::string random_text(Random& random) {
  constexpr std::string_view pieces[] = {"ball", "\"quoted\"", "back\\slash", "é", "漢字", "#", "=", "[x]", "'", " "};
  std::string text = "t";
  for (std::size_t i = random.below(6); i > 0; --i) text += pieces[random.below(std::size(pieces))];
  return text;
}

RenderChoices random_choices(Random& random) {
  RenderChoices choices;
  choices.integrator = static_cast<Integrator>(random.below(values_of<Integrator>.size()));
  choices.sampler = static_cast<Sampler>(random.below(values_of<Sampler>.size()));
  if (random.chance(0.5)) choices.samples = 1 + static_cast<int>(random.below(64));
  if (random.chance(0.5)) choices.light_grid = 1 + static_cast<int>(random.below(8));
  if (random.chance(0.5)) choices.tolerance = random.unit();
  if (random.chance(0.5)) choices.path_length = 1 + static_cast<int>(random.below(20));
  if (random.chance(0.5)) choices.photons.count = 1 + static_cast<int>(random.below(1000));
  if (random.chance(0.5)) choices.photons.nearest = 2 + static_cast<int>(random.below(100));
  if (random.chance(0.5)) choices.photons.radius = 0.01 + random.unit();
  choices.photons.gather = random.chance(0.5);
  choices.photons.progressive = random.chance(0.5);
  if (random.chance(0.5)) choices.radiosity.patch = 0.01 + random.unit();
  if (random.chance(0.5)) choices.radiosity.tolerance = random.unit();
  if (random.chance(0.5)) choices.radiosity.shots = 1 + static_cast<int>(random.below(1000));
  if (random.chance(0.5)) choices.numerics = Numerics::naive;
  if (random.chance(0.5)) choices.epsilon = random.unit();
  choices.subsurface = static_cast<Subsurface>(random.below(values_of<Subsurface>.size()));
  choices.radiosity.as_ambient = random.chance(0.5);
  return choices;
}

}  // namespace

double Random::number() {
  switch (below(6)) {
    case 0:
      return static_cast<double>(below(21)) - 10;
    case 1:
      return (static_cast<double>(below(201)) - 100) / 10;
    case 2:
      return std::ldexp(unit() - 0.5, static_cast<int>(below(98)) - 49);
    case 3:
      return chance(0.5) ? 0.0 : -0.0;
    case 4:
      return chance(0.5) ? 5e-324 : -2.2250738585072011e-308;
    default:
      return 20 * unit() - 10;
  }
}

double Random::positive() {
  return chance(0.5) ? static_cast<double>(1 + below(40)) / 10
                     : std::ldexp(1 + unit(), static_cast<int>(below(98)) - 49);
}

Material random_material(Random& random) {
  Material material;
  const auto maybe = [&](Rgbd& colour) {
    if (random.chance(0.4)) colour = random_colour(random);
  };
  maybe(material.ambient);
  maybe(material.diffuse);
  maybe(material.specular);
  maybe(material.reflection);
  maybe(material.transmission);
  maybe(material.emission);
  if (random.chance(0.3)) material.shininess = 100 * random.unit();
  if (random.chance(0.3)) material.ior = 1 + random.unit();
  material.dielectric = random.chance(0.2);
  if (random.chance(0.2)) material.shadow = ShadowKind::filtered;
  if (random.chance(0.2)) material.gloss = 90 * random.unit();
  if (random.chance(0.2)) material.translucency = 90 * random.unit();
  if (random.chance(0.2)) maybe(material.absorption);
  if (random.chance(0.2)) material.texture = ImageTexture{random_text(random), random.positive(), random.positive()};
  if (material.texture && random.chance(0.5))
    material.texture->filter = random.chance(0.5) ? TextureFilter::trilinear : TextureFilter::ewa;
  const auto wrap = [&] { return values_of<ImageWrap>[random.below(values_of<ImageWrap>.size())]; };
  if (material.texture) material.texture->wrap = wrap();
  if (random.chance(0.2)) material.checker = Checker{random_colour(random), random_colour(random), random.positive()};
  if (material.checker && random.chance(0.5)) material.checker->filter = CheckerFilter::closed;
  if (random.chance(0.2)) material.priority = 6 * random.unit() - 3;
  const auto map_image = [&] {
    return MapImage{random_text(random), random.positive(), random.positive(), {}, wrap()};
  };
  const auto channel = [&] { return values_of<MapChannel>[random.below(3)]; };
  if (random.chance(0.2)) {
    const auto of = values_of<MappedParameter>[random.below(values_of<MappedParameter>.size())];
    material.maps.push_back({map_image(), of, channel()});
    if (random.chance(0.3) && of != MappedParameter::emission)
      material.maps.push_back({map_image(), MappedParameter::emission, channel()});
  }
  if (random.chance(0.1)) material.normal_map = NormalMap{map_image(), random.positive()};
  if (random.chance(0.1)) material.bump_map = BumpMap{map_image(), 2 * random.unit() - 1, channel()};
  if (random.chance(0.2)) {
    Mask& mask = material.mask.emplace(Mask{map_image(), {}, channel(), {}});
    if (random.chance(0.3)) mask.file.clear(), mask.squares = random.positive();
    maybe(mask.second.diffuse);
    maybe(mask.second.specular);
    if (random.chance(0.3)) mask.second.shininess = 100 * random.unit();
    if (random.chance(0.3)) mask.second.maps.push_back({map_image(), MappedParameter::diffuse, channel()});
  }
  // Filtered shadows go with neither.
  if (!material.maps.empty() || material.mask) material.shadow = ShadowKind::opaque;
  return material;
}

Object random_object(Random& random, const std::string& name) {
  Object object{name, random_shape(random), {}, {}};
  if (random.chance(0.4)) object.transform = random_transform(random);
  if (random.chance(0.8)) object.material = random_material(random);
  return object;
}

Sky random_sky(Random& random) {
  Sky sky;
  // Not black.
  const Rgbd some = random_colour(random) + Rgbd(0.25);
  switch (random.below(4)) {
    case 0:
      sky.kind = GradientSky{random_colour(random), some};
      break;
    case 1:
      sky.kind = OvercastSky{some};
      break;
    case 2:
      sky.kind = ClearSky{90 * random.unit(), 1 + 9 * random.unit(), random.unit(), some};
      break;
    default:
      sky.kind = ImageSky{"sky.hdr", some};
  }
  if (random.chance(0.3)) sky.up = random_direction(random);
  if (random.chance(0.3)) sky.rotation = 720 * random.unit() - 360;
  return sky;
}

Light random_light(Random& random, const std::string& name) {
  Light light{name, Rgbd(1.0), {}};
  if (random.chance(0.5)) light.strength = random_colour(random);
  const Attenuation attenuation =
      random.chance(0.5) ? Attenuation{} : Attenuation{random.unit(), 0, random.unit() + 0.1};
  const int samples = 1 + static_cast<int>(random.below(5));
  switch (random.below(6)) {
    case 0:
      light.kind = DirectionalLight{random_direction(random)};
      break;
    case 1: {
      const Vec3d position = random_point(random);
      const double angle = 180 * (1 - random.unit());
      light.kind = SpotLight{position, position + random_direction(random), angle, angle * random.unit(), attenuation};
      if (std::get<SpotLight>(light.kind).look_at == position) std::get<SpotLight>(light.kind).position = Vec3d(0.0);
      break;
    }
    case 2:
      light.kind =
          SphereLight{random_point(random), random.chance(0.2) ? 0.0 : random.positive(), samples, attenuation};
      break;
    case 3:
      light.kind =
          RectangleLight{random_point(random), random_point(random), random_point(random), samples, attenuation};
      break;
    default:
      light.kind = PointLight{random_point(random), attenuation};
  }
  return light;
}

Scene random_scene(Random& random) {
  Scene scene;
  if (random.chance(0.7)) scene.title = random_text(random);
  if (random.chance(0.4)) scene.description = random_text(random);
  scene.camera.eye = random_point(random);
  scene.camera.look_at = scene.camera.eye + Vec3d(1 + random.unit(), random.unit(), 0.1);
  if (!(length(scene.camera.look_at - scene.camera.eye) > 1e-3)) scene.camera.eye = Vec3d(0.0);
  if (random.chance(0.3)) scene.camera.up = {0.1 * random.unit(), -0.0, 1 + random.unit()};
  if (random.chance(0.5)) scene.camera.screen.distance = random.positive();
  if (random.chance(0.3)) scene.camera.screen.cells = 1 + static_cast<int>(random.below(500));
  random_view(scene.camera, random);
  if (random.chance(0.3))
    scene.image = {1 + static_cast<int>(random.below(999)), 1 + static_cast<int>(random.below(999))};
  if (random.chance(0.3)) scene.limits = {1 + static_cast<int>(random.below(20)), random.unit()};
  if (random.chance(0.3)) scene.camera.aperture = random.positive();
  if (random.chance(0.3)) scene.camera.focus = random.positive();
  if (random.chance(0.3)) scene.camera.shutter_close = 1 + (scene.camera.shutter_open = random.unit());
  if (random.chance(0.3)) scene.render = random_choices(random);
  if (random.chance(0.3)) scene.background = random_colour(random);
  if (random.chance(0.3)) scene.ambient = random_colour(random);
  if (random.chance(0.4)) scene.sky = random_sky(random);
  for (std::size_t i = random.below(4); i > 0; --i)
    scene.lights.push_back(random_light(random, "light " + std::to_string(i) + random_text(random)));
  for (std::size_t i = random.below(6); i > 0; --i)
    scene.objects.push_back(random_object(random, "object " + std::to_string(i) + random_text(random)));
  return scene;
}

void change_something(Scene& scene, Random& random) {
  Object* object = scene.objects.empty() ? nullptr : &scene.objects[random.below(scene.objects.size())];
  Light* light = scene.lights.empty() ? nullptr : &scene.lights[random.below(scene.lights.size())];
  switch (random.below(12)) {
    case 0:
      return random_view(scene.camera, random);
    case 1:
      scene.background = random_colour(random);
      return;
    case 2:
      scene.limits.depth = 1 + static_cast<int>(random.below(9));
      return;
    case 3:
      scene.camera.screen.distance = random.positive();
      return;
    case 4:
      scene.title = random_text(random);
      return;
    case 5:
      if (light != nullptr) light->strength = random_colour(random);
      return;
    case 6:
      if (light != nullptr) light->kind = random_light(random, "").kind;
      return;
    case 7:
      if (object != nullptr) object->shape = random_shape(random);
      return;
    case 8:
      if (object != nullptr) object->material = random_material(random);
      return;
    case 9:
      if (object != nullptr) object->material.diffuse = random_colour(random);
      return;
    default:
      break;
  }
  if (object == nullptr) return;
  if (auto* sphere = std::get_if<Sphere<double>>(&object->shape)) {
    sphere->centre = random_point(random);
  } else if (auto* plane = std::get_if<Plane<double>>(&object->shape)) {
    plane->point = random_point(random);
  } else if (auto* prism = std::get_if<Prism<double>>(&object->shape)) {
    auto& corners = prism->corners;
    const auto at = corners.begin() + static_cast<std::ptrdiff_t>(random.below(corners.size()));
    if (random.chance(0.5) && corners.size() > 3)
      corners.erase(at);
    else
      corners.insert(at, *at);
    const auto changed = std::find(corners.begin(), corners.end(), corners.front());
    *changed += Vec2d(1e-9, 1e-9);
    if (!why_not_polygon(corners).empty()) corners = random_corners(random);
  }
}

bool same_bits(const Scene& a, const Scene& b) { return detail::values_of(a) == detail::values_of(b) && a == b; }

}  // namespace raywalk::test
