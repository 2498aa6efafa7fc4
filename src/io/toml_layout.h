#pragma once
// The places of everything in a TOML text, so that parts can be replaced and the rest be kept. The text must have been
// accepted by a TOML parser; otherwise scan_toml gives up. Internal to `io`.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::detail {

/// Characters of a text, `end` excluded.
struct Span {
  std::size_t begin = 0, end = 0;
};

inline constexpr std::size_t no_section = static_cast<std::size_t>(-1);

/// A value, a table or a list of tables.
struct LayoutNode {
  enum class Kind { scalar, list, table, tables };

  std::string key{};  ///< "" for an element of a list
  Kind kind = Kind::table;
  bool is_inline = false;            ///< a table in braces, or a value
  Span value{};                      ///< the characters of an inline value
  Span entry{};                      ///< of a key with a value: from the key's first character to the value's last
  std::size_t name_begin = 0;        ///< where in the entry the last part of a dotted key begins
  bool trailing_comma = false;       ///< of a list: a comma follows its last element
  std::size_t section = no_section;  ///< the section whose header opens this table
  std::vector<LayoutNode> children{};

  [[nodiscard]] const LayoutNode* find(std::string_view child_key) const;
  [[nodiscard]] bool has_entry() const { return entry.end > entry.begin; }
};

/// A header and what follows it, up to the next header. Section 0 has no header: it is the top of the file.
struct Section {
  std::size_t lead_begin = 0;    ///< of the comment lines directly above the header, or of the header
  std::size_t header_begin = 0;  ///< of the header's line
  std::size_t body_end = 0;      ///< after the line of the last key, or of the header where there is none
  std::size_t own_end = 0;       ///< after the comment lines directly below that
};

struct TomlLayout {
  LayoutNode root;
  std::vector<Section> sections;
};

[[nodiscard]] std::optional<TomlLayout> scan_toml(std::string_view text);

/// Of the line that contains `at`: its first character, and the one after its newline.
[[nodiscard]] std::size_t line_begin(std::string_view text, std::size_t at);
[[nodiscard]] std::size_t line_end(std::string_view text, std::size_t at);

/// The sections that opened `node` and its contents, in file order.
[[nodiscard]] std::vector<std::size_t> sections_of(const LayoutNode& node);

/// Replacements in a text, collected and applied together. They must not overlap; those at one place are applied in the
/// order of their addition.
class TextEdits {
 public:
  void replace(Span span, std::string text) { edits_.push_back({span, std::move(text)}); }
  void insert(std::size_t at, std::string text) { replace({at, at}, std::move(text)); }
  void remove(Span span) { replace(span, ""); }
  /// The text with all edits; nothing if two of them overlap.
  [[nodiscard]] std::optional<std::string> apply(std::string_view text) const;

 private:
  struct Edit {
    Span span;
    std::string text;
  };
  std::vector<Edit> edits_;
};

}  // namespace raywalk::detail
