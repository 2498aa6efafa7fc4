#include "app/part_file.h"

#include "app/arguments.h"
#include "scene/schema_kinds.h"
#include "text/file.h"

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstring>
#include <string_view>

namespace raywalk {

namespace {

// A line with the number of bytes that follow it once unpacked: the head, as a line of JSON, then the pixels of the
// share's tiles, row by row, red, green and blue as the tracer has them. zlib's sum over both tells what was changed.
constexpr std::string_view first_words = "raywalk part 1 ";
constexpr std::size_t max_head = 1 << 20;

static_assert(std::endian::native == std::endian::little);

template <class T>
std::size_t bytes_of(ImageSize size, const Share& share) {
  std::size_t pixels = 0;
  Tiles(size).for_rows(share, [&](int, int, int columns) { pixels += static_cast<std::size_t>(columns); });
  return pixels * sizeof(Rgb<T>);
}

std::string head_of(const PicturePart& part) {
  nlohmann::json made_from = nlohmann::json::array();
  for (const auto& [name, value] : part.made_from) made_from.push_back({name, value});
  const nlohmann::json head{{"part", part.share.part},
                            {"of", part.share.of},
                            {"width", part.size.width},
                            {"height", part.size.height},
                            {"corners", part.corners},
                            {"double", std::holds_alternative<Film<double>>(part.film)},
                            {"truncated", part.encoding == Encoding::truncated},
                            {"made_from", made_from}};
  return head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Everything of a part but its pixels. False unless each value is there and possible.
bool take_head(std::string_view text, PicturePart& part) {
  const nlohmann::json head = nlohmann::json::parse(text, nullptr, false);
  if (!head.is_object()) return false;
  const auto whole = [&](const char* name, int low, int high, int& value) {
    const auto found = head.find(name);
    if (found == head.end() || !found->is_number_integer()) return false;
    const auto number = found->get<std::int64_t>();
    value = static_cast<int>(number);
    return number >= low && number <= high;
  };
  const auto flag = [&](const char* name, bool& value) {
    const auto found = head.find(name);
    if (found == head.end() || !found->is_boolean()) return false;
    value = found->get<bool>();
    return true;
  };
  constexpr int most = schema::pixel_count.high + 1;
  bool in_double = true, truncated = false;
  if (!whole("of", 1, max_parts, part.share.of) || !whole("part", 1, part.share.of, part.share.part) ||
      !whole("width", 1, most, part.size.width) || !whole("height", 1, most, part.size.height) ||
      !flag("corners", part.corners) || !flag("double", in_double) || !flag("truncated", truncated) ||
      !head.contains("made_from") || !head["made_from"].is_array())
    return false;
  const int edge = part.corners ? 1 : 0;
  if (part.size.width <= edge || part.size.height <= edge ||
      has_too_many_pixels({part.size.width - edge, part.size.height - edge}))
    return false;
  for (const nlohmann::json& pair : head["made_from"]) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) return false;
    part.made_from.emplace_back(pair[0].get<std::string>(), pair[1].get<std::string>());
  }
  part.encoding = truncated ? Encoding::truncated : Encoding::srgb;
  if (in_double)
    part.film = Film<double>(part.size);
  else
    part.film = Film<float>(part.size);
  return true;
}

tl::unexpected<Error> damaged(const std::string& path, const std::string& how) {
  return tl::unexpected(
      Error{path, 0, 0, "this part of a picture " + how, "render it once more: the same command, with this --part"});
}

}  // namespace

std::string part_path(const std::string& image, const Share& share) {
  return fmt::format("{}.part-{}-of-{}", image, share.part, share.of);
}

std::string checksum(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return fmt::format("{:08x}{:08x}", crc32_z(0, data, bytes.size()), adler32_z(1, data, bytes.size()));
}

Result<void> write_part(const std::string& path, const PicturePart& part) {
  std::string content = head_of(part);
  std::visit(
      [&]<class T>(const Film<T>& film) {
        Tiles(part.size).for_rows(part.share, [&](int row, int column, int columns) {
          content.append(reinterpret_cast<const char*>(&film.at(column, row)),
                         static_cast<std::size_t>(columns) * sizeof(Rgb<T>));
        });
      },
      part.film);
  uLongf packed_size = compressBound(static_cast<uLong>(content.size()));
  std::string packed(packed_size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &packed_size, reinterpret_cast<const Bytef*>(content.data()),
                static_cast<uLong>(content.size()), Z_BEST_SPEED) != Z_OK)
    return tl::unexpected(Error{path, 0, 0, "there is not enough memory to pack this part of a picture", ""});
  packed.resize(packed_size);
  return write_file_atomically(path, fmt::format("{}{}\n", first_words, content.size()) + packed);
}

Result<PicturePart> read_part(const std::string& path) {
  constexpr std::size_t most = max_head + static_cast<std::size_t>(max_image_pixels) * sizeof(Rgb<double>) * 2;
  const auto bytes = read_file(path, most);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string_view text(*bytes);
  const std::size_t line_end = text.find('\n');
  if (text.substr(0, first_words.size()) != first_words || line_end == std::string_view::npos)
    return tl::unexpected(Error{path, 0, 0, "this is no part of a picture that this version of Raywalk can read",
                                "raywalk render SCENE -o IMAGE --part 1/4 makes one"});
  const auto size = parse_seed(text.substr(first_words.size(), line_end - first_words.size()));
  const std::string_view packed = text.substr(line_end + 1);
  constexpr std::size_t best_ratio = 1032;  // of deflate: whoever claims more has changed it
  if (!size || *size > most || *size > packed.size() * best_ratio) return damaged(path, "has been changed");
  std::string content(static_cast<std::size_t>(*size), '\0');
  uLongf unpacked = static_cast<uLongf>(content.size());
  if (uncompress(reinterpret_cast<Bytef*>(content.data()), &unpacked, reinterpret_cast<const Bytef*>(packed.data()),
                 static_cast<uLong>(packed.size())) != Z_OK ||
      unpacked != content.size())
    return damaged(path, "has been cut off or changed");
  PicturePart part;
  const std::size_t head_end = content.find('\n');
  if (head_end == std::string::npos || !take_head(std::string_view(content).substr(0, head_end), part))
    return damaged(path, "has been changed");
  const bool whole = std::visit(
      [&]<class T>(Film<T>& film) {
        const char* from = content.data() + head_end + 1;
        if (content.size() - head_end - 1 != bytes_of<T>(part.size, part.share)) return false;
        Tiles(part.size).for_rows(part.share, [&](int row, int column, int columns) {
          for (int i = 0; i < columns; ++i, from += sizeof(Rgb<T>)) {
            T channels[3];
            static_assert(sizeof channels == sizeof(Rgb<T>));
            std::memcpy(channels, from, sizeof channels);
            film.set(column + i, row, {channels[0], channels[1], channels[2]});
          }
        });
        return true;
      },
      part.film);
  if (!whole) return damaged(path, "has been changed");
  return part;
}

}  // namespace raywalk
