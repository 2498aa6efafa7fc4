#include "app/misuse.h"

#include "app/options.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

namespace raywalk {

std::string name_of(const CLI::Option& option) {
  const auto& words = option.get_lnames();
  return words.empty() ? option.get_name() : "--" + words.front();
}

namespace {

/// The command that is parsed: the deepest that was chosen.
const CLI::App& chosen_command(const CLI::App& command) {
  const auto chosen = command.get_subcommands();
  return chosen.empty() ? command : chosen_command(*chosen.back());
}

/// "raywalk lesson script" while parsing it.
std::string command_name(const CLI::App& command) {
  const auto chosen = command.get_subcommands();
  return command.get_name() + (chosen.empty() ? "" : " " + command_name(*chosen.back()));
}

/// An option of `command`, or of its chosen subcommands, that takes one value and was given several.
const CLI::Option* repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw && option->get_items_expected_max() == 1 &&
        option->count() > 1)
      return option;
  for (const CLI::App* chosen : command.get_subcommands())
    if (const CLI::Option* option = repeated_option(*chosen)) return option;
  return nullptr;
}
const CLI::Option* repeated_option(const CLI::App& program, const CLI::ParseError& error) {
  return dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr ? repeated_option(program) : nullptr;
}

/// Whether words are left that nothing takes. Of them and of what is missing, CLI11 says the latter: "raywalk check
/// numrics" would lack a command.
bool has_extras(const CLI::App& program, const CLI::ParseError& error) {
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  return dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr || (lacks && program.remaining_size(true) > 0);
}

/// The commands of a command, "list, check or script"; empty when it has none.
std::string commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands({})) names.push_back(sub->get_name());
  return names.empty() ? "" : one_of({names.begin(), names.end()});
}

/// Whether the command that was chosen needs a command of its own.
bool lacks_command(const CLI::App& program, const CLI::ParseError& error) {
  return dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
         chosen_command(program).get_require_subcommand_min() > 0;
}

/// The first example of a command's help; empty when it has none.
std::string example_of(const CLI::App& command) {
  const std::string help = command.get_footer(), start = "\n  raywalk ";
  const std::size_t at = help.find(start, std::min(help.find("Example"), help.size()));
  return at == std::string::npos ? "" : help.substr(at + 3, help.find('\n', at + 1) - at - 3);
}

/// CLI11's message, improved where it is hard to read: for an option given twice it counts the values, and it lists
/// unexpected words in reverse.
std::string what_is_wrong(const CLI::App& program, const CLI::ParseError& error) {
  if (const CLI::Option* option = repeated_option(program, error))
    return name_of(*option) + " is given " +
           (option->count() == 2 ? "twice" : std::to_string(option->count()) + " times");
  if (!has_extras(program, error)) {
    if (lacks_command(program, error))
      return "a command is missing (expected " + commands_of(chosen_command(program)) + ")";
    // "--output: 1 required IMAGE missing"
    const std::string what = error.what();
    const std::size_t name = what.find(": 1 required "), end = what.rfind(" missing");
    if (name == std::string::npos || end == std::string::npos) return what;
    return fmt::format("{0} lacks its value (expected {0} {1})", what.substr(0, name),
                       what.substr(name + 13, end - name - 13));
  }
  std::string text = "not expected:";
  for (const std::string& word : program.remaining(true)) text += " " + word;
  const std::string commands = commands_of(chosen_command(program));
  return text + (commands.empty() || &chosen_command(program) == &program ? "" : " (expected " + commands + ")");
}

/// An unexpected word of the command line is most likely misspelt.
std::string hint_for(const CLI::App& program, const CLI::ParseError& error) {
  if (repeated_option(program, error) != nullptr) return "give it once";
  const CLI::App& command = chosen_command(program);
  if (has_extras(program, error)) {
    std::vector<std::string> known, words = program.remaining(true);
    // A first word that is no command was taken for a scene.
    if (&command == &program) words.insert(words.begin(), program["SCENE"]->as<std::string>());
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const CLI::App* sub : command.get_subcommands({})) known.push_back(sub->get_name());
    for (const std::string& each : words) {
      const std::string word = each.substr(0, each.find('='));
      if (std::find(known.begin(), known.end(), word) != known.end()) continue;
      const std::string meant = nearest_word(word, {known.begin(), known.end()});
      if (!meant.empty()) return fmt::format("did you mean {} for {}?", meant, word);
    }
  }
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (const std::string example = example_of(command); lacks && !example.empty()) return "such as " + example;
  return command_name(program) + " --help says what there is";
}

/// A word as a shell takes it.
std::string typed(const std::string& word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return c > 127 || std::isalnum(c) != 0 ||
           std::string_view("-_./,:=+@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (is_plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// A command line for a hint.
std::string line_of(const std::vector<std::string>& words) {
  std::string line = "raywalk";
  for (const std::string& word : words) line += " " + typed(word);
  return line;
}

/// "raywalk classic step": the scene before the command.
std::optional<Error> why_scene_misplaced(const CLI::App& program, std::vector<std::string> words) {
  const auto chosen = program.get_subcommands();
  const CLI::Option* scene = program.get_option_no_throw("SCENE");
  if (chosen.empty() || scene == nullptr || scene->count() == 0 || chosen.back()->count() > 1) return std::nullopt;
  const CLI::Option* own = chosen.back()->get_option_no_throw("SCENE");
  if (own == nullptr || own->count() > 0) return std::nullopt;  // two scenes are given
  const std::string command = chosen.back()->get_name(), given = scene->results().front();
  for (const std::string& placed : {given, command})
    if (const auto found = std::find(words.begin(), words.end(), placed); found != words.end()) words.erase(found);
  words.insert(words.begin(), {command, given});
  return Error{"", 0, 0,
               fmt::format("raywalk: the command {} comes after the scene {}; it has to come first", command, given),
               line_of(words)};
}

/// "raywalk -o classic.png render classic": an option before its command.
std::optional<Error> why_option_misplaced(const CLI::App& program, const std::vector<std::string>& words) {
  std::vector<std::string> commands, before, after;
  auto at = words.begin();
  for (const CLI::App* command = &program; !command->get_subcommands().empty();) {
    command = command->get_subcommands().back();
    const auto found = std::find(at, words.end(), command->get_name());
    if (found == words.end()) return std::nullopt;
    before.insert(before.end(), at, found);
    commands.push_back(*found);
    at = found + 1;
  }
  const auto is_its_own = [&](const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           chosen_command(program).get_option_no_throw(word.substr(0, word.find('='))) != nullptr;
  };
  const auto misplaced = std::find_if(before.begin(), before.end(), is_its_own);
  if (misplaced == before.end()) return std::nullopt;
  const std::string command = command_name(program);
  std::vector<std::string> right = commands;
  right.insert(right.end(), at, words.end());
  right.insert(right.end(), before.begin(), before.end());
  return Error{"", 0, 0,
               fmt::format("{}: {} stands before the command (expected the options of a command after its name)",
                           command, *misplaced),
               line_of(right)};
}

}  // namespace

Error misuse(const CLI::App& program, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const std::string command = command_name(program) + ": ";
  if (const auto* refused = dynamic_cast<const RefusedValue*>(&error))
    return {"", 0, 0, command + refused->what(), refused->hint};
  if (const auto misplaced = why_option_misplaced(program, words)) return *misplaced;
  if (const auto misplaced = why_scene_misplaced(program, words)) return *misplaced;
  return {"", 0, 0, command + what_is_wrong(program, error), hint_for(program, error)};
}

}  // namespace raywalk
