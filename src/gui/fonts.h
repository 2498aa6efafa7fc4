#pragma once

#include "text/language.h"

#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace raywalk {

/// The faces of the interface, all non-null once built. Where Inter or JetBrains Mono is not installed, ImGui's own
/// face stands in.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* strong = nullptr;  ///< semi-bold, same size as text
  ImFont* small = nullptr;
  ImFont* title = nullptr;
  ImFont* code = nullptr;
  ImFont* code_strong = nullptr;
  float density = 1;  ///< pixels per unit that they were rasterised for
};

/// Height of a line of a face, in units.
[[nodiscard]] float line_height(const Fonts& fonts, const ImFont& font);

/// Font files by their use; an empty path where none was found.
struct FontFiles {
  std::string text, strong, code, code_strong;
  friend bool operator==(const FontFiles&, const FontFiles&) = default;
};

/// The folders that fonts are looked for in: `data_dir`/fonts, then the user's and the system's.
[[nodiscard]] std::vector<std::string> font_folders(const std::string& data_dir);
/// Looks through `folders` and their subfolders, earlier folders first. Unreadable and missing folders are skipped.
[[nodiscard]] FontFiles find_fonts(const std::vector<std::string>& folders);

/// Fills the (cleared) atlas with faces for one scale. `scale`: units per unit at 96 dots per inch, 1 and up;
/// `density`: pixels per unit. Glyphs are rasterised at the size at which they are seen, so they are crisp. They hold
/// Latin letters and the Greek of optics, and the other alphabets of the faces that texts of `languages` are written
/// in.
[[nodiscard]] Fonts build_fonts(ImFontAtlas& atlas, const FontFiles& files, float scale, float density,
                                const Languages& languages = Language().others());

}  // namespace raywalk
