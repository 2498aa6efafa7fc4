#pragma once
// Replaces changed values in a scene's text; everything else is kept. Internal to `io`.

#include "io/scene_values.h"
#include "io/toml_layout.h"

#include <string_view>

namespace raywalk::detail {

/// Collects the edits that change a text from `old` to `now`. Lists of tables have equally many elements in both
/// (rearrange_tables ensures that).
void merge_values(const TomlLayout& layout, std::string_view text, const Value& old, const Value& now,
                  TextEdits& edits);

}  // namespace raywalk::detail
