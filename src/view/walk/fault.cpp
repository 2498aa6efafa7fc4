#include "view/walk/fault.h"

#include "view/state.h"
#include "view/walk/walk.h"

namespace raywalk {

std::optional<Fault> fault_at_work(const State& state) {
  return state.walk.bug && !state.walk.bug->mended ? std::optional(state.walk.bug->fault) : std::nullopt;
}

void set_bug(State& state, std::optional<Fault> fault) {
  const std::optional<Fault> now = state.walk.bug ? std::optional(state.walk.bug->fault) : std::nullopt;
  const bool changes = now != fault || (state.walk.bug && state.walk.bug->mended);
  state.walk.bug.reset();
  if (fault) state.walk.bug = Bug{*fault, false, false, {}};
  if (!changes && !fault) return;
  ++state.picture.revision;
  record_again(state);
}

}  // namespace raywalk
