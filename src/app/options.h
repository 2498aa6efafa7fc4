#pragma once
// Declares command line options: each with its parser, and its message if that fails.

#include "app/arguments.h"
#include "app/console.h"
#include "app/drawing.h"
#include "image/image_file.h"
#include "math/words.h"
#include "text/error.h"
#include "text/spelling.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

/// The action of a command line, run after parsing all of it.
using Run = std::function<ExitCode()>;
inline constexpr const char* to_standard_output = "standard output is /dev/stdout";
inline constexpr const char* scene_help =
    "A scene file (.toml, .nff, or .test of ray tracing courses), a mesh (.ply, .obj, .gltf, .glb), or the name of a "
    "scene that comes with Raywalk";

/// A value that an option's own check refuses, and what to do about it.
class RefusedValue : public CLI::ParseError {
 public:
  RefusedValue(const std::string& option, raywalk::Error why)
      : CLI::ParseError(option + ": " + raywalk::Error{why.file, why.line, why.column, why.message, ""}.text(),
                        CLI::ExitCodes::ValidationError),
        hint(std::move(why.hint)) {}

  std::string hint;
};

namespace detail {
template <class Value>
void store_value(Value& target, const Value& value) {
  target = value;
}
template <class Value>
void store_value(std::optional<Value>& target, const Value& value) {
  target.emplace(value);
}
}  // namespace detail

/// An option whose value `parse` reads; if it returns nothing, `complain` says why.
template <class Target, class Parse, class Complain>
CLI::Option* add_value(CLI::App& command, const std::string& name, Target& target, const Parse& parse,
                       const Complain& complain, const std::string& type, const std::string& help) {
  const CLI::callback_t take = [name, &target, parse, complain](const CLI::results_t& words) {
    const auto value = parse(words.front());
    if (!value) throw CLI::ValidationError(name, "\"" + words.front() + "\" " + complain(words.front()));
    detail::store_value(target, *value);
    return true;
  };
  return command.add_option(name, take, help)->type_name(type);
}

template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Target& target, Parse parse,
                        const std::string& type, const std::string& expected, const std::string& help) {
  const auto complain = [expected](const std::string&) { return "is not understood (expected " + expected + ")"; };
  return add_value(command, name, target, parse, complain, type, help);
}

/// An option that takes one of a few words.
template <Worded Choice, class Target>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Target& target, const std::string& help) {
  const std::vector<std::string_view> words = all_words<Choice>();
  const auto complain = [words](const std::string& word) {
    const std::string meant = nearest_word(word, words);
    return "is not known (expected " + one_of(words) + ")" + (meant.empty() ? "" : "; did you mean " + meant + "?");
  };
  return add_value(command, name, target, named<Choice>, complain, fmt::format("{}", fmt::join(words, "|")), help);
}

/// An option that names a file or a folder. An empty name, as from an unset shell variable, does not mean absent; and
/// "-", standard output elsewhere, is no name here. `instead`: what to write for it, where there is something.
template <class Target>
CLI::Option* add_file(CLI::App& command, const std::string& name, Target& target, const std::string& type,
                      const std::string& help, const std::string& instead = "") {
  const auto parse = [](const std::string& word) {
    return word.empty() || word == "-" ? std::nullopt : std::optional(word);
  };
  const auto complain = [instead](const std::string& word) {
    return "names no file (expected a name" + (word.empty() || instead.empty() ? "" : "; " + instead) + ")";
  };
  return add_value(command, name, target, parse, complain, type, help);
}

/// The option -o of a picture, whose ending says its format; `or_drawing`: it may be a drawing, too.
template <class Target>
CLI::Option* add_image(CLI::App& command, Target& target, const std::string& help, bool or_drawing = false) {
  const auto ending = [=](const std::string& path) {
    const auto format = image_format_of(path);
    if (format || (or_drawing && is_drawing(path))) return std::string();
    raywalk::Error why = format.error();
    if (or_drawing) why.hint += ", .svg for a drawing by beams";
    throw RefusedValue("--output", why);
  };
  return add_file(command, "-o,--output", target, "IMAGE", help)->check(CLI::Validator(ending, "", "ending"));
}

/// --part, one share of many.
inline CLI::Option* add_part(CLI::App& command, std::optional<Share>& target, const std::string& help) {
  return add_parsed(
      command, "--part", target, parse_part, "I/N",
      fmt::format(
          "two whole numbers, the first from 1 to the second, this up to {}, such as 3/7 for the third of seven",
          max_parts),
      help);
}

inline CLI::Option* add_whole(CLI::App& command, const std::string& name, auto& target, int low, int high,
                              const std::string& help) {
  return add_parsed(
      command, name, target, [=](const std::string& text) { return parse_whole(text, low, high); }, "N",
      "a whole number from " + std::to_string(low) + " to " + std::to_string(high), help);
}

}  // namespace raywalk
