#include "gui/platform.h"

#include "text/file.h"

#include <GLFW/glfw3.h>
#include <emscripten/em_js.h>
#include <imgui.h>

#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>

// clang-format off
EM_JS_DEPS(raywalk_platform, "$UTF8ToString,$stringToNewUTF8");
EM_JS(void, raywalk_page_size, (int* width, int* height), {
  [HEAP32[width >> 2], HEAP32[height >> 2]] = Module["canvas_size"]();
});
// Emscripten's GLFW notices only when the ratio differs from the first one.
EM_JS(void, raywalk_follow_pixel_ratio, (), {
  if (GLFW.scale !== window.devicePixelRatio) GLFW.onDevicePixelRatioChange();
});
EM_JS(void, raywalk_copy, (const char* text), { Module["copy"](UTF8ToString(text)); });
EM_JS(char*, raywalk_pasted, (), { return stringToNewUTF8(Module["pasted"] ?? ""); });
EM_JS(int, raywalk_input_waits, (), { return navigator.scheduling?.isInputPending?.() ? 1 : 0; });
EM_JS(void, raywalk_toggle_full_screen, (), {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => {});
});
EM_JS(void, raywalk_choose_files, (), { Module["chooseFiles"](); });
EM_JS(int, raywalk_workers, (), { return Module["workers"]?.count() ?? 0; });
EM_JS(void, raywalk_tell_worker, (int worker, const char* bytes, int size),
      { Module["workers"].tell(worker, HEAPU8.slice(bytes, bytes + size)); });
// Of the next answer of a kind: its size, or -1 if there is none; then its worker and, into the room for it, its bytes.
EM_JS(int, raywalk_answer_size, (int kind), { return Module["workers"]?.next(kind)?.bytes.length ?? -1; });
EM_JS(int, raywalk_take_answer, (int kind, char* room), {
  const { worker, bytes } = Module["workers"].take(kind);
  HEAPU8.set(bytes, room);
  return worker;
});
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

void hear_drops(GLFWwindow* /*window*/, void (* /*dropped*/)(GLFWwindow*, int, const char**)) {}  // page.js does

void follow_surroundings(GLFWwindow* window) {
  int width = 0, height = 0, page_width = 0, page_height = 0;
  raywalk_follow_pixel_ratio();
  raywalk_page_size(&page_width, &page_height);
  glfwGetWindowSize(window, &width, &height);
  if (width != page_width || height != page_height) glfwSetWindowSize(window, page_width, page_height);
}

int key_written(int key, int /*scan_code*/) { return key; }  // Emscripten's GLFW has it from there

bool input_waits() { return raywalk_input_waits() != 0; }

void toggle_full_screen(GLFWwindow* /*window*/) { raywalk_toggle_full_screen(); }

bool can_quit() { return false; }

bool has_file_chooser() { return true; }

std::string home_folder() { return {}; }

void choose_files() { raywalk_choose_files(); }

Workers& workers() {
  class OfPage final : public Workers {
    int count() override { return raywalk_workers(); }
    void tell(int worker, const std::string& message) override {
      raywalk_tell_worker(worker, message.data(), static_cast<int>(message.size()));
    }
    std::optional<Answer> hear(MessageKind of) override {
      const int kind = static_cast<int>(of), size = raywalk_answer_size(kind);
      if (size < 0) return std::nullopt;
      Answer answer{0, std::string(static_cast<std::size_t>(size), '\0')};
      answer.worker = raywalk_take_answer(kind, answer.message.data());
      return answer;
    }
  };
  static OfPage of_page;
  return of_page;
}

const std::string& licences() {
  constexpr std::size_t most = 1 << 20;
  static const std::string text = read_file("/raywalk/licences.txt", most).value_or("");
  return text;
}

}  // namespace raywalk::platform
