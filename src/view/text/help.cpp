// The text of help mode.

#include "view/text/text.h"

namespace raywalk {

namespace {

using action::ObjectKind;

struct Entry {
  std::string_view term, text;  ///< ids; a paragraph has no term
  std::optional<ObjectKind> picture{};
};
struct Section {
  std::string_view title;  ///< the id
  std::vector<Entry> entries;
};

/// In reading order.
const std::vector<Section>& sections() {
  static const std::vector<Section> all{
      {"help.what.title", {{"", "help.what.text"}}},
      {"help.plan.title",
       {{"object.eye", "help.plan.eye"},
        {"object.screen", "help.plan.screen"},
        {"name.Solid Sphere", "help.plan.solid_sphere", ObjectKind::solid_sphere},
        {"name.Transparent Sphere", "help.plan.transparent_sphere", ObjectKind::transparent_sphere},
        {"name.Polygon", "help.plan.polygon", ObjectKind::polygon},
        {"name.Light Source", "help.plan.light_source", ObjectKind::light}}},
      {"help.modes.title",
       {{"command.mode_move.label", "help.modes.move"},
        {"command.mode_trace.label", "help.modes.trace"},
        {"command.mode_help.label", "help.modes.help"}}},
      {"help.buttons.title",
       {{"command.step.label", "help.buttons.step"},
        {"command.step_back.label", "help.buttons.back"},
        {"command.play.label", "help.buttons.auto"},
        {"command.clear.label", "help.buttons.clear"},
        {"help.buttons.the_bar_term", "help.buttons.the_bar"},
        {"help.buttons.over_out_term", "help.buttons.over_out"},
        {"command.predict.label", "help.buttons.predict"},
        {"command.tab_structure.label", "help.buttons.structure"},
        {"help.buttons.breakpoints_term", "help.buttons.breakpoints"}}},
      {"help.lessons.title", {{"", "help.lessons.text"}}},
      {"help.bugs.title", {{"", "help.bugs.text"}}},
      {"help.ink.title", {{"", "help.ink.text"}}},
      {"help.links.title", {{"", "help.links.text"}}},
      {"help.panels.title",
       {{"help.panels.code_term", "help.panels.code"},
        {"command.tab_image.label", "help.panels.image"},
        {"command.lines.label", "help.panels.lines_in_space"},
        {"command.tab_tree.label", "help.panels.ray_tree"},
        {"command.tab_equation.label", "help.panels.equation"},
        {"command.tab_microscope.label", "help.panels.microscope"},
        {"command.tab_stack.label", "help.panels.stack"},
        {"command.tab_legend.label", "help.panels.legend"},
        {"command.tab_cost.label", "help.panels.cost"}}},
      {"help.numbers.title",
       {{"property.ambient", "explanation.ambient"},
        {"property.diffuse", "explanation.diffuse"},
        {"property.specular", "explanation.specular"},
        {"property.shininess", "explanation.shininess"},
        {"property.reflection", "explanation.reflection"},
        {"property.transmission", "explanation.transmission"},
        {"property.ior", "explanation.ior"},
        {"property.dielectric", "explanation.dielectric"},
        {"property.shadow", "explanation.shadow"},
        {"property.emission", "explanation.emission"},
        {"property.checker", "explanation.checker"},
        {"property.strength", "explanation.strength"},
        {"property.attenuation", "explanation.attenuation"},
        {"property.background", "explanation.background"},
        {"property.sky", "explanation.sky"},
        {"property.scene_ambient", "explanation.scene_ambient"},
        {"property.limits_depth", "explanation.limits_depth"},
        {"property.threshold", "explanation.threshold"}}},
      {"help.endings.title",
       {{"ending.hit", "help.endings.hit"},
        {"ending.missed", "help.endings.left_the_scene"},
        {"ending.blocked", "help.endings.blocked"},
        {"ending.reached_light", "help.endings.reached_the_light"},
        {"help.endings.depth_limit_term", "help.endings.depth_limit"},
        {"help.endings.share_too_small_term", "help.endings.share_too_small"},
        {"help.endings.total_internal_reflection_term", "help.endings.total_internal_reflection"},
        {"help.endings.faces_away_term", "help.endings.faces_away"},
        {"help.endings.outside_cone_term", "help.endings.outside_cone"},
        {"help.endings.wrong_side_term", "help.endings.wrong_side"},
        {"help.endings.path_length_term", "help.endings.path_length"},
        {"ending.scattered", "help.endings.scattered"}}},
      {"help.credits.title", {{"", "help.credits.text"}}},
  };
  return all;
}

}  // namespace

std::vector<HelpSection> help(Language language) {
  std::vector<HelpSection> all;
  for (const Section& section : sections()) {
    HelpSection& said = all.emplace_back(HelpSection{fill(section.title, language), {}});
    for (const Entry& entry : section.entries)
      said.entries.push_back(
          {entry.term.empty() ? std::string() : fill(entry.term, language), fill(entry.text, language), entry.picture});
  }
  return all;
}

}  // namespace raywalk
