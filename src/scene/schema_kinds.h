#pragma once
// The kinds of values of a scene's keys, with the numbers, lists and words that each accepts. The keys themselves:
// scene/schema.h. A kind's `expected()` completes "expected ..." in messages and is part of the reference of the
// format.

#include "math/words.h"
#include "scene/ink.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk::schema {

/// Every number is finite and at most this, so that squares and products of a few of them do not overflow; a number
/// that must be above 0 is at least 1 / max_magnitude.
inline constexpr double max_magnitude = 1e15;

/// Why a value is refused.
struct Refusal {
  std::string expected, hint;
};

struct Number {
  std::string_view words;
  double low = 0, high = max_magnitude;
  bool above_low = false;   ///< low itself is refused
  bool below_high = false;  ///< high itself is refused
  std::string_view hint{};
  std::string_view unit{};

  [[nodiscard]] std::string expected() const { return std::string(words); }
  [[nodiscard]] std::optional<Refusal> refusal(double value) const;
  [[nodiscard]] constexpr Number in(std::string_view the_unit) const {
    Number number = *this;
    number.unit = the_unit;
    return number;
  }
};

inline constexpr std::string_view scene_units = "scene units", degrees = "degrees", pixels = "pixels";
inline constexpr Number any_number{.words = "a number", .low = -max_magnitude, .hint = "such as 1 or -0.5"};
inline constexpr Number coordinate{
    .words = "a number",
    .low = -max_magnitude,
    .hint = "in scene units: x to the right, y up, z towards the reader",
    .unit = scene_units,
};
inline constexpr Number above_zero{.words = "a number above 0", .above_low = true, .hint = "such as 1 or 0.5"};
inline constexpr Number not_negative{.words = "a number that is 0 or more", .hint = "such as 0 or 0.5"};
inline constexpr Number extent = above_zero.in(scene_units), extent_or_zero = not_negative.in(scene_units);
/// Emitted light, and the fraction that a surface scatters. Both limits are far above what any scene needs, and low
/// enough that a few bounces do not exceed the float range of an image file, 3e38.
inline constexpr Number light_amount{
    .words = "a number from 0 to 1e12",
    .high = 1e12,
    .hint = "one number is a grey, [red, green, blue] a colour; light is never negative",
};
inline constexpr Number reflectance{
    .words = "a number from 0 to 1000",
    .high = 1000,
    .hint = "the share of the light that goes on, usually from 0 to 1",
};
inline constexpr Number view_angle{
    .words = "an angle in degrees above 0 and below 180",
    .high = 180,
    .above_low = true,
    .below_high = true,
    .hint = "45 is a usual angle of view, 90 a very wide one",
    .unit = degrees,
};
inline constexpr Number cone_angle{
    .words = "a full angle in degrees above 0 and at most 180",
    .high = 180,
    .above_low = true,
    .hint = "30 is a narrow spot, 90 a wide one",
    .unit = degrees,
};
inline constexpr Number inner_cone_angle{
    .words = "a full angle in degrees from 0 to 180",
    .high = 180,
    .hint = "up to half of it from the axis the light is at its full strength",
    .unit = degrees,
};
inline constexpr Number lobe_angle{
    .words = "half an angle in degrees from 0 to 90",
    .high = 90,
    .hint = "0 is sharp, 5 a brushed metal, 20 very rough",
    .unit = degrees,
};
inline constexpr Number roughness{
    .words = "a number from 0 to 1",
    .high = 1,
    .hint = "0 is smooth, 0.1 polished metal, 0.5 cast metal",
};
inline constexpr Number diffuse_roughness{
    .words = "a number from 0 to 1",
    .high = 1,
    .hint = "0 is chalk by Lambert, 0.5 clay, 1 dust",
};
inline constexpr Number coordinate_along_normal{
    .words = "a number",
    .low = -max_magnitude,
    .hint = "such as 0.05: the height of the relief beside the size of its copies",
    .unit = scene_units,
};
inline constexpr Number sun_elevation{
    .words = "an angle in degrees from 0 to 90",
    .high = 90,
    .hint = "0 is sunset, 90 straight up",
    .unit = degrees,
};
inline constexpr Number azimuth{
    .words = "an angle in degrees from -360 to 360",
    .low = -360,
    .high = 360,
    .hint = "90 is to the left of 0",
    .unit = degrees,
};
inline constexpr Number turbidity{
    .words = "a number from 1 to 10",
    .low = 1,
    .high = 10,
    .hint = "2 is very clear air, 3 clear, 6 moist, 10 hazy",
};
inline constexpr Number albedo{
    .words = "a number from 0 to 1",
    .high = 1,
    .hint = "0.2 is grass, 0.8 snow",
};

inline constexpr Number mean_cosine{
    .words = "a number above -1 and below 1",
    .low = -1,
    .high = 1,
    .above_low = true,
    .below_high = true,
    .hint = "the mean cosine of the angle by which light is scattered: 0 is evenly, 0.9 mostly ahead",
};

struct Whole {
  int low = 1, high = 1;
  std::string_view unit{};
  [[nodiscard]] std::string expected() const;
};
inline constexpr Whole cell_count{1, 10001}, pixel_count{1, 32768, pixels}, depth_count{1, 1000},
    sample_count{1, 1 << 20}, light_grid_count{1, 256}, path_length_count{1, 1000}, photon_count{1, 100000000},
    nearest_count{2, 10000}, shot_count{1, 10000000};

struct Flag {
  [[nodiscard]] static std::string expected() { return "true or false"; }
};

/// One of the values of an enumeration, by its word.
template <Worded Value>
struct Choice {
  [[nodiscard]] static std::string expected();
};
/// "a", "b" or "c", each in quotes.
[[nodiscard]] std::string quoted_words(const std::vector<std::string_view>& words);
template <Worded Value>
std::string Choice<Value>::expected() {
  return quoted_words(all_words<Value>());
}
inline constexpr Choice<FovAxis> fov_axes;
inline constexpr Choice<ShadowKind> shadow_kinds;
inline constexpr Choice<ShadingNormal> shading_normals;
inline constexpr Choice<CheckerFilter> checker_filters;
inline constexpr Choice<TextureFilter> texture_filters;
inline constexpr Choice<ImageWrap> image_wraps;
inline constexpr Choice<MirrorKind> mirror_kinds;
inline constexpr Choice<MappedParameter> mapped_parameters;
inline constexpr Choice<MapChannel> map_channels;
inline constexpr Choice<Encoding> encodings;
inline constexpr Choice<Integrator> integrators;
/// What each of them follows: "How light is followed: shadows only (cast); ...".
[[nodiscard]] const std::string& integrator_sentence();
inline constexpr Choice<Sampler> samplers;
inline constexpr Choice<Subsurface> subsurfaces;
inline constexpr Choice<Numerics> numerics;
inline constexpr Choice<InkColour> ink_colours;

/// Any text in quotes.
struct Text {
  [[nodiscard]] static std::string expected() { return "text in quotes"; }
};
/// One line of it.
struct OneLine {
  std::size_t longest;  ///< in bytes
  [[nodiscard]] std::string expected() const;
};
/// The unique name of an object, light or group.
struct Name {
  std::size_t longest;  ///< in bytes
  [[nodiscard]] std::string expected() const;
};
/// Names of lights, objects and groups.
struct Names {
  std::size_t most;
  [[nodiscard]] static std::string expected() { return "names in quotes, in brackets"; }
};
/// The name of a group defined before.
struct GroupName {
  [[nodiscard]] static std::string expected() { return "the name of a group in quotes"; }
};
/// A file name, relative to the scene's folder.
struct FileName {
  std::string_view words, hint;
  [[nodiscard]] std::string expected() const { return std::string(words); }
};
inline constexpr Name own_name{100};
inline constexpr OneLine ink_text{longest_ink_text};
inline constexpr FileName file_name{"the name of a file in quotes", "it is looked for from the scene's own folder"},
    mesh_file_name{"the name of a mesh file in quotes", "such as file = \"bunny.ply\""},
    sky_file_name{"the name of a picture's file in quotes", "such as file = \"evening.hdr\""},
    map_file_name{"the name of a picture's file in quotes", "it is looked for from the scene's own folder"};

/// How a list of numbers may be abbreviated.
enum class Shorthand {
  none,
  grey,  ///< three equal numbers as one number
  flat,  ///< three numbers without the last one if that is 0
};

/// A few numbers in brackets.
struct Tuple {
  std::string_view words;
  Number number;
  Shorthand shorthand = Shorthand::none;
  bool is_direction = false;  ///< not of length 0; the last number may be omitted in input, but is always written
  [[nodiscard]] std::string expected() const { return std::string(words); }
};
/// What a key of a direction holds: `given` as it is, unless its square would come too close to 0: then scaled by a
/// power of two to a length of about 1, which is exact. Nothing if its length is 0.
[[nodiscard]] std::optional<Vec3d> usable_direction(const Vec3d& given);
/// Linear RGB, each number at least 0.
struct Colour : Tuple {};
inline constexpr std::string_view point_words = "[x, y] in the plan or [x, y, z]",
                                  colour_words = "one number for a grey, or [red, green, blue]",
                                  radii_words = "one number above 0, or [x, y, z] of them";
inline constexpr Tuple point{point_words, coordinate, Shorthand::flat}, place{"[x, y] in the plan", coordinate},
    direction{point_words, coordinate.in(""), Shorthand::none, true},
    attenuation_terms{"[constant, linear, quadratic]", not_negative}, open_and_close{"[open, close]", any_number},
    radii{radii_words,
          {.words = radii_words, .above_low = true, .hint = "such as 1 or [1, 2, 0.5]", .unit = scene_units},
          Shorthand::grey};
inline constexpr Colour light_colour{{colour_words, light_amount, Shorthand::grey}},
    share{{colour_words, reflectance, Shorthand::grey}};

/// A list of tuples.
struct Rows {
  std::string_view words;  ///< "corners [x, y]"
  Tuple row;
  std::size_t least, most;
  std::string_view hint;
  [[nodiscard]] std::string expected() const;
};
inline constexpr std::size_t max_vertices = 1'000'000;
inline constexpr Rows plan_corners{"corners [x, y]",
                                   {"a corner [x, y]", coordinate},
                                   3,
                                   1'000,
                                   "the corners go once around, such as [[0, 0], [2, 0], [1, 2]]"},
    corners{"corners [x, y, z]",
            {"a corner [x, y, z]", coordinate},
            3,
            10'000,
            "such as [[0, 0, 1], [2, 0, 1], [1, 2, 1]]"},
    motion_keys{"keys [time, x, y, z]",
                {"a key [time, x, y, z]", coordinate.in("")},
                0,
                10'000,
                "such as motion = [[0, 0, 0, 0], [1, 2, 0, 0]]: from its place at the time 0 by 2 along x at 1"};
inline constexpr Rows pen_points{"places [x, y]",
                                 {"a place [x, y]", coordinate},
                                 1,
                                 most_pen_points,
                                 "the pen goes through them in this order, such as [[0, 0], [1, 0.5]]"};
/// A list of lists of tuples.
struct Lists {
  Rows rows;
  [[nodiscard]] static std::string expected() { return "a list of holes, each a list of corners"; }
};
inline constexpr Lists holes{corners};

/// One of a mesh's lists, with one row per vertex or triangle.
struct MeshRows {
  enum class Part { positions, triangles, normals, uv } part;
  Rows rows;
  [[nodiscard]] std::string expected() const { return rows.expected(); }
};
inline constexpr MeshRows vertex_rows{MeshRows::Part::positions,
                                      {"vertices [x, y, z]", {"[x, y, z]", coordinate}, 0, max_vertices, {}}},
    triangle_rows{MeshRows::Part::triangles,
                  {"triangles [a, b, c]",
                   {"[a, b, c], which count the vertices from 0", coordinate.in("")},
                   0,
                   max_vertices,
                   {}}},
    normal_rows{MeshRows::Part::normals, {"normals [x, y, z]", {"[x, y, z]", coordinate.in("")}, 0, max_vertices, {}}},
    uv_rows{MeshRows::Part::uv, {"points [u, v]", {"[u, v]", coordinate}, 0, max_vertices, {}}};

/// The steps of a transform, in order of application.
struct Steps {
  std::size_t most;
  [[nodiscard]] std::string expected() const;
};
inline constexpr Steps transform_steps{1'000};

/// A table with its own keys, and a list of such tables.
struct Table {
  [[nodiscard]] static std::string expected() { return "a table"; }
};
struct Tables {
  [[nodiscard]] static std::string expected() { return "any number of tables"; }
};
inline constexpr Flag yes_or_no;
inline constexpr Text text;
inline constexpr Names names{10'000};
inline constexpr GroupName group_name;
inline constexpr Table table;
inline constexpr Tables tables;

// --- The numbers of a tuple, in the order in which they are written

template <class Visit>
void each_number(Vec2d& v, const Visit& visit) {
  visit(v.x), visit(v.y);
}
template <class Visit>
void each_number(Vec3d& v, const Visit& visit) {
  visit(v.x), visit(v.y), visit(v.z);
}
template <std::size_t Count, class Visit>
void each_number(std::array<double, Count>& numbers, const Visit& visit) {
  for (double& number : numbers) visit(number);
}
template <class Visit>
void each_number(Attenuation& a, const Visit& visit) {
  visit(a.constant), visit(a.linear), visit(a.quadratic);
}
template <class Visit>
void each_number(MotionKey& key, const Visit& visit) {
  visit(key.time), each_number(key.offset, visit);
}
template <class Visit>
void each_number(Translate& step, const Visit& visit) {
  each_number(step.by, visit);
}
template <class Visit>
void each_number(Rotate& step, const Visit& visit) {
  each_number(step.axis, visit), visit(step.degrees);
}
template <class Visit>
void each_number(Scale& step, const Visit& visit) {
  each_number(step.by, visit);
}
template <class Visit>
void each_number(Mirror& step, const Visit& visit) {
  each_number(step.normal, visit);
}
template <class Visit>
void each_number(Shear& s, const Visit& visit) {
  visit(s.xy), visit(s.xz), visit(s.yx), visit(s.yz), visit(s.zx), visit(s.zy);
}
template <class Visit>
void each_number(Matrix& matrix, const Visit& visit) {
  each_number(matrix.rows, visit);
}

// --- What the alternatives of a variant are called

/// A step's word, its arguments, and a description.
struct StepWords {
  std::string_view word, arguments, meaning;
};
constexpr StepWords step_words(const Translate& /*step*/) { return {"translate", "x, y, z", "moves by x, y, z"}; }
constexpr StepWords step_words(const Rotate& /*step*/) {
  return {"rotate", "x, y, z, degrees", "turns about the axis x, y, z through the origin, by the right-hand rule"};
}
constexpr StepWords step_words(const Scale& /*step*/) {
  return {"scale", "x, y, z", "stretches along each axis; -1 mirrors"};
}
constexpr StepWords step_words(const Mirror& /*step*/) {
  return {"mirror", "x, y, z", "mirrors in the plane through the origin whose normal is x, y, z"};
}
constexpr StepWords step_words(const Shear& /*step*/) {
  return {"shear", "xy, xz, yx, yz, zx, zy", "x grows by xy times y and xz times z, and so on"};
}
constexpr StepWords step_words(const Matrix& /*step*/) {
  return {"matrix", "twelve numbers", "three rows of four: the factors of x, y and z, and what is added"};
}

[[nodiscard]] inline StepWords words_of(const TransformStep& step) {
  return std::visit([](const auto& kind) { return step_words(kind); }, step.kind);
}
template <class Visit>
void each_number(TransformStep& step, const Visit& visit) {
  std::visit([&](auto& kind) { each_number(kind, visit); }, step.kind);
}

/// The value of `type`.
template <class S>
constexpr auto type_name(const S& shape) -> decltype(shape_name(shape)) {
  return shape_name(shape);
}
template <LightKind L>
constexpr auto type_name(const L& /*light*/) {
  return L::name;
}
template <class S>
  requires std::is_constructible_v<AnySky, S>
constexpr auto type_name(const S& /*sky*/) {
  return S::name;
}

}  // namespace raywalk::schema
