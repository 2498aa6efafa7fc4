#pragma once

#include "gui/key.h"
#include "image/image_file.h"
#include "text/error.h"

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;
struct ImGuiContext;

namespace raywalk {

/// The one window, its OpenGL 3.3 context and Dear ImGui's context. Lengths of the interface are in ImGui's units (the
/// window's screen coordinates), pixels are those of the framebuffer.
class Window {
 public:
  /// Opens a window of this size in screen coordinates, not yet shown; 0: 1280 x 720 at the display's own scale. It is
  /// limited to the screen. Fails without a display or OpenGL 3.3.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  Window(Window&&) = delete;
  Window& operator=(Window&&) = delete;

  struct WindowSize {
    float width = 0, height = 0;
  };
  /// Of the window, in units.
  [[nodiscard]] WindowSize extent() const;
  /// Framebuffer pixels per unit: 2 on a high-DPI display with scaled coordinates.
  [[nodiscard]] float density() const;
  /// The scale relative to 96 dots per inch, in units.
  [[nodiscard]] float scale() const;
  [[nodiscard]] bool minimised() const;

  /// Waits for events, at most `seconds` (negative: indefinitely; 0: not at all), and passes them to ImGui. Returns
  /// whether there were any.
  bool wait(double seconds);
  /// Polls events, as `wait` does, during other work: whether the user asked to close the window, or, with `input`,
  /// pressed a key or a button or drags. The functions below still report them.
  [[nodiscard]] bool look(bool input);
  /// Keys pressed since the last call, in order.
  [[nodiscard]] std::vector<KeyPress> take_keys();
  /// The same, which no frame shall see any more: not even as pressed, where it waits for a frame of its own.
  [[nodiscard]] std::vector<KeyPress> drop_keys();
  /// Whether a key was let go since the last call.
  [[nodiscard]] bool take_key_release();
  /// Whether the user asked the window to close since the last call.
  [[nodiscard]] bool take_close_request();

  /// Keys pressed in that window are this one's from now on.
  void hear(GLFWwindow* other);

  void set_title(const std::string& title);
  void toggle_full_screen();
  /// Uploads the rebuilt font atlas to the GPU.
  void upload_fonts();
  /// Where the graphics card has lost what it was given: ImGui's part is made anew.
  void draw_again();

  /// `with_pointer` false: without pointer and buttons, for screenshots.
  void begin_frame(bool with_pointer = true);
  /// Draws ImGui's frame on `background` (sRGB, 0..1), and shows it. `picture`: optional copy of the window.
  void end_frame(const float (&background)[3], Image* picture = nullptr);
  /// Instead of end_frame: an invisible frame, after which the layout has settled.
  void end_frame_unseen();

 private:
  Window() = default;
  void listen();
  /// `place`: the key, by where it is.
  static void on_key(GLFWwindow* window, int place, int scan_code, int action, int modifiers);
  void replay_fast_input();

  GLFWwindow* window_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  bool backends_ = false;
  std::vector<KeyPress> keys_;
  /// For ImGui before 1.87, which polls mouse and keys once per frame: events between two frames.
  struct Place {
    float x, y;
  };
  Place pointer_{-1, -1};  ///< after the last event
  struct FastButton {
    int button;
    bool down;
    Place at;
  };
  std::vector<FastButton> fast_buttons_;
  struct FastKey {
    int key, place;  ///< GLFW_KEY_*, by what is written on it and by where it is
    bool ctrl, shift, alt;
  };
  std::vector<FastKey> fast_keys_;
  std::vector<FastKey> held_keys_;
  bool happened_ = true, close_requested_ = false, shown_ = false, key_released_ = false;
};

/// A GPU texture with nearest-neighbour magnification.
class Texture {
 public:
  Texture() = default;
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;
  Texture(Texture&&) = delete;
  Texture& operator=(Texture&&) = delete;

  /// `rgba`: width * height * 4 bytes, top row first.
  void upload(int width, int height, const unsigned char* rgba);
  [[nodiscard]] unsigned id() const { return id_; }
  /// What the graphics card has lost: the next upload makes it anew.
  void forget() { id_ = 0, width_ = height_ = 0; }

 private:
  unsigned id_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace raywalk
