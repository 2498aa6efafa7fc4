// Reads the scene keys of meshes, groups and motion.

#include "io/scene_reader.h"
#include "text/spelling.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <memory>

namespace raywalk::detail {

namespace {

constexpr int max_nesting = 64;

}  // namespace

std::optional<MeshFile> ReadLog::mesh(const std::string& name, const toml::source_region& where) {
  if (!reads_meshes_) return std::nullopt;
  const std::string path = path_beside(file_, name), file = one_name(path);
  if (const auto known = meshes_.find(file); known != meshes_.end()) return known->second;
  auto read = read_mesh(path);
  if (!read) {
    // The place in the mesh file helps most; the scene's reference to it is mentioned too.
    const Error& error = read.error();
    if (error.line == 0 && error.message.find(" at byte ") == std::string::npos)
      fail(where, fmt::format("file {}: {}", toml_text::quoted(name), error.message), error.hint);
    else if (!error_)
      error_ = error;
    return std::nullopt;
  }
  warnings_.insert(warnings_.end(), read->warnings.begin(), read->warnings.end());
  return meshes_.emplace(file, std::move(*read)).first->second;
}

void ReadLog::define(const Group& group, const toml::source_region& where) {
  if (error_) return;
  auto content = std::make_shared<const GroupContent>(group);
  if (content->entries > max_copied)
    return fail(where,
                fmt::format("group {} comes to {:.3g} objects and triangles (expected at most {:g})",
                            toml_text::quoted(group.name), content->entries, max_copied),
                "groups of groups grow fast: use fewer instances, or smaller meshes");
  if (content->nesting > max_nesting)
    return fail(where,
                fmt::format("group {} nests {} deep (expected at most {})", toml_text::quoted(group.name),
                            content->nesting, max_nesting),
                "put more objects into one group");
  groups_[group.name] = std::move(content);
}

std::shared_ptr<const GroupContent> ReadLog::group(const std::string& name) const {
  const auto found = groups_.find(name);
  return found == groups_.end() ? nullptr : found->second;
}

std::vector<std::string_view> ReadLog::group_names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, content] : groups_) names.push_back(name);
  return names;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::GroupName& kind, Instance& value) {
  const auto* text = node.as_string();
  if (text == nullptr) {
    fail_type(node, key, kind.expected(), "such as group = \"tree\"");
    return false;
  }
  value.group = text->get();
  value.content = log_.group(value.group);
  if (value.content) return true;
  const auto names = log_.group_names();
  const std::string nearest = nearest_word(value.group, names);
  fail(node, key, fmt::format("there is no group {} above", toml_text::quoted(value.group.substr(0, 60))),
       !nearest.empty() ? "did you mean \"" + nearest + "\"?"
                        : "a [[group]] stands above what uses it: name = ..., then its [[group.object]] tables");
  return false;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::MeshRows& kind,
                       MeshShape& /*value*/) {
  using Part = schema::MeshRows::Part;
  Mesh& mesh = own_mesh_;
  if (kind.part == Part::uv) return read(node, key, kind.rows, mesh.uv);
  if (kind.part != Part::triangles)
    return read(node, key, kind.rows, kind.part == Part::normals ? mesh.normals : mesh.positions);
  std::vector<Vec3d> rows;
  if (!read(node, key, kind.rows, rows)) return false;
  for (const Vec3d& row : rows) {
    for (const double corner : {row.x, row.y, row.z}) {
      // complete() reports a mesh without vertices.
      if (mesh.positions.empty() ||
          (corner >= 0 && corner < static_cast<double>(mesh.positions.size()) && corner == std::floor(corner)))
        continue;
      fail(node, key,
           fmt::format("triangle {} names vertex {:g} (expected 0 to {})", mesh.triangles.size(), corner,
                       mesh.positions.size() - 1),
           "the first vertex is number 0");
      return false;
    }
    if (!mesh.positions.empty())
      mesh.triangles.push_back(
          {static_cast<std::int32_t>(row.x), static_cast<std::int32_t>(row.y), static_cast<std::int32_t>(row.z)});
  }
  return true;
}

void SceneReader::complete(MeshShape& mesh) {
  if (log_.error()) return;
  const toml::node *vertices = table_.get("vertices"), *triangles = table_.get("triangles");
  if (!mesh.file.empty()) {
    if (vertices != nullptr || triangles != nullptr)
      return fail(vertices ? *vertices : *triangles, vertices ? "vertices" : "triangles",
                  "the mesh already has a file (expected only one of them)", "remove file or the vertices");
    if (auto read = log_.mesh(mesh.file, table_.get("file")->source())) {
      mesh.mesh = read->mesh;
      mesh.materials = read->materials;
    }
    return;
  }
  if (vertices == nullptr || triangles == nullptr) {
    broken_ = [this] {
      log_.fail(table_.source(), fmt::format("{} has neither file nor vertices and triangles", place_),
                "such as file = \"bunny.ply\", or vertices = [[0, 0, 0], ...] and triangles = [[0, 1, 2], ...]");
    };
    return;
  }
  const auto is_one_each = [&](std::string_view key, std::size_t count, std::string_view what, std::string_view hint) {
    if (table_.contains(key) && count != own_mesh_.positions.size())
      fail(*table_.get(key), key, fmt::format("{} {} for {} vertices", count, what, own_mesh_.positions.size()),
           std::string(hint));
  };
  is_one_each("normals", own_mesh_.normals.size(), "normals",
              "each vertex has one, in the same order; [0, 0, 0] for none");
  is_one_each("uv", own_mesh_.uv.size(), "texture points", "each vertex has one, in the same order");
  if (log_.error()) return;
  if (const std::string why = why_no_mesh(own_mesh_); !why.empty()) fail(*triangles, "triangles", why, "");
  if (const std::string why = why_unseen(own_mesh_); !why.empty()) log_.warn(triangles->source(), place_ + ": " + why);
  mesh.mesh = std::make_shared<const Mesh>(std::move(own_mesh_));
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Rows& kind, Motion& value) {
  if (!read<MotionKey>(node, key, kind, value)) return false;
  for (std::size_t i = 1; i < value.size(); ++i) {
    if (value[i].time > value[i - 1].time) continue;
    fail(*node.as_array()->get(i), key,
         fmt::format("the time {:g} does not come after {:g} (expected ascending times)", value[i].time,
                     value[i - 1].time),
         "list the keys in the order of their times");
    return false;
  }
  return true;
}

}  // namespace raywalk::detail
