#pragma once

#include "render/world_cache.h"
#include "timeline/timeline.h"
#include "trace/kernel.h"

namespace raywalk {

/// An observer that keeps every event.
class Recorder : public Observer {
 public:
  void record(Event&& event) override { events_.push_back(std::move(event)); }
  /// The timeline of the recorded events; `image`: the size of the image, one row high for the strip. `statistics`:
  /// what was counted meanwhile.
  [[nodiscard]] Timeline take(ImageSize image, const Statistics& statistics) {
    Timeline timeline(std::move(events_), image);
    timeline.set_statistics(statistics);
    return timeline;
  }

 private:
  std::vector<Event> events_;
};

/// Pixels are recorded one after the other, each with all its samples.
struct Recording {
  Precision precision = Precision::double_;
  Sampling sampling{};
  std::optional<Fault> fault{};  ///< injected into the tracer
  WorldCache* worlds = nullptr;  ///< of the scene; null: a world is built for this recording alone
  int photons = 100;             ///< so many are followed line by line, the others in one step
  int shots = 6;                 ///< of patches in the plan: so many are walked line by line,
  int single_shots = 150;        ///< and so many more in one step each
  Stop stop{};                   ///< cancels it: the record functions then throw Stopped
};

/// Whether the strip is recorded as beams; else as rays: where its scene wants them, and there is no reason against it.
[[nodiscard]] bool follows_beams(const Scene& scene, const Recording& how = {});

/// The whole strip: row 0 of a cells x 1 image, which is the middle row of every image an odd multiple as large.
[[nodiscard]] Timeline record_strip(const Scene& scene, const Recording& how = {});
/// One cell of it; 0 <= cell < the screen's cells.
[[nodiscard]] Timeline record_cell(const Scene& scene, int cell, const Recording& how = {});
/// One pixel of the scene's image of the given size; 0 <= column < width, 0 <= row < height.
[[nodiscard]] Timeline record_pixel(const Scene& scene, ImageSize size, int column, int row, const Recording& how = {});

}  // namespace raywalk
