#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/test.h"

namespace ar3d::testing {

/// Expects of each pair that the first text holds the second.
inline void expect_parts(const std::vector<std::pair<std::string, std::string>>& pairs) {
  for (const auto& [text, part] : pairs) EXPECT_THAT(text, HasSubstr(part));
}

}  // namespace ar3d::testing
