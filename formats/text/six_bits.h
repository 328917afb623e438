#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "ar3d/formats/text/text_input.h"

namespace ar3d {

/// The printable characters of a graph6 or sparse6 line as groups of 6 bits.
class SixBits {
 public:
  /// @param at  where in `line` the groups begin.
  SixBits(const TextInput& input, std::string_view line, std::size_t at)
      : input_(&input), line_(line), at_(at) {}

  std::size_t left() const { return line_.size() - at_; }
  std::size_t column() const { return at_ + 1; }  ///< of the next group, from 1
  /// The next group. @throws InputError at the end of the line or on any other byte than '?' to
  /// '~'.
  unsigned group() {
    const unsigned value = left() > 0 ? static_cast<unsigned char>(line_[at_]) - 63u : 64u;
    if (value >= 64) fail_group();
    ++at_;
    return value;
  }
  /// The next four groups as 24 bits, the first of them highest; false, and nothing is read, if
  /// there are fewer or one is no such character.
  bool four_groups(std::uint32_t& bits) {
    if (left() < 4) return false;
    std::uint32_t c = 0;
    std::memcpy(&c, line_.data() + at_, sizeof c);
    if constexpr (std::endian::native == std::endian::big) c = __builtin_bswap32(c);
    const bool below_128 = (c & 0x80808080u) == 0;
    const bool up_to_tilde = ((c + 0x01010101u) & 0x80808080u) == 0;
    const bool from_mark = ((c + 0x41414141u) & 0x80808080u) == 0x80808080u;  // from '?' = 63
    if (!below_128 || !up_to_tilde || !from_mark) return false;
    c -= 0x3f3f3f3fu;
    bits = (c & 63) << 18 | (c >> 8 & 63) << 12 | (c >> 16 & 63) << 6 | c >> 24;
    at_ += 4;
    return true;
  }
  /// The number of vertices, N(n) in the format's description; up to 36 bits.
  std::uint64_t size();
  const TextInput& input() const { return *input_; }

 private:
  [[noreturn]] void fail_group() const;

  const TextInput* input_;
  std::string_view line_;
  std::size_t at_;
};

/// Appends N(n).
void append_size(std::string& out, std::uint64_t n);

/// Appends bits to a text, six a character.
class SixBitWriter {
 public:
  explicit SixBitWriter(std::string& out) : out_(&out) {}
  void put(unsigned width, std::uint32_t value) {  // width <= 32
    held_ = (held_ << width) | value;
    count_ += width;
    while (count_ >= 6) {
      count_ -= 6;
      out_->push_back(static_cast<char>(63 + ((held_ >> count_) & 63)));
    }
  }
  /// Bits missing to a whole character.
  unsigned missing() const { return count_ == 0 ? 0 : 6 - count_; }

 private:
  std::string* out_;
  std::uint64_t held_ = 0;  // the low count_ bits wait; count_ < 6 between calls
  unsigned count_ = 0;
};

}  // namespace ar3d
