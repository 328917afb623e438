#pragma once

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <vector>

#include "ar3d/model/error.h"

namespace ar3d {

/// Parses "name=integer" words (options of algorithms, parameters of families).
/// @throws InputError naming the word.
template <class Value>
std::vector<Value> parse_assignments(const std::vector<std::string>& words) {
  std::vector<Value> values;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    Value value;
    bool good = equals != std::string::npos && equals > 0;
    if (good) {
      value.name = word.substr(0, equals);
      const char* end = word.data() + word.size();
      const auto parsed = std::from_chars(word.data() + equals + 1, end, value.value);
      good = parsed.ec == std::errc() && parsed.ptr == end;
    }
    if (!good) throw InputError(fmt::format("'{}' is not of the form name=integer", word));
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace ar3d
