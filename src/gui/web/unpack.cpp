// Unpacks the program's code in the browser: a module of its own, of a few kilobytes and without imports (unpack.js).
// What it unpacks is a .lzma file that tells its size and ends with LZMA's mark, and behind it the texts by PPMd. No
// damage goes unnoticed: what follows a wrong bit is unpacked to something else, and what is left over at the end of
// either is then not the 0 that it has to be. In the first the code stands sorted (joiner.h).

#include "gui/web/joiner.h"
#include "gui/web/text_model.h"

#include <LzmaDec.h>
#include <Ppmd7.h>
#include <emscripten/emscripten.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

extern "C" unsigned char __heap_base;  // the linker's: nothing of the module stands behind it

namespace {

using raywalk::Bytes, raywalk::Joiner, raywalk::most;

constexpr std::size_t size_size = 8, header_size = LZMA_PROPS_SIZE + size_size;
constexpr std::size_t sizes_size = 8;  // of the sizes of what is put together and of the packed texts
constexpr std::int32_t damaged = -1, no_memory = -2;

unsigned char room[1 << 16];
unsigned char header[header_size];
std::size_t of_header = 0;  // bytes that have come of it
CLzmaProb chances[16384];   // enough for the context of four bits that pack.mjs chooses
CLzmaDec decoder;
Joiner joiner;
Bytes packed_texts;
std::size_t texts_to_come = 0;  // bytes of them
CPpmd7 text_model;
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

// Behind the end comes what leaves no 0 over.
Byte next_packed(IByteInPtr /*from*/) { return packed_texts.left() > 0 ? *packed_texts.at++ : Byte{0xff}; }
const IByteIn from_packed_texts{next_packed};

int next_of_texts() {
  // It takes at most two bytes for each length of what it looks at; and five to begin with.
  if (texts_to_come > 0 && packed_texts.left() < 2 * (raywalk::text_order + 2)) return raywalk::not_there_yet;
  if (text_model.rc.dec.Stream == nullptr) {
    text_model.rc.dec.Stream = &from_packed_texts;
    if (!Ppmd7z_RangeDec_Init(&text_model.rc.dec)) return raywalk::wrong_text;
    Ppmd7_Init(&text_model, raywalk::text_order);
  }
  const int byte = Ppmd7z_DecodeSymbol(&text_model);
  return byte < 0 ? raywalk::wrong_text : byte;
}

// By LZMA comes first how large all is.
std::int32_t begin_joining() {
  const auto size_at = [](const unsigned char* at) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size |= std::size_t{at[i]} << (8 * i);
    return size;
  };
  const std::size_t size = size_at(decoder.dic);
  texts_to_come = size_at(decoder.dic + 4);
  if (size > most || texts_to_come > most) return damaged;
  joiner.takes(size);
  joiner.next_of_texts = next_of_texts;
  packed_texts.at = packed_texts.end = decoder.dic + decoder.dicBufSize + size;
  // Behind the packed texts stands what is known of texts, in whole words.
  Ppmd7_Construct(&text_model);
  text_model.Size = raywalk::text_memory;
  text_model.Base = packed_texts.at + texts_to_come;
  text_model.Base += -reinterpret_cast<std::size_t>(text_model.Base) % sizeof(std::uint32_t);
  if (!has_room_until(text_model.Base + text_model.Size)) return no_memory;
  joiner.read = sizes_size;
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
  if (LzmaDec_DecodeToDic(&decoder, decoder.dicBufSize, room + more, &read, LZMA_FINISH_END, &status) != SZ_OK)
    return damaged;
  if (joiner.read == 0 && decoder.dicPos >= sizes_size)
    if (const std::int32_t wrong = begin_joining(); wrong != 0) return wrong;
  const std::size_t of_texts = count - more - read;
  if (of_texts > texts_to_come) return damaged;
  if (joiner.read == 0) return 0;
  packed_texts.end = std::copy_n(room + more + read, of_texts, packed_texts.end);
  texts_to_come -= of_texts;
  const bool all = status == LZMA_STATUS_FINISHED_WITH_MARK && texts_to_come == 0;
  if (!joiner.join(decoder.dic, decoder.dicPos)) return damaged;
  whole = all && decoder.dicPos == decoder.dicBufSize && joiner.read == decoder.dicPos && joiner.whole() &&
          packed_texts.left() == 0 && Ppmd7z_RangeDec_IsFinishedOK(&text_model.rc.dec);
  if (all && !whole) return damaged;
  return static_cast<std::int32_t>(joiner.done());
}

/// Where that stands, and whether it is all.
EMSCRIPTEN_KEEPALIVE const unsigned char* unpack_code() { return decoder.dic + decoder.dicBufSize; }
EMSCRIPTEN_KEEPALIVE bool unpack_whole() { return whole; }
}
