// What makes rows belong to one study, and how shards are written.
#include "ar3d/store/columns/study_identity.h"

#include <xxhash.h>

#include <charconv>

#include "ar3d/store/columns/row_key.h"

namespace ar3d {

std::string StudyIdentity::source() const {
  if (!dirty) return source_hash;
  return source_hash + " with changes" + (dirty_hash.empty() ? "" : " " + dirty_hash);
}

std::optional<Shard> parse_shard(std::string_view text) {
  constexpr std::uint32_t kMostShards = 1'000'000;
  Shard shard;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = std::from_chars(slash ? index.ptr + 1 : end, end, shard.count);
  const bool is_read = slash && count.ec == std::errc() && count.ptr == end;
  if (!is_read || shard.index < 1 || shard.index > shard.count || shard.count > kMostShards) {
    return {};
  }
  return shard;
}

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return to_string(RowKey{hash.high64, hash.low64});
}

}  // namespace ar3d
