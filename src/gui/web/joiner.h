#pragma once
// Puts the page's code together again, which streams.mjs has sorted by what instructions are made of: all opcodes, all
// locals, all offsets and so on stand beside each other, where each is foretold by its like.
//
// A local that is read is told by how many others of the function were named since it was; before any is named, the
// last was 0, then 1 and so on. So code that differs only in the numbers of its locals is the same, which spares a
// fiftieth of all. (Bentley et al., "A locally adaptive data compression scheme", 1986.)
//
// First comes the size of the whole, and then parts, each of which is put together as soon as it is there. A part
// begins with a word of four bytes. 0: so many bytes, as the next word says, that stand there as they are, and behind
// them as many as the third says of the texts, which are packed elsewhere. Else it is the number of functions that
// follow, and then come the sizes of all streams, and the streams.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace raywalk {

inline constexpr std::uint64_t most = 64 << 20;  ///< bytes; what says that it has more is damaged

// The numbers of the streams, as in streams.mjs.
enum Name : std::size_t {
  declarations,
  opcodes,
  local,
  local_set,
  small,
  added,
  large,
  i64,
  f32,
  f64,
  vectors,
  called,
  called_by_pointer,
  branches,
  branch_tables,
  others,
  loaded,
  stored,
  lanes_offset,
  lanes_align,
  align,
  names = align + 0x3f - 0x28
};

inline constexpr int not_there_yet = -1, wrong_text = -2;  // in place of a byte of the texts

/// The locals of a function, the one that was named last first.
class RecentLocals {
 public:
  static constexpr std::uint32_t most = 1 << 14;  ///< as in streams.mjs

  void begin() { count_ = 0; }
  /// The local of this rank, which is then the first.
  std::uint32_t name_ranked(std::uint32_t rank) {
    reach(rank);
    const std::uint16_t local = locals_[rank];
    std::copy_backward(locals_, locals_ + rank, locals_ + rank + 1);
    return locals_[0] = local;
  }
  void name(std::uint32_t local) {
    reach(local);
    std::uint32_t rank = 0;
    while (locals_[rank] != local) ++rank;
    name_ranked(rank);
  }

 private:
  // Those that were not named yet stand in their order.
  void reach(std::uint32_t place) {
    for (; count_ <= place; ++count_) locals_[count_] = static_cast<std::uint16_t>(count_);
  }

  std::uint16_t locals_[most];
  std::uint32_t count_ = 0;  // that stand in it
};

struct Bytes {
  unsigned char *at = nullptr, *end = nullptr;
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end - at); }
};

class Joiner {
 public:
  /// False: it is damaged.
  bool join(unsigned char* from, std::size_t count);
  void begin(unsigned char* to) { code_ = to; }
  void takes(std::size_t size) { made_ = {code_, code_ + size}; }
  [[nodiscard]] std::size_t done() const { return static_cast<std::size_t>(made_.at - code_); }
  [[nodiscard]] bool whole() const { return made_.at != nullptr && made_.at == made_.end; }
  std::size_t read = 0;              ///< of what is unpacked
  int (*next_of_texts)() = nullptr;  ///< a byte, or one of those two

 private:
  bool function();
  bool instruction(unsigned op);
  void put(unsigned byte) {
    if (made_.at == made_.end) return fail();
    *made_.at++ = static_cast<unsigned char>(byte);
  }
  unsigned take(Name name) {
    Bytes& stream = streams_[name];
    if (stream.at == stream.end) return fail(), 0U;
    return *stream.at++;
  }
  unsigned pass(Name name) {
    const unsigned byte = take(name);
    put(byte);
    return byte;
  }
  void pass(Name name, int count) {
    for (; count > 0; --count) pass(name);
  }
  std::uint32_t number(Name name) {
    std::uint32_t value = 0;
    for (unsigned shift = 0; !failed_; shift += 7) {
      const unsigned byte = pass(name);
      if (shift < 32) value |= (byte & 127U) << shift;
      if (byte < 128) break;
    }
    return value;
  }
  // An instruction that reads a local, or writes one.
  void read_local() {
    std::uint32_t rank = 0;
    unsigned byte = 128;
    for (unsigned shift = 0; byte > 127 && shift < 21; shift += 7) {
      byte = take(local);
      rank |= (byte & 127U) << shift;
    }
    if (rank >= RecentLocals::most) return fail();
    std::uint32_t index = recent_.name_ranked(rank);
    for (; index > 127; index >>= 7) put((index & 127U) | 128U);
    put(index);
  }
  void write_local() {
    const std::uint32_t index = number(local_set);
    if (index >= RecentLocals::most) return fail();
    recent_.name(index);
  }
  void fail() { failed_ = true; }

  Bytes streams_[names];
  RecentLocals recent_;
  Bytes made_;
  unsigned char* code_ = nullptr;
  std::size_t text_left_ = 0;  // bytes that come next
  int depth_ = 0;              // of blocks
  bool failed_ = false;
};

// Appends an instruction's operands, and says whether the function goes on.
inline bool Joiner::instruction(unsigned op) {
  if (op == 0x27) {  // what stands for a large constant
    put(0x41);
    number(large);
    return true;
  }
  put(op);
  if (op >= 0x28 && op <= 0x3e) {
    number(static_cast<Name>(align + op - 0x28));
    number(op >= 0x36 ? stored : loaded);
    return true;
  }
  switch (op) {
    case 0x02:
    case 0x03:
    case 0x04:
    case 0x06:
      number(opcodes);
      ++depth_;
      break;
    case 0x18:
      --depth_;
      [[fallthrough]];
    case 0x0c:
    case 0x0d:
    case 0x09:
      number(branches);
      break;
    case 0x0b:
      return --depth_ >= 0;
    case 0x0e:
      for (std::uint64_t left = std::uint64_t{number(branch_tables)} + 1; left > 0 && !failed_; --left)
        number(branch_tables);
      break;
    case 0x10:
      number(called);
      break;
    case 0x11:
      number(called_by_pointer);
      number(called_by_pointer);
      break;
    case 0x1c:
      for (std::uint32_t left = number(opcodes); left > 0 && !failed_; --left) number(opcodes);
      break;
    case 0x20:
      read_local();
      break;
    case 0x21:
    case 0x22:
      write_local();
      break;
    case 0x07:
    case 0x08:
    case 0x23:
    case 0x24:
    case 0x25:
    case 0x26:
    case 0x3f:
    case 0x40:
    case 0xd0:
    case 0xd2:
      number(others);
      break;
    case 0x41:  // followed by an addition, or not
      number(streams_[opcodes].left() > 0 && *streams_[opcodes].at == 0x6a ? added : small);
      break;
    case 0x42:
      number(i64);
      break;
    case 0x43:
      pass(f32, 4);
      break;
    case 0x44:
      pass(f64, 8);
      break;
    case 0xfc: {
      const unsigned more = pass(opcodes);
      if (more == 10 || more == 11) pass(others, more == 10 ? 2 : 1);
      break;
    }
    case 0xfd: {
      const std::uint32_t more = number(opcodes);
      const bool names_lane = more >= 84 && more <= 91;
      if (more <= 11 || names_lane || more == 92 || more == 93) {
        number(lanes_align);
        number(lanes_offset);
      }
      if (more == 12 || more == 13) pass(vectors, 16);
      if ((more >= 21 && more <= 34) || names_lane) pass(others);
      break;
    }
    default:
      break;
  }
  return true;
}

inline bool Joiner::function() {
  constexpr std::ptrdiff_t longest = 5;  // digits of its size, which stands before it
  if (made_.end - made_.at < longest) return false;
  unsigned char* const size_at = made_.at;
  unsigned char* const body = made_.at += longest;
  for (std::uint32_t groups = number(declarations); groups > 0 && !failed_; --groups) {
    number(declarations);
    pass(declarations);
  }
  depth_ = 0;
  recent_.begin();
  while (!failed_ && instruction(take(opcodes))) {
  }
  if (failed_) return false;
  unsigned char* const end = made_.at;
  made_.at = size_at;
  std::size_t size = static_cast<std::size_t>(end - body);
  for (; size > 127; size >>= 7) put((size & 127) | 128);
  put(static_cast<unsigned>(size));
  made_.at = std::copy(body, end, made_.at);
  return true;
}

// Of so many bytes that are unpacked.
inline bool Joiner::join(unsigned char* from, std::size_t count) {
  const auto word = [&](std::size_t i) {
    const unsigned char* const at = from + read + 4 * i;
    return std::size_t{at[0]} | std::size_t{at[1]} << 8 | std::size_t{at[2]} << 16 | std::size_t{at[3]} << 24;
  };
  for (;;) {
    for (; text_left_ > 0; --text_left_) {
      const int byte = next_of_texts();
      if (byte < 0) return byte == not_there_yet;
      *made_.at++ = static_cast<unsigned char>(byte);
    }
    const std::size_t left = count - read;
    if (left < 12) return true;
    const std::size_t functions = word(0), words = functions == 0 ? 3 : 1 + names;
    if (left < 4 * words) return true;
    std::size_t size = 4 * words;
    for (std::size_t i = 1; i < words; ++i) {
      if (word(i) > most) return false;
      size += word(i);
    }
    if (functions == 0) size -= word(2);
    if (left < size) return true;
    unsigned char* at = from + read + 4 * words;
    if (functions == 0) {
      if (word(1) + word(2) > made_.left()) return false;
      made_.at = std::copy_n(at, word(1), made_.at);
      text_left_ = word(2);
    } else {
      for (std::size_t i = 0; i < names; ++i) {
        streams_[i] = {at, at + word(i + 1)};
        at = streams_[i].end;
      }
      for (std::size_t i = 0; i < functions; ++i)
        if (!function()) return false;
      for (const Bytes& stream : streams_)
        if (stream.at != stream.end) return false;
    }
    read += size;
  }
}

}  // namespace raywalk
