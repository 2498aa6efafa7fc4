#include "trace/radiosity_pass.h"

#include "trace/radiosity.h"
#include "trace/radiosity_kernel.h"

#include <algorithm>

namespace raywalk {

const std::vector<FormFactors::Entry>& FormFactors::row(int patch, const RunAll& run_all, const Stop& stop) {
  Row& row = rows_[static_cast<std::size_t>(patch)];
  if (row.known) return row.entries;
  std::vector<Entry> entries;
  for (int other = 0; other < patches_.size(); ++other)
    if (patches_.face_each_other(patch, other)) entries.push_back({other, 0});
  constexpr int chunk = 32;
  const auto count = static_cast<int>(entries.size());
  const auto fill = [&](int i) {
    for (int k = i * chunk; k < std::min(count, (i + 1) * chunk); ++k) {
      if (stop.asked()) return;
      Entry& entry = entries[static_cast<std::size_t>(k)];
      if (const Row& other = rows_[static_cast<std::size_t>(entry.other)]; other.known) {
        const auto same = std::lower_bound(other.entries.begin(), other.entries.end(), patch,
                                           [](const Entry& e, int id) { return e.other < id; });
        entry.exchange = same->exchange;
      } else {
        entry.exchange = patches_.exchange(patch, entry.other).through();
      }
    }
  };
  for_all(run_all, (count + chunk - 1) / chunk, fill);
  stop.check();
  row.entries = std::move(entries);
  row.entries.shrink_to_fit();
  row.known = true;
  return row.entries;
}

PatchIrradiance::PatchIrradiance(FormFactors& factors, const std::vector<PatchLight>& lights, const RunAll& run_all,
                                 const Stop& stop, bool as_ambient) {
  const Patches& patches = factors.patches();
  std::vector<int> sources;
  for (int patch = 0; patch < patches.size(); ++patch)
    if (!is_black(patches[patch].emission)) sources.push_back(patch);
  const bool has_elements = !as_ambient && !patches.is_flat() && sources.size() <= most_sources;

  // What reached each patch by way of others.
  std::vector<Rgbd> bounced(lights.size());
  if (has_elements || as_ambient) {
    for_all(run_all, patches.size(), [&](int patch) {
      const auto index = static_cast<std::size_t>(patch);
      if (!stop.asked()) bounced[index] = lights[index].irradiance - patches.light_of_lamps(patch);
    });
    for (const int source : has_elements ? sources : std::vector<int>())
      for (const FormFactors::Entry& entry : factors.row(source, run_all, stop))
        bounced[static_cast<std::size_t>(entry.other)] -=
            entry.exchange / patches[entry.other].area * patches[source].emission;
    for (Rgbd& each : bounced)
      for (int channel = 0; channel < 3; ++channel) each[channel] = std::max(each[channel], 0.0);  // rounding
  }

  corners_.resize(lights.size());
  elements_.resize(lights.size());
  const auto look_at = [&](int patch) {
    if (stop.asked()) return;
    const auto index = static_cast<std::size_t>(patch);
    if (has_elements && patches.is_in_flat_surface(patch))
      elements_[index] = PatchElements(patches, patch, sources, bounced[index]);
    for (int corner = 0; corner < patches[patch].corners; ++corner) {
      const std::vector<int>& about = patches.about(patch, corner);
      // What no light has reached at all lies under something, and does not darken what lies beside it.
      Rgbd sum(0.0);
      int lit = 0;
      for (const int each : about) {
        const Rgbd& irradiance = lights[static_cast<std::size_t>(each)].irradiance;
        sum += !as_ambient && elements_[index].empty() ? irradiance : bounced[static_cast<std::size_t>(each)];
        lit += is_black(irradiance) ? 0 : 1;
      }
      corners_[index][static_cast<std::size_t>(corner)] = sum / static_cast<double>(std::max(lit, 1));
    }
  };
  for_all(run_all, patches.size(), look_at);
  stop.check();
}

Rgbd PatchIrradiance::at(const Patches::Place& place) const {
  Rgbd sum(0.0);
  if (place.patch < 0 || corners_.empty()) return sum;
  const auto index = static_cast<std::size_t>(place.patch);
  for (std::size_t i = 0; i < corners_[index].size(); ++i) sum += place.weights[i] * corners_[index][i];
  if (!elements_[index].empty()) sum += elements_[index].straight_light_at(place.point);
  return sum;
}

RadiosityState shoot_light(FormFactors& factors, const RadiositySettings& settings, const Shooting& shooting,
                           const Stop& stop) {
  const Scene no_pixels;
  const World<double> world(no_pixels);
  const RayGenerator<double> camera(no_pixels, {1, 1}, {1, 1});
  const PatchIrradiance none;
  NoObserver no_observer;
  RadiosityTracer<Policy<double>> tracer(world, factors, settings, none, camera, no_observer, stop);
  tracer.main_algorithm(&shooting, PixelBlock{}, [](const Pixel&, const Rgb<double>&) {});
  return tracer.state();
}

}  // namespace raywalk
