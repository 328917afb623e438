#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace ar3d {

/// Whole numbers from low to high, written with digits alone: CLI11 reads "-5" as 2^64 - 5, and
/// "1e9" or "0x10" in ways of its own.
inline CLI::Validator whole_number(std::uint64_t low,
                                   std::uint64_t high = std::numeric_limits<std::uint64_t>::max()) {
  return {[low, high](std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto parsed = std::from_chars(text.data(), end, value);
            if (!text.empty() && parsed.ptr == end && parsed.ec == std::errc() && value >= low &&
                value <= high) {
              return {};
            }
            return fmt::format("'{}' is not a whole number from {} to {}", text, low, high);
          },
          "NUMBER"};
}

/// Decimal numbers that are finite, and above 0 if `positive`.
inline CLI::Validator finite_number(bool positive) {
  return {[positive](std::string& text) -> std::string {
            double value = 0;
            const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            if (is_number && (value > 0 || !positive)) return {};
            return fmt::format("'{}' is not a number{}", text, positive ? " above 0" : "");
          },
          "NUMBER"};
}

/// Decimal numbers from low to high.
inline CLI::Validator number_between(double low, double high) {
  return {[low, high](std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
            return fmt::format("'{}' is not a number from {} to {}", text, low, high);
          },
          "NUMBER"};
}

}  // namespace ar3d
