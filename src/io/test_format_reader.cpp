#include "io/test_format_reader.h"

#include "io/scene_parts.h"
#include "shape/object_transform.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace raywalk {

namespace {

using detail::WordReader;
using schema::above_zero;
using schema::coordinate;
using schema::not_negative;
using schema::reflectance;
using schema::view_angle;

/// Most vertices, and most matrices on the stack.
constexpr int max_vertices = 100'000'000;
constexpr std::size_t max_pushed = 10'000;

/// The matrix stack: the step written last is applied to an object first.
class Matrices {
 public:
  void append(TransformStep step) {
    // Many steps are combined into one matrix, so that the cost of a push is bounded.
    constexpr std::size_t max_steps = 16;
    steps_.push_back(std::move(step));
    if (steps_.size() > max_steps) steps_ = {matrix_step()};
    whole_ = affine_of(object_steps());
  }
  /// In the order in which they are applied to an object.
  [[nodiscard]] std::vector<TransformStep> object_steps() const { return {steps_.rbegin(), steps_.rend()}; }
  [[nodiscard]] const Affine<double>& whole() const { return whole_; }

 private:
  [[nodiscard]] TransformStep matrix_step() const {
    const Affine<double> m = affine_of(object_steps());
    return {Matrix{{m.x.x, m.y.x, m.z.x, m.move.x, m.x.y, m.y.y, m.z.y, m.move.y, m.x.z, m.y.z, m.z.z, m.move.z}}};
  }

  std::vector<TransformStep> steps_;
  Affine<double> whole_;
};

class TestFormatReader {
 public:
  TestFormatReader(std::string_view text, const std::string& file)
      : words_(text, file, WordReader::Scope::line),
        too_large_(detail::make_room(scene_, text, file, {"sphere"}, {"tri", "trinormal"})) {}

  Result<SceneDocument> read() {
    if (too_large_) return tl::unexpected(*too_large_);
    scene_.camera.screen.width.reset();
    scene_.camera.fov.reset();
    scene_.limits.depth = 6;
    scene_.ambient = Rgbd(1.0);
    scene_.encoding = Encoding::truncated;
    material_.ambient = Rgbd(0.2);
    material_.diffuse = Rgbd(0.0);
    material_.shininess = 0;
    material_.normal = ShadingNormal::fixed;
    while (words_.ok()) {
      const std::string_view command = words_.item();
      if (command.empty()) break;
      read_command(command);
      words_.end_item();
    }
    if (!has_size_)
      words_.fail("there is no size (expected size WIDTH HEIGHT)", "such as size 640 480, in the first line");
    if (!scene_.camera.fov)
      words_.fail("there is no camera (expected camera FROM AT UP FOV)", "such as camera 0 0 4 0 0 0 0 1 0 30");
    triangles_.put(scene_, names_);
    triangles_.warn(words_);
    if (!words_.ok()) return tl::unexpected(*words_.error());
    return SceneDocument{std::move(scene_), {}, words_.warnings()};
  }

 private:
  using Read = void (TestFormatReader::*)();
  struct FormatCommand {
    std::string_view word;
    Read read;
  };

  void read_command(std::string_view word) {
    using R = TestFormatReader;
    static constexpr std::array<FormatCommand, 24> commands{{
        {"size", &R::read_size},
        {"maxdepth", &R::read_maxdepth},
        {"output", &R::read_output},
        {"camera", &R::read_camera},
        {"sphere", &R::read_sphere},
        {"maxverts", &R::read_count},
        {"maxvertnorms", &R::read_count},
        {"vertex", &R::read_vertex},
        {"vertexnormal", &R::read_vertex_with_normal},
        {"tri", &R::read_triangle},
        {"trinormal", &R::read_smooth_triangle},
        {"translate", &R::read_translate},
        {"rotate", &R::read_rotate},
        {"scale", &R::read_scale},
        {"pushTransform", &R::push},
        {"popTransform", &R::pop},
        {"directional", &R::read_directional},
        {"point", &R::read_point},
        {"attenuation", &R::read_attenuation},
        {"ambient", &R::read_ambient},
        {"diffuse", &R::read_diffuse},
        {"specular", &R::read_specular},
        {"shininess", &R::read_shininess},
        {"emission", &R::read_emission},
    }};
    const auto known =
        std::find_if(commands.begin(), commands.end(), [&](const FormatCommand& each) { return each.word == word; });
    if (known != commands.end()) return (this->*known->read)();
    std::vector<std::string_view> all;
    for (const FormatCommand& each : commands) all.push_back(each.word);
    const std::string meant = word.size() <= 40 ? nearest_word(word, all) : std::string();
    words_.fail(
        fmt::format("unknown command {} (expected {})", word.size() <= 40 ? word : "of many letters", one_of(all)),
        meant.empty() ? "each line starts with a command; # starts a comment" : "did you mean " + meant + "?");
  }

  void read_size() {
    if (has_size_) return words_.fail("there is a second size (expected one)", "comment out all sizes but one");
    scene_.image.width = words_.whole("the width", schema::pixel_count);
    scene_.image.height = words_.whole("the height", schema::pixel_count);
    detail::check_image(scene_.image, words_);
    has_size_ = true;
  }
  void read_maxdepth() {
    scene_.limits.depth = 1 + words_.whole("the number of bounces", {0, schema::depth_count.high - 1});
  }
  void read_output() {
    while (!words_.word().empty()) continue;  // a name, with blanks in it or not
  }
  void read_count() { words_.whole("the number", {0, std::numeric_limits<int>::max()}); }

  void read_camera() {
    if (scene_.camera.fov)
      return words_.fail("there is a second camera (expected one)", "comment out all cameras but one");
    Camera& camera = scene_.camera;
    camera.eye = words_.point("from");
    camera.look_at = words_.point("at");
    camera.up = words_.direction("up");
    camera.fov = FieldOfView{words_.number("fov", view_angle), FovAxis::y};
    if (words_.ok()) detail::check_camera(camera, words_);
  }

  // --- State

  void read_ambient() { material_.ambient = words_.colour("the colour", reflectance); }
  void read_diffuse() { material_.diffuse = words_.colour("the colour", reflectance); }
  void read_specular() { material_.specular = material_.reflection = words_.colour("the colour", reflectance); }
  void read_shininess() { material_.shininess = words_.number("the shininess", not_negative); }
  void read_emission() { material_.emission = words_.colour("the colour"); }
  void read_attenuation() {
    attenuation_.constant = words_.number("the constant", not_negative);
    attenuation_.linear = words_.number("the linear term", not_negative);
    attenuation_.quadratic = words_.number("the quadratic term", not_negative);
    if (words_.ok() && attenuation_ == Attenuation{0, 0, 0})
      words_.fail_item("all three terms of the attenuation are 0 (expected at least one above 0)",
                       "1 0 0 is no attenuation");
  }

  void read_translate() { matrices_.back().append({Translate{words_.point("the way")}}); }
  void read_scale() {
    const Vec3d by = words_.point("the factor");
    if (words_.ok() && (by.x == 0 || by.y == 0 || by.z == 0))
      words_.fail_item("a factor is 0 (expected three others)", "0 would flatten what is scaled; try 1e-6");
    matrices_.back().append({Scale{by}});
  }
  void read_rotate() {
    const Vec3d axis = words_.direction("the axis");
    const double degrees = words_.number("the angle", coordinate);
    if (words_.ok()) matrices_.back().append({Rotate{axis, degrees}});
  }
  void push() {
    if (matrices_.size() > max_pushed)
      return words_.fail(fmt::format("too many pushTransform (expected at most {} open ones)", max_pushed),
                         "each pushTransform needs its popTransform");
    matrices_.push_back(matrices_.back());
  }
  void pop() {
    if (matrices_.size() == 1)
      return words_.fail("popTransform without a pushTransform (expected as many of both)",
                         "put a pushTransform before what it belongs to, or remove it");
    matrices_.pop_back();
  }
  /// The current matrix; fails if it cannot place an object.
  const Affine<double>& matrix() {
    const Affine<double>& m = matrices_.back().whole();
    if (words_.ok() && !inverse(m))
      words_.fail_item("the current matrix flattens the object, or its numbers have become too large",
                       "scale by less, and not to 0");
    return m;
  }

  // --- Lights

  void read_point() {
    const Vec3d position = matrices_.back().whole().point(words_.point("the position"));
    add_light({names_.next("Light"), words_.colour("the colour"), PointLight{position, attenuation_}}, position);
  }
  void read_directional() {
    const Vec3d towards = matrices_.back().whole().direction(words_.direction("the direction"));
    if (words_.ok() && length(towards) * schema::max_magnitude < 1)
      return words_.fail_item("the current matrix leaves the light no direction", "scale by more");
    add_light({names_.next("Light"), words_.colour("the colour"), DirectionalLight{towards}}, towards);
  }
  void add_light(Light light, const Vec3d& place) {
    if (!words_.ok()) return;
    if (!is_finite(place) || length(place) > schema::max_magnitude)
      return words_.fail_item("the current matrix puts the light too far away", "scale by less");
    scene_.lights.push_back(std::move(light));
  }

  // --- Objects

  void read_sphere() {
    const Vec3d centre = words_.point("the centre");
    const double radius = words_.number("the radius", above_zero);
    static_cast<void>(matrix());
    if (!words_.ok()) return;
    triangles_.put(scene_, names_);
    scene_.objects.push_back({names_.next("Sphere"), Shape<double>(Sphere<double>{centre, radius}), material_,
                              matrices_.back().object_steps()});
  }
  void read_vertex() { vertices_.push_back(words_.point("the position")); }
  void read_vertex_with_normal() {
    const Vec3d position = words_.point("the position"), normal = words_.point("the normal");
    smooth_vertices_.push_back({position, normal});
  }
  /// An index into a list of `size`.
  std::size_t index(std::size_t size) {
    if (size == 0 && words_.ok())
      words_.fail_item("there is no vertex yet (expected vertices above the triangles)",
                       "vertex belongs to tri, vertexnormal to trinormal");
    if (!words_.ok()) return 0;
    const int last = static_cast<int>(std::min(size, static_cast<std::size_t>(max_vertices))) - 1;
    return static_cast<std::size_t>(words_.whole("a vertex, counted from 0,", {0, last}));
  }
  void read_triangle() {
    const std::size_t a = index(vertices_.size()), b = index(vertices_.size()), c = index(vertices_.size());
    if (words_.ok()) add_triangle({{{vertices_[a]}, {vertices_[b]}, {vertices_[c]}}});
  }
  void read_smooth_triangle() {
    const std::size_t size = smooth_vertices_.size(), a = index(size), b = index(size), c = index(size);
    if (words_.ok()) add_triangle({smooth_vertices_[a], smooth_vertices_[b], smooth_vertices_[c]});
  }
  void add_triangle(std::array<detail::MeshCorner, 3> corners) {
    const Affine<double>& m = matrix();
    if (!words_.ok()) return;
    for (detail::MeshCorner& corner : corners) {
      corner = {m.point(corner.position), corner.normal == Vec3d(0.0) ? corner.normal : m.normal(corner.normal)};
      if (!is_finite(corner.position) || length(corner.position) > schema::max_magnitude || !is_finite(corner.normal) ||
          length(corner.normal) > schema::max_magnitude)
        return words_.fail_item("the current matrix puts the triangle too far away", "scale by less");
    }
    // If the matrix mirrors, corners are swapped so that the normal keeps its side (as with the inverse transpose).
    if (m.determinant() < 0) std::swap(corners[1], corners[2]);
    triangles_.add(scene_, names_, material_, corners);
  }

  WordReader words_;
  Scene scene_;
  detail::UniqueNames names_;
  detail::TriangleGatherer triangles_;
  Material material_;
  Attenuation attenuation_;
  std::vector<Matrices> matrices_{1};
  std::vector<Vec3d> vertices_;
  std::vector<detail::MeshCorner> smooth_vertices_;
  std::optional<Error> too_large_;
  bool has_size_ = false;
};

}  // namespace

Result<SceneDocument> parse_test_format(std::string_view text, const std::string& file_name) {
  if (const auto fine = detail::check_plain_text(text, file_name); !fine) return tl::unexpected(fine.error());
  return TestFormatReader(text, file_name).read();
}

}  // namespace raywalk
