// Memory for long arrays. They ask for pages of 2 MiB, and arrays that one drawing frees serve the
// next one: these then need no fresh memory, which the system would have to clear.
#include "ar3d/base/long_vector.h"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace ar3d {
namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;

// Arrays that nothing uses; null: no LongArrayReuse lives.
thread_local std::vector<void*>* spares = nullptr;

/// The smallest spare array of at least so many bytes and at most twice as many; null if none is.
void* take_spare(std::size_t bytes) {
  auto best = spares->end();
  std::size_t least = 2 * bytes + 2;
  for (auto spare = spares->begin(); spare != spares->end(); ++spare) {
    const std::size_t size = malloc_usable_size(*spare);
    if (size < bytes || size >= least) continue;
    best = spare;
    least = size;
  }
  if (best == spares->end()) return nullptr;
  std::swap(*best, spares->back());
  void* const array = spares->back();
  spares->pop_back();
  return array;
}

}  // namespace

void advise_long_array(void* array, std::size_t bytes) {
  if (bytes < kLongArrayBytes) return;
  // Whole pages inside the array only; the advice takes addresses that are multiples of 4 KiB.
  const auto begin = (reinterpret_cast<std::uintptr_t>(array) + kPage - 1) / kPage * kPage;
  const auto end = (reinterpret_cast<std::uintptr_t>(array) + bytes) / kPage * kPage;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded up to a page
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

void* allocate_long_array(std::size_t bytes) {
  if (spares != nullptr) {
    if (void* const array = take_spare(bytes)) return array;
  }
  const bool fills_pages = bytes >= kPage / 2;
  void* const array = fills_pages ? std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage)
                                  : std::malloc(bytes);
  if (array == nullptr) throw std::bad_alloc();
  // The last page costs what it holds, or is at least half full.
  if (fills_pages) madvise(array, (bytes + kPage / 2) / kPage * kPage, MADV_HUGEPAGE);
  return array;
}

void free_long_array(void* array) noexcept {
  // Within the room that was reserved, so nothing is thrown.
  if (spares == nullptr || spares->size() == spares->capacity()) return std::free(array);
  spares->push_back(array);
}

LongArrayReuse::LongArrayReuse() : is_outermost_(spares == nullptr) {
  constexpr std::size_t kMost = 64;
  if (!is_outermost_) return;
  auto room = std::make_unique<std::vector<void*>>();
  room->reserve(kMost);
  spares = room.release();
}

LongArrayReuse::~LongArrayReuse() {
  if (!is_outermost_) return;
  for (void* const array : *spares) std::free(array);
  delete spares;
  spares = nullptr;
}

}  // namespace ar3d
