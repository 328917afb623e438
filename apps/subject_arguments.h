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
  std::string plant;
  std::string measure = "side";
  std::string against = "theorem";
  std::string output;
};

void add_subject_options(CLI::App& verb, SubjectArguments& arguments);

/// Numbers above 0; not NaN, which CLI11's own checks let pass.
CLI::Validator positive_number();

/// @throws InputError naming what is unknown.
Subject subject_of(const SubjectArguments& arguments);
RatioRule rule_of(const SubjectArguments& arguments);

/// "extent x 12 of 16 (75.0 %), …; ratio 0.75", and the failure if there is one.
std::string trial_text(const Trial& trial, const SubjectArguments& arguments);

/// Writes PREFIX.s6 (the graph), PREFIX.jsonl (its drawing), PREFIX.svg (a picture, if it is small
/// enough for one) and PREFIX.txt (what it shows and the lines that show it again), and prints
/// their names. @throws InputError if one cannot be written.
void write_exhibit(const Subject& subject, const Trial& trial, const SubjectArguments& arguments);

}  // namespace ar3d
