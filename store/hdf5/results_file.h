#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// Represents a results file, read row by row. Memory: a few hundred rows, however many there
/// are.
///  The file's checksum is verified before HDF5 sees the file, and HDF5 sees it in a process of
/// its own, so that nothing that another program has written can crash or hang this one. The page
/// results/SCHEMA.md describes the file.
class ResultsReader {
 public:
  /// @param format  outlives the reader.
  /// @throws InputError naming the file and what is wrong with it: missing, not HDF5, damaged,
  /// changed by another program, another version, no /runs, a required column missing, …; or one
  /// that crashes HDF5.
  ResultsReader(const std::string& path, const RowFormat& format);
  ~ResultsReader();
  ResultsReader(ResultsReader&&) noexcept;

  /// Its tables are those of format.tables that the file has.
  const StudyIdentity& identity() const { return identity_; }
  const std::vector<EnvironmentEntry>& environment() const { return environment_; }
  std::size_t size() const;
  /// Returns record i in the layout of the format, valid until the next call; cheap if i is near
  /// the one before. What the file has no column for is missing: -1, NaN or empty.
  /// @throws InputError naming the file.
  const char* read(std::size_t i);

 private:
  struct File;
  StudyIdentity identity_;
  std::vector<EnvironmentEntry> environment_;
  std::unique_ptr<File> file_;
};

/// Writes FILE.h5 atomically: a new file beside it, fsync, rename. @throws InputError if it cannot
/// (a disk that gets full leaves nothing behind).
/// Memory: a few hundred rows, and 40 bytes per record of the extract.
void write_results(const StudyIdentity& identity, const std::vector<EnvironmentEntry>& environment,
                   const RowFormat& format, const RecordSource& rows, const std::string& path);

/// Returns the version of the HDF5 library in use, "1.10.8".
std::string hdf5_version();

}  // namespace ar3d
