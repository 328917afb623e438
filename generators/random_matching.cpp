// Permutations on all threads (Rao 1961; Sandelius 1962): numbers are dealt to buckets that fit a
// core's cache, then each bucket is shuffled. A plain Fisher-Yates shuffle waits for memory at
// every step once the numbers outgrow the cache.
#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/base/parallel.h"
#include "ar3d/generators/switching.h"

namespace ar3d {
namespace {

using Number = std::uint32_t;

constexpr std::uint64_t kMostInOneBucket = std::uint64_t{1} << 16;  // 256 KiB: fits a core's cache
constexpr unsigned kMostBucketBits = 12;
constexpr std::uint64_t kChunk = std::uint64_t{1} << 18;  // numbers dealt with one stream

/// Deals 0..count-1 to the buckets, in chunks with a stream each: the numbers of a bucket come to
/// stand side by side. Then each bucket is shuffled.
UnwrittenVector<Number> permutation_by_buckets(std::uint64_t count, std::uint64_t seed) {
  const unsigned bits = std::min<unsigned>(
      kMostBucketBits, static_cast<unsigned>(std::bit_width((count - 1) / kMostInOneBucket)));
  const std::uint64_t buckets = std::uint64_t{1} << bits;
  const std::uint64_t chunks = (count + kChunk - 1) / kChunk;
  std::vector<std::uint32_t> indices(chunks << bits);  // of the next number, by chunk and bucket
  const std::uint32_t threads = threads_for(count);
  // Calls use(index of its bucket in its chunk, number) for each number. A random word lasts for
  // several of them.
  const auto deal = [&](auto use) {
    for_each_in_threads(threads, chunks, [&](std::uint32_t, std::uint64_t chunk) {
      std::uint32_t* const own = indices.data() + (chunk << bits);
      const std::uint32_t mask = (1u << bits) - 1;
      const unsigned width = bits;
      RandomStream random(seed, chunk);
      std::uint32_t word = 0;
      unsigned left = 0;
      const std::uint64_t end = std::min(count, (chunk + 1) * kChunk);
      for (std::uint64_t number = chunk * kChunk; number < end; ++number) {
        if (left < width) {
          word = random.next32();
          left = 32;
        }
        use(own[word & mask], number);
        word >>= width;
        left -= width;
      }
    });
  };
  deal([](std::uint32_t& index, std::uint64_t) { ++index; });
  std::uint32_t next = 0;
  for (std::uint64_t bucket = 0; bucket < buckets; ++bucket) {
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
      next += std::exchange(indices[(chunk << bits) + bucket], next);
    }
  }
  UnwrittenVector<Number> numbers(count);
  deal([&](std::uint32_t& index, std::uint64_t number) {
    numbers[index++] = static_cast<Number>(number);
  });
  // After all is dealt, the last chunk's index of a bucket is the bucket's end.
  const std::uint32_t* const ends = indices.data() + ((chunks - 1) << bits);
  for_each_in_threads(threads, buckets, [&](std::uint32_t, std::uint64_t bucket) {
    const std::uint64_t begin = bucket == 0 ? 0 : ends[bucket - 1];
    RandomStream random(seed, chunks + bucket);
    random.shuffle(std::span<Number>(numbers.data() + begin, ends[bucket] - begin));
  });
  return numbers;
}

}  // namespace

UnwrittenVector<std::uint32_t> random_permutation(std::uint64_t count, RandomStream& random) {
  if (count > kMostInOneBucket) return permutation_by_buckets(count, random.next64());
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
