#pragma once

#include "ar3d/formats/text/output.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/examination.h"

namespace ar3d {

/// Returns the certificate, metrics and hash of a drawing, all metrics filled in.
Examination examine_all(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                        CertificateMode mode);

/// Writes one line of JSON that describes a drawing without its polylines:
///   {"n":N,"m":M,"algorithm":"…","level":"extents","certificate":"exact","verdict":"proved",
///    "violations":0,
///    "drawing_hash":"…","box":[[x,y,z],[x,y,z]],METRIC:VALUE,…}
/// with every metric of `ar3d list metrics`, null if it is missing. verdict is "proved",
/// "violated", "not judged" or "measured" (in a real type, nothing is proved; such a line has no
/// box). At level positions
/// "vertices":[[x,y,z],…] follows, as in the line of the drawing itself, with real_type and
/// unit_exponent before it if it is in a real type.
/// @throws InputError if it cannot be written.
void write_summary_line(OutputFile& output, const Drawing& drawing, const Examination& examination,
                        Level level);

}  // namespace ar3d
