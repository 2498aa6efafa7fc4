#include "shape/exactly.h"

namespace raywalk::detail {

RAYWALK_EXACTLY(, float)
RAYWALK_EXACTLY(, double)

}  // namespace raywalk::detail
