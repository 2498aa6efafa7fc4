#pragma once
// The few words of the window itself that the catalogue of view/text.h does not have.

#include <string_view>

namespace raywalk::words {

inline constexpr std::string_view menu_walk = "Walk";
inline constexpr std::string_view keys = "Keys";
inline constexpr std::string_view scrub_hint = "Where the walk stands; drag to go anywhere";
inline constexpr std::string_view speed_hint = "How fast AUTO goes; it may be changed while it runs";
inline constexpr std::string_view scene_settings = "Scene";
inline constexpr std::string_view folder_up = "Up";
inline constexpr std::string_view folder_up_hint = "Go to the folder that holds this one";
inline constexpr std::string_view no_scene_here = "No scene (*.toml, *.nff, *.test) in this folder";
inline constexpr std::string_view folder_unreadable = "This folder cannot be read";
inline constexpr std::string_view swatch_hint = "Choose the colour";
inline constexpr std::string_view corners_hint = "Corners are dragged in the plan";

}  // namespace raywalk::words
