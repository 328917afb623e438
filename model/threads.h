#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ar3d {

/// Threads that a loop over `items` small items is worth: those of OpenMP (OMP_NUM_THREADS), 1 for
/// fewer than 2^17 items and inside a parallel region, where the threads have other work. What is
/// computed never depends on the number.
int threads_for(std::uint64_t items);

/// Leaves new elements of a vector as they are, for arrays whose elements are all written before
/// they are read: a long array then gets its memory where its threads write, not in one thread.
template <class T>
struct UnwrittenAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnwrittenAllocator<U>;
  };
  template <class U>
  void construct(U*) noexcept {}
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};
template <class T>
using UnwrittenVector = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace ar3d
