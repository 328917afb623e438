#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/bench/external/external_algorithm.h"
#include "ar3d/formats/graphs/read_options.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {

class Corpus;   // bench/corpus/corpus.h
struct Family;  // generators/catalog.h

/// Describes batches of equal drawings shared by 1, ... threads or ranks. strong: `drawings` in
/// all, weak: `drawings` for each of them.
struct BatchRules {
  std::vector<std::uint32_t> workers;  ///< how many share; from 1 on, increasing
  std::uint32_t drawings = 1;
  std::uint32_t repetitions = 1;
};

/// Holds what holds for the whole timing phase.
struct TimingRules {
  std::uint32_t warm_up = 1;      ///< drawings before each timed one, thrown away
  std::uint32_t concurrency = 1;  ///< timed drawings at the same time, each on a core of its own
  bool write = false;             ///< time the formatting as JSON lines too
  bool restart = false;           ///< programs of the study are started anew in each round
};

/// Holds what a study may cost. A row that passes its limit is a row with status timeout or
/// out_of_memory.
struct Budget {
  std::optional<LimitByVertices> row_time_s;
  std::optional<LimitByVertices> row_memory_bytes;
  std::optional<double> study_s;
  /// Holds what the proof by counting may store at a time (CertifyOptions::proof_bytes); no limit
  /// of rows.
  std::optional<LimitByVertices> certify_memory_bytes;
  bool limits_rows() const { return row_time_s || row_memory_bytes; }
};

/// Says which drawings of a study are kept. Each drawing is kept once, however many rows are of it.
enum class KeptDrawings : std::uint8_t {
  none,
  worst,     ///< the worst one of every curve: algorithm with options, family with parameters
  violated,  ///< those that were proved wrong
  all        ///< those of all rows that were drawn
};
/// Returns "none", "worst", "violated", "all".
const char* to_string(KeptDrawings kept);
/// @throws InputError naming the text and the choices if it is none of them.
KeptDrawings parse_kept_drawings(std::string_view text);

/// Describes a family with complete parameters, or the graphs of a file.
struct FamilyChoice {
  const Family* family = nullptr;  ///< of the catalogue, or the corpus's own
  Settings parameters;
  std::shared_ptr<const Corpus> corpus = {};  ///< null: a family of the catalogue
};

/// Describes an algorithm with complete options, and how much of its drawings is stored.
struct AlgorithmChoice {
  const Algorithm* algorithm = nullptr;  ///< of the catalogue, or the program's row
  Settings options;
  std::shared_ptr<const ExternalAlgorithm> program = {};  ///< null: of the catalogue
  CertificateMode certificate = CertificateMode::exact;   ///< that judges its drawings
  Level level = Level::extents;
  /// Returns false for what promises nothing, not even an angle above 0 degrees, as programs without
  /// a guarantee do: its drawings are only measured.
  bool is_judged() const {
    const Guarantee& guarantee = algorithm->guarantee;
    return guarantee.claim == Claim::proved ||
           guarantee.cosine.numerator < guarantee.cosine.denominator;
  }
};

/// Describes files whose graphs are instances, and how these are taken.
struct GraphsEntry {
  std::string file = {};       ///< path or pattern (glob); of a collection also a folder
  std::string name = {};       ///< empty: the file's own
  bool is_collection = false;  ///< all files together are one family
  std::string groups = {};  ///< of a collection: path of a table file → group; empty: sub-folders
  ReadOptions reading = {};        ///< whether loops and parallel edges are dropped, too
  bool largest_component = false;  ///< of each graph only its largest connected component
  std::uint64_t sample = 0;        ///< so many of the graphs; 0: all
  std::uint64_t sample_seed = 0;   ///< the study's
  bool skip = false;  ///< a file is read up to its first error and listed; else that is thrown
  /// Files are held, and all that there are now stand behind them; one without a graph is skipped.
  bool rescan = false;
  std::vector<std::int64_t> shuffles = {0};  ///< numbers of the permutations of the labels; 0: none
  std::string location = {};                 ///< "FILE:LINE: " of the specification, for messages
};

/// Holds what an include or exclude entry says: an empty name matches all.
struct CellPattern {
  std::string location;  ///< "FILE:LINE: " of the specification, for messages
  std::string family;
  std::string algorithm;
  std::uint64_t from = 0;
  std::uint64_t to = ~std::uint64_t{0};
  bool matches(const std::string& family_name, const std::string& algorithm_name,
               std::uint64_t n) const;
};

/// Describes families x sizes x instances x algorithms x repetitions, less what include and exclude
/// drop.
struct Sweep {
  std::vector<FamilyChoice> families;
  std::vector<GraphsEntry> graphs;
  std::vector<std::uint64_t> sizes;         ///< increasing
  std::vector<AlgorithmChoice> algorithms;  ///< at every level, by every certificate
  std::uint32_t instances = 1;    ///< where the graph depends on the seed; others have one
  std::uint32_t repetitions = 1;  ///< of every drawing in the metrics phase
  /// Hold rounds of the timing phase, each with one repetition of a drawing: between least and most,
  /// until times are stable within the precision (make_timing); exactly most if it is 0.
  std::uint32_t least_timed = 0, most_timed = 0;
  double timed_precision = 0;
  std::map<RunPhase, BatchRules> batches;  ///< of every drawing, by phase
  std::vector<CellPattern> include;        ///< if not empty, a cell has to match one of these
  std::vector<CellPattern> exclude;
};

/// Drawings of more vertices are not counted unless that is asked for.
inline constexpr std::int64_t kLargestCounted = 10000;

/// Is what the text of a specification says: a value, made once.
struct StudySpec {
  std::string name;
  std::string description;
  std::uint64_t seed = 0;
  std::vector<std::shared_ptr<const ExternalAlgorithm>> programs;  ///< of `[[algorithm]]`
  std::vector<Sweep> sweeps;
  std::map<std::string, std::uint64_t> max_n;  ///< algorithm -> largest n it is given
  TimingRules timing;
  Budget budget;
  CertificateMode certificate = CertificateMode::exact;  ///< of the sweeps that name none
  KeptDrawings keep_drawings = KeptDrawings::none;
  bool count = false;            ///< made to be compared: drawings are counted where they can be
  bool accept_unproved = false;  ///< its verdict passes with rows that are not proved exactly
  double graphs_bytes = 64e6;    ///< graphs of files go into the results up to this size
  std::string text;              ///< the verbatim TOML
};

/// Holds what a study has listed and opened, for all copies of it: nothing is listed or read twice.
struct OpenFiles {
  std::optional<std::chrono::system_clock::time_point> listed;   ///< when files were first listed
  std::map<std::string, std::vector<std::string>> listings;      ///< by path, pattern or folder
  std::map<std::string, std::shared_ptr<const Corpus>> corpora;  ///< by files and options
};

/// Represents a study to be planned: its specification, where the graphs of its files are and, of a
/// study that has begun, what it knows of them.
struct Study {
  // NOLINTNEXTLINE(google-explicit-constructor): without files a specification is a study
  Study(StudySpec says = {}, std::string its_folder = {})
      : spec(std::move(says)), folder(std::move(its_folder)) {}
  StudySpec spec;
  /// Holds where the files of `graphs` are looked for; empty: in the current folder.
  std::string folder;
  /// Holds, if given, the files that the study began with, in order; the patterns of `graphs` say
  /// no more.
  std::optional<std::vector<GraphFileRecord>> begun_with = {};
  /// Holds, of a study that has begun, its files as they were read, and those that could not be.
  std::vector<CollectedFile> collected = {};
  std::vector<SkippedFile> skipped = {};
  /// Holds its graphs; null or without a family: they are not held.
  std::shared_ptr<const StoredGraphs> stored_graphs = {};
  /// Holds results, report and drawings of the study; none of them is a graph of a folder.
  std::vector<std::string> own_files = {};
  bool rescan = false;  ///< graphs that the files hold by now are added
  /// Holds files that were opened, for all copies of the study.
  std::shared_ptr<OpenFiles> open_files = std::make_shared<OpenFiles>();
};

/// Reads a specification; docs/study.md describes the keys.
/// @param file  for messages.
/// @throws InputError "file:line: message" naming the value: syntax, unknown key, family,
/// algorithm, option or
///   parameter, value out of range, empty list.
StudySpec parse_study(const std::string& text, const std::string& file);
/// Returns StudySpec::accept_unproved of a specification, also where its sweeps cannot be read any
/// more.
bool accepts_unproved(const std::string& text);

/// Returns a named study, or else the TOML file at that path.
/// @throws InputError naming the file, or the known studies if there is no such file.
Study load_study(const std::string& name_or_path);

/// Returns a study that has begun, with the files that it began with.
/// @param file  that the identity stands in, for messages. @throws InputError as parse_study.
Study recorded_study(const StudyIdentity& identity, const std::string& file);

/// Returns the algorithm of that name, of the catalogue or a program of the study, with complete
/// options.
/// @throws InputError naming the unknown algorithm or option.
AlgorithmChoice algorithm_choice(const StudySpec& spec, const std::string& name,
                                 const Settings& options);

/// Returns the program of that name; null if the study has none.
std::shared_ptr<const ExternalAlgorithm> find_program(const StudySpec& spec,
                                                      const std::string& name);

/// Returns "ar3d-<name>.h5".
std::string default_results_path(const StudySpec& spec);

/// Describes a study that comes with the program, by name.
struct NamedStudy {
  std::string_view name;
  std::string_view summary;  ///< one sentence
  std::string_view toml;
};

std::span<const NamedStudy> named_studies();

/// Returns null if there is none of that name.
const NamedStudy* find_named_study(std::string_view name);

/// Returns the text of the specification, to be kept in another folder: the paths of `graphs` are
/// absolute. A study without graphs of files keeps its text byte for byte.
std::string movable_text(const Study& whole);

/// Returns the study with so many rounds of the timing phase in every sweep, as if its text said so.
Study with_timed_rounds(const Study& whole, std::uint64_t rounds);

/// Returns the same for one of many runs of the study, also by older programs: without `count`, and
/// with at most `most_timed` timed repetitions.
std::string text_of_a_turn(const Study& whole, std::int64_t most_timed);

}  // namespace ar3d
