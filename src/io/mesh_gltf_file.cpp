#include "io/file.h"
#include "io/mesh_gltf.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace raywalk::detail {

namespace {

/// The number of 4 bytes, the lowest first.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

/// None when there is anything else in it.
std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int digit = base64_digit(c);
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

std::string from_percent(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      text += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The bytes that a buffer's URI stands for: in the URI itself, or in a file beside this one. Nothing is fetched.
std::string bytes_of(const GltfFile& file, const std::string& uri, const std::string& path) {
  if (uri.rfind("data:", 0) == 0) {
    const std::size_t comma = uri.find(";base64,");
    const auto bytes = comma == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(comma + 8));
    if (!bytes) file.fail("a data URI that is not base64", "export it with its buffer in a file");
    return bytes.value_or("");
  }
  const std::string name = from_percent(uri);
  if (name.empty() || name.front() == '/' || name.front() == '\\' || name.find(':') != std::string::npos ||
      name.find('\0') != std::string::npos) {
    file.fail("a buffer lies at \"" + uri.substr(0, 60) + "\" (expected a file beside the mesh)",
              "nothing is fetched from elsewhere");
    return "";
  }
  auto bytes = read_file(path_beside(path, name), most_mesh_bytes);
  if (bytes) return std::move(*bytes);
  file.fail("its buffer \"" + name.substr(0, 60) + "\": " + bytes.error().message, bytes.error().hint);
  return "";
}

const Json& nothing() {
  static const Json null;
  return null;
}

}  // namespace

const Json* GltfFile::find(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

void GltfFile::fail(std::string message, std::string hint) const {
  if (!failure_) failure_ = Failure{std::move(message), std::move(hint)};
}

void GltfFile::wrong(const char* key) const {
  fail(fmt::format("\"{}\" is not what it should be", key), "see the glTF 2.0 specification");
}

double GltfFile::finite(const Json& number, const char* key) const {
  if (number.is_number() && std::isfinite(number.get<double>())) return number.get<double>();
  wrong(key);
  return 0;
}

std::int64_t GltfFile::index(const Json& number) const {
  constexpr double most = 2147483647;
  const double value = finite(number, "index");
  if (value >= 0 && value <= most && value == std::floor(value)) return static_cast<std::int64_t>(value);
  wrong("index");
  return -1;
}

std::int64_t GltfFile::whole(const Json& object, const char* key, std::int64_t otherwise) const {
  const Json* found = find(object, key);
  if (found == nullptr) return otherwise;
  const double value = finite(*found, key);
  if (value == std::floor(value) && std::abs(value) <= 4e9) return static_cast<std::int64_t>(value);
  wrong(key);
  return otherwise;
}

std::string GltfFile::text(const Json& object, const char* key) const {
  const Json* found = find(object, key);
  if (found != nullptr && found->is_string()) return found->get<std::string>();
  wrong(key);
  return "";
}

const Json& GltfFile::element(const char* list, std::int64_t index) const {
  const Json* found = find(json, list);
  if (found != nullptr && found->is_array() && index >= 0 && index < static_cast<std::int64_t>(found->size()))
    return (*found)[static_cast<std::size_t>(index)];
  fail(fmt::format("it names number {} of \"{}\", which is not there", index, list), "the file is damaged");
  return nothing();
}

std::int64_t GltfFile::size_of(const char* list) const {
  const Json* found = find(json, list);
  return found == nullptr || !found->is_array() ? 0 : static_cast<std::int64_t>(found->size());
}

const std::string& GltfFile::buffer(std::int64_t index) const {
  static const std::string none;
  if (index >= 0 && index < static_cast<std::int64_t>(buffers.size())) return buffers[static_cast<std::size_t>(index)];
  fail(fmt::format("it names buffer {}, which is not there", index), "the file is damaged");
  return none;
}

Result<GltfFile> open_gltf(const std::string& bytes, const std::string& path) {
  const auto fail = [&](const std::string& message) {
    return tl::unexpected(Error{path, 0, 0, message, "is this a glTF 2.0 file, and whole?"});
  };
  GltfFile file;
  std::string_view text = bytes, binary;
  if (bytes.rfind("glTF", 0) == 0) {
    // A header of 12 bytes, then chunks: length, type, bytes. The first is the JSON.
    if (bytes.size() < 20) return fail("the file ends in its header at byte " + std::to_string(bytes.size()));
    if (number_at(bytes, 4) != 2) return fail(fmt::format("version {} (expected 2) at byte 4", number_at(bytes, 4)));
    const std::uint64_t length = number_at(bytes, 12);
    if (bytes.substr(16, 4) != "JSON" || length > bytes.size() - 20)
      return fail("the JSON goes over the end of the file at byte 12");
    text = std::string_view(bytes).substr(20, length);
    const std::size_t next = 20 + length;
    if (bytes.size() - next >= 8) {
      const std::uint64_t size = number_at(bytes, next);
      if (size > bytes.size() - next - 8)
        return fail(fmt::format("a chunk goes over the end of the file at byte {}", next));
      binary = std::string_view(bytes).substr(next + 8, size);
    }
  }
  file.json = Json::parse(text, nullptr, false);
  if (file.json.is_discarded() || !file.json.is_object()) return fail("its JSON is not well formed");
  const Json* asset = GltfFile::find(file.json, "asset");
  if (asset == nullptr || file.text(*asset, "version").rfind("2.", 0) != 0) return fail("its version is not 2");
  for (std::int64_t i = 0; i < file.size_of("buffers") && !file.failure(); ++i) {
    const Json& buffer = file.element("buffers", i);
    const bool is_own = i == 0 && GltfFile::find(buffer, "uri") == nullptr;
    file.buffers.push_back(is_own ? std::string(binary) : bytes_of(file, file.text(buffer, "uri"), path));
  }
  if (file.failure()) return tl::unexpected(Error{path, 0, 0, file.failure()->message, file.failure()->hint});
  return file;
}

}  // namespace raywalk::detail
