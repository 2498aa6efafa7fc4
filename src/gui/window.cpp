#include "gui/window.h"

#include "gui/platform.h"
#include "image/srgb.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <iterator>
#include <map>
#include <utility>

#ifndef GL_CLAMP_TO_EDGE
#define GL_CLAMP_TO_EDGE 0x812F
#endif

namespace raywalk {

namespace {

/// GLFW's last error; its callback has no user data.
std::string& last_complaint() {
  static std::string text;
  return text;
}

std::string complaint() { return last_complaint().empty() ? "no reason given" : last_complaint(); }

Error no_display() {
  return {"", 0, 0, "no display to open a window on (" + complaint() + ")",
          "without a screen: raywalk render SCENE -o IMAGE.png draws the 3-D image, raywalk step SCENE tells the "
          "walk; over ssh try ssh -X; in a script try xvfb-run -a raywalk"};
}

Error no_opengl() {
  return {"", 0, 0, "the window needs OpenGL 3.3, which this display does not offer (" + complaint() + ")",
          "install the graphics driver, or Mesa's software one (libgl1-mesa-dri), and try "
          "LIBGL_ALWAYS_SOFTWARE=1 raywalk; raywalk render SCENE -o IMAGE.png needs no OpenGL"};
}

/// In the words of gui/key.h; empty for keys without a name there.
std::string_view name_of_key(int key) {
  constexpr std::string_view characters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return characters.substr(static_cast<std::size_t>(key - GLFW_KEY_0), 1);
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
    return characters.substr(static_cast<std::size_t>(10 + key - GLFW_KEY_A), 1);
  static const std::map<int, std::string_view> names{{GLFW_KEY_SPACE, "Space"},
                                                     {GLFW_KEY_ENTER, "Enter"},
                                                     {GLFW_KEY_KP_ENTER, "Enter"},
                                                     {GLFW_KEY_TAB, "Tab"},
                                                     {GLFW_KEY_DELETE, "Delete"},
                                                     {GLFW_KEY_BACKSPACE, "Backspace"},
                                                     {GLFW_KEY_ESCAPE, "Escape"},
                                                     {GLFW_KEY_LEFT, "Left"},
                                                     {GLFW_KEY_RIGHT, "Right"},
                                                     {GLFW_KEY_UP, "Up"},
                                                     {GLFW_KEY_DOWN, "Down"},
                                                     {GLFW_KEY_PAGE_UP, "Page Up"},
                                                     {GLFW_KEY_PAGE_DOWN, "Page Down"},
                                                     {GLFW_KEY_HOME, "Home"},
                                                     {GLFW_KEY_END, "End"},
                                                     {GLFW_KEY_F1, "F1"},
                                                     {GLFW_KEY_F2, "F2"},
                                                     {GLFW_KEY_F3, "F3"},
                                                     {GLFW_KEY_F4, "F4"},
                                                     {GLFW_KEY_F5, "F5"},
                                                     {GLFW_KEY_F6, "F6"},
                                                     {GLFW_KEY_F7, "F7"},
                                                     {GLFW_KEY_F8, "F8"},
                                                     {GLFW_KEY_F9, "F9"},
                                                     {GLFW_KEY_F10, "F10"},
                                                     {GLFW_KEY_F11, "F11"},
                                                     {GLFW_KEY_F12, "F12"},
                                                     {GLFW_KEY_COMMA, ","},
                                                     {GLFW_KEY_MINUS, "-"},
                                                     {GLFW_KEY_KP_SUBTRACT, "-"},
                                                     {GLFW_KEY_EQUAL, "+"},
                                                     {GLFW_KEY_KP_ADD, "+"},
                                                     {GLFW_KEY_KP_0, "0"}};
  const auto found = names.find(key);
  return found == names.end() ? std::string_view() : found->second;
}

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

// Whether it writes a letter, where it is no command.
bool writes(int key) {
  return key == GLFW_KEY_UNKNOWN || (key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2) ||
         (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL && key != GLFW_KEY_KP_ENTER);
}

Window* window_of(GLFWwindow* window) { return static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height) {
  last_complaint().clear();
  glfwSetErrorCallback([](int, const char* text) { last_complaint() = text; });
  if (glfwInit() != GLFW_TRUE) return tl::unexpected(no_display());

  std::unique_ptr<Window> window(new Window);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  // ImGui anti-aliases its own edges; multisampling would only cost, especially in software.
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "raywalk");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "raywalk");
  platform::hint_window();

  constexpr int default_width = 1280, default_height = 720;
  const bool usual = width <= 0 || height <= 0;
  if (usual) width = default_width, height = default_height;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
#if !defined(__APPLE__)  // there, screen coordinates already follow the scale
    float scale_x = 1, scale_y = 1;
    glfwGetMonitorContentScale(monitor, &scale_x, &scale_y);
    if (usual && scale_x > 1) {
      width = static_cast<int>(static_cast<float>(width) * scale_x);
      height = static_cast<int>(static_cast<float>(height) * scale_x);
    }
#endif
    int x = 0, y = 0, max_width = 0, max_height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &max_width, &max_height);
    if (max_width > 0 && max_height > 0) {
      width = std::min(width, max_width);
      height = std::min(height, max_height);
    }
  }
  window->window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window->window_ == nullptr) return tl::unexpected(no_opengl());
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(1);
  window->listen();

  IMGUI_CHECKVERSION();
  window->imgui_ = ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;               // the layout is fixed: nothing to remember
  ImGui::GetIO().ConfigInputTextCursorBlink = false;  // a blinking cursor would redraw forever
  // ImGui keeps the functions set above and calls them after its own.
  if (!ImGui_ImplGlfw_InitForOpenGL(window->window_, true)) return tl::unexpected(no_opengl());
#if IMGUI_VERSION_NUM < 18700
  // What is pressed and typed reaches it by show_to_imgui.
  glfwSetKeyCallback(window->window_, on_key);
  glfwSetCharCallback(window->window_, [](GLFWwindow* w, unsigned code) {
    Window& self = *window_of(w);
    self.happened_ = true;
    self.input_.emplace_back(Character{code});
  });
#endif
  platform::connect_clipboard();
  if (!ImGui_ImplOpenGL3_Init(platform::shading_language())) {
    ImGui_ImplGlfw_Shutdown();
    return tl::unexpected(no_opengl());
  }
  window->backends_ = true;
  return window;
}

Window::~Window() {
  if (backends_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
  }
  if (imgui_ != nullptr) ImGui::DestroyContext(imgui_);
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::on_key(GLFWwindow* window, int place, int scan_code, int action, int modifiers) {
  Window& self = *window_of(window);
  self.happened_ = true;
  const bool ctrl = (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0, alt = (modifiers & GLFW_MOD_ALT) != 0;
  const int key = platform::key_written(place, scan_code);
  self.input_.emplace_back(Key{key, action != GLFW_RELEASE, action == GLFW_REPEAT, ctrl, shift, alt});
}

void Window::hear(GLFWwindow* other) {
  glfwSetWindowUserPointer(other, this);
  glfwSetKeyCallback(other, on_key);
  glfwSetWindowRefreshCallback(other, [](GLFWwindow* w) { window_of(w)->happened_ = true; });
  glfwSetWindowCloseCallback(other, [](GLFWwindow* w) { window_of(w)->happened_ = true; });
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  // A callback per event; most only note that something happened.
#if IMGUI_VERSION_NUM >= 18700
  glfwSetKeyCallback(window_, on_key);
#endif
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { window_of(w)->happened_ = true; });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    Window& self = *window_of(w);
    self.happened_ = true;
    self.pointer_ = {static_cast<float>(x), static_cast<float>(y)};
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { window_of(w)->happened_ = true; });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    Window& self = *window_of(w);
    self.happened_ = true;
    // Not glfwGetCursorPos, which gives the current position.
    self.input_.emplace_back(Button{button, action == GLFW_PRESS, self.pointer_});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { window_of(w)->happened_ = true; });
  platform::hear_drops(window_, [](GLFWwindow* w, int count, const char** paths) {
    Window& self = *window_of(w);
    self.happened_ = true;
    self.dropped_.assign(paths, paths + count);
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { window_of(w)->happened_ = true; });
  glfwSetWindowSizeCallback(window_, [](GLFWwindow* w, int, int) { window_of(w)->happened_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { window_of(w)->happened_ = true; });
  glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { window_of(w)->happened_ = true; });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { window_of(w)->happened_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { window_of(w)->happened_ = true; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
    Window& self = *window_of(w);
    self.happened_ = self.close_requested_ = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);
  });
}

float Window::density() const {
  int width = 0, height = 0, pixel_width = 0, pixel_height = 0;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &pixel_width, &pixel_height);
  return width > 0 && pixel_width > 0 ? static_cast<float>(pixel_width) / static_cast<float>(width) : 1.0f;
}

Window::WindowSize Window::extent() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return {static_cast<float>(width), static_cast<float>(height)};
}

float Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x / density() : 1.0f;
}

bool Window::minimised() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return width <= 0 || height <= 0 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Window::wait(double seconds) {
  platform::follow_surroundings(window_);
  if (happened_) seconds = 0;  // in the middle of something else, where `look` took it in
  if (seconds < 0) {
    glfwWaitEvents();
  } else if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  return std::exchange(happened_, false);
}

bool Window::look(bool input) {
  glfwPollEvents();
  if (close_requested_ || !input) return close_requested_;
  const bool drags = happened_ && glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  return drags || input_.size() > due_ || !dropped_.empty() || platform::input_waits();
}

bool Window::Key::edits() const { return (ctrl && !alt) || !writes(key); }

void Window::note(const Key& key, std::vector<KeyPress>& keys) {
  key_released_ |= !key.down;
  if (const std::string_view name = name_of_key(key.key); key.down && !name.empty())
    keys.push_back({name, key.ctrl, key.shift && key.key != GLFW_KEY_EQUAL, key.alt, key.repeat});
}

std::size_t Window::of_a_frame() const {
#if IMGUI_VERSION_NUM < 18700
  // Later ones keep such a queue themselves. This one sees a button or key only as it is at a frame, and takes letters
  // before it takes keys.
  bool pressed = false, edits = false;
  std::vector<int> changed;
  for (std::size_t i = 0; i < input_.size(); ++i) {
    if (std::holds_alternative<Button>(input_[i])) return std::max<std::size_t>(i, 1);
    if (std::holds_alternative<Character>(input_[i])) {
      if (edits) return i;
      continue;
    }
    const Key& key = std::get<Key>(input_[i]);
    if (key.repeat) {
      edits |= key.edits();
      continue;
    }
    const bool again = std::find(changed.begin(), changed.end(), key.key) != changed.end();
    if (again || (pressed && is_modifier(key.key))) return i;
    changed.push_back(key.key);
    if (!key.down || is_modifier(key.key)) continue;
    if (std::exchange(pressed, true)) return i;
    edits |= key.edits();
  }
#endif
  return input_.size();
}

std::vector<KeyPress> Window::take_keys() {
  if (due_ > 0) return {};  // taken, and no frame came since
  due_ = of_a_frame();
  std::vector<KeyPress> keys;
  for (std::size_t i = 0; i < due_; ++i)
    if (const Key* key = std::get_if<Key>(&input_[i])) note(*key, keys);
  return keys;
}

std::vector<KeyPress> Window::drop_keys() {
  std::vector<KeyPress> keys;
  for (std::size_t i = 0; i < input_.size(); ++i) {
    const Key* key = std::get_if<Key>(&input_[i]);
    if (key == nullptr) continue;
    if (i >= due_) note(*key, keys);
    if (!key->down) show_to_imgui(*key);
  }
  input_.erase(std::remove_if(input_.begin(), input_.end(),
                              [](const auto& event) { return !std::holds_alternative<Button>(event); }),
               input_.end());
  due_ = 0;
  return keys;
}

bool Window::take_key_release() { return std::exchange(key_released_, false); }

bool Window::take_close_request() { return std::exchange(close_requested_, false); }

std::vector<std::string> Window::take_dropped() { return std::exchange(dropped_, {}); }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::toggle_full_screen() { platform::toggle_full_screen(window_); }

void Window::upload_fonts() {
#if IMGUI_VERSION_NUM < 19200  // from 1.92 on the backend detects changes of the atlas
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void Window::draw_again() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplOpenGL3_Init(platform::shading_language());
}

void Window::show_to_imgui([[maybe_unused]] const Key& key) {
#if IMGUI_VERSION_NUM < 18700
  ImGuiIO& io = ImGui::GetIO();
  if (key.key >= 0 && key.key < static_cast<int>(std::size(io.KeysDown)) && !key.repeat)
    io.KeysDown[key.key] = key.down;
  const auto down = [&](int one, int other) { return io.KeysDown[one] || io.KeysDown[other]; };
  const bool has_them = !is_modifier(key.key);  // that of a modifier has those before it
  io.KeyCtrl = down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) || (has_them && key.ctrl);
  io.KeyShift = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) || (has_them && key.shift);
  io.KeyAlt = down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) || (has_them && key.alt);
  io.KeySuper = down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
#endif
}

// A drag begins where the button went down, even if the pointer has moved before the frame; and a key released before
// the frame still counts as pressed.
void Window::show_to_imgui() {
#if IMGUI_VERSION_NUM < 18700
  ImGuiIO& io = ImGui::GetIO();
  show_to_imgui(Key{GLFW_KEY_UNKNOWN, false, false, false, false, false});  // a key's modifiers are for its frame only
  const auto is_button = [](const auto& event) { return std::holds_alternative<Button>(event); };
  if (std::any_of(input_.begin(), input_.end(), is_button))  // the backend has them as they are now
    for (std::size_t i = 0; i < std::size(io.MouseDown); ++i) io.MouseDown[i] = io.MouseDownDuration[i] >= 0;
  for (std::size_t i = 0; i < due_; ++i) {
    if (const Key* key = std::get_if<Key>(&input_[i])) show_to_imgui(*key);
    if (const Character* character = std::get_if<Character>(&input_[i])) io.AddInputCharacter(character->code);
    if (const Button* event = std::get_if<Button>(&input_[i])) {
      if (event->button < static_cast<int>(std::size(io.MouseDown))) io.MouseDown[event->button] = event->down;
      io.MousePos = {event->at.x, event->at.y};
    }
  }
#endif
  input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(std::exchange(due_, 0)));
  happened_ |= !input_.empty();
}

void Window::begin_frame(bool with_pointer) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  show_to_imgui();
  if (!with_pointer) {
#if IMGUI_VERSION_NUM >= 18700
    ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
#else
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
#endif
  }
  // Circles are of lines that leave them by so many of the window's units: less where the screen's pixels are smaller.
  constexpr float of_a_pixel = 0.06f;  // the corners of a large circle could be seen
  ImGui::GetStyle().CircleTessellationMaxError = of_a_pixel / std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.0f);
  ImGui::NewFrame();
}

void Window::end_frame_unseen() { ImGui::EndFrame(); }

void Window::end_frame(const float (&background)[3], Image* picture) {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(background[0], background[1], background[2], 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (picture != nullptr && width > 0 && height > 0) {
    const auto row_bytes = static_cast<std::size_t>(width) * 4;  // OpenGL ES reads nothing but RGBA everywhere
    std::vector<unsigned char> bytes(row_bytes * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = static_cast<float>(srgb_decode(double(i) / 255));
    *picture = {.width = width, .height = height, .pixels = {}};
    picture->pixels.reserve(bytes.size() / 4);
    for (int row = height - 1; row >= 0; --row) {  // OpenGL's first row is the bottom one
      const unsigned char* at = bytes.data() + static_cast<std::size_t>(row) * row_bytes;
      for (int column = 0; column < width; ++column, at += 4)
        picture->pixels.emplace_back(linear[at[0]], linear[at[1]], linear[at[2]]);
    }
  }
  glfwSwapBuffers(window_);
  if (!shown_) {
    // Shown only now, so that the first visible frame is not empty.
    shown_ = true;
    glfwShowWindow(window_);
  }
}

void set_magnification(std::uintptr_t texture, Magnification magnification) {
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                  magnification == Magnification::smooth ? GL_LINEAR : GL_NEAREST);
}

Texture::~Texture() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

void Texture::upload(int width, int height, const unsigned char* rgba) {
  if (id_ == 0) {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glBindTexture(GL_TEXTURE_2D, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (width == width_ && height == height_) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  } else {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    width_ = width;
    height_ = height;
  }
}

}  // namespace raywalk
