#include "join_ranks.h"

namespace ar3d {

std::unique_ptr<Ranks> join_ranks() { return std::make_unique<Ranks>(); }

}  // namespace ar3d
