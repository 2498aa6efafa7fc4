#pragma once

#include "gui/key.h"
#include "image/image_file.h"
#include "text/error.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
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
  /// Keys pressed since the last call, in order; of what was pressed between two frames, that which the next frame
  /// shows to ImGui. What comes after it waits: a letter that follows a command is for the field that this one opens.
  [[nodiscard]] std::vector<KeyPress> take_keys();
  /// All keys that were pressed, where no frame shall show them, nor what was typed, to ImGui.
  [[nodiscard]] std::vector<KeyPress> drop_keys();
  /// Whether a key that was taken or dropped was let go since the last call.
  [[nodiscard]] bool take_key_release();
  /// Whether the user asked the window to close since the last call.
  [[nodiscard]] bool take_close_request();
  /// The paths of the files and folders that were dropped on the window last, since the last call.
  [[nodiscard]] std::vector<std::string> take_dropped();

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
  struct Place {
    float x, y;
  };
  struct Button {
    int button;
    bool down;
    Place at;
  };
  struct Key {
    int key;  ///< GLFW_KEY_*, by what is written on it
    bool down, repeat, ctrl, shift, alt;
    [[nodiscard]] bool edits() const;  ///< or commands: writes nothing
  };
  struct Character {
    unsigned code;
  };

  Window() = default;
  void listen();
  /// `place`: the key, by where it is.
  static void on_key(GLFWwindow* window, int place, int scan_code, int action, int modifiers);
  /// How many of `input_` one frame can show to ImGui, so that none is lost and all keep their order.
  [[nodiscard]] std::size_t of_a_frame() const;
  void show_to_imgui();
  static void show_to_imgui(const Key& key);
  void note(const Key& key, std::vector<KeyPress>& keys);

  GLFWwindow* window_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  bool backends_ = false;
  Place pointer_{-1, -1};                                    ///< after the last event
  std::vector<std::variant<Button, Key, Character>> input_;  ///< what no frame has shown to ImGui yet, in order
  std::vector<std::string> dropped_;                         ///< that nobody has taken yet
  std::size_t due_ = 0;                                      ///< so many of `input_` are the next frame's
  bool happened_ = true, close_requested_ = false, shown_ = false, key_released_ = false;
};

/// How a texture that is drawn larger than it is looks: its pixels as squares, or bilinearly interpolated.
enum class Magnification { pixels, smooth };
/// Of a texture's id; for all that is drawn of it in this frame.
void set_magnification(std::uintptr_t texture, Magnification magnification);

/// A GPU texture; magnified, its pixels are squares.
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
