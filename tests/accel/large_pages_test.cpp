// Memory in large pages: aligned to them where it is as large as one, and the system is asked for them.

#include "accel/large_pages.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

using namespace raywalk;

namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;

struct alignas(64) Line {
  int number[16] = {};
};

/// The flags that Linux keeps of the memory at an address; empty where it does not tell.
std::string flags_at(const void* memory) {
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  std::ifstream maps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    unsigned long long begin = 0, end = 0;
    char dash = 0;
    std::istringstream range(line);
    if (range >> std::hex >> begin >> dash >> end && dash == '-') inside = begin <= address && address < end;
    if (inside && line.rfind("VmFlags:", 0) == 0) return line + " ";
  }
  return "";
}

}  // namespace

TEST_CASE("an array in large pages begins with one where it fills one, and is aligned as its elements are elsewhere") {
  const std::size_t lines =
      GENERATE(std::size_t{1}, std::size_t{3}, large_page / sizeof(Line) - 1, large_page / sizeof(Line),
               large_page / sizeof(Line) + 1, 5 * large_page / sizeof(Line) + 7);
  LargeArray<Line> array(lines);
  const auto address = reinterpret_cast<std::uintptr_t>(array.data());
  CHECK(address % alignof(Line) == 0);
  if (lines * sizeof(Line) >= large_page) CHECK(address % large_page == 0);
  for (std::size_t i = 0; i < lines; ++i) array[i].number[0] = static_cast<int>(i);
  LargeArray<Line> copy = array;
  array.push_back({});
  bool same = copy.size() == lines && array.size() == lines + 1;
  for (std::size_t i = 0; i < lines; ++i)
    same = same && array[i].number[0] == static_cast<int>(i) && copy[i].number[0] == static_cast<int>(i);
  CHECK(same);
}

#ifdef __linux__
TEST_CASE("memory in large pages is fresh where as much was freed before: what is used again has small pages") {
  constexpr std::size_t bytes = 2 * large_page;
  // What is freed first was mapped alone; from then on as much comes from the heap.
  std::vector<char>(4 * bytes, 'x').clear();
  std::vector<std::vector<char>> used;
  for (int i = 0; i < 6; ++i) used.emplace_back(bytes, 'x');
  used.erase(used.begin(), used.end() - 1);  // the last keeps the heap as long as it is
  InLargePages<Line> memory;
  Line* const lines = memory.allocate(bytes / sizeof(Line));
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> resident(bytes / page);
  REQUIRE(::mincore(lines, bytes, resident.data()) == 0);
  CHECK(std::none_of(resident.begin(), resident.end(), [](unsigned char page_is) { return (page_is & 1) != 0; }));
  memory.deallocate(lines, bytes / sizeof(Line));
}
#endif

TEST_CASE("Linux is asked for large pages") {
  const LargeArray<Line> array(4 * large_page / sizeof(Line));
  const std::string flags = flags_at(array.data());
  std::ifstream enabled("/sys/kernel/mm/transparent_hugepage/enabled");
  if (flags.empty() || !enabled) return;
  CHECK(flags.find(" hg ") != std::string::npos);
}

TEST_CASE("more elements than there can be are refused") {
  CHECK_THROWS_AS(InLargePages<Line>().allocate(SIZE_MAX / 2), std::bad_array_new_length);
}
