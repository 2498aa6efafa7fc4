#include "gui/platform.h"

#include <GLFW/glfw3.h>
#include <emscripten/em_js.h>
#include <imgui.h>

#include <cstdlib>
#include <string>

// clang-format off
EM_JS_DEPS(raywalk_platform, "$UTF8ToString,$stringToNewUTF8");
EM_JS(void, raywalk_page_size, (int* width, int* height), {
  HEAP32[width >> 2] = Math.max(1, window.innerWidth);
  HEAP32[height >> 2] = Math.max(1, window.innerHeight);
});
// Emscripten's GLFW notices only when the ratio differs from the first one.
EM_JS(void, raywalk_follow_pixel_ratio, (), {
  if (GLFW.scale !== window.devicePixelRatio) GLFW.onDevicePixelRatioChange();
});
EM_JS(void, raywalk_copy, (const char* text), { navigator.clipboard?.writeText(UTF8ToString(text)).catch(() => {}); });
EM_JS(char*, raywalk_pasted, (), { return stringToNewUTF8(Module["pasted"] ?? ""); });
EM_JS(int, raywalk_input_waits, (), { return navigator.scheduling?.isInputPending?.() ? 1 : 0; });
EM_JS(void, raywalk_toggle_full_screen, (), {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => {});
});
EM_JS(void, raywalk_choose_files, (), { Module["chooseFiles"](); });
// clang-format on

namespace raywalk::platform {

void hint_window() { glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE); }

const char* shading_language() { return "#version 300 es"; }

void connect_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.SetClipboardTextFn = [](void*, const char* text) { raywalk_copy(text); };
  io.GetClipboardTextFn = [](void*) {
    static std::string pasted;  // ImGui takes a pointer
    char* const text = raywalk_pasted();
    pasted = text;
    std::free(text);
    return pasted.c_str();
  };
}

void follow_surroundings(GLFWwindow* window) {
  int width = 0, height = 0, page_width = 0, page_height = 0;
  raywalk_follow_pixel_ratio();
  raywalk_page_size(&page_width, &page_height);
  glfwGetWindowSize(window, &width, &height);
  if (width != page_width || height != page_height) glfwSetWindowSize(window, page_width, page_height);
}

bool input_waits() { return raywalk_input_waits() != 0; }

void toggle_full_screen(GLFWwindow* /*window*/) { raywalk_toggle_full_screen(); }

bool can_quit() { return false; }

bool has_file_chooser() { return true; }

void choose_files() { raywalk_choose_files(); }

}  // namespace raywalk::platform
