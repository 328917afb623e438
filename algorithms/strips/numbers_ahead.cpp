// Random numbers in advance (Philox 4x32-10, base/random.h), for the cells that narrow strips try
// under Lemmas C.3 to C.5. A block is a pure function of its number, so eight of them are made side
// by side: in 64-bit lanes the two products of a round are one instruction for four blocks. Cost: 8
// instructions per number with AVX2.
#include "ar3d/algorithms/strips/numbers_ahead.h"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

namespace ar3d::strips {

void make_blocks_plainly(std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                         std::uint32_t* numbers) {
  RandomStream random(seed, stream);
  random.seek(4 * first);
  for (std::size_t i = 0; i < 32; ++i) numbers[i] = random.next32();
}

#if defined(__x86_64__) && defined(__GNUC__)
namespace {

__attribute__((target("avx2"))) inline __m256i same(std::uint64_t word) {
  return _mm256_set1_epi64x(static_cast<long long>(word));
}

/// Four blocks; the words of a block's counter in the low halves of its lanes.
__attribute__((target("avx2"))) void make_four_blocks(std::uint64_t seed, std::uint64_t stream,
                                                      std::uint64_t first, std::uint32_t* numbers) {
  __m256i a = _mm256_add_epi64(same(first), _mm256_set_epi64x(3, 2, 1, 0));
  __m256i b = _mm256_srli_epi64(a, 32);
  __m256i c = same(stream);
  __m256i d = same(stream >> 32);
  __m256i key_a = same(seed);
  __m256i key_c = same(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const __m256i p = _mm256_mul_epu32(a, same(0xd2511f53u));
    const __m256i q = _mm256_mul_epu32(c, same(0xcd9e8d57u));
    a = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(q, 32), b), key_a);
    c = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(p, 32), d), key_c);
    b = q;
    d = p;
    key_a = _mm256_add_epi32(key_a, same(0x9e3779b9u));
    key_c = _mm256_add_epi32(key_c, same(0xbb67ae85u));
  }
  const __m256i ab = _mm256_blend_epi32(a, _mm256_slli_epi64(b, 32), 0xaa);
  const __m256i cd = _mm256_blend_epi32(c, _mm256_slli_epi64(d, 32), 0xaa);
  const __m256i even = _mm256_unpacklo_epi64(ab, cd);  // blocks 0 and 2
  const __m256i odd = _mm256_unpackhi_epi64(ab, cd);   // blocks 1 and 3
  auto* out = reinterpret_cast<__m256i*>(numbers);
  _mm256_storeu_si256(out, _mm256_permute2x128_si256(even, odd, 0x20));
  _mm256_storeu_si256(out + 1, _mm256_permute2x128_si256(even, odd, 0x31));
}

const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;

}  // namespace
#endif

void make_blocks(std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                 std::uint32_t* numbers) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (kHasAvx2) {
    make_four_blocks(seed, stream, first, numbers);
    make_four_blocks(seed, stream, first + 4, numbers + 16);
    return;
  }
#endif
  make_blocks_plainly(seed, stream, first, numbers);
}

void NumbersAhead::make_more() {
  std::copy(numbers_.begin() + static_cast<std::ptrdiff_t>(next_),
            numbers_.begin() + static_cast<std::ptrdiff_t>(end_), numbers_.begin());
  end_ -= next_;
  next_ = 0;
  for (std::size_t made = 0; made < made_at_once_; made += kBlocksAtOnce * kNumbersPerBlock) {
    make_blocks(seed_, stream_, next_block_, &numbers_[end_]);
    next_block_ += kBlocksAtOnce;
    end_ += kBlocksAtOnce * kNumbersPerBlock;
  }
  made_at_once_ = std::min(2 * made_at_once_, kMostMade);
}

}  // namespace ar3d::strips
