// What makes rows belong to one study, how shards are written, and keys of rows: 32 hexadecimal
// digits in a record, two numbers in memory.
#include "ar3d/store/columns/study_identity.h"

#include <fmt/compile.h>
#include <xxhash.h>

#include <charconv>

#include "ar3d/base/error.h"
#include "ar3d/base/number.h"

namespace ar3d {

std::string StudyIdentity::source() const {
  if (!dirty) return source_hash;
  return source_hash + " with changes" + (dirty_hash.empty() ? "" : " " + dirty_hash);
}

std::optional<Shard> parse_shard(std::string_view text) {
  constexpr std::uint32_t kMostShards = 1'000'000;
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return {};
  const auto index = integer_of<std::uint32_t>(text.substr(0, slash));
  const auto count = integer_of<std::uint32_t>(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count || *count > kMostShards) return {};
  return Shard{*index, *count};
}

RowKey parse_row_key(std::string_view text) {
  RowKey key;
  const char* const begin = text.data();
  const bool has_size = text.size() == 32;
  if (has_size) {
    std::from_chars(begin, begin + 16, key.high, 16);
    std::from_chars(begin + 16, begin + 32, key.low, 16);
  }
  if (has_size && to_string(key) == text) return key;
  throw InputError(
      fmt::format("'{}' is no row key of 32 hexadecimal digits", text.substr(0, text.find('\0'))));
}

std::string to_string(const RowKey& key) {
  return fmt::format(FMT_COMPILE("{:016x}{:016x}"), key.high, key.low);
}

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return to_string(RowKey{hash.high64, hash.low64});
}

}  // namespace ar3d
