#pragma once
// A parsed glTF file: its JSON, its buffers, and checked access to the members of the JSON. Internal to `io`.

#include "io/mesh_file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace raywalk::detail {

using Json = nlohmann::json;

/// If the file does not conform, its members note the first error and return something harmless.
class GltfFile {
 public:
  Json json;
  std::vector<std::shared_ptr<const std::string>> buffers;  ///< buffers of one file share its bytes

  /// A member, or null if absent.
  [[nodiscard]] static const Json* find(const Json& object, const char* key);
  /// Empty where there is none.
  [[nodiscard]] static std::string text_or_none(const Json& object, const char* key);
  [[nodiscard]] std::int64_t whole(const Json& object, const char* key, std::int64_t otherwise) const;
  [[nodiscard]] std::string text(const Json& object, const char* key) const;
  /// An index into the list `key`.
  [[nodiscard]] std::int64_t index(const Json& number, const char* key) const;
  /// An element of one of the top-level lists.
  [[nodiscard]] const Json& element(const char* list, std::int64_t index) const;
  [[nodiscard]] std::int64_t size_of(const char* list) const;
  [[nodiscard]] const std::string& buffer(std::int64_t index) const;

  /// Finite numbers: a list of them, or one by itself when Count is 1.
  template <std::size_t Count>
  [[nodiscard]] std::array<double, Count> numbers(const Json& object, const char* key,
                                                  std::array<double, Count> otherwise) const {
    const Json* found = find(object, key);
    if (found == nullptr) return otherwise;
    std::array<double, Count> result{};
    if (!(Count == 1 && found->is_number()) && !(found->is_array() && found->size() == Count)) {
      wrong(*found, key, Count == 1 ? "a number" : "a list of " + std::to_string(Count) + " numbers");
      return otherwise;
    }
    for (std::size_t i = 0; i < Count; ++i) result[i] = finite(found->is_array() ? (*found)[i] : *found, key);
    return result;
  }

  void fail(std::string message, std::string hint) const;
  struct Failure {
    std::string message, hint;
  };
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }

 private:
  void wrong(const Json& found, const char* key, const std::string& expected) const;
  void fail_missing(const char* what, std::int64_t index, std::size_t size) const;
  double finite(const Json& number, const char* key) const;

  mutable std::optional<Failure> failure_;
};

[[nodiscard]] Result<GltfFile> open_gltf(std::string bytes, const std::string& path);

/// The bytes of a URI: in the URI itself, or in a file beside the one at `path`. Nothing is downloaded. `what` it is
/// of, for messages.
[[nodiscard]] tl::expected<std::string, GltfFile::Failure> bytes_of_uri(const std::string& uri, const std::string& path,
                                                                        const std::string& what);

/// What the textures of materials make of these, as maps (io/mesh_gltf_maps.cpp).
class GltfMaps {
 public:
  GltfMaps(const GltfFile& file, std::string path) : file_(file), path_(std::move(path)) {}
  /// The factors of a material in glTF's own terms, linear and in 0..1.
  struct Factors {
    Rgbd base{1.0};
    double metallic = 1, roughness = 1, through = 0;

    friend bool operator<(const Factors& a, const Factors& b) {
      const auto all = [](const Factors& f) {
        return std::array{f.base.x, f.base.y, f.base.z, f.metallic, f.roughness, f.through};
      };
      return all(a) < all(b);
    }
  };
  /// Adds the maps of its textures to a material that is made of the factors alone. The name of the first texture that
  /// is not read, with its image's name if it has one; or "".
  std::string add_to(Material& material, const Json& from, const Factors& factors);
  /// What the first sampler asks for that a texture which is read does not do; or "".
  [[nodiscard]] const std::string& laid_otherwise() const { return laid_otherwise_; }

 private:
  using Pixels = std::shared_ptr<const Image>;
  /// A texture: an image, and how its sampler wraps it. Without pixels: none.
  struct Texture {
    Pixels pixels{};
    ImageWraps wraps{};
    explicit operator bool() const { return pixels != nullptr; }
  };
  /// What a texture of metal and roughness makes of a material's parameters; null for a colour that is black.
  struct Worn {
    Pixels mirrored, matt, passed, rough;
  };
  /// Made once for all materials of the same textures and factors.
  const Worn& worn(const Pixels& base, const Pixels& metal, const Factors& factors);
  /// A texture that lies on TEXCOORD_0 and can be read.
  Texture read(const Json* use, const char* key, bool is_colour);
  [[nodiscard]] const Json* named_by(const Json& object, const char* key, const char* list) const;
  [[nodiscard]] std::optional<std::string> bytes_of(const Json& image) const;
  [[nodiscard]] ImageWraps wraps_of(const Json& texture, const char* key);

  const GltfFile& file_;
  std::string path_;
  std::map<std::pair<const Json*, bool>, Pixels> images_;
  std::map<std::tuple<Pixels, Pixels, Factors>, Worn> worn_;
  std::string unread_, laid_otherwise_;
};

}  // namespace raywalk::detail
