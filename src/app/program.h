#pragma once

namespace raywalk {

/// The program raywalk, from its command line to its exit code.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace raywalk
