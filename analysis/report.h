#pragma once

#include <string>

#include "ar3d/results/run.h"

namespace ar3d {

/// One HTML page about a results file: verdict, bound ledger, growth, plots, bends, environment,
/// spec and methods. It needs nothing from outside (no network, no other file); every string of the
/// file is escaped. Cost: that of check, ledger and scaling; about 1 kB a plotted size.
std::string render_report(const Results& results);

}  // namespace ar3d
