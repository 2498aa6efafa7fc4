#pragma once
// The commands for files, edits and the selection. Included by gui/command_table.h.

#include "gui/command_row.h"

#include <GLFW/glfw3.h>

#include <array>

namespace raywalk {

inline constexpr std::array scene_rows{
    CommandRow{Command::new_scene, "new", {{{GLFW_KEY_N, true}}}},
    CommandRow{Command::open, "open", {{{GLFW_KEY_O, true}}}},
    CommandRow{Command::save, "save", {{{GLFW_KEY_S, true}}}},
    CommandRow{Command::save_as, "save-as", {{{GLFW_KEY_S, true, true}}}},
    CommandRow{Command::quit, "quit", {{{GLFW_KEY_Q, true}}}},
    CommandRow{Command::undo, "undo", {{{GLFW_KEY_Z, true}}}},
    CommandRow{Command::redo, "redo", {{{GLFW_KEY_Y, true}, {GLFW_KEY_Z, true, true}}}},
    CommandRow{
        Command::remove,
        "remove",
        {{{GLFW_KEY_DELETE, false, false, false, When::move}, {GLFW_KEY_BACKSPACE, false, false, false, When::move}}}},
    CommandRow{Command::deselect, "deselect", {}},
    CommandRow{Command::select_next, "select-next", {{{GLFW_KEY_TAB, false, false, false, When::move}}}},
    CommandRow{Command::select_previous, "select-previous", {{{GLFW_KEY_TAB, false, true, false, When::move}}}},
    CommandRow{
        Command::edit_properties,
        "edit-properties",
        {{{GLFW_KEY_ENTER, false, false, false, When::move}, {GLFW_KEY_KP_ENTER, false, false, false, When::move}}}},
    CommandRow{Command::add_solid_sphere, "add-solid-sphere", {{{GLFW_KEY_1, false, false, false, When::move}}}},
    CommandRow{
        Command::add_transparent_sphere, "add-transparent-sphere", {{{GLFW_KEY_2, false, false, false, When::move}}}},
    CommandRow{Command::add_polygon, "add-polygon", {{{GLFW_KEY_3, false, false, false, When::move}}}},
    CommandRow{Command::add_light, "add-light", {{{GLFW_KEY_4, false, false, false, When::move}}}},
};

}  // namespace raywalk
