#pragma once
// Lights and objects that were added, removed, renamed or moved: their parts of a scene's text follow. Internal to
// `io`.

#include "io/scene_values.h"
#include "io/toml_layout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::detail {

/// For each element of a new list the element of the old list that it continues, if any.
using Origins = std::vector<std::optional<std::size_t>>;

/// Tables continue those of their name; of the others, those that are the same but for the name, then those at the same
/// place with the same type and at least half of their values the same.
[[nodiscard]] Origins pair_up(const Value& old_tables, const Value& new_tables);

/// Whether nothing was added, removed or moved.
[[nodiscard]] bool is_unchanged(const Origins& origins, std::size_t old_count);

/// Puts the [[key]] tables of a text into the new order: parts of removed tables go, with their comments; new ones get
/// the text of their values. What continues an old table keeps its old values. `tables` is where they stand, null
/// where there are none.
void rearrange_tables(const Layout& layout, std::string_view text, const LayoutNode* tables, const Value& now,
                      const Origins& origins, TextEdits& edits);

/// The same for the elements of a list in brackets.
void rearrange_list(std::string_view text, const LayoutNode& list, const Value& now, const Origins& origins,
                    TextEdits& edits);

}  // namespace raywalk::detail
