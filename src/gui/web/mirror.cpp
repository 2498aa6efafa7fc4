// What page.js asks of the program for those who do not see its canvas, or have no keyboard.

#include "gui/mirror.h"

#include "gui/scroll.h"
#include "gui/web/program.h"

#include <emscripten/emscripten.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <string>

using namespace raywalk;

extern "C" {

/// The window in words (gui/mirror.h).
EMSCRIPTEN_KEEPALIVE const char* page_outline() {
  static std::string json;
  const CostFindings costs = page_loop().costs();
  json = outline_json(page_loop().state(), &costs);
  return json.c_str();
}

/// Presses a button of the outline, or types into a field of it; empty, or what is wrong with what was typed.
EMSCRIPTEN_KEEPALIVE const char* page_do(const char* does, const char* typed) {
  static std::string wrong;
  const Result<void> done = page_loop().act_by_outline(does, typed);
  wrong = done ? std::string() : done.error().message;
  return wrong.c_str();
}

/// Whether what is typed goes into a field.
EMSCRIPTEN_KEEPALIVE bool page_types() { return ImGui::GetIO().WantTextInput; }

/// Whether that is a lesson's field for a number.
EMSCRIPTEN_KEEPALIVE bool page_types_number() { return page_loop().types_number(); }

/// Where the next letter is typed, in CSS pixels: the left and the upper end of its place.
EMSCRIPTEN_KEEPALIVE double page_typed_x() { return ImGui::GetCurrentContext()->PlatformImePos.x; }
EMSCRIPTEN_KEEPALIVE double page_typed_y() { return ImGui::GetCurrentContext()->PlatformImePos.y; }

/// An action in the words of demo files.
EMSCRIPTEN_KEEPALIVE void page_act(const char* line) { page_do(line, ""); }

/// Turns the wheel, also by parts of a step.
EMSCRIPTEN_KEEPALIVE void page_wheel(double by) { ImGui::GetIO().MouseWheel += static_cast<float>(by); }

/// Scrolls what is there, in CSS pixels, by so many down; false if it does not scroll.
EMSCRIPTEN_KEEPALIVE bool page_scroll(double x, double y, double by) {
  return scroll_at({static_cast<float>(x), static_cast<float>(y)}, static_cast<float>(by));
}

/// Whether what is there, in CSS pixels, does more while it is held down.
EMSCRIPTEN_KEEPALIVE bool page_holds(double x, double y) {
  return page_loop().holds_at(static_cast<float>(x), static_cast<float>(y));
}
}
