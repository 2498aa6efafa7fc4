#include "io/nff_reader.h"

#include "io/polygon_cut.h"
#include "io/scene_parts.h"
#include "math/elementary.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace raywalk {

namespace {

using detail::WordReader;
using schema::above_zero;
using schema::coordinate;
using schema::not_negative;
using schema::reflectance;
using schema::view_angle;

constexpr schema::Whole corner_count{3, 10'000};

/// Maps z = 0 to `foot` and the +z direction to `axis`, for a shape about z.
std::vector<TransformStep> along(const Vec3d& foot, const Vec3d& axis) {
  std::vector<TransformStep> steps;
  steps.reserve(2);
  const Vec3d z(0, 0, 1), side = cross(z, axis);
  constexpr double degrees = 180 / 3.14159265358979323846;
  if (length(side) > 0) {
    steps.push_back({Rotate{side, portable::atan2(length(side), axis.z) * degrees}});
  } else if (axis.z < 0) {
    steps.push_back({Rotate{{1, 0, 0}, 180}});
  }
  if (foot != Vec3d(0.0)) steps.push_back({Translate{foot}});
  return steps;
}

class NffReader {
 public:
  NffReader(std::string_view text, const std::string& file)
      : words_(text, file, WordReader::Scope::text),
        too_large_(detail::make_room(scene_, text, file, {"s", "c"}, {"p", "pp"})) {}

  Result<SceneDocument> read() {
    if (too_large_) return tl::unexpected(*too_large_);
    scene_.camera.screen.width.reset();
    scene_.camera.fov.reset();
    scene_.limits.depth = 5;
    while (words_.ok()) {
      const std::string_view item = words_.item();
      if (item.empty()) break;
      read_item(item);
    }
    if (!scene_.camera.fov)
      words_.fail("there is no view (expected v with from, at, up, angle and resolution)",
                  "a scene in NFF starts with its view");
    triangles_.put(scene_, names_);
    triangles_.warn(words_);
    if (!words_.ok()) return tl::unexpected(*words_.error());
    set_strengths();
    return SceneDocument{std::move(scene_), {}, words_.warnings()};
  }

 private:
  void read_item(std::string_view item) {
    constexpr std::array<std::string_view, 8> items{"v", "b", "l", "f", "s", "c", "p", "pp"};
    if (item == "v") return read_view();
    if (item == "b") {
      scene_.background = words_.colour("the colour");
    } else if (item == "l") {
      read_light();
    } else if (item == "f") {
      read_material();
    } else if (item == "s") {
      read_sphere();
    } else if (item == "c") {
      read_cone();
    } else if (item == "p") {
      read_polygon(false);
    } else if (item == "pp") {
      read_polygon(true);
    } else {
      const bool is_number = item.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
      words_.fail(fmt::format("unknown item {} (expected {})", item.size() <= 40 ? item : "of many letters",
                              one_of({items.begin(), items.end()})),
                  is_number ? "the item before it has taken all of its numbers"
                            : "each item starts with its letter; # starts a comment");
    }
  }

  void read_view() {
    if (scene_.camera.fov) return words_.fail("there is a second view (expected one)", "comment out all views but one");
    constexpr std::array<std::string_view, 6> keys{"from", "at", "up", "angle", "hither", "resolution"};
    Camera& camera = scene_.camera;
    bool has_from = false, has_at = false, has_up = false, has_resolution = false;
    const auto is_key = [&](std::string_view word) { return std::find(keys.begin(), keys.end(), word) != keys.end(); };
    while (words_.ok() && is_key(words_.peek())) {
      const std::string_view key = words_.word();
      if (key == "from") {
        camera.eye = words_.point("from");
        has_from = true;
      } else if (key == "at") {
        camera.look_at = words_.point("at");
        has_at = true;
      } else if (key == "up") {
        camera.up = words_.direction("up");
        has_up = true;
      } else if (key == "angle") {
        camera.fov = FieldOfView{words_.number("angle", view_angle), FovAxis::y};
      } else if (key == "hither") {
        words_.number("hither", coordinate);
      } else {
        scene_.image.width = words_.whole("resolution", schema::pixel_count);
        scene_.image.height = words_.whole("resolution", schema::pixel_count);
        detail::check_image(scene_.image, words_);
        has_resolution = true;
      }
    }
    const char* missing = !has_from ? "from" : !has_at ? "at" : !has_up ? "up" : !camera.fov ? "angle" : nullptr;
    if (missing == nullptr && !has_resolution) missing = "resolution";
    if (!words_.ok()) return;
    if (missing != nullptr)
      return words_.fail_item(
          fmt::format("{} is missing in the view (expected {})", missing, one_of({keys.begin(), keys.end()})),
          "v is followed by from x y z, at x y z, up x y z, angle a, hither h, resolution w h");
    detail::check_camera(camera, words_);
  }

  /// Whether the item's next word is a number.
  bool number_follows() {
    const std::string_view word = words_.peek();
    return !word.empty() && word.find_first_of("+-.0123456789") == 0;
  }

  void read_light() {
    Light light{names_.next("Light"), Rgbd(1.0), PointLight{words_.point("the position"), {}}};
    if (number_follows()) light.strength = words_.colour("the colour");
    scene_.lights.push_back(std::move(light));
  }

  void read_material() {
    const Rgbd colour = words_.colour("the colour", reflectance);
    const double diffuse = words_.number("Kd", reflectance), specular = words_.number("Ks", reflectance);
    const double shine = words_.number("the shine", not_negative), transmission = words_.number("T", reflectance);
    if (std::max(diffuse, transmission) * max_component(colour) > reflectance.high)
      return words_.fail_item(
          "more than a thousand times the light would go on (expected Kd and T times the colour at "
          "most 1000)",
          std::string(reflectance.hint));
    Material material;
    material.ambient = material.diffuse = diffuse * colour;
    material.specular = material.reflection = Rgbd(specular);
    material.shininess = shine;
    const double ior = words_.number("the index of refraction", transmission > 0 ? above_zero : not_negative);
    if (transmission > 0) {
      material.transmission = transmission * colour;
      material.dielectric = specular == 0;
      material.ior = ior;
    }
    material_ = material;
  }

  /// The material for the next object; fails if there is none.
  const Material& material() {
    static const Material none;
    if (!material_)
      words_.fail_item("there is an object before the first material (expected f r g b Kd Ks shine T ior above it)",
                       "each object takes the material of the last f before it");
    return material_ ? *material_ : none;
  }

  /// A radius, whose sign only selects a side.
  double radius(std::string_view what) {
    const double given = words_.number(what, coordinate);
    return std::abs(given);
  }

  void read_sphere() {
    const Material& of = material();
    const Vec3d centre = words_.point("the centre");
    const double r = radius("the radius");
    if (words_.ok() && r * schema::max_magnitude < 1)
      words_.fail("the radius of s is 0 (expected any other number)", "a negative radius shows the inside");
    if (words_.ok()) add({names_.next("Sphere"), Shape<double>(Sphere<double>{centre, r}), of});
  }

  /// Between two circles, the wall only.
  void read_cone() {
    const Material& of = material();
    Vec3d base = words_.point("the base");
    double base_radius = radius("the radius at the base");
    Vec3d apex = words_.point("the apex");
    double apex_radius = radius("the radius at the apex");
    if (!words_.ok()) return;
    if (base_radius < apex_radius) std::swap(base, apex), std::swap(base_radius, apex_radius);
    const double height = length(apex - base), least = 1 / schema::max_magnitude;
    if (!(height >= least))
      return words_.fail_item("base and apex are the same point (expected a cone with a height)", "move one of them");
    if (!(base_radius >= least))
      return words_.fail_item("both radii are 0 (expected at least one other)", "a cone ends in a point, not in two");
    if (base_radius == apex_radius) {
      Cylinder<double> cylinder;
      cylinder.radii = {base_radius, base_radius, 1};
      cylinder.z_min = 0;
      cylinder.z_max = height;
      add({names_.next("Cylinder"), Shape<double>(cylinder), of, along(base, apex - base)});
      return;
    }
    // z is measured from the apex of the extended wall.
    const double tip = height * (base_radius / (base_radius - apex_radius));
    Cone<double> cone;
    cone.radii = {base_radius / tip, base_radius / tip, 1};
    cone.z_min = apex_radius == 0 ? 0 : tip - height;
    cone.z_max = tip;
    const Vec3d axis = (base - apex) / height;
    if (!(tip <= schema::max_magnitude && cone.radii.x >= least && cone.z_min < cone.z_max))
      return words_.fail_item("the cone is too slender to be told from a cylinder (expected radii that differ more)",
                              "make the two radii equal");
    add({names_.next("Cone"), Shape<double>(cone), of, along(base - tip * axis, axis)});
  }

  void read_polygon(bool with_normals) {
    const Material& of = material();
    const int count = words_.whole("the number of corners", corner_count);
    std::vector<Vec3d> corners, normals;
    for (int i = 0; i < count && words_.ok(); ++i) {
      corners.push_back(words_.point("a corner"));
      if (with_normals) normals.push_back(words_.point("a normal"));
    }
    if (!words_.ok()) return;
    const Polygon<double> polygon{corners, {}};
    if (count > 3 && !with_normals) {
      if (why_not_flat(polygon).empty()) {
        add({names_.next("Polygon"), Shape<double>(polygon), of});
        return;
      }
      if (!said_bent_) words_.warn("a polygon is not flat, or has no area; it is cut into triangles");
      said_bent_ = true;
    }
    const auto corner = [&](std::size_t i) {
      return detail::MeshCorner{corners[i], with_normals ? normals[i] : Vec3d(0.0)};
    };
    Mesh cut;
    cut.positions = corners;
    std::vector<std::int32_t> face(corners.size());
    std::iota(face.begin(), face.end(), 0);
    if (!detail::add_face(cut, face)) return words_.fail(detail::too_many_corners(face.size()), detail::hint_to_cut);
    for (const auto& [a, b, c] : cut.triangles)
      triangles_.add(scene_, names_, of,
                     {corner(static_cast<std::size_t>(a)), corner(static_cast<std::size_t>(b)),
                      corner(static_cast<std::size_t>(c))});
  }

  void add(Object object) {
    triangles_.put(scene_, names_);
    scene_.objects.push_back(std::move(object));
  }

  void set_strengths() {
    const double n = static_cast<double>(scene_.lights.size());
    const double strength = n > 0 ? std::sqrt(n) / (2 * n) : 1;
    for (Light& light : scene_.lights) light.strength *= strength;
    scene_.ambient = Rgbd(strength);
  }

  WordReader words_;
  Scene scene_;
  detail::UniqueNames names_;
  detail::TriangleGatherer triangles_;
  std::optional<Material> material_;
  std::optional<Error> too_large_;
  bool said_bent_ = false;
};

}  // namespace

Result<SceneDocument> parse_nff(std::string_view text, const std::string& file_name) {
  if (const auto fine = detail::check_plain_text(text, file_name); !fine) return tl::unexpected(fine.error());
  return NffReader(text, file_name).read();
}

}  // namespace raywalk
