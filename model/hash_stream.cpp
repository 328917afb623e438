#include "ar3d/model/hash_stream.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace ar3d {
namespace {

template <class Integer>
void feed(XXH3_state_t* state, Integer value) {
  unsigned char bytes[sizeof(Integer)];
  for (std::size_t i = 0; i < sizeof bytes; ++i) {
    bytes[i] = static_cast<unsigned char>(value >> (8 * i));
  }
  XXH3_128bits_update(state, bytes, sizeof bytes);
}

}  // namespace

HashStream::HashStream() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state_);
}

HashStream::~HashStream() { XXH3_freeState(state_); }

void HashStream::put(std::uint32_t value) { feed(state_, value); }

void HashStream::put(std::uint64_t value) { feed(state_, value); }

std::string HashStream::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace ar3d
