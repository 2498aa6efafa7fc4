#pragma once
// Polls user input during long operations, so that the window can be closed at any time.

#include "gui/reminder.h"
#include "gui/window.h"
#include "math/stop.h"

#include <chrono>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

namespace raywalk {

/// The stopper of the window's work. It is reminded to poll events, which only the creating thread may do.
class Attention final : public Stopper {
 public:
  explicit Attention(Window& window) : window_(window), reminder_(raised) {}

  /// What ends the watched work.
  enum class To {
    closing,  ///< closing the window
    input     ///< that, a key, a button, a drag
  };
  /// While one exists, the work is watched; at most one at a time. It also ends after `seconds`, unless negative, when
  /// other work is due.
  class Watch {
   public:
    Watch(Attention& attention, To what, double seconds = -1) : attention_(attention) {
      attention_.begin(what, seconds);
    }
    ~Watch() { attention_.end(); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    Attention& attention_;
  };

  /// During the work that is being watched, from when it takes long and then ten times a second, on the thread that
  /// watches: gets the seconds so far, and returns whether the work is to end.
  void tell(std::function<bool(double seconds)> tell) { tell_ = std::move(tell); }

  [[nodiscard]] bool stops() override;

 private:
  void begin(To what, double seconds);
  void end();

  Window& window_;
  std::thread::id own_ = std::this_thread::get_id();
  To what_ = To::closing;
  std::optional<std::chrono::steady_clock::time_point> until_;
  std::chrono::steady_clock::time_point begun_, told_;
  std::function<bool(double)> tell_;  ///< may be empty
  std::atomic<bool> decided_{false};
  Reminder reminder_;
};

}  // namespace raywalk
