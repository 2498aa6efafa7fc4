#pragma once
// What the statements of trace/radiosity.h do. Included by it alone.

#include "trace/flat_ray.h"
#include "trace/radiosity.h"
#include "trace/representable.h"
#include "trace/tracer.h"

namespace raywalk {

template <class Policy>
double RadiosityTracer<Policy>::power_of(int patch) const {
  const Rgbd& unshot = state_.lights[static_cast<std::size_t>(patch)].unshot;
  return patches_[patch].area * (unshot.x + unshot.y + unshot.z);
}

template <class Policy>
void RadiosityTracer<Policy>::cut_patches() {
  if (!shooting_) return;
  state_.lights.assign(static_cast<std::size_t>(patches_.size()), {});
  note(Line::cut_patches, [&] { return PatchesMade{patches_.size(), patches_.is_flat()}; });
}

/// What they emit, and what they send on of the light of lamps.
template <class Policy>
void RadiosityTracer<Policy>::light_patches() {
  if (!shooting_) return;
  const auto light = [&](int patch) {
    if (stop_.asked()) return;
    PatchLight& own = light_of(patch);
    own.irradiance = patches_.light_of_lamps(patch);
    own.unshot = patches_[patch].emission + patches_[patch].reflectance * own.irradiance;
  };
  for_all(shooting_->run_all, patches_.size(), light);
  stop_.check();
  for (int patch = 0; patch < patches_.size(); ++patch) state_.first += power_of(patch);
  state_.unshot = state_.first;
  note(Line::light_patches, [&] {
    Rgbd unshot(0.0);
    for (int patch = 0; patch < patches_.size(); ++patch) unshot += patches_[patch].area * light_of(patch).unshot;
    return PatchesMade{patches_.size(), patches_.is_flat(), unshot,
                       std::make_shared<const std::vector<PatchLight>>(state_.lights)};
  });
}

template <class Policy>
bool RadiosityTracer<Policy>::there_is_unshot_light() {
  if (!shooting_) return false;
  const bool holds = state_.unshot > 0 && state_.share() > settings_.tolerance && state_.shots < settings_.shots;
  if (!holds && shot_together_ > 0)
    note(Line::shoot_light, [&] {
      return PatchShot{first_together_, patches_[first_together_].object, shot_together_, state_.share(),
                       std::make_shared<const std::vector<PatchLight>>(state_.lights)};
    });
  if (announces() || !holds)
    note(Line::while_unshot_light,
         [&] { return UnshotLight{holds, state_.shots, state_.share(), settings_.tolerance}; });
  return holds;
}

/// Of equal ones the first.
template <class Policy>
int RadiosityTracer<Policy>::take_patch() {
  stop_.check();
  int most = 0;
  double power = -1;
  for (int patch = 0; patch < patches_.size(); ++patch)
    if (const double own = power_of(patch); own > power) power = own, most = patch;
  if (announces())
    note(Line::take_patch,
         [&] { return PatchTaken{most, patches_[most].object, light_of(most).unshot, power / state_.unshot}; });
  return most;
}

template <class Policy>
int RadiosityTracer<Policy>::call(int patch) {
  if (walks()) note(Line::shoot_light, [&] { return PatchShot{patch, patches_[patch].object, 0, state_.share()}; });
  return patch;
}

template <class Policy>
const std::vector<FormFactors::Entry>& RadiosityTracer<Policy>::row_of(int patch) {
  return factors_.row(patch, shooting_->run_all, stop_);
}

template <class Policy>
void RadiosityTracer<Policy>::begin(const FormFactors::Entry& other) {
  if (walks()) note(Line::for_each_patch, [&] { return PatchInFront{other.other, patches_[other.other].object}; });
}

/// The share of the light of `patch` that arrives at the other one.
template <class Policy>
double RadiosityTracer<Policy>::compute_form_factor(int patch, const FormFactors::Entry& other) {
  if (walks())
    note(Line::compute_form_factor, [&] {
      const Exchange exchange = patches_.exchange(patch, other.other);
      const Patch& from = patches_[patch];
      FormFactorFound found{patch, other.other, patches_[other.other].object};
      if (patches_.is_flat()) {
        const Strings strings = strings_between(from.edge(), patches_[other.other].edge());
        found.from_a = strings.first.a, found.from_b = strings.first.b;
        found.to_a = strings.second.a, found.to_b = strings.second.b;
        found.crossed = strings.crossed, found.uncrossed = strings.uncrossed;
      }
      found.length = from.area;
      found.factor = exchange.area / from.area;
      found.visible = exchange.visible;
      return found;
    });
  return other.exchange / patches_[patch].area;
}

template <class Policy>
void RadiosityTracer<Policy>::add_what_arrives(int patch, int other, double factor) {
  const Patch& receiver = patches_[other];
  const Rgbd arrived = patches_[patch].area * factor / receiver.area * light_of(patch).unshot;
  PatchLight& light = light_of(other);
  light.irradiance += arrived;
  light.unshot += receiver.reflectance * arrived;
  if (walks())
    note(Line::add_what_arrives,
         [&] { return LightArrived{other, receiver.object, arrived, receiver.reflectance, light}; });
}

template <class Policy>
void RadiosityTracer<Policy>::forget_unshot_light(int patch) {
  light_of(patch).unshot = Rgbd(0.0);
  state_.unshot = 0;
  for (int each = 0; each < patches_.size(); ++each) state_.unshot += power_of(each);
  const bool walked = walks(), shown = shows();
  ++state_.shots;
  if (walked)
    note(Line::forget_unshot_light,
         [&] { return PatchEmptied{patch, patches_[patch].object, light_of(patch), state_.share()}; });
  else if (shown)
    note(Line::shoot_light, [&] {
      return PatchShot{patch, patches_[patch].object, 0, state_.share(),
                       std::make_shared<const std::vector<PatchLight>>(state_.lights)};
    });
  else if (shot_together_++ == 0)
    first_together_ = patch;
  if (shooting_->shot) shooting_->shot(state_.share());
}

template <class Policy>
void RadiosityTracer<Policy>::begin(const Pixel& pixel) {
  stop_.check();
  note(Line::radiosity_for_each_pixel, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

template <class Policy>
auto RadiosityTracer<Policy>::form_primary_ray(const Pixel& pixel) -> EyeRay {
  raywalk::Ray<T> ray = camera_.primary_ray(pixel, pixel_draws_, statistics_);
  if (settings_.patches.flat) ray = flattened(ray);
  const EyeRay primary{Ray{ray}, Rgb<T>(1), 1, rays_formed_++};
  differential_.begin(primary.ray.direction);
  ++statistics_.formed(RayKind::primary);
  note(Line::radiosity_form_primary_ray, [&] {
    return RayFormed{primary.number, -1, RayKind::primary, Vec3d(primary.ray.origin), Vec3d(primary.ray.direction),
                     Rgbd(1.0)};
  });
  return primary;
}

template <class Policy>
auto RadiosityTracer<Policy>::find_closest(const EyeRay& ray) -> Nearest {
  const Nearest nearest = world_.accelerator.closest(ray.ray, infinity<T>, statistics_.tests);
  ++statistics_.ends(nearest ? Ending::hit : Ending::missed);
  note(Line::radiosity_find_closest_intersection, [&] {
    return nearest ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *nearest)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
  return nearest;
}

/// Emission, and what the surface sends on of the light that arrives there. What leaves the scene sees what lies
/// around.
template <class Policy>
auto RadiosityTracer<Policy>::look_up_light(const EyeRay& ray, const Nearest& nearest) -> Rgb<T> {
  if (!nearest) {
    const Rgb<T> seen = world_.background_along(ray.ray.direction);
    note(Line::look_up_light, [&] {
      return LightLookedUp{ray.number, -1, settings_.patches.flat, Rgbd(0.0), Rgbd(0.0), Rgbd(seen), Rgbd(seen)};
    });
    return seen;
  }
  const auto at = prepare_vertex<Policy>(world_, nested_, ray, *nearest, statistics_, differential_);
  const Patches::Place place =
      patches_.place_of(nearest->primitive, Vec3d(at.position), Vec3d(at.bsdf.geometric_normal));
  const Rgbd irradiance = irradiance_.at(place);
  const Rgb<T> arriving(irradiance / patches_.cosines());
  Rgb<T> sent_on = at.bsdf.diffuse * arriving;
  inject<Policy>(world_, Fault::reflectance_forgotten, [&] { sent_on = arriving; });
  const Rgb<T> shade = at.values().emission + sent_on;
  note(Line::look_up_light, [&] {
    return LightLookedUp{ray.number, place.patch,           settings_.patches.flat,
                         irradiance, Rgbd(at.bsdf.diffuse), Rgbd(at.values().emission),
                         Rgbd(shade)};
  });
  return shade;
}

template <class Policy>
template <class Put>
void RadiosityTracer<Policy>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::radiosity_put_final_shade, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

}  // namespace raywalk
