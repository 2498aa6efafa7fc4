// Textures of glTF materials. Their v runs downward, so each copy is -1 high. Base colour, metal and roughness are
// three factors of what our materials state as kd, kr and the roughness of glass: where a texture has one of the last
// two, these are computed for each pixel.

#include "image/image_file.h"
#include "io/mesh_gltf.h"
#include "text/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace raywalk::detail {

namespace {

MapImage laid(const std::shared_ptr<const Image>& pixels, const ImageWraps& wraps) {
  return {"", 1, -1, pixels, wraps.u, wraps.v == wraps.u ? std::nullopt : std::optional(wraps.v)};
}

/// The pixel of an image at the place of that of an image of another size.
Rgbd at_place(const Image* image, int column, int row, const Image& of) {
  if (image == nullptr) return Rgbd(1.0);
  return Rgbd(image->at(static_cast<int>(std::int64_t{column} * image->width / of.width),
                        static_cast<int>(std::int64_t{row} * image->height / of.height)));
}

double within(double x) { return std::clamp(x, 0.0, 1.0); }

}  // namespace

// Of what is not read: whatever is wrong with it is no failure.
const Json* GltfMaps::named_by(const Json& object, const char* key, const char* list) const {
  const Json* index = GltfFile::find(object, key);
  if (index == nullptr || !index->is_number_unsigned()) return nullptr;
  const auto i = index->get<std::uint64_t>();
  return i < static_cast<std::uint64_t>(file_.size_of(list)) ? &file_.element(list, static_cast<std::int64_t>(i))
                                                             : nullptr;
}

std::optional<std::string> GltfMaps::bytes_of(const Json& image) const {
  if (const std::string uri = GltfFile::text_or_none(image, "uri"); !uri.empty()) {
    auto bytes = bytes_of_uri(uri, path_, "image");
    if (!bytes) return std::nullopt;
    return std::move(*bytes);
  }
  const Json* view = named_by(image, "bufferView", "bufferViews");
  const Json* index = view == nullptr ? nullptr : GltfFile::find(*view, "buffer");
  if (index == nullptr || !index->is_number_unsigned()) return std::nullopt;
  const auto buffer = index->get<std::uint64_t>();
  if (buffer >= file_.buffers.size()) return std::nullopt;
  const std::string& bytes = *file_.buffers[static_cast<std::size_t>(buffer)];
  const auto number = [&](const char* key) -> std::size_t {
    const Json* found = GltfFile::find(*view, key);
    return found != nullptr && found->is_number_unsigned() ? found->get<std::size_t>() : 0;
  };
  const std::size_t offset = number("byteOffset"), length = number("byteLength");
  if (offset > bytes.size() || length > bytes.size() - offset) return std::nullopt;
  return bytes.substr(offset, length);
}

ImageWraps GltfMaps::wraps_of(const Json& texture, const char* key) {
  const Json* sampler = named_by(texture, "sampler", "samplers");
  if (sampler == nullptr) return {};
  constexpr std::int64_t clamp_to_edge = 33071, mirrored_repeat = 33648, nearest = 9728;
  const auto is = [&](const char* of, std::int64_t code) {
    const Json* found = GltfFile::find(*sampler, of);
    return found != nullptr && found->is_number_integer() && found->get<std::int64_t>() == code;
  };
  if (is("magFilter", nearest) && laid_otherwise_.empty())
    laid_otherwise_ = fmt::format("that of a {} blends no pixels; here they are blended", key);
  const auto wrap = [&](const char* way) {
    return is(way, clamp_to_edge) ? ImageWrap::clamp : is(way, mirrored_repeat) ? ImageWrap::mirror : ImageWrap::repeat;
  };
  return {wrap("wrapS"), wrap("wrapT")};
}

auto GltfMaps::read(const Json* use, const char* key, bool is_colour) -> Texture {
  if (use == nullptr) return {};
  const Json* texture = named_by(*use, "index", "textures");
  const Json* image = texture == nullptr ? nullptr : named_by(*texture, "source", "images");
  const Json* on = GltfFile::find(*use, "texCoord");
  const bool is_first = on == nullptr || (on->is_number_unsigned() && on->get<std::uint64_t>() == 0);
  Pixels pixels;
  if (image != nullptr && is_first && GltfFile::find(*use, "extensions") == nullptr) {
    const auto [known, is_new] = images_.try_emplace({image, is_colour});
    if (is_new) {
      const auto bytes = bytes_of(*image);
      auto decoded = bytes ? decode_png_or_jpeg(*bytes, path_, is_colour ? ByteMeaning::colour : ByteMeaning::number)
                           : Result<Image>(tl::unexpected(Error{}));
      if (decoded) known->second = std::make_shared<const Image>(std::move(*decoded));
    }
    pixels = known->second;
  }
  if (!pixels && unread_.empty()) {
    std::string name = image == nullptr ? "" : GltfFile::text_or_none(*image, "uri");
    if (name.empty() || name.rfind("data:", 0) == 0)
      name = image == nullptr ? "" : GltfFile::text_or_none(*image, "name");
    unread_ = name.empty() ? key : std::string(key) + " " + name;
  }
  return pixels ? Texture{pixels, wraps_of(*texture, key)} : Texture{};
}

auto GltfMaps::worn(const Pixels& base, const Pixels& metal, const Factors& factors) -> const Worn& {
  const auto [known, is_new] = worn_.try_emplace({base, metal, factors});
  Worn& of = known->second;
  if (!is_new) return of;
  const Image& size = base && base->pixels.size() > metal->pixels.size() ? *base : *metal;
  const double through = factors.through, pictures = through > 0 ? 4 : 2;
  if (const auto large = why_too_large(
          {fmt::format("the maps of materials from {} x {} pixels", size.width, size.height),
           pictures * sizeof(Rgb<float>) * static_cast<double>(size.pixels.size()), "use smaller textures"},
          path_)) {
    file_.fail(large->message, large->hint);
    return of;
  }
  const auto made = [&](auto pixel) {
    Image image{size.width, size.height, {}};
    image.pixels.reserve(size.pixels.size());
    for (int row = 0; row < size.height; ++row)
      for (int column = 0; column < size.width; ++column) {
        const Rgbd own = at_place(metal.get(), column, row, size);
        const Rgbd tint = factors.base * at_place(base.get(), column, row, size);
        const double roughness = within(factors.roughness * own.y);
        image.pixels.emplace_back(pixel(tint, within(factors.metallic * own.z) * (1 - roughness), roughness));
      }
    return std::make_shared<const Image>(std::move(image));
  };
  const auto seen = [](const Pixels& of_colours) {
    const auto& pixels = of_colours->pixels;
    return std::all_of(pixels.begin(), pixels.end(), [](const auto& each) { return is_black(each); }) ? nullptr
                                                                                                      : of_colours;
  };
  const double opaque = 1 - through;
  of.mirrored = seen(made([&](const Rgbd& tint, double mirror, double) { return opaque * mirror * tint; }));
  of.matt = seen(made([&](const Rgbd& tint, double mirror, double) { return opaque * (1 - mirror) * tint; }));
  if (through == 0) return of;
  of.passed = seen(made([&](const Rgbd& tint, double, double) { return through * tint; }));
  of.rough = made([](const Rgbd&, double, double roughness) { return Rgbd(roughness * roughness); });
  return of;
}

std::string GltfMaps::add_to(Material& material, const Json& from, const Factors& factors) {
  unread_.clear();
  const Json none = Json::object();
  const Json* found = GltfFile::find(from, "pbrMetallicRoughness");
  const Json& pbr = found != nullptr ? *found : none;
  const Texture base = read(GltfFile::find(pbr, "baseColorTexture"), "baseColorTexture", true);
  const Texture metal = read(GltfFile::find(pbr, "metallicRoughnessTexture"), "metallicRoughnessTexture", false);
  const ImageWraps wraps = base ? base.wraps : metal.wraps;
  const auto map = [&](MappedParameter of, const Pixels& pixels) {
    material.maps.push_back({laid(pixels, wraps), of});
  };
  if (metal) {
    if (wraps != metal.wraps && laid_otherwise_.empty())
      laid_otherwise_ =
          "that of a metallicRoughnessTexture wraps otherwise than the baseColorTexture, like which it is laid here";
    const Worn& maps = worn(base.pixels, metal.pixels, factors);
    const auto take = [&](Rgbd& colour, MappedParameter of, const Pixels& pixels) {
      colour = Rgbd(pixels ? 1.0 : 0.0);
      if (pixels) map(of, pixels);
    };
    take(material.reflection, MappedParameter::reflection, maps.mirrored);
    take(material.diffuse, MappedParameter::diffuse, maps.matt);
    take(material.transmission, MappedParameter::transmission, maps.passed);
    if (maps.rough) {
      material.roughness = 1;
      map(MappedParameter::roughness, maps.rough);
    }
  } else if (base) {
    if (!is_black(material.diffuse)) map(MappedParameter::diffuse, base.pixels);
    if (!is_black(material.reflection)) map(MappedParameter::reflection, base.pixels);
    if (!is_black(material.transmission)) map(MappedParameter::transmission, base.pixels);
  }
  if (const Texture light = read(GltfFile::find(from, "emissiveTexture"), "emissiveTexture", true);
      light && !is_black(material.emission))
    material.maps.push_back({laid(light.pixels, light.wraps), MappedParameter::emission});
  const Json* use = GltfFile::find(from, "normalTexture");
  if (const Texture normals = read(use, "normalTexture", false)) {
    const Json* scale = GltfFile::find(*use, "scale");
    constexpr double most = 1e6;
    material.normal_map =
        NormalMap{laid(normals.pixels, normals.wraps),
                  scale != nullptr && scale->is_number() ? std::clamp(scale->get<double>(), 0.0, most) : 1};
  }
  if (const Json* occlusion = GltfFile::find(from, "occlusionTexture"); occlusion != nullptr && unread_.empty()) {
    const Json* texture = named_by(*occlusion, "index", "textures");
    const Json* image = texture == nullptr ? nullptr : named_by(*texture, "source", "images");
    const std::string name = image == nullptr ? "" : GltfFile::text_or_none(*image, "uri");
    unread_ = name.empty() ? "occlusionTexture" : "occlusionTexture " + name;
  }
  return unread_;
}

}  // namespace raywalk::detail
