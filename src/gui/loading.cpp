#include "gui/loading.h"

#include "gui/session.h"
#include "gui/style.h"
#include "gui/ui.h"
#include "view/text/text.h"

#include <cmath>
#include <cstdint>
#include <filesystem>

namespace raywalk {

bool takes_long_to_read(const GuiOptions& options) {
  constexpr std::uintmax_t long_file = 4 << 20;  // bytes: some 80,000 spheres, which take a third of a second
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(options.scene_path, none);
  return !none && size >= long_file;
}

void show_loading(Window& window, const Fonts& fonts, Theme theme, const std::string& words, const std::string& hint,
                  double seconds) {
  const Palette& colours = palette(theme);
  const Shades shades(theme);
  window.begin_frame(false);
  const ImVec2 extent = ImGui::GetIO().DisplaySize;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const float line = line_height(fonts, *fonts.title);
  const auto centred = [&](ImFont* font, float y, Colour colour, const std::string& text) {
    const float size = line_height(fonts, *font);
    const ImVec2 room = font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
    draw.AddText(font, size, {(extent.x - room.x) / 2, y}, to_imgui(colour), text.c_str());
  };
  const float top = extent.y / 2 - 1.5f * line;
  centred(fonts.title, top, colours.text, words);
  // How much is left is not known: a piece runs along the line.
  constexpr float share = 0.3f, rounds_a_second = 0.5f;
  const float width = extent.x * 0.4f, left = (extent.x - width) / 2, y = top + 1.7f * line, thick = line * 0.18f;
  const float at =
      (0.5f - 0.5f * std::cos(2 * 3.14159265f * rounds_a_second * static_cast<float>(seconds))) * (1 - share);
  draw.AddRectFilled({left, y}, {left + width, y + thick}, to_imgui(shades.raised), thick / 2);
  draw.AddRectFilled({left + at * width, y}, {left + (at + share) * width, y + thick}, to_imgui(shades.accent),
                     thick / 2);
  if (!hint.empty()) centred(fonts.text, y + line, colours.dim_text, hint);
  const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255; };
  window.end_frame({part(colours.window.r), part(colours.window.g), part(colours.window.b)});
}

Result<State> start_in_sight(const GuiOptions& options, Window& window, Attention& attention) {
  const Settings settings = read_settings(state_folder(options));
  const Language language = language_for(options, settings);
  const float unit = window.scale() * static_cast<float>(settings.ui_scale * theme_scale(settings.theme));
  ImGuiIO& io = ImGui::GetIO();
  const Fonts fonts =
      build_fonts(*io.Fonts, find_fonts(font_folders(options.data_dir)), unit, window.density(), language.others());
  io.FontGlobalScale = 1 / window.density();
  window.upload_fonts();
  const std::string file = std::filesystem::path(options.scene_path).filename().string();
  const std::string words = fill("files.reading_scene", language, {{"file", file}});
  // A window manager shows a window with a delay, and frames drawn before may be lost.
  constexpr int frames = 4;
  for (int i = 0; i < frames; ++i) {
    window.wait(i == 0 ? 0 : 0.03);
    show_loading(window, fonts, settings.theme, words, {}, 0);
  }
  const Attention::Watch watch(attention, Attention::To::closing);
  attention.tell([&](double seconds) {
    show_loading(window, fonts, settings.theme, words, {}, seconds);
    return false;
  });
  return start(options, Stop(attention));
}

}  // namespace raywalk
