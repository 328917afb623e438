#include "ar3d/bench/spec/kept_drawings.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {

const char* to_string(KeptDrawings kept) {
  switch (kept) {
    case KeptDrawings::none:
      return "none";
    case KeptDrawings::worst:
      return "worst";
    case KeptDrawings::violated:
      return "violated";
    case KeptDrawings::all:
      return "all";
  }
  throw InternalError("internal error: no name for which drawings are kept");
}

KeptDrawings parse_kept_drawings(std::string_view text) {
  for (const KeptDrawings kept :
       {KeptDrawings::none, KeptDrawings::worst, KeptDrawings::violated, KeptDrawings::all}) {
    if (text == to_string(kept)) return kept;
  }
  throw InputError(fmt::format("keep_drawings '{}' is none of none, worst, violated and all{}",
                               printable(text),
                               did_you_mean(text, {"none", "worst", "violated", "all"})));
}

}  // namespace ar3d
