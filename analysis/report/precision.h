#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {

/// Holds how drawings in one real type are called, and the bits of its significand; 0 if not known.
struct RealSetting {
  std::string name;
  int bits = 0;
};
/// "float" of 24 bits, … for `two-bend-paper` with its option type; another algorithm's label.
RealSetting real_setting(const CurveKey& key);

/// Is one drawing that was judged without tolerance: a first repetition of the metrics phase.
struct RealRow {
  std::size_t row = 0;
  std::size_t setting = 0;  ///< in RealRows::settings
  std::string graph;        ///< equal for drawings of one graph
  std::string family;       ///< family_label
  std::int64_t requested_n = 0;
  std::int64_t n = 0;
  double log_miss = 0;       ///< log10 of the largest miss of an angle in degrees; -infinity: none
  double log_condition = 0;  ///< log10
  std::array<double, 4> within{};  ///< shares of its angles within 1e-12, 1e-9, 1e-6, 1e-3 degrees
  bool is_broken = false;          ///< a crossing or a segment of length zero
  double cpu_s = kMissing;         ///< CPU time of drawing
};

/// At most the first 200,000 of them.
struct RealRows {
  std::vector<RealSetting> settings;  ///< by bits, unknown ones last
  std::vector<RealRow> rows;
  std::size_t left_out = 0;
};

/// Holds what a certificate mode or a level cost, summed up over the rows of one n.
struct Judgements {
  std::size_t rows = 0, violated = 0;
  std::vector<double> draw_s, store_s, certify_s;  ///< per vertex
  std::vector<double> peak_bytes;                  ///< beyond those when the row began, per vertex
};
struct JudgementKey {
  std::string algorithm;    ///< with its options
  std::int64_t n = 0;       ///< requested
  std::string certificate;  ///< "exact", "measured", …
  std::string level;        ///< "extents", …
  friend auto operator<=>(const JudgementKey&, const JudgementKey&) = default;
};

/// Holds what the section on precision reads of a study, in one pass over its rows; of a study
/// whose rows are all proved over the first 200,000.
struct PrecisionRows {
  RealRows real;
  std::map<JudgementKey, Judgements> judgements;  ///< at most the first 2,000
};
PrecisionRows precision_rows(const StudyAnalysis& analysis);

/// Returns the family with most graphs, of which medians tell most.
std::string sample_family(const RealRows& real);

/// Returns log10 of the median over the graphs of a family (empty: of all) by requested n.
std::map<std::int64_t, double> median_misses(const RealRows& real, std::size_t setting,
                                             const std::string& family);

/// Holds what predicts the misses: the drawings in the type of most bits. A miss is kappa 2^-p C
/// radians; kappa and C are theirs, p is the bits of the type that is predicted.
struct MissModel {
  std::size_t setting = 0;            ///< that predicts the others
  std::array<double, 3> log_kappa{};  ///< log10 of its 10 %, 50 % and 90 % quantiles over all rows
  std::size_t drawings = 0;           ///< that it is taken from; 0: there is no model
  std::map<std::string, double> family_kappa;  ///< log10 of the median, by family
  std::map<std::string, std::map<std::int64_t, double>> log_condition;  ///< by family and n, median

  /// Returns log10 of kappa 2^-bits C in degrees.
  static double log_miss(double log_kappa, double log_c, int bits);
};
MissModel miss_model(const RealRows& real);

/// Says where misses of one type pass a limit, predicted and seen.
enum class OnsetVerdict { confirmed, refuted, open };
struct Onset {
  std::string family;
  std::size_t setting = 0;
  double log_limit = 0;                    ///< log10 degrees
  double log_predicted = 0, log_seen = 0;  ///< log10 n; +infinity: not up to the largest n,
                                           ///< -infinity: at the smallest already
  double log_first = 0, log_last = 0;      ///< log10 of the least and the largest n drawn
  OnsetVerdict verdict = OnsetVerdict::open;
  double log_kappa = kMissing;       ///< log10: the family's, which predicts
  double log_kappa_seen = kMissing;  ///< of the type where it passes, or at the last n
};
/// Returns where medians pass the limits 1e-12, 1e-9, 1e-6, 1e-3 and 1 degree, by interpolation in
/// logarithms; those that neither passes, or both do at the least n, are left out.
std::vector<Onset> onsets(const RealRows& real, const MissModel& model);
/// Confirmed: both passes are within a factor of 2. Refuted: they are further apart. Open: what is
/// beyond the sizes drawn may be either.
OnsetVerdict judge_onset(const Onset& onset);

}  // namespace ar3d::report
