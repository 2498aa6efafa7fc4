// Links: their commands, and the dialog that shows one with its QR code.

#include "view/link/link.h"
#include "gui/command.h"
#include "gui/dialogs.h"
#include "gui/style.h"
#include "gui/widgets.h"
#include "view/link/qr_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace raywalk {

namespace {

/// Black on white in every theme: not all telephones read the reverse.
void draw_code(const Ui& ui, const QrCode& code, float most) {
  const int squares = code.side + 2 * qr_border;
  const float edge = std::max(std::floor(most / static_cast<float>(squares)), 1.0f);  // whole pixels are sharp
  const float whole = edge * static_cast<float>(squares);
  ImGui::SetCursorPosX((ImGui::GetWindowWidth() - whole) / 2);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + whole, at.y + whole}, IM_COL32_WHITE);
  for (int row = 0; row < code.side; ++row)
    for (int column = 0; column < code.side; ++column) {
      if (!code.is_dark(column, row)) continue;
      const ImVec2 corner{at.x + edge * static_cast<float>(column + qr_border),
                          at.y + edge * static_cast<float>(row + qr_border)};
      draw.AddRectFilled(corner, {corner.x + edge, corner.y + edge}, IM_COL32_BLACK);
    }
  ImGui::Dummy({whole, whole});
  ui.publish("link-code");
}

/// As much of an address as a few lines hold; it has no spaces to break it at.
std::string in_some_lines(const std::string& address, float width) {
  constexpr int most = 3;
  const ImFont& font = *ImGui::GetFont();
  std::string lines;
  const char *at = address.c_str(), *const end = at + address.size();
  for (int line = 1; at < end; ++line) {
    const char* next = font.CalcWordWrapPositionA(ImGui::GetFontSize() / font.FontSize, at, end, width);
    next = std::max(next, at + 1);
    const bool is_cut = line == most && next < end;
    lines += std::string(at, is_cut ? next - 1 : next) + (is_cut ? "\u2026" : next < end ? "\n" : "");
    if (is_cut) break;
    at = next;
  }
  return lines;
}

/// The address of the page that links lead to.
void page_field(const Ui& ui) {
  constexpr std::size_t longest = 1024;
  std::array<char, longest> typed{};
  std::strncpy(typed.data(), ui.state.link.page.c_str(), typed.size() - 1);
  label(ui.colours.dim_text, ui.say("link.page"));
  ImGui::SetNextItemWidth(-1);
  const std::string& own = ui.state.link.own_page;
  if (ImGui::InputTextWithHint("##page", own.empty() ? "https://example.org/raywalk/" : own.c_str(), typed.data(),
                               typed.size()))
    ui.act(action::SetLinkPage{typed.data()});
  ui.publish("link-page");
  if (page_of_links(ui.state).empty()) paragraph(ui.colours.dim_text, ui.say("link.no_page"));
}

}  // namespace

void link_dialog(const Ui& ui) {
  const LinkRoom& link = ui.state.link;
  if (!link.shown || ui.state.document.question || ui.state.document.prompt != PathPrompt::none) return;
  const ImVec2 whole = ImGui::GetMainViewport()->Size;
  const float width = std::min(ui.px(600), whole.x);
  ImGui::SetNextWindowPos({whole.x / 2, whole.y / 2}, 0, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, whole.y});
  ImGui::SetNextWindowSize({width, 0});
  const std::string id = ui.say("link.title") + "###link";
  if (!ImGui::IsPopupOpen(id.c_str())) ImGui::OpenPopup(id.c_str());
  if (!ImGui::BeginPopupModal(id.c_str(), nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return;
  std::optional<FingerFields> fields(ui);
  const std::string address = address_shown(ui.state);
  const ImVec2 large{ui.px(150), ImGui::GetFrameHeight()};
  if (address.empty()) {
    paragraph(ui.colours.text, link.why_not);
    ImGui::Dummy({1, ui.px(8)});
    if (button(ui, "link-save", command_label(command("save-as"), ui.state),
               command_hint(command("save-as"), ui.state.appearance.language), large, {.look = Look::primary})) {
      ui.act(action::ShowLink{false});
      ui.act(action::AskSaveAs{});
    }
  } else {
    if (const auto code = qr_code(address))
      draw_code(ui, *code, std::min(width - ui.px(60), whole.y - ui.px(270)));
    else
      paragraph(ui.colours.dim_text, ui.say("link.no_code", {{"letters", address.size()}, {"most", max_qr_letters}}));
    push_font(ui.fonts.small);
    label(ui.colours.text, in_some_lines(address, ImGui::GetContentRegionAvail().x));
    ui.publish("link-address");
    pop_font();
    page_field(ui);
    ImGui::Dummy({1, ui.px(4)});
    if (button(ui, "link-copy", command_label(command("copy-link"), ui.state),
               command_hint(command("copy-link"), ui.state.appearance.language), large, {.look = Look::primary}))
      ui.act(action::CopyLink{});
  }
  ImGui::SameLine();
  if (button(ui, "link-close", ui.say("dialog.close"), "", large, {})) ui.act(action::ShowLink{false});
  fields.reset();
  ImGui::EndPopup();
}

bool link_by_key(const KeyPress& press, const Ui& ui) {
  const LinkRoom& link = ui.state.link;
  if (!link.shown) return false;
  if (press.key == "Escape" || (press.key == "Enter" && link.letters.empty()))
    ui.act(action::ShowLink{false});
  else if (press.key == "Enter")
    ui.act(action::CopyLink{});
  return true;
}

Commands LinkRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "copy-link", .keys = {"Ctrl+Shift+E"}, .section = Section::save, .line = "keys.files",
       .run = act<action::CopyLink>},
      {.name = "show-link", .keys = {"Alt+L"}, .section = Section::save, .line = "keys.files", .run = act<action::ShowLink, true>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
