#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/store/columns/table.h"

namespace ar3d {

struct EnvironmentEntry {
  std::string name;
  std::string value;
  std::int64_t session = 0;  ///< a session is one process that made rows of the study
};

/// Names entries in words: why there were no more rounds of the timing phase, in which order it drew
/// (there where the settings of each graph took turns), and the yardsticks' share.
inline constexpr const char* kTimingRounds = "timing_rounds";
inline constexpr const char* kTimingOrder = "timing_order";
inline constexpr const char* kTimingYardsticks = "timing_yardsticks";

/// Holds which part of a study's instances a process makes: shard `index` of `count`, from 1.
struct Shard {
  std::uint32_t index = 1;
  std::uint32_t count = 1;
  bool operator==(const Shard&) const = default;
};

/// Reads "2/8", the second of eight; nothing unless 1 <= index <= count <= 1,000,000.
std::optional<Shard> parse_shard(std::string_view text);

/// Holds what makes rows belong together.
struct StudyIdentity {
  std::string study_id;
  std::string spec;                 ///< the verbatim TOML
  std::string spec_hash;            ///< content_hash(spec)
  std::string source_hash;          ///< git commit of the program
  bool dirty = false;               ///< the program had changes to it
  std::string dirty_hash;           ///< SHA-256 of the changes; empty: none, or not known
  std::string created;              ///< ISO 8601 with zone
  Shard shard;                      ///< what of the study
  std::int64_t planned_rows = -1;   ///< of this shard; -1: unknown
  std::vector<StoredTable> tables;  ///< small tables that describe all rows

  /// Returns the commit and changes, "8a1f… with changes 17c0…".
  std::string source() const;
};

/// Returns XXH3-128 of the bytes, 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

/// Describes the 128-bit identity of a row: its 32 hexadecimal digits as two numbers.
struct RowKey {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  auto operator<=>(const RowKey&) const = default;
};

/// @throws InputError if the text is not 32 lower-case hexadecimal digits.
RowKey parse_row_key(std::string_view text);
std::string to_string(const RowKey& key);

}  // namespace ar3d

/// Takes the key, which is a hash already.
template <>
struct std::hash<ar3d::RowKey> {
  std::size_t operator()(const ar3d::RowKey& key) const noexcept { return key.low; }
};
