#pragma once
// Cancellation of long work, like std::stop_source and std::stop_token. What may cancel (a signal, a person at the
// window, a clock) is a Stopper; long work is given a Stop by value, checks it regularly, and throws Stopped. This
// needs neither threads nor signals: a Stopper that is always raised is asked each time.

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace raywalk {

/// Thrown by cancelled work. What it had begun is dropped.
struct Stopped {};

/// Who may cancel work. Outlives it.
class Stopper {
 public:
  Stopper() = default;
  virtual ~Stopper() = default;
  Stopper(const Stopper&) = delete;
  Stopper& operator=(const Stopper&) = delete;

  /// Requests that the work end, or at least that `stops` be asked. Set from any thread or a signal handler.
  std::atomic<bool> raised{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

  /// Whether the work is to end. Called by any working thread while `raised` is true.
  [[nodiscard]] virtual bool stops() { return true; }
};

/// A handle to a Stopper: while it is not raised, a check costs one load.
class Stop {
 public:
  Stop() = default;  ///< never
  explicit Stop(Stopper& stopper) : stopper_(&stopper) {}

  [[nodiscard]] bool asked() const { return stopper_->raised.load(std::memory_order_relaxed) && stopper_->stops(); }
  /// Throws Stopped when asked.
  void check() const {
    if (stopper_->raised.load(std::memory_order_relaxed)) [[unlikely]]
      ask();
  }
  /// body(*i) for each i from `begin` up to `end`, with regular checks: for bodies of a few instructions.
  template <class Iterator, class Body>
  void each(Iterator begin, Iterator end, Body body) const {
    constexpr std::ptrdiff_t stretch = std::ptrdiff_t{1} << 15;
    while (begin != end) {
      check();
      for (const Iterator until = begin + std::min<std::ptrdiff_t>(stretch, end - begin); begin != until; ++begin)
        body(*begin);
    }
  }
  /// std::sort, with regular checks.
  template <class Iterator, class Less>
  void sort(Iterator begin, Iterator end, Less less) const {
    constexpr std::ptrdiff_t soon_done = std::ptrdiff_t{1} << 17;
    if (end - begin <= soon_done) {
      check();
      return std::sort(begin, end, less);
    }
    unsigned compared = 0;
    std::sort(begin, end, [&](const auto& a, const auto& b) {
      constexpr unsigned every = 1U << 16;
      if (++compared % every == 0) check();
      return less(a, b);
    });
  }

 private:
  [[gnu::cold, gnu::noinline]] void ask() const {
    if (stopper_->stops()) throw Stopped{};
  }

  inline static Stopper nobody_;
  Stopper* stopper_ = &nobody_;
};

}  // namespace raywalk
