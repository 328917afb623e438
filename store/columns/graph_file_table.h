#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/store/study_identity.h"

namespace ar3d {

/// A record of /graph_files: a file whose graphs are instances of the study.
struct GraphFileRecord {
  std::string name;          ///< the family of its rows
  std::int64_t entry = 0;    ///< which entry of the specification's `graphs` it is of, from 0
  std::int64_t graphs = -1;  ///< in the file
  std::string hash;          ///< of its graphs, 32 hexadecimal digits
  std::string path;          ///< absolute, where the study found it
};

/// The name and the fields of /graph_files.
const TableSpec& graph_files_spec();

/// The table of these records. @throws InputError if a path is longer than 1024 bytes (each that is
/// no printable ASCII counts three).
StoredTable graph_file_table(const std::vector<GraphFileRecord>& records);

/// The records of /graph_files of a study; none if it has no such table.
std::vector<GraphFileRecord> graph_file_records(const StudyIdentity& identity);

}  // namespace ar3d
