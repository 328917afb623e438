#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ar3d/base/print.h"
#include "ar3d/formats/graphs/graph_format.h"

// Options that several verbs have, and what their values may be.
namespace ar3d {

/// Returns whole numbers from low to high, written with digits alone: CLI11 reads "-5" as 2^64 - 5,
/// and "1e9" or "0x10" in ways of its own.
CLI::Validator whole_number(std::uint64_t low,
                            std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
/// Returns decimal numbers that are finite, and above 0 if `positive`.
CLI::Validator finite_number(bool positive);
/// Returns decimal numbers from low to high.
CLI::Validator number_between(double low, double high);
/// Returns one of the known words; any other is answered with all of them and the nearest one.
CLI::Validator one_of(std::vector<std::string> known);

/// Returns an option that may be repeated, each time with one value.
CLI::Option* add_repeated(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                          const std::string& what);

/// Adds --threads to verbs that work on many drawings at a time, or with threads on a large one.
void add_threads_option(CLI::App& verb);

/// What -q, which every verb has, and --json ask of the verb that runs.
inline bool is_quiet_output = false, is_json_output = false;

/// Returns the flag --json of verbs with a result: one JSON object instead of text.
CLI::Option* add_json(CLI::App& verb);
/// Prints it on one line, in ASCII: other characters are escaped, bytes that are no UTF-8 replaced.
void print_json(const nlohmann::ordered_json& json);

/// Prints what is not in the JSON object: nothing on stderr with -q, nothing on stdout with --json.
template <class... Values>
void log(std::FILE* to, fmt::format_string<Values...> format, Values&&... values) {
  if (to == stderr ? is_quiet_output : is_json_output) return;
  ar3d::print(to, format, std::forward<Values>(values)...);
}

/// Prints a result: as text, or with --json as that object.
template <class... Values>
void print_result(const nlohmann::ordered_json& json, fmt::format_string<Values...> format,
                  Values&&... values) {
  if (is_json_output) return print_json(json);
  ar3d::print(format, std::forward<Values>(values)...);
}

/// Prints on standard error what a reader has assumed, a line each.
void log_notes(const std::vector<std::string>& notes);

/// Adds the options --base, --first-line and --undirected.
void add_edge_list_options(CLI::App& verb, ReadOptions& options);

/// Adds these and --from and --trust-sizes.
void add_graph_input_options(CLI::App& verb, ReadOptions& options);

}  // namespace ar3d
