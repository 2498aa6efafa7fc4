#pragma once
// Values as bytes, for messages between programs of the same build (gui/workers.h).

#include "image/image_file.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace raywalk {

class Packer {
 public:
  template <class Value>
    requires std::is_trivially_copyable_v<Value>
  void put(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::string_view text) {
    put(text.size());
    bytes_.append(text);
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    // GLM's vectors are not trivially copyable, though their bytes are.
    static_assert(std::is_standard_layout_v<Value>);
    put(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)));
  }
  void put(const Image& image) {
    put(image.width);
    put(image.height);
    put(image.pixels);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// What is missing is 0.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

  template <class Value>
    requires std::is_trivially_copyable_v<Value>
  [[nodiscard]] Value take() {
    Value value{};
    const std::size_t size = std::min(sizeof value, bytes_.size());
    std::memcpy(&value, bytes_.data(), size);
    bytes_.remove_prefix(size);
    return value;
  }
  [[nodiscard]] std::string_view take_text() {
    const auto size = std::min(take<std::size_t>(), bytes_.size());
    const std::string_view text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return text;
  }
  template <class Value>
  [[nodiscard]] std::vector<Value> take_all() {
    const std::string_view bytes = take_text();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(Value));
    return values;
  }
  [[nodiscard]] Image take_image() {
    Image image;
    image.width = take<int>();
    image.height = take<int>();
    image.pixels = take_all<Rgb<float>>();
    return image;
  }

 private:
  std::string_view bytes_;
};

}  // namespace raywalk
