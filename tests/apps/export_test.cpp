// `ar3d draw` to the formats of other programs, from the command line.
#include "support/program.h"

namespace ar3d::testing {
namespace {

const char* const kExports[] = {"svg", "tikz", "vtp", "glb", "stl", "graphml"};

TEST(Export, HelpSaysWhatEachFormatKeeps) {
  const std::string help = run("{} draw --help").out;
  for (const std::string name : kExports) {
    EXPECT_THAT(help, ContainsRegex("\n  " + name + " +\\.[a-z]+.*: "));
  }
}

TEST(Export, BadInputIsOneLineAndWritesNothing) {
  const ScratchDirectory scratch;
  const auto expect_error = [&](const std::string& command, const std::string& why) {
    expect_one_line(run(command), why);
    EXPECT_TRUE(fs::is_empty(scratch.path(""))) << command;
  };
  for (const std::string name : kExports) {
    const std::string to = " --format " + name + " -o " + scratch.path("x");
    expect_error("printf 'C~\\nC~\\n' | {} draw - --algorithm grid" + to,
                 "<stdin>:2: a second graph, but format " + name + " holds one drawing per file");
    expect_error("printf 'D~{\\n' | {} draw - --algorithm grid" + to, "maximum degree 3");
    expect_error("printf 'C~\\n' | {} draw - --algorithm grid --format " + name + " -o " +
                     scratch.path("no/x"),
                 "no/x");
  }
  const std::string large = "{} generate random-cubic -n 60000 | {} draw - --algorithm grid ";
  const std::string to = "-o " + scratch.path("x");
  expect_error(large + to + ".svg", "svg holds at most these");
  expect_error(large + to + ".tikz", "tikz holds at most these");
  expect_error(large + to + ".stl", "stl holds at most 65536");
  expect_error("{} generate random-cubic -n 9000 | {} draw - --algorithm two-bend " + to + ".glb",
               "glb holds at most 16777216");
}

/// Read by Python's own XML parser, as VTK's documentation describes the file.
constexpr const char* kReadVtp = R"(
import json, sys
import xml.etree.ElementTree as ET
piece = ET.parse(sys.argv[1]).getroot().find("PolyData/Piece")
array = {(e.tag, a.get("Name")): [float(w) for w in a.text.split()] for e in piece for a in e}
drawing = json.load(open(sys.argv[2]))
n, m = drawing["n"], len(drawing["edges"])
assert [int(piece.get(k)) for k in ("NumberOfVerts", "NumberOfLines")] == [n, m]
points = int(piece.get("NumberOfPoints"))
lattice = [array["PointData", "lattice"][3 * i:3 * i + 3] for i in range(points)]
assert lattice[:n] == drawing["vertices"]
assert array["PointData", "vertex"] == list(range(n)) + [-1] * (points - n)
assert array["CellData", "edge"] == [-1] * n + list(range(m))
assert array["Verts", "offsets"] == list(range(1, n + 1))
assert len(array["CellData", "colour"]) == 3 * (n + m) and len(array["Points", "Points"]) == 3 * points
begin = 0
for (u, v, bends), end in zip(drawing["edges"], array["Lines", "offsets"]):
    ids = [int(i) for i in array["Lines", "connectivity"][begin:int(end)]]
    assert ids[0] == u and ids[-1] == v and [lattice[i] for i in ids[1:-1]] == bends
    begin = int(end)
print("read", points)
)";

TEST(Export, VtpIsReadByPython) {
  const ScratchDirectory scratch;
  const std::string reader = scratch.write("read.py", kReadVtp);
  for (const std::string algorithm : {"diamond", "grid", "two-bend"}) {
    const std::string draw =
        "{} generate random-cubic -n 40 | {} draw - --force --algorithm " + algorithm;
    expect_output(run(draw + " -o " + scratch.path("d.vtp") + " && " + draw + " -o " +
                      scratch.path("d.jsonl") + " && /usr/bin/python3 " + reader + " " +
                      scratch.path("d.vtp") + " " + scratch.path("d.jsonl")),
                  "read ");
  }
}

}  // namespace
}  // namespace ar3d::testing
