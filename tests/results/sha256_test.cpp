#include "ar3d/results/sha256.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ar3d {
namespace {

// Examples of FIPS 180-4 and NIST's test vectors.
TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Every length around a block's end pads in its own way; expected values from coreutils' sha256sum.
TEST(Sha256, LengthsAroundABlock) {
  const std::vector<std::pair<std::size_t, std::string>> known = {
      {55, "d5e285683cd4efc0"}, {56, "04c26261370ee754"}, {63, "75220b47218278e6"},
      {64, "7ce100971f64e700"}, {65, "9537c5fdf120482f"}, {119, "000b48d4edf0fa7b"},
      {120, "13f05a0b594787f5"}};
  for (const auto& [length, digits] : known) {
    EXPECT_EQ(sha256(std::string(length, 'x')).substr(0, 16), digits) << length;
  }
}

}  // namespace
}  // namespace ar3d
