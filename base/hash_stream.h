#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

struct XXH3_state_s;  // of xxhash.h, which a user of the installed package need not have

namespace ar3d {

/// Hashes a sequence of integers, fed little endian, by 128-bit XXH3: equal on all platforms.
class HashStream {
 public:
  HashStream();
  ~HashStream();
  HashStream(const HashStream&) = delete;
  HashStream& operator=(const HashStream&) = delete;

  void put(std::uint32_t value) { append(value); }
  void put(std::uint64_t value) { append(value); }
  void put(std::int64_t value) { append(static_cast<std::uint64_t>(value)); }
  void put(const std::array<std::int64_t, 3>& values) { append(values); }
  /// Integers as they stand in the memory.
  void put(std::span<const std::byte> bytes);

  /// Returns 32 hexadecimal digits.
  std::string digest();

 private:
  // A call of the library costs more than hashing a number: numbers are gathered first.
  template <class Integers>
  void append(const Integers& value) {
    if (sizeof value > buffer_.size() - used_) flush();
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(buffer_.data() + used_, &value, sizeof value);
    used_ += sizeof value;
  }
  void flush();

  XXH3_state_s* state_ = nullptr;
  std::size_t used_ = 0;
  std::array<unsigned char, 4096> buffer_;
};

}  // namespace ar3d
