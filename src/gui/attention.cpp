#include "gui/attention.h"

namespace raywalk {

using Clock = std::chrono::steady_clock;

void Attention::begin(To what, double seconds) {
  what_ = what;
  until_.reset();
  if (seconds >= 0)
    until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  decided_ = false;
  begun_ = told_ = Clock::now();
  reminder_.begin();
}

void Attention::end() {
  reminder_.end();
  decided_ = false;
  tell_ = nullptr;
}

bool Attention::stops() {
  if (decided_ || std::this_thread::get_id() != own_) return decided_;
  if (!reminder_.due()) return false;
  const Clock::time_point now = Clock::now();
  decided_ = window_.look(what_ == To::input) || (until_ && now >= *until_);
  constexpr auto long_work = std::chrono::milliseconds(400), every = std::chrono::milliseconds(100);
  if (tell_ && !decided_ && now - begun_ >= long_work && now - told_ >= every) {
    told_ = now;
    decided_ = tell_(std::chrono::duration<double>(now - begun_).count());
  }
  if (decided_) raised = true;
  return decided_;
}

}  // namespace raywalk
