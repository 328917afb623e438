#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d {

/// Returns the known name that a misspelt one most likely means: the one that takes the fewest
/// insertions, deletions, replacements and exchanges of neighbouring characters (optimal string
/// alignment distance; upper and lower case count as equal, '_' as '-'), at most a third of its
/// characters. Of several at the same distance the first; nothing if all are farther away.
/// O(length^2) time for each known name.
std::optional<std::string> nearest_name(std::string_view wanted,
                                        const std::vector<std::string_view>& known);

/// Returns "; did you mean 'NAME'?" with the nearest known name, or an empty text: the end of a
/// message about an unknown name.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string_view>& known);

/// Returns the names of the rows of a catalogue, for the functions above.
template <class Rows>
std::vector<std::string_view> names_of(const Rows& rows) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

}  // namespace ar3d
