// Draws what each effect of a scene adds.

#include "view/cost/cost.h"
#include "view/state.h"
#include "view/text/choice_text.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

namespace {

/// "61%"; time may be negative by chance, 0 has no sign.
std::string whole_percent(double share, Language language) {
  return typeset_number(fmt::format("{:.0f}%", std::round(100 * share) + 0.0), language);
}

/// A name on the left; on the right, one above the other, the bars of rays and time.
struct BarRow {
  std::string name;
  double rays;                                ///< share, 0..1
  const study::EffectCost* effect = nullptr;  ///< if its time is known too
};

std::string_view title_of(const study::SceneCost& survey) {
  return survey.effects.empty() ? "cost.no_effects" : "cost.effects_title";
}

/// The costliest first, and all shadow rays at the end.
std::vector<BarRow> rows_of(const study::SceneCost& survey, Language language) {
  std::vector<BarRow> rows;
  for (const study::EffectCost& effect : survey.effects)
    rows.push_back({std::string(text(effect.effect, language)), effect.rays_share, &effect});
  if (survey.whole.rays > 0)
    rows.push_back({std::string(text("cost.all_rays", language)),
                    static_cast<double>(survey.shadow_rays) / static_cast<double>(survey.whole.rays)});
  return rows;
}

std::string rays_text(const BarRow& row, Language language) {
  return fill("cost.of_rays", language, {{"percent", whole_percent(row.rays, language)}});
}
std::string time_text(const study::EffectCost& effect, Language language) {
  return fill("cost.of_time", language,
              {{"percent", whole_percent(effect.seconds_share, language)},
               {"least", whole_percent(effect.seconds_low, language)},
               {"most", whole_percent(effect.seconds_high, language)}});
}

/// Wrapped at words to this width.
std::vector<std::string> lines_of(std::string_view rest, double letters, double width) {
  std::vector<std::string> lines(1);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string word(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, letters) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace

std::vector<std::string> effect_texts(const study::SceneCost& survey, Language language) {
  std::vector<std::string> texts{std::string(text(title_of(survey), language))};
  for (const BarRow& row : rows_of(survey, language))
    texts.push_back(row.name + ": " + rays_text(row, language) +
                    (row.effect != nullptr ? ", " + time_text(*row.effect, language) : ""));
  return texts;
}

DisplayList effect_bars(const State& state, const std::optional<study::SceneCost>& survey, double width, double height,
                        double unit) {
  DisplayList list;
  if (!survey) return list;
  const Palette& colours = palette(state.appearance.theme);
  double letters = 15 * unit;
  const double line = 1.2 * unit;
  const auto write = [&](const Vec2d& at, const std::string& what, Colour colour, TextAnchor anchor) {
    list.push_back({TextItem{at, what, letters, colour, anchor}});
  };

  // Rays are a filled bar, time an open one: distinguishable without colour.
  const auto draw_bar = [&](const Vec2d& low, const Vec2d& high, bool filled, double stroke) {
    list.push_back({PolygonItem{{low, {high.x, low.y}, high, {low.x, high.y}},
                                filled ? std::optional(colours.selected) : std::nullopt,
                                Stroke{filled ? colours.selected : colours.ink, stroke}}});
  };

  const Language language = state.appearance.language;
  const std::vector<BarRow> rows = rows_of(*survey, language);

  double y = 0.7 * letters;
  for (const std::string& part : lines_of(text(title_of(*survey), language), letters, width)) {
    write({0, y}, part, colours.text, TextAnchor::start);
    y += 1.2 * letters;
  }

  const auto percent = [&](double share) { return whole_percent(share, language); };
  const std::string longest =
      fill("cost.of_time", language, {{"percent", "100%"}, {"least", "100%"}, {"most", "100%"}});
  const auto names_width = [&] {
    double widest = 0;
    for (const BarRow& row : rows) widest = std::max(widest, text_width(row.name, letters));
    return widest;
  };
  const auto room_beside = [&](const std::string& words) {
    return width - names_width() - 2.2 * letters - text_width(words, letters);
  };
  // Without room for words, only numbers are beside the bars, and a line above explains them.
  const bool in_words = room_beside(longest) > 4 * letters;
  if (!in_words && !rows.empty()) {
    double x = 0;
    for (const bool filled : {true, false}) {
      const Vec2d low(x, y - 0.3 * letters), high(x + letters, y + 0.3 * letters);
      draw_bar(low, high, filled, 1.5 * line);
      const std::string words(text(filled ? "cost.key_rays" : "cost.key_time", language));
      write({high.x + 0.4 * letters, y}, words, colours.text, TextAnchor::start);
      x = high.x + 1.6 * letters + text_width(words, letters);
    }
    y += 1.5 * letters;
  }
  const double row_height =
      std::min(3.0 * letters, (height - y) / std::max<double>(1, static_cast<double>(rows.size())));
  // Many rows: smaller letters; if even those do not fit one above the other, one number for both bars.
  letters = std::clamp(row_height / 1.2, 0.6 * letters, letters);
  const bool apart = row_height > 2.3 * letters;
  const double name_width = names_width(), left = name_width + letters;
  const double full = std::max(room_beside(in_words ? longest : apart ? "100%" : "100% \u00b7 100%"), letters);
  const double thick = std::min(0.8 * letters, row_height * 0.32);

  const double first = y;
  double last = y;
  const auto bar = [&](double top, double share, bool filled) {
    last = top + thick;
    const double right = left + std::clamp(share, 0.0, 1.0) * full;
    draw_bar({left, top}, {right, last}, filled, std::min(1.5 * line, thick / 4));
    return right;
  };
  const auto label = [&](double middle, double right, const std::string& what) {
    write({right + 0.6 * letters, middle}, what, colours.text, TextAnchor::start);
  };
  for (const BarRow& row : rows) {
    const double step = row_height * 0.45;
    double top = y;
    const double lowest = row.effect != nullptr ? top + step + thick : top + thick;
    const double centre = (top + lowest) / 2;
    write({name_width, centre}, row.name, colours.text, TextAnchor::end);
    double right = bar(top, row.rays, true);
    if (apart || row.effect == nullptr)
      label(top + thick / 2, right, in_words && apart ? rays_text(row, language) : percent(row.rays));
    if (row.effect != nullptr) {
      top += step;
      const study::EffectCost& effect = *row.effect;
      const double of_time = bar(top, effect.seconds_share, false);
      right = apart ? of_time : std::max(right, of_time);
      const auto x_of = [&](double share) { return left + std::clamp(share, 0.0, 1.0) * full; };
      const double low = x_of(effect.seconds_low), high = x_of(effect.seconds_high), middle = top + thick / 2;
      if (high > low) {
        const Stroke whisker{colours.ink, std::min(1.5 * line, thick / 4)};
        list.push_back({LineItem{{low, middle}, {high, middle}, whisker}});
        for (const double x : {low, high})
          list.push_back({LineItem{{x, middle - thick / 2}, {x, middle + thick / 2}, whisker}});
        right = std::max(right, high);
      }
      const std::string time = percent(effect.seconds_share);
      if (!apart)
        label(centre, right, percent(row.rays) + " \u00b7 " + time);
      else
        label(middle, right, in_words ? time_text(effect, language) : time);
    }
    y += row_height;
  }
  list.push_back({LineItem{{left, first}, {left, std::max(last, first)}, {colours.dim_text, line}}});
  return list;
}

}  // namespace raywalk
