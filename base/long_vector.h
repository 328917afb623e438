#pragma once

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace ar3d {

/// Tells from which size on arrays get pages of 2 MiB where the system has them for the asking: far
/// fewer page faults, and random access misses the address cache less often.
inline constexpr std::size_t kLongArrayBytes = std::size_t{1} << 22;
/// Returns memory for `bytes` bytes, at least kReusableBytes. @throws std::bad_alloc.
void* allocate_long_array(std::size_t bytes);
void free_long_array(void* array) noexcept;

/// Tells from which size on the memory of arrays can be used again (LongArrayReuse).
inline constexpr std::size_t kReusableBytes = std::size_t{1} << 19;

/// Allocates as std::allocator; arrays of kLeast bytes and more get pages of 2 MiB and can be used
/// again. Elements that are not initialised are all written before they are read: a long array then
/// gets its memory where its threads write, not in one thread.
template <class T, class Initialises>
struct LongAllocator : std::allocator<T> {
  static constexpr std::size_t kLeast = Initialises::value ? kReusableBytes : kLongArrayBytes;
  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T) || count * sizeof(T) < kLeast) {
      return std::allocator<T>::allocate(count);
    }
    return static_cast<T*>(allocate_long_array(count * sizeof(T)));
  }
  void deallocate(T* array, std::size_t count) noexcept {
    if (count * sizeof(T) < kLeast) return std::allocator<T>::deallocate(array, count);
    free_long_array(array);
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (Initialises::value || sizeof...(Arguments) > 0) {
      std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
  }
};
template <class T>
using UnwrittenVector = std::vector<T, LongAllocator<T, std::false_type>>;
template <class T>
using LongVector = std::vector<T, LongAllocator<T, std::true_type>>;

/// Asks for pages of 2 MiB for memory that is about to be written, if it is long enough
/// (kLongArrayBytes). Advice: may be refused.
void advise_long_array(void* array, std::size_t bytes);

/// Reserves as vector.reserve(count) does, with pages as for an UnwrittenVector.
template <class T>
void reserve_long(std::vector<T>& vector, std::size_t count) {
  if (count <= vector.capacity()) return;
  if (vector.empty()) {  // nothing to copy: the pages are asked for before they are touched
    vector.reserve(count);
    advise_long_array(vector.data(), vector.capacity() * sizeof(T));
    return;
  }
  std::vector<T> longer;
  reserve_long(longer, count);
  longer.insert(longer.end(), vector.begin(), vector.end());
  vector.swap(longer);
}

/// Keeps arrays from kReusableBytes on that its thread frees for its later ones, while it lives:
/// these then need no fresh memory, which the system would have to clear. An array is at most
/// twice as long as it was asked for. What nothing uses at the end is given back; arrays may
/// outlive it, and other threads may free them. Inside another one it does nothing.
class LongArrayReuse {
 public:
  LongArrayReuse();
  ~LongArrayReuse();
  LongArrayReuse(const LongArrayReuse&) = delete;
  LongArrayReuse& operator=(const LongArrayReuse&) = delete;

 private:
  bool is_outermost_;
};

}  // namespace ar3d
