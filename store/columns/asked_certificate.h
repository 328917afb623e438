#pragma once

#include <string>

#include "ar3d/store/columns/run_record.h"
#include "ar3d/verify/certificate_mode.h"

namespace ar3d {

/// "certificate double did not accept it; ": how the message begins of a row whose drawing another
/// certificate than exact did not accept, so that it was judged exactly.
std::string not_accepted(const CertificateMode& mode);

/// The certificate that was asked for, as the row's certificate and message tell: "exact",
/// "measured", "double", ...
std::string asked_certificate(const RunRecord& run);

}  // namespace ar3d
