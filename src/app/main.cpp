#include "app/interrupt.h"
#include "app/program.h"
#include "render/parallel.h"
#include "scene/schema_kinds.h"
#include "trace/recursion.h"

#include <unistd.h>

#include <cstdio>

int main(int argc, char** argv) {
  using namespace raywalk;
  end_at_signals();
  // Whatever this process was given (`ulimit -s`): enough for the deepest scene that there may be.
  constexpr std::size_t around = std::size_t{2} << 20, room = stack_for(schema::depth_count.high) + around;
  int code = 1;
  const auto run = [&] { code = run_program(argc, argv); };
  if (stack_left() >= room || !run_on_stack(room, run)) run();
  if (left_alone()) {
    // What the closed window left to itself would else be torn down under its feet.
    std::fflush(nullptr);
    _exit(code);
  }
  return code;
}
