// What the numbers of a scene mean, for the tooltips of their fields and for Help.

#include "view/text.h"

#include <array>

namespace raywalk {

std::span<const Explanation> english_explanations() {
  static constexpr std::array table{
      Explanation{
          TextId::ambient,
          "ka: the share of the scene's ambient light that the surface gives off, lit or not. It stands for all "
          "the light that no ray follows."},
      Explanation{
          TextId::diffuse,
          "kd: the share of a light that a matt surface scatters evenly, times the cosine between the surface's "
          "normal and the light. It is the body's own colour."},
      Explanation{
          TextId::specular,
          "ks: how bright the highlight is, the blurred mirror image of a light: ks times (n.h) to the power of "
          "the shininess, where h lies half way between the light and the eye."},
      Explanation{TextId::shininess, "s: the exponent of the highlight. 10 is broad and dull, 100 small and polished."},
      Explanation{
          TextId::reflection,
          "kr: the share that is mirrored. Above 0, SHADE forms a reflect ray and adds kr times what it brings."},
      Explanation{
          TextId::transmission,
          "kt: the share that goes through. Above 0, SHADE forms a refract ray and adds kt times what it brings."},
      Explanation{TextId::ior,
                  "How much slower light is inside, which bends it at the surface (Snell's law): air 1, water 1.33, "
                  "glass 1.5, diamond 2.4. It matters where kt is above 0."},
      Explanation{TextId::dielectric,
                  "Like real glass: how much of kr + kt is mirrored and how much goes through follows from the angle "
                  "(Fresnel's equations), more being mirrored the flatter light meets the surface. Off: kr and kt are "
                  "taken as they are."},
      Explanation{TextId::priority,
                  "Which of two transparent bodies is there where they overlap: the one with the higher number, and of "
                  "equal ones the one that light entered last."},
      Explanation{TextId::filtered_shadow,
                  "A shadow ray goes on through this body and brings kt of the light at each surface it crosses. Off: "
                  "the body blocks light, even if it is of glass."},
      Explanation{TextId::emission, "Light that the surface gives off by itself, lit or not."},
      Explanation{TextId::checker, "Squares in two colours, which multiply ka and kd."},
      Explanation{TextId::strength, "L: the light's colour and how much of it there is; 1 is white in full."},
      Explanation{
          TextId::attenuation,
          "How the light weakens with the distance r: it is divided by c + l r + q r\u00b2. 1, 0, 0 is the same "
          "everywhere; 0, 0, 1 is as in nature."},
      Explanation{TextId::background, "The colour that a ray brings which leaves the scene."},
      Explanation{TextId::ambient_light, "Light from everywhere; ka says how much of it a surface gives off."},
      Explanation{TextId::depth_limit,
                  "\"depth\" in the scene's file: the deepest SHADE there may be. The primary ray's has DEPTH 1; a ray "
                  "that would call a deeper one is not formed."},
      Explanation{TextId::threshold,
                  "\"threshold\" in the scene's file: a ray that could bring less than this share of its pixel is not "
                  "formed. 0.01 is one part in a hundred."},
  };
  return table;
}

}  // namespace raywalk
