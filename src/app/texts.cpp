#include "app/texts.h"

#include "app/console.h"
#include "app/scene_lookup.h"

namespace raywalk {

const LanguagesRead& texts() {
  static const LanguagesRead read = read_languages(text_dir());
  return read;
}

CLI::Option* add_language(CLI::App& command, std::optional<Language>& target, const std::string& help) {
  const auto parse = [](const std::string& code) { return texts().languages->find(code); };
  const auto complain = [](const std::string& code) {
    std::vector<std::string_view> known;
    for (const Language language : texts().languages->all()) known.push_back(language.code());
    warn_of_broken_texts();
    return "is not known (expected " + one_of(known) + "): there is no " + code + ".toml in " + text_dir();
  };
  return add_value(command, "--language", target, parse, complain, "CODE", help);
}

void warn_of_broken_texts() {
  for (const Error& error : texts().broken) warn({error.text()});
}

}  // namespace raywalk
