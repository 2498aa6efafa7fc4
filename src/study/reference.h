#pragma once
// Pictures that are known in closed form.

#include "math/vec.h"

namespace raywalk::study {

struct Rectangle {
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< x0 <= x1, y0 <= y1
  [[nodiscard]] double area() const { return (x1 - x0) * (y1 - y0); }
};

/// Solid angle of a rectangle of the plane z = 0, seen from (x, y, height), height > 0. Also the integral of
/// height / r^3 over it: what a point light with quadratic attenuation brings to a diffuse floor, or what the point
/// lights of a rectangle above it bring to a point of the floor.
[[nodiscard]] double solid_angle(const Rectangle& rectangle, double x, double y, double height);

/// Area that a disk about the origin has in common with a rectangle: coverage of a pixel by a round edge.
[[nodiscard]] double disk_area_in(const Rectangle& rectangle, double radius);

/// Radius, on the plane at distance 1 in front of a pinhole, of the image of a sphere straight ahead; distance >
/// radius. It is a little more than radius / distance: the silhouette lies nearer than the middle.
[[nodiscard]] double silhouette_radius(double radius, double distance);

/// Share of a unit disk that lies at x > edge: what a lens sees past an edge that is out of focus.
[[nodiscard]] double disk_beyond(double edge);

/// Light that a diffuse point of albedo 1 reflects of a disk that emits radiance 1, parallel to its surface at `height`
/// above it, the disk's axis `aside` away: the form factor (J. Howell's catalogue, B-13).
[[nodiscard]] double disk_form_factor(double radius, double height, double aside);

/// The same of a rectangle of the plane at `height` above the point (0, 0) (Lambert 1760, by its corners).
[[nodiscard]] double rectangle_form_factor(const Rectangle& rectangle, double height);

/// Radiance in a closed room whose walls emit `emission` and send back `albedo` of what arrives, after `length` rays.
[[nodiscard]] double furnace(double emission, double albedo, int length);
/// The same without an end; albedo < 1.
[[nodiscard]] inline double endless_furnace(double emission, double albedo) { return emission / (1 - albedo); }

}  // namespace raywalk::study
