#include "render/parallel.h"

#include <algorithm>

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
#define RAYWALK_THREADS 0
#else
#define RAYWALK_THREADS 1
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>
#endif

namespace raywalk {

#if RAYWALK_THREADS

int hardware_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

int parallel_for(int count, int threads, const std::function<void(int index)>& body) {
  if (count <= 0) return 0;
  const int wanted = std::min(threads > 0 ? threads : hardware_threads(), count);
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int index = next++; index < count; index = next++) body(index);
  };
  std::vector<std::thread> helpers;
  helpers.reserve(static_cast<std::size_t>(wanted - 1));
  for (int i = 1; i < wanted; ++i) {
    try {
      helpers.emplace_back(work);
    } catch (const std::system_error&) {
      break;  // the system has no more threads to give; those there are do all of the work
    }
  }
  work();
  for (std::thread& helper : helpers) helper.join();
  return static_cast<int>(helpers.size()) + 1;
}

#else

int hardware_threads() { return 1; }

int parallel_for(int count, int /*threads*/, const std::function<void(int index)>& body) {
  for (int index = 0; index < count; ++index) body(index);
  return count > 0 ? 1 : 0;
}

#endif

}  // namespace raywalk
