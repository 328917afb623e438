#include "ar3d/model/level.h"

#include <fmt/format.h>

#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {

const char* to_string(Level level) {
  switch (level) {
    case Level::extents:
      return "extents";
    case Level::positions:
      return "positions";
    case Level::full:
      return "full";
  }
  throw InternalError("internal error: no name for a level");
}

Level parse_level(std::string_view text) {
  for (const Level level : {Level::extents, Level::positions, Level::full}) {
    if (text == to_string(level)) return level;
  }
  throw InputError(fmt::format("'{}' is no level (known: extents, positions, full){}",
                               printable(text),
                               did_you_mean(text, {"extents", "positions", "full"})));
}

Drawing at_level(Drawing drawing, Level level) {
  switch (level) {
    case Level::extents:
      return drawing;
    case Level::positions:
      return with_stored_positions(drawing);
    case Level::full:
      return with_stored_bends(drawing);
  }
  throw InternalError("internal error: no such level");
}

}  // namespace ar3d
