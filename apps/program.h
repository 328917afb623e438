#pragma once

namespace ar3d {

/// Runs the whole program `ar3d`: all verbs, with the rows of the catalogues at the time of the
/// call. A program that brings an algorithm, a family or a metric of its own registers it
/// (register_algorithm, register_family, register_metric) and calls this.
/// @return the exit code (docs/contracts.md). Throws nothing.
int run_program(int argc, char** argv);

}  // namespace ar3d
