#pragma once

#include <omp.h>

#include <CLI/CLI.hpp>

#include "numbers.h"

namespace ar3d {

/// Of verbs that work on many drawings at the same time, or on a large one with several threads.
inline void add_threads_option(CLI::App& verb) {
  verb.add_option_function<int>(
          "--threads", [](int threads) { omp_set_num_threads(threads); },
          "drawings worked on at the same time, or threads for a single large one; as many as "
          "cores if left out; what comes out is the same")
      ->check(whole_number(1, 1024));
}

}  // namespace ar3d
