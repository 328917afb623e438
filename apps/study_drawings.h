#pragma once

#include <string>

#include "ar3d/analysis/rows.h"
#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// Writes the drawings that a study keeps beside its results file, and tells where they are. What
/// stands there is replaced if it is a file of drawings or `force` is given; else nothing is
/// written. Where no row was made since (`unchanged`), a file of drawings stays as it is, too.
/// @return kPass, or kRegression if a drawing could not be kept, which is said on standard error.
int keep_drawings_beside(const std::string& results, const RowView& rows, KeptDrawings kept,
                         bool force, bool unchanged);

}  // namespace ar3d
