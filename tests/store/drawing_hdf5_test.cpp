#include "ar3d/store/hdf5/drawing_hdf5.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "formats/format_helpers.h"

namespace ar3d {
namespace {

using testing::TemporaryFolder;

Drawing sample(Vertex n, Lattice lattice = kCubeLattice) {
  RandomStream random(n);
  const auto point = [&] {
    const auto coordinate = [&] {
      return static_cast<std::int64_t>(random.below64(2 * kMaxCoordinate)) - kMaxCoordinate;
    };
    return Point{coordinate(), coordinate(), coordinate()};
  };
  Coordinates vertices(n, kMaxCoordinate);
  for (Vertex v = 0; v < n; ++v) vertices.set(v, point());
  auto edges = std::make_shared<std::vector<Edge>>();
  auto bends = std::make_shared<StoredBends>();
  for (Vertex v = 1; v < n; ++v) {
    edges->push_back({v, random.below(v)});
    bends->add_edge(std::vector<Point>(random.below(4), point()));
  }
  return Drawing("sample", lattice, std::move(vertices), std::move(edges), std::move(bends));
}

std::string text_of(const Drawing& drawing) {
  std::string text;
  append_drawing_line(text, drawing);
  return text;
}

template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Every number, against the same drawing as a JSON line.
TEST(DrawingHdf5, H5pyReadsTheDrawingThatWasWritten) {
  const TemporaryFolder folder;
  testing::write_file(folder.file("check.py"), R"(
import json, sys, h5py
d = json.load(open(sys.argv[1]))
f = h5py.File(sys.argv[2])
assert f.attrs["format"].decode() == "ar3d-drawing" and f.attrs["format_version"] == 1
assert f.attrs["algorithm"].decode() == d["algorithm"]
assert f.attrs["gram"].tolist() == d["gram"], f.attrs["gram"]
assert f.attrs["gram_denominator"] == d["gram_denominator"]
for name in ("vertices", "edges", "bends/offsets", "bends/points"):
    assert f[name].dtype == "int64"
at = f["bends/offsets"][:]
points = f["bends/points"][:].tolist()
assert f["vertices"][:].tolist() == d["vertices"]
assert f["edges"][:].tolist() == [e[:2] for e in d["edges"]]
assert [points[a:b] for a, b in zip(at, at[1:])] == [e[2] for e in d["edges"]]
)");
  for (const Vertex n : {0u, 1u, 2u, 17u, 5000u}) {  // 5000: more than one block of rows
    const Drawing drawing = sample(n, kTallLattice);
    write_drawing_hdf5(drawing, folder.file("d.h5"));
    testing::write_file(folder.file("d.json"), text_of(drawing));
    const std::string command = "/usr/bin/python3 " + folder.file("check.py") + " " +
                                folder.file("d.json") + " " + folder.file("d.h5");
    EXPECT_EQ(std::system(command.c_str()), 0) << n;
  }
}

TEST(DrawingHdf5, RefusesPlacesThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal([&] { write_drawing_hdf5(sample(3), folder.file("no/d.h5")); }),
            "cannot write " + folder.file("no/d.h5") + ": No such file or directory");
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace ar3d
