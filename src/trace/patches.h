#pragma once
// Patches: the surfaces of a scene cut into small flat pieces, each as bright all over (C. Goral, K. Torrance, D.
// Greenberg and B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces", SIGGRAPH 1984).
//
// Boxes, prisms, polygons and triangles are cut as they are. Curved bodies become polygons inscribed in them, with at
// least 16 sides around: no place of theirs lies further off than 2% of a radius. What has two sides has patches on
// both, but for sides that no light can reach: inside a closed body that holds neither a source of light nor the eye,
// and where nothing lies in front. Mirrors and glass absorb: they are as dark as their kd says.
//
// In a flat world everything is endless along z, and patches are pieces of the edges where the plane z = 0 cuts it.

#include "accel/accelerator.h"
#include "math/stop.h"
#include "scene/scene.h"
#include "text/error.h"
#include "trace/form_factor.h"
#include "trace/world.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raywalk {

struct PatchSettings {
  double size = infinity<double>;  ///< no side of a patch is longer; infinite: a twelfth of the scene
  bool flat = false;
};

/// One side of a piece of a surface. In a flat world it is as high as 2, from z = -1 to 1, and its area its length.
struct Patch {
  std::array<Vec3d, 4> corner;     ///< counter-clockwise seen from where its light goes
  int corners;                     ///< 3 or 4
  Vec3d centre{0.0}, normal{0.0};  ///< normal: unit length
  double area = 0;
  int primitive = 0, part = 0, object = 0;
  bool inner = false;  ///< the inside of a body, or the back of a surface
  int face = 0;        ///< of the occluder that both sides share
  Rgbd emission{0.0};  ///< radiosity that it gives off by itself
  Rgbd reflectance{0.0};

  [[nodiscard]] std::span<const Vec3d> outline() const { return {corner.data(), static_cast<std::size_t>(corners)}; }
  /// Its edge, in a flat world.
  [[nodiscard]] Edge edge() const {
    const Vec2d a(corner[0]), b(corner[1]), along = b - a;
    return along.x * normal.y - along.y * normal.x > 0 ? Edge{a, b} : Edge{b, a};
  }
};

/// The value that a point of a flat convex polygon has of each of its corners: its mean value coordinates (M. Floater,
/// 2003), which are linear along edges.
[[nodiscard]] std::array<double, 4> mean_value_weights(const Patch& patch, const Vec3d& point);
/// How far inside the polygon's edges a point lies, seen along its normal; negative outside.
[[nodiscard]] double inside_by(const Patch& patch, const Vec3d& point);

/// Whether a point lies before the patch's plane; one in it does not, whatever rounding says.
[[nodiscard]] bool in_front(const Patch& of, const Vec3d& point);

/// What one patch sees of another one.
struct Exchange {
  double area = 0;     ///< A1 F12 as if nothing stood between
  double visible = 1;  ///< the share of it that nothing keeps away
  [[nodiscard]] double through() const { return area * visible; }
};

/// Why a scene has no patches, by the name of the object: what is endless cannot be cut, what moves has no one place.
/// And no scene has too many.
[[nodiscard]] std::optional<Error> why_no_patches(const Scene& scene, const Stop& stop = {});
/// What of a scene patches leave out, a sentence each, by the names of the objects.
[[nodiscard]] std::vector<std::string> patch_losses(const Scene& scene);

/// Some patches, by the cells of a grid that they reach into. None of them is larger than a cell.
class PatchGrid {
 public:
  PatchGrid(const std::vector<Patch>& patches, const std::vector<int>& of);
  /// Ascending if they were; all that the point lies in, and none that it is farther from than two cells.
  [[nodiscard]] const std::vector<int>& near(const Vec3d& point) const;
  [[nodiscard]] double cell() const { return cell_; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const Vec3d& point) const;
  double cell_ = 0;
  std::map<Cell, std::vector<int>> cells_;
};

/// All patches of a scene, and what they see of each other. Its answers do not depend on how it is asked.
class Patches {
 public:
  /// `stop` may cancel it, which then throws Stopped.
  Patches(const Scene& scene, const PatchSettings& settings, const Stop& stop = {});
  /// Another light of the same surfaces.
  void paint(int patch, const Rgbd& emission, const Rgbd& reflectance) {
    patches_[static_cast<std::size_t>(patch)].emission = emission;
    patches_[static_cast<std::size_t>(patch)].reflectance = reflectance;
  }

  /// More are not cut: their form factors would not fit into memory. Then there are none.
  static constexpr int most = 5000;
  /// The longest side of a patch, of the scene's, where none is chosen.
  static constexpr double share_of_extent = 1.0 / 12;
  [[nodiscard]] bool too_many() const { return too_many_; }

  [[nodiscard]] int size() const { return static_cast<int>(patches_.size()); }
  [[nodiscard]] const Patch& operator[](int i) const { return patches_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const std::vector<Patch>& all() const { return patches_; }
  [[nodiscard]] bool is_flat() const { return flat_; }
  /// The integral of the cosine over all directions above a surface.
  [[nodiscard]] double cosines() const;

  /// Whether some of each lies in front of the other.
  [[nodiscard]] bool face_each_other(int a, int b) const;
  /// The same, bit for bit, the other way round. Whole where rays between 4 points of each (in the plane 8) meet
  /// nothing; else weakened as 16 points (in the plane 32) tell.
  [[nodiscard]] Exchange exchange(int a, int b) const;
  /// What arrives from the lights of the scene, averaged over the patch: an irradiance.
  [[nodiscard]] Rgbd light_of_lamps(int patch) const;
  /// What arrives at a point of a patch straight from the lights of the scene and from the patches `sources`, which
  /// emit: an irradiance. In space.
  [[nodiscard]] Rgbd straight_light(int patch, const Vec3d& at, const std::vector<int>& sources) const;
  /// Whether the patches about it lie in its plane.
  [[nodiscard]] bool is_in_flat_surface(int patch) const;

  /// A place on a surface, between patches.
  struct Place {
    int patch = -1;                   ///< -1: none is there
    std::array<double, 4> weights{};  ///< of its corners
    Vec3d point{0.0};                 ///< of the patch; in space
  };
  /// `normal`: of the side that is seen.
  [[nodiscard]] Place place_of(int primitive, const Vec3d& position, const Vec3d& normal) const;
  /// The patches whose mean a corner of a patch has: those about it on the same surface.
  [[nodiscard]] const std::vector<int>& about(int patch, int corner) const {
    return about_[static_cast<std::size_t>(patch)][static_cast<std::size_t>(corner)];
  }

 private:
  struct Colours {
    Rgbd emission, reflectance;
  };
  [[nodiscard]] Colours mean_colours(const Patch& patch, const World<double>::Surface& surface) const;
  void find_neighbours();
  /// Of the light between two surfaces: pairs of points, each as important as it is for the form factor.
  struct VisibleShare {
    double seen = 0, all = 0;
    [[nodiscard]] double value() const { return all > 0 ? seen == all ? 1 : seen / all : 1; }
  };
  void look_along(const Patch& a, const Vec3d& p, const Patch& b, const Vec3d& q, VisibleShare& share) const;
  [[nodiscard]] double visible_share(const Patch& a, const Patch& b, int points) const;
  /// Of a source, seen from a point of a patch: by `points` x `points` rays.
  [[nodiscard]] double visible_share(const Patch& patch, const Vec3d& at, const Patch& source, int points) const;
  /// What arrives at a point of a patch from a light, an area light by `grid` x `grid` points of it; and whether some
  /// of these are hidden or below the patch's horizon, but not all.
  struct LampLight {
    Rgbd irradiance{0.0};
    bool partly_hidden = false;
  };
  [[nodiscard]] LampLight light_of(const World<double>::Light& light, const Patch& patch, const Vec3d& at,
                                   int grid) const;
  [[nodiscard]] bool sees(const Patch& from, const Vec3d& a, const Patch& to, const Vec3d& b) const;
  [[nodiscard]] Vec3d point_on(const Patch& patch, double u, double v) const;
  /// The `k`-th of points that are spread evenly: `points` along each side; in the plane, along the edge.
  [[nodiscard]] Vec3d grid_point(const Patch& patch, int k, int points) const;

  std::vector<Patch> patches_;
  bool flat_ = false, too_many_ = false;
  std::optional<World<double>> world_;  ///< for its lamps
  std::optional<Accelerator<double>> occluders_;
  std::vector<std::vector<int>> by_primitive_;
  std::vector<std::array<std::vector<int>, 4>> about_;
  std::vector<PatchGrid> grids_;  ///< by primitive
};

}  // namespace raywalk
