// Wavefront OBJ and MTL (B. Martin Wright, "Object Files" and "MTL material format", Alias|Wavefront 1995).

#include "io/mesh_file.h"
#include "io/mesh_text.h"
#include "io/polygon_cut.h"
#include "scene/schema_kinds.h"
#include "text/file.h"
#include "text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <list>
#include <map>
#include <set>
#include <unordered_map>

namespace raywalk {

namespace {

/// Indices of one corner of a face, -1 for absent ones.
struct ObjCorner {
  std::int32_t position = -1, uv = -1, normal = -1;
  friend bool operator==(const ObjCorner&, const ObjCorner&) = default;
};
struct HashCorner {
  std::size_t operator()(const ObjCorner& corner) const {
    std::uint64_t key = 0;
    for (const std::int32_t index : {corner.position, corner.uv, corner.normal}) {
      key = (key ^ static_cast<std::uint32_t>(index)) * 0x9e3779b97f4a7c15U;
      key ^= key >> 32;
    }
    return static_cast<std::size_t>(key);
  }
};

/// The next word of a line; empty at its end, and where a comment begins.
std::string_view next_word(detail::TextCursor& cursor) {
  const std::string_view word = cursor.word();
  return word.starts_with('#') ? std::string_view() : word;
}

/// The name on the rest of a line, which may hold spaces, and a # as in "Material #25"; one that stands alone begins a
/// comment.
std::string name_of(detail::TextCursor& cursor) {
  std::string_view name = cursor.rest();
  for (std::size_t at = name.find('#'); at != std::string_view::npos; at = name.find('#', at + 1)) {
    const auto is_blank = [&](std::size_t i) { return i >= name.size() || name[i] == ' ' || name[i] == '\t'; };
    if (is_blank(at - 1) && is_blank(at + 1)) {
      name = name.substr(0, at);
      break;
    }
  }
  return std::string(name.substr(0, name.find_last_not_of(" \t") + 1));
}

class ObjReader {
  using Library = std::map<std::string, std::int32_t>;  ///< names of its materials, to their indices

 public:
  ObjReader(const std::string& bytes, const std::string& path) : path_(path), cursor_(bytes) {}

  Result<MeshFile> read() {
    do {
      if (!read_line()) return tl::unexpected(*error_);
    } while (cursor_.next_line());
    if (!has_normals_) mesh_.normals.clear();
    if (!has_uv_) mesh_.uv.clear();
    if (!has_materials_) mesh_.materials.clear();
    if (const std::string why = detail::why_no_mesh(mesh_); !why.empty())
      return tl::unexpected(Error{path_, 0, 0, why, "lines \"v X Y Z\" are vertices, lines \"f 1 2 3\" faces"});
    MeshFile file = detail::finished_mesh(std::move(mesh_), path_);
    if (!unknown_.empty()) file.warnings.push_back(warning_of_unknown());
    file.warnings.insert(file.warnings.end(), unread_textures_.begin(), unread_textures_.end());
    if (has_materials_) file.materials = std::make_shared<const std::vector<Material>>(std::move(materials_));
    return file;
  }

 private:
  bool fail(const std::string& message, const std::string& hint) {
    if (!error_) error_ = Error{path_, cursor_.line(), 0, message, hint};
    return false;
  }

  bool read_line() {
    const std::string_view keyword = next_word(cursor_);
    if (keyword == "v") {
      std::array<double, 3> xyz{};
      if (!numbers(xyz, 3, "v X Y Z")) return false;
      positions_.emplace_back(xyz[0], xyz[1], xyz[2]);
    } else if (keyword == "vn") {
      std::array<double, 3> xyz{};
      if (!numbers(xyz, 3, "vn X Y Z")) return false;
      normals_.emplace_back(xyz[0], xyz[1], xyz[2]);
    } else if (keyword == "vt") {
      std::array<double, 3> uv{};
      if (!numbers(uv, 1, "vt U V")) return false;
      uvs_.emplace_back(uv[0], uv[1]);
    } else if (keyword == "f" || keyword == "fo") {
      return read_face();
    } else if (keyword == "usemtl") {
      const std::string name = name_of(cursor_);
      material_ = material_named(name);
      if (material_ < 0) {
        if (unknown_.empty()) first_unknown_ = name, unknown_line_ = cursor_.line();
        unknown_.insert(name);
      }
    } else if (keyword == "mtllib") {
      return read_libraries(name_of(cursor_));
    }
    return true;  // names of parts, smoothing groups, curves and comments do not affect triangles
  }

  /// The numbers of a line: at least `least`; further ones are ignored.
  bool numbers(std::array<double, 3>& values, std::size_t least, std::string_view form) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string_view word = next_word(cursor_);
      if (word.empty() && i >= least) return true;
      const auto number = detail::number_in(word);
      if (!number)
        return fail(word.empty()
                        ? fmt::format("a number is missing (expected \"{}\")", form)
                        : fmt::format("\"{}\" is no finite number (expected \"{}\")", word.substr(0, 40), form),
                    "numbers are written like 1.5 or 2e-3");
      values[i] = *number;
    }
    return true;
  }

  /// One index of a corner: from 1, or backwards from the newest as -1. `count` are known so far; `form` is an example.
  bool read_index(std::string_view word, std::size_t count, std::string_view what, std::string_view form,
                  std::int32_t& index) {
    const auto number = detail::whole_in(word);
    const auto known = static_cast<std::int64_t>(count);
    if (word.empty())
      return fail(fmt::format("a corner of a face leaves its {} empty (expected a number)", what),
                  "a corner is 1, 1/2, 1//3 or 1/2/3: vertex, texture vertex and normal");
    if (known == 0)
      return fail(fmt::format("a face names {} {}, but the file has none so far (expected \"{}\" above it)", what,
                              word.substr(0, 40), form),
                  "faces stand below what they name");
    if (!number || *number == 0 || *number > known || *number < -known)
      return fail(
          fmt::format("a face names {} {} (expected 1 to {}, or -1 for the newest)", what, word.substr(0, 40), known),
          "faces stand below the vertices that they name, which are counted from 1");
    index = static_cast<std::int32_t>(*number > 0 ? *number - 1 : known + *number);
    return true;
  }

  bool read_corner(std::string_view word, ObjCorner& corner) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    if (!read_index(word.substr(0, slash), positions_.size(), "vertex", "v X Y Z", corner.position)) return false;
    if (slash == word.size()) return true;
    const std::string_view after = word.substr(slash + 1);
    const std::size_t second = std::min(after.find('/'), after.size());
    if (second > 0 && !read_index(after.substr(0, second), uvs_.size(), "texture vertex", "vt U V", corner.uv))
      return false;
    if (second == after.size()) return true;
    return read_index(after.substr(second + 1), normals_.size(), "normal", "vn X Y Z", corner.normal);
  }

  bool read_face() {
    face_.clear();
    for (std::string_view word = next_word(cursor_); !word.empty(); word = next_word(cursor_)) {
      ObjCorner corner;
      if (!read_corner(word, corner)) return false;
      face_.push_back(vertex_of(corner));
    }
    if (face_.size() < 3)
      return fail(fmt::format("a face of {} corners (expected 3 or more)", face_.size()), "such as \"f 1 2 3\"");
    if (!detail::add_face(mesh_, face_)) return fail(detail::too_many_corners(face_.size()), detail::hint_to_cut);
    mesh_.materials.resize(mesh_.triangles.size(), material_);
    has_materials_ = has_materials_ || material_ >= 0;
    return true;
  }

  std::int32_t vertex_of(const ObjCorner& corner) {
    const auto [entry, is_new] = vertices_.emplace(corner, static_cast<std::int32_t>(mesh_.positions.size()));
    if (!is_new) return entry->second;
    mesh_.positions.push_back(positions_[static_cast<std::size_t>(corner.position)]);
    mesh_.normals.push_back(corner.normal < 0 ? Vec3d(0.0) : normals_[static_cast<std::size_t>(corner.normal)]);
    mesh_.uv.push_back(corner.uv < 0 ? Vec2d(0.0) : uvs_[static_cast<std::size_t>(corner.uv)]);
    has_normals_ = has_normals_ || corner.normal >= 0;
    has_uv_ = has_uv_ || corner.uv >= 0;
    return entry->second;
  }

  [[nodiscard]] std::string warning_of_unknown() const {
    const std::size_t others = unknown_.size() - 1;
    const std::string more = others == 0 ? "" : fmt::format(", nor {} other{}", others, others == 1 ? "" : "s");
    return fmt::format("{}:{}: warning: no mtllib above has the material \"{}\"{}: such faces take the object's own",
                       path_, unknown_line_, first_unknown_.substr(0, 60), more);
  }

  /// The rest of a line: one name, which may hold spaces where there is such a file, or several. Those that Windows
  /// wrote have folders with backslashes.
  bool read_libraries(std::string names) {
    std::replace(names.begin(), names.end(), '\\', '/');
    std::error_code failed;
    const bool is_one =
        names.find_first_of(" \t") == std::string::npos || names.size() > longest_name ||
        (detail::stays_beside(names) && std::filesystem::exists(detail::path_beside(path_, names), failed));
    if (is_one) return read_library(names);
    detail::TextCursor words(names);
    for (std::string_view name = words.word(); !name.empty(); name = words.word())
      if (!read_library(std::string(name))) return false;
    return true;
  }
  bool read_library(const std::string& name) {
    if (name.size() > longest_name)
      return fail(
          fmt::format("the name of its materials has {} letters (expected at most {})", name.size(), longest_name),
          "a name of an MTL file stands after mtllib");
    if (!detail::stays_beside(name))
      return fail(fmt::format("its materials lie at \"{}\" (expected a file beside the mesh)", name.substr(0, 60)),
                  "nothing is read from elsewhere: copy the MTL file into the mesh's folder");
    const std::string path = detail::path_beside(path_, name);
    const auto [library, is_new] = libraries_.emplace(detail::one_name(path), Library{});
    Library* const now = &library->second;
    latest_.remove(now);  // few files, even with many lines
    latest_.push_front(now);
    if (!is_new) return true;
    constexpr std::size_t max_bytes = std::size_t{16} << 20;
    auto bytes = read_file(path, max_bytes);
    if (!bytes)
      return fail(fmt::format("its materials cannot be read: {}", bytes.error().message),
                  fmt::format("\"{}\" is looked for beside the mesh; remove the line mtllib to do without", name));
    auto read = parse_mtl(std::move(*bytes), path);
    if (!read) {
      error_ = read.error();
      return false;
    }
    const auto has_texture = [](const NamedMaterial& each) { return !each.texture.empty(); };
    if (const auto first = std::find_if(read->begin(), read->end(), has_texture); first != read->end()) {
      const auto others = static_cast<std::size_t>(std::count_if(first + 1, read->end(), has_texture));
      unread_textures_.push_back(detail::warning_of_textures(fmt::format("{}:{}", path, first->texture_line),
                                                             "textures of mesh files", first->name, first->texture,
                                                             others));
    }
    for (NamedMaterial& each : *read) {
      (*now)[std::move(each.name)] = static_cast<std::int32_t>(materials_.size());
      materials_.push_back(std::move(each.material));
    }
    return true;
  }
  /// The index of the material of this name in the most recently named library that has it; -1 for none.
  [[nodiscard]] std::int32_t material_named(const std::string& name) const {
    for (const Library* library : latest_)
      if (const auto found = library->find(name); found != library->end()) return found->second;
    return -1;
  }

  static constexpr std::size_t longest_name = 255;  // as of most file systems

  const std::string& path_;
  detail::TextCursor cursor_;
  std::vector<Vec3d> positions_, normals_;
  std::vector<Vec2d> uvs_;
  std::unordered_map<ObjCorner, std::int32_t, HashCorner> vertices_;
  std::vector<Material> materials_;
  std::map<std::string, Library> libraries_;  ///< by file; each is read once
  std::list<Library*> latest_;                ///< most recently named first
  std::int32_t material_ = -1;
  std::set<std::string> unknown_;             ///< materials that faces use and no library has
  std::vector<std::string> unread_textures_;  ///< a warning for each library that has some
  std::string first_unknown_;
  int unknown_line_ = 0;
  bool has_normals_ = false, has_uv_ = false, has_materials_ = false;
  std::vector<std::int32_t> face_;  ///< vertices of the one that is read
  Mesh mesh_;
  std::optional<Error> error_;
};

/// The final values of MTL's numbers, when a material is complete.
struct MtlMaterial {
  Material material;
  Rgbd filter{1.0};
  double opaque = 1;
  int illumination = 2;

  [[nodiscard]] Material finished() const {
    Material m = material;
    m.transmission = (1 - opaque) * filter;
    m.diffuse *= opaque;
    const int kind = illumination;
    if (kind < 2) m.specular = Rgbd(0.0);                   // no highlight
    if (kind >= 3 && kind <= 8) m.reflection = m.specular;  // these trace a reflected ray
    m.dielectric = kind == 5 || kind == 7;                  // Fresnel
    // Only illum 6 and 7 bend rays: what is dissolved otherwise is seen through straight. Of 5, Fresnel needs Ni.
    if (opaque < 1 && (kind < 5 || kind > 7)) m.ior = 1;
    return m;
  }
};

bool names_texture(std::string_view keyword) {
  return keyword.rfind("map_", 0) == 0 || keyword == "bump" || keyword == "disp" || keyword == "decal" ||
         keyword == "refl" || keyword == "norm";
}

}  // namespace

Result<std::vector<NamedMaterial>> parse_mtl(std::string bytes, const std::string& path) {
  if (const auto plain = make_plain_text(bytes, path); !plain) return tl::unexpected(plain.error());
  detail::TextCursor cursor(bytes);
  std::vector<NamedMaterial> named;
  MtlMaterial current;
  const auto finish = [&] {
    if (!named.empty()) named.back().material = current.finished();
  };
  do {
    const std::string keyword(next_word(cursor));
    if (keyword == "newmtl") {
      finish();
      constexpr std::size_t max_materials = 100'000;
      if (named.size() == max_materials)
        return tl::unexpected(Error{path, cursor.line(), 0,
                                    fmt::format("there are too many materials (expected at most {})", max_materials),
                                    "is this the right file?"});
      named.push_back({name_of(cursor), {}});
      current = {};
      current.material.diffuse = Rgbd(0.0);
      continue;
    }
    if (names_texture(keyword) && !named.empty() && named.back().texture.empty()) {
      named.back().texture = keyword + " " + std::string(cursor.rest());
      named.back().texture_line = cursor.line();
      continue;
    }
    const bool is_colour = keyword == "Ka" || keyword == "Kd" || keyword == "Ks" || keyword == "Ke" || keyword == "Tf";
    const bool is_number =
        keyword == "Ns" || keyword == "Ni" || keyword == "d" || keyword == "Tr" || keyword == "illum";
    if (!is_colour && !is_number) continue;  // extensions of other renderers
    const double most = keyword == "Ke" ? schema::light_amount.high
                        : is_colour     ? schema::reflectance.high
                                        : schema::max_magnitude;
    std::array<double, 3> values{};
    int count = 0;
    for (std::string_view word = next_word(cursor); !word.empty() && count < 3; word = next_word(cursor)) {
      if (word == "-halo") continue;
      const auto number = detail::number_in(word);
      if (!number || *number < 0 || *number > most)
        return tl::unexpected(
            Error{path, cursor.line(), 0,
                  fmt::format("{}: found \"{}\" (expected a number from 0 to {:g})", keyword, word.substr(0, 40), most),
                  "colours are given as three numbers, such as Kd 0.8 0.2 0.1"});
      values[static_cast<std::size_t>(count++)] = *number;
    }
    if (count == 0 || (is_colour && count == 2))
      return tl::unexpected(Error{path, cursor.line(), 0,
                                  fmt::format("{}: a number is missing (expected {})", keyword, is_colour ? "3" : "1"),
                                  is_colour ? "such as Kd 0.8 0.2 0.1" : "such as Ns 30"});
    const Rgbd colour = count == 3 ? Rgbd(values[0], values[1], values[2]) : Rgbd(values[0]);
    // Blender and others write Ka 1 1 1 for every surface: everything would be white in full ambient light.
    if (keyword == "Ka" && colour != Rgbd(1.0)) current.material.ambient = colour;
    if (keyword == "Kd") current.material.diffuse = colour;
    if (keyword == "Ks") current.material.specular = colour;
    if (keyword == "Ke") current.material.emission = colour;
    if (keyword == "Tf") current.filter = colour;
    if (keyword == "Ns") current.material.shininess = values[0];
    if (keyword == "Ni" && values[0] >= 1e-15) current.material.ior = values[0];
    if (keyword == "d") current.opaque = std::min(values[0], 1.0);
    if (keyword == "Tr") current.opaque = 1 - std::min(values[0], 1.0);
    if (keyword == "illum") current.illumination = static_cast<int>(std::min(values[0], 10.0));
  } while (cursor.next_line());
  finish();
  return named;
}

Result<MeshFile> parse_obj(std::string bytes, const std::string& path) {
  if (const auto plain = make_plain_text(bytes, path); !plain) return tl::unexpected(plain.error());
  return ObjReader(bytes, path).read();
}

}  // namespace raywalk
