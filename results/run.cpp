#include "ar3d/results/run.h"

#include <fmt/format.h>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {
constexpr std::array<const char*, 6> kNames = {"ok",      "timeout",  "out_of_memory",
                                               "refused", "violated", "crashed"};
}  // namespace

const char* to_string(RunStatus status) { return kNames.at(static_cast<std::size_t>(status)); }

RunStatus parse_run_status(std::string_view text) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (text == kNames[i]) return static_cast<RunStatus>(i);
  }
  throw InputError(fmt::format("unknown status '{}'", text));
}

}  // namespace ar3d
