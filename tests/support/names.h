#pragma once

#include <cctype>
#include <string>

#include "support/test.h"

namespace ar3d::testing {

/// Names a test's instances after their values: `before` and what of the value's text may stand in
/// a test's name. What a number counts belongs into `before`: "n5", not "5".
inline auto named(const std::string& before = "") {
  return [before](const auto& instance) {
    std::string name = before;
    for (const char c : ::testing::PrintToString(instance.param)) {
      const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
      if (letter) name += c;
      if (!letter && !name.empty() && name.back() != '_') name += '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    return name;
  };
}

}  // namespace ar3d::testing
