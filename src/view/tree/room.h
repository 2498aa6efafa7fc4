#pragma once
// The ray tree.

#include "view/room.h"

namespace raywalk {

/// The ray tree.
struct TreeRoom {
  static constexpr Tab tab{"tree", true};
};

}  // namespace raywalk
