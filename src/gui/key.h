#pragma once
// Keys by name, as menus and the list of keys write them in English: "Ctrl+Shift+S", "Page Up". What reports them, the
// window or a browser, translates its own.

#include <algorithm>
#include <array>
#include <string_view>

namespace raywalk {

/// The keys that have a name of more than one character. The others are letters, digits, ",", "-" and "+", which on
/// many keyboards is the key of "=". A key of the keypad has the name of what it writes.
inline constexpr std::array<std::string_view, 26> named_keys{
    "Space", "Enter",   "Tab",       "Delete", "Backspace", "Escape", "Left", "Right", "Up",
    "Down",  "Page Up", "Page Down", "Home",   "End",       "F1",     "F2",   "F3",    "F4",
    "F5",    "F6",      "F7",        "F8",     "F9",        "F10",    "F11",  "F12"};

[[nodiscard]] constexpr bool is_key(std::string_view name) {
  if (name.size() != 1) return std::find(named_keys.begin(), named_keys.end(), name) != named_keys.end();
  const char c = name[0];
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ',' || c == '-' || c == '+';
}

/// A key that went down, with its modifiers.
struct KeyPress {
  std::string_view key;
  bool ctrl = false, shift = false, alt = false;
  bool repeated = false;  ///< it is being held down

  /// Whether only the key and its modifiers are the same.
  [[nodiscard]] constexpr bool is(const KeyPress& other) const {
    return key == other.key && ctrl == other.ctrl && shift == other.shift && alt == other.alt;
  }
};

/// "Ctrl+Alt+Shift+S": any of the modifiers, in this order, and a key.
[[nodiscard]] constexpr KeyPress key_press(std::string_view written) {
  const auto holds = [&](std::string_view modifier) {
    if (!written.starts_with(modifier)) return false;
    written.remove_prefix(modifier.size());
    return true;
  };
  const bool ctrl = holds("Ctrl+"), alt = holds("Alt+"), shift = holds("Shift+");
  return {written, ctrl, shift, alt};
}

/// The mode in which a key is bound to its command. Digits and arrows differ between Move and Trace.
enum class When { always, move, not_move, trace };

/// A key bound to a command.
struct Shortcut {
  KeyPress press{};
  When when = When::always;

  constexpr Shortcut() = default;  ///< none
  // NOLINTNEXTLINE(google-explicit-constructor): a row says {"Ctrl+Y", "Ctrl+Shift+Z"}
  consteval Shortcut(const char* written, When in = When::always) : press(key_press(written)), when(in) {
    if (!is_key(press.key)) throw "no key has this name";
  }
};

}  // namespace raywalk
