# The mutants, for run.sh: mutant NAME WHO FILE OLD NEW [FLAGS]. Each OLD is one place of the product's source.
# shellcheck shell=bash

# --- The compiler's liberties -----------------------------------------------------------------------------------------
mutant contraction_on arithmetic '' '' '' '-O2 -ffp-contract=fast -mfma'  # g++ contracts from -O2 on
mutant reassociation_on arithmetic '' '' '' '-ffast-math'

# --- Exact arithmetic -------------------------------------------------------------------------------------------------
mutant two_sum_forgets_its_error arithmetic math/double_double.h '(a - a_part) + (b - b_part)' '(a - a_part)'
mutant two_product_forgets_low_bits arithmetic math/double_double.h '+ a_lo * b_hi) + a_lo * b_lo' '+ a_lo * b_hi)'
mutant expansion_drops_a_term arithmetic math/expansion.h \
  'if (sum.lo != 0) shorter.terms_.push_back(sum.lo);' ''
mutant expansion_signed_by_its_least arithmetic math/expansion.h 'terms_.back() > 0 ? 1 : -1' 'terms_[0] > 0 ? 1 : -1'
mutant dot_without_bound arithmetic math/exact.h '{x + y + z, 4 * detail::half_ulp' '{x + y + z, 0 * detail::half_ulp'
mutant difference_without_bound Plane math/exact.h '{x + y + z, 5 * detail::half_ulp' '{x + y + z, 0 * detail::half_ulp'

# --- Sphere -----------------------------------------------------------------------------------------------------------
mutant sphere_second_root_dropped Sphere shape/sphere.h 'if (!(t > 0)) t = static_cast<T>(far);' ''
mutant sphere_tangent_missed Sphere shape/sphere.h 'if (discriminant.hi < 0) return' 'if (discriminant.hi <= 0) return'
mutant sphere_sign_without_bound Sphere shape/sphere.h 'sign_bound = 32 *' 'sign_bound = 0 *'
mutant sphere_digits_without_bound Sphere shape/sphere.h 'digits_bound = 1e-8;' 'digits_bound = 0;'
mutant sphere_exact_tier_dropped Sphere shape/sphere.h 'constexpr double cancelled = 1e-13;' 'constexpr double cancelled = -1;'
mutant sphere_zero_is_a_crossing Sphere shape/sphere.h 'if (!(t > 0 && t < t_max))' 'if (!(t >= 0 && t < t_max))'
mutant sphere_discriminant_cancels Sphere shape/sphere.h 'discriminant = a * r2 - dot(oxd, oxd),' \
  'discriminant = b * b - a * c,'
mutant sphere_passes_without_bound Sphere shape/sphere.h '(c - detail::sphere_sign_bound * size)' \
  '(c + detail::sphere_sign_bound * size)'
mutant sphere_far_root_first Sphere shape/sphere.h 'return c > 0 ? nearest(c / q, q / a) :' 'return c > 0 ? nearest(q / a, c / q) :'
mutant sphere_leaves_the_wrong_way Sphere shape/sphere.h 'root = -2 * b / a;' 'root = 2 * b / a;'
mutant sphere_behind_is_before Sphere shape/sphere.h 'b > 0 && c > detail::sphere_digits_bound * size' \
  'b < 0 && c > detail::sphere_digits_bound * size'
mutant sphere_departure_forgotten Sphere shape/sphere.h 'if (departed_part != no_part) {' 'if (false) {'

# --- Plane, disk, polygon ---------------------------------------------------------------------------------------------
mutant plane_level_behind_is_before Plane shape/plane.h '(above > 0) != (climb > 0)' '(above > 0) == (climb > 0)'
mutant plane_behind_is_before Plane shape/intersection.h 'if (!(t > 0 && t < t_max))' 'if (!(t < t_max))'
mutant disk_rim_excluded Disk shape/disk.h '(square - reach * reach).sign() <= 0' '(square - reach * reach).sign() < 0'
mutant disk_rim_without_bound Disk shape/disk.h 'std::abs(square - radius * radius) > doubt' \
  'std::abs(square - radius * radius) >= 0'
mutant polygon_half_open_turned Polygon shape/polygon.h '(denominator * p[ky] - y).sign() > 0' \
  '(denominator * p[ky] - y).sign() >= 0'
mutant polygon_back_face Polygon shape/polygon.h 'if (denominator.sign() < 0) numerator' 'if (false) numerator'
mutant polygon_edges_without_bound Polygon shape/polygon.h 'std::abs(left - right) > doubt' 'std::abs(left - right) >= 0'
mutant polygon_heights_without_bound Polygon shape/polygon.h 'std::abs(p[ky] - y) > y_error' 'std::abs(p[ky] - y) >= 0'
mutant polygon_left_is_right Polygon shape/polygon.h 'q_above ? side > 0 : side < 0' 'q_above ? side < 0 : side > 0'

# --- Box --------------------------------------------------------------------------------------------------------------
mutant box_edge_without_bound Box shape/box.h '<= 8 * detail::half_ulp * std::abs(interval.out)' '< 0'
mutant box_edges_open Box shape/box.h 'enters.slope).sign() > 0' 'enters.slope).sign() >= 0'
mutant box_faces_open Box shape/box.h 'if (!(low <= o && o <= high))' 'if (!(low < o && o < high))'
mutant box_signs_ignored Box shape/box.h 'if (d < 0) std::swap(t_in, t_out)' 'if (false) std::swap(t_in, t_out)'
mutant box_sign_of_zero_ignored Box shape/box.h 'if (d == 0) {' 'if (false) {'
mutant box_departure_forgotten Box shape/box.h 'double t_in = departed_part == 2 * axis ? 0' 'double t_in = false ? 0'
mutant box_enters_where_it_starts Box shape/box.h 'const bool entering = interval.in > 0;' 'const bool entering = interval.in >= 0;'

# --- Quadrics ---------------------------------------------------------------------------------------------------------
mutant quadric_second_root_dropped Cylinder shape/quadric.h '{wall.roots.near, wall.roots.far})' '{wall.roots.near})'
mutant quadric_discriminant_without_bound Cylinder shape/quadratic.h \
  'std::abs(discriminant) > 2 * discriminant_error' 'std::abs(discriminant) > 0'
mutant quadric_parallel_without_bound Cone shape/quadratic.h 'std::abs(a) > 2 * a_error' 'std::abs(a) > 0'
mutant quadric_rim_without_bound Cylinder shape/quadric.h 'wall.sure && wall.sure_about(slab_in) && wall.sure_about(slab_out)' \
  'wall.sure'
mutant quadric_tangent_missed Cylinder shape/quadratic.h 'return discriminant.sign() + 1;' \
  'return discriminant.sign() > 0 ? 2 : 0;'
mutant quadric_linear_case_forgotten Cone shape/quadratic.h 'if (a.sign() == 0) return static_cast<double>(-wide_c / (wide_b + wide_b));' ''
mutant quadric_other_way_round Cone shape/quadratic.h 'const bool flip = a.sign() < 0;' 'const bool flip = false;'
mutant quadric_rim_met_twice Cylinder shape/quadric.h 'first = place.below + place.at;' 'first = place.below;'
mutant quadric_cap_open Cylinder shape/quadric.h '(wall.flipped ? -sign : sign) <= 0' '(wall.flipped ? -sign : sign) < 0'
mutant quadric_departure_forgotten Cylinder shape/quadratic.h 'const double c = on_wall ? 0 :' 'const double c = false ? 0 :'
mutant quadric_not_refined Cone shape/quadratic.h 'step < 4' 'step < 0'
mutant quadric_normal_of_another_place HyperboloidTwoSheets shape/quadric.h 'gradient_at(Vec3d(position));' 'slope;'
mutant quadric_a_without_bound Cone shape/quadratic.h 'const double a_error = 8' 'const double a_error = 0'
mutant quadric_inside_is_outside Cone shape/quadratic.h ': t <= near || far <= t;' ': near <= t && t <= far;'

# --- Prism ------------------------------------------------------------------------------------------------------------
mutant prism_half_open_broken Prism shape/prism.h '(side >= 0) != (next_side >= 0)' '(side > 0) != (next_side >= 0)'
mutant prism_cap_behind Prism shape/prism.h 'if (slab.out < next.t) meet_cap' 'if (slab.out > next.t) meet_cap'
mutant prism_corners_without_bound Prism shape/prism.h '!(std::abs(side) < 4 * half_ulp * size_of_cross(d, to))' 'true'
mutant prism_rim_without_bound Prism shape/prism.h 'std::abs(t - start) > error + 4 * half_ulp * start' 'true'
mutant prism_far_cap_without_bound Prism shape/prism.h 'slab.in > 0 || told_from_cap(sides.out, sides.out_error)' 'true'
mutant prism_exactly_half_open Prism shape/prism.h 'along.y).sign() >= 0) == ((qy' 'along.y).sign() > 0) == ((qy'
mutant prism_upright_from_the_slab Prism shape/prism.h 'enters && !upright ? in' 'enters ? in'
mutant prism_parity_forgotten Prism shape/prism.h 'crossings.inside = !crossings.inside;' 'crossings.inside = true;'

# --- Triangles --------------------------------------------------------------------------------------------------------
mutant triangle_signs_without_bound Triangle shape/triangle.h \
  '(least > error || most < -error) &&' 'true &&'
mutant triangle_weights_believed Triangle shape/triangle.h '(off.z - slope) * ray.inverse' 'off.z * ray.inverse'
mutant triangle_t_without_bound Triangle shape/triangle.h '> 4 * error * depth' '>= 0'
mutant triangle_edges_for_both mesh shape/triangle.h 'if (side != 0) return side;' 'return side >= 0 ? 1 : -1;'
mutant triangle_edges_for_none mesh shape/triangle.h 'if (side != 0) return side;' 'return side;'
mutant triangle_one_edge_turned mesh shape/triangle.h 'exact_side(o, d, c, a) != side' 'exact_side(o, d, a, c) != side'
mutant triangle_absolute_threshold mesh shape/triangle.h '(most > error && least < -error)) return' \
  '(most > error && least < -error) || std::abs(determinant) < 1e-6) return'
mutant triangle_bound_too_small Triangle shape/triangle.h 'corner_error = 8 * detail::half_ulp' \
  'corner_error = 0.001 * detail::half_ulp'
mutant triangle_tie_by_the_edge_alone mesh shape/triangle.h 'x != 0) return x;' 'x != 0) return 1;'
mutant triangle_slivers_dropped mesh accel/triangles.h 'normal_of(triangle) == Vec3<T>(0)' 'true'
mutant triangle_deep_corner_forgotten Triangle shape/triangle.h 'detail::half_ulp * (across + 2 * depth)' \
  'detail::half_ulp * across'

# --- Accelerators -----------------------------------------------------------------------------------------------------
mutant accel_tie_to_the_higher accel accel/query.h 'id < hit_.primitive' 'id > hit_.primitive'
mutant accel_sign_of_zero_ignored accel accel/slabs.h 'negative[axis] = std::signbit(ray.direction[axis])' \
  'negative[axis] = ray.direction[axis] < 0'
mutant accel_boxes_without_pad accel accel/primitives.cpp 'const T pad = 8 *' 'const T pad = -8 *'
mutant kdtree_far_side_late accel accel/kdtree.h 'std::fmax(at.in, t - slack)' 'std::fmax(at.in, t + std::abs(t) / 64)'
mutant kdtree_one_side accel accel/kdtree.h 'boxes.box(id).max[best_axis] >= plane' 'boxes.box(id).min[best_axis] >= plane'
mutant bvh_too_early accel accel/bvh.h 'beyond(stack[count].in, query.t_far())' 'beyond(2 * stack[count].in, query.t_far())'
mutant mesh_bvh_too_early accel accel/wide_search_loop.h 'static_cast<Far>(in * (1 - 8 ' 'static_cast<Far>(2 * in * (1 - 8 '
mutant packet_enters_with_the_last packets accel/ray_packet.h 'enter[axis] = negative ? in.least : in.greatest' \
  'enter[axis] = negative ? in.greatest : in.least'
mutant packet_of_mixed_signs packets accel/ray_packet.h 'signs |= (' 'signs &= ('
mutant packet_slopes_of_zero packets accel/ray_packet.h '&& finite())' ')'
mutant packet_bounds_of_others packets accel/ray_packet.h 'own(values, 0), high = low' 'all_lanes(values[first]), high = low'
mutant packet_of_another_kind packets accel/ray_packet.h 'return same & where' 'return where'
mutant packet_shortens_all packets accel/packet_search_loop.h 'packet.latest()' 'packet.t_far[0]'
mutant packet_grain_of_one_ray packets accel/packet_lane_tests.h 'loaded(of.grain + first)' 'all_of(of.grain[0])'
mutant lanes_grain_of_doubles_forgotten widths accel/mesh_ray.h 'rounds ? size : Float{}' 'rounds ? Float{} : Float{}'
mutant packet_inverse_of_one_ray packets accel/packet_lane_tests.h 'min(max(far * least, far * most), leaves)' 'min(min(far * least, far * most), leaves)'
mutant lanes_shrunk accel accel/float_slabs.h '-rounded_up(-static_cast<double>(box.min[axis]))' \
  'rounded_up(box.min[axis] + 1e-5 * std::abs(static_cast<double>(box.min[axis])))'
mutant lanes_origin_without_slack accel accel/float_slabs.h '16 * std::numeric_limits<float>::epsilon() * sum +' '0 * sum +'
mutant lanes_boxes_not_widened accel accel/float_slabs.h 'near + 8 * std::numeric_limits' 'near - 1000 * std::numeric_limits'
mutant lanes_sign_of_zero_ignored accel accel/float_slabs.h 'bits_of(reinterpret_cast<LaneMask>(slope))' \
  'bits_of(slope < all_lanes(0))'
mutant lanes_beyond_floats_range accel accel/float_slabs.h 'slope == 0 || (slope > 1 / most_held && slope < most_held)' 'true'
mutant triangles_ruled_out_without_error accel accel/lane_tests.h 'all_of(4) * across * corner_error' \
  'all_of(-4) * across * corner_error'
mutant triangles_beyond_too_early accel accel/lane_tests.h 'nearest - (farthest - nearest) > ' 'nearest + nearest > '
mutant triangles_behind_too_early accel accel/lane_tests.h '(at < -slack)' '(at < slack)'
mutant triangles_beyond_without_slack accel accel/lane_tests.h 'at - slack > ray.reach * wide' 'at + slack > ray.reach * area'
mutant packs_taken_for_exact widths accel/wide_tree.h 'packs_are_exact_ = false' 'packs_are_exact_ = true'
mutant edge_left_unseen widths accel/triangles.h 'way > rounding * std::max(largest_, start)' 'way > rounding * start / 64'
mutant edge_left_unseen_of_copies widths accel/triangles.h 'term_sizes(to_world, found->second) + ' ''
mutant certain_at_an_edge widths accel/lane_tests.h '(min(u, min(v, w)) > error)' '(min(u, min(v, w)) > -error)'
mutant certain_beyond_the_light widths accel/lane_tests.h 'at + slack < short_of_it * narrow' 'at - slack < ray.reach * wide'
mutant certain_of_the_departed widths accel/primitives.h '(departed != id && !any_equal_' '(!any_equal_'
mutant certain_of_its_neighbour widths accel/lane_tests.h '(at - slack > all_of(128 * half_ulp)' '(at + slack > all_of(-128 * half_ulp)'
mutant split_triangles_cross_elsewhere splits accel/spatial_split.cpp 'a + (plane - a[axis]) /' 'a + 0.9 * (plane - a[axis]) /'
mutant split_triangles_on_one_side_only splits accel/spatial_split.cpp 'sides.right_items.push_back(each.right);' ''
mutant split_triangles_beyond_the_plane splits accel/spatial_split.cpp '-infinity<float>, plane.at);' '-infinity<float>, plane.at - 0.01F);'
mutant moved_subtrees_out_of_the_box splits accel/reinsertion.cpp 'both.include(box(node.left + 1));' ''
mutant moved_subtrees_never splits accel/wide_tree.cpp '!in_haste && Builder' 'false && Builder'
mutant splits_built_once splits accel/wide_tree.cpp 'return binary.splits_space;' 'return false;'
mutant moved_subtrees_instead_of_others splits accel/reinsertion.cpp 'put(joined, height_of_joined, beside);' ''
mutant copies_off_by_nothing copies accel/mesh_copies.cpp 'return off_ + rounding_of(' 'return 0.0 * off_ + 0.0 * rounding_of('
mutant copies_corners_not_rounded copies accel/mesh_copies.cpp 'rounding * far_' '0.0 * far_'
mutant copies_boxes_without_pad copies accel/mesh_copies.cpp 'placed.min -= pad, placed.max += pad;' ''
mutant copies_grain_forgotten copies accel/mesh_ray.h 'grain += most / (4 * half_ulp);' ''
mutant copies_turned_rays_trusted copies accel/mesh_ray.h '!(turned < half_ulp)' 'false'
mutant copies_mirrored_inside_out copies accel/triangles.h 'return {a, mirrored ? c : b, mirrored ? b : c};' 'return {a, b, c};'
mutant copies_hit_again_at_once copies accel/primitives.h 'triangles_.equal(left, met)' 'false'
mutant copies_degenerate_hit copies accel/primitives.h 'if (found && Triangles<T>::degenerate(placed)) found.reset();' ''
mutant copies_numbered_from_the_first copies accel/mesh_copies.h 'primitives.shape_count() + copy.first' 'primitives.shape_count()'
mutant grid_leaves_by_the_farthest accel accel/grid.h 'leave[0] <= leave[1] ? (leave[0] <= leave[2]' \
  'leave[0] >= leave[1] ? (leave[0] <= leave[2]'

# --- Transforms -------------------------------------------------------------------------------------------------------
mutant normal_by_the_map_itself transform math/transform.h 'n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y)' \
  'n.x * x + n.y * y + n.z * z'
mutant mirror_turns_inside_out transform math/transform.h 'return determinant() < 0 ? -image : image;' 'return image;'
mutant inverse_moves_the_wrong_way transform math/transform.h 'inverted.move = -inverted.direction(m.move);' \
  'inverted.move = inverted.direction(m.move);'

# --- Coordinates on surfaces ------------------------------------------------------------------------------------------
mutant uv_box_axes_swapped uv shape/box.h 'across = part / 2 == 0 ? 1 : 0, up = part / 2 == 2 ? 1 : 2' \
  'across = part / 2 == 2 ? 1 : 2, up = part / 2 == 0 ? 1 : 0'
mutant uv_box_mirrored uv shape/box.h 'part == 1 || part == 2 || part == 5' 'part < 6'
mutant uv_wall_without_radius uv shape/quadric.h '{quadric.radii.x * angle, ' '{angle, '
mutant uv_triangle_turned uv shape/triangle.h 'cross(point.normal, along)' 'cross(along, point.normal)'
mutant uv_normal_as_a_direction uv shape/object_transform.h 'transform.to_object.normal(point.normal)' \
  'transform.to_object.direction(point.normal)'

# --- Bodies in one another --------------------------------------------------------------------------------------------
mutant stack_entered_twice stack trace/media.h 'if (holds(stack, body)) return;' ''
mutant stack_first_of_equals_on_top stack trace/media.h 'bodies[each].priority > bodies[body].priority' \
  'bodies[each].priority >= bodies[body].priority'
mutant stack_lowest_on_top stack trace/media.h 'bodies[each].priority > bodies[body].priority' \
  'bodies[each].priority < bodies[body].priority'
mutant stack_never_left stack trace/media.h 'std::remove(stack.begin(), stack.end(), body)' 'stack.end()'
mutant stack_top_is_left stack trace/media.h 'std::remove(stack.begin(), stack.end(), body)' \
  'stack.empty() ? stack.end() : stack.end() - 1'

# --- Photons ----------------------------------------------------------------------------------------------------------
mutant photons_count_the_edge photons trace/photon_map.cpp \
  'if (heap.full() && entry.photon == heap.farthest().photon) continue;' 'if (false) continue;'
mutant photons_stored_from_behind photons trace/photon_map.cpp '!normal || dot(Vec3d(photon.normal), *normal) > half' 'true'
mutant photons_around_the_corner photons trace/photon_map.cpp 'constexpr double half = 0.5;' 'constexpr double half = -0.5;'
mutant photons_one_side_of_the_split photons trace/photon_map.cpp 'waiting[count++] = far;' ''
mutant photons_far_side_too_far photons trace/photon_map.cpp 'far.squared = beyond * beyond;' 'far.squared = 2 * beyond * beyond;'
mutant photons_splitter_forgotten photons trace/photon_map.cpp 'take(middle, squared_distance(photons_[middle], point));' ''
mutant photons_by_the_sphere photons trace/photon_map.cpp 'std::numbers::pi * squared_radius' '4 * std::numbers::pi * squared_radius'
mutant photons_by_half_the_line photons trace/photon_map.cpp '2 * std::sqrt(squared_radius)' 'std::sqrt(squared_radius)'
mutant photons_heap_upside_down photons trace/photon_map.cpp 'else if (entry < entries_.front())' 'else if (entries_.front() < entry)'
mutant photons_beyond_the_radius photons trace/photon_map.cpp \
  'if (!(apart <= found.squared_radius) ||' 'if (!(apart <= 2 * found.squared_radius) ||'

# --- Radiosity --------------------------------------------------------------------------------------------------------
mutant factors_of_what_lies_behind radiosity trace/form_factor.cpp \
  'const std::vector<Vec3d> one = clipped(first, second[0], area_vector_of(second));' \
  'const std::vector<Vec3d> one(first.begin(), first.end());'
mutant factors_by_three_points radiosity trace/form_factor.cpp '!(std::abs(by_five - by_three) > tolerance)' 'true'
mutant factors_without_the_angle radiosity trace/form_factor.cpp '(h > 0 ? h * portable::atan2(w, h) : 0)' '0'
mutant factors_without_the_cosine radiosity trace/form_factor.cpp 'sum += cosine * log_between(' 'sum += log_between('
mutant factors_over_pi radiosity trace/form_factor.cpp 'sum / (2 * std::numbers::pi)' 'sum / std::numbers::pi'
mutant factor_at_a_point_of_what_lies_behind radiosity trace/form_factor.cpp \
  'const std::vector<Vec3d> seen = clipped(corners, point, normal);' \
  'const std::vector<Vec3d> seen(corners.begin(), corners.end());'
mutant factor_at_a_point_over_pi radiosity trace/form_factor.cpp 'std::abs(sum) / (2 * std::numbers::pi)' \
  'std::abs(sum) / std::numbers::pi'
mutant strings_not_halved radiosity trace/form_factor.h 'return 0.5 * (crossed - uncrossed);' 'return crossed - uncrossed;'
mutant strings_swapped radiosity trace/form_factor.cpp 'length(other->a - one->a) + length(other->b - one->b)' \
  'length(other->b - one->a) + length(other->a - one->b)'
mutant strings_behind radiosity trace/form_factor.cpp 'if (a >= 0 && b >= 0) return edge;' 'return edge;'
# --- Beams ------------------------------------------------------------------------------------------------------------
mutant beams_reflected_the_other_way beams trace/unfolded_plan.cpp 'point = point * mirror->size - normal * (across * mirror->twice);' \
  'point = point * mirror->size + normal * (across * mirror->twice);'
mutant beams_mirrors_in_the_wrong_order beams trace/unfolded_plan.cpp 'mirror = mirrors_.rbegin(); mirror != mirrors_.rend()' \
  'mirror = mirrors_.begin(); mirror != mirrors_.end()'
mutant beams_see_through_the_mirror beams trace/unfolded_plan.cpp 'static_cast<double>(at - *beyond) > alike * beyond->hi' 'at.hi > 0'
mutant beams_farthest_first beams trace/unfolded_plan.cpp '(*least - *at) > alike' '(*at - *least) > alike'
mutant beams_last_of_those_upon_each_other beams trace/unfolded_plan.cpp '!(static_cast<double>(*least - *at) > alike * least->hi)' \
  '!(static_cast<double>(*least - *at) > -alike * least->hi)'
mutant beams_sides_without_ends beams trace/unfolded_plan.cpp 'if (!outline.endless && (cross' 'if (outline.endless && (cross'
mutant beams_corner_forgotten beams trace/unfolded_plan.cpp 'parallel(turned_left(one.from)), parallel(turned_left(one.to));' \
  'parallel(turned_left(one.from));'
mutant beams_tangents_forgotten beams trace/unfolded_plan.cpp 'equal({cross(begin, one.centre), 0.0}, {cross(end, one.centre), 0.0}, one.square, begin, end);' ';'
mutant beams_crossings_forgotten beams trace/unfolded_plan.cpp 'parallel(other.normal * one.offset - one.normal * other.offset);' ';'
mutant beams_radical_line_signed_wrong beams trace/unfolded_plan.cpp 'other.square - one.square + dot' 'one.square - other.square + dot'
mutant beams_one_root_of_two beams trace/unfolded_plan.cpp 'if (sum.hi != 0) add(a.rounded() / sum);' ''
mutant beams_roots_that_cancel beams trace/unfolded_plan.cpp 'half.sign() < 0 ? root - half.rounded()' 'half.sign() > 0 ? root - half.rounded()'
mutant beams_rounded_to_doubles beams trace/unfolded_plan.cpp 'std::nearbyint(((x.hi - high) + x.lo) * fine) / fine' '0'
mutant beams_wide_slivers_dropped beams trace/unfolded_plan.cpp 'least_width = 0x1p-98' 'least_width = 0x1p-58'
mutant beams_near_side_only beams trace/unfolded_plan.cpp 'return lies_beyond(far) ? std::optional(far) : std::nullopt;' 'return std::nullopt;'
mutant beams_gap_between_parts beams trace/unfolded_plan.cpp '    last = place;' '    last = {place.high + 0x1p-52, place.low};'
mutant beams_shadows_from_the_eye beams trace/unfolded_plan.cpp 'return std::pair{begin * surface.offset - start * n0, end * surface.offset - start * n1};' \
  'return std::pair{begin * surface.offset, end * surface.offset};'
mutant beams_shadows_of_one_corner beams trace/unfolded_plan.cpp 'corner(outline.from), corner(outline.to);' 'corner(outline.from);'
mutant beams_sun_at_a_place beams trace/unfolded_plan.cpp 'light.is_distant ? place : at - place' 'at - place'
mutant beams_round_shadows_too_wide beams trace/unfolded_plan.cpp 'c0 * c0 - outline.square * dot(w0, w0)' 'c0 * c0 - 4.0 * outline.square * dot(w0, w0)'
mutant beams_round_shadows_of_the_sun_too_wide beams trace/unfolded_plan.cpp 'square = outline.square * dot(place, place)' 'square = outline.square'
mutant marks_squares_off_by_half marks trace/plan_marks.cpp 'line <= last; ++line) add(line * size);' 'line <= last; ++line) add((line + 0.5) * size);'
mutant marks_one_axis_of_squares marks trace/plan_marks.cpp 'for (const int axis : {0, 1}) {' 'for (const int axis : {0}) {'
mutant marks_seam_forgotten marks trace/plan_marks.cpp 'if (low < seam && seam < high) add(seam);' ''
mutant marks_one_rim_of_two marks trace/plan_marks.cpp '{spot.cos_outer / level, spot.cos_inner / level}' '{spot.cos_outer / level}'
mutant marks_rim_on_one_side marks trace/plan_marks.cpp 'for (const double side : {sine, -sine}) {' 'for (const double side : {sine}) {'
mutant marks_rim_of_a_tilted_spot marks trace/plan_marks.cpp 'spot.cos_outer / level' 'spot.cos_outer'
mutant marks_sun_from_behind marks trace/plan_marks.cpp 'PlanRay{at, -place, true} : PlanRay{place, at - place}' 'PlanRay{at, -place, true} : PlanRay{at, at - place}'
mutant marks_tangents_as_wide_as_the_centre marks trace/plan_marks.cpp 'sine = other.radius / away' 'sine = other.radius / (away + other.radius)'
mutant marks_critical_angle_of_the_cosine marks trace/plan_marks.cpp 'turned(towards * normal, way, cosine)' 'turned(towards * normal, cosine, way)'
mutant glass_ratio_turned_over marks trace/flat_refraction.h 'n2 * cos_out / (n1 * cos_in)' 'n1 * cos_in / (n2 * cos_out)'
mutant glass_ratio_along_the_normal marks trace/flat_refraction.h 'n2 * cos_out / (n1 * cos_in)' 'n2 / n1'
mutant glass_bent_the_other_way marks trace/flat_refraction.h 'way + (ratio_ - 1)' 'way - (ratio_ - 1)'
mutant glass_off_by_another_law marks trace/flat_refraction.h 'n1_ / n2_ * dot(direction, along)' 'n2_ / n1_ * dot(direction, along)'

# --- Cones and pencils ------------------------------------------------------------------------------------------------
mutant cones_mirror_curved_the_other_way cones trace/ray_cone.cpp 'width.spread + 2 * curvature' 'width.spread - 2 * curvature'
mutant cones_mirror_planes_exchanged cones trace/ray_cone.cpp 'ConePlane::of_incidence ? 1 / cos_in : cos_in' \
  'ConePlane::of_incidence ? cos_in : 1 / cos_in'
mutant cones_refracted_without_the_normal cones trace/ray_cone.cpp '(width.spread + turn) - turn' '(width.spread + turn)'
mutant cones_refracted_across_by_a_sum cones trace/ray_cone.cpp '(eta * cos_in - cos_out) * curvature' \
  '(eta * cos_in + cos_out) * curvature'
mutant cones_refracted_as_wide_as_before cones trace/ray_cone.cpp 'width.radius * cos_out / cos_in, eta' 'width.radius, eta'
mutant cones_snell_upside_down cones trace/ray_cone.cpp 'eta = n1 / n2' 'eta = n2 / n1'
mutant cones_segment_doubled cones trace/ray_cone.cpp '(arc - portable::sin(arc)) / 2' 'arc - portable::sin(arc)'
mutant cones_small_segment_doubled cones trace/ray_cone.cpp 'arc * square / 12' 'arc * square / 6'
mutant cones_one_segment_of_two cones trace/ray_cone.cpp 'segment(own) + radius * radius * segment(other)' 'segment(own)'
mutant cones_gloss_narrows cones trace/ray_cone.cpp 'min(width.spread + more' 'min(width.spread - more'
mutant cones_facets_turn_once cones trace/ray_cone.cpp '{2, 2 * cos_in}' '{1, cos_in}'
mutant cones_facets_turn_with_the_light cones trace/ray_cone.cpp 'std::abs(1 - in / cos_out)' 'std::abs(in / cos_out)'
mutant cones_facets_as_wide_as_half cones trace/ray_cone.cpp '2 / std::numbers::sqrt3' '1 / std::numbers::sqrt3'
mutant cones_ask_as_if_they_did_not_widen cone_bodies trace/cone_bodies.cpp 'std::abs(cone.radius_at(until))' '0.0'
mutant cones_ask_nothing_behind_their_start cone_bodies trace/cone_bodies.cpp 'std::max(along - reach, 0.0)' 'std::max(along, 0.0)'
mutant pencils_mirror_keeps_left cones trace/pencil.h 'ConePlane::of_incidence ? -1 : 1;' 'ConePlane::of_incidence ? 1 : 1;'
mutant pencils_focus_elsewhere cones trace/pencil.h '-system.b / system.d' '-system.a / system.d'
mutant pencils_in_the_wrong_order cones trace/pencil.h 'a * before.b + b * before.d' 'before.a * b + before.b * d'
mutant pencils_curved_alike_inside cones trace/pencil.h 'return side * Vec3d(primitives' 'return Vec3d(primitives'
mutant pencils_planes_alike cones trace/pencil.h 'dot(turn(along), along)' 'dot(turned_across, across)'
mutant pencils_transferred_back cones trace/pencil.h '{pencil_transfer(distance), pencil_transfer(distance)}' '{pencil_transfer(-distance), pencil_transfer(distance)}'
mutant pencils_system_in_the_wrong_order cones trace/pencil.h '{plan * before.plan +' '{before.plan * plan +'
mutant pencils_system_without_detours cones trace/pencil.h 'across * before.across,' 'across * before.across + across,'
mutant pencils_from_up_twice cones trace/pencil.h 'plan * before.left_from_up + left_from_up * before.across,' 'left_from_up * before.left_from_up + plan * before.across,'
mutant pencils_mirrored_flat_across cones trace/pencil.h 'pencil_mirror(ConePlane::across, at.upright' 'pencil_mirror(ConePlane::across, 0 * at.upright'
mutant pencils_mirror_twists_back cones trace/pencil.h '{0, 0, -2 * at.twist, 0}' '{0, 0, 2 * at.twist, 0}'
mutant pencils_glass_twists_not cones trace/pencil.h 'turn * at.twist / (n2 * at.cos_in)' '0 * at.twist / (n2 * at.cos_in)'
mutant pencils_glass_twists_as_it_enters cones trace/pencil.h 'turn * at.twist / (n2 * cos_out)' 'turn * at.twist / (n2 * at.cos_in)'
mutant pencils_turned_the_other_way cones trace/pencil.h 'sin = -dot(across, sides.left)' 'sin = dot(across, sides.left)'
mutant pencils_turned_twice cones trace/pencil.h 'std::swap(turn.left_from_up, turn.up_from_left);' ''
mutant pencils_foci_of_a_mean cones trace/pencil.h 'mean < 0 ? mean - apart : mean + apart' 'mean'
mutant pencils_second_focus_is_the_first cones trace/pencil.h 'foci[1] = -B.determinant() / larger' 'foci[1] = -larger / D.determinant()'
mutant pencils_ellipse_is_a_circle cones trace/pencil.h 'turned + flipped, std::abs(turned - flipped)' 'turned, turned'

# Light inside bodies.
mutant media_back_for_on media trace/phase.h '(g < 0 ? -g * (1 + cos) : g * (1 - cos))' '(g < 0 ? -g * (1 - cos) : g * (1 + cos))'
mutant media_plan_as_space media trace/phase.h 'if (flat) return lost' 'if (false) return lost'
mutant media_cosine_of_the_textbook_half media trace/phase.h 'g / 2 * (s * s + 3)' 'g * (s * s + 3)'
mutant media_plan_turned_back media trace/phase.h 'ahead = (1 + g) * cos_half, aside = (1 - g)' 'ahead = (1 - g) * cos_half, aside = (1 + g)'
mutant media_sphere_squeezed media trace/phase.h 'std::sqrt((1 - cos) * (1 + cos));' '1 - cos;'
mutant media_one_channel_for_all media trace/medium_walk.h 'return 1 / dot(odds, transmittance(distance));' 'return 1 / transmittance(distance).x;'
mutant media_absorption_forgotten media trace/medium_walk.h 'return left * scattering.coefficient * (1' 'return left * medium->extinction * (1'
mutant media_absorption_scatters media trace/medium_walk.h 'dot(odds, left * medium->extinction)' 'dot(odds, left * scattering.coefficient)'
mutant media_odds_of_all_alike media trace/medium_walk.h 'odds = sum > 0 ? throughput * (1 / sum) : Rgb<T>(T(1) / 3);' 'odds = Rgb<T>(T(1) / 3);'
mutant media_free_path_inverted media trace/medium_walk.h '-portable::log1p(-u) / extinction' '-portable::log1p(-u) * extinction'
mutant dipole_sources_in_one_place dipole trace/dipole.h 'real_[c] * (1 + 4 * a / 3)' 'real_[c]'
mutant dipole_without_a_boundary dipole trace/dipole.h 'a = (1 + reflected_inside) / (1 - reflected_inside)' 'a = 1 + 0 * reflected_inside'
mutant dipole_directions_over_n dipole trace/dipole.h 'mean_transmittance_ / (ior * ior)' 'mean_transmittance_ / ior'
mutant dipole_anisotropy_forgotten dipole trace/dipole.h 'scattering[c] * (1 - anisotropy)' 'scattering[c] + 0 * anisotropy'
mutant dipole_falls_by_what_scatters dipole trace/dipole.h '3 * absorption[c] * extinction' '3 * absorption[c] * scattered'
mutant dipole_of_one_source dipole trace/dipole.h '(from(real_[channel]) + from(virtual_[channel]))' 'from(real_[channel])'
mutant dipole_light_lost_at_the_boundary dipole trace/dipole.h 'transmittance(cos) / mean_transmittance_' 'transmittance(cos)'
mutant dipole_distance_from_the_source dipole trace/dipole.h 'z * std::sqrt(grown * (2 + grown))' 'z * (1 + grown)'
mutant dipole_sources_drawn_alike dipole trace/dipole.h 'of_real / (of_real + of_virtual)' 'T(0.5) + 0 * of_virtual * of_real'

# Rays with width.
mutant differentials_transfer_without_dt differentials trace/ray_differential.h 'return {without_dt + dt * D, ray.dD};' 'return {without_dt, ray.dD};'
mutant differentials_transfer_backwards differentials trace/ray_differential.h 'const T dt = -dot(without_dt, N)' 'const T dt = dot(without_dt, N)'
mutant differentials_mirrors_are_flat differentials trace/ray_differential.h '(D_N * dN + dD_N * N)' '(dD_N * N)'
mutant differentials_reflect_wrong_sign differentials trace/ray_differential.h 'ray.dD - T(2) * (D_N * dN' 'ray.dD - T(2) * (-D_N * dN'
mutant differentials_refract_by_one_eta differentials trace/ray_differential.h 'eta - eta * eta * D_N / refracted_N' 'eta - eta * D_N / refracted_N'
mutant differentials_refract_towards_the_ray differentials trace/ray_differential.h 'D_N = -at.cos_in, refracted_N = -at.cos_out' 'D_N = -at.cos_in, refracted_N = at.cos_out'
mutant differentials_eye_without_perspective differentials trace/ray_differential.h '(right - dot(D, right) * D) * per_length' 'right * per_length'
mutant differentials_normal_on_one_side differentials trace/ray_differential.h 'dot(shading_normal, point.normal) < 0 ? T(-1) : T(1)' 'T(1)'
mutant differentials_ball_of_radius_one differentials shape/sphere.h 'return along / sphere.radius;' 'return along;'
mutant differentials_gradient_gets_longer differentials math/vec.h '(derivative - dot(derivative, unit) * unit) / size' 'derivative / size'
mutant differentials_map_forgotten differentials shape/object_transform.h 'return derivative_of_unit(transform.to_world.normal(own.normal), transform.to_world.normal(turned));' 'return turned;'
mutant differentials_corners_alike differentials accel/triangles.h 'bc.x * (b - a) + bc.y * (c - a)' 'bc.x * (b - a)'
mutant checker_border_clockwise differentials trace/checker_filter.cpp 'integral / cross(p, q)' 'integral / std::abs(cross(p, q))'
mutant checker_integral_of_another_row differentials trace/checker_filter.cpp 'return absolute(within_period(u)) - 0.5' 'return 0.5 - absolute(within_period(u))'
mutant checker_line_half_exchanged differentials trace/checker_filter.cpp 'mean_along(swapped(centre), swapped(way))' 'mean_along(centre, swapped(way))'
mutant checker_lines_counted_once differentials trace/checker_filter.cpp '2.0 * wave * F(' 'wave * F('
mutant checker_by_parts_without_its_ends differentials trace/checker_filter.cpp 'S(u + du) * S(v + dv) - S(u) * S(v)' 'S(u + du) * S(v + dv)'

# Images over footprints.
mutant pyramid_last_pixel_forgotten pyramid trace/texture_pyramid.cpp 'to((size + 1) / 2)' 'to(size / 2)'
mutant pyramid_pixels_alike pyramid trace/texture_pyramid.cpp 'use(at, covered / ratio)' 'use(at, 1 / ratio)'
mutant pyramid_ellipse_turned pyramid trace/texture_pyramid.cpp 'B = 2 * (dx.x * dx.y + dy.x * dy.y)' 'B = -2 * (dx.x * dx.y + dy.x * dy.y)'
mutant pyramid_ellipse_of_one_side pyramid trace/texture_pyramid.cpp 'A = dx.y * dx.y + dy.y * dy.y + 1' 'A = dx.y * dx.y + 1'
mutant pyramid_levels_by_the_shorter pyramid trace/texture_pyramid.cpp 'if (major < minor) std::swap(longer, shorter), std::swap(major, minor);' ''
mutant pyramid_share_of_the_sharper pyramid trace/texture_pyramid.cpp 'portable::log1p(2 * mantissa - 1)' 'portable::log1p(1 - mantissa)'
mutant pyramid_rows_count_upwards pyramid trace/texture_pyramid.cpp '(1 - place(v, wraps.v))' '(place(v, wraps.v))'
mutant pyramid_mirror_repeats pyramid trace/texture.h 'index < size ? index : 2 * size - 1 - index' 'index % size'
mutant pyramid_gaussian_wider pyramid trace/texture_pyramid.cpp 'portable::exp(-2.0 * static_cast<double>(i) / last)' 'portable::exp(-1.0 * static_cast<double>(i) / last)'

# Mirrors of small mirrors, and metals.
mutant facets_without_their_area facets trace/microfacets.h 'return alpha_ * alpha_ / (pi_v<T> * at * at);' 'return alpha_ / (pi_v<T> * at * at);'
mutant facets_hide_the_wrong_way facets trace/microfacets.h '(2 * (eye * light_root + light * eye_root))' '(2 * (eye * eye_root + light * light_root))'
mutant facets_cosine_counted_twice facets trace/microfacets.h 'value.once = facets * light /' 'value.once = facets * light * light /'
mutant facets_pdf_of_all_facets facets trace/microfacets.h 'facets / (2 * (eye + eye_root))' 'facets / (4 * eye)'
mutant facets_drawn_from_all facets trace/microfacets.h 'const T z = (1 - share) * (1 + eye.z) - eye.z;' 'const T z = (1 - share) * 2 - 1;'
mutant facets_lost_light_forgotten facets trace/microfacets.h 'value.again = mean < 1 ?' 'value.again = mean < 0 ?'
mutant facets_metal_met_once_for_all facets trace/microfacets.h 'again = mean * mean * seen /' 'again = mean * seen /'
mutant metal_absorbs_the_wrong_way facets trace/microfacets.h 'n * n - k * k - sin2' 'n * n + k * k - sin2'
mutant metal_without_its_angle facets trace/microfacets.h 'p_odd = s_odd * sin2' 'p_odd = s_odd'

# --- Rough matt surfaces and rough glass ------------------------------------------------------------------------------
mutant matt_lost_light_forgotten matt trace/rough_diffuse.h 'if (!(mean_ < 1)) return sum;' 'if (true) return sum;'
mutant matt_mean_of_another_law matt trace/rough_diffuse.h '28 / (15 * pi_v<T>)' '18 / (15 * pi_v<T>)'
mutant matt_sends_light_on matt trace/rough_diffuse.h 's = dot(to_eye, to_light) - eye * light' 's = eye * light - dot(to_eye, to_light)'
mutant matt_other_way_differs matt trace/rough_diffuse.h 'std::max(std::max(out, in),' 'std::max(out,'
mutant matt_colour_counted_once matt trace/rough_diffuse.h 'albedo[c] * albedo[c] * mean_' 'albedo[c] * mean_'
mutant matt_albedo_of_angle_alone matt trace/rough_diffuse.h 'sin * (portable::atan2(sin, cos) - sin * cos)' 'sin * portable::atan2(sin, cos)'
mutant glass_index_counted_once glass trace/rough_dielectric.h 'turned * turned * -light_half' 'turned * -light_half'
mutant glass_facets_upside_down glass trace/rough_dielectric.h 'return side == Side::rarer ? -along : along;' 'return -along;'
mutant glass_transmits_all glass trace/rough_dielectric.h 'value.once = (1 - fresnel) * pdf' 'value.once = pdf'
mutant glass_seen_is_lit glass trace/rough_dielectric.h 'pdf * (2 * light / (light + light_root))' 'pdf'
mutant glass_density_of_one_facet glass trace/rough_dielectric.h 'value.pdf_of_both += (1 - lost) * (1 - fresnel) * pdf' 'value.pdf_of_both += (1 - fresnel) * pdf'
mutant glass_loses_on_its_own_side glass trace/rough_dielectric.h 'through ? far.albedo : own.albedo' 'own.albedo'
mutant glass_indices_not_squared glass trace/rough_dielectric.cpp 'passed * ratio * ratio * rarer_loss' 'passed * ratio * rarer_loss'
mutant glass_loss_of_the_wrong_side glass trace/rough_dielectric.cpp 'passed * denser_loss / most' 'passed * rarer_loss / most'
mutant glass_lost_light_forgotten glass trace/rough_dielectric.h '(const T mean = out.mean(); mean < 1)' '(const T mean = out.mean(); mean < 0)'

# --- Maps and reliefs -------------------------------------------------------------------------------------------------
mutant maps_of_another_channel maps trace/surface_maps.h 'return colour(uv)[channel];' 'return colour(uv)[0];'
mutant maps_height_as_wide maps trace/surface_maps.cpp 'uv.y / height' 'uv.y / width'
mutant maps_relief_upside_down maps trace/surface_maps.cpp 'leaning = bent - gradient;' 'leaning = bent + gradient;'
mutant maps_slope_of_one_side maps trace/surface_maps.cpp '(2 * (half.x + half.y))' '(half.x + half.y)'
mutant maps_slopes_exchanged maps trace/surface_maps.cpp '(h_u * by_s.x + h_v * by_s.y)' '(h_u * by_s.y + h_v * by_s.x)'
mutant maps_green_downward maps trace/surface_maps.cpp 'dot(across, by_v) < 0 ? -bend_y : bend_y' 'bend_y'
mutant maps_red_of_a_mirrored_frame maps trace/surface_maps.cpp 'std::copysign(T(1), normal_map_.width * area)' 'T(1)'
mutant maps_strength_of_one_axis maps trace/surface_maps.cpp 'bend_y = strength_ * (2 * c.y - 1)' 'bend_y = 2 * c.y - 1'
mutant maps_share_of_the_wrong_one maps trace/surface_maps.cpp '(at.roughness - levels_[low])' '(levels_[next] - at.roughness)'
mutant maps_two_steps_far maps trace/surface_maps.cpp 'low = alone ? next : next - 1;' 'low = alone ? next : 0;'
mutant maps_density_of_one_roughness maps trace/bsdf.h 'less.pdf + this->rougher_share * (more.pdf - less.pdf)' 'less.pdf'
mutant maps_value_of_one_roughness maps trace/bsdf.h 'less.value + this->rougher_share * (more.value - less.value)' 'less.value'
mutant maps_numbers_used_twice maps trace/bsdf.h 'u = std::clamp(chosen ?' '[[maybe_unused]] const T rest = std::clamp(chosen ?'
mutant maps_normal_turns_away maps trace/optics.h 'if (const T height = height_by(bent); height > 0 && height >= least) return bent;' 'return bent;'
mutant maps_normal_falls_back_at_once maps trace/optics.h 'return height_by(normal) > 0 ? normal : geometric_normal;' 'return geometric_normal;'
mutant maps_normal_clamped_to_the_horizon maps trace/optics.h 'least = std::min(facing, T(0.05));' 'least = T(1e-3) * facing;'

# Faces through a window, of beams in space.
mutant faces_behind_seen beam_faces trace/beam_faces.cpp 'const double side = face.plane.above(view.eye) < 0 ? 1 : -1;' 'const double side = 1;'
mutant faces_farthest_seen beam_faces trace/beam_faces.cpp 'WindowLine nearer{nearness.a - its.a, nearness.b - its.b, nearness.c - its.c,' \
  'WindowLine nearer{its.a - nearness.a, its.b - nearness.b, its.c - nearness.c,'
mutant faces_crossings_forgotten beam_faces trace/beam_faces.cpp 'if (sides.inside && sides.outside) lines.push_back(nearer);' ''
mutant faces_higher_primitive_first beam_faces trace/beam_faces.cpp 'faces[other].primitive <= face.primitive' 'faces[other].primitive >= face.primitive'
mutant faces_seen_before_the_mirror beam_faces trace/beam_faces.cpp 'if (beyond != nullptr) edges.push_back(view.above(*beyond, face.plane));' ''
mutant faces_far_too_near beam_faces trace/beam_faces.cpp 'far = std::max(far, dot(axis, view.direction(place)) / nearness);' 'far = std::max(far, 0.8 * dot(axis, view.direction(place)) / nearness);'
mutant faces_region_too_small beam_faces trace/beam_faces.cpp 'if (most < side.offset - 1e-9 * terms) return std::nullopt;' 'if (most < side.offset + 1e-2 * terms) return std::nullopt;'
mutant faces_shadow_before_the_blocker beam_faces trace/beam_faces.cpp 'lines.push_back(view.above({side * face.plane.normal, side * face.plane.offset}, on));' ''
mutant faces_shadow_turned beam_faces trace/beam_faces.cpp 'light.is_distant ? cross(to - from, light.place) : cross(from - light.place, to - light.place);
    lines.push_back' 'light.is_distant ? cross(light.place, to - from) : cross(from - light.place, to - light.place);
    lines.push_back'
mutant faces_beyond_the_light_hide_it beam_faces trace/beam_faces.h 'lines.back().c -= 1;' ''
mutant faces_filters_stop beam_faces trace/beam_faces.h '(does == ShadowRole::filters ? piece.weakened : piece.stopped) = true;' 'piece.stopped = true;'
mutant faces_round_shade_themselves beam_faces trace/beam_faces.h 'return &face != &other && (other.is_flat || from_inside || face.primitive != other.primitive);' 'return &face != &other;'
mutant faces_round_light_their_inside beam_faces trace/beam_faces.h '(other.is_flat || from_inside || face.primitive != other.primitive)' '(other.is_flat || face.primitive != other.primitive)'
mutant window_halves_overlap beam_faces trace/beam_window.cpp 'if (here < 0 || starts_on) halves.outside.push_back(from);' 'halves.outside.push_back(from);'
mutant window_crossing_misplaced beam_faces trace/beam_window.cpp 'from + here / (here - there) * (to - from)' 'from + there / (there - here) * (to - from)'
mutant window_mirrored_eye_only beam_faces trace/beam_window.cpp 'mirror.above(eye) * mirror.normal, turned(corner)' 'mirror.above(eye) * mirror.normal, corner'
mutant window_above_behind_the_eye beam_faces trace/beam_window.cpp 'const double sign = height < 0 ? -1 : 1;' 'const double sign = 1;'
