#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/optimum/question.h"
#include "ar3d/optimum/solver.h"

namespace ar3d::optimum {

/// Holds what became of one formula: a box with one class of its points.
struct FormulaRecord {
  std::string name = {};  ///< of its files: "1-8x8x7-0" for the first graph, box and class
  BoxSize box{};
  int point_class = 0;
  std::size_t points = 0;
  int variables = 0;  ///< 0, as the clauses, if there are fewer points than vertices
  std::uint64_t clauses = 0;
  Answer answer = Answer::undecided;
  double cpu_s = 0;
  std::string formula_hash = {};  ///< XXH3-128 of the DIMACS file; empty without one
  std::string proof_hash = {};    ///< XXH3-128 of the proof's file
};

struct SearchOptions {
  std::int64_t volume_below = 4097;   ///< boxes of at least this volume are not tried
  std::optional<Drawing> first = {};  ///< where the search begins, if it answers the question
  std::string proofs = {};            ///< folder for formulas and proofs; empty: none are kept
  std::string name = "1";             ///< of the graph, in names of files
  std::function<bool()> should_stop = [] { return false; };             ///< asked now and then
  std::function<void(const FormulaRecord&)> on_formula = [](auto&) {};  ///< before it is solved
};

/// The least volume of all boxes of drawings, or what is known of it.
struct SmallestBox {
  std::int64_t at_least = 1;              ///< no box below it holds a drawing
  std::optional<Drawing> drawing = {};    ///< certified
  BoxSize box{};                          ///< of the drawing, sides ascending
  std::vector<FormulaRecord> formulas{};  ///< as they were answered
  std::string too_large = {};             ///< why a box could not be tried; empty: all could
  std::int64_t at_most() const { return volume_of(box); }  ///< 0 without a drawing
  bool is_closed() const { return drawing && at_least == at_most(); }
};

/// Returns the boxes a <= b <= c of less than this volume that no other one contains. Without edges
/// all sides are at least 1; else two of them are at least 2, along body diagonals all three.
std::vector<BoxSize> maximal_boxes(std::int64_t volume_below, Diagonals diagonals, bool has_edges);

/// Finds the smallest box (docs/optimum.md): without a first drawing cubes until one holds one,
/// then the maximal boxes below the best one. A formula that is not decided in some seconds of CPU time comes
/// again, with four times as many. Exponential.
/// @throws InputError as refuse_unanswerable and Solver.
SmallestBox find_smallest_box(const Graph& graph, const Question& question, const Solver& solver,
                              const SearchOptions& options = {});

}  // namespace ar3d::optimum
