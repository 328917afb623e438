#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/curves.h"

namespace ar3d {

/// Describes a study whose timing phase lets two versions of something take turns.
struct TurnsStudy {
  Study study;
  std::vector<SettingPair> pairs;         ///< which of its settings are compared
  std::vector<std::string> remarks = {};  ///< one line each
};

/// Holds one side of a comparison in turns.
struct TurnsSide {
  Study study;
  std::optional<CurveKey> setting = {};  ///< the only one that is compared; nothing: all are
};

/// Returns all settings of a study, each once.
std::vector<CurveKey> settings_of(const StudySpec& spec);

/// Returns one study of two that differ in their programs and the algorithms of their sweeps only.
/// The settings of a sweep belong together in their order; a program NAME becomes NAME.A and NAME.B,
/// started anew in each round. Algorithms of the catalogue that are the same on both sides are left
/// out.
/// @param rounds  timed repetitions of every sweep; 0: as the specification says.
/// @param otherwise  those of a sweep of which it says nothing.
/// @throws InputError naming what differs; if nothing is left to be compared.
TurnsStudy turns_of(const TurnsSide& base, const TurnsSide& now, std::size_t rounds,
                    std::size_t otherwise);

/// Returns the study with another command of its one program, words between blanks.
/// @throws InputError if it has none or several; if the command holds a quote or a backslash.
Study with_command(const Study& study, const std::string& command);

/// Returns the study whose programs start in that folder: files of their commands are those there.
Study with_folder(const Study& study, const std::string& folder);

}  // namespace ar3d
