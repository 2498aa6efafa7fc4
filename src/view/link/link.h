#pragma once
// What a link holds, as values and as letters. It stands in the fragment of an address, which browsers send to nobody:
//
//     https://example.org/raywalk/#v=1/scene=glass/changes=q1bKS.../sum=1a2b3c4d/effects=6,3/step=42/mode=trace
//
// `effects` says what the effects bar changes: in hexadecimal the effects that it leaves out, a bit each in the order
// of scene/effects.h, and behind a comma the depth, if it limits that. Here: no reflection, no refraction, depth 3.
//
// A / stands between the parts, for a shell needs no quotes around it. Parts that a version does not know it skips. v
// is raised when a link of the old form would be misread; all earlier forms stay readable (tests/view/links).

#include "io/scene_file.h"
#include "scene/render_choices.h"
#include "text/error.h"
#include "view/state.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

inline constexpr std::size_t max_link = 8000;  ///< letters from the # on: some programs cut longer addresses

struct Link {
  // The scene: a lesson's, a bug's, or else a shipped one, or one that begins with nothing; or that which is open,
  // where nothing is told.
  std::string lesson{};  ///< by the name of its folder
  int lesson_step = 1;
  int bug = 0;                         ///< its number, from 1; 0: none
  std::string scene{};                 ///< by the name of its file
  std::string changes{};               ///< io/scene_patch.h; not of a bug's
  std::optional<std::uint32_t> sum{};  ///< of the scene that `changes` are of

  // How it is seen and walked.
  std::string camera{};                    ///< of the picture, as further changes
  std::optional<PixelWalk> pixel{};        ///< without its camera; absent: the strip
  std::optional<Integrator> integrator{};  ///< absent: the scene's own
  bool single_precision = false;
  int walk_samples = 1;
  EffectSet left_out{};        ///< by the effects bar
  std::optional<int> depth{};  ///< that it limits to; absent: the scene's own

  // The moment, and what is beside it. Absent: as it is.
  std::optional<int> step{};
  std::optional<Mode> mode{};
  std::optional<Tab> tab{};
  std::string language{};  ///< its code
  std::optional<Theme> theme{};

  [[nodiscard]] bool tells_scene() const {
    return !lesson.empty() || bug > 0 || !scene.empty() || !changes.empty() || sum.has_value();
  }
  friend bool operator==(const Link&, const Link&) = default;
};

/// From the # on.
[[nodiscard]] std::string write_link(const Link& link);
/// Of a whole address, or from the # on. Anybody may have written it.
[[nodiscard]] Result<Link> read_link(std::string_view address);
/// The scene of a link that is neither a lesson's nor a bug's, and the sum of what its changes are applied to.
/// `shipped`: the path of the shipped scene that it names, if it does.
struct LinkedScene {
  SceneDocument document{};
  std::uint32_t sum = 0;
};
[[nodiscard]] Result<LinkedScene> linked_scene(const Link& link, const std::string& shipped);
/// Whether this is meant to be a link, and no path.
[[nodiscard]] bool is_link(std::string_view word);

/// The scene and the moment of a state; fails if they do not fit into a link, or need files that are not shipped.
[[nodiscard]] Result<Link> link_of(const State& state);

/// The page that links lead to; empty: none.
[[nodiscard]] const std::string& page_of_links(const State& state);
/// The whole address of the link that is shown; empty: there is none.
[[nodiscard]] std::string address_shown(const State& state);

}  // namespace raywalk
