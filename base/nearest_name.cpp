// Finds the name that was meant, for messages about unknown names.
#include "ar3d/base/nearest_name.h"

#include <algorithm>
#include <array>

namespace ar3d {
namespace {

constexpr std::size_t kLongestName = 100;

char folded(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return c == '_' ? '-' : c;
}

/// Optimal string alignment distance of two names, by rows of the usual table.
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;  // those of i - 2, i - 1 and i
  rows.fill(std::vector<std::size_t>(b.size() + 1));
  for (std::size_t j = 0; j <= b.size(); ++j) rows[2][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    rows[2][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = folded(a[i - 1]) == folded(b[j - 1]);
      rows[2][j] = std::min({rows[1][j] + 1, rows[2][j - 1] + 1, rows[1][j - 1] + (equal ? 0 : 1)});
      if (i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) &&
          folded(a[i - 2]) == folded(b[j - 1])) {
        rows[2][j] = std::min(rows[2][j], rows[0][j - 2] + 1);
      }
    }
  }
  return rows[2][b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view wanted,
                                        const std::vector<std::string_view>& known) {
  if (wanted.empty() || wanted.size() > kLongestName) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string_view name : known) {
    const std::size_t allowed = std::max<std::size_t>(1, name.size() / 3);
    const std::size_t found = distance(wanted, name);
    if (found > allowed || (nearest && found >= least)) continue;
    nearest = name;
    least = found;
  }
  return nearest;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string_view>& known) {
  const std::optional<std::string> nearest = nearest_name(wanted, known);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace ar3d
