#pragma once
// Texts of rays, messages and numbers, and Help. Every other text is used by its id directly (text/language.h).

#include "scene/scene.h"
#include "text/language.h"
#include "timeline/message.h"
#include "timeline/timeline.h"
#include "view/document/room.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

[[nodiscard]] std::string_view text(RayKind kind, Language language);         ///< "reflect ray"
[[nodiscard]] std::string_view text(Ending ending, Language language);        ///< a clause: "left the scene"
[[nodiscard]] std::string_view text(Line line, Language language);            ///< of the pseudocode: "Form shadow ray"
[[nodiscard]] std::string_view text(Procedure procedure, Language language);  ///< its title
[[nodiscard]] std::string_view symbol(Ending ending);                         ///< one or two characters for the tree

/// With a capital at its beginning, as a title or a sentence has it.
[[nodiscard]] std::string capitalised(std::string words);

// Numbers in the format of the language.
[[nodiscard]] std::string number_text(double value, Language language);  ///< 3 significant digits, no trailing zeros
/// "45%", "0.2%"; with one more digit "45.1%", "0.23%".
[[nodiscard]] std::string percent_text(double share, Language language, int more_digits = 0);
/// "(0.2, 0.5, 1)", in Portuguese "(0,2; 0,5; 1)", or one number for a grey.
[[nodiscard]] std::string colour_text(const Rgbd& c, Language language);

/// A message about a timeline of `scene` as one sentence.
[[nodiscard]] std::string sentence_of(const Scene& scene, const Message& message, Language language);

/// The step that leads to `position`, 1 <= position <= steps(), as one line of a transcript: number, indentation by
/// depth, the line of pseudocode and its sentence.
[[nodiscard]] std::string step_text(const Scene& scene, const Timeline& timeline, int position, Language language);
/// All steps, one per line.
[[nodiscard]] std::string transcript(const Scene& scene, const Timeline& timeline, Language language);

// ---- Properties -----------------------------------------------------------------------------------------------------

/// An explanation of a property; empty for obvious ones. `property`: the id of its name, "property.ambient".
[[nodiscard]] std::string_view explanation(std::string_view property, Language language);

// ---- Help -----------------------------------------------------------------------------------------------------------

struct HelpEntry {
  std::string term;  ///< a button, a key, an object; empty for a paragraph
  std::string text;
  std::optional<action::ObjectKind> picture{};  ///< of the object (view/plan/pictogram.h)
};
struct HelpSection {
  std::string title;
  std::vector<HelpEntry> entries;
};
/// The text of help mode.
[[nodiscard]] std::vector<HelpSection> help(Language language);

}  // namespace raywalk
