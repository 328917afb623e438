#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/rows.h"

namespace ar3d {

struct InterleaveOptions {
  std::size_t rounds = 15;
  int core = -1;                  ///< that both programs are pinned to; -1: the last allowed one
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  bool count = false;             ///< `study count` after the first run of each
};

/// Holds what two programs measured in turns; base[i] and now[i] belong to round i.
struct InterleavedRounds {
  std::vector<Results> base;
  std::vector<Results> now;
  bool interrupted = false;  ///< (is_interrupted) the rounds are not all there
};

/// Runs the study with both programs in turns, base first in even rounds and last in odd ones, so
/// that a machine that gets slower or faster treats both alike. Each run is a process of its own on
/// one thread, pinned to one core; both programs run under paths of equal length. Files go into a
/// folder of their own in `folder`, which is removed afterwards.
/// @throws InputError naming round and program if one ends with anything but a verdict.
InterleavedRounds run_interleaved(const std::string& base_program, const std::string& new_program,
                                  const Study& study, const std::string& folder,
                                  const InterleaveOptions& options);

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
