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

constexpr double widest_beam = 32;  // pixels along the side of a beam
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
  void draw(const Vec2d& from, const Vec2d& to) { draw(from, to, parts(from, to)); }

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

  void draw(const Vec2d& from, const Vec2d& to, const std::vector<Piece>& whole) {
    if (polygons_ > most_polygons) return;
    const Vec2d middle = (from + to) / 2.0;
    if (std::max(to.x - from.x, to.y - from.y) > settings_.finest * (1 + 1e-9)) {
      const std::array<std::pair<Vec2d, Vec2d>, 4> quarters{{{from, middle},
                                                             {{middle.x, from.y}, {to.x, middle.y}},
                                                             {{from.x, middle.y}, {middle.x, to.y}},
                                                             {middle, to}}};
      std::array<std::vector<Piece>, 4> finer;
      bool changes = std::any_of(whole.begin(), whole.end(), [](const Piece& part) { return part.has_mean; });
      for (std::size_t i = 0; i < 4; ++i) {
        finer[i] = parts(quarters[i].first, quarters[i].second);
        changes = changes || differ(whole, finer[i]);
      }
      if (changes) {
        for (std::size_t i = 0; i < 4; ++i) draw(quarters[i].first, quarters[i].second, finer[i]);
        return;
      }
    }
    for (const Piece& part : whole) add(part);
  }

  /// Whether what is seen from nearer has another colour than that of which it is a part.
  [[nodiscard]] bool differ(const std::vector<Piece>& whole, const std::vector<Piece>& finer) const {
    return std::any_of(finer.begin(), finer.end(), [&](const Piece& part) {
      const Vec2d middle = middle_of(part.window);
      const auto of = std::find_if(whole.begin(), whole.end(), [&](const Piece& each) {
        return each.object == part.object && holds(each.window, middle);
      });
      if (of == whole.end()) return false;
      const Colour a = colour_of(of->shade, scene_.encoding), b = colour_of(part.shade, scene_.encoding);
      int most = 0;
      for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
      return most > settings_.tolerance;
    });
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
