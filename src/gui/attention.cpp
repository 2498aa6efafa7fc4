#include "gui/attention.h"

namespace raywalk {

using Clock = std::chrono::steady_clock;

void Attention::begin(To what, double seconds) {
  what_ = what;
  until_.reset();
  if (seconds >= 0)
    until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  decided_ = false;
  reminder_.begin();
}

void Attention::end() {
  reminder_.end();
  decided_ = false;
}

bool Attention::stops() {
  if (decided_ || std::this_thread::get_id() != own_) return decided_;
  if (!reminder_.due()) return false;
  decided_ = window_.look(what_ == To::input) || (until_ && Clock::now() >= *until_);
  if (decided_) raised = true;
  return decided_;
}

}  // namespace raywalk
