#include "study/workbench.h"

#include "render/picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace raywalk::study {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double almost = 0.999;

double rms(const std::vector<Rgbd>& differences) {
  double squares = 0;
  for (const Rgbd& difference : differences) squares += dot(difference, difference);
  return std::sqrt(squares / (3 * std::max(1.0, static_cast<double>(differences.size()))));
}

}  // namespace

/// A picture in progress, row by row.
class Workbench::Development {
 public:
  virtual ~Development() = default;
  /// Traces the rest of one row at one sample. Returns whether anything is left. Throws Stopped when cancelled through
  /// `stop`: the next call traces the interrupted pixel again, and the counts are as if it had not been interrupted.
  virtual bool step(const Stop& stop) = 0;
  [[nodiscard]] virtual double done() const = 0;
  [[nodiscard]] virtual Image image() const = 0;
  [[nodiscard]] virtual std::vector<Rgbd> pixels() const = 0;
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  double seconds = 0;

 protected:
  Statistics statistics_;
};

namespace {

template <class T>
class DevelopmentIn final : public Workbench::Development {
 public:
  DevelopmentIn(const Scene& scene, const Setup& setup, ImageSize size, std::uint64_t seed, const Stop& stop)
      : world_(scene, setup.accelerator, {}, {.stop = stop}),
        picture_(scene, world_, size, size, Sampling{setup.samples, seed}, setup.tolerance),
        sample_(picture_.from()) {}

  bool step(const Stop& stop) override {
    const ImageSize size = picture_.film().size();
    for (; column_ < size.width; ++column_)
      statistics_ += picture_.trace({column_, column_ + 1, row_, row_ + 1, sample_, 1, 1, stop}, [this] { ++taken_; });
    column_ = 0;
    if (++row_ < size.height) return true;
    row_ = 0;
    if (++sample_ < picture_.to()) return true;
    const bool goes_on = picture_.next();
    sample_ = picture_.from();
    return goes_on;
  }
  [[nodiscard]] double done() const override {
    return static_cast<double>(taken_) / static_cast<double>(picture_.expected());
  }
  [[nodiscard]] Image image() const override { return image_of(picture_.film()); }
  [[nodiscard]] std::vector<Rgbd> pixels() const override {
    const auto& means = picture_.film().pixels();
    return {means.begin(), means.end()};
  }

 private:
  World<T> world_;
  Picture<T> picture_;
  int sample_, row_ = 0, column_ = 0;  ///< of the next pixel
  std::uint64_t taken_ = 0;
};

std::unique_ptr<Workbench::Development> develop(const Scene& scene, const Setup& setup, ImageSize size,
                                                std::uint64_t seed, const Stop& stop) {
  const Scene changed = under(scene, setup);
  if (setup.single_precision) return std::make_unique<DevelopmentIn<float>>(changed, setup, size, seed, stop);
  return std::make_unique<DevelopmentIn<double>>(changed, setup, size, seed, stop);
}

}  // namespace

Setup setup_of(const Scene& scene) {
  return {.samples = scene.render.samples,
          .sampler = scene.render.sampler,
          .light_grid = scene.render.light_grid.value_or(0),
          .depth = scene.limits.depth,
          .threshold = scene.limits.threshold,
          .tolerance = scene.render.tolerance,
          .numerics = scene.render.numerics,
          .epsilon = scene.render.numerics == Numerics::naive ? scene.render.epsilon : default_epsilon};
}

Scene under(const Scene& scene, const Setup& setup) {
  Scene changed = scene;
  changed.render.samples = setup.samples;
  changed.render.sampler = setup.sampler;
  changed.render.light_grid = setup.light_grid > 0 ? std::optional(setup.light_grid) : std::nullopt;
  changed.render.tolerance = setup.tolerance;
  changed.render.numerics = setup.numerics;
  changed.render.epsilon = setup.epsilon;
  changed.limits = {setup.depth, setup.threshold};
  return changed;
}

double cost_on(CostAxis axis, const Cost& cost) {
  switch (axis) {
    case CostAxis::seconds:
      return cost.seconds;
    case CostAxis::rays:
      return static_cast<double>(cost.rays);
    case CostAxis::tests:
      return static_cast<double>(cost.nodes + cost.tests);
  }
  return 0;
}

std::vector<int> frontier(const std::vector<Attempt>& attempts, CostAxis axis) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(attempts.size()); ++i)
    if (attempts[static_cast<std::size_t>(i)].done >= 1) order.push_back(i);
  const auto at = [&](int i) -> const Attempt& { return attempts[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const double cost_a = cost_on(axis, at(a).cost), cost_b = cost_on(axis, at(b).cost);
    return cost_a != cost_b ? cost_a < cost_b : at(a).error < at(b).error;
  });
  std::vector<int> best;
  for (const int i : order)
    if (best.empty() || at(i).error < at(best.back()).error) best.push_back(i);
  return best;
}

Workbench::Workbench() = default;
Workbench::~Workbench() = default;
Workbench::Workbench(Workbench&&) noexcept = default;
Workbench& Workbench::operator=(Workbench&&) noexcept = default;

void Workbench::reset(const Scene& scene, ImageSize size, const std::vector<Setup>& setups) {
  const std::uint64_t revision = revision_;
  *this = Workbench();
  revision_ = revision + 1;
  scene_ = std::make_unique<Scene>(scene);
  size_ = size;
  depth_ = scene.limits.depth + deeper;
  for (const Setup& setup : setups) try_out(setup);
}

void Workbench::try_out(const Setup& setup) {
  const bool known =
      std::any_of(attempts_.begin(), attempts_.end(), [&](const Attempt& a) { return a.setup == setup; });
  if (known) return;
  attempts_.push_back({.setup = setup});
  ++revision_;
  // The user waits for this one, but not for the reference.
  if (attempt_ < 0) under_way_.reset();
  if (setup.depth + deeper > depth_) forget_reference(setup.depth + deeper);
}

void Workbench::forget_reference(int depth) {
  depth_ = depth;
  passes_ = 0;
  floor_ = 0;
  for (Attempt& attempt : attempts_) attempt.error = 0;
  reference_ = {};
  halves_[0].clear();
  halves_[1].clear();
}

bool Workbench::finished() const {
  if (attempts_.empty()) return true;
  const bool waiting = std::any_of(attempts_.begin(), attempts_.end(), [](const Attempt& a) { return a.done < 1; });
  return !waiting && passes_ >= max_passes;
}

bool Workbench::work(double milliseconds, const Stop& stop) {
  const auto deadline = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  while (!finished()) {
    if (!under_way_) begin(stop);
    const double before = thread_seconds();
    const bool more = under_way_->step(stop);
    under_way_->seconds += thread_seconds() - before;
    if (attempt_ >= 0) attempts_[static_cast<std::size_t>(attempt_)].done = std::min(under_way_->done(), almost);
    if (!more) end();
    if (Clock::now() >= deadline) break;
  }
  return !finished();
}

void Workbench::show(Findings found) {
  bool is_new = found.reference_samples != reference_samples();
  for (std::size_t i = 0; i < std::min(attempts_.size(), found.attempts.size()); ++i) {
    Attempt& own = attempts_[i];
    Attempt& other = found.attempts[i];
    is_new = is_new || !other.image.pixels.empty();
    if (!other.image.pixels.empty()) own.image = std::move(other.image);
    own.done = other.done;
    own.cost = other.cost;
    own.error = other.error;
  }
  if (!found.reference.pixels.empty()) reference_ = std::move(found.reference);
  passes_ = found.reference_samples / samples_a_pass;
  floor_ = found.floor;
  if (is_new) ++revision_;
}

void Workbench::begin(const Stop& stop) {
  const auto waiting = std::find_if(attempts_.begin(), attempts_.end(), [](const Attempt& a) { return a.done < 1; });
  attempt_ = waiting == attempts_.end() ? -1 : static_cast<int>(waiting - attempts_.begin());
  if (attempt_ >= 0) {
    under_way_ = develop(*scene_, waiting->setup, size_, 0, stop);
    return;
  }
  Setup right = setup_of(*scene_);
  right.samples = samples_a_pass;
  right.sampler = Sampler::sobol;
  right.depth = depth_;
  right.threshold = right.tolerance = 0;
  right.numerics = Numerics::robust;
  // Attempts draw with seed 0.
  under_way_ = develop(*scene_, right, size_, static_cast<std::uint64_t>(passes_) + 1, stop);
}

void Workbench::end() {
  if (attempt_ >= 0) {
    Attempt& attempt = attempts_[static_cast<std::size_t>(attempt_)];
    attempt.done = 1;
    attempt.image = under_way_->image();
    attempt.cost = cost_of(under_way_->statistics(), under_way_->seconds);
  } else {
    const std::vector<Rgbd> pass = under_way_->pixels();
    std::vector<Rgbd>& half = halves_[passes_ % 2];
    half.resize(pass.size(), Rgbd(0.0));
    const double n = passes_ / 2 + 1;
    for (std::size_t i = 0; i < pass.size(); ++i) half[i] += (pass[i] - half[i]) / n;
    ++passes_;
    take_reference();
  }
  under_way_.reset();
  attempt_ = -1;
  for (Attempt& attempt : attempts_) attempt.error = error_of(attempt);
  ++revision_;
}

/// The mean of the halves, each with the weight of its passes. The halves' difference d is that of two independent
/// pictures: as large as their errors combined, so the error of their mean is d / 2.
void Workbench::take_reference() {
  if (passes_ < 2) return;
  const double first = (passes_ + 1) / 2, second = passes_ / 2;
  std::vector<Rgbd> differences;
  reference_ = {size_.width, size_.height, {}};
  for (std::size_t i = 0; i < halves_[0].size(); ++i) {
    reference_.pixels.emplace_back((halves_[0][i] * first + halves_[1][i] * second) / (first + second));
    differences.push_back((halves_[0][i] - halves_[1][i]) / 2.0);
  }
  floor_ = rms(differences);
}

double Workbench::error_of(const Attempt& attempt) const {
  if (attempt.done < 1 || reference_.pixels.empty()) return 0;
  std::vector<Rgbd> differences;
  for (std::size_t i = 0; i < attempt.image.pixels.size(); ++i)
    differences.push_back(Rgbd(attempt.image.pixels[i]) - Rgbd(reference_.pixels[i]));
  return rms(differences);
}

}  // namespace raywalk::study
