#include "ar3d/algorithms/two_bend_paper/arithmetic.h"

#include "ar3d/model/ieee_arithmetic.h"

namespace ar3d::two_bend_paper {

std::string arithmetic_departures() { return ar3d::arithmetic_departures(); }

}  // namespace ar3d::two_bend_paper
