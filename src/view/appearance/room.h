#pragma once
// How the window looks.

#include "text/language.h"
#include "view/drawing/theme.h"
#include "view/fields.h"
#include "view/picture/room.h"
#include "view/room.h"

#include <algorithm>
#include <string>
#include <vector>

namespace raywalk {

inline constexpr double min_ui_scale = 1, max_ui_scale = 3;
inline constexpr double min_code_part = 0.15, max_code_part = 0.85;

/// In a narrow, tall window: which of three stands below the walk.
enum class Front { code, tabs, lesson };
template <>
inline constexpr Word<Front> words_of<Front>[] = {
    {Front::code, "code"}, {Front::tabs, "tabs"}, {Front::lesson, "lesson"}};

}  // namespace raywalk

namespace raywalk::action {

struct SetTheme {
  static constexpr std::string_view word = "theme";
  Theme theme;
  static void fields(auto& f, auto& a) { f(a.theme); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
/// Of interface, lessons and bugs.
struct SetLanguage {
  static constexpr std::string_view word = "language";
  std::string code;  ///< "pt"
  static void fields(auto& f, auto& a) { f(a.code); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
/// The pseudocode in English, whatever the language.
struct SetEnglishCode {
  static constexpr std::string_view word = "english-code";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(auto& state) const { state.appearance.english_code = on; }
};
struct SetUiScale {
  static constexpr std::string_view word = "ui-scale";
  double scale;  ///< clamped
  static void fields(auto& f, auto& a) { f(a.scale); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
/// Fingers point, which are thicker than a mouse's arrow.
struct SetTouch {
  static constexpr std::string_view word = "touch";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(auto& state) const { state.appearance.touch = on; }
};
/// The window has no room for the scale: everything is drawn smaller.
struct SetFitted {
  static constexpr std::string_view word = "fitted";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true, .always = true};
  void apply(auto& state) const { state.appearance.is_fitted = on; }
};
struct SetTab {
  static constexpr std::string_view word = "tab";
  Tab tab;
  static void fields(auto& f, auto& a) { f(a.tab); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
struct ShowFront {
  static constexpr std::string_view word = "front";
  Front front;
  static void fields(auto& f, auto& a) { f(a.front); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(auto& state) const { state.appearance.front = front; }
};
/// How high the code is beside the plan, of it and the tabs below it.
struct DividePanes {
  static constexpr std::string_view word = "divide";
  double code_part;  ///< clamped; 0: as high as it wants to be
  static void fields(auto& f, auto& a) { f(a.code_part); }
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
struct DismissNotice {
  static constexpr std::string_view word = "dismiss";
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(auto& state) const {
    auto& document = state.document;
    if (document.notice && document.notice->lasts) document.failure_dismissed = true;
    document.notice.reset();
  }
};

}  // namespace raywalk::action

namespace raywalk {

/// How the window looks.
struct AppearanceRoom {
  using Actions =
      Types<action::SetTheme, action::SetLanguage, action::SetEnglishCode, action::SetUiScale, action::SetTouch,
            action::SetFitted, action::SetTab, action::ShowFront, action::DividePanes, action::DismissNotice>;
  static Commands commands();

  Theme theme = Theme::dark;
  Language language{};
  bool english_code = false;  ///< the pseudocode, whatever the language
  bool touch = false;         ///< handles are as large as a finger
  double ui_scale = 1;        ///< min_ui_scale..max_ui_scale
  bool is_fitted = false;     ///< the window has no room for that: everything is drawn smaller
  Tab tab = PictureRoom::tab;
  Front front = Front::code;
  double code_part = 0;          ///< height of the code, of it and the tabs below it; 0: as it wants
  std::vector<Tab> exchanged{};  ///< those that a person moved to the plan's place, or back from it
  bool embedded = false;         ///< in somebody's page: scene, code and transport alone, and an open lesson

  /// Whether the open tab is one of those.
  [[nodiscard]] bool exchanges() const { return std::find(exchanged.begin(), exchanged.end(), tab) != exchanged.end(); }
  /// Of the pseudocode.
  [[nodiscard]] Language code_language() const { return english_code ? language.others().english() : language; }
};

}  // namespace raywalk
