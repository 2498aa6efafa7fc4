// Packs the page's texts for pack.mjs, by PPMd. It is a module as unpack.cpp is, of the same library.

#include "gui/web/text_model.h"

#include <Ppmd7.h>
#include <emscripten/emscripten.h>

#include <cstddef>

namespace {

unsigned char texts[8 << 20], packed[8 << 20];
alignas(4) unsigned char memory[raywalk::text_memory];
std::size_t size = 0;
CPpmd7 model;

void put(IByteOutPtr /*to*/, Byte byte) {
  if (size == sizeof packed) __builtin_trap();
  packed[size++] = byte;
}
const IByteOut to_packed{put};

}  // namespace

extern "C" {

/// Where texts are to be written, and how many bytes of them at most.
EMSCRIPTEN_KEEPALIVE unsigned char* pack_room() { return texts; }
EMSCRIPTEN_KEEPALIVE std::size_t pack_most() { return sizeof texts; }

/// Packs so many bytes from there, once. How many they are then.
EMSCRIPTEN_KEEPALIVE std::size_t pack(std::size_t count) {
  Ppmd7_Construct(&model);
  model.Base = memory;
  model.Size = sizeof memory;
  model.rc.enc.Stream = &to_packed;
  Ppmd7z_Init_RangeEnc(&model);
  Ppmd7_Init(&model, raywalk::text_order);
  Ppmd7z_EncodeSymbols(&model, texts, texts + count);
  Ppmd7z_Flush_RangeEnc(&model);
  return size;
}

/// Where these stand.
EMSCRIPTEN_KEEPALIVE const unsigned char* pack_packed() { return packed; }
}
