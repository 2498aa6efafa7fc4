#pragma once
// What is to be known of radiosity without the procedure that shoots light (trace/radiosity.h).

#include "trace/event.h"
#include "trace/patch_elements.h"
#include "trace/patches.h"
#include "trace/run_all.h"

#include <functional>
#include <vector>

namespace raywalk {

struct RadiositySettings {
  PatchSettings patches;
  double tolerance = 0.005;  ///< as much of the first light may stay unshot
  int shots = 100000;        ///< most
  bool as_ambient = false;   ///< what lamps send straight to surfaces is not looked up
};

/// What each patch exchanges with those in front of it: rows of A1 F12, each computed when its patch first shoots. A
/// row takes 16 bytes for each patch that is seen.
class FormFactors {
 public:
  explicit FormFactors(const Patches& patches) : patches_(patches), rows_(static_cast<std::size_t>(patches.size())) {}

  struct Entry {
    int other;
    double exchange;  ///< with what stands between; 0: nothing gets through
  };
  /// Of all patches in front, ascending. The same bits whoever computes them, and the same from both sides.
  const std::vector<Entry>& row(int patch, const RunAll& run_all, const Stop& stop);
  [[nodiscard]] const Patches& patches() const { return patches_; }

 private:
  struct Row {
    bool known = false;
    std::vector<Entry> entries;
  };
  const Patches& patches_;
  std::vector<Row> rows_;
};

/// Progressive refinement, as far as it has come.
struct RadiosityState {
  std::vector<PatchLight> lights;
  double first = 0;   ///< power that patches give off by themselves or from lamps, the channels' sum
  double unshot = 0;  ///< what is still to be shot of that and of what arrived since
  int shots = 0;

  /// Of the first light.
  [[nodiscard]] double share() const { return first > 0 ? unshot / first : 0; }
};

/// How light is shot.
struct Shooting {
  RunAll run_all{};
  std::function<void(double share)> shot{};  ///< told after each shot what is unshot, of the first light
  /// So many shots are recorded line by line, so many more in one step each, the rest in one step.
  int walked = 0, single = 0;
};

/// The light at any place: between the corners of patches, each with the mean of the patches about it. In space, what
/// comes straight to flat surfaces has elements of its own (trace/patch_elements.h), unless more than `most_sources`
/// patches emit: then its shadows are as soft as patches are large. `as_ambient`: without what lamps send straight, and
/// without such elements.
class PatchIrradiance {
 public:
  PatchIrradiance() = default;
  PatchIrradiance(FormFactors& factors, const std::vector<PatchLight>& lights, const RunAll& run_all = {},
                  const Stop& stop = {}, bool as_ambient = false);
  /// Black where no patch is.
  [[nodiscard]] Rgbd at(const Patches::Place& place) const;

  static constexpr std::size_t most_sources = 64;

 private:
  std::vector<std::array<Rgbd, 4>> corners_;  ///< without what elements have
  std::vector<PatchElements> elements_;       ///< by patch; empty ones for those that have none
};

/// The light that surfaces send each other, in the place of ambient light: kd / pi times the irradiance by what emits
/// and by all that has been reflected before. What lamps send straight is the tracer's.
class BouncedLight {
 public:
  BouncedLight() = default;
  BouncedLight(const Patches& patches, const PatchIrradiance& irradiance)
      : patches_(&patches), irradiance_(&irradiance) {}
  /// At a place of a primitive. `normal`: of the side that is seen. An irradiance; black where no patch is.
  [[nodiscard]] Rgbd irradiance_at(int primitive, const Vec3d& position, const Vec3d& normal) const {
    return irradiance_->at(patches_->place_of(primitive, position, normal));
  }

 private:
  const Patches* patches_ = nullptr;
  const PatchIrradiance* irradiance_ = nullptr;
};

}  // namespace raywalk
