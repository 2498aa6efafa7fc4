#include "trace/event.h"

namespace raywalk {

std::string_view ray_kind_name(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "primary";
    case RayKind::shadow:
      return "shadow";
    case RayKind::reflect:
      return "reflect";
    case RayKind::refract:
      return "refract";
  }
  return "";
}

std::string_view ending_name(Ending ending) {
  switch (ending) {
    case Ending::hit:
      return "hit";
    case Ending::missed:
      return "missed";
    case Ending::blocked:
      return "blocked";
    case Ending::reached_light:
      return "reached_light";
    case Ending::depth:
      return "depth";
    case Ending::threshold:
      return "threshold";
    case Ending::total_internal_reflection:
      return "total_internal_reflection";
    case Ending::path_length:
      return "path_length";
    case Ending::facing_away:
      return "facing_away";
    case Ending::outside_cone:
      return "outside_cone";
  }
  return "";
}

std::string_view lobe_name(Lobe lobe) {
  switch (lobe) {
    case Lobe::diffuse:
      return "diffuse";
    case Lobe::highlight:
      return "highlight";
    case Lobe::mirror:
      return "mirror";
    case Lobe::transparent:
      return "transparent";
  }
  return "";
}

}  // namespace raywalk
