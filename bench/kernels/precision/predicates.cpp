// Wrong answers of predicates: as drawn, one unit beside, and where segments touch or nearly do.
// The questions are those of a drawing, and harder ones made of them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <compare>
#include <string>
#include <utility>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/ieee_arithmetic.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/predicates/choices.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

using kernels::random_family;
using verify::PredicateChoice;

constexpr std::size_t kMost = 20000;
constexpr std::array<const char*, 4> kChoices = {"float", "double", kLongDouble, "cosine"};

using Segment = std::array<Point, 2>;

Box box_of(const Segment& s) {
  GrowingBox box;
  box.add(s[0]);
  box.add(s[1]);
  return box.box();
}

bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

void add_pairs(std::vector<Segment> segments, std::size_t most, Decisions& decisions) {
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    return std::min(a[0].z, a[1].z) < std::min(b[0].z, b[1].z);
  });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i < 200 ? 0 : i - 200; j < i; ++j) {
      if (decisions.pairs.size() == most) return;
      const Segment &s = segments[j], &t = segments[i];
      if (boxes_meet(box_of(s), box_of(t))) decisions.pairs.push_back({s[0], s[1], t[0], t[1]});
    }
  }
}

/// Every k-th, so that at most so many are left.
void thin(std::vector<std::array<Point, 3>>& angles, std::size_t most) {
  if (angles.size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) angles[i] = angles[i * (angles.size() / most)];
  angles.resize(most);
}

std::int64_t& any_coordinate(Point& p, RandomStream& random) {
  const std::uint32_t axis = random.below(3);
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// Is the angle as promised: by P1 if all must be equal, else by P2?
bool keeps(const Guarantee& guarantee, std::strong_ordering order) {
  return guarantee.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
}

/// The angles, one coordinate of one end moved by one unit.
std::vector<Angle> one_off(std::vector<Angle> angles) {
  RandomStream random(1);
  for (auto& angle : angles) {
    any_coordinate(angle[0], random) += random.chance(1, 2) ? 1 : -1;
  }
  std::erase_if(angles, [](const auto& angle) { return angle[0] == angle[1]; });
  return angles;
}

/// The pairs, the second segment moved so that an end of it falls on an end of the first, or one
/// unit beside.
std::vector<SegmentPair> touching(std::vector<SegmentPair> pairs) {
  RandomStream random(2);
  for (auto& [a, b, c, d] : pairs) {
    const Vector move = (random.chance(1, 2) ? a : b) - (random.chance(1, 2) ? c : d);
    c = c + move;
    d = d + move;
    if (random.chance(1, 2)) {
      std::int64_t& coordinate = any_coordinate(c, random);
      coordinate += random.chance(1, 2) ? 1 : -1;
    }
  }
  std::erase_if(pairs, [](const auto& pair) { return pair[2] == pair[3]; });
  return pairs;
}

/// Wrong answers to "is this angle as promised": exactly the optimum, or at least that.
std::uint64_t wrong_angles(const PredicateChoice& choice, const Guarantee& guarantee,
                           const std::vector<Angle>& angles) {
  std::uint64_t wrong = 0;
  for (const auto& [from, at, to] : angles) {
    const auto order = choice.angle(guarantee.lattice, from, at, to, guarantee.cosine);
    const auto exact = compare_cosine(guarantee.lattice, from - at, to - at, guarantee.cosine);
    wrong += keeps(guarantee, order) != keeps(guarantee, exact);
  }
  return wrong;
}

/// Wrong answers to "do these segments meet".
std::uint64_t wrong_meetings(const PredicateChoice& choice, const std::vector<SegmentPair>& pairs) {
  std::uint64_t wrong = 0;
  for (const auto& [a, b, c, d] : pairs) {
    const auto exact = verify::meeting_kind_in(verify::IntegerWidth::int256, a, b, c, d);
    wrong += (choice.meeting(a, b, c, d) == verify::MeetingKind::nothing) !=
             (exact == verify::MeetingKind::nothing);
  }
  return wrong;
}

std::vector<std::string> row_of(const Algorithm& algorithm, std::uint64_t n, int bits,
                                const char* what) {
  return {fmt::format("`{}`", algorithm.name), fmt::format("{}", n), what, fmt::format("{}", bits)};
}

void add_rows(const Algorithm& algorithm, std::uint64_t n,
              std::vector<std::vector<std::string>>& rows,
              std::vector<std::vector<std::string>>& filters) {
  const Guarantee& guarantee = algorithm.guarantee;
  const Decisions decisions =
      decisions_of(draw(algorithm, generate(random_family(algorithm), n, 1)), guarantee, kMost);
  const auto near_angles = one_off(decisions.angles);
  const auto near_pairs = touching(decisions.pairs);
  auto drawn = row_of(algorithm, n, decisions.bits.angle, "angle as drawn");
  auto off = row_of(algorithm, n, decisions.bits.angle, "angle, one unit off");
  auto touch = row_of(algorithm, n, decisions.bits.meeting, "touching or one off");
  for (const char* name : kChoices) {
    const PredicateChoice& choice = verify::predicate_choice(name);
    drawn.push_back(
        rate(wrong_angles(choice, guarantee, decisions.angles), decisions.angles.size()));
    off.push_back(rate(wrong_angles(choice, guarantee, near_angles), near_angles.size()));
    touch.push_back(rate(wrong_meetings(choice, near_pairs), near_pairs.size()));
  }
  rows.insert(rows.end(), {drawn, off, touch});
  std::uint64_t open_angles = 0, open_pairs = 0;
  for (const auto& [from, at, to] : decisions.angles) {
    open_angles += !verify::filtered_angle(guarantee.lattice, from, at, to, guarantee.cosine);
  }
  for (const auto& [a, b, c, d] : decisions.pairs) {
    open_pairs += !verify::surely_skew({a, b - a}, {c, d - c});
  }
  filters.push_back({fmt::format("`{}`", algorithm.name), fmt::format("{}", n),
                     rate(open_angles, decisions.angles.size()),
                     rate(open_pairs, decisions.pairs.size())});
}

}  // namespace

Decisions decisions_of(const Drawing& drawing, const Guarantee& guarantee, std::size_t most) {
  Decisions decisions;
  std::vector<std::vector<Point>> stars(drawing.num_vertices());
  std::vector<Segment> segments;
  verify::Reach reach;
  const auto add = [&](Point from, Point at, Point to) {
    decisions.angles.push_back({from, at, to});
  };
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      segments.push_back({points[i - 1], points[i]});
      reach.add(points[i] - points[i - 1]);
      if (i > 1) add(points[i - 2], points[i - 1], points[i]);
    }
    stars[drawing.edge(e).u].push_back(points[1]);
    stars[drawing.edge(e).v].push_back(points[points.size() - 2]);
  });
  for (std::size_t v = 0; v < stars.size(); ++v) {
    for (std::size_t i = 1; i < stars[v].size(); ++i) {
      add(stars[v][i - 1], drawing.vertex(static_cast<Vertex>(v)), stars[v][i]);
    }
  }
  decisions.bits = verify::predicate_bits(reach, guarantee.lattice, guarantee.cosine);
  thin(decisions.angles, most);
  add_pairs(std::move(segments), most, decisions);
  return decisions;
}

void predicate_tables() {
  std::vector<std::vector<std::string>> rows, filters;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    const Algorithm& algorithm = find_algorithm(name);
    for (const std::uint64_t n : {100u, 1000u, 10000u}) add_rows(algorithm, n, rows, filters);
    if (algorithm.name != "two-bend") continue;
    for (const std::uint64_t n : {30000u, 100000u}) add_rows(algorithm, n, rows, filters);
  }
  fmt::print("Wrong answers, percent with 95 % Wilson intervals:\n\n");
  print_table(
      {"algorithm", "n", "question", "bits", "float", "double", kLongDouble, "cosine in double"},
      rows);
  fmt::print("What the filter leaves to exact integers:\n\n");
  print_table({"algorithm", "n", "angles as drawn", "pairs with meeting boxes"}, filters);
}

}  // namespace ar3d::precision
