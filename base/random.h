#pragma once

#include <cstdint>
#include <span>
#include <utility>

namespace ar3d {

/// Returns a number that is uniform in [0, bound), bound >= 1 (Lemire's method with rejection).
/// @param next32  the next number of a stream.
template <class Next>
std::uint32_t uniform_below(std::uint32_t bound, const Next& next32) {
  std::uint64_t product = std::uint64_t{next32()} * bound;
  if (static_cast<std::uint32_t>(product) < bound) {
    const std::uint32_t threshold = (0u - bound) % bound;
    while (static_cast<std::uint32_t>(product) < threshold) {
      product = std::uint64_t{next32()} * bound;
    }
  }
  return static_cast<std::uint32_t>(product >> 32);
}

/// Represents a counter-based random stream (Philox 4x32-10): the numbers are a pure function of
/// (seed, stream, position), equal on every platform, compiler and thread count. Give every
/// independent use its own stream number.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0)
      : seed_(seed), stream_(stream) {}

  std::uint32_t next32() {
    if (used_ == 4) refill();
    return block_[used_++];
  }
  std::uint64_t next64() {
    const std::uint64_t low = next32();
    return low | (static_cast<std::uint64_t>(next32()) << 32);
  }
  std::uint32_t below(std::uint32_t bound) {
    return uniform_below(bound, [this] { return next32(); });
  }
  /// Returns a number that is uniform in [0, bound), bound >= 1.
  std::uint64_t below64(std::uint64_t bound);
  /// Returns true with probability numerator / denominator, exactly.
  bool chance(std::uint32_t numerator, std::uint32_t denominator) {
    return below(denominator) < numerator;
  }
  /// Returns a number that is uniform in [0, 1) with 53 bits.
  double unit() { return static_cast<double>(next64() >> 11) * 0x1.0p-53; }
  /// Permutes in place, uniformly (Fisher-Yates); fewer than 2^32 elements.
  template <class T>
  void shuffle(std::span<T> items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[below(static_cast<std::uint32_t>(i))]);
    }
  }
  /// Jumps to number `index` of the stream (in units of next32), for parallel loops.
  void seek(std::uint64_t index);

 private:
  void refill();

  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t next_block_ = 0;
  std::uint32_t block_[4] = {};
  unsigned used_ = 4;
};

/// Mixes two numbers into a seed (for seeds of instances, streams of repetitions, …).
std::uint64_t mix_seed(std::uint64_t a, std::uint64_t b);

}  // namespace ar3d
