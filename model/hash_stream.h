#pragma once

#include <cstdint>
#include <string>

struct XXH3_state_s;  // of xxhash.h, which a user of the installed package need not have

namespace ar3d {

/// 128-bit XXH3 hash of a sequence of integers, fed little endian: equal on all platforms.
class HashStream {
 public:
  HashStream();
  ~HashStream();
  HashStream(const HashStream&) = delete;
  HashStream& operator=(const HashStream&) = delete;

  void put(std::uint32_t value);
  void put(std::uint64_t value);
  void put(std::int64_t value) { put(static_cast<std::uint64_t>(value)); }

  /// 32 hexadecimal digits.
  std::string digest() const;

 private:
  XXH3_state_s* state_ = nullptr;
};

}  // namespace ar3d
