#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
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

/// Runs the study with both programs in turns, base first in even rounds and last in odd ones, so
/// that a machine that gets slower or faster treats both alike. Each run is a process of its own on
/// one thread, pinned to one core; both programs run under paths of equal length. Files go into a
/// folder of their own in `folder`, which is removed afterwards.
/// @return what each measured, round by round; fewer rounds if it was interrupted.
/// @throws InputError naming round and program if one ends with anything but a verdict.
std::array<std::vector<Results>, 2> run_interleaved(const std::string& base_program,
                                                    const std::string& new_program,
                                                    const Study& study, const std::string& folder,
                                                    const InterleaveOptions& options);

/// Returns all settings of a study, each once.
std::vector<CurveKey> settings_of(const StudySpec& spec);

/// Returns one study of two that differ in their programs and the algorithms of their sweeps only;
/// its timing phase lets them take turns. Beside it stand the pairs of its settings that are
/// compared, and remarks, one line each.
/// The settings of a sweep belong together in their order; a program NAME becomes NAME.A and NAME.B,
/// started anew in each round. Algorithms of the catalogue that are the same on both sides are left
/// out.
/// @param settings  of each side the only one that is compared; empty: all are.
/// @param rounds  timed repetitions of every sweep; 0: as the specification says.
/// @param otherwise  those of a sweep of which it says nothing.
/// @throws InputError naming what differs; if nothing is left to be compared.
std::tuple<Study, std::vector<SettingPair>, std::vector<std::string>> turns_of(
    const std::vector<Study>& sides, const std::vector<CurveKey>& settings, std::size_t rounds,
    std::size_t otherwise);

/// Returns the study with another command of its one program, words between blanks.
/// @throws InputError if it has none or several; if the command holds a quote or a backslash.
Study with_command(const Study& study, const std::string& command);

/// Returns the study whose programs start in that folder: files of their commands are those there.
Study with_folder(const Study& study, const std::string& folder);

/// Returns the last line of a log that is not empty.
std::string last_line(const std::filesystem::path& log);

/// Returns the folder of the git checkout of ar3d that holds the working directory; empty: none.
std::string checkout_here();
/// Returns the same. @throws InputError if there is none.
std::string find_checkout();

/// Puts another commit of the repository that holds the working directory into a folder, as a clone
/// of its own, and builds it there.
/// @param ref  as build_reference. @param command  for `sh -c`, run in the folder of the clone that
/// is like the working directory.
/// @return that folder; nothing if it was interrupted.
/// @throws InputError naming the ref if there is no such commit; with the last line that was printed
/// if it does not build.
std::optional<std::string> build_own(const std::string& ref, const std::string& command,
                                     const std::string& folder);

/// Returns the program of another commit, Release, as CHECKOUT/build/compare/COMMIT/ar3d. What is
/// there is taken as it is; else it is built in a git worktree beside it, which is removed
/// afterwards, however the build ends.
/// @param ref  whatever git takes for a commit: a tag, a branch, HEAD~3.
/// @param progress  where to tell how far it is; null: nowhere.
/// @return nothing if it was interrupted (is_interrupted).
/// @throws InputError naming the ref if there is no such commit, or the log if it does not build.
std::optional<std::string> build_reference(const std::string& checkout, const std::string& ref,
                                           std::FILE* progress);

}  // namespace ar3d
