// The program without MPI is a single rank. The program for mpirun links mpi/mpi_ranks.cpp instead
// of this file.
#include <fmt/format.h>

#include <cstdlib>

#include "ar3d/base/error.h"
#include "ar3d/bench/run/ranks.h"

namespace ar3d {

std::unique_ptr<Ranks> join_ranks() {
  const char* const ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (ranks != nullptr && std::atoi(ranks) > 1) {
    throw InputError(fmt::format(
        "mpirun started {} of this program, which knows nothing of the others: ar3d-mpi shares the "
        "rows",
        ranks));
  }
  return std::make_unique<Ranks>();
}

}  // namespace ar3d
