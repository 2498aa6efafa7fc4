#pragma once
// The few words of the window itself that the catalogue of view/text.h does not have.

#include <string_view>

namespace raywalk::words {

inline constexpr std::string_view menu_walk = "Walk";
inline constexpr std::string_view menu_panels = "Panels";
inline constexpr std::string_view plan = "Plan";
inline constexpr std::string_view keys = "Keys";
inline constexpr std::string_view image_settings = "The 3-D picture";
inline constexpr std::string_view settings = "Settings";
inline constexpr std::string_view settings_hint =
    "How the picture is made; heat maps of what it costs and how noisy it is";
inline constexpr std::string_view integrator = "Integrator";
inline constexpr std::string_view accelerator = "Accelerator";
inline constexpr std::string_view cost_knobs = "What to try";
inline constexpr std::string_view cost_reference = "reference";
inline constexpr std::string_view cost_split = "Split";
inline constexpr std::string_view cost_difference = "Difference";
inline constexpr std::string_view cost_rays = "Against rays";
inline constexpr std::string_view cost_tests = "Against tests";
inline constexpr std::string_view cost_seconds = "Against time";
inline constexpr std::string_view sampler = "Sampler";
inline constexpr std::string_view light_grid = "Rays to a light: n x n";
inline constexpr std::string_view tolerance = "Tolerance";
inline constexpr std::string_view samples = "Samples of a pixel";
inline constexpr std::string_view precision = "Precision";
inline constexpr std::string_view numerics = "Numerics";
inline constexpr std::string_view epsilon = "Epsilon";
inline constexpr std::string_view cost_effects = "Effects";
inline constexpr std::string_view cost_tries = "Tries";
inline constexpr std::string_view magnification_hint = "How close; the wheel over the drawing does the same";
inline constexpr std::string_view double_ = "double";
inline constexpr std::string_view single = "float";
inline constexpr std::string_view heat = "Heat map";
inline constexpr std::string_view walk_samples = "Samples walked";
inline constexpr std::string_view heat_none = "none";
inline constexpr std::string_view heat_rays = "rays of each pixel";
inline constexpr std::string_view heat_tests = "nodes and shapes tested";
inline constexpr std::string_view heat_time = "time";
inline constexpr std::string_view heat_noise = "noise of its samples";
inline constexpr std::string_view image_hint =
    "Drag to turn, with Shift or the right button to move, wheel to zoom; click a pixel to walk its rays";
inline constexpr std::string_view scrub_hint = "Where the walk stands; drag to go anywhere";
inline constexpr std::string_view speed_hint = "How fast AUTO goes; it may be changed while it runs";
inline constexpr std::string_view scene_settings = "Scene";
inline constexpr std::string_view folder_up = "Up";
inline constexpr std::string_view folder_up_hint = "Go to the folder that holds this one";
inline constexpr std::string_view no_scene_here = "No scene (*.toml, *.nff, *.test) in this folder";
inline constexpr std::string_view folder_unreadable = "This folder cannot be read";
inline constexpr std::string_view swatch_hint = "Choose the colour";
inline constexpr std::string_view breakpoints = "Where to come to rest";
inline constexpr std::string_view breakpoints_hint =
    "Before lines of code: click left of a line, or press Ctrl+B. AUTO, Run on and steps longer than a line stop "
    "there.";
inline constexpr std::string_view breakpoint_hint = "Come to rest before this line, or no longer";
inline constexpr std::string_view mark_hint = "This line is at fault";
inline constexpr std::string_view breakpoints_off = "This step of the lesson passes all breakpoints.";
inline constexpr std::string_view at_depth = "At DEPTH (0: none)";
inline constexpr std::string_view at_pixel = "At pixel (-1: none)";
inline constexpr std::string_view at_object = "At a hit of";
inline constexpr std::string_view at_total = "Total reflection";
inline constexpr std::string_view nowhere = "nowhere";
inline constexpr std::string_view remove_breakpoints = "Remove all";
inline constexpr std::string_view go_to_step = "Go to step";
inline constexpr std::string_view status_hint = "Go to a step by its number";
inline constexpr std::string_view equation_empty =
    "Take a step: here stands what the line computes, with the numbers of the ray.";
inline constexpr std::string_view short_image = "3-D";
inline constexpr std::string_view short_tree = "Tree";
inline constexpr std::string_view short_microscope = "Scope";
inline constexpr std::string_view corners_hint = "Corners are dragged in the plan";

}  // namespace raywalk::words
