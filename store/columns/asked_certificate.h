#pragma once

#include <string>

#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// The certificate that was asked for, as the row's certificate and message tell: "exact", "none",
/// "measured"; in results of 0.2.0 also "double" and others, which proved nothing: the message of a
/// drawing that such a one did not accept begins "certificate double did not accept it; ".
std::string asked_certificate(const RunRecord& run);

}  // namespace ar3d
