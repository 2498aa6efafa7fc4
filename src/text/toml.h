#pragma once
// The only place that includes toml++, so that it is configured uniformly.

// Errors are results here, not exceptions: the browser build has none.
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
// Some of the library's assertions fail on malformed text (3.3.0: the header "[=]"), which it then refuses properly.
// With NDEBUG they become promises to the optimiser, which is worse. So: neither.
#define TOML_ASSERT(expression) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
