#include "view/microscope.h"

namespace raywalk {

std::string_view english(ScopeText id) {
  switch (id) {
    case ScopeText::empty:
      return "Walk to a hit, with STEP or a click on a cell: here it is seen down to the last digit of its numbers.";
    case ScopeText::title:
      return "{0} meets {1}";
    case ScopeText::robust:
      return "robust";
    case ScopeText::naive:
      return "naive";
    case ScopeText::naive_start:
      return "naive starts here";
    case ScopeText::error_box:
      return "error box";
    case ScopeText::crossing:
      return "true crossing";
    case ScopeText::row_hit:
      return "meets";
    case ScopeText::row_t:
      return "t";
    case ScopeText::row_t_error:
      return "t off by";
    case ScopeText::row_point:
      return "point is";
    case ScopeText::row_start:
      return "rays start";
    case ScopeText::nothing:
      return "nothing";
    case ScopeText::none:
      return "\u2013";
    case ScopeText::ulp:
      return "{0} ulp";
    case ScopeText::outside:
      return "{0} ulp outside";
    case ScopeText::inside:
      return "{0} ulp inside";
    case ScopeText::on_surface:
      return "on the surface";
    case ScopeText::at_point:
      return "at the point";
    case ScopeText::leaves:
      return "leaves";
    case ScopeText::hits_own:
      return "hits itself";
    case ScopeText::goes_astray:
      return "goes astray";
    case ScopeText::some_hit_own:
      return "{0} of {1} hit itself";
    case ScopeText::some_astray:
      return "{0} of {1} go astray";
    case ScopeText::off_sight:
      return "{0}: {1} ulp away";
    case ScopeText::one_cell:
      return "1 cell = 1 ulp = {0}";
    case ScopeText::two_cells:
      return "1 ulp = {1} in {0}, {3} in {2}";
    case ScopeText::bar:
      return "{0} = {1} ulp";
    case ScopeText::says_missed:
      return "Naive numerics miss this surface. The ray truly meets it.";
    case ScopeText::says_invented:
      return "Naive numerics find a hit here. The ray truly misses.";
    case ScopeText::says_acne:
      return "Naive: the {1} starts {0} and meets the very surface that it leaves. Speckles, called acne, come of "
             "that.";
    case ScopeText::says_wrong_side:
      return "Naive: rays start {0}, on the wrong side of the surface.";
    case ScopeText::says_astray:
      return "Naive: rays start {0}, and one meets something else than what is truly there.";
    case ScopeText::says_apart:
      return "The two points are {0} ulp apart. Naive rays start {1}, robust ones at their point.";
    case ScopeText::says_alike:
      return "Both find the same hit. Naive rays start {0}: here that does no harm. Robust ones need no such distance.";
    case ScopeText::says_alike_at_surface:
      return "Both find the same hit, and no ray goes wrong here.";
  }
  return "";
}

}  // namespace raywalk
