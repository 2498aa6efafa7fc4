#pragma once
// A walk as one self-contained HTML page, stepped by buttons, keys and a bar.

#include "scene/ink.h"
#include "scene/scene.h"
#include "text/language.h"
#include "timeline/timeline.h"
#include "view/drawing/theme.h"

#include <memory>
#include <string>

namespace raywalk {

/// Browsers are slow with more.
inline constexpr int max_slides = 20'000;

/// The page; `timeline` was recorded from `scene`. Each step has the plan, the pseudocode with its pointer, the
/// sentence, read by screen readers, and the equation with its numbers. `ink`: what is drawn over the plan.
/// `english_code`: the pseudocode is in English, whatever the language.
[[nodiscard]] std::string slides_page(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language,
                                      Theme theme = Theme::projector, const Ink& ink = {}, bool english_code = false);

/// The plan after the last step, as a file of SVG.
[[nodiscard]] std::string plan_picture(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language,
                                       Theme theme = Theme::projector, const Ink& ink = {});

}  // namespace raywalk
