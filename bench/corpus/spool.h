#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// Graphs in a temporary file that has no name any more: it goes with the last process that has it
/// open. Each is stored as n, m and the differences of its edges, 7 bits a byte: about 2 bytes an
/// edge of a small graph.
class Spool {
 public:
  /// @throws InputError if the folder for temporary files (TMPDIR, else /tmp) takes no file.
  Spool();

  /// @return where the graph stands. @throws InputError if the disk is full.
  std::uint64_t append(const Graph& graph);
  /// To be called behind the last append(). @throws as append().
  void flush();
  /// The graph that stands there; called by any number of threads and forked processes at once.
  /// @throws InputError if it cannot be read.
  Graph read(std::uint64_t offset) const;

  int descriptor() const { return file_.get(); }

 private:
  std::string name_;  // that it had, for messages
  Descriptor file_;
  std::uint64_t end_ = 0;     // of the file, buffer_ included
  std::vector<char> buffer_;  // not written yet
};

}  // namespace ar3d
