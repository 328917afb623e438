#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/store/columns/side_tables.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Takes a note on each file that is read though another program has opened it for writing.
inline std::function<void(const std::string& note)> note_on_results = [](const std::string&) {};

/// Is a file read whose rows another program may have changed? Set once, before files are read.
inline bool accept_changed_results = false;

/// Represents a child process that reads a file whose bytes may crash or hang who reads them, and
/// answers questions about it. It ends with this object, or with this process.
class ReaderProcess {
 public:
  /// Gives the answer to a question, in the child.
  using Answers = std::function<std::string(std::uint64_t question)>;

  /// @param path  of the file, for messages.
  /// @param file  stays open in the child, as no other but the standard ones does.
  /// @param limit_s  wall time of an answer.
  /// @throws InputError if the system has no process or socket left.
  ReaderProcess(std::string path, const Descriptor& file, const Answers& answers,
                double limit_s = 60);

  /// Returns the answer, valid until the next question. @throws InputError with the message of what
  /// the child has thrown, or naming the file and how the child has ended: by a signal, or since it
  /// needed more than 20 s of CPU time or the limit.
  const std::string& ask(std::uint64_t question);

 private:
  [[noreturn]] void refuse(double left_s);

  std::string path_;
  double limit_s_;
  Child child_;
  std::string answer_;
};

/// Represents a results file, read record by record. Memory: a few hundred rows, however many there are.
/// The file's checksum is verified before HDF5 sees the file, and HDF5 sees it in a process of
/// its own, so that nothing that another program has written can crash or hang this one. Without the
/// checksum all rows are read and compared with their hash, unless changed files are accepted. The page results/SCHEMA.md describes the file.
class RunReader {
 public:
  /// @throws InputError naming the file and what is wrong with it: missing, not HDF5, damaged, held
  /// open or changed by another program, another version, no /runs, a required column missing, …; or one
  /// that crashes HDF5.
  explicit RunReader(const std::string& path);

  /// Returns the study with the tables of side_table_specs() that the file has.
  const StudyIdentity& identity() const { return identity_; }
  const std::vector<EnvironmentEntry>& environment() const { return environment_; }
  /// Returns the entries of each session. @throws InputError naming a session that has none.
  std::vector<std::vector<EnvironmentEntry>> sessions() const;
  std::size_t size() const { return size_; }

  /// Returns record i, valid until the next call; cheap if i is near the one before. What the file
  /// has no column for is missing: -1, NaN or empty. @throws InputError naming the file.
  const char* record(std::size_t i);
  void read(std::size_t i, char* record);
  /// @throws InputError naming file and row.
  RowKey key(std::size_t i);

 private:
  std::string rows_hash(std::string_view description);

  std::string path_;
  bool is_checked_ = false;  // by the checksum of the bytes; before the process
  ReaderProcess process_;
  StudyIdentity identity_;
  std::vector<EnvironmentEntry> environment_;
  std::size_t size_ = 0;
  std::size_t block_ = SIZE_MAX;  // that is in `rows_`
  std::string rows_;
};

/// Writes FILE.h5 atomically: a new file beside it, fsync, rename. `read` writes record i.
/// @throws InputError if it cannot (a disk that gets full leaves nothing behind).
/// Memory: a few hundred rows, and 40 bytes per record of /instances.
void write_results(const StudyIdentity& identity, const std::vector<EnvironmentEntry>& environment,
                   std::size_t rows, const std::function<void(std::size_t i, char* record)>& read,
                   const std::string& path);

/// A results file ends with 40 bytes behind the end of its HDF5 part, which HDF5 does not look at:
/// "ar3d-checksum 1\n", the number of bytes before (8 bytes, little endian) and the XXH3-128 hash
/// of everything up to there (canonical: big endian).
inline constexpr std::size_t kChecksumSize = 40;

/// Appends it to an open file that is otherwise complete. @return 0, or the errno of what failed.
int append_checksum(int descriptor);

/// Reads the whole file. @return true if its checksum is right; false if another program has opened it
/// for writing, which cuts the checksum off, or has it open. @throws InputError naming `path` if it
/// cannot be read or its checksum is a wrong one.
bool has_checksum(int descriptor, const std::string& path);

/// Returns the version of the HDF5 library in use, "1.10.8".
std::string hdf5_version();

}  // namespace ar3d
