#pragma once

#include <cstdint>

namespace ar3d::testing {

/// Runs small studies and kills them `kills` times, at random times and at random calls that change
/// files (before, in the middle of, and after the call), resuming after each until they are
/// complete. Expects that every row acknowledged before a kill is there after it and never changes,
/// and that every completed study equals an uninterrupted one in all columns but the measured ones.
void kill_and_resume(int kills, std::uint64_t seed);

}  // namespace ar3d::testing
