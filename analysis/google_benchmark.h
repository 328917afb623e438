#pragma once

#include <string>

#include "ar3d/analysis/export.h"

namespace ar3d {

/// The timed rows as a Google Benchmark report, so that its tools (compare.py) work on them: a row
/// is an iteration named draw/ALGORITHM[/OPTIONS]/FAMILY[/PARAMETERS]/N/instance:I, its repetition
/// is repetition_index. Rows that did not end ok carry error_occurred and their message. Where a
/// study has a timing phase, its rows are the ones written. Reads every row twice.
void google_benchmark_json(const RowView& rows, const TextSink& write);

/// Reads a Google Benchmark report: every iteration becomes an ok row whose algorithm is the
/// benchmark's name and whose wall_s and cpu_s are its times per iteration; aggregates are left
/// out. Counters named INSTRUCTIONS become counted_instructions. The study is called "Google
/// Benchmark".
/// @throws InputError naming the file and what is wrong with it.
Results read_google_benchmark(const std::string& path);

/// A results file or a Google Benchmark report, whichever the content shows.
/// @throws InputError as read_results and read_google_benchmark.
Results read_results_or_benchmarks(const std::string& path);

}  // namespace ar3d
