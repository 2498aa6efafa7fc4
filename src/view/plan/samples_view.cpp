// The samples of the current pixel in order, and how their mean converges.

#include "render/adaptive.h"
#include "view/plan/painter.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {

namespace {

double grey(const Rgbd& c) { return (c.x + c.y + c.z) / 3; }

/// The 95% confidence bound on the mean of `count` >= 2 independent samples, in standard errors; better samplers are
/// closer.
double reach_of(int count) {
  // Student's distribution with 1 to 14 degrees of freedom: W. Gosset, "The probable error of a mean", 1908.
  constexpr std::array few{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                           2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145};
  const auto freedom = static_cast<std::size_t>(count - 1);
  return freedom <= few.size() ? few[freedom - 1] : student_quantile(0.05, count - 1);
}

/// The mean of the first samples, and its interval; none before the second one.
struct Mean {
  double value = 0, half = 0;  ///< half of the 95% interval
};

std::vector<Mean> means_of(const std::vector<double>& samples) {
  std::vector<Mean> means;
  double mean = 0, squares = 0;  // B. Welford 1962
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double before = mean, count = static_cast<double>(i + 1);
    mean += (samples[i] - mean) / count;
    squares += (samples[i] - before) * (samples[i] - mean);
    Mean now{mean, 0};
    if (i > 0) now.half = reach_of(static_cast<int>(i + 1)) * std::sqrt(std::max(squares, 0.0) / (count - 1) / count);
    means.push_back(now);
  }
  return means;
}

}  // namespace

int samples_of_pixel(const Timeline& timeline, int pixel) {
  const auto& pixels = timeline.pixels();
  const auto at = [&](int i) -> const PixelRecord& { return pixels[static_cast<std::size_t>(i)]; };
  int last = pixel;
  while (last + 1 < static_cast<int>(pixels.size()) && at(last + 1).sample > 0) ++last;
  return at(last).sample + 1;
}

void draw_samples(Painter& painter) {
  const State& state = painter.state;
  const Timeline& timeline = *state.walk.timeline;
  const int pixel = timeline.current_pixel(state.walk.position);
  if (pixel < 0) return;
  const int samples = samples_of_pixel(timeline, pixel);
  if (samples < 2) return;
  const int first = pixel - timeline.pixels()[static_cast<std::size_t>(pixel)].sample;

  // The scale is that of all samples, so that it stays fixed.
  std::vector<double> all, done;
  for (int i = 0; i < samples; ++i) {
    all.push_back(grey(timeline.pixels()[static_cast<std::size_t>(first + i)].shade));
    if (timeline.pixel_done(first + i, state.walk.position)) done.push_back(all.back());
  }
  const std::vector<Mean> means = means_of(done);
  auto [least, most] = std::minmax_element(all.begin(), all.end());
  const double air = std::max(0.08 * (*most - *least), 1e-6);
  const double low = *least - air, high = *most + air;

  const double unit = painter.sizes.unit, letters = painter.sizes.text, gap = 8 * unit;
  const auto said_of = [&](const std::string& count, double mean, double half) {
    return fill("plan.samples_mean", state.appearance.language,
                {{"samples", count},
                 {"mean", number_text(mean, state.appearance.language)},
                 {"interval", number_text(half, state.appearance.language)}});
  };
  const double longest = text_width(said_of(std::to_string(samples), 0.888, 0.888), letters);
  const double width = std::max(std::min(230 * unit, 0.45 * painter.viewport.width), longest), tall = 92 * unit;
  // In a small pane the plot would cover its subject: then only the mean is shown.
  const bool plots = width * tall < 0.2 * painter.viewport.width * painter.viewport.height;
  if (!plots && means.size() < 2) return;
  const Vec2d size(width, plots ? tall : 0);
  const Vec2d corner(gap, painter.viewport.height - gap - size.y - 1.5 * letters);
  if (corner.y < gap || size.x > painter.viewport.width - 2 * gap) return;
  const auto rectangle = [](const Vec2d& a, const Vec2d& b) {
    return std::vector<Vec2d>{a, {b.x, a.y}, b, {a.x, b.y}};
  };
  const PixelRect plate{corner - gap / 2, corner + size + Vec2d(gap / 2, gap / 2 + 1.5 * letters)};
  painter.add(PolygonItem{rectangle(plate.min, plate.max), painter.colours.panel.with_alpha(235),
                          Stroke{painter.colours.dim_text.with_alpha(120), painter.sizes.line}});
  painter.kept_free.push_back(plate);
  if (means.size() > 1)
    painter.add(TextItem{{corner.x, corner.y + size.y + 0.85 * letters},
                         said_of(std::to_string(means.size()), means.back().value, means.back().half),
                         letters,
                         painter.colours.text,
                         TextAnchor::start});
  if (!plots) return;

  const auto x_of = [&](std::size_t i) {
    return corner.x + (static_cast<double>(i) + 0.5) / static_cast<double>(samples) * size.x;
  };
  const auto y_of = [&](double value) {
    return corner.y + size.y * (1 - (std::clamp(value, low, high) - low) / (high - low));
  };
  // The interval as a band, from the second sample on; the mean as a line; each sample as a ring.
  std::vector<Vec2d> band;
  for (std::size_t i = 1; i < means.size(); ++i) band.push_back({x_of(i), y_of(means[i].value + means[i].half)});
  for (std::size_t i = means.size(); i-- > 1;) band.push_back({x_of(i), y_of(means[i].value - means[i].half)});
  if (band.size() > 3) painter.add(PolygonItem{band, painter.colours.selected.with_alpha(60), std::nullopt});
  const double radius = std::clamp(0.3 * size.x / samples, 1.5 * unit, 4 * unit);
  for (std::size_t i = 0; i < done.size(); ++i)
    painter.add(
        CircleItem{{x_of(i), y_of(done[i])}, radius, std::nullopt, Stroke{painter.colours.text, painter.sizes.line}});
  PolylineItem line{{}, {painter.colours.next, 2.2 * painter.sizes.line}};
  for (std::size_t i = 0; i < means.size(); ++i) line.points.push_back({x_of(i), y_of(means[i].value)});
  if (line.points.size() > 1) painter.add(line);
}

}  // namespace raywalk
