#pragma once
// What is said about the accelerators that are stepped, by id: a family of view/text.h. {0} and so on stand for
// arguments.

#include <string_view>

namespace raywalk {

enum class StructureText {
  ray_primary,
  ray_shadow,
  ray_reflect,
  ray_refract,
  bvh,
  grid,
  octree,
  kdtree,
  none,    ///< no structure
  search,  ///< the page and its button
  build,
  search_hint,
  build_hint,
  kind_hint,
  slider_hint,
  title_search,  ///< {0} kind of ray
  title_build,   ///< {0} structure
  counter,       ///< {0} step, {1} all
  no_ray,
  stub,
  lost,
  too_large,  ///< {0} of the scene, {1} most
  not_begun,
  shapes_none,  ///< what a leaf lists
  shapes_one,
  shapes_many,
  entered_inner,  ///< {0} children
  entered_leaf,   ///< {0} shapes
  entered_cell,
  opened,
  skip_missed,
  skip_behind,
  skip_beyond,  ///< {0} entry, {1} hit
  skip_light,
  skip_off_plan,
  test_missed,  ///< {0} name
  test_nearest,
  test_farther,
  test_blocks,
  test_filters,
  test_outside,    ///< follows a test
  test_again,      ///< follows a test
  test_unbounded,  ///< follows a test
  passed,
  end_all,
  end_blocked,
  end_beyond,
  end_light,
  end_left,
  found,
  found_nothing,
  so_far,
  summary,  ///< {0} structure, {1} its tests, {2} brute force's, {3} fewer
  summary_more,
  summary_none,
  label_missed,  ///< beside a box that is skipped
  label_behind,
  label_beyond,
  label_off_plan,
  label_light,
  column_nodes,
  column_tests,
  column_saved,
  column_listed,  ///< shapes, each as often as it is listed
  column_depth,
  build_begins,  ///< {0} shapes
  build_none,
  build_empty,
  split,       ///< {0} shapes, {1} axis, {2} place, {3} and {4} counts
  split_cost,  ///< follows a split
  halved,
  eight,        ///< {0} shapes, {1} parts
  leaf_single,  ///< {0} shapes
  leaf_few,
  leaf_dearer,
  leaf_no_gain,
  leaf_deep,
  leaf_same,
  joined,  ///< {0} how many
  cells,   ///< {0} shapes
  listed,  ///< {0} name
  listed_once,
  note_unbounded,  ///< {0} how many
  note_above,
  note_many,
  note_cut_short,
};

[[nodiscard]] std::string_view english(StructureText id);
[[nodiscard]] std::string_view portuguese(StructureText id);

}  // namespace raywalk
