#pragma once

#include "gui/commands.h"
#include "gui/style.h"
#include "gui/ui.h"

#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// Drawn with lines, so that no font has to have it and it is crisp at any size.
enum class Icon { none, step, back, play, pause, clear, first, last, undo, redo, plus, minus, close, up, exchange };

enum class Look {
  plain,    ///< raised a little
  primary,  ///< the first thing to press
  flat,     ///< no ground until pointed at
  choice,   ///< one of several: the chosen one is filled
};

struct ButtonLook {
  Look look = Look::plain;
  Icon icon = Icon::none;
  ImFont* font = nullptr;  ///< null: text
  bool label = true;       ///< false: the icon alone
};

/// A button for a command: label, tooltip with its key, enabled or not, chosen or not. `size` 0: as the label needs.
/// `label`: in place of the command's own.
void command_button(const Ui& ui, Command command, ImVec2 size = {0, 0}, const ButtonLook& look = {},
                    const std::string& label = {});
/// Width that command_button takes when it is left free.
[[nodiscard]] float button_width(const Ui& ui, Command command, const ButtonLook& look = {});
[[nodiscard]] float button_width(const Ui& ui, const std::string& label, const ButtonLook& look = {});
/// The same for what is no command; `name` is for tests and ImGui. Whether it was pressed.
bool button(const Ui& ui, std::string_view name, const std::string& label, const std::string& hint, ImVec2 size,
            const ButtonLook& look, bool is_chosen = false, bool is_enabled = true);

/// Buttons of which one is chosen, in one frame.
/// They are as wide as their words, but together no wider than `most_width`.
void choice(const Ui& ui, std::initializer_list<Command> commands, float height, ImFont* font = nullptr,
            float most_width = 1e6f);
/// The same in as many lines as their words need, each over all of `width`. How high they are together.
float choice_in_lines(const Ui& ui, std::initializer_list<Command> commands, float line_height, ImFont* font,
                      float width);

/// Buttons from left to right, on a further line where there is no room left.
class ButtonRow {
 public:
  ButtonRow(const Ui& ui, const Rect& where, float height) : ui_(ui), where_(where), height_(height), x_(where.x) {}
  void add(Command command, const std::string& label = {});
  /// Puts ImGui's cursor where something so wide has room.
  void place(float width);
  [[nodiscard]] float bottom() const { return where_.y + y_ + height_; }

 private:
  const Ui& ui_;
  Rect where_;
  float height_, x_, y_ = 0;
};

/// A bar to drag along, `fraction` of it filled; where it was dragged to, if it was.
std::optional<float> slider(const Ui& ui, const char* name, ImVec2 extent, float fraction, const std::string& inside);

/// A line of a menu.
void menu_item(const Ui& ui, Command command);

/// Shows `text` beside the pointer once it has rested on the last item.
void tooltip(const Ui& ui, std::string_view name, const std::string& text);

/// Draws an icon into a square of this edge around `centre`.
void draw_icon(ImDrawList& draw, Icon icon, ImVec2 centre, float edge, ImU32 colour);

/// Pushes a face at its own size, and back.
void push_font(ImFont* font);
void pop_font();
/// `text` as far as it fits into this width, in the face that is pushed, with an ellipsis for what is left out.
[[nodiscard]] std::string shortened(const std::string& text, float most_width);
/// Text in a colour; `text` is taken as it is.
void label(Colour colour, std::string_view text);
/// The same in lines no wider than the pane.
void paragraph(Colour colour, std::string_view text);

}  // namespace raywalk
