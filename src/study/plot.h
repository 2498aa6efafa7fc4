#pragma once
// Diagrams as SVG: what was measured with its intervals, and the laws as dotted lines. Read without colours too: each
// series has a mark and a dash of its own. Light and dark pages both.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace raywalk::study {

struct PlotPoint {
  double x = 0, y = 0;
  double low = 0, high = 0;  ///< of y; both y where there is no interval
};

struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  /// What the law says: a line of this slope through the middle of the points from `law_from` on. With both axes
  /// logarithmic the exponent; with only y, the change of the natural logarithm.
  std::optional<double> law{};
  std::string law_name{};             ///< "N^-1/2"
  std::optional<std::size_t> look{};  ///< the same in several diagrams; absent: its place among the series
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = true, log_y = true;
  std::vector<PlotSeries> series;
  std::optional<double> floor{};  ///< below this y, differences mean nothing
  std::string floor_name{};
  std::optional<double> ceiling{};  ///< a level to compare with, drawn likewise
  std::string ceiling_name{};
};

/// A whole SVG document.
[[nodiscard]] std::string svg_of(const Plot& plot);

}  // namespace raywalk::study
