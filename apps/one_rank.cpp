// The program without MPI is a single rank. The program for mpirun links mpi/mpi_ranks.cpp instead
// of this file.
#include "join_ranks.h"

namespace ar3d {

std::unique_ptr<Ranks> join_ranks() { return std::make_unique<Ranks>(); }

}  // namespace ar3d
