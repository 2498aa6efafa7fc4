#include "accel/search.h"

namespace raywalk {

RAYWALK_SEARCHES(double, NaiveRay)

}  // namespace raywalk
