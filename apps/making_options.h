#pragma once

#include <CLI/CLI.hpp>

#include "ar3d/bench/run/make_rows.h"

namespace ar3d {

/// Options of every verb that makes rows of a study.
inline void add_making_options(CLI::App& verb, MakingPolicy& policy) {
  verb.add_flag("--isolate", policy.isolate,
                "make rows in processes of their own: a crash is one row's status");
  verb.add_flag("--force-timing", policy.force_timing,
                "time even in a debug or sanitised build (its rows are marked)");
}

}  // namespace ar3d
