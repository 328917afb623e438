#include "ar3d/results/hdf5/drawing_hdf5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/model/error.h"
#include "ar3d/model/random.h"
#include "formats/format_helpers.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
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

TEST(DrawingHdf5, GivesBackWhatItWrote) {
  const TemporaryFolder folder;
  for (const Vertex n : {0u, 1u, 2u, 17u, 10000u}) {  // 10000: more than one block of rows
    const Drawing drawing = sample(n, kTallLattice);
    write_drawing_hdf5(drawing, folder.file("d.h5"));
    EXPECT_EQ(text_of(read_drawing_hdf5(folder.file("d.h5"))), text_of(drawing)) << n;
  }
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(DrawingHdf5, RefusesFilesThatCannotBeReadOrWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("d.h5");
  const auto reading = [&] { return refusal([&] { read_drawing_hdf5(path); }); };
  EXPECT_EQ(reading(), "cannot read " + path + ": No such file or directory");
  testing::write_file(path, "no HDF5");
  EXPECT_EQ(reading(), path + " is not an HDF5 file");
  EXPECT_EQ(refusal([&] { write_drawing_hdf5(sample(3), folder.file("no/d.h5")); }),
            "cannot write " + folder.file("no/d.h5") + ": No such file or directory");
  EXPECT_EQ(folder.entries(), 1u);
}

/// Runs a python line on the file f (an h5py.File) of a written sample; false without h5py.
bool changed(const std::string& path, const std::string& line) {
  write_drawing_hdf5(sample(10), path);
  const std::string command = "/usr/bin/python3 -c \"import h5py, numpy\nf = h5py.File('" + path +
                              "', 'r+')\n" + line + "\" 2> /dev/null";
  return std::system(command.c_str()) == 0;
}

TEST(DrawingHdf5, IsReadByH5pyAndRefusesWhatWasChanged) {
  const TemporaryFolder folder;
  const std::string path = folder.file("d.h5");
  ASSERT_TRUE(changed(path, "")) << "python3-h5py is one of the packages that ./run-tests installs";
  EXPECT_TRUE(
      changed(path,
              "assert f['vertices'].shape == (10, 3) and f['edges'].shape == (9, 2)\n"
              "assert f['vertices'].dtype == 'int64' and f['bends/points'].dtype == 'int64'\n"
              "assert f['bends/offsets'].shape == (10,) and f['bends/offsets'][-1] == "
              "len(f['bends/points'])\n"
              "assert f.attrs['gram'].tolist() == [[1,0,0],[0,1,0],[0,0,1]]\n"
              "assert f.attrs['gram_denominator'] == 1\n"));
  const auto refused = [&](const std::string& line) {
    EXPECT_TRUE(changed(path, line)) << line;
    return refusal([&] { read_drawing_hdf5(path); });
  };
  EXPECT_THAT(refused("f['edges'][3, 1] = 10"),
              HasSubstr("/edges[3]: 10 is no vertex, there are 10"));
  EXPECT_THAT(refused("f['edges'][3, 1] = -1"), HasSubstr("/edges[3]: -1 is no vertex"));
  EXPECT_THAT(refused("f['vertices'][2, 0] = 2**62"),
              HasSubstr("/vertices[2]: (4611686018427387904, "));
  EXPECT_THAT(refused("f['bends/offsets'][0] = 1"), HasSubstr("/bends/offsets: 1 after -1"));
  EXPECT_THAT(refused("f['bends/offsets'][9] = 99"), HasSubstr("/bends/offsets: 99 after "));
  EXPECT_THAT(refused("f['bends/offsets'][:] = 0"), HasSubstr("/bends/offsets ends with "));
  EXPECT_THAT(refused("del f['edges']"), HasSubstr("/edges is missing"));
  EXPECT_THAT(refused("del f['edges']\nf['edges'] = numpy.zeros((9, 3), 'i8')"),
              HasSubstr("has not the shape rows x 2"));
  EXPECT_THAT(refused("del f['edges']\nf['edges'] = numpy.zeros((9, 2))"),
              HasSubstr("/edges holds no integers"));
  EXPECT_THAT(refused("del f['edges']\nf.create_dataset('edges', (10**12, 2), 'i8')"),
              HasSubstr("/edges claims 1000000000000 rows, more than the file can hold"));
  EXPECT_THAT(refused("f.attrs['gram'] = numpy.zeros((3, 3), 'i4')"),
              HasSubstr("not positive definite"));
  EXPECT_THAT(refused("f.attrs['format_version'] = 2"),
              HasSubstr("it has format version 2, this program reads version 1"));
  EXPECT_THAT(refused("del f.attrs['format']"), HasSubstr("attribute 'format' is missing"));
}

}  // namespace
}  // namespace ar3d
