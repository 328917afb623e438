#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ar3d/results/run_record.h"

namespace ar3d {

/// A results file, read row by row.
class ResultsReader {
 public:
  /// @throws InputError as read_results.
  explicit ResultsReader(const std::string& path);
  ~ResultsReader();
  ResultsReader(ResultsReader&&) noexcept;

  const StudyIdentity& identity() const { return identity_; }
  const std::vector<EnvironmentEntry>& environment() const { return environment_; }
  std::size_t size() const;
  /// The record of row i, valid until the next call; cheap if i is near the one before.
  /// @throws InputError naming the file.
  const char* read(std::size_t i);

 private:
  struct File;
  StudyIdentity identity_;
  std::vector<EnvironmentEntry> environment_;
  std::unique_ptr<File> file_;
};

}  // namespace ar3d
