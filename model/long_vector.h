#pragma once

#include <cstddef>
#include <vector>

namespace ar3d {

/// Asks for pages of 2 MiB for memory that is about to be written, if it is long enough
/// (kLongArrayBytes). Advice: may be refused.
void advise_long_array(void* array, std::size_t bytes);

/// vector.reserve(count) with pages as for an UnwrittenVector.
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

}  // namespace ar3d
