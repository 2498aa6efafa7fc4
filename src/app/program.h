#pragma once

namespace raywalk {

/// Runs raywalk for a command line; returns its exit code.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace raywalk
