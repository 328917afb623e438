#pragma once

#include <algorithm>
#include <string_view>

namespace ar3d {

/// Puts C2 before C10: runs of digits are compared as numbers.
struct AsPeopleSort {
  bool operator()(std::string_view a, std::string_view b) const {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::string_view all_a = a, all_b = b;
    while (!a.empty() && !b.empty()) {
      if (is_digit(a[0]) && is_digit(b[0])) {
        const std::string_view one = number_at(a), other = number_at(b);
        if (one.size() != other.size()) return one.size() < other.size();
        if (one != other) return one < other;
        continue;
      }
      if (a[0] != b[0]) return a < b;  // by bytes without a sign
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
    return a.empty() != b.empty() ? a.empty() : all_a < all_b;
  }

 private:
  /// Takes the digits away. @return those behind leading zeros.
  static std::string_view number_at(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view digits = text.substr(0, end);
    text.remove_prefix(end);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
  }
};

}  // namespace ar3d
