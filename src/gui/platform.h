#pragma once
// What the desktop and a page of a browser do each in its own way: gui/desktop has one file for it, gui/web another.

#include "gui/workers.h"

#include <string>

struct GLFWwindow;

namespace raywalk::platform {

/// Tells GLFW what else the next window needs.
void hint_window();
/// The first line of the shaders that ImGui draws with.
[[nodiscard]] const char* shading_language();
/// Makes ImGui's current context copy to the system's clipboard and paste from it.
void connect_clipboard();
/// Calls `dropped` with the paths of what is dropped on the window, where GLFW tells of it. A page takes it by itself.
void hear_drops(GLFWwindow* window, void (*dropped)(GLFWwindow* window, int count, const char** paths));
/// Makes the window as large as what it stands in, if that decides.
void follow_surroundings(GLFWwindow* window);
/// The key, GLFW_KEY_*, by what is written on it, where GLFW tells its place on an American keyboard.
[[nodiscard]] int key_written(int key, int scan_code);
/// Whether the user did something that polling cannot report before the current work ends.
[[nodiscard]] bool input_waits();
void toggle_full_screen(GLFWwindow* window);
/// Whether the program can end itself; a page cannot.
[[nodiscard]] bool can_quit();
/// Whether the user's files come through a chooser of the system's, and not by their paths.
[[nodiscard]] bool has_file_chooser();
/// The folder that ~ stands for in a path; empty where there is none.
[[nodiscard]] std::string home_folder();
/// Shows it. What is chosen is opened later.
void choose_files();
[[nodiscard]] Workers& workers();
/// The licences of what is built in, "== NAME ==" above each; empty where nothing is.
[[nodiscard]] const std::string& licences();

}  // namespace raywalk::platform
