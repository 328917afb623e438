#pragma once

#include <cstdint>
#include <string>

#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// The study of one cell of another one: its graphs with their seeds, its algorithm and options.
/// @param cell  as cell_label() says it.
/// @param timed_repetitions  of every drawing; 0: none is timed.
/// @throws InputError naming the cell, and the nearest, if the study has no such cell, or if its
/// graphs are of a file or its algorithm is a program.
StudySpec study_of_cell(const StudySpec& spec, const std::string& cell, int timed_repetitions);

}  // namespace ar3d
