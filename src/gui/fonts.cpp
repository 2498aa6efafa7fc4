#include "gui/fonts.h"

#include "gui/fallback_fonts.h"

#include <imgui.h>
#if __has_include(<imgui_freetype.h>)
#include <imgui_freetype.h>
#define RAYWALK_FREETYPE 1
#elif __has_include(<misc/freetype/imgui_freetype.h>)
#include <misc/freetype/imgui_freetype.h>
#define RAYWALK_FREETYPE 1
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

// Heights of a line at scale 1, in units; letters are about four fifths of it.
constexpr float text_size = 17, small_size = 15, title_size = 23, code_size = 18;

// Characters of the texts and the panes: Latin with accents, the Greek of optics, typographic marks, super- and
// subscripts, arrows, the mathematics of the sentences, and a few shapes.
constexpr std::array<ImWchar, 25> glyphs{0x0020, 0x017F, 0x0391, 0x03C9, 0x2010, 0x2027, 0x2032, 0x2033, 0x2070,
                                         0x209C, 0x2190, 0x2199, 0x21BA, 0x21BB, 0x2200, 0x2265, 0x22C5, 0x22C5,
                                         0x25A0, 0x25CF, 0x2713, 0x2717, 0xFFFD, 0xFFFD, 0};

// A superscript that JetBrains Mono lacks.
constexpr std::array<ImWchar, 3> raised_minus{0x207B, 0x207B, 0};

// Further alphabets of Inter, as Unicode blocks: extended Latin, Greek, Cyrillic, Vietnamese, polytonic Greek.
struct Alphabet {
  ImWchar first, last;
};
constexpr std::array alphabets{Alphabet{0x0180, 0x024F}, Alphabet{0x0370, 0x03FF}, Alphabet{0x0400, 0x052F},
                               Alphabet{0x1E00, 0x1EFF}, Alphabet{0x1F00, 0x1FFF}};

#if IMGUI_VERSION_NUM < 19200  // later ones draw each glyph on first use
// `glyphs`, with the alphabets that are needed: each enlarges the atlas.
std::vector<ImWchar> glyphs_for(const Languages& languages) {
  std::array<bool, alphabets.size()> needed{};
  const auto need = [&](unsigned letter) {
    for (std::size_t i = 0; i + 1 < glyphs.size(); i += 2)
      if (letter >= glyphs[i] && letter <= glyphs[i + 1]) return;
    for (std::size_t i = 0; i < alphabets.size(); ++i)
      needed[i] = needed[i] || (letter >= alphabets[i].first && letter <= alphabets[i].last);
  };
  for (const Language language : languages.all()) {
    for (const std::string_view id : language.catalogue().ids()) {
      const std::string& words = *language.catalogue().find(id);
      const auto six_bits = [&](std::size_t at) { return static_cast<unsigned char>(words[at]) & 0x3FU; };
      for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const auto lead = static_cast<unsigned char>(words[i]);
        if (lead >= 0xC0 && lead < 0xE0)
          need((lead & 0x1FU) << 6 | six_bits(i + 1));
        else if (lead >= 0xE0 && lead < 0xF0 && i + 2 < words.size())
          need((lead & 0x0FU) << 12 | six_bits(i + 1) << 6 | six_bits(i + 2));
      }
    }
  }
  std::vector<ImWchar> ranges(glyphs.begin(), glyphs.end() - 1);
  for (std::size_t i = 0; i < alphabets.size(); ++i)
    if (needed[i]) ranges.insert(ranges.end(), {alphabets[i].first, alphabets[i].last});
  ranges.push_back(0);
  return ranges;
}
#endif

struct Wanted {
  std::string FontFiles::* use;
  std::array<const char*, 3> names;  // best first; packages name the same face differently
};

constexpr std::array<Wanted, 4> wanted_faces{{
    {&FontFiles::text, {"Inter-Regular.otf", "Inter-Regular.ttf", "Inter.ttf"}},
    {&FontFiles::strong, {"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "Inter-Bold.otf"}},
    {&FontFiles::code, {"JetBrainsMono-Regular.ttf", "JetBrainsMono-Regular.otf", "JetBrainsMonoNL-Regular.ttf"}},
    {&FontFiles::code_strong, {"JetBrainsMono-Bold.ttf", "JetBrainsMono-Bold.otf", "JetBrainsMonoNL-Bold.ttf"}},
}};

// Notes `path` if its name is wanted and no better one was found.
void note(FontFiles& found, const fs::path& path) {
  const std::string name = path.filename().string();
  for (const Wanted& want : wanted_faces) {
    const auto rank = [&](const std::string& file) {
      return std::find(want.names.begin(), want.names.end(), file) - want.names.begin();
    };
    std::string& place = found.*want.use;
    if (rank(name) < rank(fs::path(place).filename().string())) place = path.string();
  }
}

bool complete(const FontFiles& files) {
  return std::all_of(wanted_faces.begin(), wanted_faces.end(),
                     [&](const Wanted& want) { return !(files.*want.use).empty(); });
}

}  // namespace

std::vector<std::string> font_folders(const std::string& data_dir) {
  std::vector<std::string> folders;
  if (!data_dir.empty()) folders.push_back(data_dir + "/fonts");
  if (const char* home = std::getenv("HOME")) {
    for (const char* folder : {"/.local/share/fonts", "/.fonts", "/Library/Fonts"})
      folders.push_back(std::string(home) + folder);
  }
  // The folders of Debian's packages before the whole tree of fonts, which can be large.
  for (const char* folder : {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/inter",
                             "/usr/share/fonts/truetype/jetbrains-mono", "/usr/local/share/fonts", "/usr/share/fonts",
                             "/Library/Fonts", "C:/Windows/Fonts"})
    folders.emplace_back(folder);
  return folders;
}

FontFiles find_fonts(const std::vector<std::string>& folders) {
  constexpr int deepest = 4, max_entries = 20000;
  FontFiles found;
  for (const std::string& folder : folders) {
    FontFiles here;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (int count = 0; !error && entry != fs::recursive_directory_iterator() && count < max_entries; ++count) {
      if (entry.depth() >= deepest) entry.disable_recursion_pending();
      std::error_code no_file;
      if (entry->is_regular_file(no_file)) note(here, entry->path());
      entry.increment(error);
    }
    for (const Wanted& want : wanted_faces) {
      if ((found.*want.use).empty()) found.*want.use = here.*want.use;
    }
    if (complete(found)) break;
  }
  return found;
}

bool is_letter_of_inter(char16_t letter) {
  for (std::size_t i = 0; i + 1 < glyphs.size(); i += 2)
    if (letter >= glyphs[i] && letter <= glyphs[i + 1]) return true;
  return std::any_of(alphabets.begin(), alphabets.end(),
                     [&](const Alphabet& each) { return letter >= each.first && letter <= each.last; });
}

float line_height(const Fonts& fonts, const ImFont& font) {
#if IMGUI_VERSION_NUM >= 19200
  return font.LegacySize / fonts.density;
#else
  return font.FontSize / fonts.density;
#endif
}

Fonts build_fonts(ImFontAtlas& atlas, const FontFiles& files, float scale, float density,
                  [[maybe_unused]] const Languages& languages) {
  atlas.Clear();  // what an earlier call put there points to ranges that are gone
#ifdef RAYWALK_FREETYPE
#if IMGUI_VERSION_NUM >= 19200
  atlas.SetFontLoader(ImGuiFreeType::GetFontLoader());
#else
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
#endif
#endif
#if IMGUI_VERSION_NUM >= 19200
  density = 1;  // glyphs are rasterised on demand, at the framebuffer's density
  const ImWchar* const ranges = nullptr;
  const ImWchar* const more_ranges = nullptr;
#else
  const std::vector<ImWchar> wanted_glyphs = glyphs_for(languages);  // used until the atlas is built, below
  const ImWchar* const ranges = wanted_glyphs.data();
  const std::vector<ImWchar> more_glyphs = ranges_of(files.letters);
  const ImWchar* const more_ranges = more_glyphs.data();
#endif
  // A file may be unreadable, or not a font despite its name: then ImGui's own font.
  const auto face = [&](const std::string& file, const std::string& fallback, float size) {
    ImFontConfig config;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    const float pixels = std::round(size * scale * density);
    const auto from_file = [&](const std::string& name, const ImWchar* letters) -> ImFont* {
      std::error_code error;
      if (name.empty() || fs::file_size(name, error) == 0 || error) return nullptr;
      return atlas.AddFontFromFileTTF(name.c_str(), pixels, &config, letters);
    };
    ImFont* font = from_file(file, ranges);
    if (font == nullptr) font = from_file(fallback, ranges);
    if (font == nullptr) {
      config.SizePixels = pixels;
      font = atlas.AddFontDefault(&config);
    }
    // Where several have a letter, ImGui takes that of the first.
    config.MergeMode = true;
    if (file != files.text) from_file(files.text, raised_minus.data());
    for (const std::string& name : files.more) from_file(name, more_ranges);
    return font;
  };
  Fonts fonts;
  fonts.density = density;
  fonts.text = face(files.text, "", text_size);
  fonts.strong = face(files.strong, files.text, text_size);
  fonts.small = face(files.text, "", small_size);
  fonts.title = face(files.strong, files.text, title_size);
  fonts.code = face(files.code, files.text, code_size);
  fonts.code_strong = face(files.code_strong, files.code, code_size);
#if IMGUI_VERSION_NUM < 19200
  atlas.Build();
#endif
  return fonts;
}

}  // namespace raywalk
