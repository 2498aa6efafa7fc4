#pragma once
// How long work learns that nobody wants its result any more. Whoever may end it (a signal, a person at the window, a
// clock) is a Stopper; whatever takes long is given a Stop by value, reads it now and then, and throws Stopped. No
// threads and no signals are needed for that: a Stopper whose attention is always raised is asked each time.

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace raywalk {

/// Thrown by work that was given up. What it had begun is dropped.
struct Stopped {};

/// Who may end work. Outlives it.
class Stopper {
 public:
  Stopper() = default;
  virtual ~Stopper() = default;
  Stopper(const Stopper&) = delete;
  Stopper& operator=(const Stopper&) = delete;

  /// Asked for the work to end, or at least for `stops` to be asked. From any thread or a signal handler.
  std::atomic<bool> raised{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

  /// Whether the work is to end, asked by any thread that works while `raised` is true.
  [[nodiscard]] virtual bool stops() { return true; }
};

/// What work is given of a Stopper: where nobody has raised it, a look costs one load.
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
  /// body(*i) for each i from `begin` up to `end`, with a check every now and then: for bodies of a few instructions.
  template <class Iterator, class Body>
  void each(Iterator begin, Iterator end, Body body) const {
    constexpr std::ptrdiff_t stretch = std::ptrdiff_t{1} << 15;
    while (begin != end) {
      check();
      for (const Iterator until = begin + std::min<std::ptrdiff_t>(stretch, end - begin); begin != until; ++begin)
        body(*begin);
    }
  }
  /// std::sort, with a check every now and then.
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
