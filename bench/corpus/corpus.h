#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {

/// Represents graphs in a temporary file that has no name any more: it goes with the last process
/// that has it open. Each is stored as a line of sparse6: about an edge a byte of a small graph.
class Spool {
 public:
  /// @throws InputError if the folder for temporary files (TMPDIR, else /tmp) takes no file.
  Spool();

  /// @return where the graph stands. @throws InputError if the disk is full.
  std::uint64_t append(const Graph& graph);
  /// Writes what waits; to be called behind the last append(). @throws as append().
  void flush();
  /// Returns the graph that stands there; called by any number of threads and forked processes at
  /// once.
  /// @throws InputError if it cannot be read.
  Graph read(std::uint64_t offset) const;

  int descriptor() const { return file_.get(); }

 private:
  std::string name_;  // that it had, for messages
  Descriptor file_;
  std::uint64_t end_ = 0;  // of the file, buffer_ included
  std::string buffer_;     // not written yet
};

/// Describes a file of a corpus.
struct CorpusFile {
  std::string path;
  std::string name;          ///< of its graph in rows; empty where the corpus is one file
  std::string group;         ///< in rows
  std::string problem = {};  ///< why it cannot be read; empty if no error is known yet
  std::string file = {};     ///< path within the collection; empty where the corpus is one file
  /// Holds the file as a study has read it before. Given: nothing is read, its graphs are these.
  std::optional<CollectedFile> held = {};
  std::map<std::uint32_t, std::string> lines = {};  ///< of sparse6, by index
};

/// Represents the graphs of files, read once and kept in a temporary file without a name, so that
/// any of them can be had again in any order by any thread, and by forked processes. Memory: 28
/// bytes a graph, names and a hash a file, and one graph at a time.
class Corpus {
 public:
  /// Reads the files whole (graphs in any format, packed or not). Behind files that are held, one
  /// is left out that holds what a held file of its name does.
  /// @throws InputError naming file and line if a graph cannot be read; if there are more than 10^7
  /// graphs and no sample is taken; if the temporary file cannot be written.
  /// @param taken  how; the files that it names are not looked at.
  /// @param name  by which a study and its results know it.
  Corpus(const std::vector<CorpusFile>& files, const GraphsEntry& taken,
         const std::string& name = "");
  Corpus(const std::string& path, const GraphsEntry& taken)
      : Corpus(std::vector<CorpusFile>{{path, "", ""}}, taken) {}

  /// Returns the family of that name; every n is its own nearest; it generates nothing.
  const Family& family() const { return family_; }
  /// Returns, of one file, XXH3-128 of its graphs in order (each one's n and edges), as 32
  /// hexadecimal digits: the same in every format, packed or not, and whatever options take of
  /// them. Of a collection: of names, groups and hashes of its files.
  const std::string& hash() const { return hash_; }
  std::uint64_t graphs_in_file() const { return graphs_in_file_; }
  /// Returns files left out because of GraphsEntry::skip; their collection has no name yet.
  const std::vector<SkippedFile>& skipped() const { return skipped_; }

  /// Returns what was assumed where a file left a choice, a line each (GraphReader::take_notes).
  const std::vector<std::string>& notes() const { return notes_; }

  /// Returns which files are added, changed and gone, compared with those that were held: what they
  /// hold by now is added.
  const std::array<std::vector<std::string>, 3>& growth() const { return growth_; }
  /// Returns the files with graphs, by index; their family has no name yet.
  const std::vector<CollectedFile>& files() const { return files_; }

  /// Returns the file that holds the graph at that index. O(log files).
  const CollectedFile& file_at(std::uint32_t index) const { return files_[number_at(index)]; }
  /// Returns how many files before that one have the same graphs.
  std::uint32_t copy_at(std::uint32_t index) const { return copies_[number_at(index)]; }
  /// Returns the name of its file, "#3" behind it if that holds several; of 96 bytes at most, the
  /// last.
  std::string graph_name(std::uint32_t index) const;
  /// Returns how many of the graphs taken have a vertex of larger degree.
  std::size_t count_above(std::uint32_t max_degree) const;

  /// Gives the graphs taken, by number of vertices and, where that is equal, by index in the file.
  std::size_t size() const { return order_.size(); }
  /// Returns the index among the graphs of all files, from 0. @pre i < size().
  std::uint32_t index(std::size_t i) const { return entries_[order_[i]].index; }
  /// Returns the number of vertices of that graph.
  Vertex n(std::size_t i) const { return entries_[order_[i]].n; }
  /// Returns the first i with n(i) >= wanted, or the last one; rather the nearest one of no larger
  /// degree than allowed. @pre size() > 0.
  std::size_t first_of_size(std::uint64_t wanted, std::uint32_t max_degree) const;

  /// Returns the graph taken from that index. O(n + m).
  /// @throws InputError if no graph was taken from there.
  Graph graph(std::uint32_t index) const;

  /// Returns a file descriptor that users of the corpus leave open.
  int descriptor() const { return spool_.descriptor(); }

 private:
  struct TakenGraph {
    std::uint64_t offset = 0;  // in the spool
    Vertex n = 0;
    std::uint32_t index = 0;
    std::uint32_t max_degree = 0;
  };
  class Scan;
  std::size_t number_at(std::uint32_t index) const;  // of the file

  Family family_;
  std::string path_;  // of the file being read, or of the last one
  std::string hash_;
  std::vector<CollectedFile> files_;   // those with graphs, by index
  std::vector<std::string> names_;     // of their graphs in rows
  std::vector<std::uint32_t> copies_;  // how many files before each have the same graphs
  std::vector<SkippedFile> skipped_;
  std::vector<std::string> notes_;
  std::array<std::vector<std::string>, 3> growth_;
  std::uint64_t graphs_in_file_ = 0;
  std::vector<TakenGraph> entries_;   // by index
  std::vector<std::uint32_t> order_;  // indices in entries_, by n and index
  Spool spool_;
};

/// Returns the graph on the vertices with keep[v], renamed in order. O(n + m).
Graph induced(const Graph& graph, const std::vector<bool>& keep);

/// Returns the subgraph that the first `n` vertices of a breadth-first search induce (from vertex
/// 0, then from the smallest vertex left), numbered as they are found; the graph itself if it has
/// no more. Degrees only fall. O(n + m).
Graph breadth_first_piece(const Graph& graph, std::uint64_t n);

}  // namespace ar3d
