#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/model/guarantee.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Describes a record of /algorithms: what follows from algorithm and options for every input.
struct AlgorithmRecord {
  std::string algorithm;
  std::string options;  ///< "effort=1", complete and in catalogue order
  SizeBound theorem;
  std::optional<SizeBound> published;  ///< of others, for comparison only
  std::int64_t max_bends = -1;  ///< of an edge, as promised; -1: in results that do not say it
};

/// Describes a record of /graph_files: a file, or a collection, whose graphs are instances.
struct GraphFileRecord {
  std::string name;          ///< the family of its rows
  std::int64_t entry = 0;    ///< which entry of the specification's `graphs` it is of, from 0
  std::int64_t graphs = -1;  ///< in the file, or in all files
  std::string hash;          ///< of its graphs, 32 hexadecimal digits
  std::string path;  ///< absolute, where the study found it; a collection's pattern or folder
  std::string groups = {};  ///< absolute path of a collection's table of groups, if it has one
};

/// Describes a record of /skipped_files: a file of a collection that could not be read.
struct SkippedFile {
  std::string name;    ///< of the collection
  std::string file;    ///< within it; cut where it is too long
  std::string reason;  ///< cut, too
};

/// Describes a record of /collected_files: a file whose graphs are instances, as it was read.
struct CollectedFile {
  std::string name;         ///< family of its rows
  std::string file;         ///< path within the collection; empty: the file of /graph_files itself
  std::string group;        ///< in rows
  std::string hash;         ///< of its graphs
  std::int64_t first = 0;   ///< index of its first graph among those of its family
  std::int64_t graphs = 0;  ///< in it
  bool operator==(const CollectedFile&) const = default;
};

/// Returns names and columns of the tables that may stand beside the rows, those of records and
/// /graphs.
const std::vector<StoredTable>& side_table_specs();

/// Returns the table of records of one of the four kinds above. @throws InputError if a text does
/// not fit its column (in a path each byte that is no printable ASCII counts three).
template <class Record>
StoredTable side_table(const std::vector<Record>& records);

/// Returns the records of a study's table; none if it has no such table.
/// @throws InputError naming the column if a bound of /algorithms is none.
template <class Record>
std::vector<Record> side_records(const StudyIdentity& identity);

/// Returns /environments for texts of so many bytes, the table of these entries, and its entries.
StoredTable environments_spec(std::size_t name_bytes, std::size_t value_bytes);
StoredTable environments_table(const std::vector<EnvironmentEntry>& environment);
std::vector<EnvironmentEntry> environment_of(const StoredTable& table);

/// Returns the record of a run's algorithm and options; null if there is none.
const AlgorithmRecord* find_algorithm_record(const std::vector<AlgorithmRecord>& records,
                                             std::string_view algorithm, std::string_view options);

/// Sets theorem_bound and published_bound of a run from its n. Those of a run without n, and of a
/// bound that is null, are missing.
void set_bounds(const SizeBound* theorem, const SizeBound* published, RunRecord& run);

/// Counts the files of all collections of a study. @return those that were read, and all.
std::pair<std::size_t, std::size_t> file_counts(const StudyIdentity& identity);

/// Describes the graphs that results hold: by family and index a line of sparse6 without its end.
using StoredGraphs = std::map<std::string, std::map<std::uint32_t, std::string>>;
/// Returns the table /graphs of these graphs, each text once.
StoredTable graphs_table(const StoredGraphs& graphs);
/// Returns the graphs of a study's table. @throws InputError naming what is no word of it.
StoredGraphs stored_graphs(const StudyIdentity& identity);

/// Adds to a study's collected files, skipped files and graphs those of another part of it; then
/// files are in the order of their names. @return false if both have the same files. @throws
/// InputError if they have not, and one of them does not hold its graphs.
bool unite_files(StudyIdentity& all, const StudyIdentity& other);

}  // namespace ar3d
