#include "io/pov_parts.h"
#include "scene/metals.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace raywalk::detail {

namespace {

/// The part of a material that has one colour: the members are weights of it.
struct ColouredPart {
  Rgbd colour;  ///< its largest channel is 1
  double ambient = 0, diffuse = 0, emission = 0;
  bool patterned = false;  ///< the material's checker multiplies it
};

double mean(const Rgbd& colour) { return (colour.x + colour.y + colour.z) / 3; }
bool is_grey(const Rgbd& colour) { return colour.x == colour.y && colour.y == colour.z; }

/// The parts of `material`, grouped by colour.
std::vector<ColouredPart> parts_of(const Material& material) {
  std::vector<ColouredPart> parts;
  const auto add = [&](const Rgbd& colour, double ColouredPart::* weight, bool patterned) {
    if (is_black(colour)) return;
    const double size = max_component(colour);
    const Rgbd unit = colour / size;
    const auto same = std::find_if(parts.begin(), parts.end(), [&](const ColouredPart& part) {
      return length(part.colour - unit) < 1e-12 && part.patterned == patterned;
    });
    ColouredPart& part =
        same == parts.end() ? parts.emplace_back(ColouredPart{.colour = unit, .patterned = patterned}) : *same;
    part.*weight = size;
  };
  const bool patterned = material.checker.has_value();
  add(material.diffuse, &ColouredPart::diffuse, patterned);
  add(material.ambient, &ColouredPart::ambient, patterned);
  add(material.emission, &ColouredPart::emission, false);
  if (parts.empty()) parts.push_back({.colour = Rgbd(1.0)});
  return parts;
}

/// The contents of "pigment { }". `transmits` is appended to each colour: " transmit 0.5".
std::string pigment(const ColouredPart& part, const Material& material, const std::optional<FlatFrame>& frame,
                    const std::string& transmits, PovLosses& losses) {
  if (!part.patterned) return pov_colour(part.colour) + transmits;
  const Checker& checker = *material.checker;
  std::string text = "checker " + pov_colour(part.colour * checker.even) + transmits + " " +
                     pov_colour(part.colour * checker.odd) + transmits;
  if (!frame) {
    losses.insert("patterns on curved surfaces and solids, which become cubes in space");
    return text + fmt::format(" scale {}", checker.size);
  }
  // POV-Ray's checker fills space with cubes. The surface is placed in the middle of a layer of them, whose first cube
  // has the colour `even`.
  const Vec3d u = checker.size * frame->u, v = checker.size * frame->v, n = checker.size * frame->normal;
  const Vec3d origin = frame->origin - 0.5 * n;
  return text + fmt::format(" matrix <{0}, {2}, {1},  {3}, {5}, {4},  {6}, {8}, {7},  {9}, {11}, {10}>", u.x, u.y, u.z,
                            n.x, n.y, n.z, v.x, v.y, v.z, origin.x, origin.y, origin.z);
}

std::string finish(const ColouredPart& part, double share) {
  const auto weight = [&](const char* word, double value) {
    return value == 0 && word[0] == 'e' ? std::string() : fmt::format(" {} {}", word, value == 0 ? 0 : value / share);
  };
  return weight("ambient", part.ambient) + weight("diffuse", part.diffuse) + weight("emission", part.emission);
}

/// Only for the uppermost layer: highlight and mirror.
std::string gloss(const Material& material, PovLosses& losses) {
  std::string text;
  if (!is_black(material.specular)) {
    if (!is_grey(material.specular)) losses.insert("the colour of highlights, which become grey");
    text += fmt::format(" specular {} roughness {}", mean(material.specular), 1 / std::max(material.shininess, 1e-6));
  }
  if (material.transmits() && material.dielectric) {
    const Rgbd both = material.reflection + material.transmission;
    text += fmt::format(" reflection {{ rgb 0, {} fresnel on }} conserve_energy", pov_colour(both));
  } else if (material.reflects()) {
    const Rgbd metal = material.is_metal() ? reflectance_at_right_angles(material.mirror) : Rgbd(1.0);
    text += fmt::format(" reflection {{ {} }}", pov_colour(material.reflection * metal));
  }
  return text;
}

/// Of what is inside; scattered light is lost.
Rgbd extinction(const Material& material) { return material.absorption + material.scattering; }

}  // namespace

std::string pov_texture(const Material& material, const std::optional<FlatFrame>& frame, PovLosses& losses) {
  if (material.gloss > 0 || material.translucency > 0)
    losses.insert("gloss and translucency: mirrors and glass become sharp");
  if (material.is_rough_mirror()) losses.insert("rough mirrors, which become sharp and lose their highlights");
  if (material.is_rough_glass()) losses.insert("rough glass, which becomes clear");
  if (material.is_rough_diffuse()) losses.insert("the roughness of matt surfaces, which become Lambert's");
  if (material.is_metal()) losses.insert("how metals reflect more at flat angles: they reflect as at right angles");
  if (material.normal == ShadingNormal::fixed) losses.insert("fixed normals: surfaces are lit from both sides");
  if (material.texture) losses.insert("image textures");
  if (!material.maps.empty()) losses.insert("maps of parameters, which are as strong everywhere as without them");
  if (material.has_bent_normals()) losses.insert("normal and bump maps: surfaces become smooth");
  if (material.mask) losses.insert("masks: the second material is left out");
  if (material.filters_checker())
    losses.insert("filters of checkers, which are seen by points: more samples, such as +A0.1, do what can be done");
  if (material.transmits() && material.priority != 0)
    losses.insert("priorities: where transparent bodies overlap, the one entered last counts");
  const Rgbd through =
      material.dielectric && material.transmits() ? material.reflection + material.transmission : material.transmission;
  const bool transmits = material.transmits();
  constexpr double rounding = 1e-9;
  const Rgbd kept = material.reflection + material.transmission;
  if (transmits && std::min({kept.x, kept.y, kept.z}) < 1 - rounding)
    losses.insert("light lost in total internal reflection and by dielectrics: it is reflected in full");
  if (material.scatters_inside()) losses.insert("light that is scattered inside of an object, which is absorbed");
  if (transmits && !is_black(extinction(material)) && (material.reflects() || material.dielectric))
    losses.insert("absorption along rays that are reflected inside of an object");
  std::vector<ColouredPart> parts = parts_of(material);
  // Layers from top to bottom. Each covers a fraction of what is below it, so that all contribute equally; together
  // they let the transmission through, whose colour the lowest layer gives.
  const double passed = transmits ? std::min(max_component(through), 1.0) : 0;
  const bool bare = parts.size() == 1 && parts[0].ambient + parts[0].diffuse + parts[0].emission == 0;
  if (transmits && passed == 1 && !bare)
    losses.insert("diffuse, ambient and emitted light of materials that transmit all light");
  if (transmits && (bare || passed == 1)) {
    const Rgbd tint = through / max_component(through);
    return fmt::format("texture {{ pigment {{ {} filter {} }} finish {{ ambient 0 diffuse 0{} }} }}\n",
                       pov_colour(tint), passed, gloss(material, losses));
  }
  const bool tinted = transmits && !is_grey(through);
  const double covered = 1 - passed, layers = static_cast<double>(parts.size());
  std::vector<std::string> texts;
  double left = 1;  // transmittance of the layers so far
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    const double share = covered / layers;  // of the total
    const double transmit = last && !transmits ? 0 : (left - share) / left;
    const std::string transmitted = transmit > 0 ? fmt::format(" transmit {}", transmit) : "";
    texts.push_back(fmt::format("texture {{ pigment {{ {} }} finish {{{}{} }} }}\n",
                                pigment(parts[i], material, frame, transmitted, losses), finish(parts[i], share),
                                i == 0 ? gloss(material, losses) : ""));
    left *= transmit;
  }
  // The layers transmit grey; a final layer that covers nothing colours it.
  if (tinted)
    texts.push_back(fmt::format("texture {{ pigment {{ {} filter 1 }} finish {{ ambient 0 diffuse 0 }} }}\n",
                                pov_colour(through / max_component(through))));
  // POV-Ray writes the lowest layer first.
  std::string text;
  for (auto layer = texts.rbegin(); layer != texts.rend(); ++layer) text += *layer;
  return text;
}

std::string pov_interior(const Material& material) {
  if (!material.transmits()) return {};
  std::string text = fmt::format("interior {{ ior {}", material.ior);
  if (!is_black(extinction(material))) {
    // POV-Ray computes exp(-a d) for a fade_power above 1000: exp(-(1 - colour) d / distance).
    const double most = max_component(extinction(material));
    text += fmt::format(" fade_power 1001 fade_distance {} fade_color {}", 1 / most,
                        pov_colour(Rgbd(1.0) - extinction(material) / most));
  }
  return text + " }";
}

}  // namespace raywalk::detail
