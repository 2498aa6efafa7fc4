#pragma once
// Reads a scene's members from parsed TOML tables. Internal to `io`; the interface is io/scene_file.h.

#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "scene/schema.h"
#include "text/toml.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace raywalk::detail {

/// The state of reading a whole file. Only the first error is kept; later ones may follow from it.
class ReadLog {
 public:
  /// Without `reads_meshes`, objects keep only the names of their mesh files.
  ReadLog(std::string file, bool reads_meshes) : file_(std::move(file)), reads_meshes_(reads_meshes) {}

  void fail(const toml::source_region& where, std::string message, std::string hint);
  void warn(const toml::source_region& where, const std::string& message);
  /// An error when an object or light already has this name.
  void claim_name(const std::string& name, const toml::source_region& where);
  /// Remembers where the scene names a file first.
  void claim_file(const std::string& name, const toml::source_region& where);
  /// An error of such a file, at that place; any other as it is.
  [[nodiscard]] Error where_named(Error error) const;

  /// A mesh file, relative to the scene's; read once. Null (and an error) if it cannot be read; null too if meshes are
  /// not read.
  std::optional<MeshFile> mesh(const std::string& name, const toml::source_region& where);
  void define(const Group& group, const toml::source_region& where);
  /// Null if no group of this name has been defined before.
  [[nodiscard]] std::shared_ptr<const GroupContent> group(const std::string& name) const;
  [[nodiscard]] std::vector<std::string_view> group_names() const;

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::string file_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
  std::map<std::string, toml::source_index> names_;  ///< with the line of each
  struct Named {
    std::string name;
    toml::source_position at;
  };
  std::map<std::filesystem::path, Named> files_;  ///< by path
  bool reads_meshes_;
  std::map<std::string, MeshFile> meshes_;  ///< by file
  std::map<std::string, std::shared_ptr<const GroupContent>> groups_;
};

/// The `Fields` of the schema for reading: takes each key from one TOML table, checks its value and stores it.
class SceneReader {
 public:
  /// `place` names the table in messages: "[camera]".
  SceneReader(const toml::table& table, ReadLog& log, std::string place)
      : table_(table), log_(log), place_(std::move(place)) {}

  void about(std::string_view /*sentence*/) {}
  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view /*sentence*/ = {}) {
    if (const toml::node* node = take(name)) read(*node, name, kind, value);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view /*sentence*/ = {});
  template <class T, class Kind>
  void required(std::string_view name, T& value, const Kind& kind, std::string_view sentence = {}) {
    if (!table_.contains(name)) missing_.push_back(name);
    key(name, value, kind, sentence);
  }
  template <class T>
  void left_out(std::string_view name, T& value, const T& usual) {
    if (!table_.contains(name)) value = usual;
  }
  void without(std::string_view name, std::string_view message, std::string_view hint) {
    if (const toml::node* node = table_.get(name)) fail(*node, name, std::string(message), std::string(hint));
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view sentence);
  template <class T>
  void together(std::optional<T>& value);
  void check(std::string_view key, bool holds, std::string_view message, std::string_view hint);
  template <class Why>
  void check(std::string_view key, const Why& why, std::string_view hint) {
    if (log_.error() || !missing_.empty()) return;
    const std::string message = why();
    check(key, message.empty(), message, hint);
  }
  void complete(MeshShape& mesh);
  void complete(const Group& group) { log_.define(group, table_.source()); }

  /// Call once at the end: refuses unknown keys, reports the first missing one, or else the first broken rule, which
  /// may be only a consequence of these.
  void finish();

 private:
  /// The value of `key`, or null if absent.
  const toml::node* take(std::string_view key);
  void fail(const toml::node& at, std::string_view key, const std::string& message, std::string hint);
  void fail_type(const toml::node& at, std::string_view key, const std::string& expected, std::string_view hint);

  // Stores the value of `node`, or fails and leaves the old one.
  bool read(const toml::node& node, std::string_view key, const schema::Number& kind, double& value);
  bool read(const toml::node& node, std::string_view key, const schema::Whole& kind, int& value);
  bool read(const toml::node& node, std::string_view key, const schema::Flag& kind, bool& value);
  bool read(const toml::node& node, std::string_view key, const schema::Text& kind, std::string& value);
  bool read(const toml::node& node, std::string_view key, const schema::OneLine& kind, std::string& value);
  bool read(const toml::node& node, std::string_view key, const schema::Name& kind, std::string& value);
  bool read(const toml::node& node, std::string_view key, const schema::Names& kind, std::vector<std::string>& value);
  bool read(const toml::node& node, std::string_view key, const schema::FileName& kind, std::string& value);
  bool read(const toml::node& node, std::string_view key, const schema::GroupName& kind, Instance& value);
  bool read(const toml::node& node, std::string_view key, const schema::MeshRows& kind, MeshShape& value);
  bool read(const toml::node& node, std::string_view key, const schema::Steps& kind, std::vector<TransformStep>& value);
  bool read(const toml::node& node, std::string_view key, const schema::Rows& kind, Motion& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Choice<T>& kind, T& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Tuple& kind, T& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Rows& kind, std::vector<T>& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Lists& kind, std::vector<T>& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Table& kind, T& value);
  template <class T>
  bool read(const toml::node& node, std::string_view key, const schema::Tables& kind, std::vector<T>& value);

  /// The numbers of a tuple, at most `count`; fewer only if the kind allows it. Empty after an error.
  std::vector<double> numbers_of(const toml::node& node, std::string_view key, const schema::Tuple& kind,
                                 std::size_t count);
  bool to_direction(const toml::node& node, std::string_view key, Vec3d& value);
  /// The list of a key of Rows; null after an error.
  const toml::array* rows_of(const toml::node& node, std::string_view key, const schema::Rows& kind);
  bool step_of(const toml::node& node, std::string_view key, TransformStep& value);
  /// The word's index among `words`.
  std::optional<std::size_t> word_of(const toml::node& node, std::string_view key,
                                     const std::vector<std::string_view>& words);
  const toml::table* table_of(const toml::node& node, std::string_view key);
  const toml::array* tables_of(const toml::node& node, std::string_view key);
  void fail_without_type(const std::vector<std::string_view>& words);
  [[nodiscard]] std::string place_of(std::string_view key) const;
  [[nodiscard]] std::string place_of_element(std::string_view key, std::size_t number) const;

  const toml::table& table_;
  ReadLog& log_;
  std::string place_;
  std::vector<std::string_view> known_, missing_;
  int found_ = 0;
  std::function<void()> broken_;  ///< reports the first broken rule
  Mesh own_mesh_;                 ///< of the lists in this table
};

// ---------------------------------------------------------------------------------------------------------------------

template <class T, class Kind>
void SceneReader::key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view /*sentence*/) {
  value.reset();
  const toml::node* node = take(name);
  if (T given{}; node != nullptr && read(*node, name, kind, given)) value = std::move(given);
}

template <class... Kinds>
void SceneReader::type(std::variant<Kinds...>& value, std::string_view /*sentence*/) {
  const std::vector<std::string_view> words{schema::type_name(Kinds{})...};
  const std::vector<std::variant<Kinds...>> kinds{Kinds{}...};
  const toml::node* node = take("type");
  if (node == nullptr) return fail_without_type(words);
  const auto index = word_of(*node, "type", words);
  if (!index) return;
  value = kinds[*index];
  std::visit([&](auto& kind) { schema::describe(*this, kind); }, value);
}

template <class T>
void SceneReader::together(std::optional<T>& value) {
  const int found_before = found_;
  const std::size_t missing_before = missing_.size();
  schema::describe(*this, value.emplace());
  if (found_ == found_before) {
    value.reset();
    missing_.resize(missing_before);
  }
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Choice<T>& /*kind*/, T& value) {
  const auto index = word_of(node, key, all_words<T>());
  if (index) value = words_of<T>[*index].first;
  return index.has_value();
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Tuple& kind, T& value) {
  T given{};
  std::size_t count = 0, next = 0;
  schema::each_number(given, [&](double&) { ++count; });
  const std::vector<double> numbers = numbers_of(node, key, kind, count);
  if (numbers.empty()) return false;
  schema::each_number(given, [&](double& number) { number = next < numbers.size() ? numbers[next++] : 0.0; });
  if constexpr (std::is_same_v<T, Vec3d>)
    if (kind.is_direction && !to_direction(node, key, given)) return false;
  value = given;
  return true;
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Rows& kind, std::vector<T>& value) {
  value.clear();
  const toml::array* rows = rows_of(node, key, kind);
  if (rows == nullptr) return false;
  for (const toml::node& row : *rows)
    if (!read(row, key, kind.row, value.emplace_back())) return false;
  return true;
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Lists& kind, std::vector<T>& value) {
  value.clear();
  const toml::array* lists = node.as_array();
  if (lists == nullptr) fail_type(node, key, kind.expected(), "such as [[[0, 0, 1], ...]]");
  for (std::size_t i = 0; lists != nullptr && i < lists->size(); ++i)
    if (!read(*lists->get(i), key, kind.rows, value.emplace_back())) return false;
  return lists != nullptr;
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Table& /*kind*/, T& value) {
  const toml::table* table = table_of(node, key);
  if (table == nullptr) return false;
  SceneReader inner(*table, log_, place_of(key));
  schema::describe(inner, value);
  inner.finish();
  return true;
}

template <class T>
bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Tables& /*kind*/,
                       std::vector<T>& value) {
  value.clear();
  const toml::array* array = tables_of(node, key);
  if (array == nullptr) return false;
  for (const toml::node& element : *array) {
    if (log_.error()) return false;  // a file of millions of wrong tables is refused at the first one
    SceneReader inner(*element.as_table(), log_, place_of_element(key, value.size() + 1));
    schema::describe(inner, value.emplace_back());
    inner.finish();
  }
  return true;
}

}  // namespace raywalk::detail
