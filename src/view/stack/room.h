#pragma once
// The call stack.

#include "view/room.h"

namespace raywalk {

/// The call stack.
struct StackRoom {
  static constexpr Tab tab{"stack"};
};

}  // namespace raywalk
