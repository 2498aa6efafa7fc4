// Implements the actions on the appearance.

#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/pointer.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

void action::SetTheme::apply(State& state) const {
  state.appearance.theme = theme;
  refit(state);
}

void action::SetLanguage::apply(State& state) const {
  const std::optional<Language> found = state.appearance.language.others().find(code);
  if (!found) return complain(state, fill("notice.no_language", state.appearance.language, {{"language", code}}));
  state.appearance.language = *found;
  state.document.notice.reset();  // it is in the old language
}

void action::SetUiScale::apply(State& state) const {
  state.appearance.ui_scale = std::clamp(scale, min_ui_scale, max_ui_scale);
  refit(state);
}

void action::SetTab::apply(State& state) const {
  // In Focus the tabs are folded: what is of use there alone comes in the plan's place, and goes by the same key.
  if (state.focus.on) state.focus.tab = !tab.in_plan && !(state.focus.tab && tab == state.appearance.tab);
  state.appearance.tab = tab;
  state.appearance.front = Front::tabs;
  if (tab == StructureRoom::tab) {  // it draws into the plan of a walk
    end_drag(state);
    state.walk.mode = Mode::trace;
  }
  if (tab == PictureRoom::tab) state.space.turned_last = SpaceView::image;  // keys turn the selected view
}

void action::DividePanes::apply(State& state) const {
  state.appearance.code_part = code_part > 0 ? std::clamp(code_part, min_code_part, max_code_part) : 0;
}

}  // namespace raywalk
