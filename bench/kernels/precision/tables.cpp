#include "tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace ar3d::precision {

std::string rate(std::uint64_t successes, std::uint64_t trials) {
  if (trials == 0) return "-";
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  constexpr double kZ = 1.959964;  // 95 % of a normal distribution
  if (successes == 0) return fmt::format("0 (< {:.2g} %)", 100 * kZ * kZ / (n + kZ * kZ));
  const double middle = share + kZ * kZ / (2 * n);
  const double half = kZ * std::sqrt(share * (1 - share) / n + kZ * kZ / (4 * n * n));
  const double scale = 1 + kZ * kZ / n;
  return fmt::format("{:.3g} % ({:.3g}-{:.3g})", 100 * share, 100 * (middle - half) / scale,
                     100 * (middle + half) / scale);
}

void print_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows) {
  fmt::print("| {} |\n|", fmt::join(head, " | "));
  for (std::size_t i = 0; i < head.size(); ++i) fmt::print("---|");
  fmt::print("\n");
  for (const std::vector<std::string>& row : rows) fmt::print("| {} |\n", fmt::join(row, " | "));
  fmt::print("\n");
}

}  // namespace ar3d::precision
