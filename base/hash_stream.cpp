// Integers are collected in a buffer and hashed by XXH3 many at a time, which is what XXH3 is made
// for.
#include "ar3d/base/hash_stream.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace ar3d {

HashStream::HashStream() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state_);
}

HashStream::~HashStream() { XXH3_freeState(state_); }

void HashStream::put(std::span<const std::byte> bytes) {
  if (bytes.size() > buffer_.size() - used_) flush();
  if (bytes.size() > buffer_.size()) {
    XXH3_128bits_update(state_, bytes.data(), bytes.size());
    return;
  }
  std::memcpy(buffer_.data() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
}

void HashStream::flush() {
  XXH3_128bits_update(state_, buffer_.data(), used_);
  used_ = 0;
}

std::string HashStream::digest() {
  flush();
  const XXH128_hash_t hash = XXH3_128bits_digest(state_);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace ar3d
