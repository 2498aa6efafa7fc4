#include "gui/loading.h"

#include "gui/fonts.h"
#include "gui/session.h"
#include "gui/style.h"
#include "gui/ui.h"
#include "view/text/text.h"

#include <cstdint>
#include <filesystem>

namespace raywalk {

bool takes_long_to_read(const GuiOptions& options) {
  constexpr std::uintmax_t long_file = 4 << 20;  // bytes: some 80,000 spheres, which take a third of a second
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(options.scene_path, none);
  return !none && size >= long_file;
}

namespace {

void show_loading(Window& window, const GuiOptions& options) {
  const Settings settings = read_settings(state_folder(options));
  const Language language = language_for(options, settings);
  const float unit = window.scale() * static_cast<float>(settings.ui_scale * theme_scale(settings.theme));
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const Fonts fonts =
      build_fonts(*io.Fonts, find_fonts(font_folders(options.data_dir)), unit, window.density(), language.others());
  io.FontGlobalScale = 1 / window.density();
  window.upload_fonts();

  const Palette& colours = palette(settings.theme);
  const std::string file = std::filesystem::path(options.scene_path).filename().string();
  const std::string words = fill("files.reading_scene", language, {{"file", file}});
  const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255; };
  const Colour ground = colours.window;
  // A window manager shows a window with a delay, and frames drawn before may be lost.
  constexpr int frames = 4;
  for (int i = 0; i < frames; ++i) {
    window.wait(i == 0 ? 0 : 0.03);
    window.begin_frame(false);
    const ImVec2 extent = io.DisplaySize;
    const float size = line_height(fonts, *fonts.title);
    const ImVec2 room = fonts.title->CalcTextSizeA(size, FLT_MAX, 0, words.c_str());
    ImGui::GetBackgroundDrawList()->AddText(fonts.title, size, {(extent.x - room.x) / 2, (extent.y - room.y) / 2},
                                            to_imgui(colours.text), words.c_str());
    window.end_frame({part(ground.r), part(ground.g), part(ground.b)});
  }
}

}  // namespace

Result<State> start_in_sight(const GuiOptions& options, Window& window, Attention& attention) {
  show_loading(window, options);
  const Attention::Watch watch(attention, Attention::To::closing);
  return start(options, Stop(attention));
}

}  // namespace raywalk
