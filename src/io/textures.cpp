#include "io/textures.h"

#include "image/image_file.h"
#include "io/mesh_file.h"
#include "text/file.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

constexpr std::size_t max_bytes = std::size_t{256} << 20;

/// Why numbers in floats are no map; empty where they are.
std::string why_no_map(const Image& image) {
  constexpr float most = 1e6F;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const float value = image.pixels[i][channel];
      if (value >= 0 && value <= most) continue;
      const auto width = static_cast<std::size_t>(image.width);
      return fmt::format("pixel ({}, {}), from the top left, is {} (expected numbers from 0 to {:g})", i % width,
                         i / width, value, most);
    }
  return {};
}

/// Loads the pixels of textures; each file is decoded once, whatever its names.
class Loader {
 public:
  explicit Loader(std::string folder) : folder_(std::move(folder)) {}

  Result<void> load(std::vector<Object>& objects) {
    for (Object& object : objects) {
      if (object.material.texture) {
        const auto pixels = pixels_of(object, object.material.texture->file, Use::texture);
        if (!pixels) return tl::unexpected(pixels.error());
        object.material.texture->pixels = *pixels;
      }
      std::optional<Error> failure;
      each_map(object.material, [&](MapImage& map, bool colour) {
        if (failure || map.file.empty()) return;
        auto pixels = pixels_of(object, map.file, colour ? Use::map_of_colours : Use::map_of_numbers);
        if (pixels)
          map.pixels = *pixels;
        else
          failure = pixels.error();
      });
      if (failure) return tl::unexpected(*failure);
      if (auto* instance = std::get_if<Instance>(&object.shape); instance && instance->content) {
        const auto content = loaded(instance->content);
        if (!content) return tl::unexpected(content.error());
        instance->content = *content;
      }
    }
    return {};
  }

 private:
  using Pixels = std::shared_ptr<const Image>;
  using Content = std::shared_ptr<const GroupContent>;

  enum class Use { texture, map_of_colours, map_of_numbers };

  static Result<Image> decoded_for(Use use, const std::string& bytes, const std::string& path) {
    if (use == Use::texture) return decode_png_or_jpeg(bytes, path);
    auto map = decode_map(bytes, path, use == Use::map_of_colours ? ByteMeaning::colour : ByteMeaning::number);
    if (!map) return map;
    if (const std::string why = why_no_map(*map); !why.empty())
      return tl::unexpected(Error{path, 0, 0, why, "paint it over, or write it again"});
    return map;
  }

  Result<Pixels> pixels_of(const Object& object, const std::string& file, Use use) {
    const std::string path = (std::filesystem::path(folder_) / file).string();
    Pixels& pixels = pixels_[{detail::one_name(path), use}];
    if (pixels) return pixels;
    const auto bytes = read_file(path, max_bytes);
    auto decoded = bytes ? decoded_for(use, *bytes, path) : tl::unexpected(bytes.error());
    if (!decoded) {
      Error error = decoded.error();
      error.hint = fmt::format("it is {} of \"{}\", looked for from the scene's folder; {}",
                               use == Use::texture ? "the texture" : "a map", object.name, error.hint);
      return tl::unexpected(error);
    }
    return pixels = std::make_shared<const Image>(std::move(*decoded));
  }

  /// A group's shared content, with its textures loaded; unchanged if it has none.
  Result<Content> loaded(const Content& content) {
    if (const auto known = contents_.find(content); known != contents_.end()) return known->second;
    Group group = content->group;
    if (const auto inside = load(group.objects); !inside) return tl::unexpected(inside.error());
    const auto differs = [](const Object& now, const Object& before) {
      const auto* instance = std::get_if<Instance>(&now.shape);
      return now.material.texture || now.material.is_mapped() ||
             (instance && instance->content != std::get<Instance>(before.shape).content);
    };
    bool same = true;
    for (std::size_t i = 0; i < group.objects.size(); ++i)
      same = same && !differs(group.objects[i], content->group.objects[i]);
    return contents_[content] = same ? content : std::make_shared<const GroupContent>(std::move(group));
  }

  std::string folder_;
  std::map<std::pair<std::string, Use>, Pixels> pixels_;  ///< by file
  std::map<Content, Content> contents_;
};

Result<void> load_sky(Sky& sky, const std::string& folder) {
  auto* image = std::get_if<ImageSky>(&sky.kind);
  if (image == nullptr) return {};
  const std::string path = (std::filesystem::path(folder) / image->file).string();
  auto picture = read_image(path);
  if (!picture) {
    Error error = picture.error();
    error.hint = fmt::format("it is the picture of the sky, looked for from the scene's folder; {}", error.hint);
    return tl::unexpected(error);
  }
  if (const auto why = why_no_sky(*picture)) return tl::unexpected(Error{path, 0, 0, why->first, why->second});
  image->pixels = std::make_shared<const Image>(std::move(*picture));
  return {};
}

}  // namespace

Result<void> load_textures(Scene& scene, const std::string& folder) {
  if (scene.sky)
    if (const auto loaded = load_sky(*scene.sky, folder); !loaded) return loaded;
  Loader loader(folder);
  for (Group& group : scene.groups)
    if (const auto loaded = loader.load(group.objects); !loaded) return loaded;
  return loader.load(scene.objects);
}

}  // namespace raywalk
