#pragma once

#include <string>

#include "ar3d/base/random.h"
#include "ar3d/store/columns/run_columns.h"
#include "store/sample_runs.h"
#include "support/problem.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {

/// How reading forged files has ended.
struct ForgedReads {
  int read = 0;     ///< rows came
  int refused = 0;  ///< an InputError of one line that names the file
  int crashed = 0;  ///< of these: the process that reads them
};

/// Changes up to eight bytes of a results file, makes its checksum right again and reads it,
/// `count` times. That this returns is what is tested.
inline ForgedReads read_forged_files(int count, std::uint64_t seed) {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("r.h5");
  write_results(sample_results(3), path);
  const std::string whole = read_file(path);
  RandomStream random(seed);
  ForgedReads reads;
  for (int i = 0; i < count; ++i) {
    std::string forged = whole.substr(0, whole.size() - kChecksumSize);
    for (std::uint64_t byte = 0; byte < 1 + random.below(8); ++byte) {
      forged[random.below(static_cast<std::uint32_t>(forged.size()))] =
          static_cast<char>(random.below(256));
    }
    scratch.write("r.h5", forged);
    renew_checksum(path);
    const std::string told = problem([&] { read_results(path); }, "");
    reads.read += told.empty();
    reads.refused += !told.empty();
    reads.crashed += told.find("has crashed") != std::string::npos;
    EXPECT_TRUE(told.empty() || told.find("r.h5") != std::string::npos) << told;
    EXPECT_EQ(told.find('\n'), std::string::npos) << told;
  }
  return reads;
}

}  // namespace ar3d::testing
