#pragma once

#include <atomic>
#include <memory>

namespace raywalk {

/// Raises a flag every so often during long work, so that it looks up. Differs by platform: a thread of its own where
/// there are threads, else a clock.
class Reminder {
 public:
  explicit Reminder(std::atomic<bool>& raised);
  ~Reminder();
  Reminder(const Reminder&) = delete;
  Reminder& operator=(const Reminder&) = delete;

  void begin();
  /// The flag is low afterwards.
  void end();
  /// To be asked by whoever finds the flag raised: whether it is time to look up. Lowers the flag until the next time.
  [[nodiscard]] bool due();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raywalk
