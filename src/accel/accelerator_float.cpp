#include "accel/search.h"

namespace raywalk {

RAYWALK_SEARCHES(float, Ray)
RAYWALK_SEARCHES(float, NaiveRay)

}  // namespace raywalk
