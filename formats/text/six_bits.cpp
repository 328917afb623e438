#include "ar3d/formats/text/six_bits.h"

#include <fmt/format.h>

namespace ar3d {
namespace {
constexpr unsigned kEscape = 63;  // the group '~': a longer form of N(n) follows
}

void SixBits::fail_group() const {
  if (left() == 0) input_->fail(column(), "the line ends too early");
  input_->fail(column(), fmt::format("character {} is not one of graph6 and sparse6 ('?' to '~')",
                                     shown(line_.substr(at_, 1))));
}

std::uint64_t SixBits::size() {
  std::uint64_t n = group();
  if (n < kEscape) return n;
  unsigned groups = 3;
  n = group();
  if (n == kEscape) {
    groups = 6;
    n = group();
  }
  for (unsigned i = 1; i < groups; ++i) n = (n << 6) | group();
  return n;
}

void append_size(std::string& out, std::uint64_t n) {
  unsigned groups = 1;
  if (n > 62) {
    out += '~';
    groups = 3;
  }
  if (n > 258047) {
    out += '~';
    groups = 6;
  }
  for (unsigned i = groups; i-- > 0;) out.push_back(static_cast<char>(63 + ((n >> (6 * i)) & 63)));
}

}  // namespace ar3d
