#include "accel/search.h"

namespace raywalk {

RAYWALK_SEARCHES(float, NaiveRay)
RAYWALK_SEARCHES(double, NaiveRay)

}  // namespace raywalk
