#include "study/plot.h"

#include <cmath>

#include "support/catch.h"

using namespace raywalk::study;
using raywalk::test::contains;

namespace {

Plot sample_plot() {
  Plot plot;
  plot.title = "Error & cost";
  plot.x_label = "N";
  plot.y_label = "error < 1";
  for (const char* name : {"random", "jittered"}) {
    PlotSeries series{name, {}};
    for (int n = 1; n <= 1024; n *= 4) series.points.push_back({1.0 * n, 0.3 / n, 0.2 / n, 0.4 / n});
    series.law = -1, series.law_name = "N^-1";
    plot.series.push_back(series);
  }
  return plot;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// Every tag is closed, in order.
bool is_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = svg.substr(at + 1, end - at - 1), name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.front() == '/') {
      if (open.empty() || "/" + open.back() != tag) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

}  // namespace

TEST_CASE("a plot is an SVG of its own, with axes, names, marks, intervals and laws") {
  const std::string svg = svg_of(sample_plot());
  CHECK(svg.starts_with("<svg xmlns='http://www.w3.org/2000/svg'"));
  CHECK(is_well_formed(svg));
  for (const char* word :
       {"Error &amp; cost", "error &lt; 1", ">random<", ">jittered<", "law: N<tspan", ">\u22121</tspan>", ">1000<"})
    CHECK_THAT(svg, contains(word));
  CHECK(count(svg, "class='law'") == 2);
  CHECK(count(svg, "class='e s0'") == 6);  // each point's interval
  CHECK(count(svg, "class='m s1'") == 7);  // and its mark, and one beside the name
  CHECK_THAT(svg, !contains("nan") && !contains("inf") && !contains("<script") && !contains("url("));
  CHECK(count(svg, "http") == 1);  // its own namespace
}

TEST_CASE("series are told apart by dashes too") {
  Plot plot;
  for (int i = 0; i < 8; ++i) plot.series.push_back({"s" + std::to_string(i), {{1, 1, 1, 1}, {10, 1.0 + i, 1, 2}}});
  const std::string svg = svg_of(plot);
  std::vector<std::string> dashes;
  for (std::size_t at = svg.find("stroke-dasharray='"); at != std::string::npos;
       at = svg.find("stroke-dasharray='", at + 1))
    dashes.push_back(svg.substr(at, svg.find('\'', at + 18) - at));
  REQUIRE(dashes.size() == 16);
  for (std::size_t a = 0; a < 16; a += 2)
    for (std::size_t b = a + 2; b < 16; b += 2) CHECK(dashes[a] != dashes[b]);
}

TEST_CASE("a point that a logarithm cannot show is left out, and nothing else is") {
  Plot plot;
  plot.series = {{"some", {{1, 0, 0, 0}, {10, 0.5, 0.5, 0.5}, {100, 0.25, 0.25, 0.25}}}, {"none", {}}};
  const std::string svg = svg_of(plot);
  CHECK(is_well_formed(svg));
  CHECK(count(svg, "class='m s0'") == 3);  // two points and the name
  CHECK_THAT(svg, contains(">none<") && !contains("nan"));
}

TEST_CASE("levels are drawn with their names, and axes reach them") {
  Plot plot = sample_plot();
  plot.floor = 1e-7, plot.floor_name = "the floor";
  plot.ceiling = 5, plot.ceiling_name = "the ceiling";
  const std::string svg = svg_of(plot);
  CHECK_THAT(svg, contains("the floor") && contains("the ceiling"));
  CHECK(count(svg, "class='floor'") == 2);
}

TEST_CASE("straight axes count in steps of 1, 2 or 5") {
  Plot plot = sample_plot();
  plot.log_x = plot.log_y = false;
  const std::string svg = svg_of(plot);
  CHECK(is_well_formed(svg));
  CHECK_THAT(svg, contains(">200<") && contains(">400<") && contains(">0.1<"));
}
