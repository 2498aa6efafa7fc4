#include "gui/platform.h"

#include "gui/desktop/monitor.h"

#include <GLFW/glfw3.h>

#include <cstdlib>
#include <cstring>

namespace raywalk::platform {

void hint_window() {
  // A presenter who clicks into the notes goes on showing the walk on the whole of another screen.
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
}

const char* shading_language() { return "#version 150"; }

void connect_clipboard() {}  // ImGui's GLFW backend has done so

void hear_drops(GLFWwindow* window, void (*dropped)(GLFWwindow* window, int count, const char** paths)) {
  glfwSetDropCallback(window, dropped);
}

void follow_surroundings(GLFWwindow* /*window*/) {}

int key_written(int key, int scan_code) {
  // Digits stay in their row, where French and Czech keyboards write them with Shift; other keys have one name.
  const bool is_digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;
  const bool prints = key > GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2 && !is_digit;
  const char* const written = prints ? glfwGetKeyName(key, scan_code) : nullptr;
  if (written == nullptr || std::strlen(written) != 1) return key;  // Greek letters have the places of the Latin ones
  const char c = *written;
  if (c == '+') return GLFW_KEY_EQUAL;  // as in gui/key.h
  if (c >= 'a' && c <= 'z') return GLFW_KEY_A + (c - 'a');
  return c <= GLFW_KEY_GRAVE_ACCENT ? c : key;  // GLFW's numbers are those of ASCII
}

bool input_waits() { return false; }

void toggle_full_screen(GLFWwindow* window) {
  static struct {
    int x = 0, y = 0, width = 0, height = 0;
  } before;
  if (glfwGetWindowMonitor(window) != nullptr)
    return glfwSetWindowMonitor(window, nullptr, before.x, before.y, before.width, before.height, GLFW_DONT_CARE);
  GLFWmonitor* monitor = monitor_of(window);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwGetWindowPos(window, &before.x, &before.y);
  glfwGetWindowSize(window, &before.width, &before.height);
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool can_quit() { return true; }

bool has_file_chooser() { return false; }

std::string home_folder() {
  const char* const home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? home : "";
}

void choose_files() {}

Workers& workers() {
  class None final : public Workers {
    int count() override { return 0; }
    void tell(int, const std::string&) override {}
    std::optional<Answer> hear(MessageKind) override { return std::nullopt; }
  };
  static None none;
  return none;
}

const std::string& licences() {
  static const std::string no_text;  // the system has the libraries and the fonts, and their licences
  return no_text;
}

}  // namespace raywalk::platform
