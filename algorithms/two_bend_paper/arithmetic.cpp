// Whether the drawings' arithmetic rounds as IEEE 754 says, on which Repair P.1 and Steps P.1 to
// P.12 rest: the test runs in this file, so that it is compiled with the same flags as the
// drawings. Cost: O(1).
#include "ar3d/algorithms/two_bend_paper/arithmetic.h"

#include "ar3d/base/ieee_arithmetic.h"

namespace ar3d::two_bend_paper {

std::string arithmetic_departures() { return ar3d::arithmetic_departures(); }

}  // namespace ar3d::two_bend_paper
