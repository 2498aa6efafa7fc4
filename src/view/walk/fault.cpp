#include "view/walk/fault.h"

#include "view/state.h"
#include "view/walk/walk.h"

namespace raywalk {

std::optional<Fault> fault_at_work(const State& state) {
  return state.bug && !state.bug->mended ? std::optional(state.bug->fault) : std::nullopt;
}

void set_bug(State& state, std::optional<Fault> fault) {
  const std::optional<Fault> now = state.bug ? std::optional(state.bug->fault) : std::nullopt;
  const bool changes = now != fault || (state.bug && state.bug->mended);
  state.bug.reset();
  if (fault) state.bug = Bug{*fault, false, false, {}};
  if (!changes && !fault) return;
  ++state.image_revision;
  record_again(state);
}

}  // namespace raywalk
