#include "gui/attention.h"

namespace raywalk {

using Clock = std::chrono::steady_clock;

Attention::Attention(Window& window) : window_(window), reminder_([this] { remind(); }) {}

Attention::~Attention() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  reminder_.join();
}

void Attention::begin(To what, double seconds) {
  what_ = what;
  until_.reset();
  if (seconds >= 0)
    until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  decided_ = raised = false;
  {
    const std::lock_guard lock(mutex_);
    watching_ = true;
  }
  changed_.notify_all();
}

void Attention::end() {
  const std::lock_guard lock(mutex_);
  watching_ = false;
  decided_ = raised = false;
}

void Attention::remind() {
  constexpr auto every = std::chrono::milliseconds(30);
  std::unique_lock lock(mutex_);
  while (!over_) {
    changed_.wait(lock, [this] { return watching_ || over_; });
    changed_.wait_for(lock, every, [this] { return over_; });
    if (watching_) raised = true;
  }
}

bool Attention::stops() {
  if (decided_ || std::this_thread::get_id() != own_) return decided_;
  raised = false;  // until the next reminder
  decided_ = window_.look(what_ == To::input) || (until_ && Clock::now() >= *until_);
  if (decided_) raised = true;
  return decided_;
}

}  // namespace raywalk
