#pragma once
// The whole state of the visualiser, in the parts of its rooms. It changes only through update(state, action) of
// view/action.h; the screen is a pure function of it.

#include "view/appearance/room.h"
#include "view/band/room.h"
#include "view/bugs/room.h"
#include "view/cost/room.h"
#include "view/document/room.h"
#include "view/document/scene_seen.h"
#include "view/effects/room.h"
#include "view/equation/room.h"
#include "view/export/room.h"
#include "view/focus/room.h"
#include "view/ink/room.h"
#include "view/legend/room.h"
#include "view/lesson/room.h"
#include "view/link/room.h"
#include "view/live/room.h"
#include "view/lobe/room.h"
#include "view/microscope/room.h"
#include "view/pencil/room.h"
#include "view/photons/room.h"
#include "view/picture/room.h"
#include "view/plan/room.h"
#include "view/predict/room.h"
#include "view/radiosity/room.h"
#include "view/sky/room.h"
#include "view/space/room.h"
#include "view/stack/room.h"
#include "view/structure/room.h"
#include "view/tree/room.h"
#include "view/walk/room.h"

#include <array>
#include <string>
#include <type_traits>

namespace raywalk {

struct State {
  DocumentRoom document;
  WalkRoom walk;
  PlanRoom plan;
  SpaceRoom space;
  PictureRoom picture;
  AppearanceRoom appearance;
  LessonRoom lessons;
  BugRoom bugs;
  PredictRoom predictions;
  CostRoom cost;
  MicroscopeRoom microscope;
  StructureRoom structure;
  ExportRoom exports;
  LegendRoom legend;
  LiveRoom live;
  FocusRoom focus;
  BandRoom band;
  EffectsRoom effects;
  LinkRoom link;
  InkRoom ink;
  SkyRoom sky;
  LobeRoom lobe;
  PencilRoom pencil;
  PhotonRoom photons;
  RadiosityRoom radiosity;

  [[nodiscard]] const Scene& scene() const { return document.contents.scene; }
};

/// All rooms, in the order of their tabs and of their commands in menus.
using Rooms = Types<WalkRoom, LessonRoom, BugRoom, PlanRoom, SpaceRoom, PictureRoom, TreeRoom, StackRoom, EquationRoom,
                    LegendRoom, CostRoom, MicroscopeRoom, StructureRoom, DocumentRoom, PredictRoom, ExportRoom,
                    LinkRoom, LiveRoom, BandRoom, EffectsRoom, FocusRoom, SkyRoom, LobeRoom, PencilRoom, PhotonRoom,
                    RadiosityRoom, InkRoom, AppearanceRoom>;

namespace rooms {
template <class Room>
concept WithTab = requires { requires std::is_same_v<decltype(&Room::tab), const Tab*>; };
template <class... Rs>
[[nodiscard]] constexpr auto tab_words(Types<Rs...>) {
  std::array<Word<Tab>, (std::size_t{WithTab<Rs>} + ...)> words;
  std::size_t size = 0;
  const auto add = [&]<class Room>() {
    if constexpr (WithTab<Room>) words[size++] = {Room::tab, Room::tab.word};
  };
  (add.template operator()<Rs>(), ...);
  return words;
}
}  // namespace rooms
template <>
inline constexpr auto words_of<Tab> = rooms::tab_words(Rooms());

/// A state that shows `document`, fitted to the viewport, at position 0.
[[nodiscard]] State make_state(SceneDocument document, std::string path = {}, std::string state_dir = {},
                               const Stop& stop = {}, Language language = {});

/// Reads the list of recent files and looks for an autosave in state.state_dir; if there is one, asks whether to
/// recover it. To be called once at the start.
void restore_session(State& state);

/// The scene as stored in the file.
[[nodiscard]] const Scene& saved_scene(const State& state);
/// The document as stored in the file, with the ink that was never to be stored.
[[nodiscard]] SceneDocument saved_document(const State& state);
/// The camera of the 3-D picture.
[[nodiscard]] const Camera& image_camera(const State& state);
/// Overrides the scene's settings with the user's choices. With a bug, numerics are naive: faults exist only there.
void choose(const State& state, RenderChoices& choices);
/// The scene of the 3-D picture.
[[nodiscard]] SceneSeen pictured_scene(const State& state);
/// The scene of the walk.
[[nodiscard]] SceneSeen walked_scene(const State& state);
/// Whether the scene is shown as lines in space instead of the plan.
[[nodiscard]] bool shows_lines(const State& state);

/// The position whose rays and shades the plan shows: the end of the walk while live rays are shown.
[[nodiscard]] int position_shown(const State& state);
/// The cell whose rays follow in Move, or would.
[[nodiscard]] int live_cell(const State& state);
/// The strip's column of the current pixel (or the one just put), or -1; also -1 while a pixel of the picture is
/// walked.
[[nodiscard]] int current_cell(const State& state);

/// Whether there is unsaved work, and a folder to autosave it in. The scene of a hunt does not count.
[[nodiscard]] bool holds_unsaved_work(const State& state);
/// Whether there is some that is not in the autosave.
[[nodiscard]] bool wants_autosave(const State& state);

/// The file's name for the title bar: without folders, "Untitled" if never saved, with "*" in front if dirty.
[[nodiscard]] std::string document_title(const State& state);

}  // namespace raywalk
