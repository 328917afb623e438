#pragma once

#include <fcntl.h>

#include <string>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/rows.h"
#include "support/test.h"

namespace ar3d::testing {

/// The rows of two results files are equal, in the same order, in all columns but the measured
/// ones.
inline void expect_same_rows(const std::string& a, const std::string& b) {
  const Results left = read_results(a);
  const Results right = read_results(b);
  ASSERT_EQ(left.runs.size(), right.runs.size()) << a << ' ' << b;
  for (std::size_t i = 0; i < left.runs.size(); ++i) {
    EXPECT_EQ(differing_columns(left.runs[i], right.runs[i]), std::vector<std::string>())
        << "row " << i << " of " << a << " and " << b;
  }
}

/// Makes the checksum of a results file right again that h5py has changed.
inline void renew_checksum(const std::string& path) {
  const Descriptor file(open(path.c_str(), O_RDWR));
  EXPECT_EQ(append_checksum(file.get()), 0) << path;
}

/// Every column of a row, measured ones and session too, as its bytes.
inline std::string all_bytes(const RunRecord& run) {
  std::string record(run_record_size(), '\0');
  store_record(run, record.data());
  return record;
}

}  // namespace ar3d::testing
