#include "io/mesh_gltf.h"
#include "text/file.h"
#include "text/file_path.h"
#include "text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace raywalk::detail {

namespace {

/// The little-endian number of 4 bytes.
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

/// None if it contains anything else.
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

/// A value as shown in messages. Nested values are only named: they may be too deep to traverse.
std::string shown(const Json& value) {
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  if (value.is_string()) return "\"" + value.get_ref<const std::string&>().substr(0, 40) + "\"";
  return value.dump();
}

/// A SAX handler that finds where a text stops being JSON: the bytes read until then, including the faulty one.
struct JsonFault {
  std::size_t at = 0;

  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(Json::number_integer_t) { return true; }
  bool number_unsigned(Json::number_unsigned_t) { return true; }
  bool number_float(Json::number_float_t, const std::string&) { return true; }
  bool string(const std::string&) { return true; }
  bool binary(const Json::binary_t&) { return true; }
  bool start_object(std::size_t) { return true; }
  bool key(const std::string&) { return true; }
  bool end_object() { return true; }
  bool start_array(std::size_t) { return true; }
  bool end_array() { return true; }
  bool parse_error(std::size_t position, const std::string&, const Json::exception&) {
    at = position;
    return false;
  }
};

/// The error that `text`, at byte `begin` of the file, is not JSON; with the line, if it is a text file.
Error no_json(std::string_view text, std::size_t begin, const std::string& path) {
  JsonFault fault;
  static_cast<void>(Json::sax_parse(text, &fault));
  const std::string_view before = text.substr(0, fault.at == 0 ? 0 : fault.at - 1);
  Error error{path, 0, 0, "its JSON is not well formed", "is this a glTF 2.0 file, and whole?"};
  error.message += before.size() == text.size() ? ": it ends too early (expected its closing brackets)"
                                                : " (expected values with a comma between them, names in quotes)";
  if (begin > 0) {
    error.message += fmt::format(" at byte {}", begin + before.size());
    return error;
  }
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 in the first line
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  error.line = static_cast<int>(1 + std::count(before.begin(), before.end(), '\n'));
  error.column = static_cast<int>(
      1 + std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_begin), before.end(), begins_character));
  return error;
}

/// The line that contains a text in quotes; 0 if none or several do, or it is written differently.
int line_of(std::string_view text, const std::string& word) {
  const std::string quoted = '"' + word + '"';
  const std::size_t at = text.find(quoted);
  if (at == std::string_view::npos || text.find(quoted, at + 1) != std::string_view::npos) return 0;
  return static_cast<int>(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string read_uri(const GltfFile& file, const std::string& uri, const std::string& path) {
  auto bytes = bytes_of_uri(uri, path, "buffer");
  if (bytes) return std::move(*bytes);
  file.fail(bytes.error().message, bytes.error().hint);
  return "";
}

const Json& nothing() {
  static const Json null;
  return null;
}

}  // namespace
tl::expected<std::string, GltfFile::Failure> bytes_of_uri(const std::string& uri, const std::string& path,
                                                          const std::string& what) {
  const auto failure = [](std::string message, std::string hint) {
    return tl::unexpected(GltfFile::Failure{std::move(message), std::move(hint)});
  };
  if (uri.rfind("data:", 0) == 0) {
    const std::size_t comma = uri.find(";base64,");
    auto bytes = comma == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(comma + 8));
    if (!bytes)
      return failure("a data URI that is not base64 (expected data:...;base64,...)",
                     "export it with its " + what + " in a file");
    return std::move(*bytes);
  }
  const std::string name = from_percent(uri);
  if (!stays_beside(name))
    return failure("a " + what + " lies at \"" + uri.substr(0, 60) + "\" (expected a file beside the mesh)",
                   "nothing is read from elsewhere: copy the " + what + " into the mesh's folder");
  auto bytes = read_file(path_beside(path, name), max_mesh_bytes);
  if (bytes) return std::move(*bytes);
  return failure("its " + what + " \"" + name.substr(0, 60) + "\": " + bytes.error().message, bytes.error().hint);
}

const Json* GltfFile::find(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string GltfFile::text_or_none(const Json& object, const char* key) {
  const Json* found = find(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

void GltfFile::fail(std::string message, std::string hint) const {
  if (!failure_) failure_ = Failure{std::move(message), std::move(hint)};
}

void GltfFile::wrong(const Json& found, const char* key, const std::string& expected) const {
  fail(fmt::format("\"{}\": found {} (expected {})", key, shown(found), expected), "see the glTF 2.0 specification");
}

void GltfFile::fail_missing(const char* what, std::int64_t index, std::size_t size) const {
  fail(size == 0 ? fmt::format("it names number {} of \"{}\", but has none (expected a list of them)", index, what)
                 : fmt::format("it names number {} of \"{}\" (expected 0 to {})", index, what, size - 1),
       "the file is damaged");
}

double GltfFile::finite(const Json& number, const char* key) const {
  if (number.is_number() && std::isfinite(number.get<double>())) return number.get<double>();
  wrong(number, key, "a finite number");
  return 0;
}

std::int64_t GltfFile::index(const Json& number, const char* key) const {
  constexpr double most = 2147483647;
  const double value = finite(number, key);
  if (value >= 0 && value <= most && value == std::floor(value)) return static_cast<std::int64_t>(value);
  wrong(number, key, "a whole number, 0 or more");
  return -1;
}

std::int64_t GltfFile::whole(const Json& object, const char* key, std::int64_t otherwise) const {
  const Json* found = find(object, key);
  if (found == nullptr) return otherwise;
  const double value = finite(*found, key);
  if (value == std::floor(value) && std::abs(value) <= 4e9) return static_cast<std::int64_t>(value);
  wrong(*found, key, "a whole number, at most 4e9");
  return otherwise;
}

std::string GltfFile::text(const Json& object, const char* key) const {
  const Json* found = find(object, key);
  if (found != nullptr && found->is_string()) return found->get<std::string>();
  if (found != nullptr)
    wrong(*found, key, "a text");
  else
    fail(fmt::format("\"{}\" is missing (expected a text)", key), "see the glTF 2.0 specification");
  return "";
}

const Json& GltfFile::element(const char* list, std::int64_t index) const {
  const Json* found = find(json, list);
  if (found != nullptr && found->is_array() && index >= 0 && index < static_cast<std::int64_t>(found->size()))
    return (*found)[static_cast<std::size_t>(index)];
  fail_missing(list, index, found != nullptr && found->is_array() ? found->size() : 0);
  return nothing();
}

std::int64_t GltfFile::size_of(const char* list) const {
  const Json* found = find(json, list);
  return found == nullptr || !found->is_array() ? 0 : static_cast<std::int64_t>(found->size());
}

const std::string& GltfFile::buffer(std::int64_t index) const {
  static const std::string none;
  if (index >= 0 && index < static_cast<std::int64_t>(buffers.size())) return *buffers[static_cast<std::size_t>(index)];
  fail_missing("buffers", index, buffers.size());
  return none;
}

Result<GltfFile> open_gltf(std::string bytes, const std::string& path) {
  const auto fail = [&](const std::string& message) {
    return tl::unexpected(Error{path, 0, 0, message, "is this a glTF 2.0 file, and whole?"});
  };
  GltfFile file;
  if (bytes.empty()) return fail("the file is empty (expected a glTF 2.0 file)");
  constexpr std::string_view magic = "glTF";
  const bool is_binary = magic.starts_with(std::string_view(bytes).substr(0, magic.size()));
  // Some programs write text under this ending, too.
  if (!is_binary && ending_of(path) == ".glb" && bytes.find('\0') != std::string::npos)
    return fail("the file does not begin with \"glTF\" (expected a binary glTF 2.0 file)");
  if (const auto plain = is_binary ? Result<void>() : make_plain_text(bytes, path); !plain)
    return tl::unexpected(plain.error());
  std::string_view text = bytes, binary;
  std::size_t begin = 0;
  if (is_binary) {
    // A header of 12 bytes, then chunks: length, type, bytes. The first is the JSON.
    if (bytes.size() < 20)
      return fail(fmt::format("the file ends in its header (expected 20 bytes or more) at byte {}", bytes.size()));
    if (number_at(bytes, 4) != 2) return fail(fmt::format("version {} (expected 2) at byte 4", number_at(bytes, 4)));
    const std::size_t length = number_at(bytes, 12);
    if (bytes.substr(16, 4) != "JSON" || length > bytes.size() - 20)
      return fail("the JSON goes over the end of the file (expected a chunk of JSON that is whole) at byte 12");
    begin = 20;
    text = std::string_view(bytes).substr(begin, length);
    const std::size_t next = begin + length;
    if (bytes.size() - next >= 8) {
      const std::size_t size = number_at(bytes, next);
      if (size > bytes.size() - next - 8)
        return fail(fmt::format("a chunk goes over the end of the file (expected at most {} bytes) at byte {}",
                                bytes.size() - next - 8, next));
      binary = std::string_view(bytes).substr(next + 8, size);
    }
  }
  file.json = Json::parse(text, nullptr, false);
  if (file.json.is_discarded()) return tl::unexpected(no_json(text, begin, path));
  if (!file.json.is_object()) return fail(fmt::format("its JSON is {} (expected an object)", shown(file.json)));
  const Json* asset = GltfFile::find(file.json, "asset");
  const Json* version = asset == nullptr ? nullptr : GltfFile::find(*asset, "version");
  if (version == nullptr) return fail("it has no version (expected \"asset\": {\"version\": \"2.0\"})");
  if (!version->is_string() || version->get_ref<const std::string&>().rfind("2.", 0) != 0)
    return fail(fmt::format("its version is {} (expected \"2.0\")", shown(*version)));
  int line = 0;
  std::map<std::string, std::shared_ptr<const std::string>> read;  // each file once, however many buffers refer to it
  for (std::int64_t i = 0; i < file.size_of("buffers") && !file.failure(); ++i) {
    const Json& buffer = file.element("buffers", i);
    const bool is_own = i == 0 && GltfFile::find(buffer, "uri") == nullptr;
    const std::string uri = is_own ? "" : file.text(buffer, "uri");
    std::shared_ptr<const std::string>& one = read[uri.starts_with("data:") ? uri : one_name(path_beside(path, uri))];
    if (!one) one = std::make_shared<const std::string>(is_own ? std::string(binary) : read_uri(file, uri, path));
    file.buffers.push_back(one);
    if (file.failure() && begin == 0 && !uri.empty()) line = line_of(text, uri);
  }
  if (file.failure()) return tl::unexpected(Error{path, line, 0, file.failure()->message, file.failure()->hint});
  return file;
}

}  // namespace raywalk::detail
