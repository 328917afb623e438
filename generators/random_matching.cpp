// Permutations on all threads (Rao 1961; Sandelius 1962): numbers are dealt to buckets that fit a
// core's cache, then each bucket is shuffled. A plain Fisher-Yates shuffle waits for memory at
// every step once the numbers outgrow the cache.
#include "ar3d/generators/random_matching.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <vector>

#include "ar3d/base/parallel.h"

namespace ar3d {
namespace {

using Number = std::uint32_t;

constexpr std::uint64_t kMostInOneBucket = std::uint64_t{1} << 16;  // 256 KiB: fits a core's cache
constexpr unsigned kMostBucketBits = 12;
constexpr std::uint64_t kChunk = std::uint64_t{1} << 18;  // numbers dealt with one stream

/// Deals 0..count-1 to the buckets, in chunks with a stream each.
class NumberDealer {
 public:
  NumberDealer(std::uint64_t count, std::uint64_t seed)
      : count_(count),
        seed_(seed),
        bits_(std::min<unsigned>(kMostBucketBits, static_cast<unsigned>(std::bit_width(
                                                      (count - 1) / kMostInOneBucket)))),
        chunks_((count + kChunk - 1) / kChunk),
        places_(chunks_ << bits_) {}

  /// The numbers, those of a bucket side by side and each bucket shuffled.
  UnwrittenVector<Number> permutation() {
    UnwrittenVector<Number> numbers(count_);
    const std::uint32_t threads = threads_for(count_);
    for_each_in_threads(threads, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      deal(chunk, [](std::uint32_t& place, std::uint64_t) { ++place; });
    });
    turn_counts_into_places();
    for_each_in_threads(threads, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      deal(chunk, [&](std::uint32_t& place, std::uint64_t number) {
        numbers[place++] = static_cast<Number>(number);
      });
    });
    for_each_in_threads(threads, buckets(),
                        [&](std::uint32_t, std::uint64_t bucket) { shuffle(bucket, numbers); });
    return numbers;
  }

 private:
  std::uint64_t buckets() const { return std::uint64_t{1} << bits_; }
  /// Calls use(place of its bucket in this chunk, number) for each number of the chunk. A random
  /// word lasts for several buckets.
  template <class Use>
  void deal(std::uint64_t chunk, Use use) {
    std::uint32_t* const places = places_.data() + (chunk << bits_);
    RandomStream random(seed_, chunk);
    std::uint32_t word = 0;
    unsigned left = 0;
    const std::uint64_t end = std::min(count_, (chunk + 1) * kChunk);
    for (std::uint64_t number = chunk * kChunk; number < end; ++number) {
      if (left < bits_) {
        word = random.next32();
        left = 32;
      }
      use(places[word & (buckets() - 1)], number);
      word >>= bits_;
      left -= bits_;
    }
  }
  void turn_counts_into_places() {
    std::uint32_t place = 0;
    for (std::uint64_t bucket = 0; bucket < buckets(); ++bucket) {
      for (std::uint64_t chunk = 0; chunk < chunks_; ++chunk) {
        std::uint32_t& entry = places_[(chunk << bits_) + bucket];
        place += std::exchange(entry, place);
      }
    }
  }
  /// After all is dealt, the last chunk's place of a bucket is the bucket's end.
  void shuffle(std::uint64_t bucket, UnwrittenVector<Number>& numbers) const {
    const std::uint32_t* const ends = places_.data() + ((chunks_ - 1) << bits_);
    const std::uint64_t begin = bucket == 0 ? 0 : ends[bucket - 1];
    RandomStream random(seed_, chunks_ + bucket);
    random.shuffle(std::span<Number>(numbers.data() + begin, ends[bucket] - begin));
  }

  std::uint64_t count_;
  std::uint64_t seed_;
  unsigned bits_;
  std::uint64_t chunks_;
  std::vector<std::uint32_t> places_;  // of the next number, for each chunk and bucket
};

}  // namespace

UnwrittenVector<std::uint32_t> random_permutation(std::uint64_t count, RandomStream& random) {
  if (count > kMostInOneBucket) return NumberDealer(count, random.next64()).permutation();
  UnwrittenVector<Number> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  random.shuffle(std::span<Number>(numbers));
  return numbers;
}

UnwrittenVector<std::uint32_t> random_matching(std::uint64_t count, RandomStream& random) {
  const UnwrittenVector<Number> order = random_permutation(count, random);
  UnwrittenVector<Number> partner(count);
  for_ranges_in_threads(threads_for(count), count,
                        [&](std::uint32_t, std::uint64_t begin, std::uint64_t end) {
                          for (std::uint64_t i = begin; i < end; ++i) {
                            partner[order[i]] = order[i ^ 1];  // ranges begin with even numbers
                          }
                        });
  return partner;
}

}  // namespace ar3d
