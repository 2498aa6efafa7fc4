// The English texts about the accelerators that are stepped.

#include "view/structure_text.h"

namespace raywalk {

std::string_view english(StructureText id) {
  switch (id) {
    case StructureText::ray_primary:
      return "primary ray";
    case StructureText::ray_shadow:
      return "shadow ray";
    case StructureText::ray_reflect:
      return "reflect ray";
    case StructureText::ray_refract:
      return "refract ray";
    case StructureText::bvh:
      return "BVH";
    case StructureText::grid:
      return "Grid";
    case StructureText::octree:
      return "Octree";
    case StructureText::kdtree:
      return "kd-tree";
    case StructureText::none:
      return "None";
    case StructureText::search:
      return "Search";
    case StructureText::build:
      return "Build";
    case StructureText::search_hint:
      return "Follow this ray through the structure";
    case StructureText::build_hint:
      return "See how the structure was built";
    case StructureText::kind_hint:
      return "Search in this structure";
    case StructureText::slider_hint:
      return "How far the search or the build has come";
    case StructureText::title_search:
      return "Search of the {0}";
    case StructureText::title_build:
      return "How it is built: {0}";
    case StructureText::counter:
      return "{0} / {1}";
    case StructureText::no_ray:
      return "Take steps until a ray is formed. Its search is then shown here.";
    case StructureText::stub:
      return "No ray was formed here, so nothing is searched.";
    case StructureText::lost:
      return "This ray cannot be formed again, so its search is not shown.";
    case StructureText::too_large:
      return "{0} shapes are too many to be shown here: {1} at most.";
    case StructureText::not_begun:
      return "The search has not begun. Go on step by step.";
    case StructureText::shapes_none:
      return "nothing";
    case StructureText::shapes_one:
      return "1 shape";
    case StructureText::shapes_many:
      return "{0} shapes";
    case StructureText::entered_inner:
      return "Node entered: {0} boxes lie in it.";
    case StructureText::entered_leaf:
      return "Leaf entered: it lists {0}.";
    case StructureText::entered_cell:
      return "Cell entered: it lists {0}.";
    case StructureText::opened:
      return "Leaf opened: it lists {0}. Its box was met together with those beside it.";
    case StructureText::skip_missed:
      return "Skipped: the ray misses this box.";
    case StructureText::skip_behind:
      return "Skipped: this box lies behind the start of the ray.";
    case StructureText::skip_beyond:
      return "Skipped: the ray would get there at t = {0}, but has hit something at t = {1}.";
    case StructureText::skip_light:
      return "Skipped: this box lies behind the light.";
    case StructureText::skip_off_plan:
      return "Skipped: this box does not reach the plan, which the ray never leaves.";
    case StructureText::test_missed:
      return "{0} is tested: missed.";
    case StructureText::test_nearest:
      return "{0} is tested: hit at t = {1}, the nearest so far.";
    case StructureText::test_farther:
      return "{0} is tested: hit at t = {1}, behind the nearest.";
    case StructureText::test_blocks:
      return "{0} is tested: it stands before the light.";
    case StructureText::test_filters:
      return "{0} is tested: light goes through it, weakened.";
    case StructureText::test_outside:
      return "That is beyond this cell: something nearer may still come.";
    case StructureText::test_again:
      return "It was tested before: it reaches into this box too.";
    case StructureText::test_unbounded:
      return "No box can hold it, so every ray tests it.";
    case StructureText::passed:
      return "{0} was tested in an earlier cell: not again.";
    case StructureText::end_all:
      return "Nothing is left: the search is over.";
    case StructureText::end_blocked:
      return "One blocker is enough: the search is over.";
    case StructureText::end_beyond:
      return "The next cell begins behind the hit: the search is over.";
    case StructureText::end_light:
      return "The next cell begins behind the light: the search is over.";
    case StructureText::end_left:
      return "The ray leaves the grid: the search is over.";
    case StructureText::found:
      return "Found: {0} at t = {1}.";
    case StructureText::found_nothing:
      return "Nothing is met.";
    case StructureText::so_far:
      return "So far: nodes {0}, tests {1}";
    case StructureText::summary:
      return "{0}: {1} of {2} tests, {3} saved";
    case StructureText::summary_more:
      return "{0}: {1} tests in place of {2}, {3} more";
    case StructureText::summary_none:
      return "Without a structure: {0} tests";
    case StructureText::label_missed:
      return "missed";
    case StructureText::label_behind:
      return "behind";
    case StructureText::label_beyond:
      return "too far";
    case StructureText::label_off_plan:
      return "off the plan";
    case StructureText::label_light:
      return "behind the light";
    case StructureText::column_nodes:
      return "Nodes";
    case StructureText::column_tests:
      return "Tests";
    case StructureText::column_saved:
      return "Saved";
    case StructureText::column_listed:
      return "Listed";
    case StructureText::column_depth:
      return "Depth";
    case StructureText::build_begins:
      return "Nothing is built yet: there is one box around {0}. Go on step by step.";
    case StructureText::build_none:
      return "Nothing is built: every ray tests every shape.";
    case StructureText::build_empty:
      return "No shape of this scene has a box, so nothing can be built.";
    case StructureText::split:
      return "{0}: cut at {1} = {2}, {3} on one side, {4} on the other.";
    case StructureText::split_cost:
      return "A ray that comes here is expected to pay {0} tests with the cut, {1} without.";
    case StructureText::halved:
      return "{0}: no plane parts them, so the list is halved.";
    case StructureText::eight:
      return "{0}: the cube is cut into eight, of which {1} hold something.";
    case StructureText::leaf_single:
      return "Leaf: {0}.";
    case StructureText::leaf_few:
      return "Leaf of {0}: few enough.";
    case StructureText::leaf_dearer:
      return "Leaf of {0}: the best cut would cost {1} tests, the leaf costs {2}.";
    case StructureText::leaf_no_gain:
      return "Leaf of {0}: a cut would copy most of them into most parts.";
    case StructureText::leaf_deep:
      return "Leaf of {0}: the tree is as deep as it may be.";
    case StructureText::leaf_same:
      return "Leaf of {0}: no plane parts them.";
    case StructureText::joined:
      return "{0} boxes become one node: a ray is held against all of them at once.";
    case StructureText::cells:
      return "The room of {0} is cut into {1} x {2} x {3} cells, about four a shape.";
    case StructureText::listed:
      return "{0} is listed in {1} cells.";
    case StructureText::listed_once:
      return "{0} is listed in 1 cell.";
    case StructureText::note_unbounded:
      return "Shapes without end, in no structure: {0}.";
    case StructureText::note_above:
      return "The scene leaves the plan: boxes are drawn as seen from above.";
    case StructureText::note_many:
      return "Only the {0} upper boxes are drawn.";
    case StructureText::note_cut_short:
      return "Only the first {0} steps are kept.";
  }
  return {};
}

}  // namespace raywalk
