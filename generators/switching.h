#pragma once

#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/graph_builder.h"

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

/// Least n for which the default limits below are proved to work (for d <= 4).
inline constexpr Count kLeastSwitchingSize = 200;

/// A uniformly random labelled simple d-regular graph by switchings (McKay and Wormald 1990): one
/// pairing is drawn, and its few loops and double edges are switched away one after the other.
/// Exactly uniform, and one attempt nearly always suffices, where the pairing model with full
/// restart needs e^((d^2-1)/4) of them. The proof is in switching.cpp.
/// @return the edges (u, v), u < v, in order of u.
/// @param n  nd even and large enough for the limits (n >= kLeastSwitchingSize for the default
/// ones).
/// @param most_loops,most_doubles  a pairing with more loops or double edges is thrown away; both
/// keep the lower bounds of the proof positive.
/// @throws InternalError if n is too small for the limits.
/// Cost: O(n) expected time on all threads (threads_for); 4 nd bytes for the points' order (freed
/// before the edges are made) and 4 nd for the partners. The edges do not depend on the number of
/// threads.
std::vector<Edge> random_regular_by_switching(Count n, std::uint32_t d, RandomStream& random,
                                              Count most_loops = 8, Count most_doubles = 12);

}  // namespace ar3d
