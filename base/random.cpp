// Random numbers come from Philox, which computes any number of a stream from its index. So loops
// on several threads draw the same numbers as one.
#include "ar3d/base/random.h"

#include <Random123/philox.h>

namespace ar3d {
namespace {
std::uint32_t low(std::uint64_t v) { return static_cast<std::uint32_t>(v); }
std::uint32_t high(std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); }
r123::Philox4x32::ctr_type philox(std::uint64_t key, std::uint64_t c0, std::uint64_t c1) {
  const r123::Philox4x32::ctr_type counter = {{low(c0), high(c0), low(c1), high(c1)}};
  const r123::Philox4x32::key_type words = {{low(key), high(key)}};
  return r123::Philox4x32()(counter, words);
}
}  // namespace

void RandomStream::refill() {
  const auto words = philox(seed_, next_block_++, stream_);
  for (unsigned i = 0; i < 4; ++i) block_[i] = words[i];
  used_ = 0;
}

void RandomStream::seek(std::uint64_t index) {
  next_block_ = index / 4;
  refill();
  used_ = static_cast<unsigned>(index % 4);
}

std::uint64_t RandomStream::below64(std::uint64_t bound) {
  if (bound <= 0xffffffffu) return below(static_cast<std::uint32_t>(bound));
  const std::uint64_t threshold = (0 - bound) % bound;  // 2^64 mod bound
  for (;;) {
    const std::uint64_t value = next64();
    if (value >= threshold) return value % bound;
  }
}

std::uint64_t mix_seed(std::uint64_t a, std::uint64_t b) {
  const auto words = philox(a, b, 0x61723364u);  // a stream number of its own
  return words[0] | (static_cast<std::uint64_t>(words[1]) << 32);
}

}  // namespace ar3d
