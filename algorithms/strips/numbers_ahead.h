#pragma once

#include <array>
#include <cstdint>

#include "ar3d/base/random.h"

namespace ar3d::strips {

/// The numbers of RandomStream(seed, stream), made many at a time before they are used. Who looks
/// at several of them may go on behind whichever it takes, as if it had drawn them one by one.
class NumbersAhead {
 public:
  explicit NumbersAhead(std::uint64_t seed, std::uint64_t stream = 0)
      : seed_(seed), stream_(stream) {}

  static constexpr std::size_t kMostAhead = 64;
  /// The next `count` numbers, at most kMostAhead; they stand there until the next call.
  const std::uint32_t* ahead(std::size_t count) {
    if (end_ - next_ < count) make_more();
    return &numbers_[next_];
  }
  /// Goes on behind the first `count` of the numbers that ahead() showed.
  void skip(std::size_t count) { next_ += count; }

  std::uint32_t next32() {
    const std::uint32_t number = *ahead(1);
    skip(1);
    return number;
  }
  /// RandomStream::below.
  std::uint32_t below(std::uint32_t bound) {
    return uniform_below(bound, [this] { return next32(); });
  }

 private:
  static constexpr std::size_t kNumbersPerBlock = 4;
  static constexpr std::size_t kBlocksAtOnce = 8;
  static constexpr std::size_t kMostMade = 1024;
  void make_more();

  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t next_block_ = 0;
  std::size_t made_at_once_ = kMostAhead;  ///< doubled up to kMostMade: small graphs need few
  std::size_t next_ = 0;
  std::size_t end_ = 0;
  std::array<std::uint32_t, kMostAhead + kMostMade> numbers_;
};

/// The numbers of blocks `first` to `first` + 7 of RandomStream(seed, stream), four to a block;
/// several at a time on processors that have AVX2.
void make_blocks(std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                 std::uint32_t* numbers);
/// The same, on every processor.
void make_blocks_plainly(std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                         std::uint32_t* numbers);

}  // namespace ar3d::strips
