// Draws error against cost.

#include "view/cost/cost.h"
#include "view/state.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

using study::Attempt;
using study::CostAxis;

/// A logarithmic scale around some numbers, at least one decade.
class LogScale {
 public:
  void hold(double value) {
    if (!(value > 0)) return;
    low_ = std::min(low_, std::log10(value));
    high_ = std::max(high_, std::log10(value));
  }
  /// Rounds outwards to a third of a decade (1, 2, 5), with a margin.
  void round() {
    if (low_ > high_) low_ = 0, high_ = 1;
    const double air = 0.1, middle = (low_ + high_) / 2, half = std::max((high_ - low_) / 2 + air, 0.55);
    low_ = middle - half;
    high_ = middle + half;
  }
  [[nodiscard]] double part(double value) const { return (std::log10(value) - low_) / (high_ - low_); }
  /// 1, 2, 5 of each decade if there are few, else the decades, at most `most`.
  [[nodiscard]] std::vector<double> ticks(int most) const {
    const double span = high_ - low_;
    if (span * 3 > most)
      if (std::vector<double> decades = ticks(most, false); decades.size() >= 2) return decades;
    std::vector<double> all = ticks(most, true);  // one tick is not enough
    while (static_cast<int>(all.size()) > std::max(most, 2))
      for (std::size_t i = 1; i < all.size(); ++i) all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    return all;
  }

 private:
  [[nodiscard]] std::vector<double> ticks(int most, bool fine) const {
    std::vector<double> all;
    const double span = high_ - low_;
    const int stride = std::max(1, static_cast<int>(std::ceil(span / most)));
    for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::ceil(high_)); ++decade)
      for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit > 1 ? !fine : decade % stride != 0) continue;
        const double value = digit * std::pow(10.0, decade);
        if (part(value) >= 0 && part(value) <= 1) all.push_back(value);
      }
    return all;
  }

  double low_ = 1e300, high_ = -1e300;
};

std::string tick_text(double value, Language language) {
  const auto short_text = [&](double number, const char* unit) {
    return typeset_power(fmt::format("{:g}", number), language) + unit;
  };
  if (value >= 0.999e9) return short_text(value / 1e9, " G");
  if (value >= 0.999e6) return short_text(value / 1e6, " M");
  if (value >= 0.999e3) return short_text(value / 1e3, " k");
  if (value >= 0.999e-4) return short_text(value, "");
  return typeset_power(fmt::format("{:.0e}", value), language);
}

TextItem words(const Vec2d& at, std::string what, double size, Colour colour, TextAnchor anchor) {
  return {at, std::move(what), size, colour, anchor};
}

}  // namespace

CostPlot cost_plot(const State& state, const CostFindings& findings, double width, double height, double unit) {
  CostPlot plot;
  DisplayList& list = plot.list;
  const Palette& colours = palette(state.appearance.theme);
  const double letters = 15 * unit, line = 1.2 * unit;
  const CostAxis axis = state.cost.axis;

  LogScale across, up;
  bool any = false;
  for (const Attempt& attempt : findings.attempts) {
    if (attempt.done < 1) continue;
    any = true;
    across.hold(study::cost_on(axis, attempt.cost));
    up.hold(std::max(attempt.error, findings.floor));
  }
  up.hold(findings.floor);
  across.round();
  up.round();

  const double left = 4.2 * letters, right = width - 0.6 * letters, top = 1.7 * letters,
               bottom = height - 2.6 * letters;
  if (right - left < 3 * letters || bottom - top < 2 * letters) return plot;
  const auto x_of = [&](double value) { return left + across.part(value) * (right - left); };
  const auto y_of = [&](double value) { return bottom - up.part(value) * (bottom - top); };

  const Stroke grid{colours.grid, line};
  const int across_most = std::max(2, static_cast<int>((right - left) / (4.5 * letters)));
  const int up_most = std::max(2, static_cast<int>((bottom - top) / (2 * letters)));
  for (const double value : across.ticks(across_most)) {
    if (any) list.push_back({LineItem{{x_of(value), top}, {x_of(value), bottom}, grid}});
    if (any)
      list.push_back({words({x_of(value), bottom + 0.8 * letters}, tick_text(value, state.appearance.language), letters,
                            colours.dim_text, TextAnchor::middle)});
  }
  const bool known = findings.floor > 0;  // before there is a reference, only the costs are known
  for (const double value : up.ticks(up_most)) {
    if (!known) break;
    list.push_back({LineItem{{left, y_of(value)}, {right, y_of(value)}, grid}});
    list.push_back({words({left - 0.5 * letters, y_of(value)}, tick_text(value, state.appearance.language), letters,
                          colours.dim_text, TextAnchor::end)});
  }
  const Stroke frame{colours.dim_text, line};
  list.push_back({PolylineItem{{{left, top}, {left, bottom}, {right, bottom}}, frame}});
  list.push_back({words({0.3 * letters, 0.7 * letters}, std::string(text("cost.error_axis", state.appearance.language)),
                        letters, colours.text, TextAnchor::start)});
  const std::string_view name = axis == CostAxis::seconds ? "cost.seconds_axis"
                                : axis == CostAxis::rays  ? "cost.rays_axis"
                                                          : "cost.tests_axis";
  list.push_back({words({right, height - 0.8 * letters}, std::string(text(name, state.appearance.language)), letters,
                        colours.text, TextAnchor::end)});
  if (!any) return plot;

  if (known && up.part(findings.floor) >= 0) {
    const double y = y_of(findings.floor);
    list.push_back({LineItem{{left, y}, {right, y}, {colours.dim_text, line, {{6 * unit, 4 * unit}, 2}}}});
    const double beside = bottom - y > 1.2 * letters ? 0.7 : -0.7;
    const std::string own(text("cost.floor", state.appearance.language));
    if (text_width(own, letters) < right - left)
      list.push_back({words({right, y + beside * letters}, own, letters, colours.dim_text, TextAnchor::end)});
  }

  const auto place = [&](const Attempt& attempt) {
    const double error = std::max({attempt.error, findings.floor, 1e-12});
    return Vec2d(x_of(study::cost_on(axis, attempt.cost)), known ? y_of(error) : bottom);
  };
  PolylineItem best{{}, {colours.selected, 2 * line}};
  for (const int i : study::frontier(findings.attempts, axis))
    best.points.push_back(place(findings.attempts[static_cast<std::size_t>(i)]));
  if (best.points.size() > 1 && known) list.push_back({best});

  const double radius = 5 * unit;
  for (int i = 0; i < static_cast<int>(findings.attempts.size()); ++i) {
    const Attempt& attempt = findings.attempts[static_cast<std::size_t>(i)];
    if (attempt.done < 1) continue;
    const Vec2d at = place(attempt);
    const bool chosen = i == state.cost.chosen, against = i == state.cost.against;
    plot.marks.push_back({i, at});
    // Float is a square: distinguishable without colour.
    if (attempt.setup.single_precision)
      list.push_back({PolygonItem{
          {at + Vec2d(-radius), at + Vec2d(radius, -radius), at + Vec2d(radius), at + Vec2d(-radius, radius)},
          colours.panel,
          Stroke{colours.ink, 1.6 * line}}});
    else
      list.push_back({CircleItem{at, radius, colours.panel, Stroke{colours.ink, 1.6 * line}}});
    if (chosen) list.push_back({CircleItem{at, 0.55 * radius, colours.selected, {}}});
    if (chosen || against) {
      const Vec2d above = at - Vec2d(0, radius + 0.9 * letters);
      list.push_back({words(above, chosen ? "A" : "B", 1.1 * letters, colours.text, TextAnchor::middle)});
    }
  }
  return plot;
}

}  // namespace raywalk
