#include "io/pov_writer.h"

#include "io/pov_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace raywalk {

namespace {

using detail::FlatFrame;
using detail::pov_colour;
using detail::pov_number;
using detail::pov_vector;
using detail::PovLosses;

/// Far from everything; POV-Ray finds no hits beyond 1e7.
constexpr double far_away = 1e5;

std::string head(const Scene& scene) {
  std::string title = scene.title.empty() ? "A scene of Raywalk" : scene.title;
  std::replace_if(title.begin(), title.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return fmt::format(
      "// {}\n"
      "// Written by raywalk convert. To render it as Raywalk does, at {} sample{} a pixel and in one thread:\n"
      "//   povray +W{} +H{} {} +WT1 -D +ISCENE.pov\n"
      "#version 3.7;\n"
      "global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout {} ambient_light {} }}\n"
      "background {{ color {} }}\n",
      title, scene.render.samples, scene.render.samples == 1 ? "" : "s", scene.image.width, scene.image.height,
      scene.render.samples == 1 ? "-A" : fmt::format("+A0.0 +AM1 +R{}", std::lround(std::sqrt(scene.render.samples))),
      std::min(scene.limits.depth, 256), scene.limits.threshold, pov_colour(scene.ambient),
      pov_colour(scene.background));
}

std::string camera_text(const Scene& scene) {
  const Camera& camera = scene.camera;
  const Vec3d forward = normalize(camera.look_at - camera.eye), right = normalize(cross(forward, camera.up));
  const Vec3d width = 2 * camera.half_extent() * right, height = 2 * camera.half_extent() * cross(right, forward);
  // The angle is that of one side of the picture; the other side follows from its pixels.
  const bool by_height = camera.extent_axis() == FovAxis::y;
  std::string text = fmt::format("camera {{ perspective\n  location {}\n  direction {}\n  right {}{}\n  up {}{}\n",
                                 pov_vector(camera.eye), pov_vector(forward), pov_vector(width),
                                 by_height ? " * image_width / image_height" : "", pov_vector(height),
                                 by_height ? "" : " * image_height / image_width");
  if (camera.aperture > 0)
    text += fmt::format("  aperture {} focal_point {} blur_samples {} confidence 0 variance 0\n", 2 * camera.aperture,
                        pov_vector(camera.eye + camera.focus_distance() * forward), std::max(scene.render.samples, 4));
  return text + "}\n";
}

/// The light's colour and attenuation, as far as POV-Ray supports it: 2 / (1 + (d / fade_distance)^fade_power).
std::string fading(const Light& light, const Attenuation& a, double typical_distance, PovLosses& losses) {
  Attenuation used = a;
  if (a.linear > 0 && a.quadratic > 0) {
    losses.insert("attenuation with a linear and a quadratic term: taken as at the distance of what is looked at");
    used.quadratic += a.linear / typical_distance;
    used.linear = 0;
  }
  const bool linear = used.linear > 0;
  const double fade = linear ? used.linear : used.quadratic;
  if (fade == 0) return "color " + pov_colour(light.strength / used.constant);
  // Without a constant term, one too small to be visible is used.
  const double least = linear ? 1e-4 * fade * typical_distance : 1e-8 * fade * typical_distance * typical_distance;
  const double constant = std::max(used.constant, least);
  const double distance = linear ? constant / fade : std::sqrt(constant / fade);
  return fmt::format("color {} fade_distance {} fade_power {}", pov_colour(light.strength / (2 * constant)), distance,
                     linear ? 1 : 2);
}

/// POV-Ray spreads n samples from edge to edge; ours lie in the middles of n cells.
std::string area(const Vec3d& u, const Vec3d& v, int samples, bool jittered) {
  const double inner = (samples - 1.0) / samples;
  return fmt::format(" area_light {}, {}, {}, {} area_illumination on{}", pov_vector(inner * u), pov_vector(inner * v),
                     samples, samples, jittered ? " jitter" : "");
}

class LightText {
 public:
  LightText(const Scene& scene, const Light& light, PovLosses& losses)
      : scene_(scene), light_(light), losses_(losses) {}

  std::string operator()(const PointLight& at) const {
    return pov_vector(at.position) + " " + faded(at.position, at.attenuation);
  }
  std::string operator()(const DirectionalLight& sun) const {
    const Vec3d away = far_away * normalize(sun.direction);
    return pov_vector(away) + " color " + pov_colour(light_.strength) + " parallel point_at <0, 0, 0>";
  }
  std::string operator()(const SpotLight& spot) const {
    return pov_vector(spot.position) + " " + faded(spot.position, spot.attenuation) +
           fmt::format(" spotlight point_at {} radius {} falloff {} tightness 0", pov_vector(spot.look_at),
                       spot.inner_angle / 2, spot.angle / 2);
  }
  std::string operator()(const SphereLight& sphere) const {
    const std::string text = pov_vector(sphere.position) + " " + faded(sphere.position, sphere.attenuation);
    const int samples = scene_.render.light_grid.value_or(sphere.samples);
    if (sphere.radius == 0 || samples == 1) return text;
    losses_.insert("sphere lights, which become disks that face what they light");
    return text + area({2 * sphere.radius, 0, 0}, {0, 0, 2 * sphere.radius}, samples, jittered()) + " circular orient";
  }
  /// A kind that POV-Ray lacks.
  template <LightKind Other>
  std::string operator()(const Other& other) const {
    losses_.insert(std::string(Other::name) + " lights, which become points");
    return (*this)(PointLight{other.middle().value_or(Vec3d(0.0)), attenuation_of(light_)});
  }
  std::string operator()(const RectangleLight& rectangle) const {
    const Vec3d middle = rectangle.corner + 0.5 * (rectangle.u + rectangle.v);
    const std::string text = pov_vector(middle) + " " + faded(middle, rectangle.attenuation);
    const int samples = scene_.render.light_grid.value_or(rectangle.samples);
    if (samples == 1) return text;
    return text + area(rectangle.u, rectangle.v, samples, jittered());
  }

 private:
  [[nodiscard]] std::string faded(const Vec3d& from, const Attenuation& attenuation) const {
    const double distance = length(scene_.camera.look_at - from);
    return fading(light_, attenuation, distance > 0 ? distance : 1, losses_);
  }
  [[nodiscard]] bool jittered() const { return scene_.render.integrator != Integrator::whitted; }

  const Scene& scene_;
  const Light& light_;
  PovLosses& losses_;
};

std::string comment(std::string name) {
  std::replace_if(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return "// " + name + "\n";
}

/// The texture's name; prepends its declaration to `text` if it is new.
class Textures {
 public:
  std::string use(const std::string& texture, std::string& text) {
    const auto [entry, is_new] = numbers_.emplace(texture, static_cast<int>(numbers_.size()) + 1);
    if (is_new) text += fmt::format("#declare Texture_{} =\n{}", entry->second, texture);
    return fmt::format("texture {{ Texture_{} }}", entry->second);
  }

 private:
  std::map<std::string, int> numbers_;
};

class ObjectText {
 public:
  ObjectText(const Scene& scene, PovLosses& losses) : scene_(scene), losses_(losses) {}

  /// Groups first: each is declared before what uses it.
  std::string operator()() {
    std::string text;
    for (const Group& group : scene_.groups) {
      groups_.emplace(group.name, static_cast<int>(groups_.size()) + 1);
      std::string members, declared;
      for (const Object& object : group.objects) members += object_text(object, declared);
      text += comment(group.name) + declared +
              fmt::format("#declare Group_{} = union {{\n{}}}\n", groups_.at(group.name), members);
    }
    for (const Object& object : scene_.objects) {
      std::string declared;
      const std::string object_lines = object_text(object, declared);
      text += declared + object_lines;
    }
    return text;
  }

 private:
  std::string object_text(const Object& object, std::string& declared) {
    std::string place = detail::pov_matrix(object.transform);
    if (!is_at_rest(object.motion)) losses_.insert("motion: everything stands where it is when the shutter opens");
    const Vec3d offset = offset_at(object.motion, scene_.camera.shutter_open);
    if (offset != Vec3d(0.0)) place += "  translate " + pov_vector(offset) + "\n";
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      const auto group = groups_.find(instance->group);
      if (group == groups_.end()) return {};
      return comment(object.name) + fmt::format("object {{ Group_{}\n{}}}\n", group->second, place);
    }
    const Material& material = object.material;
    const auto plain = detail::plain_shape(object.shape);
    const auto texture_of = [&](const Material& of) {
      const auto frame = of.checker && plain ? detail::flat_frame(*plain) : std::nullopt;
      return textures_.use(detail::pov_texture(of, frame, losses_), declared);
    };
    std::string shape;
    if (plain) {
      shape = detail::pov_shape(*plain, losses_);
    } else if (const auto* mesh = std::get_if<MeshShape>(&object.shape); mesh && mesh->mesh) {
      shape = detail::pov_mesh(*mesh, texture_of);
    } else {
      return {};
    }
    // In POV-Ray everything that transmits lets shadow rays pass. If it should not, an invisible copy blocks them
    // instead.
    const bool stops = material.transmits() && material.shadow == ShadowKind::opaque;
    const std::string texture = texture_of(material);
    std::string text = comment(object.name) + shape + "\n  " + texture + " " + detail::pov_interior(material) +
                       (stops ? " no_shadow" : "") + "\n" + place + "}\n";
    if (stops) text += shape + "\n  pigment { rgb 0 } no_image no_reflection\n" + place + "}\n";
    return text;
  }

  const Scene& scene_;
  PovLosses& losses_;
  Textures textures_;
  std::map<std::string, int> groups_;
};

}  // namespace

PovText format_pov(const Scene& scene) {
  PovText pov;
  PovLosses losses;
  pov.text = camera_text(scene);
  for (const Light& light : scene.lights) {
    if (is_black(light.strength)) continue;
    pov.text +=
        comment(light.name) + "light_source { " + std::visit(LightText(scene, light, losses), light.kind) + " }\n";
  }
  pov.text += ObjectText(scene, losses)();
  if (scene.sky) losses.insert("the sky: only the background below it");
  if (scene.encoding == Encoding::truncated) losses.insert("8-bit pictures without the sRGB curve");
  if (traits_of(scene.render.integrator).is_global)
    losses.insert("light from everywhere (path tracing, photons, radiosity)");
  pov.left_out.assign(losses.begin(), losses.end());
  std::string said;
  for (const std::string& loss : losses) said += "// POV-Ray renders without: " + loss + "\n";
  pov.text = said + head(scene) + pov.text;
  return pov;
}

}  // namespace raywalk
