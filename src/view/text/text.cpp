#include "view/text/text.h"

#include "math/overloaded.h"
#include "scene/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace raywalk {

namespace {

std::string met_text(const Scene& scene, const HitObject& met, Language language) {
  std::string name = shown_name(scene, met.object, language);
  if (!met.member.empty())
    name = fill("object.member_of", language, {{"member", shown_name(scene, met.member, language)}, {"group", name}});
  if (met.triangle >= 0) name = fill("object.triangle_of", language, {{"number", met.triangle}, {"mesh", name}});
  return name;
}

/// With how many more digits the shares of a sentence differ: less than a threshold must not read as equal to it.
int digits_that_differ(const Message& message, Language language) {
  std::set<double> shares;
  for (const Argument& argument : message.arguments)
    if (const auto* share = std::get_if<Fraction>(&argument.value)) shares.insert(share->value);
  constexpr int all_digits = 16;
  for (int more = 0; more < all_digits; ++more) {
    std::set<std::string> texts;
    for (const double share : shares) texts.insert(percent_text(share, language, more));
    if (texts.size() == shares.size()) return more;
  }
  return all_digits;
}

/// 3 significant digits, and all of a number that has more before its point.
std::string digits_of(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const bool whole = size >= 999.5 && size < 999999.5;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string value_text(const Scene& scene, const Argument& argument, Language language, int more_digits) {
  return std::visit(Overloaded{
                        [](int value) { return std::to_string(value); },
                        [&](double value) { return number_text(value, language); },
                        [&](const Rgbd& colour) { return colour_text(colour, language); },
                        [&](Fraction share) { return percent_text(share.value, language, more_digits); },
                        [&](RayKind kind) { return std::string(text(kind, language)); },
                        [&](const std::string& name) { return shown_name(scene, name, language); },
                        [&](const HitObject& met) { return met_text(scene, met, language); },
                    },
                    argument.value);
}

}  // namespace

std::string_view text(RayKind kind, Language language) { return family_text("ray", name_of(kind), language); }

std::string_view text(Ending ending, Language language) { return family_text("ending", name_of(ending), language); }

std::string_view text(Line line, Language language) { return family_text("line", pseudocode_of(line).id, language); }

std::string_view text(Procedure procedure, Language language) {
  return family_text("procedure", procedure_id(procedure), language);
}

/// Only characters that every font has.
std::string_view symbol(Ending ending) {
  switch (ending) {
    case Ending::hit:
      return "o";
    case Ending::missed:
      return "~";
    case Ending::blocked:
      return "x";
    case Ending::reached_light:
      return "*";
    case Ending::depth:
      return "D";
    case Ending::threshold:
      return "%";
    case Ending::total_internal_reflection:
      return "T";
    case Ending::path_length:
      return "L";
    case Ending::facing_away:
      return "/";
    case Ending::outside_cone:
      return "v";
    case Ending::wrong_side:
      return "w";
    case Ending::scattered:
      return "s";
  }
  return "";
}

std::string capitalised(std::string words) {
  if (words.empty()) return words;
  const auto is_in = [](char c, unsigned char first, unsigned char last) {
    return static_cast<unsigned char>(c) >= first && static_cast<unsigned char>(c) <= last;
  };
  constexpr char to_capital = 'A' - 'a';
  if (is_in(words[0], 'a', 'z')) words[0] = static_cast<char>(words[0] + to_capital);
  // In UTF-8 the letters from U+00E0 to U+00FE have their capitals as far before them; U+00F7 is a sign.
  if (words[0] == '\xC3' && words.size() > 1 && is_in(words[1], 0xA0, 0xBE) && words[1] != '\xB7')
    words[1] = static_cast<char>(words[1] + to_capital);
  return words;
}

std::string number_text(double value, Language language) { return typeset_power(digits_of(value), language); }

std::string percent_text(double share, Language language, int more_digits) {
  const double percent = 100 * share;
  if (percent == 0) return "0%";
  constexpr double least = 0.001;
  if (percent < least && more_digits == 0)
    return fill("number.percent_under", language, {{"percent", number_text(least, language)}});
  return typeset_number(
      percent < 1 ? fmt::format("{:.{}g}%", percent, 1 + more_digits) : fmt::format("{:.{}f}%", percent, more_digits),
      language);
}

std::string colour_text(const Rgbd& c, Language language) {
  // Values below what a display can show are shown as 0.
  const auto part = [&](double value) { return number_text(value < 5e-5 ? 0 : value, language); };
  if (c.x == c.y && c.y == c.z) return part(c.x);
  const std::string_view between = language.separator();
  return fmt::format("({}{}{}{}{})", part(c.x), between, part(c.y), between, part(c.z));
}

std::string sentence_of(const Scene& scene, const Message& message, Language language) {
  TextArguments arguments;
  const int more_digits = digits_that_differ(message, language);
  for (const Argument& argument : message.arguments) {
    if (const int* const number = std::get_if<int>(&argument.value))
      arguments.emplace_back(argument.name, *number);  // may select a plural form
    else
      arguments.emplace_back(argument.name, value_text(scene, argument, language, more_digits));
  }
  return fill(message.id, language, arguments);
}

std::string_view explanation(std::string_view property, Language language) {
  const std::string_view name = property.substr(property.rfind('.') + 1);
  const std::string* const said = language.catalogue().find("explanation." + std::string(name));
  return said == nullptr ? std::string_view() : std::string_view(*said);
}

std::string step_text(const Scene& scene, const Timeline& timeline, int position, Language language) {
  const std::string said = sentence_of(scene, describe(scene, timeline, position), language);
  const Event* event = timeline.just_run(position);
  if (event == nullptr) return said;
  const PseudocodeLine& line = pseudocode_of(event->line);
  // Nested calls are indented; a path continues within the same call.
  const bool called = line.procedure != timeline.pseudocode().lines.front().procedure;
  const int level = timeline.of_paths() ? static_cast<int>(called) : std::min(event->depth, 20);
  const std::string indented(static_cast<std::size_t>(2 * level + 2 * line.indent), ' ');
  const std::string depth = event->depth > 0 ? fmt::format("[{}]", event->depth) : "";
  return fmt::format("{:>5} {:>4}  {:<38}  {}", position, depth, indented + std::string(text(event->line, language)),
                     said);
}

std::string transcript(const Scene& scene, const Timeline& timeline, Language language) {
  std::string lines;
  for (int position = 1; position <= timeline.steps(); ++position)
    lines += step_text(scene, timeline, position, language) + "\n";
  return lines;
}

}  // namespace raywalk
