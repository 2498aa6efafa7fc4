#pragma once

#include "text/language.h"

#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace raywalk {

/// The fonts of the interface, all non-null once built. If Inter or JetBrains Mono is not installed, ImGui's own font
/// is used.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* strong = nullptr;  ///< semi-bold, same size as text
  ImFont* small = nullptr;
  ImFont* title = nullptr;
  ImFont* code = nullptr;
  ImFont* code_strong = nullptr;
  float density = 1;  ///< pixels per unit at rasterisation
};

/// Height of a line of a face, in units.
[[nodiscard]] float line_height(const Fonts& fonts, const ImFont& font);

/// Font files by use; an empty path if none was found.
struct FontFiles {
  std::string text, strong, code, code_strong;
  std::vector<std::string> more{};  ///< for what the others lack (gui/fallback_fonts.h), best first
  std::u16string letters{};         ///< sorted: those that are wanted from them
  friend bool operator==(const FontFiles&, const FontFiles&) = default;
};

/// The folders searched for fonts: `data_dir`/fonts, then the user's and the system's.
[[nodiscard]] std::vector<std::string> font_folders(const std::string& data_dir);
/// Searches `folders` recursively, earlier folders first. Unreadable and missing folders are skipped.
[[nodiscard]] FontFiles find_fonts(const std::vector<std::string>& folders);

/// Whether it is in the alphabets, or among the signs, that Inter is used for.
[[nodiscard]] bool is_letter_of_inter(char16_t letter);

/// Fills the atlas with faces for one scale, in place of all that it held. `scale`: units per unit at 96 dots per inch,
/// 1 and up; `density`: pixels per unit. Glyphs are rasterised at their displayed size, so they are crisp: Latin
/// letters and the Greek of optics, and other alphabets used by `languages`.
[[nodiscard]] Fonts build_fonts(ImFontAtlas& atlas, const FontFiles& files, float scale, float density,
                                const Languages& languages = Language().others());

}  // namespace raywalk
