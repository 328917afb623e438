#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/search/hunt.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {

/// Holds which drawings, which share of which bound, and where the exhibit goes.
struct HuntArguments {
  std::string algorithm;
  std::vector<std::string> settings;  // of the algorithm; of `hunt`, at first, of the family, too
  std::string study;                  // whose program the algorithm may be
  std::string seeded_fault;
  std::string measure = "side";
  std::string against = "theorem";
  std::string output;
  bool force = false;
  std::vector<std::string> inputs;  // graphs to hunt from, or the one to shrink
  std::string row;                  // given: the input is a results file, and its graph is meant
  ReadOptions reading;              // of it
  std::string family = "all";       // of `hunt`, as the next two
  std::vector<std::string> parameters;
  HuntOptions hunting;
  std::optional<double> ratio;  // of `shrink`, as the next two
  std::string failure;
  std::uint64_t most_drawings = 100000;
};

/// Returns why the graph is not drawn, as --failure has it; empty if it is.
std::string kind_of_failure(const Trial& trial);
/// Returns kPass, kViolated, or kIncomplete of a graph that is not drawn: a failure is no violation.
int exit_code_of(const Trial& trial);

nlohmann::ordered_json trial_json(const Trial& trial, const HuntArguments& arguments);
/// Returns size, box and share of the bound, and what failed if something did, in lines.
std::string trial_text(const Trial& trial, const HuntArguments& arguments);

/// Returns the line that shrinks the graph of PREFIX.s6 and keeps what the trial shows: its
/// violation, its failure, or its ratio to the last digit.
std::string shrink_line(const Trial& trial, const HuntArguments& arguments);

/// Writes PREFIX.s6 (the graph), PREFIX.jsonl (its drawing), PREFIX.svg (a picture, if it is small
/// enough for one) and PREFIX.txt (what it shows and the lines that show it again), and prints
/// their names. @throws InputError if one cannot be written.
void write_exhibit(const Trial& trial, const HuntArguments& arguments);

}  // namespace ar3d
