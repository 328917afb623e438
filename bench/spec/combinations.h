#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/settings.h"

namespace ar3d {

/// One integer setting of a family or an algorithm and the values that it takes in turn.
struct SettingChoices {
  std::string name;
  std::vector<std::int64_t> values;
};

/// Every combination of the settings, the last one fastest.
/// @throws InputError if there are more than 100,000.
std::vector<Settings> combinations(const std::vector<SettingChoices>& settings);

}  // namespace ar3d
