#include "render/beam_drawing.h"

#include "image/srgb.h"
#include "text/markup.h"
#include "trace/beam_scene.h"
#include "trace/space_beam_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

using Colour = std::array<std::uint8_t, 3>;
using Piece = ShadedPiece<double>;

constexpr double widest_beam = 16;     // pixels along the side of a beam
constexpr double drawn_as_same = 0.5;  // pixels: edges that move by less as a beam is cut
constexpr std::size_t most_polygons = 2'000'000;

Colour colour_of(const Rgbd& shade, Encoding encoding) {
  const auto byte = [&](double linear) { return to_byte(static_cast<float>(linear), encoding); };
  return {byte(shade.x), byte(shade.y), byte(shade.z)};
}

bool holds(const WindowPiece& corners, const Vec2d& place) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d& from = corners[i];
    const double side = cross(corners[i + 1 == corners.size() ? 0 : i + 1] - from, place - from);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

/// Of the polygons of an object that have the same colour.
struct Outlines {
  int object = -1;
  Colour colour{};
  std::string path;
  double area = 0, length = 0;

  [[nodiscard]] double width() const { return area / length; }
};

class Drawer {
 public:
  Drawer(const Scene& scene, const BeamDrawingSettings& settings)
      : scene_(scene),
        settings_(settings),
        world_(scene),
        faces_(beam_faces_of(scene, settings.stop)),
        camera_(scene, settings.size, settings.size) {}

  /// Adds what is seen in a rectangle, as few polygons as show how colours change.
  void draw(const Vec2d& from, const Vec2d& to) {
    Beam beam{from, to, parts(from, to)};
    draw(beam);
  }

  [[nodiscard]] std::size_t polygons() const { return polygons_; }

  /// Neighbours that meet within a pixel let through what is behind them. There the same polygons are drawn before,
  /// with strokes, the thinnest first, that they do not show beside wider ones. Then all again without strokes, the
  /// thinnest last: then each covers as much of a pixel as it is.
  [[nodiscard]] std::string svg() const {
    const ImageSize size = settings_.size;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "fill=\"currentColor\">\n",
        size.width, size.height);
    if (!scene_.title.empty()) text += "<title>" + escaped(scene_.title) + "</title>\n";
    const std::vector<const Outlines*> order = thinnest_first();
    text += "<g stroke=\"currentColor\" stroke-width=\"1.5\" stroke-linejoin=\"round\">\n";
    for (std::size_t i = 0; i < order.size(); ++i)
      text += fmt::format(
          "<path id=\"p{}\" vector-effect=\"non-scaling-stroke\" color=\"#{:02x}{:02x}{:02x}\" d=\"{}\"/>\n", i,
          order[i]->colour[0], order[i]->colour[1], order[i]->colour[2], order[i]->path);
    text += "</g>\n";
    for (std::size_t i = order.size(); i > 0; --i) {
      const int object = order[i - 1]->object;
      if (i == order.size() || order[i]->object != object)
        text += object < 0 ? "<g>\n" : "<g><title>" + escaped(name_of(object)) + "</title>\n";
      text += fmt::format("<use href=\"#p{}\"/>\n", i - 1);
      if (i == 1 || order[i - 2]->object != object) text += "</g>\n";
    }
    return text + "</svg>\n";
  }

 private:
  [[nodiscard]] std::vector<Piece> parts(const Vec2d& from, const Vec2d& to) const {
    return parts_of_picture(world_, faces_, camera_, from, to, settings_.stop);
  }

  /// A beam and, where it was asked for them, its quarters.
  struct Beam {
    Vec2d from, to;
    std::vector<Piece> parts;
    std::vector<Beam> quarters{};
  };

  void cut(Beam& beam) const {
    if (!beam.quarters.empty()) return;
    const Vec2d &from = beam.from, &to = beam.to, middle = (from + to) / 2.0;
    for (const auto& [low, high] : {std::pair{from, middle}, std::pair{Vec2d(middle.x, from.y), Vec2d(to.x, middle.y)},
                                    std::pair{Vec2d(from.x, middle.y), Vec2d(middle.x, to.y)}, std::pair{middle, to}})
      beam.quarters.push_back({low, high, parts(low, high)});
  }

  [[nodiscard]] bool is_finest(const Beam& beam) const {
    return !(std::max(beam.to.x - beam.from.x, beam.to.y - beam.from.y) > settings_.finest * (1 + 1e-9));
  }

  void draw(Beam& beam) {
    if (polygons_ > most_polygons) return;
    if (changes(beam)) {
      for (Beam& quarter : beam.quarters) draw(quarter);
      beam.quarters.clear();
    } else {
      for (const Piece& part : beam.parts) add(part);
    }
  }

  /// Whether its quarters would be drawn otherwise than the whole, or theirs: what is small may lie between the middles
  /// of a few parts. Then it has its quarters.
  [[nodiscard]] bool changes(Beam& beam) const {
    if (is_finest(beam)) return false;
    cut(beam);
    if (std::any_of(beam.parts.begin(), beam.parts.end(), [](const Piece& part) { return part.has_mean; })) return true;
    if (differ(beam.parts, beam.quarters)) return true;
    for (Beam& quarter : beam.quarters) {
      if (is_finest(quarter)) continue;
      cut(quarter);
      if (differ(beam.parts, quarter.quarters)) return true;
    }
    return false;
  }

  [[nodiscard]] bool differ(const std::vector<Piece>& whole, const std::vector<Beam>& finer) const {
    return std::any_of(finer.begin(), finer.end(), [&](const Beam& beam) {
      return std::any_of(beam.parts.begin(), beam.parts.end(), [&](const Piece& part) { return !shows(whole, part); });
    });
  }

  /// Whether a drawing of the whole shows what is seen from nearer: the same object in about the same colour, in the
  /// middle of the part and beside its corners.
  [[nodiscard]] bool shows(const std::vector<Piece>& whole, const Piece& part) const {
    const Colour colour = colour_of(part.shade, scene_.encoding);
    const Vec2d middle = middle_of(part.window);
    const auto shown_at = [&](const Vec2d& place) {
      return std::any_of(whole.begin(), whole.end(), [&](const Piece& each) {
        return each.object == part.object && holds(each.window, place) &&
               alike(colour_of(each.shade, scene_.encoding), colour);
      });
    };
    return shown_at(middle) && std::all_of(part.window.begin(), part.window.end(), [&](const Vec2d& corner) {
             const Vec2d inwards = middle - corner;
             const double far = length(inwards);
             return !(far > 2 * drawn_as_same) || shown_at(corner + inwards * (drawn_as_same / far));
           });
  }

  [[nodiscard]] bool alike(const Colour& a, const Colour& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i] - b[i]) > settings_.tolerance) return false;
    return true;
  }

  void add(const Piece& part) {
    ++polygons_;
    const Colour colour = colour_of(part.shade, scene_.encoding);
    Outlines& outlines = outlines_[{part.object, colour}];
    outlines.object = part.object, outlines.colour = colour;
    outlines.area += area_of(part.window);
    Vec2d last = part.window.back();
    char command = 'M';
    for (const Vec2d& corner : part.window) {
      outlines.path += fmt::format("{}{} {}", command, number(corner.x), number(corner.y));
      outlines.length += length(corner - last);
      last = corner;
      command = 'L';
    }
    outlines.path += 'Z';
  }

  /// By objects, and of each by colours.
  [[nodiscard]] std::vector<const Outlines*> thinnest_first() const {
    std::map<int, Outlines> objects;
    std::vector<const Outlines*> order;
    for (const auto& [key, outlines] : outlines_) {
      objects[outlines.object].area += outlines.area, objects[outlines.object].length += outlines.length;
      order.push_back(&outlines);
    }
    std::stable_sort(order.begin(), order.end(), [&](const Outlines* a, const Outlines* b) {
      const double width_a = objects[a->object].width(), width_b = objects[b->object].width();
      return std::tuple(width_a, a->object, a->width()) < std::tuple(width_b, b->object, b->width());
    });
    return order;
  }

  [[nodiscard]] const std::string& name_of(int object) const {
    return scene_.objects[static_cast<std::size_t>(object)].name;
  }

  /// To a thousandth of a pixel.
  [[nodiscard]] static std::string number(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
  }

  const Scene& scene_;
  const BeamDrawingSettings& settings_;
  World<double> world_;
  BeamFaces faces_;
  RayGenerator<double> camera_;
  std::map<std::pair<int, Colour>, Outlines> outlines_;  ///< by object and colour
  std::size_t polygons_ = 0;
};

}  // namespace

Result<BeamDrawing> beam_drawing(const Scene& scene, const BeamDrawingSettings& settings) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double width = settings.size.width, height = settings.size.height;
  try {
    Drawer drawer(scene, settings);
    for (double y = 0; y < height; y += widest_beam) {
      for (double x = 0; x < width; x += widest_beam)
        drawer.draw({x, y}, {std::min(x + widest_beam, width), std::min(y + widest_beam, height)});
      const double done = std::min((y + widest_beam) / height, 1.0);
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      if (settings.progress) settings.progress({done, seconds, seconds * (1 - done) / done});
    }
    if (drawer.polygons() > most_polygons)
      return tl::unexpected(Error{"", 0, 0, "the drawing would have more than 2,000,000 polygons",
                                  "choose a smaller --size, or a picture of pixels"});
    return BeamDrawing{drawer.svg(), drawer.polygons()};
  } catch (const Stopped&) {
    return BeamDrawing{"", 0, false};
  }
}

}  // namespace raywalk
