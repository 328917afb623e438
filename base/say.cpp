// Texts of several lines are made safe for a terminal line by line.
#include "ar3d/base/say.h"

#include <algorithm>

#include "ar3d/base/printable.h"

namespace ar3d {

std::string printable_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    result += printable(text.substr(0, end));
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace ar3d
