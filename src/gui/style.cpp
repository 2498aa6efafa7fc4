#include "gui/style.h"

#include "gui/ui.h"

namespace raywalk {

Shades::Shades(Theme theme) {
  const Palette& p = palette(theme);
  raised = mix(p.panel, p.text, 0.09);
  raised_hovered = mix(p.panel, p.text, 0.17);
  raised_held = mix(p.panel, p.text, 0.26);
  line = mix(p.panel, p.text, 0.16);
  accent = theme == Theme::dark ? Colour{72, 132, 214} : Colour{20, 92, 178};
  accent_hovered = mix(accent, p.text, theme == Theme::dark ? 0.15 : 0.2);
  accent_held = mix(accent, p.text, theme == Theme::dark ? 0.3 : 0.35);
  on_accent = {255, 255, 255};
}

void set_style(ImGuiStyle& style, Theme theme, float unit) {
  const Palette& p = palette(theme);
  const Shades s(theme);
  style = ImGuiStyle();
  style.WindowPadding = {14, 12};
  style.FramePadding = {10, 6};
  style.ItemSpacing = {8, 8};
  style.ItemInnerSpacing = {8, 6};
  style.CellPadding = {6, 4};
  style.IndentSpacing = 18;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 14;
  style.WindowRounding = 8;
  style.ChildRounding = 0;
  style.FrameRounding = 6;
  style.PopupRounding = 8;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 5;
  style.TabRounding = 6;
  style.ScaleAllSizes(unit);
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.ChildBorderSize = style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.5f, 0.5f};
  style.DisabledAlpha = 0.4f;

  const auto set = [&](ImGuiCol which, Colour colour) { style.Colors[which] = to_imgui4(colour); };
  set(ImGuiCol_Text, p.text);
  set(ImGuiCol_TextDisabled, p.dim_text);
  set(ImGuiCol_WindowBg, p.window);
  set(ImGuiCol_ChildBg, p.panel);
  set(ImGuiCol_PopupBg, mix(p.panel, p.text, 0.03));
  set(ImGuiCol_Border, s.line);
  set(ImGuiCol_BorderShadow, {0, 0, 0, 0});
  set(ImGuiCol_FrameBg, s.raised);
  set(ImGuiCol_FrameBgHovered, s.raised_hovered);
  set(ImGuiCol_FrameBgActive, s.raised_held);
  set(ImGuiCol_TitleBg, p.panel);
  set(ImGuiCol_TitleBgActive, p.panel);
  set(ImGuiCol_MenuBarBg, p.window);
  set(ImGuiCol_ScrollbarBg, {0, 0, 0, 0});
  set(ImGuiCol_ScrollbarGrab, s.raised_hovered);
  set(ImGuiCol_ScrollbarGrabHovered, s.raised_held);
  set(ImGuiCol_ScrollbarGrabActive, s.raised_held);
  set(ImGuiCol_CheckMark, s.accent);
  set(ImGuiCol_SliderGrab, s.accent);
  set(ImGuiCol_SliderGrabActive, s.accent_hovered);
  set(ImGuiCol_Button, s.raised);
  set(ImGuiCol_ButtonHovered, s.raised_hovered);
  set(ImGuiCol_ButtonActive, s.raised_held);
  set(ImGuiCol_Header, s.raised);
  set(ImGuiCol_HeaderHovered, s.raised_hovered);
  set(ImGuiCol_HeaderActive, s.raised_held);
  set(ImGuiCol_Separator, s.line);
  set(ImGuiCol_TextSelectedBg, s.accent.with_alpha(110));
  set(ImGuiCol_NavHighlight, s.accent);
  set(ImGuiCol_ModalWindowDimBg, {0, 0, 0, 130});
}

}  // namespace raywalk
