#pragma once

#include <string>

#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// graphs_study_text with how the files are read: the keys format, base and first_line of every
/// entry, as far as they are not the defaults.
std::string graphs_study_text(const GraphsStudy& study, const ReadOptions& reading);

}  // namespace ar3d
