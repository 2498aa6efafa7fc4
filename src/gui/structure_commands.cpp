#include "gui/structure_commands.h"

#include "gui/choices.h"
#include "inspect/search_walk.h"

namespace raywalk {

void perform_structure(Command command, const Ui& ui) {
  const State& state = ui.state;
  const int step = structure_step(state);
  if (command == Command::structure_next) return ui.act(action::GoInStructure{step + 1});
  if (command == Command::structure_back) return ui.act(action::GoInStructure{step - 1});
  if (command == Command::structure_first) return ui.act(action::GoInStructure{0});
  if (command == Command::structure_last) return ui.act(action::GoInStructure{structure_steps(state)});
  if (command == Command::structure_kind)
    return ui.act(action::ChooseStructure{next_among(watched_accelerators, state.structure.kind)});
  ui.act(action::ShowStructurePage{state.structure.page == StructurePage::search ? StructurePage::build
                                                                                 : StructurePage::search});
}

bool structure_enabled(Command command, const State& state) {
  if (!shows_structure(state)) return false;
  if (command == Command::structure_next || command == Command::structure_last)
    return structure_step(state) < structure_steps(state);
  if (command == Command::structure_back || command == Command::structure_first) return structure_step(state) > 0;
  return true;
}

}  // namespace raywalk
