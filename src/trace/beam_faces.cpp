#include "trace/beam_faces.h"

#include "accel/float_slabs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

BeamPlane plane_through(const Vec3d& point, const Vec3d& normal) { return {normal, dot(normal, point)}; }

Bounds<double> box_of(const BeamFace& face) {
  Bounds<double> box;
  for (const Vec3d& corner : face.outline) box.include(corner);
  return box;
}

/// The place of a window on a plane; far away where the plane is seen from nearly within.
Vec3d place_on(const BeamView& view, const WindowLine& nearness, const Vec2d& place) {
  return view.eye + view.direction(place) / nearness.nearness(place);
}

/// Through the point at both ends of a side, on the side of `inner`.
BeamPlane facing(const Vec3d& normal, const Vec3d& through, const Vec3d& inner) {
  const BeamPlane plane = plane_through(through, normal);
  return plane.above(inner) < 0 ? BeamPlane{-plane.normal, -plane.offset} : plane;
}

/// How far along an axis what is seen in the window's parts lies at most.
double farthest_of(const std::vector<SeenFace>& seen, const BeamView& view, const Vec3d& axis) {
  double far = 0;
  for (const SeenFace& part : seen) {
    if (part.face < 0) return infinity<double>;
    for (const Vec2d& place : part.window) {
      const double nearness = part.nearness.at(place);
      if (!(nearness > part.nearness.slack)) return infinity<double>;
      far = std::max(far, dot(axis, view.direction(place)) / nearness);
    }
  }
  return far * (1 + 1e-9);
}

}  // namespace

BeamFaces::BeamFaces(std::vector<BeamFace> faces, const Stop& stop) : faces_(std::move(faces)) {
  std::vector<TreeItem> items;
  for (int i = 0; i < size(); ++i) {
    if ((*this)[i].outline.empty())
      endless_.push_back(i);
    else
      items.push_back({rounded_out(box_of((*this)[i])), i, 0});
  }
  if (!items.empty()) tree_ = WideTree(std::move(items), BuildOptions{stop});
}

double BeamFaces::far_from(const Vec3d& eye) const {
  double far = 1;
  for (const BeamFace& face : faces_)
    for (const Vec3d& corner : face.outline) far = std::max(far, length(corner - eye));
  return 8 * far;
}

std::optional<double> BeamFaces::nearest_of(const BeamRegion& region, const Bounds<float>& box) {
  const Vec3d low = wide(box.min), high = wide(box.max);
  for (const BeamPlane& side : region.sides) {
    double most = 0, terms = std::abs(side.offset);
    for (int axis = 0; axis < 3; ++axis) {
      const double a = side.normal[axis] * low[axis], b = side.normal[axis] * high[axis];
      most += std::max(a, b);
      terms += std::max(std::abs(a), std::abs(b));
    }
    if (most < side.offset - 1e-9 * terms) return std::nullopt;
  }
  double near = 0;
  for (int axis = 0; axis < 3; ++axis)
    near += std::min(region.axis[axis] * (low[axis] - region.eye[axis]),
                     region.axis[axis] * (high[axis] - region.eye[axis]));
  return near;
}

std::vector<SeenFace> faces_seen(const BeamFaces& faces, const BeamView& view, const WindowPiece& window,
                                 const BeamPlane* beyond, const Stop& stop) {
  std::vector<SeenFace> seen{{window}};
  BeamRegion region = detail::region_of(view, window);
  if (beyond != nullptr) region.sides.push_back(*beyond);
  std::vector<WindowLine> lines, edges;
  double far = infinity<double>;
  faces.visit(region, stop, [&](int id) {
    const BeamFace& face = faces[id];
    if (detail::is_edge_on(view.eye, face.plane)) return far;
    const WindowLine nearness = view.nearness(face.plane);
    edges.clear();
    if (beyond != nullptr) edges.push_back(view.above(*beyond, face.plane));
    detail::add_edges(edges, view, face);
    bool changed = false;
    for (std::size_t i = 0, before = seen.size(); i < before; ++i) {
      lines = edges;
      if (const int other = seen[i].face; other >= 0) {
        const WindowLine& its = seen[i].nearness;
        const WindowLine nearer{nearness.a - its.a, nearness.b - its.b, nearness.c - its.c, nearness.slack + its.slack};
        const WindowSides sides = sides_of(seen[i].window, nearer);
        const bool same_place = !sides.inside && !sides.outside;
        if (same_place ? faces[other].primitive <= face.primitive : !sides.inside) continue;
        if (sides.inside && sides.outside) lines.push_back(nearer);
      }
      detail::take(seen, i, lines, [&](SeenFace& part) {
        part.face = id, part.nearness = nearness;
        changed = true;
      });
    }
    if (changed) far = farthest_of(seen, view, region.axis);
    return far;
  });
  return seen;
}

namespace detail {

void add_edges(std::vector<WindowLine>& lines, const BeamView& view, const BeamFace& face) {
  if (face.outline.empty()) return lines.push_back(view.nearness(face.plane));
  const double side = face.plane.above(view.eye) < 0 ? 1 : -1;
  for_each_side(face, [&](const Vec3d& begin, const Vec3d& end) {
    const Vec3d from = begin - view.eye, to = end - view.eye;
    lines.push_back(view.line(side * cross(from, to), length(from) * length(to)));
  });
}

void add_shadow(std::vector<WindowLine>& lines, const BeamView& view, const BeamPlane& on, const BeamLight& light,
                const BeamFace& face) {
  const double towards = light.is_distant ? dot(face.plane.normal, light.place) : face.plane.above(light.place);
  if (light.is_distant ? std::abs(towards) <= 1e-14 : is_edge_on(light.place, face.plane)) return;
  const double side = towards < 0 ? 1 : -1;
  lines.push_back(view.above({side * face.plane.normal, side * face.plane.offset}, on));
  for_each_side(face, [&](const Vec3d& from, const Vec3d& to) {
    const Vec3d normal = light.is_distant ? cross(to - from, light.place) : cross(from - light.place, to - light.place);
    lines.push_back(view.above(plane_through(from, side * normal), on));
  });
}

BeamRegion region_to(const BeamLight& light, const BeamView& view, const SeenFace& seen, const BeamPlane& on) {
  BeamRegion region;
  const Vec3d middle = place_on(view, seen.nearness, middle_of(seen.window));
  const auto place = [&](std::size_t i) { return place_on(view, seen.nearness, seen.window[i]); };
  for (std::size_t i = 0; i < seen.window.size(); ++i) {
    const Vec3d from = place(i), to = place(i + 1 == seen.window.size() ? 0 : i + 1);
    const Vec3d normal = light.is_distant ? cross(to - from, light.place) : cross(from - light.place, to - light.place);
    region.sides.push_back(facing(normal, from, middle));
  }
  const Vec3d beside = light.is_distant ? middle + light.place : light.place;
  region.sides.push_back(facing(on.normal, middle, beside));
  region.eye = middle;
  return region;
}

BeamRegion region_of(const BeamView& view, const WindowPiece& window) {
  BeamRegion region;
  const Vec3d axis = normalize(view.direction(middle_of(window)));
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Vec3d from = view.direction(window[i]), to = view.direction(window[i + 1 == window.size() ? 0 : i + 1]);
    region.sides.push_back(facing(cross(from, to), view.eye, view.eye + axis));
  }
  region.eye = view.eye, region.axis = axis;
  return region;
}

bool is_edge_on(const Vec3d& eye, const BeamPlane& plane) {
  const double terms = std::abs(dot(plane.normal, eye)) + std::abs(plane.offset);
  return !(std::abs(plane.above(eye)) > 1e-14 * terms);
}

}  // namespace detail

}  // namespace raywalk
