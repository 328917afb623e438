#include "ar3d/algorithms/effort.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {

SettingSpec effort_option(int highest, std::string_view description) {
  return {"effort", 0, highest, kDefaultEffort, std::string(description)};
}

void check_effort(std::string_view algorithm, int effort, int highest) {
  if (effort >= 0 && effort <= highest) return;
  throw InputError(fmt::format("{} has efforts 0 to {}, not {}", algorithm, highest, effort));
}

}  // namespace ar3d
