#include "render/parallel.h"

#include <algorithm>

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
#define RAYWALK_THREADS 0
#else
#define RAYWALK_THREADS 1
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace raywalk {

#if RAYWALK_THREADS

namespace {

extern "C" void* run_body(void* body) {
  const std::unique_ptr<std::function<void()>> own(static_cast<std::function<void()>*>(body));
  (*own)();
  return nullptr;
}

/// std::thread cannot set the size of its stack.
bool start(pthread_t& thread, std::size_t stack, std::function<void()> body) {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  auto own = std::make_unique<std::function<void()>>(std::move(body));
  const bool started = pthread_attr_setstacksize(&attributes, stack) == 0 &&
                       pthread_create(&thread, &attributes, run_body, own.get()) == 0;
  pthread_attr_destroy(&attributes);
  if (started) static_cast<void>(own.release());
  return started;
}

/// Like std::latch, but the waiting thread can do something meanwhile.
class Latch {
 public:
  void count_down() {
    const std::lock_guard lock(mutex_);
    ++left_;
    changed_.notify_all();
  }
  template <class Waiting>
  void wait_for(std::size_t count, const Waiting& waiting) {
    constexpr auto now_and_then = std::chrono::milliseconds(10);
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, now_and_then, [&] { return left_ >= count; })) {
      lock.unlock();
      waiting();
      lock.lock();
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t left_ = 0;
};

std::atomic<int> detached{0};

}  // namespace

int hardware_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

int parallel_for(int count, int threads, const std::function<void(int index)>& body, std::size_t stack,
                 const std::function<void()>& waiting) {
  if (count <= 0) return 0;
  const int wanted = std::min(threads > 0 ? threads : hardware_threads(), count);
  std::atomic<int> next{0};
  std::exception_ptr thrown;
  std::mutex throwing;
  const auto work = [&] {
    try {
      for (int index = next++; index < count; index = next++) body(index);
    } catch (...) {
      const std::lock_guard lock(throwing);
      if (!thrown) thrown = std::current_exception();
      next = count;
    }
  };
  Latch latch;
  std::vector<pthread_t> helpers;
  helpers.reserve(static_cast<std::size_t>(wanted - 1));
  for (int i = 1; i < wanted; ++i) {
    pthread_t helper{};
    if (!start(helper, stack, [&] {
          work();
          latch.count_down();
        }))
      break;  // the system refuses more threads; the existing ones do all of the work
    helpers.push_back(helper);
  }
  work();
  if (waiting) latch.wait_for(helpers.size(), waiting);
  for (const pthread_t helper : helpers) pthread_join(helper, nullptr);
  if (thrown) std::rethrow_exception(thrown);
  return static_cast<int>(helpers.size()) + 1;
}

bool run_on_stack(std::size_t stack, const std::function<void()>& body) {
  std::exception_ptr thrown;
  pthread_t thread{};
  if (!start(thread, stack, [&] {
        try {
          body();
        } catch (...) {
          thrown = std::current_exception();
        }
      }))
    return false;
  pthread_join(thread, nullptr);
  if (thrown) std::rethrow_exception(thrown);
  return true;
}

void run_detached(const Stop& stop, std::function<void()> body) {
  struct Shared {
    std::function<void()> body;
    Latch latch;
    std::exception_ptr thrown;
  };
  const auto shared = std::make_shared<Shared>();
  shared->body = std::move(body);
  pthread_t thread{};
  ++detached;
  const bool started = start(thread, default_stack, [shared] {
    try {
      shared->body();
    } catch (...) {
      shared->thrown = std::current_exception();
    }
    --detached;
    shared->latch.count_down();
  });
  if (!started) {
    --detached;
    return shared->body();
  }
  pthread_detach(thread);
  shared->latch.wait_for(1, [&] { stop.check(); });
  if (shared->thrown) std::rethrow_exception(shared->thrown);
}

bool has_detached_work() { return detached > 0; }

#else

int hardware_threads() { return 1; }

int parallel_for(int count, int /*threads*/, const std::function<void(int index)>& body, std::size_t /*stack*/,
                 const std::function<void()>& /*waiting*/) {
  for (int index = 0; index < count; ++index) body(index);
  return count > 0 ? 1 : 0;
}

bool run_on_stack(std::size_t /*stack*/, const std::function<void()>& /*body*/) { return false; }
void run_detached(const Stop& /*stop*/, std::function<void()> body) { body(); }
bool has_detached_work() { return false; }

#endif

}  // namespace raywalk
