#include "text/text_file.h"

#include "text/file.h"

#include <algorithm>
#include <array>

namespace raywalk {

using namespace std::string_view_literals;

std::optional<Error> why_not_utf8(std::string_view bytes, const std::string& path) {
  // The longer marks first: that of UTF-16 begins one of UTF-32.
  struct ByteOrderMark {
    std::string_view bytes, encoding;
  };
  constexpr std::array<ByteOrderMark, 4> marks{
      {{"\xff\xfe\0\0"sv, "UTF-32"}, {"\0\0\xfe\xff"sv, "UTF-32"}, {"\xff\xfe"sv, "UTF-16"}, {"\xfe\xff"sv, "UTF-16"}}};
  const auto refused = [&](std::string_view encoding, std::string_view why) {
    return Error{path, 1, 1, std::string("the file is in ").append(encoding).append(why) + " (expected UTF-8)",
                 "save it again with the encoding UTF-8"};
  };
  for (const ByteOrderMark& mark : marks)
    if (bytes.starts_with(mark.bytes)) return refused(mark.encoding, ", as its byte order mark (BOM) says");
  // Without one, every other byte of ASCII letters is 0.
  const auto zero = [&](std::size_t i) { return bytes[i] == '\0'; };
  if (bytes.size() >= 4 && zero(0) == zero(2) && zero(1) == zero(3) && zero(0) != zero(1))
    return refused("UTF-16", ", without a byte order mark");
  return std::nullopt;
}

void end_lines_with_lf(std::string& bytes, std::size_t begin, std::size_t end) {
  for (std::size_t at = bytes.find('\r', begin); at < end; at = bytes.find('\r', at + 1))
    if (at + 1 == end || bytes[at + 1] != '\n') bytes[at] = '\n';
}

void drop_utf8_marks(std::string& bytes) {
  std::size_t end = 0;
  while (bytes.compare(end, utf8_mark.size(), utf8_mark) == 0) end += utf8_mark.size();
  bytes.erase(0, end);
}

Result<void> make_plain_text(std::string& bytes, const std::string& path) {
  if (const auto other = why_not_utf8(bytes, path)) return tl::unexpected(*other);
  drop_utf8_marks(bytes);
  end_lines_with_lf(bytes, 0, bytes.size());
  if (const std::size_t mark = bytes.find("\n" + std::string(utf8_mark)); mark != std::string::npos) {
    const auto line = 2 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(mark), '\n');
    return tl::unexpected(Error{path, static_cast<int>(line), 1,
                                "the line begins with a byte order mark (BOM) (expected none after the first line)",
                                "were files joined here? remove the mark, which editors do not show"});
  }
  if (const auto zero = std::find(bytes.begin(), bytes.end(), '\0'); zero != bytes.end()) {
    const auto line = 1 + std::count(bytes.begin(), zero, '\n');
    return tl::unexpected(Error{path, static_cast<int>(line), 0, "this is no text: it holds the byte 0x00",
                                "is this the right file, and is it whole?"});
  }
  return {};
}

Result<std::string> read_text(const std::string& path, std::size_t max_bytes) {
  auto bytes = read_file(path, max_bytes);
  if (!bytes) return bytes;
  if (const auto plain = make_plain_text(*bytes, path); !plain) return tl::unexpected(plain.error());
  return bytes;
}

}  // namespace raywalk
