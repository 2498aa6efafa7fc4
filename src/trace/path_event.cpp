#include "trace/path_event.h"

namespace raywalk {

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
