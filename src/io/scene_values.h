#pragma once
// A scene as the tree of keys and values of its file. Internal to `io`; the interface is io/scene_file.h.

#include "scene/schema.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::detail {

/// A key's value. Two trees are equal if their numbers are, bit for bit, however they are written.
struct Value {
  enum class Kind {
    scalar,  ///< `text`
    list,    ///< children without keys, scalars or lists
    table,   ///< children with keys
    tables,  ///< children without keys, tables
  };
  using Shorthand = schema::Shorthand;

  std::string key{};
  Kind kind = Kind::scalar;
  std::string text{};  ///< as TOML
  std::vector<Value> children{};
  Shorthand shorthand = Shorthand::none;
  bool is_default = false;  ///< may be omitted

  /// Whether what could be omitted before cannot be now, though it is the same: another key has changed.
  [[nodiscard]] bool must_now_be_stated(const Value& now) const { return is_default && !now.is_default; }

  friend bool operator==(const Value& a, const Value& b) {
    return a.key == b.key && a.kind == b.kind && a.text == b.text && a.children == b.children;
  }
  /// The child of this key, or null.
  [[nodiscard]] const Value* find(std::string_view child_key) const;
};

/// All of `scene` and of what is drawn over it, including the values that a file may omit.
[[nodiscard]] Value values_of(const Scene& scene, const Ink& ink = {});
/// Whether all values of two files are the same, without the memory for either.
[[nodiscard]] bool have_same_values(schema::SceneFile a, schema::SceneFile b);

/// The value on one line, a table in braces, without defaults.
[[nodiscard]] std::string inline_text(const Value& value);
/// The lines under a table's header: its values other than defaults, then its tables under their own headers. `path` is
/// the header's name, "" for the whole file.
[[nodiscard]] std::string section_text(const Value& table, const std::string& path);

/// The text of a new file. Objects are listed one by one, until it is longer than `most`: then it breaks off.
struct SceneText {
  std::string text{};
  std::size_t objects = 0;  ///< that stand in it
};
[[nodiscard]] SceneText scene_text(schema::SceneFile file, std::size_t most);

}  // namespace raywalk::detail
