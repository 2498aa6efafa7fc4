#pragma once
// Diagrams as SVG: measurements with their intervals, and the laws as dotted lines. Legible without colours: each
// series has its own mark and dash. For light and dark pages.

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
  /// The slope of the law, drawn through the middle of the later half of the points: with both axes logarithmic the
  /// exponent; with only y, the change of the natural logarithm.
  std::optional<double> law{};
  std::string law_name{};             ///< "N^-1/2"
  std::optional<std::size_t> look{};  ///< shared by several diagrams; absent: its index among the series
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
