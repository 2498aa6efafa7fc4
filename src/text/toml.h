#pragma once
// The one place that includes toml++, so that everyone's is configured alike.

// Errors are results here, not exceptions: the browser build has none.
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
// Some of the library's assertions fail on malformed text (3.3.0: the header "[=]"), which it goes on to
// refuse properly. With NDEBUG it turns them into promises to the optimiser, which is worse. So: neither.
#define TOML_ASSERT(expression) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
