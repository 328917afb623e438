#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ar3d/bench/search/trial.h"

namespace ar3d {

/// What `hunt` and `shrink` share: which drawings, which share of which bound, and where the
/// exhibit goes.
struct SubjectArguments {
  std::string algorithm;
  std::vector<std::string> options;
  std::string seeded_fault;
  std::string measure = "side";
  std::string against = "theorem";
  std::string output;
  bool force = false;
};

void add_subject_options(CLI::App& verb, SubjectArguments& arguments);

/// @throws InputError naming what is unknown.
Subject subject_of(const SubjectArguments& arguments);
RatioRule rule_of(const SubjectArguments& arguments);

/// "extent x 12 of 16 (75.0 %), …; ratio 0.75", and the failure if there is one.
std::string trial_text(const Trial& trial, const SubjectArguments& arguments);

/// The line that shrinks the graph of PREFIX.s6 and keeps what the trial shows: its violation, or
/// its ratio to the last digit.
std::string shrink_line(const Trial& trial, const SubjectArguments& arguments);

/// @throws InputError if the exhibit would go to a stream, over `input` or over somebody's results.
void refuse_unsafe_exhibit(const SubjectArguments& arguments, const std::string& input);

/// Writes PREFIX.s6 (the graph), PREFIX.jsonl (its drawing), PREFIX.svg (a picture, if it is small
/// enough for one) and PREFIX.txt (what it shows and the lines that show it again), and prints
/// their names. @throws InputError if one cannot be written.
void write_exhibit(const Subject& subject, const Trial& trial, const SubjectArguments& arguments);

}  // namespace ar3d
