#pragma once
// The commands about files, edits and what is selected. Included by gui/command_table.h.

#include "gui/command_row.h"

#include <GLFW/glfw3.h>

#include <array>

namespace raywalk {

inline constexpr std::array scene_rows{
    CommandRow{Command::new_scene, "new", TextId::menu_new, "", "start a new scene", {{{GLFW_KEY_N, true}}}},
    CommandRow{Command::open, "open", TextId::menu_open, "", "open a scene file", {{{GLFW_KEY_O, true}}}},
    CommandRow{Command::save, "save", TextId::menu_save, "", "write the scene to its file", {{{GLFW_KEY_S, true}}}},
    CommandRow{Command::save_as,
               "save-as",
               TextId::menu_save_as,
               "",
               "write the scene to another file",
               {{{GLFW_KEY_S, true, true}}}},
    CommandRow{Command::quit, "quit", TextId::menu_quit, "", "close the window", {{{GLFW_KEY_Q, true}}}},
    CommandRow{Command::undo, "undo", TextId::button_undo, "", "take the last change back", {{{GLFW_KEY_Z, true}}}},
    CommandRow{Command::redo,
               "redo",
               TextId::button_redo,
               "",
               "make the change again that was taken back",
               {{{GLFW_KEY_Y, true}, {GLFW_KEY_Z, true, true}}}},
    CommandRow{
        Command::remove,
        "remove",
        TextId::button_remove,
        "",
        "remove what is selected",
        {{{GLFW_KEY_DELETE, false, false, false, When::move}, {GLFW_KEY_BACKSPACE, false, false, false, When::move}}}},
    CommandRow{Command::deselect, "deselect", TextId::button_close, "", "select nothing; back to the code", {}},
    CommandRow{Command::select_next,
               "select-next",
               {},
               "Select next",
               "select the next thing",
               {{{GLFW_KEY_TAB, false, false, false, When::move}}}},
    CommandRow{Command::select_previous,
               "select-previous",
               {},
               "Select previous",
               "select the thing before",
               {{{GLFW_KEY_TAB, false, true, false, When::move}}}},
    CommandRow{
        Command::edit_properties,
        "edit-properties",
        TextId::properties,
        "",
        "type the numbers of what is selected; Tab goes from one to the next",
        {{{GLFW_KEY_ENTER, false, false, false, When::move}, {GLFW_KEY_KP_ENTER, false, false, false, When::move}}}},
    CommandRow{Command::add_solid_sphere,
               "add-solid-sphere",
               TextId::solid_sphere,
               "",
               "add a solid sphere",
               {{{GLFW_KEY_1, false, false, false, When::move}}}},
    CommandRow{Command::add_transparent_sphere,
               "add-transparent-sphere",
               TextId::transparent_sphere,
               "",
               "add a transparent sphere",
               {{{GLFW_KEY_2, false, false, false, When::move}}}},
    CommandRow{Command::add_polygon,
               "add-polygon",
               TextId::polygon,
               "",
               "add a polygon",
               {{{GLFW_KEY_3, false, false, false, When::move}}}},
    CommandRow{Command::add_light,
               "add-light",
               TextId::light_source,
               "",
               "add a light source",
               {{{GLFW_KEY_4, false, false, false, When::move}}}},
};

}  // namespace raywalk
