#pragma once

#include <cstdint>

#include "ar3d/base/long_vector.h"
#include "ar3d/base/random.h"

namespace ar3d {

/// A uniformly random permutation of 0..count-1. Up to 2^16 numbers: Fisher and Yates' shuffle with
/// the numbers of `random`. Above: every number is dealt to one of 2^k buckets, each equally
/// likely, and the buckets are shuffled (Rao 1961; Sandelius 1962); the streams of the chunks that
/// are dealt and of the buckets hang on one number of `random`, so the permutation is the same on
/// any number of threads.
/// @param count  at most 2^32 - 1.
/// Cost: O(count) time on all threads (threads_for), random access within a bucket only; 4 bytes a
/// number and at most 0.1 for the counts.
UnwrittenVector<std::uint32_t> random_permutation(std::uint64_t count, RandomStream& random);

/// A uniformly random perfect matching of 0..count-1, as the partner of each: neighbours in a
/// random permutation are matched.
/// @param count  even, at most 2^32 - 2.
/// Cost: as random_permutation, twice the memory while it runs.
UnwrittenVector<std::uint32_t> random_matching(std::uint64_t count, RandomStream& random);

}  // namespace ar3d
