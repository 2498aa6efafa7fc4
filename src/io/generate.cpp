#include "io/generate.h"

#include "io/forest.h"
#include "math/elementary.h"
#include "math/random.h"
#include "shape/intersection.h"
#include "text/file.h"
#include "text/file_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>

namespace raywalk {

namespace {

constexpr int max_in_toml = 20'000;

/// Buffers text for writing; ignores further text after an error.
class Sink {
 public:
  explicit Sink(FileWriter& file) : file_(file) { buffer_.reserve(full + 4096); }

  template <class... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    flush_if(buffer_.size() >= full);
  }
  void bytes(const void* data, std::size_t size) {
    buffer_.append(static_cast<const char*>(data), size);
    flush_if(buffer_.size() >= full);
  }
  /// In little-endian order.
  template <class Number>
  void number(Number value) {
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes(raw.data(), raw.size());
  }
  [[nodiscard]] bool ok() const { return result_.has_value(); }
  [[nodiscard]] Result<void> finish() {
    flush_if(true);
    return result_;
  }

 private:
  static constexpr std::size_t full = std::size_t{1} << 20;
  void flush_if(bool wanted) {
    if (!wanted) return;
    if (result_) result_ = file_.write(buffer_);
    buffer_.clear();
  }

  FileWriter& file_;
  std::string buffer_;
  Result<void> result_;
};

/// Writes the parts of a scene as NFF or in our own format, where lights are as strong as NFF has them: of n together
/// sqrt(n) / 2.
class SceneSink {
 public:
  SceneSink(Sink& sink, bool toml) : sink_(sink), toml_(toml) {}

  void begin(const Vec3d& eye, const Vec3d& look_at, double fov, const std::string& title,
             const std::vector<Vec3d>& lights) {
    const auto count = static_cast<double>(lights.size());
    const double strength = std::sqrt(count) / (2 * count);
    if (toml_) {
      sink_.print(
          "title = \"{}\"\nbackground = [0.3, 0.45, 0.7]\nambient = {}\n\n[camera]\neye = [{}, {}, {}]\n"
          "look_at = [{}, {}, {}]\nfov = {}\nfov_axis = \"y\"\n\n[image]\nwidth = 512\nheight = 512\n",
          title, strength, eye.x, eye.y, eye.z, look_at.x, look_at.y, look_at.z, fov);
    } else {
      sink_.print(
          "# {}\nv\nfrom {} {} {}\nat {} {} {}\nup 0 0 1\nangle {}\nhither 0.01\nresolution 512 512\n"
          "b 0.3 0.45 0.7\n",
          title, eye.x, eye.y, eye.z, look_at.x, look_at.y, look_at.z, fov);
    }
    for (const Vec3d& p : lights) {
      if (toml_)
        sink_.print("\n[[light]]\nname = \"Light {}\"\ntype = \"point\"\nposition = [{}, {}, {}]\nstrength = {}\n",
                    &p - lights.data() + 1, p.x, p.y, p.z, strength);
      else
        sink_.print("l {} {} {}\n", p.x, p.y, p.z);
    }
  }
  void material(const Rgbd& c, double diffuse, double specular) {
    if (!toml_) return sink_.print("f {} {} {} {} {} 40 0 1\n", c.x, c.y, c.z, diffuse, specular);
    const Rgbd kd = diffuse * c;
    material_ = fmt::format(
        "material = {{ ambient = [{0}, {1}, {2}], diffuse = [{0}, {1}, {2}], specular = {3}, shininess = 40, "
        "reflection = {4} }}\n",
        kd.x, kd.y, kd.z, specular, specular);
  }
  void sphere(const Vec3d& c, double radius) {
    if (toml_)
      sink_.print(
          "\n[[object]]\nname = \"Sphere {}\"\ntype = \"sphere\"\ncentre = [{:.9g}, {:.9g}, {:.9g}]\nradius = "
          "{:.9g}\n{}",
          ++spheres_, c.x, c.y, c.z, radius, material_);
    else
      sink_.print("s {:.9g} {:.9g} {:.9g} {:.9g}\n", c.x, c.y, c.z, radius);
  }
  /// A square at height z about the axis.
  void floor(double half, double z) {
    if (toml_)
      sink_.print(
          "\n[[object]]\nname = \"Floor\"\ntype = \"flat_polygon\"\ncorners = [[{1}, {1}, {2}], [{0}, {1}, {2}], "
          "[{0}, {0}, {2}], [{1}, {0}, {2}]]\n{3}",
          -half, half, z, material_);
    else
      sink_.print("p 4  {1} {1} {2}  {0} {1} {2}  {0} {0} {2}  {1} {0} {2}\n", -half, half, z);
  }

 private:
  Sink& sink_;
  bool toml_;
  std::string material_;
  std::int64_t spheres_ = 0;
};

const std::array<Rgbd, 8> palette{Rgbd(0.85, 0.3, 0.25), Rgbd(0.9, 0.6, 0.2),   Rgbd(0.9, 0.85, 0.35),
                                  Rgbd(0.35, 0.7, 0.35), Rgbd(0.25, 0.6, 0.75), Rgbd(0.3, 0.35, 0.8),
                                  Rgbd(0.65, 0.35, 0.7), Rgbd(0.85, 0.85, 0.85)};

void write_spheres(const GenerateOptions& options, Sink& sink, SceneSink& scene) {
  scene.begin({2.6, -4.2, 2.2}, {0, 0, 0}, 32, fmt::format("{} spheres, seed {}", options.count, options.seed),
              {{5, -8, 9}, {-7, -3, 4}});
  // They share the cube, so a ray hits about equally many for any count.
  const double usual = 0.45 * portable::pow(8.0 / options.count, 1.0 / 3);
  const auto draw = [&](int sphere, std::uint32_t dimension) {
    return random_unit<double>({options.seed, sphere, 0, 0, 0, 0, dimension});
  };
  std::size_t colour = palette.size();
  for (int i = 0; i < options.count && sink.ok(); ++i) {
    const auto now = static_cast<std::size_t>(static_cast<std::int64_t>(i) * std::ssize(palette) / options.count);
    if (now != colour) {
      colour = now;
      const bool mirrors = colour + 1 == palette.size();
      scene.material(palette[colour], mirrors ? 0.4 : 0.9, mirrors ? 0.3 : 0);
    }
    const double x = draw(i, 0), y = draw(i, 1), z = draw(i, 2), size = draw(i, 3);
    scene.sphere({2 * x - 1, 2 * y - 1, 2 * z - 1}, usual * (0.25 + 0.75 * size));
  }
}

/// Nine spheres of a third of the size sit on `sphere`: six around it, three on top, as seen along `axis`.
void write_flake(Sink& sink, SceneSink& scene, const Vec3d& centre, double radius, const PlaneAxes<double>& across,
                 const Vec3d& axis, int levels) {
  scene.sphere(centre, radius);
  if (levels == 0 || !sink.ok()) return;
  const auto grow = [&](double turn, double height) {
    const double level = std::sqrt(1 - height * height);
    const Vec3d out = level * (portable::cos(turn) * across.u + portable::sin(turn) * across.v) + height * axis;
    const Vec3d u = normalize(cross(axis, out)), v = cross(out, u);
    write_flake(sink, scene, centre + (radius * 4 / 3) * out, radius / 3, {u, v}, out, levels - 1);
  };
  for (int i = 0; i < 6; ++i) grow(i * std::numbers::pi / 3, 0);
  for (int i = 0; i < 3; ++i) grow(std::numbers::pi / 6 + i * 2 * std::numbers::pi / 3, std::sqrt(2.0 / 3));
}

void write_flake(const GenerateOptions& options, Sink& sink, SceneSink& scene) {
  scene.begin({2.4, 1.5, 1.7}, {0, 0, 0.12}, 40, fmt::format("A sphereflake of {} levels", options.levels),
              {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}});
  scene.material({1, 0.75, 0.35}, 0.8, 0);
  scene.floor(12, -0.5);
  scene.material({1, 0.9, 0.7}, 0.4, 0.3);
  write_flake(sink, scene, {0, 0, 0}, 0.5, {{1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, options.levels);
}

/// A ball whose radius varies with latitude and longitude. Its triangles lie between `rings` circles of `around`
/// vertices, and two poles.
class BumpyBall {
 public:
  explicit BumpyBall(const GenerateOptions& options) {
    // Two rows of `around` triangles at the poles, and twice as many in each other row: 4 rings^2.
    rings_ = std::max(2, static_cast<int>(std::lround(std::sqrt(options.count / 4.0))));
    around_ = 2 * rings_;
    for (std::size_t i = 0; i < phases_.size(); ++i)
      phases_[i] = 2 * std::numbers::pi * random_unit<double>({options.seed, static_cast<std::int32_t>(i)});
  }
  [[nodiscard]] std::int64_t vertices() const { return std::int64_t{rings_} * around_ + 2; }
  [[nodiscard]] std::int64_t triangles() const { return std::int64_t{2} * rings_ * around_; }
  [[nodiscard]] Vec3d position(std::int64_t vertex) const {
    const auto [down, turn] = angles(vertex);
    return at(down, turn);
  }
  [[nodiscard]] Vec3d normal(std::int64_t vertex) const {
    constexpr double step = 1e-5;
    const auto [down, turn] = angles(vertex);
    if (vertex == 0 || vertex + 1 == vertices()) return {0, 0, vertex == 0 ? 1 : -1};
    return normalize(
        cross(at(down + step, turn) - at(down - step, turn), at(down, turn + step) - at(down, turn - step)));
  }
  /// Counter-clockwise seen from outside.
  [[nodiscard]] std::array<std::int64_t, 3> corners(std::int64_t triangle) const {
    const std::int64_t last = vertices() - 1;
    const auto vertex = [&](std::int64_t ring, std::int64_t place) {
      return ring < 0 ? 0 : ring >= rings_ ? last : 1 + ring * around_ + place % around_;
    };
    if (triangle < around_) return {0, vertex(0, triangle), vertex(0, triangle + 1)};
    if (triangle >= triangles() - around_) {
      const std::int64_t place = triangle - (triangles() - around_);
      return {last, vertex(rings_ - 1, place + 1), vertex(rings_ - 1, place)};
    }
    const std::int64_t rest = triangle - around_, ring = rest / (2 * around_), place = rest % (2 * around_) / 2;
    if (rest % 2 == 0) return {vertex(ring, place), vertex(ring + 1, place), vertex(ring + 1, place + 1)};
    return {vertex(ring, place), vertex(ring + 1, place + 1), vertex(ring, place + 1)};
  }

 private:
  struct Angles {
    double down, turn;
  };
  [[nodiscard]] Angles angles(std::int64_t vertex) const {
    if (vertex == 0) return {0, 0};
    if (vertex + 1 == vertices()) return {std::numbers::pi, 0};
    const std::int64_t ring = (vertex - 1) / around_, place = (vertex - 1) % around_;
    return {std::numbers::pi * static_cast<double>(ring + 1) / (rings_ + 1),
            2 * std::numbers::pi * static_cast<double>(place) / around_};
  }
  [[nodiscard]] Vec3d at(double down, double turn) const {
    const double flat = portable::sin(down);  // no bumps at the poles
    double radius = 1;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      const double waves = static_cast<double>(i) + 3;
      radius += flat * flat * 0.18 / waves * portable::sin(waves * turn + phases_[i]) *
                portable::cos(waves * down - phases_[i]);
    }
    return radius * Vec3d(flat * portable::cos(turn), flat * portable::sin(turn), portable::cos(down));
  }

  int rings_, around_;
  std::array<double, 5> phases_{};
};

void write_ply(const BumpyBall& ball, Sink& sink) {
  sink.print(
      "ply\nformat binary_little_endian 1.0\ncomment a ball with bumps, by raywalk generate\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      ball.vertices(), ball.triangles());
  for (std::int64_t i = 0; i < ball.vertices() && sink.ok(); ++i)
    for (const Vec3d& v : {ball.position(i), ball.normal(i)})
      for (int axis = 0; axis < 3; ++axis) sink.number(static_cast<float>(v[axis]));
  for (std::int64_t i = 0; i < ball.triangles() && sink.ok(); ++i) {
    sink.number(std::uint8_t{3});
    for (const std::int64_t corner : ball.corners(i)) sink.number(static_cast<std::int32_t>(corner));
  }
}

void write_obj(const BumpyBall& ball, Sink& sink) {
  sink.print("# a ball with bumps, by raywalk generate: {} vertices, {} triangles\n", ball.vertices(),
             ball.triangles());
  for (std::int64_t i = 0; i < ball.vertices() && sink.ok(); ++i) {
    const Vec3d p = ball.position(i), n = ball.normal(i);
    sink.print("v {:.7g} {:.7g} {:.7g}\nvn {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z, n.x, n.y, n.z);
  }
  for (std::int64_t i = 0; i < ball.triangles() && sink.ok(); ++i) {
    const auto c = ball.corners(i);
    sink.print("f {0}//{0} {1}//{1} {2}//{2}\n", c[0] + 1, c[1] + 1, c[2] + 1);
  }
}

void write_nff(const BumpyBall& ball, Sink& sink, SceneSink& scene) {
  scene.begin({2.6, -4.2, 2.2}, {0, 0, 0}, 32, fmt::format("A ball with bumps, of {} triangles", ball.triangles()),
              {{5, -8, 9}, {-7, -3, 4}});
  scene.material(palette[4], 0.9, 0);
  for (std::int64_t i = 0; i < ball.triangles() && sink.ok(); ++i) {
    sink.print("pp 3");
    for (const std::int64_t corner : ball.corners(i)) {
      const Vec3d p = ball.position(corner), n = ball.normal(corner);
      sink.print("  {:.7g} {:.7g} {:.7g} {:.4f} {:.4f} {:.4f}", p.x, p.y, p.z, n.x, n.y, n.z);
    }
    sink.print("\n");
  }
}

std::int64_t size_of(const GenerateOptions& options) {
  if (options.kind != GeneratedKind::flake) return options.count;
  std::int64_t spheres = 1;
  for (int level = 0; level < options.levels; ++level) spheres = 9 * spheres + 1;
  return spheres;
}

}  // namespace

std::optional<Error> why_not_generated(const GenerateOptions& options, const std::string& path) {
  const std::string ending = ending_of(path);
  if (options.kind == GeneratedKind::forest) return why_no_forest(options, path);
  const bool is_mesh = options.kind == GeneratedKind::mesh;
  const bool known = ending == ".nff" || (is_mesh ? ending == ".ply" || ending == ".obj" : ending == ".toml");
  if (!known)
    return Error{path, 0, 0,
                 fmt::format("{} (expected {})",
                             ending.empty() ? "the file name has no ending" : '"' + ending + "\" is no ending for this",
                             is_mesh ? ".ply, .obj or .nff" : ".nff or .toml"),
                 is_mesh ? "a scene takes a mesh in by its file" : ".nff is the shorter of the two"};
  if (ending == ".toml" && size_of(options) > max_in_toml)
    return Error{
        path, 0, 0,
        fmt::format("{} spheres are too many for a .toml (expected at most {})", size_of(options), max_in_toml),
        "write an .nff, which is made for that"};
  return std::nullopt;
}

Result<void> generate(const GenerateOptions& options, const std::string& path) {
  if (const auto error = why_not_generated(options, path)) return tl::unexpected(*error);
  if (options.kind == GeneratedKind::forest) return write_forest(options, path);
  FileWriter file;
  if (const auto opened = file.open(path); !opened) return opened;
  Sink sink(file);
  const std::string ending = ending_of(path);
  SceneSink scene(sink, ending == ".toml");
  switch (options.kind) {
    case GeneratedKind::spheres:
      write_spheres(options, sink, scene);
      break;
    case GeneratedKind::flake:
      write_flake(options, sink, scene);
      break;
    case GeneratedKind::mesh: {
      const BumpyBall ball(options);
      if (ending == ".ply") write_ply(ball, sink);
      if (ending == ".obj") write_obj(ball, sink);
      if (ending == ".nff") write_nff(ball, sink, scene);
      break;
    }
    case GeneratedKind::forest:
      break;
  }
  if (const auto written = sink.finish(); !written) return written;
  return file.commit();
}

}  // namespace raywalk
