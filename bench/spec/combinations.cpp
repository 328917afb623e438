#include "ar3d/bench/spec/combinations.h"

#include <cstddef>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::size_t kMostCombinations = 100000;

}  // namespace

std::vector<Settings> combinations(const std::vector<SettingChoices>& settings) {
  std::vector<Settings> all = {{}};
  for (const SettingChoices& setting : settings) {
    std::vector<Settings> longer;
    for (const auto& prefix : all) {
      for (const std::int64_t value : setting.values) {
        longer.push_back(prefix);
        longer.back().push_back({setting.name, value});
      }
    }
    if (longer.size() > kMostCombinations) {
      throw InputError("more than 100000 combinations of settings");
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace ar3d
