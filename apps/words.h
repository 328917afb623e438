#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "ar3d/base/nearest_name.h"

namespace ar3d {

/// One of the known words; any other is answered with all of them and the nearest one.
inline CLI::Validator one_of(std::vector<std::string> known) {
  std::string shown = fmt::format("{{{}}}", fmt::join(known, ","));
  return {[known = std::move(known)](std::string& word) -> std::string {
            if (std::ranges::find(known, word) != known.end()) return {};
            return fmt::format("'{}' is none of {}{}", word, fmt::join(known, ", "),
                               did_you_mean(word, {known.begin(), known.end()}));
          },
          std::move(shown)};
}

}  // namespace ar3d
