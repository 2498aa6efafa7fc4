// What meshes, groups and motion add to reading a scene.

#include "io/scene_reader.h"
#include "io/spelling.h"
#include "io/toml_text.h"

#include <fmt/format.h>

#include <limits>

namespace raywalk::detail {

namespace {

constexpr std::size_t most_rows = 1'000'000, most_keys = 10'000;
constexpr int most_nesting = 64;

}  // namespace

std::optional<MeshFile> ReadLog::mesh(const std::string& name, const toml::source_region& where) {
  if (!reads_meshes_) return std::nullopt;
  const std::string path = path_beside(file_, name), file = one_name(path);
  if (const auto known = meshes_.find(file); known != meshes_.end()) return known->second;
  auto read = read_mesh(path);
  if (!read) {
    // The mesh's own place is what helps; that the scene names it is told along.
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
  if (content->entries > most_entries)
    return fail(where,
                fmt::format("group {} comes to {:.3g} objects and triangles (expected at most {:g})",
                            toml_text::quoted(group.name), content->entries, most_entries),
                "groups of groups grow fast: use fewer instances, or smaller meshes");
  if (content->nesting > most_nesting)
    return fail(where,
                fmt::format("group {} nests {} deep (expected at most {})", toml_text::quoted(group.name),
                            content->nesting, most_nesting),
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

void SceneReader::group_name(std::string_view key, Instance& value) {
  const toml::node* node = take(key, scene_keys::required);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  if (text == nullptr) return fail_type(*node, key, "the name of a group in quotes", "such as group = \"tree\"");
  value.group = text->get();
  value.content = log_.group(value.group);
  if (value.content) return;
  const auto names = log_.group_names();
  const std::string nearest = nearest_word(value.group, names);
  fail(*node, key, fmt::format("there is no group {} above", toml_text::quoted(value.group.substr(0, 60))),
       !nearest.empty() ? "did you mean \"" + nearest + "\"?"
                        : "a [[group]] stands above what uses it: name = ..., then its [[group.object]] tables");
}

void SceneReader::mesh_file(std::string_view key, MeshShape& value) {
  const toml::node* node = take(key, scene_keys::optional);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  if (text == nullptr || text->get().empty() || text->get().size() > 4000 ||
      text->get().find('\0') != std::string::npos)
    return fail_type(*node, key, "the name of a mesh file in quotes", "such as file = \"bunny.ply\"");
  value.file = text->get();
  if (log_.error()) return;
  if (auto read = log_.mesh(value.file, node->source())) {
    value.mesh = read->mesh;
    value.materials = read->materials;
  }
}

std::vector<std::vector<double>> SceneReader::rows_of(const toml::node& node, std::string_view key, std::size_t width,
                                                      const std::string& expected) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() > most_rows) {
    fail_type(node, key, fmt::format("a list of at most {} of {}", most_rows, expected), "");
    return {};
  }
  std::vector<std::vector<double>> rows;
  for (const toml::node& element : *array) {
    rows.push_back(numbers_of(element, key, scene_keys::coordinate, width, width, expected));
    if (rows.back().empty()) return {};
  }
  return rows;
}

void SceneReader::vertices(std::string_view positions, std::string_view triangles, std::string_view normals,
                           std::string_view uv, MeshShape& value) {
  const toml::node *at = take(positions, scene_keys::optional), *of = take(triangles, scene_keys::optional),
                   *outwards = take(normals, scene_keys::optional), *texture = take(uv, scene_keys::optional);
  if (!value.file.empty()) {
    if (const toml::node* both = at ? at : of)
      fail(*both, at ? positions : triangles, "the mesh already has a file (expected only one of them)",
           "remove file or the vertices");
    return;
  }
  if (at == nullptr || of == nullptr)
    return log_.fail(table_.source(), fmt::format("{} has neither file nor vertices and triangles", place_),
                     "such as file = \"bunny.ply\", or vertices = [[0, 0, 0], ...] and triangles = [[0, 1, 2], ...]");
  auto mesh = std::make_shared<Mesh>();
  for (const auto& row : rows_of(*at, positions, 3, "[x, y, z]")) mesh->positions.emplace_back(row[0], row[1], row[2]);
  for (const auto& row : rows_of(*of, triangles, 3, "[a, b, c], which count the vertices from 0")) {
    Mesh::Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(row[i] >= 0 && row[i] < static_cast<double>(mesh->positions.size()) && row[i] == std::floor(row[i])))
        return fail(*of, triangles,
                    fmt::format("triangle {} names vertex {:g} (expected 0 to {})", mesh->triangles.size(), row[i],
                                mesh->positions.size() - 1),
                    "the first vertex is number 0");
      corners[i] = static_cast<std::int32_t>(row[i]);
    }
    mesh->triangles.push_back(corners);
  }
  if (outwards)
    for (const auto& row : rows_of(*outwards, normals, 3, "[x, y, z]"))
      mesh->normals.emplace_back(row[0], row[1], row[2]);
  if (texture)
    for (const auto& row : rows_of(*texture, uv, 2, "[u, v]")) mesh->uv.emplace_back(row[0], row[1]);
  if (log_.error()) return;
  if (outwards && mesh->normals.size() != mesh->positions.size())
    return fail(*outwards, normals,
                fmt::format("{} normals for {} vertices", mesh->normals.size(), mesh->positions.size()),
                "each vertex has one, in the same order; [0, 0, 0] for none");
  if (texture && mesh->uv.size() != mesh->positions.size())
    return fail(*texture, uv, fmt::format("{} texture points for {} vertices", mesh->uv.size(), mesh->positions.size()),
                "each vertex has one, in the same order");
  if (const std::string why = why_no_mesh(*mesh); !why.empty()) return fail(*of, triangles, why, "");
  if (const std::string why = why_unseen(*mesh); !why.empty()) log_.warn(of->source(), place_ + ": " + why);
  value.mesh = std::move(mesh);
}

void SceneReader::motion(std::string_view key, Motion& value) {
  value.clear();
  const toml::node* node = take(key, scene_keys::optional);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  const std::string hint =
      "such as motion = [[0, 0, 0, 0], [1, 2, 0, 0]]: from its place at the time 0 by 2 along x at 1";
  if (array == nullptr || array->size() > most_keys)
    return fail_type(*node, key, fmt::format("a list of at most {} keys [time, x, y, z]", most_keys), hint);
  for (const toml::node& element : *array) {
    const auto numbers = numbers_of(element, key, scene_keys::coordinate, 4, 4, "a key [time, x, y, z]");
    if (numbers.empty()) return;
    if (!value.empty() && !(numbers[0] > value.back().time))
      return fail(element, key,
                  fmt::format("the time {:g} does not come after {:g} (expected ascending times)", numbers[0],
                              value.back().time),
                  "list the keys in the order of their times");
    value.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
  }
}

}  // namespace raywalk::detail
