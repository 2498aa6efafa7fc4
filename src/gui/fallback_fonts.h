#pragma once
// Letters that Inter lacks: found in the texts of languages, and in fonts of the system.

#include "gui/fonts.h"
#include "text/language.h"

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Adds the letters of a UTF-8 text that are in no alphabet of Inter and no sign of the interface; sorted, each once.
void add_letters_beyond(std::string_view text, std::u16string& letters);
/// Those of the texts of `languages`, and of the lessons in these languages in the folder `lessons`. Of an alphabet,
/// all letters, because a person may type them; of ideographs and syllables, which are thousands, those that stand
/// there.
[[nodiscard]] std::u16string letters_beyond(const Languages& languages, const std::string& lessons);

/// Notes the letters, and the installed faces of well-known families that have them, in `files`; as few as suffice.
void find_fallbacks(FontFiles& files, const std::vector<std::string>& folders, std::u16string letters);

/// Sorted letters as ImGui has them: the first and last of each row of neighbours, and a 0.
[[nodiscard]] std::vector<ImWchar> ranges_of(const std::u16string& letters);

}  // namespace raywalk
