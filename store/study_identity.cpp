#include "ar3d/store/study_identity.h"

#include <xxhash.h>

#include "ar3d/store/columns/row_format.h"

namespace ar3d {

std::string StudyIdentity::source() const {
  if (!dirty) return source_hash;
  return source_hash + " with changes" + (dirty_hash.empty() ? "" : " " + dirty_hash);
}

bool is_shard(const Shard& shard) {
  constexpr std::uint32_t kMostShards = 1'000'000;
  return shard.index >= 1 && shard.index <= shard.count && shard.count <= kMostShards;
}

const StoredTable* find_table(const StudyIdentity& identity, std::string_view name) {
  for (const StoredTable& table : identity.tables) {
    if (table.spec.name == name) return &table;
  }
  return nullptr;
}

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return to_string(RowKey{hash.high64, hash.low64});
}

}  // namespace ar3d
