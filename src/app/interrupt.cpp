#include "app/interrupt.h"

#include <csignal>

namespace raywalk {

namespace {

std::atomic<bool> raised{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

constexpr int heeded[] = {SIGINT, SIGTERM};

extern "C" void raise_flag(int /*signal*/) { raised.store(true, std::memory_order_relaxed); }

}  // namespace

Interrupt::Interrupt() {
  raised = false;
  struct sigaction action{};
  action.sa_handler = raise_flag;
  // The second signal finds the default action again; system calls that the first one interrupts go on.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : heeded) {
    struct sigaction before{};
    // A signal that our parent ignores (a job in the background) stays ignored.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

Interrupt::~Interrupt() {
  for (const int signal : heeded) {
    struct sigaction now{};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == raise_flag) std::signal(signal, SIG_DFL);
  }
}

const std::atomic<bool>& Interrupt::flag() { return raised; }

}  // namespace raywalk
