#pragma once
// Names in the language of the window.

#include "scene/scene.h"
#include "text/language.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A light's, object's or group's name as it is shown in `language`: if it is one of the `translated`, the text
/// "name.NAME", also with a number behind ("Polygon 2"); any other as it is.
[[nodiscard]] std::string shown_name(const std::vector<std::string>& translated, std::string_view name,
                                     Language language);
[[nodiscard]] inline std::string shown_name(const Scene& scene, std::string_view name, Language language) {
  return shown_name(scene.translated, name, language);
}

}  // namespace raywalk
