// Catch2 v2's own main and everything behind its macros, in a file of its own because it takes many seconds to compile.
// Catch2 v3 comes compiled and this file is left out.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
