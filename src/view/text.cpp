#include "view/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/cost.h"
#include "view/update_parts.h"

namespace raywalk {

std::string fill(std::string_view pattern, const std::vector<std::string>& arguments) {
  std::string result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool placeholder = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
    const auto index = placeholder ? static_cast<std::size_t>(pattern[i + 1] - '0') : 0;
    if (!placeholder || index >= arguments.size()) {
      result += pattern[i];
      continue;
    }
    result += arguments[index];
    i += 2;
  }
  return result;
}

namespace {

std::string argument_text(const Argument& argument) {
  return std::visit(detail::Overloaded{
                        [](int value) { return std::to_string(value); },
                        [](double value) { return number_text(value); },
                        [](const Rgbd& colour) { return colour_text(colour); },
                        [](Share share) { return percent_text(share.value); },
                        [](RayKind kind) { return std::string(text(kind)); },
                        [](const std::string& name) { return name; },
                    },
                    argument);
}

}  // namespace

std::string fill(TextId id, const std::vector<std::string>& arguments) { return fill(text(id), arguments); }

std::string fill(CostText id, const std::vector<std::string>& arguments) { return fill(text(id), arguments); }

std::string fill(ScopeText id, const std::vector<std::string>& arguments) { return fill(text(id), arguments); }

std::string number_text(double value) {
  if (value == 0) return "0";
  return fmt::format("{:.3g}", value);
}

std::string percent_text(double share) {
  const double percent = 100 * share;
  if (percent == 0) return "0%";
  if (percent < 0.001) return "under 0.001%";
  return percent < 1 ? fmt::format("{:.1g}%", percent) : fmt::format("{:.0f}%", percent);
}

std::string colour_text(const Rgbd& c) {
  // What no display could show is no number worth reading out.
  const auto part = [](double value) { return number_text(value < 5e-5 ? 0 : value); };
  if (c.x == c.y && c.y == c.z) return part(c.x);
  return "(" + part(c.x) + ", " + part(c.y) + ", " + part(c.z) + ")";
}

std::string sentence_of(const Message& message) {
  std::vector<std::string> arguments;
  for (const Argument& argument : message.arguments) arguments.push_back(argument_text(argument));
  return fill(template_of(message.id), arguments);
}

std::string step_text(const Scene& scene, const Timeline& timeline, int position) {
  const Event* event = timeline.just_run(position);
  if (event == nullptr) return sentence_of(describe(scene, timeline, position));
  const PseudocodeLine& line = pseudocode_of(event->line);
  // Calls within calls stand further in; a path goes on within the same call.
  const int level = line.procedure == Procedure::follow_path ? 1 : std::min(event->depth, 20);
  const std::string indented(static_cast<std::size_t>(2 * level + 2 * line.indent), ' ');
  const std::string depth = event->depth > 0 ? fmt::format("[{}]", event->depth) : "";
  return fmt::format("{:>5} {:>4}  {:<38}  {}", position, depth, indented + std::string(line.text),
                     sentence_of(describe(scene, timeline, position)));
}

std::string transcript(const Scene& scene, const Timeline& timeline) {
  std::string lines;
  for (int position = 1; position <= timeline.steps(); ++position) lines += step_text(scene, timeline, position) + "\n";
  return lines;
}

}  // namespace raywalk
