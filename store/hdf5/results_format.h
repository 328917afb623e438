#pragma once

// What writer and reader of a results file share. The page results/SCHEMA.md describes it.

#include <algorithm>
#include <string>
#include <vector>

#include "ar3d/base/descriptor.h"
#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/hdf5/hdf5_table.h"

namespace ar3d {

inline constexpr const char* kResultsFormat = "ar3d-results";
inline constexpr long long kResultsFormatVersion = 3;
inline constexpr long long kFormerVersion = 2;  ///< is read, not written

/// /environments: session, name and value, as wide as they are.
inline TableSpec environments_table(std::size_t name_size, std::size_t value_size) {
  TableSpec table{"environments", "machine, compiler, libraries and settings of every session", {}};
  table.fields = {
      {"session", "1", "which process of the study", FieldType::int64, sizeof(std::int64_t)},
      {"name", "", "what is described", FieldType::text, std::max<std::size_t>(1, name_size)},
      {"value", "", "its value", FieldType::text, std::max<std::size_t>(1, value_size)}};
  pack_fields(table.fields);
  return table;
}

/// Fills an empty, readable and writable file, with its checksum at the end; `path` is for
/// messages.
/// @throws InputError as write_results.
void write_results_into(int descriptor, const StudyIdentity& identity,
                        const std::vector<EnvironmentEntry>& environment, const RowFormat& format,
                        const RecordSource& rows, const std::string& path);

/// An open file of this very program: its checksum is right.
struct OpenResults {
  Hdf5Handle file;
  std::uint64_t bytes;
  StudyIdentity identity;
  std::vector<EnvironmentEntry> environment;
};
/// Opens what the descriptor stands for. @throws Hdf5Error, InputError
OpenResults open_results(int descriptor, long long version, const RowFormat& format);

/// A file whose name goes when this does; what has it open keeps it.
class TemporaryFile {
 public:
  /// @throws InputError if there can be none.
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  int descriptor() const { return descriptor_.get(); }

 private:
  std::string path_;
  Descriptor descriptor_;
};

/// Writes a file of version 2 as one of version 3 into an empty file, in a process of its own.
/// @throws Hdf5Error, InputError
void convert_former(int former, int converted, const RowFormat& format, const std::string& path);

}  // namespace ar3d
