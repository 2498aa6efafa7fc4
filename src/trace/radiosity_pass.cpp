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

PatchIrradiance::PatchIrradiance(const Patches& patches, const std::vector<PatchLight>& lights) {
  corners_.resize(lights.size());
  for (int patch = 0; patch < patches.size(); ++patch)
    for (int corner = 0; corner < patches[patch].corners; ++corner) {
      const std::vector<int>& about = patches.about(patch, corner);
      // What no light has reached at all lies under something, and does not darken what lies beside it.
      Rgbd sum(0.0);
      int lit = 0;
      for (const int each : about) {
        const Rgbd& irradiance = lights[static_cast<std::size_t>(each)].irradiance;
        sum += irradiance;
        lit += is_black(irradiance) ? 0 : 1;
      }
      corners_[static_cast<std::size_t>(patch)][static_cast<std::size_t>(corner)] =
          sum / static_cast<double>(std::max(lit, 1));
    }
}

Rgbd PatchIrradiance::at(const Patches::Place& place) const {
  Rgbd sum(0.0);
  if (place.patch < 0 || corners_.empty()) return sum;
  const auto& corners = corners_[static_cast<std::size_t>(place.patch)];
  for (std::size_t i = 0; i < corners.size(); ++i) sum += place.weights[i] * corners[i];
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
