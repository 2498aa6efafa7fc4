#pragma once

#include "io/error.h"
#include "io/image.h"

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;
struct ImGuiContext;

namespace raywalk {

/// A key as GLFW numbers it (GLFW_KEY_*), pressed or repeated, with the modifiers that were held.
struct KeyPress {
  int key = 0;
  bool ctrl = false, shift = false, alt = false;
  bool repeated = false;  ///< it is being held down
  friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

/// The one window, its OpenGL 3.3 context and Dear ImGui's context. Lengths of the interface are in ImGui's units (the
/// window's screen coordinates), pixels are those of the framebuffer.
class Window {
 public:
  /// Opens a window of this size in screen coordinates, not yet shown; 0: 1280 x 720 at the display's own scale. It is
  /// cut to the screen. Fails where there is no display or no OpenGL 3.3.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  Window(Window&&) = delete;
  Window& operator=(Window&&) = delete;

  struct Extent {
    float width = 0, height = 0;
  };
  /// Of the window, in units.
  [[nodiscard]] Extent extent() const;
  /// Pixels of the framebuffer per unit: 2 on a display that is twice as dense as its coordinates say.
  [[nodiscard]] float density() const;
  /// How much larger than at 96 dots per inch things should be, in units.
  [[nodiscard]] float scale() const;
  [[nodiscard]] bool minimised() const;

  /// Waits until something happens, at most `seconds` (negative: for ever; 0: not at all), and tells ImGui of it.
  /// Whether something did.
  bool wait(double seconds);
  /// Takes in what has happened, as `wait` does, in the middle of something else: whether the user asked the window to
  /// close, or, with `input`, pressed a key or a button or drags. What it was is still told by the functions below.
  [[nodiscard]] bool look(bool input);
  /// Keys pressed since the last call, in their order.
  [[nodiscard]] std::vector<KeyPress> take_keys();
  /// Whether a key was let go since the last call.
  [[nodiscard]] bool take_key_release();
  /// Whether the user asked the window to close since the last call.
  [[nodiscard]] bool take_close_request();

  void set_title(const std::string& title);
  void toggle_full_screen();
  /// Makes the font atlas known to the graphics card after it was rebuilt.
  void upload_fonts();

  /// `with_pointer` false: as if the pointer were nowhere and none of its buttons down, for pictures.
  void begin_frame(bool with_pointer = true);
  /// Draws what ImGui has, on `background` (sRGB, 0..1), and shows it. `picture`: where to copy the window to, if
  /// anywhere.
  void end_frame(const float (&background)[3], Image* picture = nullptr);
  /// In place of end_frame: a frame that nobody is to see, after which things stand where they belong.
  void end_frame_unseen();

 private:
  Window() = default;
  void listen();
  void replay_fast_input();

  GLFWwindow* window_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  bool backends_ = false;
  std::vector<KeyPress> keys_;
  /// For ImGui before 1.87, which looks at mouse and keys once a frame: what came and went between two frames.
  struct Place {
    float x, y;
  };
  Place pointer_{-1, -1};  ///< after the last event
  std::vector<Place> button_places_;
  std::vector<KeyPress> fast_keys_;
  std::vector<int> held_keys_;
  bool happened_ = true, close_requested_ = false, shown_ = false, key_released_ = false;
  int restore_[4] = {0, 0, 0, 0};  ///< x, y, width, height before full screen
};

/// A picture on the graphics card, drawn crisply: a pixel that covers several of the screen's has sharp edges.
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

 private:
  unsigned id_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace raywalk
