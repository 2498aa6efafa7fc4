#pragma once
// Values that changed are replaced in a scene's text; all else in it stays. Internal to `io`.

#include "io/scene_values.h"
#include "io/toml_layout.h"

#include <string_view>

namespace raywalk::detail {

/// Collects the edits that make a text that holds `old` hold `now`. Lists of tables have as many elements in both
/// (rearrange_tables has seen to that).
void merge_values(const Layout& layout, std::string_view text, const Value& old, const Value& now, TextEdits& edits);

}  // namespace raywalk::detail
