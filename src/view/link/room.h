#pragma once
// Links: a scene and a moment of its walk, in an address.

#include "view/fields.h"
#include "view/room.h"

#include <string>

namespace raywalk::action {

/// To the clipboard, of the scene and the moment as they are; if that does not fit, shows why.
struct CopyLink {
  static constexpr std::string_view word = "copy-link";
  void apply(State& state) const;
};
/// The link with its QR code, for a class to point telephones at.
struct ShowLink {
  static constexpr std::string_view word = "show-link";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
/// Where links lead to: the address of a page that shows Raywalk.
struct SetLinkPage {
  static constexpr std::string_view word = "link-page";
  std::string address;  ///< empty: this page, or on the desktop none
  static void fields(auto& f, auto& a) { f(a.address); }
  void apply(State& state) const;
};
/// Asks first if there is unsaved work. Where a dialog asks what to open, it stays if this cannot be.
struct OpenLink {
  static constexpr std::string_view word = "open-link";
  std::string link;  ///< a whole address, or what stands in it from the # on
  static void fields(auto& f, auto& a) { f(a.link); }
  static constexpr Traits traits{.answers_prompt = true, .of_own_scene = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// Links: where they lead to, and the one that is shown.
struct LinkRoom {
  using Actions = Types<action::CopyLink, action::ShowLink, action::SetLinkPage, action::OpenLink>;
  static Commands commands();

  std::string page;      ///< as chosen; empty: `own_page`
  std::string own_page;  ///< where this page is; empty on the desktop
  bool shown = false;
  std::string letters;  ///< of the link that is shown, from the # on; empty: none
  std::string why_not;  ///< why there is none
  std::string copied;   ///< for the clipboard
  int copies = 0;       ///< changes whenever something is copied
};

}  // namespace raywalk
