#include "trace/surface_maps.h"

#include "trace/lobe_width.h"
#include "trace/texture.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// The least and the most of a channel.
std::pair<float, float> range_of(const Image& image, int channel) {
  float least = image.pixels.front()[channel], most = least;
  for (const Rgb<float>& pixel : image.pixels)
    least = std::min(least, pixel[channel]), most = std::max(most, pixel[channel]);
  return {least, most};
}

constexpr int matt_steps = 1024;  // so close that no step is seen

}  // namespace

template <class T>
SurfaceMaps<T>::Image::Image(const MapImage& from, MapChannel from_channel)
    : pixels(from.pixels),
      width(static_cast<T>(from.width)),
      height(static_cast<T>(from.height)),
      channel(static_cast<int>(from_channel)),
      wraps(from.wraps()) {
  // A mirrored one runs from its far edge to 0; where it repeats, that is the same.
  if (width < 0 && wraps.u != ImageWrap::repeat) first.x = -1;
  if (height < 0 && wraps.v != ImageWrap::repeat) first.y = -1;
}

template <class T>
Rgb<T> SurfaceMaps<T>::Image::colour(const Vec2<T>& uv) const {
  return texture_colour<T>(*pixels, uv.x / width - first.x, uv.y / height - first.y, wraps);
}

template <class T>
auto SurfaceMaps<T>::layer_of(const Material& material, const SurfaceValues<T>& values, bool has_lobes) -> Layer {
  Layer layer{{values, static_cast<T>(material.roughness), static_cast<T>(material.diffuse_roughness)},
              has_lobes ? material.gloss : 0,
              has_lobes ? material.translucency : 0,
              {}};
  for (const ParameterMap& map : material.maps)
    if (map.pixels) layer.maps.push_back({Image(map, map.channel), map.of});
  return layer;
}

template <class T>
SurfaceMaps<T>::SurfaceMaps(const Material& material, const SurfaceValues<T>& first, const SurfaceValues<T>& second,
                            bool has_lobes, bool bends) {
  if (!material.is_mapped()) return;
  layers_.push_back(layer_of(material, first, has_lobes));
  if (material.mask && (material.mask->pixels || material.mask->squares)) {
    layers_.push_back(layer_of(second_of(material), second, has_lobes));
    if (material.mask->squares)
      squares_ = static_cast<T>(*material.mask->squares);
    else
      mask_ = Image(*material.mask, material.mask->channel);
  }
  for (const Layer& layer : layers_)
    maps_emission_ = maps_emission_ || layers_.size() > 1 ||
                     std::any_of(layer.maps.begin(), layer.maps.end(),
                                 [](const Map& map) { return map.of == MappedParameter::emission; });
  if (bends && material.normal_map) {
    normal_map_ = Image(*material.normal_map);
    strength_ = static_cast<T>(material.normal_map->strength);
  }
  if (bends && material.bump_map) {
    bump_map_ = Image(*material.bump_map, material.bump_map->channel);
    relief_ = static_cast<T>(material.bump_map->relief);
  }
  prepare_roughness(material);
  for (const Layer& layer : layers_) matts_.emplace_back(layer.own.diffuse_roughness);
  if (material.is_rough_diffuse())
    for (int i = 0; i <= matt_steps; ++i) matts_.emplace_back(static_cast<T>(i) / matt_steps);
}

/// Tables at even steps of the root of alpha, which is how the eye sees roughness, and at the ends of what there is, so
/// that these are exact.
template <class T>
void SurfaceMaps<T>::prepare_roughness(const Material& material) {
  T least = 1, most = 0;
  for (const Layer& layer : layers_) {
    T low = layer.own.roughness, high = low;
    for (const Map& map : layer.maps) {
      if (map.of != MappedParameter::roughness) continue;
      const auto [from, to] = range_of(*map.pixels, map.channel);
      low *= static_cast<T>(from), high *= static_cast<T>(to);
    }
    least = std::min({least, low, T(1)}), most = std::max(most, std::min(high, T(1)));
  }
  Material at_level = material;
  at_level.mask.reset();
  at_level.reflection = Rgbd(material.reflects() ? 1.0 : 0.0);
  if (at_level.is_metal()) {
    at_level.roughness = 0;
    smooth_.emplace_back(at_level);
  }
  if (!material.is_rough() || !(most > 0)) return;
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i)
    levels_.push_back(std::max(static_cast<T>(i * i) / (steps * steps), Ggx<T>::narrowest));
  std::erase_if(levels_, [&](T level) { return !(least < level && level < most); });
  for (const T end : {least, most})
    if (end > 0) levels_.push_back(end);
  for (const Layer& layer : layers_)
    if (least < layer.own.roughness && layer.own.roughness < most) levels_.push_back(layer.own.roughness);
  if (!(least > 0) && !(most < Ggx<T>::narrowest)) levels_.push_back(Ggx<T>::narrowest);
  std::sort(levels_.begin(), levels_.end());
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  for (const T level : levels_) {
    at_level.roughness = static_cast<double>(level);
    mirrors_.emplace_back(at_level);
  }
}

template <class T>
void SurfaceMaps<T>::prepare_glass(T ior, const std::vector<T>& others) {
  for (const T level : levels_) {
    auto& of_level = glasses_.emplace_back();
    for (const T other : others)
      if (RoughDielectric<T>::bends(ior, other)) of_level.push_back(rough_dielectric_of(level, ior, other));
  }
}

template <class T>
auto SurfaceMaps<T>::Layer::at(const Vec2<T>& uv) const -> MappedValues<T> {
  MappedValues<T> values = own;
  for (const Map& map : maps) switch (map.of) {
      case MappedParameter::ambient:
        values.ambient *= map.colour(uv);
        break;
      case MappedParameter::diffuse:
        values.diffuse *= map.colour(uv);
        break;
      case MappedParameter::diffuse_roughness:
        values.diffuse_roughness = std::min(values.diffuse_roughness * map.number(uv), T(1));
        break;
      case MappedParameter::specular:
        values.specular *= map.colour(uv);
        break;
      case MappedParameter::shininess:
        values.shininess *= map.number(uv);
        break;
      case MappedParameter::reflection:
        values.reflection *= map.colour(uv);
        break;
      case MappedParameter::transmission:
        values.transmission *= map.colour(uv);
        break;
      case MappedParameter::roughness:
        values.roughness = std::min(values.roughness * map.number(uv), T(1));
        break;
      case MappedParameter::gloss:
        values.gloss = lobe_width<T>(std::min(gloss * static_cast<double>(map.number(uv)), 90.0));
        break;
      case MappedParameter::translucency:
        values.translucency = lobe_width<T>(std::min(translucency * static_cast<double>(map.number(uv)), 90.0));
        break;
      case MappedParameter::emission:
        values.emission *= map.colour(uv);
        break;
    }
  return values;
}

template <class T>
auto SurfaceMaps<T>::at(const Vec2<T>& uv) const -> Mixture {
  Mixture mixture{layers_.front().at(uv), {}, 0};
  if (layers_.size() < 2) return mixture;
  mixture.second = layers_.back().at(uv);
  mixture.share = squares_ > 0 ? static_cast<T>(!even_square(uv, squares_)) : std::min(mask_.number(uv), T(1));
  return mixture;
}

template <class T>
MappedValues<T> SurfaceMaps<T>::mixed(const Mixture& mixture) {
  const T t = mixture.share;
  if (!(t > 0)) return mixture.first;
  if (t == 1) return mixture.second;
  const MappedValues<T>&a = mixture.first, &b = mixture.second;
  MappedValues<T> values;
  values.ambient = a.ambient + t * (b.ambient - a.ambient);
  values.diffuse = a.diffuse + t * (b.diffuse - a.diffuse);
  values.specular = a.specular + t * (b.specular - a.specular);
  values.reflection = a.reflection + t * (b.reflection - a.reflection);
  values.transmission = a.transmission + t * (b.transmission - a.transmission);
  values.emission = a.emission + t * (b.emission - a.emission);
  values.shininess = a.shininess + t * (b.shininess - a.shininess);
  values.gloss = a.gloss + t * (b.gloss - a.gloss);
  values.translucency = a.translucency + t * (b.translucency - a.translucency);
  values.roughness = a.roughness + t * (b.roughness - a.roughness);
  values.diffuse_roughness = a.diffuse_roughness + t * (b.diffuse_roughness - a.diffuse_roughness);
  return values;
}

template <class T>
MappedFacets<T> SurfaceMaps<T>::facets(const MappedValues<T>& at, const Refraction<T>* through) const {
  MappedFacets<T> found;
  if (levels_.empty() || !(at.roughness > 0)) {
    found.mirror = smooth_.empty() ? nullptr : &smooth_.front();
    return found;
  }
  const auto above = std::lower_bound(levels_.begin(), levels_.end(), at.roughness);
  const auto last = levels_.size() - 1;
  const auto next = std::min(static_cast<std::size_t>(above - levels_.begin()), last);
  const bool alone = next == 0 || at.roughness >= levels_[next];
  const std::size_t low = alone ? next : next - 1;
  if (!alone) found.share = (at.roughness - levels_[low]) / (levels_[next] - levels_[low]);
  if (glasses_.empty() || through == nullptr) {
    found.mirror = &mirrors_[low];
    if (!alone) found.rougher = &mirrors_[next];
    return found;
  }
  const auto between = [&](std::size_t level) -> const RoughDielectric<T>* {
    for (const auto& one : glasses_[level])
      if (one->is_between(through->n1, through->n2)) return one.get();
    return nullptr;
  };
  found.glass = between(low);
  if (!alone) found.rougher_glass = between(next);
  return found;
}

template <class T>
const RoughDiffuse<T>* SurfaceMaps<T>::matt(const MappedValues<T>& at) const {
  if (!(at.diffuse_roughness > 0)) return nullptr;
  for (std::size_t i = 0; i < layers_.size(); ++i)
    if (at.diffuse_roughness == layers_[i].own.diffuse_roughness) return &matts_[i];
  if (matts_.size() == layers_.size()) return nullptr;
  const auto step = static_cast<std::size_t>(std::min(at.diffuse_roughness, T(1)) * matt_steps + T(0.5));
  return &matts_[layers_.size() + step];
}

template <class T>
Vec3<T> SurfaceMaps<T>::bent(const Primitives<T>& primitives, int primitive, const SurfacePoint<T>& point, int part,
                             T time, const Vec3<T>& normal) const {
  const Vec2<T> uv = primitives.uv_at(primitive, point, part, time);
  const Basis<T> along(point.normal);
  const Vec2<T> by_s = primitives.uv_derivative(primitive, point, part, time, along.s),
                by_t = primitives.uv_derivative(primitive, point, part, time, along.t);
  Vec3<T> bent = normal;
  if (normal_map_.pixels) {
    const T area = by_s.x * by_t.y - by_t.x * by_s.y;
    // Where the image lies mirrored, so do its axes.
    const T right = std::copysign(T(1), normal_map_.width * area), up = std::copysign(T(1), normal_map_.height * area);
    const Vec3<T> by_u = right * (by_t.y * along.s - by_s.y * along.t),
                  by_v = up * (by_s.x * along.t - by_t.x * along.s);
    const Vec3<T> x = by_u - dot(by_u, normal) * normal;
    const T size = length(x);
    if (area != 0 && std::isfinite(size) && size > 0) {
      const Vec3<T> tangent = x / size, across = cross(normal, tangent);
      const Rgb<T> c = normal_map_.colour(uv);
      const T bend_x = strength_ * (2 * c.x - 1), bend_y = strength_ * (2 * c.y - 1);
      const Vec3<T> leaning =
          bend_x * tangent + (dot(across, by_v) < 0 ? -bend_y : bend_y) * across + (2 * c.z - 1) * normal;
      const T far = length(leaning);
      if (far > 0) bent = leaning / far;
    }
  }
  if (bump_map_.pixels) {
    // The slope of the height between half a pixel on either side, which changes without steps.
    const T du = bump_map_.width / static_cast<T>(2 * bump_map_.pixels->width),
            dv = bump_map_.height / static_cast<T>(2 * bump_map_.pixels->height);
    const auto slope = [&](const Vec2<T>& half) {
      return relief_ * (bump_map_.number(uv + half) - bump_map_.number(uv - half)) / (2 * (half.x + half.y));
    };
    const T h_u = slope({du, 0}), h_v = slope({0, dv});
    const Vec3<T> gradient = (h_u * by_s.x + h_v * by_s.y) * along.s + (h_u * by_t.x + h_v * by_t.y) * along.t;
    const Vec3<T> leaning = bent - gradient;
    const T far = length(leaning);
    if (std::isfinite(far) && far > 0) bent = leaning / far;
  }
  return bent;
}

template class SurfaceMaps<float>;
template class SurfaceMaps<double>;

}  // namespace raywalk
