#include "render/preview.h"

#include "image/srgb.h"
#include "render/parallel.h"
#include "trace/recursion.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <mutex>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int coarsest = PreviewPass::coarsest;

using Rgba = std::array<std::uint8_t, 4>;

template <class T>
Rgba rgba_of(const Rgb<T>& colour, Encoding encoding) {
  const Rgb<float> c(colour);
  if (std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z)) return {255, 0, 255, 255};
  return {to_byte(c.x, encoding), to_byte(c.y, encoding), to_byte(c.z, encoding), 255};
}

}  // namespace

/// A preview in progress, pass by pass; the rows of a pass come in any order and from any thread.
class Preview::Work {
 public:
  Work(const Scene& scene, const PreviewSettings& settings)
      : settings_(settings), encoding_(scene.encoding), stack_(std::max(default_stack, stack_for(scene.limits.depth))) {
    if (settings.heat != Heat::none)
      costs_.assign(static_cast<std::size_t>(settings.size.width) * static_cast<std::size_t>(settings.size.height),
                    -1.0f);
    begin_pass();
  }
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void refine(const RowTracer& tracer, double milliseconds, int threads, const Stop& stop,
              std::vector<std::uint8_t>& rgba);
  [[nodiscard]] std::vector<PreviewRow> hand_out(int most);
  void take(std::vector<TracedRow> rows, std::vector<std::uint8_t>& rgba);
  [[nodiscard]] bool has_every_pixel() const { return !pass_.of_centres(); }
  [[nodiscard]] bool finished() const { return pass_.sample == samples_to_take(); }
  [[nodiscard]] double done() const {
    const double rows = static_cast<double>(rows_to_do_.size());
    const double grid = rows_of_pass_ > 0 ? (rows_of_pass_ - rows) / rows_of_pass_ : 1;
    // The grid of each pass has four times the pixels of the previous one: 1/64, 1/16, 1/4, 1.
    const auto up_to = [](int stride) { return 1.0 / (stride * stride); };
    const int stride = pass_.stride;
    const double centres = has_every_pixel()    ? 1
                           : stride == coarsest ? grid * up_to(stride)
                                                : up_to(2 * stride) + grid * (up_to(stride) - up_to(2 * stride));
    const double samples = finished() ? samples_to_take() : has_every_pixel() ? pass_.sample + grid : 0;
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
  /// Adds the shade of a pixel's centre, or of a sample, to the film.
  virtual void put(int column, int row, int sample, const Rgbd& shade) = 0;
  [[nodiscard]] virtual Rgba shown(int column, int row, int samples_taken) const = 0;

  [[nodiscard]] const ImageSize& size() const { return settings_.size; }
  [[nodiscard]] int samples_to_take() const { return settings_.samples_to_take(); }
  [[nodiscard]] Encoding encoding() const { return encoding_; }

 private:
  void begin_pass();
  void put_row(const TracedRow& traced, std::vector<std::uint8_t>& rgba);
  void show_row(int row, int stride, int samples_taken, std::vector<std::uint8_t>& rgba) const;
  void end_pass();
  void show_heat(std::vector<std::uint8_t>& rgba);

  PreviewSettings settings_;
  Encoding encoding_;
  std::size_t stack_;
  std::vector<float> costs_;  ///< of a heat map, per pixel; negative: not traced yet
  double hottest_ = 0;
  PreviewPass pass_;
  std::vector<int> rows_to_do_;
  double rows_of_pass_ = 0;
  PreviewRow next_out_;           ///< to be handed out
  std::vector<TracedRow> early_;  ///< of the next pass
  Statistics statistics_;
  std::mutex statistics_mutex_;
};

template <class T>
class Preview::WorkIn final : public Preview::Work {
 public:
  WorkIn(const Scene& scene, const PreviewSettings& settings)
      : Work(scene, settings),
        centres_(settings.size),
        spread_(samples_to_take() > 0 ? settings.size : ImageSize{0, 0}),
        squares_(settings.heat == Heat::noise ? centres_.pixels().size() : 0) {}

  [[nodiscard]] const Film<T>& film() const { return finished() && samples_to_take() > 0 ? spread_ : centres_; }

 private:
  void put(int column, int row, int sample, const Rgbd& shade) override {
    const Rgb<T> own(shade);
    if (sample < 0) return centres_.add(column, row, 0, own);
    const Rgb<T> before = sample > 0 ? spread_.at(column, row) : own;
    spread_.add(column, row, sample, own);
    if (settings().heat == Heat::noise) note_scatter(column, row, sample, own, before);
  }

  /// Updates the sum of squared deviations from the running mean (B. Welford, Technometrics 4(3), 1962).
  void note_scatter(int column, int row, int sample, const Rgb<T>& shade, const Rgb<T>& before) {
    const auto grey = [](const Rgb<T>& c) { return (Rgbd(c).x + Rgbd(c).y + Rgbd(c).z) / 3; };
    double& squares = squares_[index_of(column, row)];
    squares += grey(shade - before) * grey(shade - spread_.at(column, row));
    if (sample > 0) note_cost(column, row, std::sqrt(std::max(squares, 0.0) / sample));
  }

  /// While samples are missing, the centre counts as one more: the first samples alone may lie in one corner of the
  /// pixel.
  [[nodiscard]] Rgba shown(int column, int row, int samples_taken) const override {
    const Rgb<T>& centre = centres_.at(column, row);
    if (samples_taken == 0) return rgba_of(centre, encoding());
    const Rgb<T>& mean = spread_.at(column, row);
    if (samples_taken == samples_to_take()) return rgba_of(mean, encoding());
    return rgba_of(mean + (centre - mean) / static_cast<T>(samples_taken + 1), encoding());
  }

  Film<T> centres_, spread_;
  std::vector<double> squares_;  ///< of a noise map, per pixel
};

void Preview::Work::begin_pass() {
  rows_to_do_.clear();
  for (int row = 0; row < size().height; row += pass_.stride) rows_to_do_.push_back(row);
  rows_of_pass_ = static_cast<double>(rows_to_do_.size());
}

void Preview::Work::end_pass() {
  pass_ = pass_.next();
  if (!finished()) begin_pass();
}

std::vector<PreviewRow> Preview::Work::hand_out(int most) {
  std::vector<PreviewRow> rows;
  const auto is_due = [&] {
    const PreviewPass& pass = next_out_.pass;
    return pass.sample < std::max(samples_to_take(), 0) && (pass == pass_ || pass == pass_.next());
  };
  while (static_cast<int>(rows.size()) < most && is_due()) {
    rows.push_back(next_out_);
    next_out_.row += next_out_.pass.stride;
    if (next_out_.row >= size().height) next_out_ = {next_out_.pass.next(), 0};
  }
  return rows;
}

void Preview::Work::take(std::vector<TracedRow> rows, std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i < rows.size() && !finished(); ++i) {
    if (rows[i].of.pass != pass_) {
      early_.push_back(std::move(rows[i]));
      continue;
    }
    put_row(rows[i], rgba);
    std::erase(rows_to_do_, rows[i].of.row);
    if (!rows_to_do_.empty()) continue;
    end_pass();
    std::move(early_.begin(), early_.end(), std::back_inserter(rows));
    early_.clear();
  }
  if (settings_.heat != Heat::none) show_heat(rgba);
}

void Preview::Work::refine(const RowTracer& tracer, double milliseconds, int threads, const Stop& stop,
                           std::vector<std::uint8_t>& rgba) {
  const auto deadline = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  bool first = true;  // at least one row, so that refining with no time budget still progresses
  while (!finished() && (first || Clock::now() < deadline) && !stop.asked()) {
    // Which rows are left at the deadline depends on the threads, so each row is marked.
    std::vector<std::uint8_t> traced(rows_to_do_.size(), 0);
    const auto trace = [&](int i) {
      const auto index = static_cast<std::size_t>(i);
      if (!(first && i == 0) && Clock::now() >= deadline) return;
      try {
        put_row(tracer.trace({pass_, rows_to_do_[index]}, stop), rgba);
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

void Preview::Work::put_row(const TracedRow& traced, std::vector<std::uint8_t>& rgba) {
  const auto& [pass, row] = traced.of;
  auto [column, step] = columns_of(traced.of);
  for (std::size_t i = 0; i < traced.shades.size(); ++i, column += step) {
    put(column, row, pass.sample, traced.shades[i]);
    if (i < traced.costs.size()) note_cost(column, row, traced.costs[i]);
  }
  if (settings_.heat == Heat::none) show_row(row, pass.stride, pass.sample + 1, rgba);
  const std::lock_guard lock(statistics_mutex_);
  statistics_ += traced.statistics;
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
  RowTracer tracer(scene, settings, worlds != nullptr ? *worlds : own, stop);
  reset_elsewhere(scene, settings);
  tracer_.emplace(std::move(tracer));
}

void Preview::reset_elsewhere(const Scene& scene, const PreviewSettings& settings) {
  const bool keep_picture = work_ && work_->settings().size == settings.size;
  tracer_.reset();
  switch (settings.precision) {
    case Precision::float_:
      work_ = std::make_unique<WorkIn<float>>(scene, settings);
      break;
    case Precision::double_:
      work_ = std::make_unique<WorkIn<double>>(scene, settings);
      break;
  }
  if (!keep_picture) blank();
}

void Preview::blank() {
  const auto pixels = static_cast<std::size_t>(size().width) * static_cast<std::size_t>(size().height);
  rgba_.assign(pixels * 4, 0);
  for (std::size_t i = 0; i < pixels; ++i) rgba_[4 * i + 3] = 255;
  ++revision_;
}

std::vector<PreviewRow> Preview::hand_out(int most) {
  return work_ ? work_->hand_out(most) : std::vector<PreviewRow>();
}

void Preview::take(std::vector<TracedRow> rows) {
  if (!work_) return;
  work_->take(std::move(rows), rgba_);
  ++revision_;
}

bool Preview::refine(double milliseconds, int threads, const Stop& stop) {
  if (finished() || !tracer_) return false;
  work_->refine(*tracer_, milliseconds, threads, stop, rgba_);
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
  constexpr Precision own = std::is_same_v<T, float> ? Precision::float_ : Precision::double_;
  if (!work_ || work_->settings().precision != own) return none;
  return static_cast<const WorkIn<T>&>(*work_).film();
}

template const Film<float>& Preview::film<float>() const;
template const Film<double>& Preview::film<double>() const;

}  // namespace raywalk
