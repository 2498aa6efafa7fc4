#include "app/console.h"
#include "app/interrupt.h"
#include "app/program.h"
#include "render/parallel.h"
#include "scene/schema_kinds.h"
#include "trace/recursion.h"

#include <unistd.h>

#include <cstdio>

int main(int argc, char** argv) {
  using namespace raywalk;
  hold_closed_streams();
  end_at_signals();
  // Whatever the stack limit (`ulimit -s`): enough for the deepest scene allowed.
  constexpr std::size_t around = std::size_t{2} << 20, room = stack_for(schema::depth_count.high) + around;
  int code = 1;
  const auto run = [&] { code = run_program(argc, argv); };
  if (stack_left() >= room || !run_on_stack(room, run)) run();
  if (has_detached_work()) {
    // Static destruction would destroy what detached threads of the window still use.
    std::fflush(nullptr);
    _exit(code);
  }
  return code;
}
