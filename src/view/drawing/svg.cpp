#include "view/drawing/svg.h"

#include "text/markup.h"

#include <fmt/format.h>

#include <cmath>

namespace raywalk {

namespace {

/// A hundredth of a pixel is not visible.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value == 0 ? 0.0 : value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string opacity(std::string_view attribute, Colour colour) {
  return colour.a == 255 ? std::string() : fmt::format(" {}=\"{}\"", attribute, number(colour.a / 255.0));
}

std::string fill_of(const std::optional<Colour>& fill) {
  if (!fill) return " fill=\"none\"";
  return fmt::format(" fill=\"{}\"{}", css_colour(*fill), opacity("fill-opacity", *fill));
}

std::string stroke_of(const Stroke& stroke) {
  std::string text = fmt::format(" stroke=\"{}\"{} stroke-width=\"{}\"", css_colour(stroke.colour),
                                 opacity("stroke-opacity", stroke.colour), number(stroke.width));
  if (stroke.dash.count == 0) return text;
  text += " stroke-dasharray=\"";
  for (int i = 0; i < stroke.dash.count; ++i)
    text += (i > 0 ? " " : "") + number(stroke.dash.lengths[static_cast<std::size_t>(i)]);
  return text + "\"" + (stroke.phase == 0 ? "" : fmt::format(" stroke-dashoffset=\"{}\"", number(stroke.phase)));
}
std::string stroke_of(const std::optional<Stroke>& stroke) { return stroke ? stroke_of(*stroke) : std::string(); }

template <class Points>
std::string points_of(const Points& points) {
  std::string text;
  for (const Vec2d& p : points) text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
  return text;
}

struct Element {
  std::string operator()(const LineItem& line) const {
    std::string text = fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>", number(line.from.x),
                                   number(line.from.y), number(line.to.x), number(line.to.y), stroke_of(line.stroke));
    if (const auto head = arrowhead(line))
      text += fmt::format("<polygon points=\"{}\"{}/>", points_of(*head), fill_of(line.stroke.colour));
    return text;
  }
  std::string operator()(const PolylineItem& item) const {
    return fmt::format("<polyline points=\"{}\" fill=\"none\"{}/>", points_of(item.points), stroke_of(item.stroke));
  }
  std::string operator()(const PolygonItem& item) const {
    return fmt::format("<polygon points=\"{}\"{}{}/>", points_of(item.points), fill_of(item.fill),
                       stroke_of(item.stroke));
  }
  std::string operator()(const CircleItem& item) const {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}{}/>", number(item.centre.x), number(item.centre.y),
                       number(item.radius), fill_of(item.fill), stroke_of(item.stroke));
  }
  std::string operator()(const ArcItem& item) const {
    // A chain of short lines: SVG cannot express an arc of a full turn.
    constexpr int pieces = 32;
    std::vector<Vec2d> points;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = item.begin + (item.end - item.begin) * i / pieces;
      points.push_back(item.centre + item.radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    return (*this)(PolylineItem{points, item.stroke});
  }
  std::string operator()(const TextItem& item) const {
    const auto anchor = [&] {
      switch (item.anchor) {
        case TextAnchor::start:
          return "start";
        case TextAnchor::middle:
          return "middle";
        case TextAnchor::end:
          return "end";
      }
      return "start";
    }();
    // The line height is 1.25 times the letters; their middle is a third above the baseline.
    const double letters = item.size / 1.25;
    const std::string halo =
        item.halo ? " paint-order=\"stroke\" stroke-linejoin=\"round\"" + stroke_of(Stroke{*item.halo, 0.3 * letters})
                  : "";
    return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}{}>{}</text>", number(item.at.x),
                       number(item.at.y + 0.35 * letters), number(letters), anchor, fill_of(item.colour), halo,
                       escaped(item.text));
  }
};

}  // namespace

std::string svg_element(const Shape2d& shape) { return std::visit(Element{}, shape); }

std::string svg_file(const DisplayList& list, double width, double height, Colour ground, std::string_view title) {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\"{3}/>\n",
      number(width), number(height), escaped(title), fill_of(ground));
  for (const DisplayItem& item : list) text += svg_element(item.shape) + "\n";
  return text + "</svg>\n";
}

std::string css_colour(Colour colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b); }

}  // namespace raywalk
