#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// What the proofs by counting count, and the records of segments that they count in.

namespace ar3d::verify {

/// Holds what is counted in the planes and on the lines of a drawing.
struct MeetingCounts {
  std::uint64_t crossing = 0;  ///< pairs of segments, not parallel, that meet
  std::uint64_t touching = 0;  ///< pairs of collinear segments with one point in common; too few
                               ///< only if a point on an end was counted, too
  bool overlap = false;        ///< collinear segments with more in common were seen
  MeetingCounts& operator+=(const MeetingCounts& other);
  friend bool operator==(const MeetingCounts&, const MeetingCounts&) = default;
};

/// Holds what must be equal if nothing meets that must not (Lemma V.1).
struct CountedMeetings {
  std::uint64_t crossing_neighbours = 0;  ///< A: neighbours that are not parallel
  std::uint64_t touching_neighbours = 0;  ///< B: neighbours that are parallel
  MeetingCounts found;                    ///< M, T, and whether an overlap was seen
  bool agree() const {
    return !found.overlap && found.crossing == crossing_neighbours &&
           found.touching == touching_neighbours;
  }
  friend bool operator==(const CountedMeetings&, const CountedMeetings&) = default;
};

/// A segment of a known direction: from its low end, `steps` times along the direction.
struct PlacedSegment {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
  std::int32_t steps;
};

/// The segments of one direction, in blocks that grow and are never copied; 16 bytes each.
class PlacedSegments {
 public:
  void add(PlacedSegment segment) {
    if (used_ == room_) grow();
    last_[used_++] = segment;
  }

  /// Calls visit(part) for std::span<const PlacedSegment>s that make up all of them.
  template <class Visit>
  void for_each_part(Visit&& visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::size_t count = b + 1 == blocks_.size() ? used_ : room_of(b);
      visit(std::span<const PlacedSegment>(blocks_[b].get(), count));
    }
  }

 private:
  static std::size_t room_of(std::size_t block) {
    return std::size_t{256} << std::min<std::size_t>(block, 10);
  }
  void grow() {
    room_ = room_of(blocks_.size());
    used_ = 0;
    // Not value-initialised: every segment is written before it is read.
    blocks_.push_back(std::unique_ptr<PlacedSegment[]>(new PlacedSegment[room_]));
    last_ = blocks_.back().get();
  }

  std::vector<std::unique_ptr<PlacedSegment[]>> blocks_;
  PlacedSegment* last_ = nullptr;
  std::size_t used_ = 0;
  std::size_t room_ = 0;
};

/// A segment in a plane of a family, or rather in a bucket of planes: it stays at `at` across its
/// own direction and runs from low across the other one.
struct PlaneRecord {
  std::uint32_t plane;  ///< equal for segments of one plane only
  std::int32_t at;
  std::int32_t low;
  std::uint32_t run;
  /// The number at the high end fits, the run need not without a sign.
  std::int32_t high() const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(low) + run);
  }
};

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
    __builtin_prefetch(end + 4, 1);
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
      const auto address = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p); };
      for (const PlaneRecord* record = begin; record != end; ++record) {
        // The next chunk is wherever there was room when this one was full.
        const auto same_in_next = address(chunk->next) + (address(record) - address(chunk));
        __builtin_prefetch(reinterpret_cast<const void*>(same_in_next));
        visit(*record);
      }
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
  __attribute__((noinline)) PlaneRecord* append_chunk(std::size_t bucket) {
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
