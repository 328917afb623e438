#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

const std::string kSymmetric = "%%MatrixMarket matrix coordinate pattern symmetric\n";
const std::string kGeneral = "%%MatrixMarket matrix coordinate pattern general\n";

TEST(MatrixMarket, ReadsSymmetricAndGeneral) {
  const Graph expected(4, {{1, 0}, {2, 1}});
  const std::vector<Graph> graphs = read_text(kSymmetric + "% comment\n\n4 4 2\n2 1\n3 2\n" +
                                              "%%matrixmarket MATRIX Coordinate Pattern GENERAL\n" +
                                              "4 4 4\n2 1\n1 2\n2 3\n% inside\n3 2\n");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(expected));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(expected));
}

TEST(MatrixMarket, RefusesOtherMatrices) {
  EXPECT_EQ(refusal("%%MatrixMarket matrix array real general\n"),
            "f:1:23: only 'coordinate' is supported here, found 'array'");
  EXPECT_EQ(refusal("%%MatrixMarket matrix coordinate real symmetric\n"),
            "f:1:34: only 'pattern' is supported here, found 'real'");
  EXPECT_EQ(refusal("%%MatrixMarket matrix coordinate pattern skew-symmetric\n"),
            "f:1:42: only 'symmetric' and 'general' are supported here, found 'skew-symmetric'");
  EXPECT_EQ(refusal(kSymmetric + "3 4 0\n"),
            "f:2:3: a graph's matrix is square, this one is 3 by 4");
  EXPECT_EQ(refusal(kGeneral + "3 3 3\n2 1\n1 2\n3 1\n"),
            "f:5: (3, 1) stands without its counterpart");
  EXPECT_EQ(refusal(kGeneral + "3 3 3\n1 3\n2 1\n1 2\n"),
            "f:3: (1, 3) stands without its counterpart");
}

TEST(MatrixMarket, RefusesWithPlaceAndValue) {
  EXPECT_EQ(refusal(kSymmetric), "f:1: the text ends before the line with the sizes");
  EXPECT_EQ(refusal(kSymmetric + "3 3\n"),
            "f:2:4: expected a number of entries, found the end of the line");
  EXPECT_EQ(refusal(kSymmetric + "3 3 2\n2 1\n"),
            "f:3: the text ends after 1 of 2 announced entries");
  EXPECT_EQ(refusal(kSymmetric + "3 3 1\n2 1\n3 1\n"),
            "f:4:1: expected '%%MatrixMarket', found '3 1'");
  EXPECT_EQ(refusal(kSymmetric + "3 3 1\n4 1\n"),
            "f:3:1: vertex id 4 is out of range, the graph has 3 vertices");
  EXPECT_EQ(refusal(kSymmetric + "3 3 1\n1 0\n"),
            "f:3:3: vertex id 0 is below 1, the smallest here");
  EXPECT_EQ(refusal(kSymmetric + "3 3 1\n2 2\n"), "f:3:3: edge (2, 2) is a loop");
  EXPECT_EQ(refusal(kSymmetric + "3 3 2\n2 1\n1 2\n"),
            "f:4: edge (1, 2) is parallel to an earlier edge");
  EXPECT_EQ(refusal(kSymmetric + "3 3 1\n2 1 0.5\n"), "f:3:5: unexpected '0.5' after the entry");
  EXPECT_EQ(refusal(kGeneral + "3 3 4\n2 1\n1 2\n2 1\n1 2\n"), "f:6: (1, 2) stands twice");
}

TEST(MatrixMarket, RefusesAbsurdSizesWithoutAllocating) {
  EXPECT_EQ(refusal(kSymmetric + "4000000000 4000000000 0\n"),
            "f:2: 4000000000 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
  EXPECT_EQ(refusal(kSymmetric + "3 3 18446744073709551615\n2 1\n"),
            "f:3: the text ends after 1 of 18446744073709551615 announced entries");
}

}  // namespace
}  // namespace ar3d::testing
