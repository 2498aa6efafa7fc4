#pragma once
// Updates a scene's text for lights and objects that were added, removed, renamed or moved. Internal to `io`.

#include "io/scene_values.h"
#include "io/toml_layout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::detail {

/// For each element of a new list, its counterpart in the old list, if any.
using Origins = std::vector<std::optional<std::size_t>>;

/// Matches tables by name; the others, and tables without names, with those that differ only in name, then with those
/// at the same place with the same type and at least half of their values equal.
[[nodiscard]] Origins pair_up(const Value& old_tables, const Value& new_tables);

/// Whether nothing was added, removed or moved.
[[nodiscard]] bool is_unchanged(const Origins& origins, std::size_t old_count);

/// Puts the [[key]] tables of a text into the new order: removed tables are deleted with their comments; new ones get
/// the text of their values; matched ones keep their old values. `tables`: their places, null if there are none.
void rearrange_tables(const TomlLayout& layout, std::string_view text, const LayoutNode* tables, const Value& now,
                      const Origins& origins, TextEdits& edits);

/// The same for the elements of a list in brackets.
void rearrange_list(std::string_view text, const LayoutNode& list, const Value& now, const Origins& origins,
                    TextEdits& edits);

}  // namespace raywalk::detail
