#include "gui/fallback_fonts.h"

#include "text/file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

/// Calls `visit(letter)` for each character of a text, but for those beyond the 16 bits that ImGui draws.
void each_letter(std::string_view text, const auto& visit) {
  const auto six_bits = [&](std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) & 0x3FU : 0U;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead >= 0xC0 && lead < 0xE0) visit((lead & 0x1FU) << 6 | six_bits(i + 1));
    if (lead >= 0xE0 && lead < 0xF0) visit((lead & 0x0FU) << 12 | six_bits(i + 1) << 6 | six_bits(i + 2));
  }
}

/// CJK ideographs and their punctuation, kana, and the syllables of Hangul and Yi.
constexpr bool is_one_of_thousands(char16_t letter) {
  return (letter >= 0x2E80 && letter <= 0xA4CF) || (letter >= 0xAC00 && letter <= 0xD7FF) ||
         (letter >= 0xF900 && letter <= 0xFAFF) || letter >= 0xFE30;
}

void sort_once(std::u16string& letters) {
  std::sort(letters.begin(), letters.end());
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
}

/// Families with many letters, upright and of usual weight, that read well beside Inter: best first.
constexpr std::array<std::string_view, 20> families{"NotoSans-Regular",
                                                    "NotoSansCJK-Regular",
                                                    "NotoSansGeorgian",
                                                    "NotoSansArmenian",
                                                    "NotoSansThai",
                                                    "NotoSansEthiopic",
                                                    "NotoSansCherokee",
                                                    "NotoSansSymbols",
                                                    "DejaVuSans.",
                                                    "FreeSans.",
                                                    "DroidSansFallback",
                                                    "SourceHanSans",
                                                    "wqy-microhei",
                                                    "segoeui.",
                                                    "msyh.",
                                                    "YuGothR",
                                                    "malgun.",
                                                    "PingFang",
                                                    "Hiragino Sans GB",
                                                    "Arial Unicode"};

/// The place of a file's family, or how many there are.
std::size_t rank_of(const fs::path& path) {
  constexpr std::array<std::string_view, 3> endings{".ttf", ".otf", ".ttc"};
  const std::string name = path.filename().string();
  if (std::find(endings.begin(), endings.end(), path.extension().string()) == endings.end()) return families.size();
  const auto family =
      std::find_if(families.begin(), families.end(), [&](std::string_view each) { return name.starts_with(each); });
  for (const std::string_view other : {"Bold", "Black", "Light", "Thin", "Medium", "Condensed", "Italic"})
    if (name.find(other) != std::string::npos) return families.size();
  return static_cast<std::size_t>(family - families.begin());
}

/// Whether it begins as TrueType, OpenType and collections of them do: ImGui gives up on anything else.
bool begins_as_font(const std::string& file) {
  std::array<char, 4> head{};
  if (std::FILE* const opened = std::fopen(file.c_str(), "rb")) {  // no stream, which would weigh on the page
    static_cast<void>(std::fread(head.data(), 1, head.size(), opened));
    std::fclose(opened);
  }
  constexpr std::array<std::string_view, 4> heads{std::string_view("\0\1\0\0", 4), "OTTO", "true", "ttcf"};
  return std::find(heads.begin(), heads.end(), std::string_view(head.data(), head.size())) != heads.end();
}

#if IMGUI_VERSION_NUM < 19200
/// Which of the letters a face has: as ImGui finds it, in small.
std::u16string had_by(const std::string& file, const std::u16string& letters) {
  constexpr float tiny = 6;
  ImFontAtlas atlas;
  const std::vector<ImWchar> ranges = ranges_of(letters);
  const ImFont* const face = atlas.AddFontFromFileTTF(file.c_str(), tiny, nullptr, ranges.data());
  std::u16string had;
  if (face == nullptr || !atlas.Build()) return had;
  std::copy_if(letters.begin(), letters.end(), std::back_inserter(had),
               [&](char16_t letter) { return face->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr; });
  return had;
}
#endif

}  // namespace

std::vector<ImWchar> ranges_of(const std::u16string& letters) {
  std::vector<ImWchar> ranges;
  for (const char16_t letter : letters) {
    const auto number = static_cast<ImWchar>(letter);
    if (ranges.empty() || ranges.back() + 1 != letter)
      ranges.insert(ranges.end(), {number, number});
    else
      ranges.back() = number;
  }
  ranges.push_back(0);
  return ranges;
}

void add_letters_beyond(std::string_view text, std::u16string& letters) {
  each_letter(text, [&](unsigned letter) {
    if (!is_letter_of_inter(static_cast<char16_t>(letter))) letters += static_cast<char16_t>(letter);
  });
  sort_once(letters);
}

std::u16string letters_beyond(const Languages& languages, const std::string& lessons) {
  std::u16string letters;
  for (const Language language : languages.all()) {
    const std::size_t before = letters.size();
    for (const std::string_view id : language.catalogue().ids())
      add_letters_beyond(*language.catalogue().find(id), letters);
    if (letters.size() == before) continue;  // then its lessons need none either
    constexpr std::size_t most = 1 << 20;
    std::error_code error;
    for (fs::directory_iterator entry(lessons, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
      if (const auto words = read_file((entry->path() / (std::string(language.code()) + ".md")).string(), most))
        add_letters_beyond(*words, letters);
  }
  std::u16string all;
  constexpr char16_t block = 0x80;
  for (const char16_t letter : letters) {
    all += letter;
    if (is_one_of_thousands(letter)) continue;
    const auto first = static_cast<char16_t>(letter & ~(block - 1U));
    for (char16_t i = 0; i < block; ++i) all += static_cast<char16_t>(first + i);
  }
  sort_once(all);
  std::erase_if(all, [](char16_t letter) { return is_letter_of_inter(letter); });
  return all;
}

void find_fallbacks([[maybe_unused]] FontFiles& files, [[maybe_unused]] const std::vector<std::string>& folders,
                    [[maybe_unused]] std::u16string letters) {
  files.letters = letters;
  if (letters.empty()) return;
  std::set<std::pair<std::size_t, std::string>> found;  // by rank
  constexpr int deepest = 5, max_entries = 20000;
  for (const std::string& folder : folders) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (int count = 0; !error && entry != fs::recursive_directory_iterator() && count < max_entries; ++count) {
      if (entry.depth() >= deepest) entry.disable_recursion_pending();
      if (const std::size_t rank = rank_of(entry->path()); rank < families.size())
        found.emplace(rank, entry->path().string());
      entry.increment(error);
    }
  }
  for (const auto& [rank, file] : found) {
    if (!begins_as_font(file)) continue;
#if IMGUI_VERSION_NUM < 19200
    const std::u16string had = had_by(file, letters);
    if (had.empty()) continue;
    std::erase_if(letters, [&](char16_t letter) { return std::binary_search(had.begin(), had.end(), letter); });
#endif
    files.more.push_back(file);
    if (letters.empty()) break;
  }
}

}  // namespace raywalk
