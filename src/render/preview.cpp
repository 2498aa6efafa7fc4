#include "render/preview.h"

#include "image/srgb.h"
#include "render/parallel.h"
#include "render/picture.h"
#include "trace/recursion.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>

namespace raywalk {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int coarsest = 8;

using Rgba = std::array<std::uint8_t, 4>;

template <class T>
Rgba rgba_of(const Rgb<T>& colour, Encoding encoding) {
  const Rgb<float> c(colour);
  if (std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z)) return {255, 0, 255, 255};
  return {to_byte(c.x, encoding), to_byte(c.y, encoding), to_byte(c.z, encoding), 255};
}

double cost_of(Heat heat, const Statistics& own, double microseconds) {
  switch (heat) {
    case Heat::none:
    case Heat::noise:
      return 0;
    case Heat::rays:
      return static_cast<double>(std::accumulate(own.rays.begin(), own.rays.end(), std::uint64_t{0}));
    case Heat::tests:
      return static_cast<double>(own.tests.nodes + own.tests.primitives);
    case Heat::time:
      return microseconds;
  }
  return 0;
}

}  // namespace

/// A preview in progress. A *pass* visits every row of a grid once, in any order and in any thread: first the passes
/// that trace pixel centres on ever finer grids, then one pass per sample.
class Preview::Work {
 public:
  Work(const Scene& scene, const PreviewSettings& settings)
      : settings_(settings), stack_(std::max(default_stack, stack_for(scene.limits.depth))) {
    if (settings.heat != Heat::none)
      costs_.assign(static_cast<std::size_t>(settings.size.width) * static_cast<std::size_t>(settings.size.height),
                    -1.0f);
  }
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void refine(double milliseconds, int threads, const Stop& stop, std::vector<std::uint8_t>& rgba);
  [[nodiscard]] bool has_every_pixel() const { return sample_ >= 0; }
  [[nodiscard]] bool finished() const { return has_every_pixel() && sample_ == samples_to_take(); }
  [[nodiscard]] double done() const {
    const double rows = static_cast<double>(rows_to_do_.size());
    const double grid = rows_of_pass_ > 0 ? (rows_of_pass_ - rows) / rows_of_pass_ : 1;
    // The grid of each pass has four times the pixels of the previous one: 1/64, 1/16, 1/4, 1.
    const auto up_to = [](int stride) { return 1.0 / (stride * stride); };
    const double centres = has_every_pixel()     ? 1
                           : stride_ == coarsest ? grid * up_to(stride_)
                                                 : up_to(2 * stride_) + grid * (up_to(stride_) - up_to(2 * stride_));
    const double samples = finished() ? samples_to_take() : has_every_pixel() ? sample_ + grid : 0;
    return (centres + samples) / (1 + samples_to_take());
  }
  [[nodiscard]] const PreviewSettings& settings() const { return settings_; }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  [[nodiscard]] double hottest() const { return hottest_; }

 protected:
  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size().width) + static_cast<std::size_t>(column);
  }
  /// Records the cost of the pixel, in the unit of the heat map.
  void note_cost(int column, int row, double cost) { costs_[index_of(column, row)] = static_cast<float>(cost); }
  /// Traces the new pixels in row `row` of the grid of this stride.
  virtual Statistics trace_centres(int row, int stride, const Stop& stop) = 0;
  virtual Statistics trace_sample(int row, int sample, const Stop& stop) = 0;
  [[nodiscard]] virtual Rgba shown(int column, int row, int samples_taken) const = 0;

  [[nodiscard]] const ImageSize& size() const { return settings_.size; }
  /// Samples of each pixel to take after its centre. One sample per pixel is the centre itself.
  [[nodiscard]] int samples_to_take() const {
    if (settings_.heat == Heat::noise) return std::max(settings_.samples, PreviewSettings::fewest_for_noise);
    return settings_.samples > 1 && settings_.heat == Heat::none ? settings_.samples : 0;
  }
  void begin_pass();

 private:
  void trace_row(int row, const Stop& stop, std::vector<std::uint8_t>& rgba);
  void show_row(int row, int stride, int samples_taken, std::vector<std::uint8_t>& rgba) const;
  void end_pass();
  void show_heat(std::vector<std::uint8_t>& rgba);

  PreviewSettings settings_;
  std::size_t stack_;
  std::vector<float> costs_;  ///< of a heat map, per pixel; negative: not traced yet
  double hottest_ = 0;
  int stride_ = coarsest;  ///< of the current pass, while centres are traced
  int sample_ = -1;        ///< of the current pass, after that
  std::vector<int> rows_to_do_;
  double rows_of_pass_ = 0;
  Statistics statistics_;
  std::mutex statistics_mutex_;
};

template <class T>
class Preview::WorkIn final : public Preview::Work {
 public:
  WorkIn(const Scene& scene, const PreviewSettings& settings, WorldCache& worlds, const Stop& stop)
      : Work(scene, settings),
        world_(worlds.of<T>(scene, settings.accelerator, settings.fault, stop)),
        centres_(scene, *world_, settings.size, settings.size, {}),
        encoding_(scene.encoding),
        squares_(settings.heat == Heat::noise ? centres_.film().pixels().size() : 0) {
    if (samples_to_take() > 0)
      spread_.emplace(scene, *world_, settings.size, settings.size, Sampling{samples_to_take()});
    begin_pass();
  }

  [[nodiscard]] const Film<T>& film() const { return finished() && spread_ ? spread_->film() : centres_.film(); }

 private:
  Statistics trace_centres(int row, int stride, const Stop& stop) override {
    // In a row of the previous grid every second pixel is already traced.
    const bool old_row = stride < coarsest && row % (2 * stride) == 0;
    const PixelBlock block{old_row ? stride : 0, size().width, row, row + 1, 0, old_row ? 2 * stride : stride, 1, stop};
    if (settings().heat == Heat::none || settings().heat == Heat::noise) return centres_.trace(block);
    Statistics sum;
    for (const Pixel& pixel : block) {
      const auto begun = Clock::now();
      const Statistics own = centres_.trace({pixel.column, pixel.column + 1, pixel.row, pixel.row + 1, 0, 1, 1, stop});
      const double microseconds = std::chrono::duration<double, std::micro>(Clock::now() - begun).count();
      note_cost(pixel.column, pixel.row, cost_of(settings().heat, own, microseconds));
      sum += own;
    }
    return sum;
  }

  Statistics trace_sample(int row, int sample, const Stop& stop) override {
    std::vector<Rgb<T>> shades(static_cast<std::size_t>(size().width));  // a cancelled row is traced again
    Film<T>& mean = spread_->film();
    const Statistics statistics = spread_->trace_into(
        {0, size().width, row, row + 1, sample, 1, 1, stop},
        [&shades](const Pixel& p, const Rgb<T>& shade) { shades[static_cast<std::size_t>(p.column)] = shade; });
    for (int column = 0; column < size().width; ++column) {
      const Rgb<T>& shade = shades[static_cast<std::size_t>(column)];
      const Rgb<T> before = sample > 0 ? mean.at(column, row) : shade;
      mean.add(column, row, sample, shade);
      if (settings().heat == Heat::noise) note_scatter(column, row, sample, shade, before);
    }
    return statistics;
  }

  /// Updates the sum of squared deviations from the running mean (B. Welford, Technometrics 4(3), 1962).
  void note_scatter(int column, int row, int sample, const Rgb<T>& shade, const Rgb<T>& before) {
    const auto grey = [](const Rgb<T>& c) { return (Rgbd(c).x + Rgbd(c).y + Rgbd(c).z) / 3; };
    double& squares = squares_[index_of(column, row)];
    squares += grey(shade - before) * grey(shade - spread_->film().at(column, row));
    if (sample > 0) note_cost(column, row, std::sqrt(std::max(squares, 0.0) / sample));
  }

  /// While samples are missing, the centre counts as one more: the first samples alone may lie in one corner of the
  /// pixel.
  [[nodiscard]] Rgba shown(int column, int row, int samples_taken) const override {
    const Rgb<T>& centre = centres_.film().at(column, row);
    if (samples_taken == 0) return rgba_of(centre, encoding_);
    const Rgb<T>& mean = spread_->film().at(column, row);
    if (samples_taken == samples_to_take()) return rgba_of(mean, encoding_);
    return rgba_of(mean + (centre - mean) / static_cast<T>(samples_taken + 1), encoding_);
  }

  std::shared_ptr<const World<T>> world_;
  Picture<T> centres_;
  std::optional<Picture<T>> spread_;  ///< where samples are to be taken after the centres
  Encoding encoding_;
  std::vector<double> squares_;  ///< of a noise map, per pixel
};

void Preview::Work::begin_pass() {
  const int stride = has_every_pixel() ? 1 : stride_;
  rows_to_do_.clear();
  for (int row = 0; row < size().height; row += stride) rows_to_do_.push_back(row);
  rows_of_pass_ = static_cast<double>(rows_to_do_.size());
}

void Preview::Work::end_pass() {
  if (has_every_pixel()) {
    ++sample_;
  } else if (stride_ == 1) {
    sample_ = 0;
  } else {
    stride_ /= 2;
  }
  if (!finished()) begin_pass();
}

void Preview::Work::refine(double milliseconds, int threads, const Stop& stop, std::vector<std::uint8_t>& rgba) {
  const auto deadline = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  bool first = true;  // at least one row, so that refining with no time budget still progresses
  while (!finished() && (first || Clock::now() < deadline) && !stop.asked()) {
    // Which rows are left at the deadline depends on the threads, so each row is marked.
    std::vector<std::uint8_t> traced(rows_to_do_.size(), 0);
    const auto trace = [&](int i) {
      const auto index = static_cast<std::size_t>(i);
      if (!(first && i == 0) && Clock::now() >= deadline) return;
      try {
        trace_row(rows_to_do_[index], stop, rgba);
        traced[index] = 1;
      } catch (const Stopped&) {
      }
    };
    parallel_for(static_cast<int>(rows_to_do_.size()), threads, trace, stack_,
                 [&] { static_cast<void>(stop.asked()); });
    first = false;
    std::vector<int> left;
    for (std::size_t i = 0; i < traced.size(); ++i)
      if (traced[i] == 0) left.push_back(rows_to_do_[i]);
    rows_to_do_ = std::move(left);
    if (rows_to_do_.empty()) end_pass();
  }
  if (settings_.heat != Heat::none) show_heat(rgba);
}

/// Paints the whole picture, since the maximum may have changed: each pixel with its own cost, or that of the nearest
/// traced one on the coarser grids.
void Preview::Work::show_heat(std::vector<std::uint8_t>& rgba) {
  std::vector<float> known;
  for (const float cost : costs_)
    if (cost >= 0) known.push_back(cost);
  if (known.empty()) return;
  // An outlier, where the machine was busy with something else, must not darken all others. Nor one that happened to
  // hit a light that the others missed.
  const double part = settings_.heat == Heat::time || settings_.heat == Heat::noise ? 0.995 : 1;
  const auto last = known.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(known.size() - 1));
  std::nth_element(known.begin(), last, known.end());
  hottest_ = static_cast<double>(*last);
  const auto [width, height] = size();
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      float cost = -1;
      for (int stride = 1; stride <= coarsest && cost < 0; stride *= 2)
        cost = costs_[static_cast<std::size_t>(row / stride * stride) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column / stride * stride)];
      const auto colour = heat_colour(hottest_ > 0 ? std::max(static_cast<double>(cost), 0.0) / hottest_ : 0);
      std::copy(colour.begin(), colour.end(), rgba.begin() + (static_cast<std::ptrdiff_t>(row) * width + column) * 4);
    }
}

void Preview::Work::trace_row(int row, const Stop& stop, std::vector<std::uint8_t>& rgba) {
  const bool centres = !has_every_pixel();
  const Statistics statistics = centres ? trace_centres(row, stride_, stop) : trace_sample(row, sample_, stop);
  if (settings_.heat == Heat::none) show_row(row, centres ? stride_ : 1, centres ? 0 : sample_ + 1, rgba);
  const std::lock_guard lock(statistics_mutex_);
  statistics_ += statistics;
}

/// Paints the blocks of the row's pixels on a grid of this stride. The blocks of different rows do not overlap, and the
/// last ones reach to the border.
void Preview::Work::show_row(int row, int stride, int samples_taken, std::vector<std::uint8_t>& rgba) const {
  const auto [width, height] = size();
  const auto begin_of = [&](int at) { return std::max(0, at - stride / 2); };
  const auto end_of = [&](int at, int limit) { return at + stride >= limit ? limit : at + stride - stride / 2; };
  const auto row_of = [&, line = static_cast<std::ptrdiff_t>(width) * 4](int at) { return rgba.begin() + at * line; };
  auto to = row_of(begin_of(row));
  for (int column = 0; column < width; column += stride) {
    const Rgba colour = shown(column, row, samples_taken);
    for (int i = begin_of(column); i < end_of(column, width); ++i) to = std::copy(colour.begin(), colour.end(), to);
  }
  for (int copy = begin_of(row) + 1; copy < end_of(row, height); ++copy)
    std::copy(row_of(begin_of(row)), row_of(begin_of(row) + 1), row_of(copy));
}

Preview::Preview() = default;
Preview::Preview(const Scene& scene, const PreviewSettings& settings) { reset(scene, settings); }
Preview::~Preview() = default;
Preview::Preview(Preview&&) noexcept = default;
Preview& Preview::operator=(Preview&&) noexcept = default;

void Preview::reset(const Scene& scene, const PreviewSettings& settings, WorldCache* worlds, const Stop& stop) {
  WorldCache own;
  if (worlds == nullptr) worlds = &own;
  const bool keep_picture = work_ && work_->settings().size == settings.size;
  switch (settings.precision) {
    case Precision::float_:
      work_ = std::make_unique<WorkIn<float>>(scene, settings, *worlds, stop);
      break;
    case Precision::double_:
      work_ = std::make_unique<WorkIn<double>>(scene, settings, *worlds, stop);
      break;
  }
  if (keep_picture) return;
  const auto pixels = static_cast<std::size_t>(settings.size.width) * static_cast<std::size_t>(settings.size.height);
  rgba_.assign(pixels * 4, 0);
  for (std::size_t i = 0; i < pixels; ++i) rgba_[4 * i + 3] = 255;
  ++revision_;
}

bool Preview::refine(double milliseconds, int threads, const Stop& stop) {
  if (finished()) return false;
  work_->refine(milliseconds, threads, stop, rgba_);
  ++revision_;
  return !finished();
}

bool Preview::finished() const { return !work_ || work_->finished(); }
bool Preview::has_every_pixel() const { return work_ && work_->has_every_pixel(); }
double Preview::done() const { return work_ ? work_->done() : 1; }
ImageSize Preview::size() const { return work_ ? work_->settings().size : ImageSize{0, 0}; }
double Preview::hottest() const { return work_ ? work_->hottest() : 0; }
Statistics Preview::statistics() const { return work_ ? work_->statistics() : Statistics{}; }

template <class T>
const Film<T>& Preview::film() const {
  static const Film<T> none;
  const auto* work = dynamic_cast<const WorkIn<T>*>(work_.get());
  return work ? work->film() : none;
}

template const Film<float>& Preview::film<float>() const;
template const Film<double>& Preview::film<double>() const;

}  // namespace raywalk
