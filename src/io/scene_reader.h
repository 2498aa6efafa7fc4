#pragma once
// A parsed TOML table told to a scene's members. Internal to `io`; the interface is io/scene_file.h.

#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "io/scene_keys.h"
#include "text/toml.h"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk::detail {

/// What reading a whole file has come to. The first error is the one that is told; later ones may follow from it.
class ReadLog {
 public:
  /// Without `reads_meshes`, objects keep the names of their meshes' files and nothing else of them.
  ReadLog(std::string file, bool reads_meshes) : file_(std::move(file)), reads_meshes_(reads_meshes) {}

  void fail(const toml::source_region& where, std::string message, std::string hint);
  void warn(const toml::source_region& where, const std::string& message);
  /// False (and an error) when an object or light already has this name.
  void claim_name(const std::string& name, const toml::source_region& where);

  /// A mesh's file, named relative to the scene's; read once. Null (and an error) when it cannot be read, null too
  /// where meshes are not read.
  std::optional<MeshFile> mesh(const std::string& name, const toml::source_region& where);
  void define(const Group& group, const toml::source_region& where);
  /// Null when no group of this name stands above.
  [[nodiscard]] std::shared_ptr<const GroupContent> group(const std::string& name) const;
  [[nodiscard]] std::vector<std::string_view> group_names() const;

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::string file_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
  std::map<std::string, toml::source_index> names_;  ///< to the line of each
  bool reads_meshes_;
  std::map<std::string, MeshFile> meshes_;  ///< by file
  std::map<std::string, std::shared_ptr<const GroupContent>> groups_;
};

/// The `Fields` of scene_keys that reads: each call takes its key from one TOML table, checks it and stores it.
class SceneReader {
 public:
  /// `place` says in messages which table this is: "[camera]".
  SceneReader(const toml::table& table, ReadLog& log, std::string place)
      : table_(table), log_(log), place_(std::move(place)) {}

  void text(std::string_view key, std::string& value);
  void name(std::string_view key, std::string& value);
  void number(std::string_view key, double& value, const scene_keys::NumberRule& rule, scene_keys::Presence presence);
  void number_or_nothing(std::string_view key, std::optional<double>& value, const scene_keys::NumberRule& rule);
  void whole(std::string_view key, int& value, scene_keys::WholeRule rule);
  void whole_or_nothing(std::string_view key, std::optional<int>& value, scene_keys::WholeRule rule);
  /// Two numbers, or what they were when the key is left out.
  void pair(std::string_view key, double& first, double& second, const scene_keys::NumberRule& rule,
            std::string_view expected);
  /// The name of a file, which need not exist.
  void file(std::string_view key, std::string& value);
  void yes_or_no(std::string_view key, bool& value);
  void colour(std::string_view key, Rgbd& value);
  void point(std::string_view key, Vec3d& value, scene_keys::Presence presence);
  void direction(std::string_view key, Vec3d& value, scene_keys::Presence presence);
  void attenuation(std::string_view key, Attenuation& value);
  void corners(std::string_view key, std::vector<Vec2d>& value);
  void lengths(std::string_view key, Vec3d& value);
  /// A coordinate that is infinite when left out.
  void limit(std::string_view key, double& value);
  void points(std::string_view key, std::vector<Vec3d>& value);
  void holes(std::string_view key, std::vector<std::vector<Vec3d>>& value);
  void steps(std::string_view key, std::vector<TransformStep>& value);
  void motion(std::string_view key, Motion& value);
  void mesh_file(std::string_view key, MeshShape& value);
  void vertices(std::string_view positions, std::string_view triangles, std::string_view normals, std::string_view uv,
                MeshShape& value);
  void group_name(std::string_view key, Instance& value);
  void define(const Group& group) { log_.define(group, table_.source()); }
  /// What no single key can tell: fails at `key` with `message` unless `holds`.
  void check(bool holds, std::string_view key, std::string_view message, std::string_view hint);
  template <class Value>
  void choice(std::string_view key, Value& value);
  template <class... Kinds>
  void type(std::string_view key, std::variant<Kinds...>& value);
  template <class T>
  void table(std::string_view key, T& value, scene_keys::Presence presence);
  template <class T>
  void table_or_nothing(std::string_view key, std::optional<T>& value);
  template <class T>
  void tables(std::string_view key, std::vector<T>& value);
  /// Members that stand in this very table, all or none of them.
  template <class T>
  void together(std::optional<T>& value);

  /// Call once at the end: refuses keys that nobody asked for, then tells the first one that is missing.
  void finish();

 private:
  /// The value of `key`, or null where the file does not give it.
  const toml::node* take(std::string_view key, scene_keys::Presence presence);
  void fail(const toml::node& at, std::string_view key, const std::string& message, std::string hint);
  void fail_type(const toml::node& at, std::string_view key, const std::string& expected, std::string hint);
  std::optional<double> number_of(const toml::node& node, std::string_view key, const scene_keys::NumberRule& rule);
  /// The numbers of a list of `least` to `most` of them; empty after an error.
  std::vector<double> numbers_of(const toml::node& node, std::string_view key, const scene_keys::NumberRule& rule,
                                 std::size_t least, std::size_t most, const std::string& expected);
  std::vector<Vec3d> points_of(const toml::node& node, std::string_view key);
  /// The rows of a list of lists, `width` numbers each.
  std::vector<std::vector<double>> rows_of(const toml::node& node, std::string_view key, std::size_t width,
                                           const std::string& expected);
  std::optional<TransformStep> step_of(const toml::node& node, std::string_view key);
  /// The choice's index among `words`.
  std::optional<std::size_t> word_of(const toml::node& node, std::string_view key,
                                     const std::vector<std::string_view>& words);
  const toml::table* table_of(const toml::node& node, std::string_view key);
  const toml::array* tables_of(const toml::node& node, std::string_view key);
  void fail_without_type(std::string_view key, const std::vector<std::string_view>& words);
  [[nodiscard]] std::string place_of(std::string_view key) const;
  [[nodiscard]] std::string place_of_element(std::string_view key, std::size_t number) const;

  const toml::table& table_;
  ReadLog& log_;
  std::string place_;
  std::vector<std::string_view> known_, missing_;
  int found_ = 0;
};

// ---------------------------------------------------------------------------------------------------------------------

template <class Value>
void SceneReader::choice(std::string_view key, Value& value) {
  const auto& names = scene_keys::Names<Value>::all;
  std::vector<std::string_view> words;
  for (const auto& [each, word] : names) words.push_back(word);
  if (const toml::node* node = take(key, scene_keys::optional))
    if (const auto index = word_of(*node, key, words)) value = names[*index].first;
}

template <class... Kinds>
void SceneReader::type(std::string_view key, std::variant<Kinds...>& value) {
  const std::vector<std::string_view> words{scene_keys::type_name(Kinds{})...};
  const std::vector<std::variant<Kinds...>> kinds{Kinds{}...};
  const toml::node* node = take(key, scene_keys::optional);
  if (node == nullptr) return fail_without_type(key, words);
  const auto index = word_of(*node, key, words);
  if (!index) return;
  value = kinds[*index];
  std::visit([&](auto& kind) { scene_keys::describe(*this, kind); }, value);
}

template <class T>
void SceneReader::table(std::string_view key, T& value, scene_keys::Presence presence) {
  const toml::node* node = take(key, presence);
  if (node == nullptr) return;
  const toml::table* table = table_of(*node, key);
  if (table == nullptr) return;
  SceneReader inner(*table, log_, place_of(key));
  scene_keys::describe(inner, value);
  inner.finish();
}

template <class T>
void SceneReader::table_or_nothing(std::string_view key, std::optional<T>& value) {
  value.reset();
  if (!table_.contains(key)) {
    known_.push_back(key);
    return;
  }
  table(key, value.emplace(), scene_keys::optional);
}

template <class T>
void SceneReader::tables(std::string_view key, std::vector<T>& value) {
  value.clear();
  const toml::node* node = take(key, scene_keys::optional);
  const toml::array* array = node == nullptr ? nullptr : tables_of(*node, key);
  if (array == nullptr) return;
  for (const toml::node& element : *array) {
    if (log_.error()) return;  // a file of millions of wrong tables is refused at the first
    SceneReader inner(*element.as_table(), log_, place_of_element(key, value.size() + 1));
    scene_keys::describe(inner, value.emplace_back());
    inner.finish();
  }
}

template <class T>
void SceneReader::together(std::optional<T>& value) {
  const int found_before = found_;
  const std::size_t missing_before = missing_.size();
  scene_keys::describe(*this, value.emplace());
  if (found_ == found_before) {
    value.reset();
    missing_.resize(missing_before);
  }
}

}  // namespace raywalk::detail
