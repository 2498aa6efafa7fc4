#include "gui/desktop/monitor.h"
#include "gui/notes.h"
#include "gui/platform.h"
#include "gui/window.h"
#include "text/language.h"
#include "view/text/text.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

namespace raywalk {

namespace {

using Clock = std::chrono::steady_clock;

// While one exists, the contexts of OpenGL and ImGui are the notes'; then what they were.
class Contexts {
 public:
  Contexts(GLFWwindow* window, ImGuiContext* imgui) {
    if (window != nullptr) glfwMakeContextCurrent(window);
    if (imgui != nullptr) ImGui::SetCurrentContext(imgui);
  }
  ~Contexts() {
    glfwMakeContextCurrent(window_);
    ImGui::SetCurrentContext(imgui_);
  }
  Contexts(const Contexts&) = delete;
  Contexts& operator=(const Contexts&) = delete;

 private:
  GLFWwindow* window_ = glfwGetCurrentContext();
  ImGuiContext* imgui_ = ImGui::GetCurrentContext();
};

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 16> text{};
  if (localtime_r(&now, &parts) != nullptr) std::strftime(text.data(), text.size(), "%H:%M", &parts);
  return text.data();
}

}  // namespace

struct NotesWindow::Parts {
  Window& main;
  FontFiles files;
  GLFWwindow* window = nullptr;
  ImGuiContext* imgui = nullptr;
  Fonts fonts{};
  float unit = 0, grown = 1;  // of the fonts
  std::string lesson{};       // since when
  std::string title{};        // so that it is told apart from the walk's, when a window is shared with the class
  Clock::time_point begun = Clock::now();

  // On a screen that the class does not look at; else beside the walk's window, where one wide screen has the room.
  void place(GLFWwindow* walk) {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    const GLFWmonitor* const shown = walk != nullptr ? monitor_of(walk) : nullptr;
    for (int i = 0; i < count && walk != nullptr; ++i) {
      int x = 0, y = 0, room = 0, rows = 0;
      glfwGetMonitorWorkarea(monitors[i], &x, &y, &room, &rows);
      if (count > 1 && monitors[i] != shown) {
        glfwSetWindowPos(window, x, y);
        glfwSetWindowSize(window, room, rows);
        return;
      }
      int left = 0, top = 0, across = 0, down = 0;
      constexpr int least = 300;
      glfwGetWindowPos(walk, &left, &top);
      glfwGetWindowSize(walk, &across, &down);
      const int before = left - x, after = x + room - left - across;
      if (std::max(before, after) < least) continue;
      glfwSetWindowPos(window, after >= before ? left + across : x, top);
      glfwSetWindowSize(window, std::max(before, after), std::min(down, rows));
    }
  }

  void open() {
    constexpr int width = 900, height = 700;
    GLFWwindow* const walk = glfwGetCurrentContext();
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);  // the walk's window keeps the keyboard
    window = glfwCreateWindow(width, height, "Raywalk", nullptr, nullptr);
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_TRUE);
    if (window == nullptr) return;
    place(walk);
    main.hear(window);
    const Contexts here(window, nullptr);
    glfwSwapInterval(0);  // frames wait for the walk's window alone
    imgui = ImGui::CreateContext();
    ImGui::SetCurrentContext(imgui);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplOpenGL3_Init(platform::shading_language());
    glfwShowWindow(window);
  }

  void close() {
    if (window == nullptr) return;
    {
      const Contexts here(window, imgui);
      ImGui_ImplOpenGL3_Shutdown();
    }
    ImGui::DestroyContext(imgui);
    glfwDestroyWindow(std::exchange(window, nullptr));
  }

  // Letters as large as the window asks for.
  void rescale(int width, int height, float density, Language language) {
    const float wanted = std::clamp(
        std::round(4 * std::min(static_cast<float>(width) / 900, static_cast<float>(height) / 700)) / 4, 0.5f, 4.0f);
    if (wanted * grown == unit && density == fonts.density) return;
    ImGuiIO& io = ImGui::GetIO();
    fonts = build_fonts(*io.Fonts, files, wanted * grown, density, language.others());
    io.FontGlobalScale = 1 / density;
    unit = wanted * grown;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }

  void draw(const State& state) {
    if (const std::string now = state.lessons.open ? state.lessons.open->lesson.name : ""; now != lesson) {
      lesson = now;
      begun = Clock::now();
    }
    if (const std::string now(text("command.notes_window.label", state.appearance.language)); now != title) {
      title = now;
      glfwSetWindowTitle(window, (title + " – Raywalk").c_str());
    }
    const Contexts here(window, imgui);
    int width = 0, height = 0, pixels = 0, rows = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixels, &rows);
    if (width <= 0 || height <= 0 || pixels <= 0) return;
    const float density = static_cast<float>(pixels) / static_cast<float>(width);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DisplayFramebufferScale = {density, density};
    io.DeltaTime = 1.0f / 60;
    rescale(width, height, density, state.appearance.language);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    const float best =
        draw_notes(notes_panel(state), fonts, state.appearance.theme,
                   lesson.empty() ? time_of_day() : time_of_day() + "   " + elapsed_text(seconds), grown);
    // Other fonts in the next frame, if letters are stretched.
    constexpr float least = 0.97f, most = 1.06f, slack = 0.98f;
    if (best < least * grown || best > most * grown) grown = slack * best;
    ImGui::Render();
    glViewport(0, 0, pixels, rows);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
  }
};

NotesWindow::NotesWindow(Window& main, FontFiles fonts) : parts_(new Parts{main, std::move(fonts)}) { parts_->open(); }

NotesWindow::~NotesWindow() { parts_->close(); }

bool NotesWindow::show(const State& state) {
  if (parts_->window == nullptr || glfwWindowShouldClose(parts_->window) == GLFW_TRUE) return false;
  parts_->draw(state);
  return true;
}

}  // namespace raywalk
