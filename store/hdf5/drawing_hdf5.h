#pragma once

#include <string>

#include "ar3d/model/drawing.h"

namespace ar3d {

/// Writes a drawing as FILE.h5, exact and atomically: /vertices (int64, n x 3), /edges (m x 2),
/// /bends/offsets (m + 1) and /bends/points (int64, k x 3), where the bends of edge e from its
/// first to its second end are the rows offsets[e] to offsets[e + 1]; attributes algorithm, gram (3
/// x 3) and gram_denominator. Memory: the file's size twice. @throws InputError if it cannot be
/// written.
void write_drawing_hdf5(const Drawing& drawing, const std::string& path);

}  // namespace ar3d
