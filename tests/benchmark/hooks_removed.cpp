// The same program from the same source, its tracer without hooks.
#define RAYWALK_WITHOUT_HOOKS
#include "hooks.cpp"
