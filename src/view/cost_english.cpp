#include "view/cost.h"

namespace raywalk {

std::string_view english(CostText id) {
  switch (id) {
    case CostText::empty:
      return "Set the knobs and press Try: the same picture is traced that way, its cost is counted, and its distance "
             "from the right picture is measured. The ladder tries 1, 4, 16 and 64 samples.";
    case CostText::under_way:
      return "tracing: {0}";
    case CostText::attempt:
      return "{0}: error {4}{5}; {1} rays, {2} tests, {3} s";
    case CostText::awaits_reference:
      return "?";
    case CostText::times_floor:
      return " ({0} times the reference's own)";
    case CostText::reference:
      return "reference: {0} samples a pixel, its own error about {1}";
    case CostText::no_reference:
      return "the reference is on its way";
    case CostText::samples:
      return "{0} samples";
    case CostText::sample:
      return "1 sample";
    case CostText::light_grid:
      return "{0} x {0} per light";
    case CostText::depth:
      return "depth {0}";
    case CostText::threshold:
      return "threshold {0}";
    case CostText::no_threshold:
      return "no threshold";
    case CostText::single:
      return "float";
    case CostText::double_:
      return "double";
    case CostText::tolerance:
      return "tolerance {0}";
    case CostText::no_tolerance:
      return "not adaptive";
    case CostText::naive:
      return "naive, epsilon {0}";
    case CostText::robust:
      return "robust";
    case CostText::error_axis:
      return "error (RMS)";
    case CostText::seconds_axis:
      return "seconds of one thread";
    case CostText::rays_axis:
      return "rays";
    case CostText::tests_axis:
      return "tests of boxes, cells and surfaces";
    case CostText::floor:
      return "the reference's own error";
    case CostText::key_rays:
      return "of the rays";
    case CostText::key_time:
      return "of the time";
    case CostText::difference:
      return "A to {0}, largest difference {1}";
    case CostText::effects_title:
      return "What each effect adds to this scene: the picture with it, less the picture without it";
    case CostText::no_effects:
      return "This scene calls for no effect that could be left out.";
    case CostText::of_rays:
      return "{0} of the rays";
    case CostText::of_time:
      return "{0} of the time ({1} to {2})";
    case CostText::all_rays:
      return "all shadow rays";
    case CostText::whole:
      return "All together: {0} rays in {1} s. Every effect, called for or not: {2} times the rays, {3} times the "
             "time.";
    case CostText::surveying:
      return "measuring: {0}";
  }
  return "";
}

}  // namespace raywalk
