#include "gui/reminder.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace raywalk {

struct Reminder::Parts {
  std::atomic<bool>& raised;
  std::mutex mutex{};
  std::condition_variable changed{};
  bool watching = false, over = false;
  std::thread thread{};

  void remind() {
    constexpr auto every = std::chrono::milliseconds(30);
    std::unique_lock lock(mutex);
    while (!over) {
      changed.wait(lock, [this] { return watching || over; });
      changed.wait_for(lock, every, [this] { return over; });
      if (watching) raised = true;
    }
  }
  void set(bool& what, bool value) {
    {
      const std::lock_guard lock(mutex);
      what = value;
      raised = false;
    }
    changed.notify_all();
  }
};

Reminder::Reminder(std::atomic<bool>& raised) : parts_(new Parts{raised}) {
  parts_->thread = std::thread([parts = parts_.get()] { parts->remind(); });
}

Reminder::~Reminder() {
  parts_->set(parts_->over, true);
  parts_->thread.join();
}

void Reminder::begin() { parts_->set(parts_->watching, true); }

void Reminder::end() { parts_->set(parts_->watching, false); }

bool Reminder::due() {
  parts_->raised = false;
  return true;
}

}  // namespace raywalk
