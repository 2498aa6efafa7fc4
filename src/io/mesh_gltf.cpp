// glTF 2.0 (Khronos, ISO/IEC 12113:2022): the triangles of the default scene, each mesh placed by its nodes.

#include "io/mesh_gltf.h"
#include "math/transform.h"
#include "scene/schema_kinds.h"
#include "text/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string_view>

namespace raywalk {

namespace {

using detail::GltfFile;
using detail::Json;

constexpr int max_depth = 256;
constexpr std::int64_t max_nodes = 1'000'000;

constexpr std::array<std::string_view, 3> extensions_read{"KHR_materials_transmission", "KHR_materials_ior",
                                                          "KHR_materials_emissive_strength"};
bool is_read(std::string_view extension) {
  return std::find(extensions_read.begin(), extensions_read.end(), extension) != extensions_read.end();
}

/// The location of an accessor's elements: `width` numbers of one type each.
struct View {
  const unsigned char* data = nullptr;
  std::int64_t count = 0, stride = 0;
  int type = 0, width = 0;
  bool normalized = false;

  [[nodiscard]] double number(std::int64_t element, int component) const {
    const unsigned char* at = data + element * stride;
    const auto bits = [&](int size) {
      std::uint32_t value = 0;
      for (int i = 0; i < size; ++i) value |= std::uint32_t{at[component * size + i]} << (8 * i);
      return value;
    };
    switch (type) {
      case 5120:
        return scaled(static_cast<std::int8_t>(bits(1)), 127);
      case 5121:
        return scaled(bits(1), 255);
      case 5122:
        return scaled(static_cast<std::int16_t>(bits(2)), 32767);
      case 5123:
        return scaled(bits(2), 65535);
      case 5125:
        return bits(4);
      default:
        return static_cast<double>(std::bit_cast<float>(bits(4)));
    }
  }

 private:
  template <class Number>
  [[nodiscard]] double scaled(Number value, double full) const {
    const auto number = static_cast<double>(value);
    return normalized ? std::max(number / full, -1.0) : number;
  }
};

class GltfReader {
 public:
  GltfReader(const GltfFile& file, const std::string& path) : file_(file), path_(path), maps_(file, path) {}

  Result<MeshFile> read() {
    read_materials();
    read_scene();
    if (file_.failure()) return tl::unexpected(Error{path_, 0, 0, file_.failure()->message, file_.failure()->hint});
    if (!has_normals_) mesh_.normals.clear();
    if (!has_uv_) mesh_.uv.clear(), materials_ = without_maps_;
    if (const std::string why = detail::why_no_mesh(mesh_); !why.empty())
      return tl::unexpected(Error{path_, 0, 0, why, "only triangles are read, not lines, points or skins"});
    const bool has_materials = !materials_.empty();
    if (!has_materials) mesh_.materials.clear();
    MeshFile result = detail::finished_mesh(std::move(mesh_), path_);
    if (textured_ > 0)
      result.warnings.push_back(detail::warning_of_textures(path_, "some textures of this file", first_textured_.name,
                                                            first_textured_.texture, textured_ - 1));
    if (see_through_ > 0) result.warnings.push_back(warning_of_alpha());
    if (has_uv_ && !maps_.laid_otherwise().empty())
      result.warnings.push_back(
          fmt::format("{}: warning: samplers are not read in full: {}", path_, maps_.laid_otherwise()));
    if (has_colours_) result.warnings.push_back(detail::warning_of_colours(path_));
    if (has_materials) result.materials = std::make_shared<const std::vector<Material>>(std::move(materials_));
    return result;
  }

 private:
  void read_scene() {
    const Json& root = file_.json;
    if (const Json* required = file_.find(root, "extensionsRequired"); required && required->is_array())
      for (const Json& name : *required)
        if (!name.is_string() || !is_read(name.get_ref<const std::string&>()))
          return file_.fail(fmt::format("it needs the extension \"{}\" (expected none but {})",
                                        name.is_string() ? name.get_ref<const std::string&>().substr(0, 60) : "?",
                                        fmt::join(extensions_read, ", ")),
                            "export it without compression and without extensions");
    const Json* scenes = file_.find(root, "scenes");
    if (scenes == nullptr) {
      // Without a scene, all meshes as they are.
      for (std::int64_t i = 0; i < file_.size_of("meshes") && !file_.failure(); ++i) add_mesh(i, Affine<double>{});
      return;
    }
    const std::int64_t scene = file_.whole(root, "scene", 0);
    if (const Json* nodes = file_.find(file_.element("scenes", scene), "nodes"); nodes && nodes->is_array())
      for (const Json& node : *nodes)
        if (!file_.failure()) add_node(file_.index(node, "nodes"), Affine<double>{}, 0);
  }

  void add_node(std::int64_t index, const Affine<double>& outer, int depth) {
    if (++nodes_visited_ > max_nodes)
      return file_.fail(
          fmt::format(
              "its nodes come to more than they may when all that share children are spelt out (expected at most {})",
              max_nodes),
          "nodes that share nodes grow fast: use fewer of them");
    if (depth > max_depth)
      return file_.fail(
          fmt::format("its nodes are nested too deeply, or in a circle (expected at most {} deep)", max_depth),
          "no node may be its own child");
    const Json& node = file_.element("nodes", index);
    const Affine<double> map = outer * map_of(node);
    if (file_.find(node, "mesh")) add_mesh(file_.whole(node, "mesh", 0), map);
    if (const Json* children = file_.find(node, "children"); children && children->is_array())
      for (const Json& child : *children)
        if (!file_.failure()) add_node(file_.index(child, "children"), map, depth + 1);
  }

  Affine<double> map_of(const Json& node) {
    if (file_.find(node, "matrix")) {
      const auto m = file_.numbers<16>(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
      return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    const auto t = file_.numbers<3>(node, "translation", {0, 0, 0});
    const auto q = file_.numbers<4>(node, "rotation", {0, 0, 0, 1});
    const auto s = file_.numbers<3>(node, "scale", {1, 1, 1});
    const Vec3d axis(q[0], q[1], q[2]);
    const double w = q[3];
    // v + 2 w (a x v) + 2 a x (a x v), with a the vector of a unit quaternion.
    const auto turned = [&](const Vec3d& v) { return v + 2.0 * (w * cross(axis, v) + cross(axis, cross(axis, v))); };
    return {s[0] * turned({1, 0, 0}), s[1] * turned({0, 1, 0}), s[2] * turned({0, 0, 1}), {t[0], t[1], t[2]}};
  }

  void add_mesh(std::int64_t index, const Affine<double>& map) {
    const Json* primitives = file_.find(file_.element("meshes", index), "primitives");
    if (primitives == nullptr || !primitives->is_array())
      return file_.fail("a mesh without primitives (expected a list of them)", "the file is damaged");
    for (const Json& primitive : *primitives)
      if (!file_.failure()) add_primitive(primitive, map);
  }

  void add_primitive(const Json& primitive, const Affine<double>& map) {
    const std::int64_t mode = file_.whole(primitive, "mode", 4);
    if (mode < 4 || mode > 6) return;  // points and lines have no surface
    const Json* attributes = file_.find(primitive, "attributes");
    if (attributes == nullptr || !file_.find(*attributes, "POSITION"))
      return file_.fail("a mesh without positions (expected the attribute POSITION)", "the file is damaged");
    const View positions = view(file_.whole(*attributes, "POSITION", 0), 3);
    if (file_.failure()) return;
    const auto first = static_cast<std::int64_t>(mesh_.positions.size());
    if (first + positions.count > std::numeric_limits<std::int32_t>::max())
      return file_.fail("too many vertices", "the file is damaged");
    const auto end = static_cast<std::size_t>(first + positions.count);
    // Nodes may repeat a mesh arbitrarily often.
    constexpr double per_vertex = 2 * sizeof(Vec3d) + sizeof(Vec2d);
    if (end > mesh_.positions.capacity()) {
      if (const auto large =
              why_too_large({fmt::format("a mesh of more than {} vertices", end),
                             3 * per_vertex * static_cast<double>(end), "use fewer nodes, or coarser meshes"},
                            path_))
        return file_.fail(large->message, large->hint);
    }
    for (std::int64_t i = 0; i < positions.count; ++i)
      mesh_.positions.push_back(map.point({positions.number(i, 0), positions.number(i, 1), positions.number(i, 2)}));
    if (file_.find(*attributes, "NORMAL")) {
      const View normals = view(file_.whole(*attributes, "NORMAL", 0), 3, positions.count);
      for (std::int64_t i = 0; i < normals.count; ++i)
        mesh_.normals.push_back(map.normal({normals.number(i, 0), normals.number(i, 1), normals.number(i, 2)}));
      has_normals_ = true;
    }
    if (file_.find(*attributes, "TEXCOORD_0")) {
      const View uv = view(file_.whole(*attributes, "TEXCOORD_0", 0), 2, positions.count);
      for (std::int64_t i = 0; i < uv.count; ++i) mesh_.uv.emplace_back(uv.number(i, 0), uv.number(i, 1));
      has_uv_ = true;
    }
    has_colours_ = has_colours_ || file_.find(*attributes, "COLOR_0") != nullptr;
    mesh_.normals.resize(end, Vec3d(0.0));
    mesh_.uv.resize(end, Vec2d(0.0));
    add_triangles(primitive, mode, first, positions.count, map.determinant() < 0);
  }

  void add_triangles(const Json& primitive, std::int64_t mode, std::int64_t first, std::int64_t vertices,
                     bool mirrored) {
    View indices;
    const bool indexed = file_.find(primitive, "indices") != nullptr;
    if (indexed) {
      indices = view(file_.whole(primitive, "indices", 0), 1);
      if (indices.normalized || (indices.type != 5121 && indices.type != 5123 && indices.type != 5125))
        return file_.fail("the indices of a mesh are no whole numbers", "the file is damaged");
    }
    const std::int64_t count = indexed ? indices.count : vertices;
    const auto corner = [&](std::int64_t i) {
      const std::int64_t vertex = indexed ? static_cast<std::int64_t>(indices.number(i, 0)) : i;
      if (vertex >= 0 && vertex < vertices) return static_cast<std::int32_t>(first + vertex);
      file_.fail(fmt::format("a triangle names vertex {} (expected 0 to {})", vertex, vertices - 1),
                 "the file is damaged");
      return std::int32_t{0};
    };
    const std::int64_t material = file_.whole(primitive, "material", -1);
    if (material >= static_cast<std::int64_t>(materials_.size()))
      return file_.fail(fmt::format("a mesh names material {} (expected one of {})", material, materials_.size()),
                        "the file is damaged");
    const std::int64_t triangles = mode == 4 ? count / 3 : std::max<std::int64_t>(count - 2, 0);
    if (static_cast<double>(mesh_.triangles.size()) + static_cast<double>(triangles) > detail::max_entries)
      return file_.fail(fmt::format("too many triangles (expected at most {:g})", detail::max_entries),
                        "use a coarser mesh");
    for (std::int64_t t = 0; t < triangles && !file_.failure(); ++t) {
      Mesh::Corners corners = mode == 4    ? Mesh::Corners{corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)}
                              : mode == 6  ? Mesh::Corners{corner(0), corner(t + 1), corner(t + 2)}
                              : t % 2 == 0 ? Mesh::Corners{corner(t), corner(t + 1), corner(t + 2)}
                                           : Mesh::Corners{corner(t + 1), corner(t), corner(t + 2)};
      if (mirrored) std::swap(corners[1], corners[2]);
      mesh_.triangles.push_back(corners);
      mesh_.materials.push_back(static_cast<std::int32_t>(std::max<std::int64_t>(material, -1)));
    }
  }

  /// An accessor's elements, all of them inside their buffer.
  View view(std::int64_t index, int width, std::int64_t count = -1) {
    const Json& accessor = file_.element("accessors", index);
    const auto bad = [&](const std::string& what) {
      file_.fail(fmt::format("accessor {}: {}", index, what), "the file is damaged, or its program wrote it wrongly");
      return View{};
    };
    if (file_.find(accessor, "sparse")) return bad("sparse accessors are not read");
    const std::string type = file_.text(accessor, "type");
    if (type != (width == 1 ? "SCALAR" : width == 2 ? "VEC2" : "VEC3"))
      return bad(fmt::format("its type is not the one expected ({})", width == 1   ? "SCALAR"
                                                                      : width == 2 ? "VEC2"
                                                                                   : "VEC3"));
    View view;
    view.width = width;
    view.type = static_cast<int>(file_.whole(accessor, "componentType", 0));
    const std::int64_t size = view.type == 5120 || view.type == 5121   ? 1
                              : view.type == 5122 || view.type == 5123 ? 2
                              : view.type == 5125 || view.type == 5126 ? 4
                                                                       : 0;
    if (size == 0) return bad("unknown component type (expected 5120 to 5123, 5125 or 5126)");
    const Json* normalized = file_.find(accessor, "normalized");
    view.normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
    view.count = file_.whole(accessor, "count", -1);
    if (view.count < 0 || (count >= 0 && view.count != count))
      return bad(count < 0 ? "its count does not fit (expected 0 or more)"
                           : fmt::format("its count does not fit (expected {})", count));
    const Json& buffer_view = file_.element("bufferViews", file_.whole(accessor, "bufferView", -1));
    const std::string& bytes = file_.buffer(file_.whole(buffer_view, "buffer", -1));
    const std::int64_t view_offset = file_.whole(buffer_view, "byteOffset", 0),
                       view_length = file_.whole(buffer_view, "byteLength", -1),
                       offset = file_.whole(accessor, "byteOffset", 0);
    view.stride = file_.whole(buffer_view, "byteStride", size * width);
    const auto length = static_cast<std::int64_t>(bytes.size());
    if (view_offset < 0 || view_length < 0 || view_offset > length || view_length > length - view_offset)
      return bad(fmt::format("its view goes over the end of its buffer (expected to end within {} bytes)", length));
    if (view.stride < size * width || view.stride > 4096 || offset < 0 || offset > view_length)
      return bad(fmt::format("its offset or stride is wrong (expected a stride of {} to 4096 bytes)", size * width));
    const std::int64_t room = view_length - offset;
    if (view.count > 0 && (room < size * width || view.count - 1 > (room - size * width) / view.stride))
      return bad(
          fmt::format("its elements go over the end of their view (expected to end within {} bytes)", view_length));
    view.data = reinterpret_cast<const unsigned char*>(bytes.data()) + view_offset + offset;
    return view;
  }

  void read_materials() {
    for (std::int64_t i = 0; i < file_.size_of("materials"); ++i) {
      const Json& from = file_.element("materials", i);
      detail::GltfMaps::Factors factors;
      materials_.push_back(material_of(from, factors));
      without_maps_.push_back(materials_.back());
      const std::string texture = maps_.add_to(materials_.back(), from, factors);
      std::string name = GltfFile::text_or_none(from, "name");
      if (name.empty()) name = std::to_string(i);
      if (is_see_through(from) && ++see_through_ == 1) first_see_through_ = name;
      if (!texture.empty() && ++textured_ == 1) first_textured_ = {std::move(name), {}, texture};
    }
  }
  /// Whether its alpha, which is not read, lets something behind it show.
  [[nodiscard]] bool is_see_through(const Json& from) const {
    const std::string mode = GltfFile::text_or_none(from, "alphaMode");
    if (mode != "BLEND" && mode != "MASK") return false;
    const Json* pbr = file_.find(from, "pbrMetallicRoughness");
    return pbr != nullptr && (file_.find(*pbr, "baseColorTexture") != nullptr ||
                              file_.numbers<4>(*pbr, "baseColorFactor", {1, 1, 1, 1})[3] < 1);
  }
  [[nodiscard]] std::string warning_of_alpha() const {
    const std::size_t others = see_through_ - 1;
    const std::string more = others == 0 ? "" : fmt::format(", nor of {} other{}", others, others == 1 ? "" : "s");
    return fmt::format("{}: warning: alpha is not read: that of the material \"{}\"{}; such surfaces are opaque", path_,
                       first_see_through_.substr(0, 60), more);
  }

  /// The metallic part is a mirror, the weaker the rougher it is; the rest is matt, or glass as rough as it says, by
  /// the square of what glTF calls roughness.
  Material material_of(const Json& from, detail::GltfMaps::Factors& factors) {
    Material material;
    const Json empty = Json::object();
    const Json* found = file_.find(from, "pbrMetallicRoughness");
    const Json& pbr = found ? *found : empty;
    const auto base = file_.numbers<4>(pbr, "baseColorFactor", {1, 1, 1, 1});
    const double rough = file_.numbers<1>(pbr, "roughnessFactor", {1})[0];
    const double metallic = file_.numbers<1>(pbr, "metallicFactor", {1})[0], mirrored = metallic * (1 - rough);
    const auto emission = file_.numbers<3>(from, "emissiveFactor", {0, 0, 0});
    const auto colour = [](double x) { return std::clamp(x, 0.0, 1.0); };
    const Rgbd tint(colour(base[0]), colour(base[1]), colour(base[2]));
    double through = 0, strength = 1;  // of the emission
    if (const Json* extensions = file_.find(from, "extensions")) {
      if (const Json* transmission = file_.find(*extensions, "KHR_materials_transmission"))
        through = colour(file_.numbers<1>(*transmission, "transmissionFactor", {0})[0]);
      if (const Json* ior = file_.find(*extensions, "KHR_materials_ior"))
        material.ior = std::clamp(file_.numbers<1>(*ior, "ior", {1.5})[0], 1.0, 10.0);
      if (const Json* emissive = file_.find(*extensions, "KHR_materials_emissive_strength"))
        strength = file_.numbers<1>(*emissive, "emissiveStrength", {1})[0];
    }
    material.transmission = through * tint;
    material.reflection = (1 - through) * colour(mirrored) * tint;
    material.diffuse = (1 - through) * (1 - colour(mirrored)) * tint;
    const auto light = [&](double x) { return std::clamp(strength * x, 0.0, schema::light_amount.high); };
    material.emission = {light(emission[0]), light(emission[1]), light(emission[2])};
    material.dielectric = through > 0;
    if (through > 0) material.roughness = colour(rough) * colour(rough);
    factors = {tint, colour(metallic), colour(rough), through};
    return material;
  }

  const GltfFile& file_;
  const std::string& path_;
  detail::GltfMaps maps_;
  Mesh mesh_;
  std::vector<Material> materials_, without_maps_;
  NamedMaterial first_textured_;
  std::size_t textured_ = 0;  ///< materials with textures that are not read
  std::string first_see_through_;
  std::size_t see_through_ = 0;  ///< materials whose alpha is not read
  std::int64_t nodes_visited_ = 0;
  bool has_normals_ = false, has_uv_ = false, has_colours_ = false;
};

}  // namespace

Result<MeshFile> parse_gltf(std::string bytes, const std::string& path) {
  const auto file = detail::open_gltf(std::move(bytes), path);
  if (!file) return tl::unexpected(file.error());
  return GltfReader(*file, path).read();
}

}  // namespace raywalk
