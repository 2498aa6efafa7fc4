#pragma once

struct GLFWmonitor;
struct GLFWwindow;

namespace raywalk {

/// The screen that the middle of the window is on; the first one if it is on none, and null if there is none.
[[nodiscard]] GLFWmonitor* monitor_of(GLFWwindow* window);

}  // namespace raywalk
