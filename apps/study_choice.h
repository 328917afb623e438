#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ar3d/bench/spec/study_spec.h"
#include "graph_input.h"

namespace ar3d {

/// Which study a verb is about: one of a name or a file, or graphs of files.
struct StudyChoice {
  std::string study;
  GraphsStudy graphs;
  GraphInput reading;  ///< of the graphs
};

void add_study_choice(CLI::App& verb, StudyChoice& choice);

/// @throws InputError as load_study; unless exactly one of STUDY and --graphs is given.
StudySpec chosen_study(const StudyChoice& choice);

}  // namespace ar3d
