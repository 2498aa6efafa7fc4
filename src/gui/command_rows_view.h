#pragma once
// The commands about what is looked at, and lessons. Included by gui/command_table.h.

#include "gui/command_row.h"

#include <GLFW/glfw3.h>

#include <array>

namespace raywalk {

inline constexpr std::array view_rows{
    CommandRow{Command::tab_image, "tab-image", {{{GLFW_KEY_I}}}},
    CommandRow{Command::tab_tree, "tab-tree", {{{GLFW_KEY_R}}}},
    CommandRow{Command::tab_stack, "tab-stack", {{{GLFW_KEY_K}}}},
    CommandRow{Command::tab_legend, "tab-legend", {{{GLFW_KEY_L}}}},
    CommandRow{Command::tab_cost, "tab-cost", {{{GLFW_KEY_F3}}}},
    CommandRow{Command::tab_equation, "tab-equation", {{{GLFW_KEY_E}}}},
    CommandRow{Command::zoom_in, "zoom-in", {{{GLFW_KEY_UP, false, false, true}}}},
    CommandRow{Command::zoom_out, "zoom-out", {{{GLFW_KEY_DOWN, false, false, true}}}},
    CommandRow{Command::fit, "fit", {{{GLFW_KEY_F}}}},
    CommandRow{Command::lines, "lines", {{{GLFW_KEY_V}}}},
    CommandRow{Command::ghosts, "ghosts", {{{GLFW_KEY_N}}}},
    CommandRow{Command::walk_strip, "walk-strip", {{{GLFW_KEY_S, false, false, false, When::trace}}}},
    CommandRow{Command::reset_view, "reset-view", {{{GLFW_KEY_O}}}},
    CommandRow{Command::use_camera, "use-camera", {{{GLFW_KEY_U}}}},
    CommandRow{Command::image_settings, "image-settings", {{{GLFW_KEY_COMMA}}}},
    CommandRow{Command::heat, "heat", {{{GLFW_KEY_G}}}},
    CommandRow{Command::cost_knobs, "cost-knobs", {{{GLFW_KEY_F3, false, true}}}},
    CommandRow{Command::cost_try, "cost-try", {{{GLFW_KEY_F4}}}},
    CommandRow{Command::cost_ladder, "cost-ladder", {{{GLFW_KEY_F4, false, true}}}},
    CommandRow{Command::cost_forget, "cost-forget", {{{GLFW_KEY_F4, true}}}},
    CommandRow{Command::cost_next, "cost-next", {{{GLFW_KEY_F5}}}},
    CommandRow{Command::cost_against, "cost-against", {{{GLFW_KEY_F5, false, true}}}},
    CommandRow{Command::cost_kind, "cost-kind", {{{GLFW_KEY_F6}}}},
    CommandRow{Command::cost_axis, "cost-axis", {{{GLFW_KEY_F7}}}},
    CommandRow{Command::cost_split_left, "cost-split-left", {{{GLFW_KEY_F8, false, true}}}},
    CommandRow{Command::cost_split_right, "cost-split-right", {{{GLFW_KEY_F8}}}},
    CommandRow{Command::cost_page, "cost-page", {{{GLFW_KEY_F9}}}},
    CommandRow{Command::tab_microscope, "tab-microscope", {{{GLFW_KEY_Y}}}},
    CommandRow{Command::magnify, "magnify", {{{GLFW_KEY_Z}}}},
    CommandRow{Command::diminish, "diminish", {{{GLFW_KEY_Z, false, true}}}},
    CommandRow{Command::to_numbers, "to-numbers", {{{GLFW_KEY_Z, false, false, true}}}},
    CommandRow{Command::to_scene, "to-scene", {{{GLFW_KEY_Z, false, true, true}}}},
    CommandRow{Command::numerics_robust, "numerics-robust", {{{GLFW_KEY_Q, false, true}}}},
    CommandRow{Command::numerics_naive, "numerics-naive", {{{GLFW_KEY_Q}}}},
    CommandRow{Command::precision_double, "precision-double", {{{GLFW_KEY_Q, false, true, true}}}},
    CommandRow{Command::precision_float, "precision-float", {{{GLFW_KEY_Q, false, false, true}}}},
    CommandRow{Command::turn_left, "turn-left", {{{GLFW_KEY_LEFT, false, true, true}}}},
    CommandRow{Command::turn_right, "turn-right", {{{GLFW_KEY_RIGHT, false, true, true}}}},
    CommandRow{Command::turn_up, "turn-up", {{{GLFW_KEY_UP, false, true, true}}}},
    CommandRow{Command::turn_down, "turn-down", {{{GLFW_KEY_DOWN, false, true, true}}}},
    CommandRow{Command::shift_left, "shift-left", {{{GLFW_KEY_LEFT, true, true}}}},
    CommandRow{Command::shift_right, "shift-right", {{{GLFW_KEY_RIGHT, true, true}}}},
    CommandRow{Command::shift_up, "shift-up", {{{GLFW_KEY_UP, true, true}}}},
    CommandRow{Command::shift_down, "shift-down", {{{GLFW_KEY_DOWN, true, true}}}},
    CommandRow{Command::approach, "approach", {{{GLFW_KEY_PAGE_UP, false, false, true}}}},
    CommandRow{Command::recede, "recede", {{{GLFW_KEY_PAGE_DOWN, false, false, true}}}},
    CommandRow{Command::theme, "theme", {{{GLFW_KEY_P}, {GLFW_KEY_D}}}},
    CommandRow{Command::language, "language", {{{GLFW_KEY_L, true}}}},
    CommandRow{Command::scale_up,
               "scale-up",
               {{{GLFW_KEY_KP_ADD, true}, {GLFW_KEY_EQUAL, true}, {GLFW_KEY_EQUAL, true, true}}}},
    CommandRow{Command::scale_down, "scale-down", {{{GLFW_KEY_MINUS, true}, {GLFW_KEY_KP_SUBTRACT, true}}}},
    CommandRow{Command::scale_reset, "scale-reset", {{{GLFW_KEY_0, true}, {GLFW_KEY_KP_0, true}}}},
    CommandRow{Command::exchange, "exchange", {{{GLFW_KEY_X}}}},
    CommandRow{Command::full_screen, "full-screen", {{{GLFW_KEY_F11}}}},
    CommandRow{Command::lessons, "lessons", {{{GLFW_KEY_F2}}}},
    CommandRow{Command::bugs, "bugs", {{{GLFW_KEY_F2, false, true}}}},
    CommandRow{Command::bug_surprise, "bug-surprise", {{{GLFW_KEY_F2, true}}}},
    CommandRow{
        Command::bug_mark,
        "bug-mark",
        {{{GLFW_KEY_ENTER, false, false, false, When::trace}, {GLFW_KEY_KP_ENTER, false, false, false, When::trace}}}},
    CommandRow{Command::bug_cure, "bug-cure", {{{GLFW_KEY_ENTER, false, true}}}},
    CommandRow{Command::bug_mend, "bug-mend", {{{GLFW_KEY_ENTER, false, false, true}}}},
    CommandRow{Command::menu, "menu", {{{GLFW_KEY_F10}}}},
};

}  // namespace raywalk
