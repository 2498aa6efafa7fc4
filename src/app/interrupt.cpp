#include "app/interrupt.h"

#include "text/temporary_file.h"

#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

namespace raywalk {

namespace {

constexpr std::array heeded_signals{SIGINT, SIGTERM, SIGHUP};
constexpr long brief_patience = 350'000;  // microseconds

Stopper signal_stopper;
std::atomic<bool> waiting{false};  // an Interrupt exists
std::atomic<bool> waiting_briefly{false};
std::atomic<long> raised_at{0};  // milliseconds
std::atomic<const char*> last_word{"interrupted\n"};
static_assert(std::atomic<long>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

long milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<long>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

[[noreturn]] void leave() {
  remove_temporary_files();
  const char* const word = last_word.load();
  // A failure cannot be reported.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, word, std::strlen(word));
  _exit(1);
}

void set_timer(long microseconds) {
  itimerval timer{};
  timer.it_value.tv_usec = microseconds;
  setitimer(ITIMER_REAL, &timer, nullptr);
}

extern "C" void on_signal(int /*signal*/) {
  const int error = errno;
  if (!waiting.load()) leave();
  const long now = milliseconds_now();
  if (!signal_stopper.raised.exchange(true)) {
    raised_at = now;
    if (waiting_briefly.load()) set_timer(brief_patience);
  } else if (constexpr long one_press = 300; now - raised_at.load() > one_press) {
    leave();  // `timeout` sends its signal twice in a row: this is not a second one
  }
  errno = error;
}

extern "C" void out_of_patience(int /*signal*/) {
  if (waiting_briefly.load()) leave();
}

/// Interrupted system calls are restarted.
void handle_signal(int signal, void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int each : heeded_signals) sigaddset(&action.sa_mask, each);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void end_at_signals() {
  for (const int signal : heeded_signals) {
    struct sigaction before{};
    // A signal that our parent ignores (a job in the background, nohup) stays ignored.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) handle_signal(signal, on_signal);
  }
}

Interrupt::Interrupt(Patience patience, const char* word) {
  signal_stopper.raised = false;
  last_word = word;
  if (patience == Patience::brief) handle_signal(SIGALRM, out_of_patience);
  waiting_briefly = patience == Patience::brief;
  waiting = true;
}

Interrupt::~Interrupt() {
  heeded();
  waiting = false;
}

Stop Interrupt::stop() const { return Stop(signal_stopper); }

void Interrupt::heeded() const {
  if (waiting_briefly.exchange(false)) set_timer(0);
}

}  // namespace raywalk
