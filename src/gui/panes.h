#pragma once
// The panes. Each draws the data of `view` into its rectangle and adds the user's actions; none changes the state.

#include "gui/command.h"
#include "gui/form.h"
#include "gui/key.h"
#include "gui/ui.h"

#include <any>
#include <cstdint>
#include <map>

namespace raywalk {

class GalleryPictures;  // gui/gallery.h
class LiveCosts;        // gui/live_costs.h
struct LessonPanel;     // view/lesson/lesson_panel.h

inline constexpr int menu_count = 5;
/// A menu: the id of its title, and the sections of its commands.
struct MenuContents {
  std::string_view title;
  std::vector<Section> sections;
};
[[nodiscard]] MenuContents menu_contents(int menu);
/// Along the top: menus, modes, undo and redo, the document's name. Opens menu `open_menu`, unless that is -1. Returns
/// the open menu, or -1.
int bar_pane(const Ui& ui, const Rect& where, int open_menu);
/// The width of menus and buttons in one line, with as little between them as in a narrow window.
[[nodiscard]] float bar_width(const Ui& ui);

/// Buttons to add and remove objects.
void palette_pane(const Ui& ui, const Rect& where);

/// The size of the plan's pane, which the state is told.
[[nodiscard]] Viewport plan_viewport(const Ui& ui, const Rect& where);
/// The plan and the pointer on it.
void plan_pane(const Ui& ui, const Rect& where);

/// The tools of ink, above the plan.
void ink_pane(const Ui& ui, const Rect& where);
[[nodiscard]] float ink_height(const Ui& ui, float width);

/// The field over the plan for words of ink that are being written.
class InkField {
 public:
  void draw(const Ui& ui, const Rect& plan);

 private:
  std::string typed_;    ///< what stands in it
  bool begins_ = false;  ///< it has just been given the keyboard
  int number_ = 0;  ///< another field once other words are begun: ImGui keeps those of a field that has the keyboard
};

/// The scene as lines in space, in the plan's place.
void lines_pane(const Ui& ui, const Rect& where);
/// Mouse actions on the last item, which shows a turnable view, in `where`.
void turn_by_mouse(const Ui& ui, SpaceView view, const Rect& where);
/// Whether the last item was clicked with the left button without moving.
[[nodiscard]] bool clicked_in_place();

/// Help mode's text. `scroll_by`: units, downwards.
void help_pane(const Ui& ui, const Rect& where, float scroll_by);

/// The step's sentence, the buttons, and the scrub bar over the whole timeline.
void transport_pane(const Ui& ui, const Rect& where);
/// Height that the transport needs at this width.
[[nodiscard]] float transport_height(const Ui& ui, float width);

/// The boxes of pseudocode, one a procedure. Scrolls to the important lines if there is not enough room.
void code_pane(const Ui& ui, const Rect& where);
[[nodiscard]] float code_height(const Ui& ui);
[[nodiscard]] float code_width(const Ui& ui);

/// Numbers and colours of the selection.
class PropertiesPane {
 public:
  /// `focus`: focuses the first field.
  void draw(const Ui& ui, const Rect& where, bool focus);

 private:
  FormMemory memory_;
  Target shown_;  ///< the target of the memory
  bool focus_field_ = false;
};

/// Breakpoints, and a step to go to: a popup beside the code.
class BreakpointsPopup {
 public:
  void draw(const Ui& ui, const Rect& code, bool open);

 private:
  FormMemory memory_;
};

/// The lessons: their list, or the current step of the open one.
class LessonPane {
 public:
  void draw(const Ui& ui, const Rect& where);
  /// Whether its field for a number has the keyboard.
  [[nodiscard]] bool types() const { return types_; }
  /// Gives that the keyboard, and takes what is typed until it has it. `missed`: says that nothing was typed.
  void ask_for_number(bool missed);

 private:
  static constexpr int until_typed = 3;  ///< frames
  /// Returns where the guess stands, in the pane's content, if there is one that the pane shows.
  std::optional<float> question(const Ui& ui, const LessonPanel& panel, bool is_new, bool is_low);
  void number(const Ui& ui, const LessonPanel& panel, bool is_new, bool takes_keys);

  std::string number_;     ///< as typed
  bool types_ = false;     ///< whether somebody types it
  int wanted_ = 0;         ///< for so many more frames it may get the keyboard
  bool missed_ = false;    ///< Enter was pressed, and nothing typed
  std::string shown_for_;  ///< the step that `number_` and the scrolling belong to
  int settling_ = 0;       ///< for so many more frames what is new is scrolled into view
  int hands_ = 0;          ///< of the class, for this step, in the last frame
};

/// Whether arrows and Enter are for the list of lessons or of bugs, and not for what is selected in Move.
inline bool chooses_from_list(const State& state) {
  const bool lists = (state.lessons.shown && state.lessons.at() == nullptr) || (state.bugs.shown && !state.bugs.hunt);
  return lists && (state.walk.mode == Mode::trace || (state.walk.mode == Mode::move && !state.plan.selected));
}
/// In a lesson's question, digits are for choices (with a presenter, for hands of the class), and Enter for the answer
/// and the next step; in the list up and down choose, and Enter opens. Returns whether the key was one of these.
bool lesson_by_key(const KeyPress& press, const Ui& ui);
/// The same in the list of bugs.
bool bug_by_key(const KeyPress& press, const Ui& ui);
/// Up and down turn the arrow that is asked for, or go from thing to thing that a ray may meet. Returns whether it was
/// one.
bool guess_by_key(const KeyPress& press, const Ui& ui);

/// Spot the bug: the list, or the current hunt.
void bug_pane(const Ui& ui, const Rect& where);
/// The banner over the plan while the tracer has a bug. Whether there is a banner above the plan.
[[nodiscard]] bool has_banner(const State& state);
[[nodiscard]] float banner_height(const Ui& ui);
void banner_pane(const Ui& ui, const Rect& where);

/// The 3-D image so far.
struct PictureView {
  std::uintptr_t texture = 0;  ///< 0: none yet
  int width = 0, height = 0;   ///< of the image; `texture` has this size
  double done = 0;             ///< 0..1
  bool has_every_pixel = false, finished = false;
  double seconds_left = 0;             ///< an estimate; 0: none
  double hottest = 0;                  ///< of a heat map: the value of the last colour
  const LiveCosts* costs = nullptr;    ///< of the Cost panel; may be null
  std::uintptr_t cost_texture = 0;     ///< its picture, of costs->size()
  GalleryPictures* gallery = nullptr;  ///< of the dialog that opens scenes; may be null
};

/// What tabs keep between frames, each a type of its own.
class TabMemory {
 public:
  template <class Kept>
  Kept& of() {
    std::any& kept = kept_[&type<Kept>];
    if (!kept.has_value()) kept.emplace<Kept>();
    return *std::any_cast<Kept>(&kept);
  }

 private:
  template <class Kept>
  static constexpr char type = 0;  ///< its address stands for the type
  std::map<const char*, std::any> kept_;
};
/// The ray that a tree last scrolled to.
struct CentredOn {
  int ray = -1;
};
/// What a tab is drawn with, beside the state.
struct TabContext {
  const PictureView& picture;
  TabMemory& memory;
  int pointed_at = -1;  ///< set to the hovered ray
};

/// Whether the open tab has the plan's place, and the plan the tab's.
[[nodiscard]] bool panes_exchanged(const State& state);

/// Which tab is shown, and whether in the plan's place.
void tab_choice(const Ui& ui, const Rect& where);
[[nodiscard]] float tab_choice_height(const Ui& ui, float width);

/// What the open tab shows.
class TabsPane {
 public:
  /// `choice`: where tabs are chosen. `open_settings`: opens the picture's settings; `open_knobs`: the Cost panel's
  /// knobs.
  void draw(const Ui& ui, const Rect& where, const Rect& choice, const PictureView& picture, bool open_settings,
            bool open_knobs);

 private:
  FormMemory settings_, knobs_;
  TabMemory memory_;
  int hovering_ = -1;  ///< the ray hovered in this pane
};

/// The ray tree of the current pixel, in a region that scrolls to the ray under way once it is another than
/// `centred_on`. Returns the hovered ray, or -1.
int ray_tree(const Ui& ui, const Rect& where, int& centred_on);

/// The popup "image-settings", where it is open.
void image_settings(const Ui& ui, FormMemory& memory);
/// The popup "cost-knobs", where it is open.
void cost_knobs_popup(const Ui& ui, FormMemory& memory);
/// A field for the scene's epsilon of naive rays.
void epsilon_row(const Ui& ui, Form& form);

/// Between code and tabs: dragging it gives one of them the other's room, and a double-click each its own again.
void divider_pane(const Ui& ui, const Layout& layout);

/// In one column: what stands below the walk.
void fronts_pane(const Ui& ui, const Rect& where, Front front, bool with_lesson);

/// Samples of the ray kinds, in one row, or a narrow pane in up to three; a click on one hides or shows its rays.
void legend_pane(const Ui& ui, const Rect& where);
/// Height that they need at this width.
[[nodiscard]] float legend_height(const Ui& ui, float width);

/// Switches for effects, with their rays.
void effects_pane(const Ui& ui, const Rect& where);
[[nodiscard]] float effects_height(const Ui& ui, float width);
[[nodiscard]] float effects_row_height(const Ui& ui);

/// SCREEN's cells, large.
void band_pane(const Ui& ui, const Rect& where);

/// What remains of a pane while the plan is in focus: a button that brings it back.
void folded_pane(const Ui& ui, const char* name, const Rect& where);
/// The button in the plan's corner.
void focus_button(const Ui& ui, const Rect& where);

}  // namespace raywalk
