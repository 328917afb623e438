#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "ar3d/store/run_storage.h"

namespace ar3d {

/// The rows of one study, looked at one at a time, so that millions of them need not fit into
/// memory. What it points at outlives it.
struct RowView {
  const StudyIdentity* identity = nullptr;
  const std::vector<EnvironmentEntry>* environment = nullptr;
  std::size_t count = 0;
  std::int64_t planned = -1;  ///< rows that the study is complete with; -1: unknown
  /// Row 0 … count - 1, valid until the next call; cheap in increasing order. @throws InputError
  std::function<const RunRecord&(std::size_t row)> read;
};

RowView view_of(const Results& results);
RowView view_of(RunReader& reader);

}  // namespace ar3d
