#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"
#include "store/sample_runs.h"
#include "support/parts.h"
#include "support/problem.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

class Journal : public ::testing::Test {
 protected:
  void write_rows(std::int64_t from, std::int64_t to) const {
    JournalWriter writer(path_, sample_identity());
    writer.begin_session({{"cpu", "abacus"}, {"odd", "\xff"}});
    for (std::int64_t i = from; i < to; ++i) writer.append(sample_run(i));
  }
  void overwrite(std::uint64_t offset, const std::string& bytes) const {
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(offset));
    file << bytes;
  }
  std::string open_error() const {
    return problem([&] { JournalWriter writer(path_, sample_identity()); }, "no error");
  }
  std::string read_error() const {
    return problem([&] { JournalReader reader(path_); }, "no error");
  }

  ScratchDirectory scratch_;
  std::string path_ = scratch_.path("s.journal");
};

void expect_rows(const std::string& path, std::int64_t count) {
  const JournalReader reader(path);
  ASSERT_EQ(reader.size(), static_cast<std::size_t>(count));
  std::vector<char> record(run_record_size());
  for (std::int64_t i = 0; i < count; ++i) {
    reader.read(static_cast<std::size_t>(i), record.data());
    const ar3d::RunRecord run = load_record(record.data());
    EXPECT_TRUE(differing_columns(run, sample_run(i)).empty()) << i;
    EXPECT_EQ(run.wall_s, sample_run(i).wall_s);
    EXPECT_EQ(to_string(reader.key(static_cast<std::size_t>(i))), sample_run(i).row_key);
  }
}

TEST_F(Journal, HoldsWhatWasAppended) {
  write_rows(0, 30);
  write_rows(30, 50);
  expect_rows(path_, 50);
  const JournalReader reader(path_);
  EXPECT_EQ(identity_text(reader.identity()), identity_text(sample_identity()));
  ASSERT_EQ(reader.sessions().size(), 2u);
  EXPECT_EQ(reader.sessions()[1][0].value, "abacus");
  std::vector<char> record(run_record_size());
  for (std::size_t i = 0; i < 50; ++i) {
    reader.read(i, record.data());
    EXPECT_EQ(load_record(record.data()).session, i < 30 ? 0 : 1);
  }
}

TEST_F(Journal, TellsTheRowsItHasWhenContinued) {
  write_rows(0, 7);
  const JournalWriter writer(path_, sample_identity());
  EXPECT_EQ(writer.rows(), 7u);
  EXPECT_EQ(writer.bytes_cut(), 0u);
}

// Whatever prefix of its last write a crash leaves, all rows before it are there and it goes on.
TEST_F(Journal, CutsOffARecordThatACrashCutShort) {
  write_rows(0, 5);
  const std::string five = read_file(path_);
  write_rows(5, 6);
  const std::string six = read_file(path_);
  for (std::size_t size = five.size(); size < six.size(); size += 7) {
    std::ofstream(path_, std::ios::binary) << six.substr(0, size);
    const bool has_lost_session = JournalReader(path_).sessions().size() == 1;
    EXPECT_EQ(JournalReader(path_).size(), 5u) << size;
    {
      JournalWriter writer(path_, sample_identity());
      EXPECT_LE(writer.bytes_cut(), size - five.size());
      EXPECT_EQ(writer.rows(), 5u);
      EXPECT_TRUE(!has_lost_session || writer.bytes_cut() == size - five.size()) << size;
    }
    write_rows(5, 9);
    expect_rows(path_, 9);
  }
}

// A power cut may leave a file longer than what reached the disk: zeros or old bytes at its end.
TEST_F(Journal, CutsOffGarbageAtTheEnd) {
  write_rows(0, 5);
  const std::string five = read_file(path_);
  for (const std::string& tail : {std::string(1, '\0'), std::string(5000, '\0'),
                                  std::string(700, '\xff'), five.substr(five.size() - 400)}) {
    std::ofstream(path_, std::ios::binary) << five << tail;
    EXPECT_EQ(journal_status(path_).rows, 5u);
    EXPECT_EQ(JournalWriter(path_, sample_identity()).bytes_cut(), tail.size());
    EXPECT_EQ(read_file(path_), five);
  }
}

TEST_F(Journal, AFlippedByteInTheMiddleIsAnErrorThatNamesTheOffset) {
  write_rows(0, 12);
  const std::string whole = read_file(path_);
  std::vector<std::uint64_t> offsets;
  scan_journal(open_input(path_).get(), path_, [&](const JournalRecord& record) {
    if (record.kind == kRow) offsets.push_back(record.offset);
    return true;
  });
  for (std::uint64_t at = kJournalStart.size(); at < offsets[11]; at += 3) {
    overwrite(at, std::string(1, static_cast<char>(whole[at] ^ 0x10)));
    const auto next = std::upper_bound(offsets.begin(), offsets.end(), at);
    const std::string error = read_error();
    EXPECT_EQ(open_error(), error);
    EXPECT_THAT(error, HasSubstr("damaged at byte"));
    if (next != offsets.begin()) {
      EXPECT_THAT(error, HasSubstr("damaged at byte " + std::to_string(*(next - 1)) + ":"));
    }
    EXPECT_EQ(read_file(path_).size(), whole.size()) << "nothing may be cut off";
    overwrite(at, whole.substr(at, 1));
  }
  expect_rows(path_, 12);
}

TEST_F(Journal, HasOneWriterAtATime) {
  {
    JournalWriter writer(path_, sample_identity());
    EXPECT_THAT(open_error(), HasSubstr("is being written by another process"));
    EXPECT_EQ(journal_status(path_).writers, 1);
    JournalReader reader(path_);
  }  // a reader's end does not give up the lock before its time
  EXPECT_EQ(journal_status(path_).writers, 0);
  EXPECT_EQ(open_error(), "no error");
}

// A worker process has the open file too.
TEST_F(Journal, IsNotContinuedWhenItsWriterHasRemovedIt) {
  auto writer = std::make_unique<JournalWriter>(path_, sample_identity());
  std::string error;
  std::thread waiting([&] { error = open_error(); });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it waits for the lock by then
  fs::remove(path_);
  writer.reset();
  waiting.join();
  EXPECT_THAT(error, HasSubstr("s.journal is gone: another process has finished it"));
}

TEST_F(Journal, IsLockedUntilTheLastWorkerIsGone) {
  pid_t child = -1;
  {
    JournalWriter writer(path_, sample_identity());
    child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
  }
  EXPECT_EQ(journal_status(path_).writers, 1);
  kill(child, SIGKILL);
  EXPECT_EQ(open_error(), "no error") << "a worker that dies a moment later is waited for";
  waitpid(child, nullptr, 0);
}

TEST_F(Journal, RefusesAnotherStudySourceOrShard) {
  write_rows(0, 1);
  const auto error_with = [&](const std::function<void(StudyIdentity&)>& change) {
    StudyIdentity other = sample_identity();
    change(other);
    return problem([&] { JournalWriter writer(path_, other); }, "no error");
  };
  using Identity = StudyIdentity;
  expect_parts(
      {{error_with([](Identity& i) { i.spec_hash[0] = 'x'; }), "its specification is "},
       {error_with([](Identity& i) { i.source_hash[0] = 'c'; }), "its program's source is b"},
       {error_with([](Identity& i) { i.dirty_hash[0] = 'e'; }), "b with changes d"},
       {error_with([](Identity& i) {
          i.shard = Shard{2, 3};
        }),
        "its shard is 1/1, not 2/3"}});
}

TEST_F(Journal, RefusesWhatIsNoJournal) {
  EXPECT_THAT(read_error(), HasSubstr("No such file or directory"));
  for (const char* text : {"", "hello", "ar3d-journal 0\n and more than sixteen bytes"}) {
    std::ofstream(path_) << text;
    expect_parts({{read_error(), "is not a journal of this version"},
                  {open_error(), "is not a journal of this version"}});
  }
  std::ofstream(path_, std::ios::binary) << kJournalStart;
  EXPECT_THAT(read_error(), HasSubstr("without a beginning"));
}

TEST_F(Journal, OfAnOlderVersionIsRefusedInOneLine) {
  const std::string old = std::string("ar3d-journal 2\n\0", 16) + std::string(5000, '\x7f');
  std::ofstream(path_, std::ios::binary) << old;
  for (const std::string& error : {read_error(), open_error()}) {
    EXPECT_EQ(error, path_ +
                         " is not a journal of this version of ar3d: finish it with the program "
                         "that began it");
  }
  EXPECT_EQ(problem([&] { Rows(std::vector<std::string>{path_}); }), read_error());
  EXPECT_EQ(read_file(path_), old);
}

// Doubles as they are in memory, the largest and smallest integers, quotes and backslashes.
TEST_F(Journal, EveryValueReadsBackBitForBit) {
  const std::vector<Column>& columns = runs_spec().columns;
  constexpr std::uint64_t kBits[] = {0x0000000000000001, 0x8000000000000000, 0x7fefffffffffffff,
                                     0x3fb999999999999a, 0x7ff0000000000000, 0xfff0000000000000,
                                     0xfff8000000000000, 0x7ff0000000000001, 0x4340000000000001};
  constexpr std::uint64_t kIntegers[] = {0x8000000000000000, 0x7fffffffffffffff, 0, 1,
                                         0xffffffffffffffff, 0x20000000000001};
  std::vector<std::string> records;
  {
    JournalWriter writer(path_, sample_identity());
    writer.begin_session({});
    for (std::size_t i = 0; i < std::size(kBits); ++i) {
      std::string record(run_record_size(), '\0');
      store_record(sample_run(static_cast<std::int64_t>(i)), record.data());
      for (const Column& column : columns) {
        const std::uint64_t bits =
            column.type == ColumnType::float64 ? kBits[i] : kIntegers[i % std::size(kIntegers)];
        if (column.type != ColumnType::text)
          std::memcpy(&record[column.offset], &bits, sizeof(bits));
        if (column.name == "message")
          std::memcpy(&record[column.offset], "a \"b\\c\" {\"rows\":1", 17);
      }
      records.push_back(record);
      writer.append_record(record.data());
    }
  }
  const JournalReader reader(path_);
  ASSERT_EQ(reader.size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::string record(run_record_size(), '\x55');
    reader.read(i, record.data());
    EXPECT_EQ(record, records[i]) << i;
  }
}

TEST_F(Journal, ItsLastLineIsTheStatusAndEveryLineIsJson) {
  write_rows(0, 3);
  std::istringstream lines(read_file(path_));
  nlohmann::json last;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) last = nlohmann::json::parse(line);
  EXPECT_EQ(count, 5);
  EXPECT_EQ(last.at("rows"), 3);
  EXPECT_EQ(last.at("not_ok"), 0);
  EXPECT_EQ(last.at("row").at("row_key"), sample_run(2).row_key);
}

TEST_F(Journal, RowsThatAreForgedAreRefused) {
  write_rows(0, 1);
  const auto error_of = [&](const std::string& row) {
    std::string record(run_record_size(), '\0');
    return problem([&] { parse_record(runs_spec().columns, row, "f", record.data()); }, "no error");
  };
  EXPECT_EQ(error_of(R"({"row_key":"1","n":5,"cpu_s":3})"), "no error");
  EXPECT_EQ(error_of(R"({"n":5.5})"), "f: a record is none of its table from '.5}' on");
  for (const char* row :
       {"", "{", "[]", "5", R"({"nn":5})", R"({"n":5,"n":5})", R"({"n":9223372036854775808})",
        R"({"seed":-1})", R"({"cpu_s":"7ff0000000000000})", R"({"cpu_s":1e999})", R"({"n":[]})",
        R"({"family":1})", R"({"family":"a)", R"({"family":"a\)", R"({"n":5,})", R"({"n":5}})",
        R"({"cpu_s":3,"n":5})", R"({ "n":5})"}) {
    EXPECT_THAT(error_of(row), HasSubstr("f: a record is none of its table")) << row;
  }
  EXPECT_EQ(error_of("{\"row_key\":\"" + std::string(32, 'a') + "\"}"), "no error");
  EXPECT_THAT(error_of("{\"row_key\":\"" + std::string(33, 'a') + "\"}"),
              HasSubstr("of its table"));
}

TEST_F(Journal, RefusesUnwritablePlaces) {
  for (const char* path : {"/proc/s.journal", "/sys/s.journal", "/no/such/place/s.journal"}) {
    try {
      JournalWriter writer(path, sample_identity());
      ADD_FAILURE() << path;
    } catch (const JournalFull&) {
      ADD_FAILURE() << "nothing was written yet";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(std::string("cannot write ") + path));
    }
  }
}

TEST_F(Journal, IsWholeWhenTheDiskIsFull) {
  write_rows(0, 10);
  const std::uint64_t ten = fs::file_size(path_);
  {
    const FileSizeLimit limit(ten + 1000);
    EXPECT_THROW(write_rows(10, 100), JournalFull);
  }
  std::uint64_t rows = 0;
  {
    JournalWriter writer(path_, sample_identity());
    EXPECT_EQ(writer.bytes_cut(), 0u) << "the half record is cut off at once";
    rows = writer.rows();
  }
  EXPECT_GT(rows, 10u);
  write_rows(static_cast<std::int64_t>(rows), 100);
  expect_rows(path_, 100);
}

TEST_F(Journal, StatusCountsRowsThatAreNotOk) {
  {
    JournalWriter writer(path_, sample_identity());
    writer.begin_session({});
    for (std::int64_t i = 0; i < 2000; ++i) {
      ar3d::RunRecord run = sample_run(i);
      if (i % 10 == 0) run.status = RunStatus::timeout;
      if (i % 10 == 1) run.status = RunStatus::measured;
      writer.append(run);
    }
    writer.end_session({{"load_after", "1.00"}});
  }
  const JournalStatus status = journal_status(path_);
  EXPECT_EQ(status.rows, 2000u);
  EXPECT_EQ(status.not_ok, 200u);
  EXPECT_EQ(status.identity.study_id, "sample");
  EXPECT_EQ(status.writers, 0);
  EXPECT_EQ(JournalReader(path_).sessions()[0].back().name, "load_after");
}

TEST(RowKey, ReadsBackAndRefusesOtherTexts) {
  const std::string text = "0123456789abcdeffedcba9876543210";
  EXPECT_EQ(to_string(parse_row_key(text)), text);
  for (const char* bad : {"", "0123", "0123456789ABCDEFfedcba9876543210",
                          "-123456789abcdeffedcba9876543210", "0123456789abcdefXedcba9876543210"}) {
    EXPECT_THROW(parse_row_key(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace ar3d::testing
