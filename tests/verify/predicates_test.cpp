// Predicates in many arithmetics, and the range check that tells which of them are exact.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>
#include <string>
#include <type_traits>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/base/random.h"
#include "ar3d/verify/predicates/choices.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"
#include "ar3d/verify/predicates/widths.h"

std::string departures_with_fast_math();
std::string departures_with_contraction();
std::string departures_with_x87();

namespace ar3d::verify {
namespace {

using ::testing::HasSubstr;
using Big = boost::multiprecision::cpp_int;

const Lattice kSkewLattice{{{{2, 1, 0}, {1, 3, -1}, {0, -1, 5}}}, 1};

/// An integer that remembers the largest absolute value of all that were computed.
struct Recorded {
  static inline Big largest;
  Big value;

  Recorded() = default;
  template <class Integer>
  requires std::is_integral_v<Integer>
  explicit Recorded(Integer v) : value(v) { record(); }
  explicit Recorded(Big v) : value(std::move(v)) { record(); }
  void record() const {
    if (abs(value) > largest) largest = abs(value);
  }
  Recorded& operator+=(const Recorded& other) { return *this = Recorded(Big(value + other.value)); }
  Recorded operator-() const { return Recorded(Big(-value)); }
  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    return Recorded(Big(a.value + b.value));
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    return Recorded(Big(a.value - b.value));
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    return Recorded(Big(a.value * b.value));
  }
  friend bool operator==(const Recorded& a, const Recorded& b) { return a.value == b.value; }
  friend auto operator<=>(const Recorded& a, const Recorded& b) {
    return a.value.compare(b.value) <=> 0;
  }
  friend bool operator==(const Recorded& a, int b) { return a.value == b; }
  friend auto operator<=>(const Recorded& a, int b) { return a.value.compare(b) <=> 0; }
};

/// A vector at the ends of the reach.
Vector extreme(RandomStream& random, const Reach& reach) {
  const auto side = [&](std::uint64_t size) {
    const auto signed_size = static_cast<std::int64_t>(size);
    return std::array<std::int64_t, 5>{-signed_size, -1, 0, signed_size,
                                       signed_size}[random.below(5)];
  };
  return {side(reach.x), side(reach.y), side(reach.z)};
}

Reach random_reach(RandomStream& random, std::uint32_t most_bits) {
  const auto side = [&] { return (random.next64() >> (64 - 1 - random.below(most_bits))) | 1; };
  return {side(), side(), side()};
}

bool is_zero(Vector v) { return v == Vector{}; }

// Lemma V.5, both ways: no value passes the bits that the range check states, and some value needs
// nearly all of them.
TEST(RangeCheck, BoundsEveryValueOfTheAngle) {
  RandomStream random(1);
  for (const Lattice& lattice : {kCubeLattice, kScaledZLattice, kSkewLattice}) {
    for (int i = 0; i < 100; ++i) {
      const Reach reach = random_reach(random, 61);
      const Cosine cosine{-1, 1 + static_cast<std::int32_t>(random.below(3))};
      const int bits = predicate_bits(reach, lattice, cosine).angle;
      Recorded::largest = 0;
      for (int j = 0; j < 60; ++j) {
        const Vector u = extreme(random, reach), v = extreme(random, reach);
        if (is_zero(u) || is_zero(v)) continue;
        using cosine_comparison::converted;
        cosine_comparison::compare(lattice, converted<Recorded>(u), converted<Recorded>(v), cosine);
      }
      ASSERT_LT(Recorded::largest, Big(1) << bits);
      ASSERT_GE(Recorded::largest, Big(1) << (bits - (lattice == kSkewLattice ? 4 : 2)));
    }
  }
}

TEST(RangeCheck, BoundsEveryValueOfAMeeting) {
  RandomStream random(2);
  for (int i = 0; i < 200; ++i) {
    const Reach reach = random_reach(random, 58);
    const Reach between = random_reach(random, 58);
    const int bits = predicate_bits(reach, between, kCubeLattice, {}).meeting;
    Recorded::largest = 0;
    for (int j = 0; j < 200; ++j) {
      const Vector u = extreme(random, reach), v = extreme(random, reach);
      if (is_zero(u) || is_zero(v)) continue;
      const Point a, c = a + extreme(random, between);
      meeting_kind<Recorded>(a, a + u, c, c + v);
      // The point at s = 0 makes them meet, so that everything is computed.
      meeting_kind<Recorded>(a, a + u, a, a + v);
    }
    // Ends of the second segment are converted, too.
    const Big ends = Big(1) << 60;
    ASSERT_LT(Recorded::largest, std::max(Big(Big(1) << bits), ends)) << i;
    if (bits > 62) {
      ASSERT_GE(Recorded::largest, Big(1) << (bits - 3)) << i;
    }
  }
}

TEST(RangeCheck, BoundsHeights) {
  EXPECT_EQ(predicate_bits({1 << 10, 1 << 20, 1 << 30}, kCubeLattice, {}).height, 51);
  EXPECT_EQ(predicate_bits({(1 << 20) - 1, 1, (1 << 30) - 1}, kCubeLattice, {}).height, 50);
}

TEST(RangeCheck, ChoosesTheNarrowestIntegers) {
  EXPECT_EQ(width_of_bits(63), IntegerWidth::int64);
  EXPECT_EQ(width_of_bits(64), IntegerWidth::int128);
  EXPECT_EQ(width_of_bits(127), IntegerWidth::int128);
  EXPECT_EQ(width_of_bits(128), IntegerWidth::int256);
  // 6 r^3 for the triple product of segments at any place, 4 (2 r^2)^2 < 2^63 and so on.
  const Reach most{1 << 20, 1 << 20, 1 << 20};
  EXPECT_EQ(predicate_bits(most, most, kCubeLattice, {-1, 2}).meeting, 63);
  EXPECT_EQ(predicate_bits(most, kCubeLattice, {-1, 2}).meeting, 64);
  // 12 * 93 is above 2^10, 10 * 93 below it.
  for (const Reach& reach : {Reach{93, 1, 1}, Reach{1, 93, 1}, Reach{1, 1, 93}}) {
    EXPECT_EQ(predicate_bits(reach, kCubeLattice, {}).meeting, 11);
  }
}

Vector random_vector(RandomStream& random, int bits) {
  const auto side = [&] {
    const auto size = static_cast<std::int64_t>(random.next64() >> (64 - bits));
    return random.chance(1, 2) ? size : -size;
  };
  return {side(), side(), side()};
}

// Each at its limit and one bit beyond it: int64 is taken only where it is exact.
TEST(AngleComparisons, AgreeWithThoseOfWideIntegers) {
  RandomStream random(3);
  for (const Lattice& lattice : {kCubeLattice, kScaledZLattice, kSkewLattice}) {
    for (const Cosine cosine : {Cosine{-1, 2}, Cosine{-1, 3}, Cosine{0, 1}, Cosine{1, 1}}) {
      const AngleComparison compare(lattice, cosine);
      ASSERT_GT(compare.room(), 20);
      for (int i = 0; i < 3000; ++i) {
        const int a = 1 + static_cast<int>(random.below(30));
        const int b = std::max(1, compare.room() - a + static_cast<int>(random.below(3)) - 1);
        const Vector u = random_vector(random, a);
        const Vector v =
            random.chance(1, 4) ? (random.chance(1, 2) ? u : -u) : random_vector(random, b);
        if (is_zero(u) || is_zero(v)) continue;
        ASSERT_EQ(compare(u, v), compare_cosine(lattice, u, v, cosine))
            << to_string(u) << to_string(v);
      }
    }
  }
}

/// Segments of which every second one meets, touches or misses by one step, their lengths of so
/// many bits.
std::array<Point, 4> near_meeting(RandomStream& random, int bits) {
  const Point at{};
  const Vector u = random_vector(random, bits - 1), v = random_vector(random, bits - 1);
  const auto some = [&] { return static_cast<std::int64_t>(random.below(2)); };
  std::array<Point, 4> points{at + -u, at + some() * u, at + -v, at + some() * v};
  if (random.chance(1, 4)) points[3] = points[3] + Vector{0, 0, 1};
  if (random.chance(1, 4)) points[2] = points[0] + u, points[3] = points[1] + u;
  return points;
}

TEST(MeetingKinds, AgreeInEveryWidthThatTheRangeCheckProves) {
  RandomStream random(4);
  std::size_t proved = 0, not_proved = 0, meetings = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto [a, b, c, d] = near_meeting(random, 2 + static_cast<int>(random.below(58)));
    if (a == b || c == d) continue;
    Reach segments, between;
    segments.add(b - a);
    segments.add(d - c);
    between.add(c - a);
    const PredicateBits bits = predicate_bits(segments, between, kCubeLattice, {});
    const MeetingKind kind = meeting_kind_in(IntegerWidth::int256, a, b, c, d);
    meetings += kind != MeetingKind::nothing;
    ASSERT_EQ(meeting_kind_in(width_of_bits(bits.meeting), a, b, c, d), kind);
    // Doubles hold the ends here where they hold the bits.
    for (const PredicateChoice& choice : predicate_choices()) {
      const bool is_proved = bits.meeting <= choice.exact_bits;
      (is_proved ? proved : not_proved) += 1;
      if (is_proved) {
        ASSERT_EQ(choice.meeting(a, b, c, d), kind) << choice.name;
      }
    }
  }
  EXPECT_GT(meetings, 5000u);
  EXPECT_GT(proved, 50000u);
  EXPECT_GT(not_proved, 20000u);
}

/// Two vectors at exactly 120 degrees on the tall lattice, or one step from that.
std::array<Vector, 2> near_120(RandomStream& random, int bits) {
  const auto r = static_cast<std::int64_t>(random.next64() >> (64 - bits)) | 1;
  std::array<Vector, 2> pair{Vector{r, 0, r}, Vector{0, 0, -r}};  // <u,v> = -r^2, 4 r^2 and r^2
  if (random.chance(1, 2)) pair[0].z += random.chance(1, 2) ? 1 : -1;
  return pair;
}

struct Wrong {
  std::size_t proved = 0, beyond = 0;
};

Wrong wrong_angles(const PredicateChoice& choice) {
  RandomStream random(5);
  Wrong wrong;
  for (int i = 0; i < 4000; ++i) {
    const auto [u, v] = near_120(random, 2 + static_cast<int>(random.below(50)));
    Reach reach;
    reach.add(u);
    reach.add(v);
    const bool is_proved =
        predicate_bits(reach, kScaledZLattice, {-1, 2}).angle <= choice.exact_bits;
    // Undefined beyond.
    if (!is_proved && choice.exact_bits >= kInt64Bits && choice.name[0] == 'i') continue;
    const Point at{1, -2, 3};
    const auto order = choice.angle(kScaledZLattice, at + u, at, at + v, {-1, 2});
    const bool is_right = order == compare_cosine(kScaledZLattice, u, v, {-1, 2});
    (is_proved ? wrong.proved : wrong.beyond) += !is_right;
  }
  return wrong;
}

TEST(AnglePredicates, AreRightWhereProvedAndWrongBeyond) {
  for (const PredicateChoice& choice : predicate_choices()) {
    const Wrong wrong = wrong_angles(choice);
    EXPECT_EQ(wrong.proved, 0u) << choice.name;
    // Squares of lengths are squares here, so that the textbook's roots are exact.
    const bool rounds =
        choice.name == "float" || choice.name == "double" || choice.name == "binary80";
    EXPECT_EQ(choice.name == "binary80", choice.exact_bits == 64) << choice.name;
    EXPECT_EQ(wrong.beyond > 0, rounds) << choice.name;
  }
}

// 1 / (sqrt(2) sqrt(2)) is not 1/2 in double: the formula decides, not the type.
TEST(AnglePredicates, TheTextbookFormulaIsWrongForTheSmallestAngles) {
  const Point u{1, 1, 0}, v{-1, 0, 1};
  EXPECT_EQ(compare_cosine(kCubeLattice, u - Point{}, v - Point{}, {-1, 2}),
            std::strong_ordering::equal);
  EXPECT_NE(predicate_choice("cosine").angle(kCubeLattice, u, {}, v, {-1, 2}),
            std::strong_ordering::equal);
  EXPECT_EQ(predicate_choice("float").angle(kCubeLattice, u, {}, v, {-1, 2}),
            std::strong_ordering::equal);
}

// A filter says nothing about what is exactly on the border, and never errs.
TEST(Filters, DecideOnlyWhatTheirErrorAllows) {
  RandomStream random(6);
  std::size_t decided = 0, open = 0, apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const int bits = 2 + static_cast<int>(random.below(58));
    const auto [u, v] = near_120(random, bits);
    const Point at{};
    const auto order = filtered_angle(kScaledZLattice, at + u, at, at + v, {-1, 2});
    const auto exact = compare_cosine(kScaledZLattice, u, v, {-1, 2});
    (order ? decided : open) += 1;
    ASSERT_EQ(order.value_or(exact), exact);
    if (exact == std::strong_ordering::equal) {
      ASSERT_FALSE(order.has_value());
    }
    const auto [a, b, c, d] = near_meeting(random, bits);
    if (a == b || c == d || !surely_skew({a, b - a}, {c, d - c})) continue;
    ++apart;
    ASSERT_EQ(meeting_kind_in(IntegerWidth::int256, a, b, c, d), MeetingKind::nothing);
  }
  EXPECT_GT(decided, 1000u);
  EXPECT_GT(open, 1000u);
  EXPECT_GT(apart, 1000u);
}

TEST(Arithmetic, IsRoundedOnceAsItIsWritten) {
  EXPECT_EQ(two_bend_paper::arithmetic_departures(), "");
}

#ifdef __x86_64__
TEST(Arithmetic, FastMathContractionAndExcessPrecisionAreNoticed) {
  EXPECT_THAT(departures_with_fast_math(), HasSubstr("double: reordering"));
#ifndef __clang__  // clang has no -mfpmath=387
  EXPECT_THAT(departures_with_x87(), HasSubstr("double: excess precision"));
#endif
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no fma";
  EXPECT_THAT(departures_with_contraction(), HasSubstr("double: contraction"));
}
#endif

}  // namespace
}  // namespace ar3d::verify
