#include "render/parallel.h"

#include <atomic>
#include <chrono>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("parallel_for calls the body once for each index") {
  const int count = GENERATE(0, 1, 2, 7, 1000);
  const int threads = GENERATE(0, 1, 2, 3, 16);
  CAPTURE(count, threads);
  std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
  const int taking_part = parallel_for(count, threads, [&](int index) { ++calls[static_cast<std::size_t>(index)]; });
  for (const auto& number : calls) CHECK(number == 1);
  CHECK(taking_part == std::min(count, threads == 0 ? hardware_threads() : threads));
}

TEST_CASE("one thread takes the indices in order, in the caller") {
  std::vector<int> order;
  bool elsewhere = false;
  const auto caller = std::this_thread::get_id();
  parallel_for(50, 1, [&](int index) {
    order.push_back(index);
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
  });
  std::vector<int> expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  CHECK(order == expected);
  CHECK_FALSE(elsewhere);
}

TEST_CASE("what a body throws ends the work and is thrown to the caller, by whichever thread it came") {
  for (const int threads : {1, 2, 5})
    for (const int thrower : {0, 1, 500}) {
      CAPTURE(threads, thrower);
      std::atomic<int> calls{0};
      CHECK_THROWS_AS(parallel_for(100'000, threads,
                                   [&](int index) {
                                     ++calls;
                                     if (index == thrower) throw std::bad_alloc();
                                     if (index > thrower) std::this_thread::yield();
                                   }),
                      std::bad_alloc);
      CHECK(calls > thrower);
      CHECK(calls < 100'000);
    }
}

TEST_CASE("threads work at the same time") {
  // Each of the two waits until the other has begun; were they to run one after the other, the first would wait in
  // vain.
  std::atomic<int> begun{0};
  std::atomic<int> met{0};
  parallel_for(2, 2, [&](int) {
    ++begun;
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (begun < 2 && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
    if (begun == 2) ++met;
  });
  CHECK(met == 2);
}
