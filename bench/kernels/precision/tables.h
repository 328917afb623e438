#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ar3d::precision {

/// A share of trials with its 95 % Wilson interval: "12 of 300: 4.0 % (2.3-6.9)"; none of N is
/// "0 of N: < 3.8/N", the interval's end.
std::string rate(std::uint64_t successes, std::uint64_t trials);

/// Prints a Markdown table. @pre every row has as many cells as the head.
void print_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows);

/// Which certificate modes catch damaged drawings. @param drawings  of each algorithm, scale and
/// kind of damage.
void damage_tables(std::uint64_t drawings);

/// What certificate modes cost.
void mode_times();

/// A drawing in real types, moved away from the origin.
void shift_tables();

/// Bits that coordinates and predicates need, by the theorem's bound and by drawings.
void width_tables();

/// Positions in each width: bytes, and times of reading and certifying. @param most  vertices.
void position_table(std::uint64_t most);

/// Filter failures and wrong answers over every family of about n vertices.
void family_tables(std::uint64_t n);

/// Time against wrong answers of the predicates in each arithmetic.
void front_table();

/// From which depth on nests of two-bend-paper miss, predicted and seen. @param most  depth.
void nest_table(int most);

/// What rounding coordinates alone makes of the graphs of the study `precision` with at most so
/// many vertices, beside what computing in a type does.
void rounding_tables(std::uint64_t most);

/// Where rounding gives the wrong sign. @param picture  a new SVG file; empty: none.
/// @throws InputError if it exists or cannot be written.
void sign_tables(const std::string& picture);

/// Wrong answers of the predicates in each arithmetic.
void predicate_tables();

/// From which n on angles are wrong, predicted and seen. @param most  largest n that is tried.
void onset_table(std::uint64_t most);

}  // namespace ar3d::precision
