#include "text/languages.h"

#include "text/file.h"
#include "text/toml_text.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace raywalk {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_of_a_file = 4 << 20;

Result<Catalogue> read_catalogue(const std::string& file, const std::string& code) {
  const Result<std::string> bytes = read_file(file, max_of_a_file);
  if (!bytes) return tl::unexpected(bytes.error());
  if (const auto checked = toml_text::check(*bytes, file, "texts"); !checked) return tl::unexpected(checked.error());
  tl::expected<Catalogue, TextMistake> catalogue = Catalogue::parse(*bytes, code);
  if (!catalogue) {
    const TextMistake& mistake = catalogue.error();
    return tl::unexpected(Error{file, mistake.line, mistake.column, mistake.message, mistake.hint});
  }
  return *std::move(catalogue);
}

}  // namespace

std::vector<std::string> language_codes_in(const std::string& folder, std::string_view ending) {
  std::vector<std::string> codes;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (const std::string code = entry->path().stem().string();
        entry->path().extension() == ending && is_language_code(code) && code != "en")
      codes.push_back(code);
  std::sort(codes.begin(), codes.end());
  codes.insert(codes.begin(), "en");
  return codes;
}

LanguagesRead read_languages(const std::string& folder) {
  const auto languages = std::make_shared<Languages>();
  LanguagesRead read;
  for (const std::string& code : language_codes_in(folder, ".toml")) {
    const std::string file = (fs::path(folder) / (code + ".toml")).string();
    std::error_code ignored;
    if (!fs::exists(file, ignored)) continue;  // English, which is built in
    Result<Catalogue> catalogue = read_catalogue(file, code);
    if (catalogue)
      languages->add(*std::move(catalogue));
    else
      read.broken.push_back(catalogue.error());
  }
  read.languages = languages;
  return read;
}

}  // namespace raywalk
