#pragma once
// A walk as one page of HTML that needs nothing but a browser: it steps offline, by buttons, keys and a bar.

#include "scene/scene.h"
#include "text/language.h"
#include "timeline/timeline.h"
#include "view/theme.h"

#include <memory>
#include <string>

namespace raywalk {

/// More steps make a page that browsers are slow with.
inline constexpr int most_slides = 20'000;

/// The page; `timeline` was recorded from `scene`. Each step has the plan, the pseudocode with its pointer, the
/// sentence, which a screen reader says, and the equation with its numbers.
[[nodiscard]] std::string slides_page(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language,
                                      Theme theme = Theme::projector);

/// The plan after the last step, as a file of SVG.
[[nodiscard]] std::string plan_picture(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language,
                                       Theme theme = Theme::projector);

}  // namespace raywalk
