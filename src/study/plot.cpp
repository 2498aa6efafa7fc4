#include "study/plot.h"

#include "text/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace raywalk::study {

namespace {

constexpr double width = 860, height = 470, left = 86, right = 232, top = 46, bottom = 64;

/// Distinguishable with every colour vision (M. Okabe and K. Ito, 2008), and by mark and dash without colours.
struct SeriesStyle {
  const char *colour, *dash;
};
constexpr std::array<SeriesStyle, 8> looks{{{"s0", ""},
                                            {"s1", "9 4"},
                                            {"s2", "3 3"},
                                            {"s3", "12 3 3 3"},
                                            {"s4", "6 2"},
                                            {"s5", "2 5"},
                                            {"s6", "14 5"},
                                            {"s7", "8 3 2 3 2 3"}}};

std::string mark(std::size_t look, double x, double y) {
  const auto path = [&](const char* d) {
    return fmt::format("<path class='m {}' transform='translate({:.2f} {:.2f})' d='{}'/>",
                       looks[look % looks.size()].colour, x, y, d);
  };
  switch (look % 8) {
    case 0:
      return path("M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0Z");
    case 1:
      return path("M-4-4H4V4H-4Z");
    case 2:
      return path("M0-5.5L5 4H-5Z");
    case 3:
      return path("M0-5.5L5.5 0L0 5.5L-5.5 0Z");
    case 4:
      return path("M0 5.5L5-4H-5Z");
    case 5:
      return path("M-1.5-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5V-1.5H-1.5Z");
    case 6:
      return path("M-5-2.5L-2.5-5L0-2.5L2.5-5L5-2.5L2.5 0L5 2.5L2.5 5L0 2.5L-2.5 5L-5 2.5L-2.5 0Z");
    default:
      return path("M-5-3.5H5V3.5H-5ZM-2-1H2V1H-2Z");
  }
}

/// Sets exponents as superscripts.
std::string prose(const std::string& text) {
  return escaped_with_powers(text, "<tspan dy='-4' font-size='75%'>", "</tspan><tspan dy='4'> </tspan>");
}

/// One axis with its numbers.
class Axis {
 public:
  Axis(bool logarithmic, double low, double high, double from, double to)
      : logarithmic_(logarithmic), low_(low), high_(high), from_(from), to_(to) {}

  [[nodiscard]] double at(double value) const {
    const double share =
        logarithmic_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
    return from_ + share * (to_ - from_);
  }
  [[nodiscard]] bool holds(double value) const { return low_ <= value && value <= high_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  /// Round numbers: powers of ten, and 2 and 5 times these if they are few; or steps of 1, 2 or 5.
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> ticks;
    if (logarithmic_) {
      const int first = static_cast<int>(std::floor(std::log10(low_))),
                last = static_cast<int>(std::ceil(std::log10(high_)));
      const double decades = std::log10(high_ / low_);
      const int step = std::max(1, static_cast<int>(std::ceil(decades / 9)));
      for (int power = first; power <= last; ++power)
        for (const int times : {1, 2, 5}) {
          const double tick = times * std::pow(10.0, power);
          const bool shown = times == 1 ? power % step == 0 : decades < 2.2;
          if (shown && holds(tick * (1 + 1e-9)) && holds(tick * (1 - 1e-9))) ticks.push_back(tick);
        }
      return ticks;
    }
    const double rough = (high_ - low_) / 7, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : rough / power > 1 ? 2 : 1);
    for (double tick = std::ceil(low_ / step) * step; tick <= high_ + step * 1e-9; tick += step)
      ticks.push_back(std::abs(tick) < step * 1e-9 ? 0 : tick);
    return ticks;
  }

  [[nodiscard]] std::string label(double tick) const {
    if (!logarithmic_ || (tick >= 0.009 && tick <= 20000)) return fmt::format("{:.6g}", tick);
    const int power = static_cast<int>(std::floor(std::log10(tick) + 1e-9));
    const double times = tick / std::pow(10.0, power);
    const std::string exponent =
        fmt::format("10<tspan dy='-5' font-size='10'>{}{}</tspan>", power < 0 ? "\u2212" : "", std::abs(power));
    return times > 1.5 ? fmt::format("{:.0f}·", times) + exponent : exponent;
  }

 private:
  bool logarithmic_;
  double low_, high_, from_, to_;
};

struct Reach {
  double low = INFINITY, high = -INFINITY;
  void include(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) return;
    low = std::min(low, value), high = std::max(high, value);
  }
  void widen(bool logarithmic) {
    if (!(low <= high)) low = logarithmic ? 0.1 : 0, high = 1;
    if (logarithmic) {
      const double more = std::max(std::pow(high / low, 0.04), 1.15);
      low /= more, high *= more;
    } else {
      low = std::min(low, 0.0);
      high += high == low ? 1 : 0.06 * (high - low);
    }
  }
};

/// Positions of the labels beside the plot: near the ends of their lines, without overlap.
std::vector<double> spread(std::vector<double> wanted, double gap, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  double least = low;
  for (const std::size_t i : order) wanted[i] = std::max(wanted[i], least), least = wanted[i] + gap;
  double most = high;
  for (std::size_t k = order.size(); k-- > 0;) {
    double& at = wanted[order[k]];
    at = std::min(at, most), most = at - gap;
  }
  return wanted;
}

/// The line of the law, through the middle of the points.
std::string law_line(const PlotSeries& series, const Plot& plot, const Axis& x, const Axis& y) {
  double middle_x = 0, middle_y = 0, least = INFINITY, most = -INFINITY;
  int count = 0;
  const auto along = [&](double value) { return plot.log_x ? std::log(value) : value; };
  // The law is asymptotic: the later half of the points places it.
  for (std::size_t i = series.points.size() / 2; i < series.points.size(); ++i) {
    const PlotPoint& p = series.points[i];
    if (p.y <= 0 || (plot.floor && p.y < *plot.floor)) continue;
    middle_x += along(p.x), middle_y += std::log(p.y), ++count;
  }
  for (const PlotPoint& p : series.points) least = std::min(least, p.x), most = std::max(most, p.x);
  if (count == 0) return {};
  middle_x /= count, middle_y /= count;
  std::string d;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double at = plot.log_x ? least * std::pow(most / least, share) : least + share * (most - least);
    const double value = std::exp(middle_y + *series.law * (along(at) - middle_x));
    if (!y.holds(value)) continue;
    d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", x.at(at), y.at(value));
  }
  return fmt::format("<path class='law' d='{}'/>\n", d);
}

constexpr const char* style = R"(<style>
svg{font-family:Inter,'Segoe UI','Liberation Sans','DejaVu Sans',sans-serif;font-size:14px}
.bg{fill:#fff}.fg{fill:#1b1d22}.axis{stroke:#1b1d22;fill:none}.grid{stroke:#d9dbe0;fill:none}
.law{stroke:#5a5f6b;fill:none;stroke-width:1.2;stroke-dasharray:1 4;stroke-linecap:round}
.floor{stroke:#5a5f6b;fill:none;stroke-width:1.2;stroke-dasharray:10 4}.note{fill:#4a4f5a;font-size:12px}
.l{fill:none;stroke-width:2}.m{stroke:none}.e{fill:none;stroke-width:1.3}.lead{stroke:#9a9faa;fill:none;stroke-width:.8}
.l.s0,.e.s0{stroke:#0072b2}.m.s0{fill:#0072b2}.l.s1,.e.s1{stroke:#d55e00}.m.s1{fill:#d55e00}
.l.s2,.e.s2{stroke:#009e73}.m.s2{fill:#009e73}.l.s3,.e.s3{stroke:#b0568f}.m.s3{fill:#b0568f}
.l.s4,.e.s4{stroke:#8a6d00}.m.s4{fill:#8a6d00}.l.s5,.e.s5{stroke:#2a8fd0}.m.s5{fill:#2a8fd0}
.l.s6,.e.s6{stroke:#6a6f7a}.m.s6{fill:#6a6f7a}.l.s7,.e.s7{stroke:#1b1d22}.m.s7{fill:#1b1d22}
@media (prefers-color-scheme:dark){.bg{fill:#15171c}.fg{fill:#e8eaef}.axis{stroke:#e8eaef}.grid{stroke:#343842}
.law,.floor{stroke:#a9aebb}.note{fill:#b4b9c6}.lead{stroke:#6a6f7a}
.l.s0,.e.s0{stroke:#4ba6e0}.m.s0{fill:#4ba6e0}.l.s1,.e.s1{stroke:#ff8b3d}.m.s1{fill:#ff8b3d}
.l.s2,.e.s2{stroke:#2fcb9f}.m.s2{fill:#2fcb9f}.l.s3,.e.s3{stroke:#e59cc8}.m.s3{fill:#e59cc8}
.l.s4,.e.s4{stroke:#e5c33d}.m.s4{fill:#e5c33d}.l.s5,.e.s5{stroke:#8fd0ff}.m.s5{fill:#8fd0ff}
.l.s6,.e.s6{stroke:#a9aebb}.m.s6{fill:#a9aebb}.l.s7,.e.s7{stroke:#e8eaef}.m.s7{fill:#e8eaef}}
@media print{.bg{fill:#fff}.fg{fill:#000}.axis{stroke:#000}.note{fill:#333}}
</style>
)";

std::string level_line(double level, const std::string& name, const Axis& x, const Axis& y) {
  return fmt::format(
      "<path class='floor' d='M{:.2f} {:.2f}H{:.2f}'/>\n<text class='note' x='{:.2f}' y='{:.2f}'>{}</text>\n",
      x.at(x.low()), y.at(level), x.at(x.high()), x.at(x.low()) + 8, y.at(level) - 5, prose(name));
}

}  // namespace

std::string svg_of(const Plot& plot) {
  Reach reach_x, reach_y;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& p : series.points) {
      reach_x.include(p.x, plot.log_x);
      for (const double y : {p.y, p.low, p.high}) reach_y.include(y, plot.log_y);
    }
  for (const auto& level : {plot.floor, plot.ceiling})
    if (level) reach_y.include(*level, plot.log_y);
  reach_x.widen(plot.log_x);
  reach_y.widen(plot.log_y);
  const Axis x(plot.log_x, reach_x.low, reach_x.high, left, width - right);
  const Axis y(plot.log_y, reach_y.low, reach_y.high, height - bottom, top);

  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' role='img'>\n"
      "<title>{2}</title>\n{3}<rect class='bg' width='{0}' height='{1}'/>\n"
      "<text class='fg' x='{4}' y='26' font-size='17' font-weight='600'>{2}</text>\n",
      width, height, escaped(plot.title), style, left);
  for (const double tick : x.ticks())
    svg += fmt::format(
        "<path class='grid' d='M{0:.2f} {1}V{2}'/><text class='fg' x='{0:.2f}' y='{3}' "
        "text-anchor='middle'>{4}</text>\n",
        x.at(tick), top, height - bottom, height - bottom + 20, x.label(tick));
  for (const double tick : y.ticks())
    svg += fmt::format(
        "<path class='grid' d='M{1} {0:.2f}H{2}'/><text class='fg' x='{3}' y='{4:.2f}' text-anchor='end'>{5}</text>\n",
        y.at(tick), left, width - right, left - 8, y.at(tick) + 5, y.label(tick));
  svg += fmt::format("<path class='axis' d='M{0} {1}V{2}H{3}'/>\n", left, top, height - bottom, width - right);
  svg += fmt::format("<text class='fg' x='{}' y='{}' text-anchor='middle'>{}</text>\n", (left + width - right) / 2,
                     height - 18, escaped(plot.x_label));
  svg += fmt::format("<text class='fg' transform='translate(20 {}) rotate(-90)' text-anchor='middle'>{}</text>\n",
                     (top + height - bottom) / 2, escaped(plot.y_label));
  if (plot.floor) svg += level_line(*plot.floor, plot.floor_name, x, y);
  if (plot.ceiling) svg += level_line(*plot.ceiling, plot.ceiling_name, x, y);

  std::vector<double> ends, sides;  // the end of each series nearest to the labels
  for (const PlotSeries& series : plot.series) {
    const auto last = std::max_element(series.points.begin(), series.points.end(),
                                       [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
    const bool any = last != series.points.end() && (!plot.log_y || last->y > 0);
    ends.push_back(any ? y.at(last->y) : height - bottom);
    sides.push_back(any ? x.at(last->x) + 8 : width - right);
  }
  const std::vector<double> labels = spread(ends, 34, top + 8, height - bottom - 8);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    const std::size_t mark_of = series.look.value_or(i);
    const SeriesStyle& look = looks[mark_of % looks.size()];
    if (series.law && plot.log_y) svg += law_line(series, plot, x, y);
    std::string d, marks;
    for (const PlotPoint& p : series.points) {
      if (plot.log_y && p.y <= 0) continue;
      const double px = x.at(p.x), py = y.at(p.y);
      d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", px, py);
      const double low = std::max(p.low, y.low()), high = std::min(p.high, y.high());
      if (y.at(low) - y.at(high) > 1)
        marks += fmt::format("<path class='e {0}' d='M{1:.2f} {2:.2f}V{3:.2f}M{4:.2f} {2:.2f}h8M{4:.2f} {3:.2f}h8'/>",
                             look.colour, px, y.at(low), y.at(high), px - 4);
      marks += mark(mark_of, px, py);
    }
    svg += fmt::format("<path class='l {}' stroke-dasharray='{}' d='{}'/>\n{}\n", look.colour, look.dash, d, marks);
    const double at = labels[i], side = width - right;
    if (!series.points.empty())
      svg += fmt::format("<path class='lead' d='M{:.2f} {:.2f}L{:.2f} {:.2f}'/>\n", std::min(sides[i], side), ends[i],
                         side + 10, at);
    svg += fmt::format("<path class='l {0}' stroke-dasharray='{1}' d='M{2} {3:.2f}h30'/>{4}", look.colour, look.dash,
                       side + 12, at, mark(mark_of, side + 27, at));
    svg += fmt::format("<text class='fg' x='{}' y='{:.2f}'>{}</text>", side + 50,
                       at + (series.law_name.empty() ? 5 : -1), escaped(series.name));
    if (!series.law_name.empty())
      svg += fmt::format("<text class='note' x='{}' y='{:.2f}'>law: {}</text>", side + 50, at + 14,
                         prose(series.law_name));
    svg += "\n";
  }
  return svg + "</svg>\n";
}

}  // namespace raywalk::study
