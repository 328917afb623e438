#pragma once

#include <CLI/CLI.hpp>

namespace ar3d {

/// Holds the exit codes of docs/contracts.md.
inline constexpr int kPass = 0;
inline constexpr int kInternalError = 1;
inline constexpr int kUsage = 2;
inline constexpr int kRegression = 3;
inline constexpr int kViolated = 4;
inline constexpr int kIncomplete = 5;
inline constexpr int kInconclusive = 6;
inline constexpr int kUnjudged = 7;
inline constexpr int kInterrupted = 130;

/// Adds one verb to the program, as all below do; its callback leaves its verdict in `exit_code`.
void add_list(CLI::App& app, int& exit_code);
void add_generate(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);
void add_play(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_optimum(CLI::App& app, int& exit_code);
void add_study(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_figures(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_history(CLI::App& app, int& exit_code);
void add_replay(CLI::App& app, int& exit_code);
void add_hunt(CLI::App& app, int& exit_code);
void add_shrink(CLI::App& app, int& exit_code);

}  // namespace ar3d
