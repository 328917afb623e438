#include "ar3d/store/hdf5/results_file.h"

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
#include "ar3d/store/journal/journal_format.h"
#include "ar3d/store/rows.h"
#include "store/forged.h"
#include "store/sample_runs.h"
#include "support/parts.h"

namespace ar3d::testing {
namespace {

class ResultsFile : public ::testing::Test {
 protected:
  std::string in_folder(const std::string& name) const { return folder_.path(name); }

  ScratchDirectory folder_;
  const std::string path_ = folder_.path("r.h5");
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
    write_results(written, path_);
    const Results read = read_results(path_);
    EXPECT_EQ(identity_text(read), identity_text(written));
    EXPECT_EQ(session_text(read.environment), session_text(written.environment));
    EXPECT_EQ(read.environment[0].session, 0);
    EXPECT_EQ(read.environment[1].session, 1);
    ASSERT_EQ(read.runs.size(), written.runs.size());
    for (std::size_t i = 0; i < read.runs.size(); ++i) {
      EXPECT_EQ(record_of(read.runs[i]), record_of(written.runs[i]));
    }
  }
  EXPECT_EQ(folder_.entries(), 1u) << "no partial file may stay";
}

TEST_F(ResultsFile, KeepsMissingValuesMissing) {
  Results results = sample_results(1);
  results.runs[0] = ar3d::RunRecord();
  results.runs[0].status = RunStatus::timeout;
  write_results(results, path_);
  const ar3d::RunRecord run = read_results(path_).runs.at(0);
  EXPECT_EQ(run.status, RunStatus::timeout);
  EXPECT_EQ(run.n, -1);
  EXPECT_EQ(run.bends[7], -1);
  EXPECT_EQ(run.peak_bytes, -1);
  EXPECT_TRUE(std::isnan(run.wall_s));
  EXPECT_TRUE(std::isnan(run.theorem_bound[2]));
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
  write_results(results, path_);
  const RunRecord run = read_results(path_).runs[0];
  EXPECT_EQ(run.message, "line?\u00f6" + std::string(233, 'x'));
  EXPECT_EQ(run.group, results.runs[0].group);
  results.runs[0].group = "\xff";
  EXPECT_THAT(write_error(results, in_folder("s.h5")), HasSubstr("is not 48 bytes of printable"));
  results.runs[0].family = std::string(100, 'f');
  EXPECT_THAT(write_error(results, in_folder("s.h5")), HasSubstr("family 'ffff"));
  EXPECT_FALSE(fs::exists(in_folder("s.h5")));
}

TEST_F(ResultsFile, RefusesWhatIsNoResultsFile) {
  expect_parts({{read_error(in_folder("missing.h5")), "No such file or directory"},
                {read_error(in_folder("")), "Is a directory"},
                {read_error(folder_.write("text.h5", "hello")), "is not an HDF5 file"},
                {read_error(folder_.write("empty.h5", "")), "is not an HDF5 file"}});
}

TEST_F(ResultsFile, RefusesAFileCutShort) {
  write_results(sample_results(2000), path_);
  fs::resize_file(path_, fs::file_size(path_) / 2);
  EXPECT_THAT(read_error(path_),
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
  expect_parts(
      {{error_after(path_, "f.attrs['format_version'] = 4"), "format version 4"},
       {error_after(path_, "del f.attrs['format']"), "attribute 'format' is missing"},
       {error_after(path_, "del f['runs']"), "/runs is missing"},
       {error_after(path_, "del f['spec']"), "/spec is missing"},
       {error_after(path_,
                    "d = f['runs'][:]; del f['runs']; "
                    "f['runs'] = d[[n for n in d.dtype.names if n != 'seed']]"),
        "/runs has no field 'seed'"},
       {error_after(path_, "del f['runs']; f['runs'] = [1, 2]"), "/runs is not a table of records"},
       {error_after(path_, "f['spec'][()] = b'another'"), "/spec"},
       {error_after(path_, "f.attrs['planned_rows'] = 1.5"), "planned_rows"}});
}

TEST_F(ResultsFile, FillsColumnsThatAreMissing) {
  EXPECT_EQ(error_after(path_,
                        "from numpy.lib.recfunctions import repack_fields; d = f['runs'][:]; "
                        "del f['runs']; f['runs'] = repack_fields(d[[n for n in d.dtype.names "
                        "if n not in ('log2_volume', 'violations', 'counters')]])"),
            "no error");
  const Results results = read_results(path_);
  EXPECT_TRUE(std::isnan(results.runs.at(2).log2_volume));
  EXPECT_EQ(results.runs[2].violations, -1);
  EXPECT_EQ(results.runs[2].counters, "");
  EXPECT_EQ(results.runs[2].extents, sample_run(2).extents);
}

// What the bytes of a file lead out of it, or claim that cannot be.
TEST_F(ResultsFile, RefusesFilesThatReachForOthers) {
  std::ofstream(in_folder("secret.txt")) << std::string(5000, 's');
  const std::string secret = in_folder("secret.txt");
  write_results(sample_results(1), in_folder("other.h5"));
  expect_parts({{error_after(path_,
                             "del f['spec']; f.create_dataset('spec', shape=(1,), dtype='S9', "
                             "external=[('" +
                                 secret + "', 0, 9)])"),
                 "/spec has its bytes in another file"},
                {error_after(path_, "del f['runs']; f['runs'] = h5py.ExternalLink('" +
                                        in_folder("other.h5") + "', 'runs')"),
                 "/runs is a link elsewhere"},
                {error_after(path_,
                             "d = f['runs'].dtype; del f['runs']; l = h5py.VirtualLayout((1,), d); "
                             "l[:] = h5py.VirtualSource('" +
                                 in_folder("other.h5") +
                                 "', 'runs', (1,)); f.create_virtual_dataset('runs', l)"),
                 "/runs is a view of other datasets"},
                {error_after(path_,
                             "d = f['runs'].dtype; del f['runs']; "
                             "f.create_dataset('runs', (10**12,), d, chunks=(512,))"),
                 "more than the file can hold"},
                {error_after(path_,
                             "d = f['runs'].dtype; del f['runs']; "
                             "f.create_dataset('runs', (10**6,), d, chunks=(10**6,))"),
                 "/runs has chunks of more than"}});
}

TEST_F(ResultsFile, IsReadByItsRowsWhereAnotherProgramHasOpenedIt) {
  std::vector<std::string> notes;
  note_on_results = [&](const std::string& note) { notes.push_back(note); };
  const Results written = sample_results(600);
  for (const char* opening :
       {"", "f.close(); s = pandas.HDFStore(path)", "f.create_dataset('mine', data=[1, 2])",
        "f.close(); s = pandas.HDFStore(path); s['mine'] = pandas.DataFrame({'a': [1]}); "
        "s.close()"}) {
    write_results(written, path_);
    change_with_h5py(path_, std::string("import pandas; path = '") + path_ + "'; " + opening);
    const Results read = read_results(path_);
    ASSERT_EQ(read.runs.size(), 600u) << opening;
    for (std::size_t i = 0; i < 600; ++i)
      EXPECT_EQ(all_bytes(read.runs[i]), all_bytes(written.runs[i]));
    EXPECT_EQ(notes,
              std::vector{path_ + " was opened for writing by another program, which cut its "
                                  "checksum off; its rows are those that it was written "
                                  "with, by their hash"});
    notes.clear();
  }
  for (const char* change :
       {"f.attrs['study_id'] = numpy.bytes_('mine')",
        "r = f['runs'][:]; r['n'][1] += 1; f['runs'][:] = r",
        "r = f['environments'][:]; r['value'][0] = b'x'; f['environments'][:] = r"}) {
    write_results(written, path_);
    change_with_h5py(path_, change);
    EXPECT_THAT(read_error(path_), HasSubstr("and its rows are not those of its rows_hash"));
  }
  write_results(written, path_);
  change_with_h5py(path_, "del f.attrs['rows_hash']");
  EXPECT_THAT(read_error(path_), HasSubstr("or opened for writing by another program "
                                           "(pandas.HDFStore, h5py's modes r+ and a), and it has "
                                           "no rows_hash, as those of earlier programs"));
  EXPECT_THAT(notes, IsEmpty());
  note_on_results = [](const std::string&) {};
}

TEST_F(ResultsFile, IsNotDamagedWhileAnotherProgramHasItOpen) {
  write_results(sample_results(3), path_);
  const std::string script = "import h5py, sys; f = h5py.File('" + path_ + "', 'r+'); open('" +
                             in_folder("ready") + "', 'w').close(); sys.stdin.read()";
  FILE* const holder = popen(("/usr/bin/python3 -c \"" + script + "\"").c_str(), "w");
  while (!fs::exists(in_folder("ready"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(read_error(path_),
            path_ + " is open for writing in another program: close it there, then it is read");
  EXPECT_EQ(pclose(holder), 0);
  EXPECT_EQ(read_error(path_), "no error");
}

// A sample of the flips; tests/store/bit_flips_long_test.cpp makes them all.
TEST_F(ResultsFile, NoFlippedBitIsAccepted) {
  write_results(sample_results(40), path_);
  const std::string bytes = read_file(path_);
  const std::size_t bits = 8 * bytes.size(), ending = bits - 8 * kChecksumSize;
  for (std::size_t bit = 0; bit < bits; bit += bit < ending ? bits / 300 : 7) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    std::ofstream(path_, std::ios::binary) << flipped;
    EXPECT_NE(read_error(path_), "no error") << bit;
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
  std::ofstream(path_) << "bytes";
  const Descriptor file(open(path_.c_str(), O_RDONLY));
  ReaderProcess reader(path_, file, [](std::uint64_t question) -> std::string {
    if (question == 1) throw InputError("no such row");
    if (question == 2) std::abort();
    return std::string(question, 'x');
  });
  EXPECT_EQ(reader.ask(100000), std::string(100000, 'x'));
  EXPECT_EQ(problem([&] { reader.ask(1); }, "no error"), path_ + ": reading it says no such row");
  EXPECT_EQ(reader.ask(0), "");
  EXPECT_THAT(problem([&] { reader.ask(2); }, "no error"), HasSubstr("reading it has crashed"));
  EXPECT_THAT(problem([&] { reader.ask(0); }, "no error"), HasSubstr("reading it has crashed"));
  const auto sleeps = [](std::uint64_t) -> std::string { return std::to_string(sleep(1000)); };
  ReaderProcess slow(path_, file, sleeps, 0.2);
  EXPECT_THAT(problem([&] { slow.ask(1); }, "no error"), HasSubstr("after 0.2 s of reading"));
}

TEST_F(ResultsFile, RefusesUnwritablePlaces) {
  const Results results = sample_results(1);
  expect_parts({{write_error(results, in_folder("no/such/r.h5")), "No such file or directory"},
                {write_error(results, folder_.path("")), "Is a directory"},
                {write_error(results, "/dev/null"), "it is not a regular file"},
                {write_error(results, "/proc/r.h5"), "cannot write /proc/r.h5: "}});
  EXPECT_THROW(require_writable("/proc/r.h5"), InputError);
  EXPECT_NO_THROW(require_writable(path_));
  EXPECT_EQ(folder_.entries(), 0u);
}

TEST_F(ResultsFile, LeavesTheOldFileWhenTheDiskIsFull) {
  write_results(sample_results(1), path_);
  std::string error;
  {
    const FileSizeLimit limit(10000);
    error = write_error(sample_results(5000), path_);
  }
  EXPECT_THAT(error, HasSubstr("r.h5: File too large"));
  EXPECT_EQ(read_results(path_).runs.size(), 1u);
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

int python_exit(const std::string& arguments) {
  return std::system(
      ("/usr/bin/python3 " AR3D_SOURCE_DIR "/tests/store/python_readers.py " + arguments).c_str());
}

// What the documentation promises to Python users.
TEST_F(ResultsFile, PandasAndH5pyReadItInOneLine) {
  write_results(sample_results(600), path_);
  EXPECT_EQ(python_exit("lines " + path_), 0);
}

TEST_F(ResultsFile, TheReaderForPandasGivesTextsAndMasksWhatIsMissing) {
  Results results = sample_results(4);
  results.runs[1].violations = -1;
  write_results(results, path_);
  EXPECT_EQ(python_exit("tools " + path_ + " " AR3D_SOURCE_DIR "/tools"), 0);
}

}  // namespace
}  // namespace ar3d::testing
