// Unpacks the program's code in the browser: a module of its own, of a few kilobytes and without imports (unpack.js).
// What it unpacks is a .lzma file that tells its size and ends with LZMA's mark. No damage goes unnoticed: what follows
// a wrong bit is unpacked to something else, and what is left over at the mark is then not the 0 that it has to be.
// In it the code stands sorted (joiner.h).

#include "gui/web/joiner.h"

#include <LzmaDec.h>
#include <emscripten/emscripten.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

extern "C" unsigned char __heap_base;  // the linker's: nothing of the module stands behind it

namespace {

using raywalk::Joiner, raywalk::most;

constexpr std::size_t size_size = 8, header_size = LZMA_PROPS_SIZE + size_size;
constexpr std::size_t size_of_size = 4;  // of what is put together
constexpr std::int32_t damaged = -1, no_memory = -2;

unsigned char room[1 << 16];
unsigned char header[header_size];
std::size_t of_header = 0;  // bytes that have come of it
CLzmaProb chances[16384];   // enough for the context of four bits that pack.mjs chooses
CLzmaDec decoder;
Joiner joiner;
bool whole = false;

constexpr std::size_t page = 1 << 16;
bool has_room_until(const unsigned char* end) {
  const std::size_t pages = (reinterpret_cast<std::size_t>(end) + page - 1) / page, now = __builtin_wasm_memory_size(0);
  return pages <= now || __builtin_wasm_memory_grow(0, pages - now) != SIZE_MAX;
}

void* take(ISzAllocPtr /*from*/, std::size_t bytes) { return bytes <= sizeof chances ? chances : nullptr; }
void give(ISzAllocPtr /*back*/, void* /*taken*/) {}
const ISzAlloc in_place{take, give};

// What is unpacked stands behind all that the module has, and is what the decoder looks back into.
std::int32_t begin() {
  std::uint64_t size = 0;
  for (std::size_t i = 0; i < size_size; ++i) size |= std::uint64_t{header[LZMA_PROPS_SIZE + i]} << (8 * i);
  if (size > most || LzmaDec_AllocateProbs(&decoder, header, LZMA_PROPS_SIZE, &in_place) != SZ_OK) return damaged;
  decoder.dic = &__heap_base;
  decoder.dicBufSize = static_cast<std::size_t>(size);
  unsigned char* const end = decoder.dic + decoder.dicBufSize;
  if (!has_room_until(end)) return no_memory;
  joiner.begin(end);
  LzmaDec_Init(&decoder);
  return 0;
}

}  // namespace

extern "C" {

/// Where packed bytes are to be written, and how many at most at once.
EMSCRIPTEN_KEEPALIVE unsigned char* unpack_room() { return room; }
EMSCRIPTEN_KEEPALIVE std::size_t unpack_most() { return sizeof room; }

/// Takes so many bytes from there. How much of the code it has put together by now; or what is wrong.
EMSCRIPTEN_KEEPALIVE std::int32_t unpack(std::size_t count) {
  const std::size_t more = std::min(count, header_size - of_header);
  std::copy_n(room, more, header + of_header);
  of_header += more;
  if (of_header < header_size) return 0;
  if (more > 0)
    if (const std::int32_t wrong = begin(); wrong != 0) return wrong;
  std::size_t read = count - more;
  ELzmaStatus status = LZMA_STATUS_NOT_SPECIFIED;
  if (LzmaDec_DecodeToDic(&decoder, decoder.dicBufSize, room + more, &read, LZMA_FINISH_END, &status) != SZ_OK ||
      read < count - more)
    return damaged;
  if (joiner.read == 0) {
    if (decoder.dicPos < size_of_size) return 0;
    std::size_t size = 0;
    for (std::size_t i = 0; i < size_of_size; ++i) size |= std::size_t{decoder.dic[i]} << (8 * i);
    if (size > most) return damaged;
    if (!has_room_until(decoder.dic + decoder.dicBufSize + size)) return no_memory;
    joiner.takes(size);
    joiner.read = size_of_size;
  }
  if (!joiner.join(decoder.dic, decoder.dicPos)) return damaged;
  whole = status == LZMA_STATUS_FINISHED_WITH_MARK && decoder.dicPos == decoder.dicBufSize &&
          joiner.read == decoder.dicPos && joiner.whole();
  return static_cast<std::int32_t>(joiner.done());
}

/// Where that stands, and whether it is all.
EMSCRIPTEN_KEEPALIVE const unsigned char* unpack_code() { return decoder.dic + decoder.dicBufSize; }
EMSCRIPTEN_KEEPALIVE bool unpack_whole() { return whole; }
}
