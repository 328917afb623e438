// Compiled with flags that the build excludes (tests/CMakeLists.txt): arithmetic_departures()
// notices.
#include <string>

#include "ar3d/base/ieee_arithmetic.h"

std::string departures_with_contraction() { return ar3d::arithmetic_departures(); }
