#pragma once
// Pictures that are known in closed form.

#include "math/vec.h"

namespace raywalk::study {

struct Rectangle {
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< x0 <= x1, y0 <= y1
  [[nodiscard]] double area() const { return (x1 - x0) * (y1 - y0); }
};

/// Solid angle of a rectangle of the plane z = 0, seen from (x, y, height), height > 0. Also the integral of height /
/// r^3 over it: the contribution of a point light with quadratic attenuation to a diffuse floor, or of a rectangle of
/// point lights to a point of the floor.
[[nodiscard]] double solid_angle(const Rectangle& rectangle, double x, double y, double height);

/// Area of the intersection of a disk about the origin with a rectangle: coverage of a pixel by a round edge.
[[nodiscard]] double disk_area_in(const Rectangle& rectangle, double radius);

/// Radius, on the plane at distance 1 in front of a pinhole, of the image of a sphere straight ahead; distance >
/// radius. It is a little more than radius / distance: the silhouette is nearer than the centre.
[[nodiscard]] double silhouette_radius(double radius, double distance);

/// Radiance that a diffuse point of albedo 1 reflects from a disk that emits radiance 1, parallel to its surface at
/// `height` above it, the disk's axis `aside` away: the form factor (J. Howell's catalogue, B-13).
[[nodiscard]] double disk_form_factor(double radius, double height, double aside);

/// The same of a rectangle of the plane at `height` above the point (0, 0) (Lambert 1760, by its corners).
[[nodiscard]] double rectangle_form_factor(const Rectangle& rectangle, double height);

/// Radiance in a closed room whose walls emit `emission` and reflect with `albedo`, after `length` rays.
[[nodiscard]] double furnace(double emission, double albedo, int length);
/// The same for infinitely many rays; albedo < 1.
[[nodiscard]] inline double endless_furnace(double emission, double albedo) { return emission / (1 - albedo); }

}  // namespace raywalk::study
