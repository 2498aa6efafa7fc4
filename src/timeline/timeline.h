#pragma once
// The timeline: the recorded list of events of some pixels, and indices into it.
//
// A position k in 0..steps() means that the first k events have happened. The state at k is a pure function of them and
// is answered here in constant time, without replay: a ray is drawn if it was formed before k, the call stack is a
// chain of frames, a cell is filled if its pixel ended before k.

#include "scene/scene.h"
#include "trace/event.h"
#include "trace/statistics.h"

#include <memory>

#include <span>
#include <vector>

namespace raywalk {

class Patches;
struct PhotonMaps;

/// A ray of the recording, or the stub of one that a limit prevented. Positions are those after the event: a ray formed
/// by event i exists from position i + 1 on.
struct RayRecord {
  bool formed = true;  ///< false: a stub
  RayKind kind = RayKind::primary;
  Ending ending = Ending::missed;
  int parent = -1;                    ///< index in rays(); -1 for primary rays
  int pixel = 0;                      ///< index in pixels()
  int depth = 0;                      ///< DEPTH of the procedure that formed it: 0 for primary rays
  int frame = -1;                     ///< index in frames() of the SHADE that formed it; -1 for MAIN ALGORITHM
  int shade = -1;                     ///< index in frames() of the SHADE of its hit; -1 when there is none
  Vec3d origin{0.0}, direction{0.0};  ///< direction as formed: see RayFormed
  Vec3d end{0.0};  ///< where it ended: hit, blocker or light. For `endless` rays and stubs: origin + unit direction
  bool endless = false;  ///< hit nothing and has no light at its end: infinite
  Vec3d normal{0.0};     ///< outward normal where it hit something
  HitNormals shaded{};   ///< where it hit a surface
  int object = -1;       ///< index in Scene::objects of what it hit, or of its blocker
  int part = 0;
  int light = -1;                     ///< shadow rays, photons: index in Scene::lights
  Rgbd throughput{1.0};               ///< at most this fraction of its radiance reaches the pixel
  Rgbd transmittance{1.0};            ///< shadow rays: of filtering objects
  int beam = -1;                      ///< index in beams(): a beam, a cone or a part of one
  double radius = 0, end_radius = 0;  ///< shadow cones: where they start, and at the light
  int formed_at = 0;                  ///< position from which it is drawn
  int found_at = 0;                   ///< position from which its end is known

  /// The normal that its hit is shaded with, on the surface's outer side.
  [[nodiscard]] Vec3d outward_shading_normal() const {
    return dot(shaded.shading, normal) < 0 ? -shaded.shading : shaded.shading;
  }
};

/// One execution of SHADE, FOLLOW PATH, FOLLOW PHOTON, GATHER LIGHT, SHADE PARTS, SHADE CONE or SHADE PENCIL.
struct FrameRecord {
  int parent = -1;  ///< index in frames() of the suspended caller; -1 when MAIN ALGORITHM or PATH TRACING called
  int depth = 1;
  int ray = 0;                         ///< index in rays() of the ray that is shaded; the primary ray of a path
  int called_at = 0, returned_at = 0;  ///< positions: it is on the stack in [called_at, returned_at)
  Rgbd returned{0.0};                  ///< RTNSHADE
};

/// A beam or a cone, or a part that sees one thing.
struct BeamRecord {
  BeamArea area;
  double begin = 0, end = 1;  ///< in the pixel's width
  double coverage = 1;        ///< of the pixel; of a part of a cone: its share of that cone
  int parts = 0;              ///< that a beam was cut into; 0: this is a part
  int begun_at = 0;           ///< position from which a part is shaded
  int added_at = 0;           ///< and from which its shade is known
  Rgbd shade{0.0};
};

/// One sample of one pixel.
struct PixelRecord {
  int column = 0, row = 0, sample = 0;
  int begun_at = 0, done_at = 0;  ///< positions after "For each pixel" and after "Put final shade in pixel"
  Rgbd shade{0.0};
  Rgbd mean{0.0};  ///< of this and the previous samples of the pixel: its displayed value
};

class Timeline {
 public:
  Timeline() = default;
  /// Indexes the events of whole pixels, as the observed tracer reported them. `image`: the image's size; one row high
  /// for the strip.
  explicit Timeline(std::vector<Event> events, ImageSize image = {0, 1});

  [[nodiscard]] ImageSize image() const { return image_; }
  [[nodiscard]] bool of_strip() const { return image_.height == 1; }
  /// Whether it follows paths, one ray after the other, and no tree: PATH TRACING or PHOTON MAPPING.
  [[nodiscard]] bool of_paths() const { return !pseudocode().recursive; }
  /// Whether it is a recording of PHOTON MAPPING.
  [[nodiscard]] bool of_photons() const { return pseudocode().lines.front().line == Line::for_each_photon; }
  /// Whether it is a recording of RADIOSITY.
  [[nodiscard]] bool of_radiosity() const { return pseudocode().lines.front().line == Line::cut_patches; }
  /// Whether it is a recording of BEAM TRACING.
  [[nodiscard]] bool of_beams() const { return pseudocode().lines.front().line == Line::beam_for_each_pixel; }
  /// Whether it is a recording of CONE TRACING.
  [[nodiscard]] bool of_cones() const { return pseudocode().lines.front().line == Line::cone_for_each_pixel; }
  /// Whether what it follows has a width: of one of these two.
  [[nodiscard]] bool has_width() const { return of_beams() || of_cones(); }
  /// Whether it is a recording of PENCIL TRACING.
  [[nodiscard]] bool of_pencils() const { return pseudocode().lines.front().line == Line::pencil_for_each_pixel; }
  /// The pseudocode whose lines it walks.
  [[nodiscard]] const Pseudocode& pseudocode() const {
    return events_.empty() ? pseudocodes.front() : pseudocode_with(events_.front().line);
  }

  /// Whether the walk can come to a line of it.
  [[nodiscard]] bool walks(Line line) const { return is_flat() || !is_of_plan(line); }

  /// A photon that was stored while it was watched.
  struct StoredPhoton {
    Vec3d position, normal;
    Rgbd power;
    PhotonHistory history;
    bool kept;
    int stored_at;  ///< position from which it is drawn
  };
  [[nodiscard]] const std::vector<StoredPhoton>& stored_photons() const { return stored_photons_; }
  /// What all photons have left, if it is a recording of PHOTON MAPPING.
  [[nodiscard]] const PhotonMaps* photons() const;
  /// The position from which all of them are there.
  [[nodiscard]] int all_photons_at() const { return all_photons_at_; }
  /// What was counted when it was recorded. The rays that follow a beam's middle ray are among that, and not recorded.
  void set_statistics(const Statistics& statistics) { statistics_ = statistics; }
  /// Whether a ray was not formed because of the limit of depth.
  [[nodiscard]] bool is_cut_off_by_depth() const { return statistics_.ends(Ending::depth) > 0; }
  /// How many steps it would have with all its rays: each has two at least.
  [[nodiscard]] double steps_of_all_rays() const;
  /// Whether it runs in a flat world.
  [[nodiscard]] bool is_flat() const { return flat_ || (of_beams() && of_strip()); }
  void set_flat() { flat_ = true; }
  /// Of RADIOSITY; else null.
  [[nodiscard]] const Patches* patches() const { return patches_.get(); }
  void set_patches(std::shared_ptr<const Patches> patches, bool flat) {
    patches_ = std::move(patches);
    flat_ = flat;
  }
  /// The light of each patch at `position`; empty before they have any.
  [[nodiscard]] std::vector<PatchLight> lights_at(int position) const;
  /// The share of the first light that is unshot at `position`; 1 at first.
  [[nodiscard]] double unshot_at(int position) const;
  /// The position after the first shot that ends behind `position`, or -1.
  [[nodiscard]] int end_of_shot(int position) const;
  [[nodiscard]] const std::vector<BeamRecord>& beams() const { return beams_; }
  /// Index in rays() of the part that the line just run is about, or whose rays are; -1 for none.
  [[nodiscard]] int part_of(int ray) const;
  void set_photons(std::shared_ptr<const std::vector<PhotonMaps>> maps, bool flat) {
    photon_maps_ = std::move(maps);
    flat_ = flat;
  }

  /// Number of events; positions run from 0 to this.
  [[nodiscard]] int steps() const { return static_cast<int>(events_.size()); }
  /// The event that leads from position i to i + 1.
  [[nodiscard]] const Event& event(int i) const { return events_[static_cast<std::size_t>(i)]; }
  /// The line that has just run at `position`; null at 0.
  [[nodiscard]] const Event* just_run(int position) const;
  /// The line that runs next; null at the end.
  [[nodiscard]] const Event* next(int position) const;

  [[nodiscard]] const std::vector<RayRecord>& rays() const { return rays_; }
  [[nodiscard]] const std::vector<FrameRecord>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<PixelRecord>& pixels() const { return pixels_; }

  /// The rays (and stubs) formed up to `position`: a prefix of rays().
  [[nodiscard]] std::span<const RayRecord> rays_at(int position) const;
  /// Index of the ray that the line just run is about (formed, found, called or returned with), or -1.
  [[nodiscard]] int current_ray(int position) const;
  /// Index of the SHADE that executes the line just run, or -1 in MAIN ALGORITHM.
  [[nodiscard]] int current_frame(int position) const;
  /// The stack of calls that have begun and not returned at `position`, innermost first.
  [[nodiscard]] std::vector<int> stack(int position) const;
  /// Index of the current pixel at `position` (or the one just put); -1 at 0.
  [[nodiscard]] int current_pixel(int position) const;
  [[nodiscard]] bool pixel_done(int pixel, int position) const;

  /// The rays (and stubs) of one pixel: the nodes of its ray tree, parents before children. A contiguous part of
  /// rays(), [first, last).
  struct Range {
    int first = 0, last = 0;
  };
  [[nodiscard]] Range rays_of_pixel(int pixel) const;

  // Larger steps. Each returns a position; at the ends it stays.
  [[nodiscard]] int next_ray(int position) const;        ///< after the next ray (or stub) has been formed
  [[nodiscard]] int previous_ray(int position) const;    ///< after the previous ray was formed, or the start
  [[nodiscard]] int next_pixel(int position) const;      ///< after the current pixel (or the next one) has been put
  [[nodiscard]] int previous_pixel(int position) const;  ///< after the previous pixel has been put, or the start

 private:
  /// The state at a position, beyond what the records tell.
  struct Moment {
    int rays = 0;  ///< formed so far
    int ray = -1, frame = -1, innermost = -1, pixel = -1;
  };
  [[nodiscard]] const Moment& moment(int position) const { return moments_[static_cast<std::size_t>(position)]; }

  ImageSize image_{0, 1};
  std::vector<Event> events_;
  std::vector<RayRecord> rays_;
  std::vector<FrameRecord> frames_;
  std::vector<PixelRecord> pixels_;
  std::vector<Moment> moments_{1};  ///< steps() + 1
  std::vector<StoredPhoton> stored_photons_;
  std::vector<BeamRecord> beams_;
  std::shared_ptr<const std::vector<PhotonMaps>> photon_maps_;
  int all_photons_at_ = 0;
  std::shared_ptr<const Patches> patches_;
  std::vector<int> shot_ends_;     ///< positions, ascending
  std::vector<int> lights_known_;  ///< positions after events that hold the light of all patches, ascending
  bool flat_ = false;
  Statistics statistics_;
};

}  // namespace raywalk
