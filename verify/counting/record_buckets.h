#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ar3d/verify/counting/plane_records.h"

namespace ar3d::verify {

/// Records in buckets whose sizes need not be known before: each is a chain of chunks. 16 bytes per
/// record and half a kilobyte per bucket; what was taken is kept.
class RecordBuckets {
 public:
  /// Empty buckets.
  void reset(std::size_t buckets) {
    ends_.assign(buckets, nullptr);
    chains_.assign(buckets, {});
    block_ = used_ = 0;
  }
  std::size_t size() const { return ends_.size(); }

  void add(std::size_t bucket, const PlaneRecord& record) {
    PlaneRecord*& end = ends_[bucket];
    // A chunk ends at a multiple of its size, and so does the null pointer.
    if (reinterpret_cast<std::uintptr_t>(end) % sizeof(Chunk) == 0) end = append_chunk(bucket);
    *end++ = record;
  }
  std::size_t size_of(std::size_t bucket) const {
    const Chain& chain = chains_[bucket];
    if (chain.last == nullptr) return 0;
    return kRecords * chain.full +
           static_cast<std::size_t>(ends_[bucket] - chain.last->records.data());
  }
  template <class Visit>
  void for_each(std::size_t bucket, Visit&& visit) const {
    const Chain& chain = chains_[bucket];
    for (const Chunk* chunk = chain.first; chunk != nullptr; chunk = chunk->next) {
      const PlaneRecord* const begin = chunk->records.data();
      const PlaneRecord* const end = chunk == chain.last ? ends_[bucket] : begin + kRecords;
      for (const PlaneRecord* record = begin; record != end; ++record) visit(*record);
    }
  }

 private:
  static constexpr std::size_t kRecords = 63;
  struct alignas(1024) Chunk {
    Chunk* next;
    alignas(sizeof(PlaneRecord)) std::array<PlaneRecord, kRecords> records;
  };
  static_assert(sizeof(Chunk) == (kRecords + 1) * sizeof(PlaneRecord));
  struct Chain {
    Chunk* first = nullptr;
    Chunk* last = nullptr;
    std::size_t full = 0;  ///< chunks before the last one
  };

  static std::size_t room_of(std::size_t block) {
    return std::size_t{4} << std::min<std::size_t>(block, 8);
  }
  PlaneRecord* append_chunk(std::size_t bucket) {
    if (block_ < blocks_.size() && used_ == room_of(block_)) {
      ++block_;
      used_ = 0;
    }
    if (block_ == blocks_.size()) {
      // Not value-initialised: every record is written before it is read.
      blocks_.push_back(std::unique_ptr<Chunk[]>(new Chunk[room_of(block_)]));
    }
    Chunk* const chunk = &blocks_[block_][used_++];
    chunk->next = nullptr;
    Chain& chain = chains_[bucket];
    if (chain.first == nullptr) {
      chain.first = chunk;
    } else {
      chain.last->next = chunk;
      ++chain.full;
    }
    chain.last = chunk;
    return chunk->records.data();
  }

  std::vector<PlaneRecord*> ends_;  ///< of the buckets
  std::vector<Chain> chains_;
  std::vector<std::unique_ptr<Chunk[]>> blocks_;
  std::size_t block_ = 0;  ///< of the next chunk
  std::size_t used_ = 0;   ///< chunks of that block
};

}  // namespace ar3d::verify
