// toml++'s own code.
#define TOML_IMPLEMENTATION
#include "text/toml.h"
