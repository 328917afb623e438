#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace ar3d {

/// The text with every byte sequence that is not UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// Valid UTF-8 on one line: control characters (escape sequences of terminals too) become spaces.
std::string one_line(std::string_view text);

/// The number, or null if it is not finite.
nlohmann::ordered_json json_number(double value);

}  // namespace ar3d
