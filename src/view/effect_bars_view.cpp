// What each effect of a scene adds, drawn.

#include "view/choice_text.h"
#include "view/cost.h"
#include "view/state.h"
#include "view/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace raywalk {

namespace {

/// "61%"; time may be negative by chance, 0 has no sign.
std::string whole_percent(double share, Language language) {
  return typeset_number(fmt::format("{:.0f}%", std::round(100 * share) + 0.0), language);
}

/// A name to the left; to the right of it, one above the other, what it adds of the rays and of the time.
struct BarRow {
  std::string name;
  double rays;                                ///< share, 0..1
  const study::EffectCost* effect = nullptr;  ///< of which the time is known too
};

/// Broken between words into lines of at most this width.
std::vector<std::string> lines_of(const std::string& what, double letters, double width) {
  std::vector<std::string> lines(1);
  std::istringstream words(what);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, letters) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace

DisplayList effect_bars(const State& state, const std::optional<study::SceneCost>& survey, double width, double height,
                        double unit) {
  DisplayList list;
  if (!survey) return list;
  const Palette& colours = palette(state.theme);
  const double letters = 15 * unit, line = 1.2 * unit;
  const auto write = [&](const Vec2d& at, const std::string& what, Colour colour, TextAnchor anchor) {
    list.push_back({TextItem{at, what, letters, colour, anchor}});
  };

  std::vector<BarRow> rows;
  for (const study::EffectCost& effect : survey->effects)
    rows.push_back({std::string(text(effect.effect, state.language)), effect.rays_share, &effect});
  if (survey->whole.rays > 0)
    rows.push_back({std::string(text(CostText::all_rays, state.language)),
                    static_cast<double>(survey->shadow_rays) / static_cast<double>(survey->whole.rays)});

  double y = 0.7 * letters;
  const bool none = survey->effects.empty();
  const std::string title(text(none ? CostText::no_effects : CostText::effects_title, state.language));
  for (const std::string& part : lines_of(title, letters, width)) {
    write({0, y}, part, colours.text, TextAnchor::start);
    y += 1.2 * letters;
  }

  double name_width = 0;
  for (const BarRow& row : rows) name_width = std::max(name_width, text_width(row.name, letters));
  const std::string longest = fill(CostText::of_time, state.language, {"100%", "100%", "100%"});
  const double left = name_width + letters, label_width = text_width(longest, letters) + letters;
  const double room = width - left - label_width;
  // Without room beside them the labels stand over the bars; where there is none above them either, names and bars
  // alone are left: the panel's text has the numbers.
  const bool beside = room > 4 * letters;
  const double full = beside ? room : std::max(width - left, letters);
  const double needed = beside ? 3.0 * letters : 4.8 * letters;
  const double row_height = std::min(needed, (height - y) / std::max<double>(1, static_cast<double>(rows.size())));
  const bool labelled = beside || row_height > 4.4 * letters;
  const double thick = std::min(0.8 * letters, row_height * (beside ? 0.32 : 0.2));

  const double first = y;
  double last = y;
  const auto bar = [&](double top, double share, bool filled) {
    last = top + thick;
    const double right = left + std::clamp(share, 0.0, 1.0) * full;
    const std::vector<Vec2d> corners{{left, top}, {right, top}, {right, top + thick}, {left, top + thick}};
    // Rays are a full bar, time an open one: told apart without colour.
    list.push_back({PolygonItem{corners, filled ? std::optional(colours.selected) : std::nullopt,
                                Stroke{filled ? colours.selected : colours.ink, 1.5 * line}}});
    return right;
  };
  const auto label = [&](double top, double right, const std::string& what) {
    if (!labelled) return;
    if (beside)
      write({right + 0.6 * letters, top + thick / 2}, what, colours.text, TextAnchor::start);
    else
      write({left, top - 0.6 * letters}, what, colours.text, TextAnchor::start);
  };
  for (const BarRow& row : rows) {
    const double step = row_height * 0.45;
    double top = y + (beside ? 0 : 0.6 * letters);
    const double lowest = row.effect != nullptr ? top + step + thick : top + thick;
    write({name_width, (top + lowest) / 2}, row.name, colours.text, TextAnchor::end);
    label(top, bar(top, row.rays, true),
          fill(CostText::of_rays, state.language, {whole_percent(row.rays, state.language)}));
    if (row.effect != nullptr) {
      top += step;
      const study::EffectCost& effect = *row.effect;
      double right = bar(top, effect.seconds_share, false);
      const auto x_of = [&](double share) { return left + std::clamp(share, 0.0, 1.0) * full; };
      const double low = x_of(effect.seconds_low), high = x_of(effect.seconds_high), middle = top + thick / 2;
      if (high > low) {
        const Stroke whisker{colours.ink, 1.5 * line};
        list.push_back({LineItem{{low, middle}, {high, middle}, whisker}});
        for (const double x : {low, high})
          list.push_back({LineItem{{x, middle - thick / 3}, {x, middle + thick / 3}, whisker}});
        right = std::max(right, high);
      }
      label(
          top, right,
          fill(CostText::of_time, state.language,
               {whole_percent(effect.seconds_share, state.language), whole_percent(effect.seconds_low, state.language),
                whole_percent(effect.seconds_high, state.language)}));
    }
    y += row_height;
  }
  list.push_back({LineItem{{left, first}, {left, std::max(last, first)}, {colours.dim_text, line}}});
  return list;
}

}  // namespace raywalk
