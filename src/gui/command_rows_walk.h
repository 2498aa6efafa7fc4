#pragma once
// The commands for modes and the walk. Included by gui/command_table.h.

#include "gui/command_row.h"

#include <GLFW/glfw3.h>

#include <array>

namespace raywalk {

inline constexpr std::array walk_rows{
    CommandRow{Command::mode_move, "mode-move", {{{GLFW_KEY_M}}}},
    CommandRow{Command::mode_trace, "mode-trace", {{{GLFW_KEY_T}}}},
    CommandRow{Command::mode_help, "mode-help", {{{GLFW_KEY_F1}, {GLFW_KEY_H}}}},
    CommandRow{Command::step,
               "step",
               {{{GLFW_KEY_SPACE},
                 {GLFW_KEY_RIGHT, false, false, false, When::trace},
                 {GLFW_KEY_PAGE_DOWN, false, false, false, When::trace}}}},
    CommandRow{
        Command::step_back,
        "step-back",
        {{{GLFW_KEY_LEFT, false, false, false, When::trace}, {GLFW_KEY_PAGE_UP, false, false, false, When::trace}}}},
    CommandRow{Command::step_ray,
               "step-ray",
               {{{GLFW_KEY_RIGHT, false, true, false, When::trace}, {GLFW_KEY_SPACE, false, true}}}},
    CommandRow{Command::step_ray_back, "step-ray-back", {{{GLFW_KEY_LEFT, false, true, false, When::trace}}}},
    CommandRow{Command::step_pixel,
               "step-pixel",
               {{{GLFW_KEY_RIGHT, true, false, false, When::trace}, {GLFW_KEY_SPACE, true}}}},
    CommandRow{Command::step_pixel_back, "step-pixel-back", {{{GLFW_KEY_LEFT, true, false, false, When::trace}}}},
    CommandRow{Command::step_over, "step-over", {{{GLFW_KEY_DOWN, false, false, false, When::trace}}}},
    CommandRow{Command::step_back_over, "step-back-over", {{{GLFW_KEY_DOWN, false, true, false, When::trace}}}},
    CommandRow{Command::step_out, "step-out", {{{GLFW_KEY_UP, false, false, false, When::trace}}}},
    CommandRow{Command::step_back_out, "step-back-out", {{{GLFW_KEY_UP, false, true, false, When::trace}}}},
    CommandRow{Command::run_on, "run-on", {{{GLFW_KEY_W}}}},
    CommandRow{Command::run_back, "run-back", {{{GLFW_KEY_W, false, true}}}},
    CommandRow{Command::break_here, "break-here", {{{GLFW_KEY_B, true}}}},
    CommandRow{Command::breakpoints, "breakpoints", {{{GLFW_KEY_B}, {GLFW_KEY_J}}}},
    CommandRow{Command::play, "play", {{{GLFW_KEY_A}}}},
    CommandRow{Command::clear, "clear", {{{GLFW_KEY_C}}}},
    CommandRow{Command::first, "first", {{{GLFW_KEY_HOME}}}},
    CommandRow{Command::last, "last", {{{GLFW_KEY_END}}}},
    CommandRow{Command::slower, "slower", {{{GLFW_KEY_MINUS}, {GLFW_KEY_KP_SUBTRACT}}}},
    CommandRow{Command::faster, "faster", {{{GLFW_KEY_KP_ADD}, {GLFW_KEY_EQUAL}, {GLFW_KEY_EQUAL, false, true}}}},
    CommandRow{Command::grain_line, "grain-line", {{{GLFW_KEY_1, false, false, false, When::not_move}}}},
    CommandRow{Command::grain_ray, "grain-ray", {{{GLFW_KEY_2, false, false, false, When::not_move}}}},
    CommandRow{Command::grain_pixel, "grain-pixel", {{{GLFW_KEY_3, false, false, false, When::not_move}}}},
};

}  // namespace raywalk
