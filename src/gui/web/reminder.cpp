// A page has one thread, so the flag stays up, and whoever works looks at the clock.

#include "gui/reminder.h"

#include <emscripten/emscripten.h>

namespace raywalk {

namespace {
constexpr double every = 5;         // milliseconds
constexpr unsigned glances = 1024;  // between looks at the clock, which takes longer than a ray
}  // namespace

struct Reminder::Parts {
  std::atomic<bool>& raised;
  double last = 0;
  unsigned glanced = 0;
};

Reminder::Reminder(std::atomic<bool>& raised) : parts_(new Parts{raised}) {}

Reminder::~Reminder() = default;

void Reminder::begin() {
  parts_->last = emscripten_get_now();
  parts_->raised = true;
}

void Reminder::end() { parts_->raised = false; }

bool Reminder::due() {
  if (++parts_->glanced % glances != 0) return false;
  const double now = emscripten_get_now();
  if (now - parts_->last < every) return false;
  parts_->last = now;
  return true;
}

}  // namespace raywalk
