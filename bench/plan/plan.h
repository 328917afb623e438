#pragma once

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {

struct CorpusFile;  // bench/corpus/corpus.h

/// Describes one row to come: an algorithm with options, and which repetition.
struct PlannedRun {
  AlgorithmChoice choice;
  std::string options;  ///< "effort=1"
  std::uint32_t repetition = 0;
  std::string row_key;  ///< 32 hexadecimal digits
  std::size_t row = 0;  ///< index in the results
  RunPhase phase = RunPhase::metrics;
  std::int64_t workers = -1;  ///< threads or ranks that share the row's batch; -1: it is in none
  std::uint32_t batch = 0;    ///< rows of one phase, batch and number of workers are drawn together
  /// A study is complete without it: it is only made while the times before it are not
  /// stable within `precision`.
  bool optional = false;
  double precision = 0;
};

/// Returns true if both runs make the same drawing of an instance at the same level, judged alike.
bool is_same_drawing(const PlannedRun& a, const PlannedRun& b);

/// Describes one graph to come and everything that is done with it.
struct PlannedInstance {
  FamilyChoice choice;
  std::string parameters;  ///< "k=2;p=750000"
  std::uint64_t requested_n = 0;
  std::uint64_t n = 0;      ///< what the family makes of requested_n
  std::uint32_t index = 0;  ///< of a corpus: the graph's index in the file
  std::uint64_t seed = 0;  ///< a function of the study's seed, family, parameters, n and index only
  std::vector<PlannedRun> runs;
};

CurveKey curve_of(const PlannedInstance& instance, const PlannedRun& run);

/// Returns the graph of an instance; of a corpus its labels are permuted by the seed where the
/// parameters say so. Of a corpus with requested_n below the graph's n: the piece of
/// it that a breadth-first search finds first.
/// @throws InputError if the family has no such graph.
Graph graph_of(const PlannedInstance& instance);

/// Gives the instance its seed and its runs their keys, functions of the study's seed and of what
/// the instance and the runs say of themselves.
void set_seed_and_keys(std::uint64_t study_seed, PlannedInstance& instance);

/// Returns the number of runs that a study is not complete without.
std::size_t required_runs(const PlannedInstance& instance);

/// Describes instances that follow each other and differ in their index only, and hence in seed and
/// keys.
struct PlannedBlock {
  /// Holds the first of them. Its runs have no keys, unless it stands alone and as it is.
  PlannedInstance first;
  std::size_t count = 0;
  std::size_t first_index = 0;  ///< of the first instance among all
  std::size_t first_row = 0;    ///< of the first instance's first run
};

/// Represents the instances of a plan in order: blocks, and the index of every instance. An
/// instance is made when it is asked for. Memory: 4 bytes an instance.
class PlannedInstances {
 public:
  explicit PlannedInstances(std::uint64_t study_seed = 0) : study_seed_(study_seed) {}

  std::size_t size() const { return indices_.size(); }
  std::size_t rows() const { return rows_; }
  /// Makes an instance afresh by every call: about 1 us per row. @pre i < size().
  PlannedInstance operator[](std::size_t i) const;
  const std::vector<PlannedBlock>& blocks() const { return blocks_; }

  /// Begins a block with the first of its instances. @pre it has runs.
  void push_back(PlannedInstance first);
  /// Appends to the last block an instance that differs from its first one in this index.
  void add(std::uint32_t index);
  /// Returns, of these instances, index `first` and every n-th after it. @pre first < n.
  PlannedInstances every_nth(std::size_t first, std::size_t n) const;
  /// Returns one of n parts. Where the graph of a file goes is a function of the file's graphs and
  /// its number there, so that files that come move none; others are dealt out in turn. @pre
  /// part < n.
  PlannedInstances part_of(std::size_t part, std::size_t n) const;

  auto begin() const { return iterator(0); }
  auto end() const { return iterator(size()); }

 private:
  boost::transform_iterator<std::function<PlannedInstance(std::size_t)>,
                            boost::counting_iterator<std::size_t>>
  iterator(std::size_t i) const {
    return {boost::counting_iterator<std::size_t>(i), [this](std::size_t i) { return (*this)[i]; }};
  }

  PlannedInstances those(
      const std::function<bool(const PlannedBlock& block, std::size_t i)>& is_taken) const;

  std::uint64_t study_seed_;
  std::vector<PlannedBlock> blocks_;
  std::vector<std::uint32_t> indices_;  // by index
  std::size_t rows_ = 0;
};

/// Describes all rows of a study, in the order of the specification: family, parameters, size,
/// index, algorithm, options, repetition. Two sizes that a family rounds to the same n are one
/// instance; a row that two sweeps ask for is planned once.
struct StudyPlan {
  PlannedInstances instances;
  TimingRules timing;  ///< of the specification
  Budget budget;       ///< of the specification
  /// Holds by algorithm the families that it leaves out, because their degrees pass its largest
  /// one.
  std::map<const Algorithm*, std::set<std::string>> left_out;
  std::size_t rows() const { return instances.rows(); }
};

/// Leaves out an algorithm where the family's graphs pass its maximum degree (found by generating
/// one of at most 1000 vertices) or n passes spec.max_n. Graphs of files that pass a maximum degree
/// are planned: their rows say `refused`.
/// @throws InputError if nothing is left or there are more than 10^7 rows; as corpora_of.
/// Memory: that of the families and sizes, and 4 bytes an instance; for graphs of files see Corpus.
StudyPlan plan_study(const Study& study);

/// Returns true if a run of the instance is of a phase that is meant.
bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant);
/// Returns true if any instance of the plan has one.
bool has_run(const StudyPlan& plan, const std::function<bool(RunPhase)>& is_meant);

/// Returns the work that a row of n vertices is, in a unit that is roughly proportional to time.
double work_of_row(std::uint64_t n);

/// Returns the indices of plan.instances, the most costly first, so that no large one is left to the
/// end; equally costly ones in the plan's order.
std::vector<std::uint32_t> largest_first(const StudyPlan& plan);

/// Describes a file, or a collection of files, of a study whose graphs are instances, opened.
struct StudyCorpus {
  const Sweep* sweep = nullptr;        ///< of the specification
  const GraphsEntry* entry = nullptr;  ///< of that sweep
  GraphFileRecord record;
  std::shared_ptr<const Corpus> corpus;

  /// Returns the family and parameters of its instances, for each of the entry's shuffles.
  std::vector<FamilyChoice> choices() const;
};

/// Returns every file of the specification's `graphs`, in its order; those that a pattern matches
/// by name, and those of a collection as one. A study that has begun has the files that it began
/// with. Each is read once for all copies of the specification.
/// @param only  given: just the files called so.
/// @throws InputError naming the entry: a file that is missing or cannot be read, a pattern without
/// match, a name that a family of the catalogue or another file has, two files with the same
/// graphs; naming the file: one that has changed since the study began.
std::vector<StudyCorpus> corpora_of(const Study& study, const std::string& only = "");

/// Returns the files whose graphs are instances, not opened; none of a pattern that matches nothing
/// now.
std::vector<std::string> graph_files_of(const Study& study);

// The files themselves (collected_files.cpp).

bool is_pattern(const std::string& file);
[[noreturn]] void refuse_empty(const GraphsEntry& entry);
/// Returns what matches, by name (no folders); the path itself where it exists under that very name,
/// or is no pattern. Of a collection also everything in folders that match, except files that a
/// study has beside its graphs. A study looks once: it always gets this first list.
/// @throws InputError naming what cannot be read.
const std::vector<std::string>& listed_files(const Study& study, const std::string& path,
                                             bool is_collection);
/// Returns the files that are there now and were not when the study listed its collections.
std::vector<std::string> files_come_since(const Study& study);
/// Returns the files of a collection with their names behind its folder, and their groups:
/// sub-folders, or as the table says. @throws InputError as above, and naming a line of the table
/// that is none.
std::vector<CorpusFile> collected_files(const GraphFileRecord& record, const GraphsEntry& entry,
                                        const Study& study);

}  // namespace ar3d
