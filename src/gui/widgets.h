#pragma once

#include "gui/command.h"
#include "gui/style.h"
#include "gui/ui.h"
#include "view/document/room.h"

#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// Drawn with lines: independent of fonts, and crisp at any size.
enum class Icon {
  none,
  step,
  back,
  play,
  pause,
  clear,
  first,
  last,
  undo,
  redo,
  plus,
  minus,
  close,
  up,
  exchange,
  focus,
  pen,
  arrow,
  letter,
  ruler,
  protractor,
  eraser,
  bin,
  keep,
  pixel,
  globe
};

enum class Look {
  plain,    ///< slightly raised
  primary,  ///< the main action
  flat,     ///< no background until hovered
  choice,   ///< one of several: the chosen one is filled
};

struct ButtonLook {
  Look look = Look::plain;
  Icon icon = Icon::none;
  ImFont* font = nullptr;                         ///< null: the text font
  bool label = true;                              ///< false: the icon alone
  std::optional<action::ObjectKind> pictogram{};  ///< in place of the icon
};

/// A button for a command: label, tooltip with its key, enabled or not, chosen or not. `size` 0: from the label.
/// `label`, `on`: replace the command's own, and whether it is chosen.
void command_button(const Ui& ui, const Command& command, ImVec2 size = {0, 0}, const ButtonLook& look = {},
                    const std::string& label = {}, std::optional<bool> on = {});
/// The width of command_button by default.
[[nodiscard]] float button_width(const Ui& ui, const Command& command, const ButtonLook& look = {});
[[nodiscard]] float button_width(const Ui& ui, const std::string& label, const ButtonLook& look = {});
/// The same without a command; `name` is for tests and ImGui. Returns whether it was pressed.
bool button(const Ui& ui, std::string_view name, const std::string& label, const std::string& hint, ImVec2 size,
            const ButtonLook& look, bool is_chosen = false, bool is_enabled = true);

/// Buttons of which one is chosen, in one frame. They are as wide as their words, but together at most `max_width`.
void choice(const Ui& ui, const std::vector<const Command*>& commands, float height, ImFont* font = nullptr,
            float max_width = 1e6f);
/// The same in as many lines as needed, each over the whole `width`.
void choice_in_lines(const Ui& ui, const std::vector<const Command*>& commands, float line_height, ImFont* font,
                     float width);
/// How high that is.
[[nodiscard]] float choice_height(const Ui& ui, const std::vector<const Command*>& commands, float line_height,
                                  ImFont* font, float width);

/// Buttons from left to right, wrapped to further lines.
class ButtonRow {
 public:
  ButtonRow(const Ui& ui, const Rect& where, float height) : ui_(ui), where_(where), height_(height), x_(where.x) {}
  void add(const Command& command, const std::string& label = {});
  /// Moves ImGui's cursor to where an item of this width fits.
  void place(float width);
  [[nodiscard]] float bottom() const { return where_.y + y_ + height_; }

 private:
  const Ui& ui_;
  Rect where_;
  float height_, x_, y_ = 0;
};

/// A slider, `fraction` of it filled; returns the dragged position, if any.
std::optional<float> slider(const Ui& ui, const char* name, ImVec2 extent, float fraction, const std::string& inside);

/// A line of a menu.
void menu_item(const Ui& ui, const Command& command);

/// What a tooltip explains, and stands beside: a whole item, so that no picture is covered by its own, or the point of
/// it that the pointer is at.
enum class TipOf { item, point };
/// Shows `text` beside the last item once the pointer has rested on it.
void tooltip(const Ui& ui, std::string_view name, const std::string& text, TipOf of = TipOf::item);
/// At the end of a frame: the tooltip that is due, where it covers the least of what can be clicked.
void show_tooltip(const Ui& ui);
/// Shows `text` beside the pointer, at once and in one line.
/// `within`: left of its right edge, where what stands beside it is read; empty: anywhere.
void tooltip_now(const Ui& ui, const std::string& text, const Rect& within = {});

/// With smooth edges whichever way round its corners are named: ImGui smooths clockwise ones alone.
void fill_triangle(ImDrawList& draw, ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour);
/// Draws an icon into a square of this edge around `centre`.
void draw_icon(ImDrawList& draw, Icon icon, ImVec2 centre, float edge, ImU32 colour);

/// Pushes a face at its own size, and back.
void push_font(ImFont* font);
void pop_font();
/// `text` shortened to this width in the current font, with an ellipsis.
[[nodiscard]] std::string shortened(const std::string& text, float max_width);
/// Text in a colour; `text` is not interpreted.
void label(Colour colour, std::string_view text);
/// The same in lines no wider than the pane.
void paragraph(Colour colour, std::string_view text);

}  // namespace raywalk
