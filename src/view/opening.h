#pragma once
// What opens what a person names or drops on the window.

#include "view/action.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Whether this is meant to be a link, even if it has been cut off, and no path.
[[nodiscard]] bool means_link(std::string_view named);
/// The actions that open a link, a lesson by its folder, or else a file; what cannot be opened is told by whoever reads
/// it.
[[nodiscard]] std::vector<Action> opening_of(const State& state, const std::string& named);
/// The same of what was dropped or chosen together: the first scene among it and in its folders, which a mesh beside it
/// may belong to; else the first mesh, or else what is first.
[[nodiscard]] std::vector<Action> opening_among(const State& state, const std::vector<std::string>& paths);

}  // namespace raywalk
