#include <fcntl.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/file_checksum.h"
#include "ar3d/store/hdf5/reader_process.h"
#include "ar3d/store/run_storage.h"
#include "store/forged.h"
#include "store/sample_runs.h"
#include "support/parts.h"

namespace ar3d::testing {
namespace {

class ResultsFile : public ::testing::Test {
 protected:
  std::string in_folder(const std::string& name) const { return folder_.path(name); }

  ScratchDirectory folder_;
};

std::string read_error(const std::string& path) {
  return problem([&] { read_results(path); }, "no error");
}

std::string write_error(const Results& results, const std::string& path) {
  return problem([&] { write_results(results, path); }, "no error");
}

TEST_F(ResultsFile, ReadsBackWhatWasWritten) {
  for (const std::int64_t count : {0, 1, 511, 512, 513, 1500}) {
    const Results written = sample_results(count);
    write_results(written, in_folder("r.h5"));
    const Results read = read_results(in_folder("r.h5"));
    EXPECT_EQ(read.study_id, written.study_id);
    EXPECT_EQ(read.spec, written.spec);
    EXPECT_EQ(read.spec_hash, written.spec_hash);
    EXPECT_EQ(read.source_hash, written.source_hash);
    EXPECT_TRUE(read.dirty);
    EXPECT_EQ(read.dirty_hash, written.dirty_hash);
    EXPECT_EQ(read.created, written.created);
    EXPECT_EQ(read.shard, written.shard);
    EXPECT_EQ(read.planned_rows, written.planned_rows);
    ASSERT_EQ(read.environment.size(), 2u);
    EXPECT_EQ(read.environment[0].session, 0);
    EXPECT_EQ(read.environment[1].session, 1);
    EXPECT_EQ(read.environment[1].name, "flags");
    EXPECT_EQ(read.environment[1].value, "-O3 -DNDEBUG");
    ASSERT_EQ(read.runs.size(), written.runs.size());
    for (std::size_t i = 0; i < read.runs.size(); ++i) {
      for (const Column& column : run_columns()) {
        EXPECT_EQ(column_text(column, read.runs[i]), column_text(column, written.runs[i]));
      }
    }
  }
  EXPECT_EQ(folder_.entries(), 1u) << "no partial file may stay";
}

TEST_F(ResultsFile, KeepsMissingValuesMissing) {
  Results results = sample_results(1);
  results.runs[0] = ar3d::RunRecord();
  results.runs[0].status = RunStatus::timeout;
  write_results(results, in_folder("r.h5"));
  const ar3d::RunRecord run = read_results(in_folder("r.h5")).runs.at(0);
  EXPECT_EQ(run.status, RunStatus::timeout);
  EXPECT_EQ(run.n, -1);
  EXPECT_EQ(run.bends[7], -1);
  EXPECT_EQ(run.peak_bytes, -1);
  EXPECT_TRUE(std::isnan(run.wall_s));
  EXPECT_TRUE(std::isnan(run.slack[2]));
}

TEST_F(ResultsFile, EqualResultsGiveEqualBytes) {
  write_results(sample_results(700), in_folder("a.h5"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // time stamps count seconds
  write_results(sample_results(700), in_folder("b.h5"));
  EXPECT_EQ(read_file(in_folder("a.h5")), read_file(in_folder("b.h5")));
}

TEST_F(ResultsFile, CutsMessagesAndRefusesLongNames) {
  Results results = sample_results(1);
  results.runs[0].message = "line\n\xc3\xb6" + std::string(1000, 'x');
  results.runs[0].group = "\u03b4\u03b5\u03bb\u03c4\u03b1";
  write_results(results, in_folder("r.h5"));
  const RunRecord run = read_results(in_folder("r.h5")).runs[0];
  EXPECT_EQ(run.message, "line?\u00f6" + std::string(233, 'x'));
  EXPECT_EQ(run.group, results.runs[0].group);
  results.runs[0].group = "\xff";
  EXPECT_THAT(write_error(results, in_folder("s.h5")), HasSubstr("is not 48 bytes of printable"));
  results.runs[0].family = std::string(100, 'f');
  EXPECT_THAT(write_error(results, in_folder("s.h5")), HasSubstr("family 'ffff"));
  EXPECT_FALSE(fs::exists(in_folder("s.h5")));
}

TEST_F(ResultsFile, RefusesWhatIsNoResultsFile) {
  EXPECT_THAT(read_error(in_folder("missing.h5")), HasSubstr("No such file or directory"));
  EXPECT_THAT(read_error(folder_.path("")), HasSubstr("Is a directory"));
  std::ofstream(in_folder("text.h5")) << "hello";
  EXPECT_THAT(read_error(in_folder("text.h5")), HasSubstr("is not an HDF5 file"));
  std::ofstream(in_folder("empty.h5")) << "";
  EXPECT_THAT(read_error(in_folder("empty.h5")), HasSubstr("is not an HDF5 file"));
}

TEST_F(ResultsFile, RefusesAFileCutShort) {
  write_results(sample_results(2000), in_folder("r.h5"));
  fs::resize_file(in_folder("r.h5"), fs::file_size(in_folder("r.h5")) / 2);
  EXPECT_THAT(read_error(in_folder("r.h5")),
              HasSubstr("is not a readable results file: it has no checksum at its end"));
}

void change_with_h5py(const std::string& path, const std::string& change) {
  const std::string script = "import h5py, numpy; f = h5py.File('" + path + "', 'a'); " + change;
  EXPECT_EQ(std::system(("/usr/bin/python3 -c \"" + script + "\"").c_str()), 0);
}

// Changes a written file with h5py, makes its checksum right again and gives the error of reading.
std::string error_after(const std::string& path, const std::string& change) {
  write_results(sample_results(3), path);
  change_with_h5py(path, change);
  renew_checksum(path);
  return read_error(path);
}

TEST_F(ResultsFile, RefusesAnotherFormatOrVersion) {
  const std::string path = in_folder("r.h5");
  expect_parts(
      {{error_after(path, "f.attrs['format_version'] = 4"), "format version 4"},
       {error_after(path, "del f.attrs['format']"), "attribute 'format' is missing"},
       {error_after(path, "del f['runs']"), "/runs is missing"},
       {error_after(path, "del f['spec']"), "/spec is missing"},
       {error_after(path,
                    "d = f['runs'][:]; del f['runs']; "
                    "f['runs'] = d[[n for n in d.dtype.names if n != 'seed']]"),
        "/runs has no field 'seed'"},
       {error_after(path, "del f['runs']; f['runs'] = [1, 2]"), "/runs is not a table of records"},
       {error_after(path, "f['spec'][()] = b'another'"), "/spec"},
       {error_after(path, "f.attrs['planned_rows'] = 1.5"), "planned_rows"}});
}

TEST_F(ResultsFile, FillsColumnsThatAreMissing) {
  const std::string path = in_folder("r.h5");
  EXPECT_EQ(error_after(path,
                        "from numpy.lib.recfunctions import repack_fields; d = f['runs'][:]; "
                        "del f['runs']; f['runs'] = repack_fields(d[[n for n in d.dtype.names "
                        "if n not in ('log2_volume', 'violations', 'counters')]])"),
            "no error");
  const Results results = read_results(path);
  EXPECT_TRUE(std::isnan(results.runs.at(2).log2_volume));
  EXPECT_EQ(results.runs[2].violations, -1);
  EXPECT_EQ(results.runs[2].counters, "");
  EXPECT_EQ(results.runs[2].extents, sample_run(2).extents);
}

// What the bytes of a file lead out of it, or claim that cannot be.
TEST_F(ResultsFile, RefusesFilesThatReachForOthers) {
  const std::string path = in_folder("r.h5");
  std::ofstream(in_folder("secret.txt")) << std::string(5000, 's');
  const std::string secret = in_folder("secret.txt");
  write_results(sample_results(1), in_folder("other.h5"));
  expect_parts({{error_after(path,
                             "del f['spec']; f.create_dataset('spec', shape=(1,), dtype='S9', "
                             "external=[('" +
                                 secret + "', 0, 9)])"),
                 "/spec has its bytes in another file"},
                {error_after(path, "del f['runs']; f['runs'] = h5py.ExternalLink('" +
                                       in_folder("other.h5") + "', 'runs')"),
                 "/runs is a link elsewhere"},
                {error_after(path,
                             "d = f['runs'].dtype; del f['runs']; l = h5py.VirtualLayout((1,), d); "
                             "l[:] = h5py.VirtualSource('" +
                                 in_folder("other.h5") +
                                 "', 'runs', (1,)); f.create_virtual_dataset('runs', l)"),
                 "/runs is a view of other datasets"},
                {error_after(path,
                             "d = f['runs'].dtype; del f['runs']; "
                             "f.create_dataset('runs', (10**12,), d, chunks=(512,))"),
                 "more than the file can hold"},
                {error_after(path,
                             "d = f['runs'].dtype; del f['runs']; "
                             "f.create_dataset('runs', (10**6,), d, chunks=(10**6,))"),
                 "/runs has chunks of more than"}});
}

TEST_F(ResultsFile, RefusesFilesThatAnotherProgramHasChanged) {
  const std::string path = in_folder("r.h5");
  write_results(sample_results(3), path);
  change_with_h5py(path, "f.attrs['study_id'] = 'mine'");
  EXPECT_THAT(read_error(path),
              AnyOf(HasSubstr("has no checksum at its end"), HasSubstr("is damaged")));
}

// A sample of the flips; tests/store/bit_flips_long_test.cpp makes them all.
TEST_F(ResultsFile, NoFlippedBitIsAccepted) {
  const std::string path = in_folder("r.h5");
  write_results(sample_results(40), path);
  const std::string bytes = read_file(path);
  const std::size_t bits = 8 * bytes.size(), ending = bits - 8 * kChecksumSize;
  for (std::size_t bit = 0; bit < bits; bit += bit < ending ? bits / 300 : 7) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    std::ofstream(path, std::ios::binary) << flipped;
    EXPECT_NE(read_error(path), "no error") << bit;
  }
}

// Bytes that HDF5 takes for its own; tests/store/bit_flips_long_test.cpp makes 2400 such files.
TEST_F(ResultsFile, ForgedFilesCrashNothing) {
  const ForgedReads reads = read_forged_files(150, 1);
  EXPECT_EQ(reads.read + reads.refused, 150);
  EXPECT_GT(reads.refused, 0);
}

// What HDF5 does to the process that reads is told, be it a crash or a loop.
TEST_F(ResultsFile, AReaderThatEndsIsTold) {
  const std::string path = in_folder("r.h5");
  std::ofstream(path) << "bytes";
  const Descriptor file(open(path.c_str(), O_RDONLY));
  ReaderProcess reader(path, file, [](std::uint64_t question) -> std::string {
    if (question == 1) throw InputError("no such row");
    if (question == 2) std::abort();
    return std::string(question, 'x');
  });
  EXPECT_EQ(reader.ask(100000), std::string(100000, 'x'));
  EXPECT_EQ(problem([&] { reader.ask(1); }, "no error"), path + ": reading it says no such row");
  EXPECT_EQ(reader.ask(0), "");
  EXPECT_THAT(problem([&] { reader.ask(2); }, "no error"), HasSubstr("reading it has crashed"));
  EXPECT_THAT(problem([&] { reader.ask(0); }, "no error"), HasSubstr("reading it has crashed"));
  const auto sleeps = [](std::uint64_t) -> std::string { return std::to_string(sleep(1000)); };
  ReaderProcess slow(path, file, sleeps, 0.2);
  EXPECT_THAT(problem([&] { slow.ask(1); }, "no error"), HasSubstr("after 0.2 s of reading"));
}

TEST_F(ResultsFile, RefusesUnwritablePlaces) {
  const Results results = sample_results(1);
  expect_parts({{write_error(results, in_folder("no/such/r.h5")), "No such file or directory"},
                {write_error(results, folder_.path("")), "Is a directory"},
                {write_error(results, "/dev/null"), "it is not a regular file"},
                {write_error(results, "/proc/r.h5"), "cannot write /proc/r.h5: "}});
  EXPECT_THROW(require_writable("/proc/r.h5"), InputError);
  EXPECT_NO_THROW(require_writable(in_folder("r.h5")));
  EXPECT_EQ(folder_.entries(), 0u);
}

TEST_F(ResultsFile, LeavesTheOldFileWhenTheDiskIsFull) {
  write_results(sample_results(1), in_folder("r.h5"));
  std::string error;
  {
    const FileSizeLimit limit(10000);
    error = write_error(sample_results(5000), in_folder("r.h5"));
  }
  EXPECT_THAT(error, HasSubstr("r.h5: File too large"));
  EXPECT_EQ(read_results(in_folder("r.h5")).runs.size(), 1u);
  EXPECT_EQ(folder_.entries(), 1u);
}

TEST_F(ResultsFile, FollowsASymbolicLink) {
  fs::create_directory(in_folder("real"));
  std::ofstream(in_folder("real/r.h5")) << "old";
  fs::create_symlink(in_folder("real/r.h5"), in_folder("link.h5"));
  write_results(sample_results(1), in_folder("link.h5"));
  EXPECT_TRUE(fs::is_symlink(in_folder("link.h5")));
  EXPECT_EQ(read_results(in_folder("real/r.h5")).runs.size(), 1u);
}

// What the documentation promises to Python users, each in one line, with warnings as errors.
TEST_F(ResultsFile, PandasAndH5pyReadItInOneLine) {
  write_results(sample_results(600), in_folder("r.h5"));
  std::ofstream(in_folder("check.py")) << R"(
import warnings
import numpy, pandas, h5py, tables
warnings.simplefilter("error")
f = ")" << in_folder("r.h5") << R"("
a = pandas.read_hdf(f, "runs")
b = pandas.DataFrame(h5py.File(f)["runs"][:])
for t in (a, b):
    assert len(t) == 600, len(t)
    assert t.requested_n[7] == 13 and t.extent_z[0] == 2**61 and t.bends_7[599] == 8
    assert t.seed[0] == 2**64 - 1 and t.seed.dtype == numpy.uint64
    assert numpy.isnan(t.certify_s).all() and (t.peak_bytes == -1).all()
    assert abs(t.log2_volume[3] - 0.3) < 1e-15
assert a.algorithm[1] == "grid" and b.algorithm[1] == b"grid", (a.algorithm[1], b.algorithm[1])
assert list(a.columns) == list(b.columns)
i = pandas.read_hdf(f, "instances")
assert len(i) == 300 and list(i.requested_n) == list(range(10, 310))
e = pandas.read_hdf(f, "environments")
assert e.value[0] == "abacus"
h = h5py.File(f)
assert h["spec"][()].decode() == "# h\u00f6her\n[study]\n"
assert h.attrs["format"].decode() == "ar3d-results" and h.attrs["format_version"] == 3
assert h["runs"].attrs["wall_s.unit"].decode() == "s"
tables.open_file(f).root.runs.attrs._f_list("all")
)";
  EXPECT_EQ(std::system(("/usr/bin/python3 " + in_folder("check.py")).c_str()), 0);
}

TEST_F(ResultsFile, TheReaderForPandasGivesTextsAndMasksWhatIsMissing) {
  Results results = sample_results(4);
  results.runs[1].violations = -1;
  write_results(results, in_folder("r.h5"));
  std::ofstream(in_folder("check.py")) << R"(
import sys
sys.path.insert(0, ")" << AR3D_SOURCE_DIR "/tools"
                                       << R"(")
import ar3d_results
runs = ar3d_results.read(")" << in_folder("r.h5")
                                       << R"(")
assert runs.algorithm[1] == "grid" and isinstance(runs.algorithm[1], str)
assert runs.violations.mean() == 0 and runs.violations.count() == 3
assert runs.peak_bytes.isna().all() and runs.wall_s.isna().sum() == 0
assert runs.seed[0] == 2**64 - 1
assert len(ar3d_results.read(")" << in_folder("r.h5")
                                       << R"(", "instances")) == 2
)";
  EXPECT_EQ(std::system(("/usr/bin/python3 " + in_folder("check.py")).c_str()), 0);
}

}  // namespace
}  // namespace ar3d::testing
