// Which boxes are tried, in which order, and what their answers say of the smallest one
// (Lemma O.3).
#include "ar3d/optimum/smallest_box.h"

#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/optimum/encoding.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::optimum {
namespace {

/// 32 hexadecimal digits, as `xxh128sum` prints them.
std::string hash_of_bytes(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// @throws InputError if it cannot be read.
std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) refuse_reading(path, errno);
  return hash_of_bytes(bytes);
}

/// Is each side at most the other box's? Sides ascend.
bool fits(const BoxSize& inner, const BoxSize& outer) {
  return inner[0] <= outer[0] && inner[1] <= outer[1] && inner[2] <= outer[2];
}

class Search {
 public:
  Search(const Graph& graph, const Question& question, const Solver& solver,
         const SearchOptions& options)
      : graph_(graph), question_(question), solver_(solver), options_(options) {}

  SmallestBox run() {
    if (options_.first) begin_with(*options_.first);
    for (auto box = next_box(); box && !options_.should_stop(); box = next_box()) try_box(*box);
    found_.at_least = proved_below();
    return std::move(found_);
  }

 private:
  static constexpr double kFirstSeconds = 5;

  bool has_edges() const { return graph_.num_edges() > 0; }
  std::int64_t below() const { return found_.drawing ? found_.at_most() : options_.volume_below; }
  bool is_refuted(const BoxSize& box) const {
    return std::ranges::any_of(refuted_, [&](const BoxSize& other) { return fits(box, other); });
  }

  /// The next cube until there is a drawing; then, of the maximal boxes that are open, the one
  /// tried least often, nearest to a cube. Nothing if none is left.
  std::optional<BoxSize> next_box() {
    for (int side = has_edges() ? 2 : 1; !found_.drawing && found_.too_large.empty(); ++side) {
      const BoxSize cube = {side, side, side};
      if (volume_of(cube) >= below()) break;
      if (!tries_.contains(cube)) return cube;
    }
    std::vector<BoxSize> open = maximal_boxes(below(), question_.diagonals, has_edges());
    std::erase_if(open, [&](const BoxSize& b) { return is_refuted(b) || too_large_.contains(b); });
    const auto rank = [&](const BoxSize& box) {
      return std::tuple(tries_[box], box[2] - box[0], -volume_of(box));
    };
    const auto best = std::ranges::min_element(open, {}, rank);
    return best == open.end() ? std::nullopt : std::optional(*best);
  }

  void try_box(const BoxSize& box) {
    double limit = kFirstSeconds;
    for (int i = tries_[box]++; i > 0 && limit < 1e9; --i) limit *= 4;
    Answer answer = Answer::unsatisfiable;
    try {
      for (const BoxSize& oriented : orientations(box)) {
        for (const PointClass& points : point_classes(question_, oriented)) {
          const Answer one = try_class(points, limit);
          if (one != Answer::unsatisfiable) answer = one;
          if (one == Answer::satisfiable || options_.should_stop()) return;
        }
      }
    } catch (const std::length_error& error) {
      found_.too_large = fmt::format("box {}: {}", to_string(box), error.what());
      too_large_.insert(box);
      return;
    }
    if (answer == Answer::unsatisfiable) refuted_.push_back(box);
  }

  /// The box itself; for vertices in a plane once with each side across it.
  std::vector<BoxSize> orientations(const BoxSize& box) const {
    if (!question_.in_plane) return {box};
    std::set<BoxSize> oriented = {box, {box[0], box[2], box[1]}, {box[1], box[2], box[0]}};
    return {oriented.begin(), oriented.end()};
  }

  Answer try_class(const PointClass& points, double limit) {
    const auto [x, y, z] = points.box;
    FormulaRecord record{
        .name = fmt::format("{}-{}x{}x{}-{}", options_.name, x, y, z, points.number),
        .box = points.box,
        .point_class = points.number,
        .points = points.points.size()};
    if (closed_.contains(record.name)) return Answer::unsatisfiable;
    if (points.points.size() < graph_.num_vertices()) {
      record.answer = Answer::unsatisfiable;
    } else {
      solve(points, limit, record);
    }
    if (record.answer == Answer::unsatisfiable) closed_.insert(record.name);
    found_.formulas.push_back(record);
    return record.answer;
  }

  void solve(const PointClass& points, double limit, FormulaRecord& record) {
    const Encoding encoding(graph_, question_, points);
    const Formula& formula = encoding.formula();
    record.variables = formula.num_variables();
    record.clauses = formula.num_clauses();
    options_.on_formula(record);
    const std::string file = options_.proofs.empty() ? "" : options_.proofs + "/" + record.name;
    const SolverResult result = solver_({.formula = formula,
                                         .proof = file.empty() ? "" : file + ".drat",
                                         .should_stop = options_.should_stop,
                                         .cpu_s = limit});
    record.cpu_s = result.cpu_s;
    record.answer = result.answer;
    if (!file.empty()) keep_proof(formula, file, record);
    if (result.answer == Answer::satisfiable) take(encoding.decode(result.model), points.box);
  }

  /// Writes the formula beside its proof; a proof of nothing is removed.
  static void keep_proof(const Formula& formula, const std::string& file, FormulaRecord& record) {
    if (record.answer != Answer::unsatisfiable) {
      unlink((file + ".drat").c_str());
      return;
    }
    const std::string text = formula.dimacs();
    write_file_atomically(file + ".cnf", text);
    record.formula_hash = hash_of_bytes(text);
    record.proof_hash = hash_of_file(file + ".drat");
  }

  /// Nothing if the drawing does not answer the question.
  std::optional<BoxSize> box_of(const Drawing& drawing) const {
    const Certificate certificate =
        certify(graph_, drawing, guarantee_of(question_), {.check_size = false});
    if (!certificate.valid()) return std::nullopt;
    const auto extents = certificate.box.extents();
    BoxSize box{};
    for (std::size_t i = 0; i < 3; ++i) box[i] = static_cast<int>(extents[i]) + 1;
    std::ranges::sort(box);
    return box;
  }

  void begin_with(const Drawing& drawing) {
    const auto box = box_of(drawing);
    if (box && volume_of(*box) < below()) found_.box = *box, found_.drawing = drawing;
  }

  void take(Drawing drawing, BoxSize inside) {
    const auto box = box_of(drawing);
    std::ranges::sort(inside);
    expect(box && fits(*box, inside), "verify certifies every drawing of a model, in its box");
    found_.box = *box;
    found_.drawing = std::move(drawing);
  }

  /// The largest volume such that all boxes of less are refuted.
  std::int64_t proved_below() const {
    const auto is_proved = [&](std::int64_t volume) {
      const auto boxes = maximal_boxes(volume, question_.diagonals, has_edges());
      return std::ranges::all_of(boxes, [&](const BoxSize& box) { return is_refuted(box); });
    };
    std::int64_t low = 1;
    for (std::int64_t high = below(); low < high;) {
      const std::int64_t middle = (low + high + 1) / 2;
      if (is_proved(middle))
        low = middle;
      else
        high = middle - 1;
    }
    return low;
  }

  const Graph& graph_;
  const Question& question_;
  const Solver& solver_;
  const SearchOptions& options_;
  SmallestBox found_;
  std::map<BoxSize, int> tries_;
  std::vector<BoxSize> refuted_;
  std::set<BoxSize> too_large_;
  std::set<std::string> closed_;  // names of unsatisfiable formulas
};

}  // namespace

std::vector<BoxSize> maximal_boxes(std::int64_t volume_below, Diagonals diagonals, bool has_edges) {
  const int least = has_edges ? 2 : 1;
  std::vector<BoxSize> boxes;
  for (int a = diagonals == Diagonals::body ? least : 1; std::int64_t{a} * a * a < volume_below;
       ++a) {
    for (int b = std::max(a, least); std::int64_t{a} * b * b < volume_below; ++b) {
      const auto c = static_cast<int>((volume_below - 1) / (std::int64_t{a} * b));
      const bool is_maximal =
          volume_of({a + 1, b, c}) >= volume_below && volume_of({a, b + 1, c}) >= volume_below;
      if (is_maximal) boxes.push_back({a, b, c});
    }
  }
  return boxes;
}

SmallestBox find_smallest_box(const Graph& graph, const Question& question, const Solver& solver,
                              const SearchOptions& options) {
  refuse_unanswerable(graph, question);
  return Search(graph, question, solver, options).run();
}

}  // namespace ar3d::optimum
