#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>

#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// Holds what one curve of a study has in common: an algorithm with its options on a family with
/// its parameters, and the level of its rows.
struct CurveKey {
  std::string algorithm;
  std::string options;
  std::string family;
  std::string parameters;
  std::string level = {};  ///< empty: extents, or missing
  friend auto operator<=>(const CurveKey&, const CurveKey&) = default;
};
CurveKey curve_of(const RunRecord& run);

/// Returns "effort=1", "effort=1;level=full": the options and, if it is not extents, the level.
std::string options_and_level(const CurveKey& key);

/// Returns "diamond (effort=1;level=full)", "cubic (k=2)": names for people; empty options and
/// parameters leave no brackets.
std::string algorithm_label(const CurveKey& key);
std::string family_label(const CurveKey& key);

/// Returns "diamond (effort=1) on cubic (k=2), n = 32, graph 3": what drew which graph of its
/// family. n is the one asked for where there is none.
std::string graph_label(const RunRecord& run);

/// Returns "diamond (effort=1) on cubic (k=2) n=300", on one line: what a cell is called, and how
/// it is chosen on a command line. @param n  -1: all sizes.
std::string cell_label(const CurveKey& key, std::int64_t n);

/// Describes two settings that are compared, keys without family, and what both are called then.
struct SettingPair {
  std::string name;
  CurveKey base;
  CurveKey now;
  bool operator==(const SettingPair&) const = default;
};

/// Returns the one setting that a text means: "grid", "diamond (effort=1)", "diamond effort=1"; of
/// options as many as tell it from the others.
/// @throws InputError naming all settings if it means none or several.
CurveKey find_setting(std::span<const CurveKey> settings, const std::string& text);

}  // namespace ar3d
