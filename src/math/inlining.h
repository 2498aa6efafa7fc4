#pragma once
// What a loop is too hot to call. Otherwise whether it is compiled in place would depend on what else its kernel holds.

#ifdef __OPTIMIZE_SIZE__  // files that are to be small rather than fast, as most of the page's
#define RAYWALK_INLINE
#define RAYWALK_INLINE_WHOLE
#else
/// Among the attributes of a function: it is always compiled in place.
#define RAYWALK_INLINE gnu::always_inline
/// So is all that it calls.
#define RAYWALK_INLINE_WHOLE gnu::always_inline, gnu::flatten
#endif
