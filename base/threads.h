#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace ar3d {

/// Threads that a loop over `items` small items is worth: those of OpenMP (OMP_NUM_THREADS), 1 for
/// fewer than 2^17 items and inside a parallel region, where the threads have other work. What is
/// computed never depends on the number.
int threads_for(std::uint64_t items);

/// Arrays from this size on get pages of 2 MiB where the system has them for the asking: far fewer
/// page faults, and random access misses the address cache less often.
inline constexpr std::size_t kLongArrayBytes = std::size_t{1} << 22;
/// Memory for `bytes` bytes, at least kLongArrayBytes. @throws std::bad_alloc.
void* allocate_long_array(std::size_t bytes);
void free_long_array(void* array) noexcept;

/// Leaves new elements of a vector as they are, for arrays whose elements are all written before
/// they are read: a long array then gets its memory where its threads write, not in one thread.
template <class T>
struct UnwrittenAllocator : std::allocator<T> {
  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T) ||
        count * sizeof(T) < kLongArrayBytes) {
      return std::allocator<T>::allocate(count);
    }
    return static_cast<T*>(allocate_long_array(count * sizeof(T)));
  }
  void deallocate(T* array, std::size_t count) noexcept {
    if (count * sizeof(T) < kLongArrayBytes) return std::allocator<T>::deallocate(array, count);
    free_long_array(array);
  }
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
