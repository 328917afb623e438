// What the page asks of the program, and its answers: one line of JSON each, in one thread. Exceptions end here as the
// line that the program would print.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/model/settings.h"
#include "view.h"

namespace ar3d {
namespace {

using Json = nlohmann::ordered_json;

std::optional<Drawing> shown_drawing;  // what is saved
std::string answer_text, answer_bytes;

/// Holds which graph is drawn, and what there is to say of where it comes from.
struct GivenGraph {
  Graph graph;
  std::vector<std::string> names = {};
  std::string where = "<stdin>:1";
  std::uint64_t count = 1;  ///< of graphs in the text
  std::string format = {}, note = {};
};

GivenGraph of_family(const std::string& name, std::uint64_t n, std::uint64_t seed) {
  const auto named = std::ranges::find(named_graphs(), name, &NamedGraph::name);
  if (named != named_graphs().end()) return {named->make()};
  GivenGraph given{generate(find_family(name), n, seed)};
  if (given.graph.num_vertices() != n) {
    given.note = fmt::format("{} has no graph with {} vertices for these parameters: this has {}",
                             name, n, given.graph.num_vertices());
  }
  return given;
}

/// The graph of that place, from 1, in the text.
GivenGraph of_text(std::string_view text, const std::string& name, std::uint64_t number) {
  GraphReader reader(TextInput(name, bytes_of(std::string(text))), ReadOptions{});
  GivenGraph given;
  std::optional<Graph> graph;
  for (given.count = 0; (graph = reader.next()); ++given.count) {
    if (given.count > 0 && given.count + 1 != number) continue;
    given.graph = std::move(*graph);
    given.names = reader.names();
    given.where = reader.where();
  }
  given.format = reader.format().name;
  return given;
}

/// The algorithm of that name; empty: the one that `ar3d draw` takes.
const Algorithm& algorithm_for(const std::string& name, const Graph& graph) {
  if (!name.empty()) return find_algorithm(name);
  const Algorithm& grid = find_algorithm("grid");
  return graph.max_degree() <= grid.guarantee.max_degree ? grid : find_algorithm("diamond");
}

/// The graph as one line, if it is a short one.
std::string short_line(const Graph& graph) {
  constexpr std::size_t kMost = 2000;
  if (graph.num_vertices() + std::size_t{graph.num_edges()} > kMost) return {};
  std::string line;
  graph.num_vertices() <= 30 ? append_graph6(line, graph) : append_sparse6(line, graph);
  line.pop_back();
  return line.size() <= kMost ? line : std::string();
}

std::string draw_and_judge(const Json& asked, std::string_view text) {
  auto last = std::chrono::steady_clock::now();
  const auto lap = [&last] {  // seconds since the last call
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last, now)).count();
  };
  GivenGraph given = asked.contains("family")
                         ? of_family(asked["family"], asked.value("n", std::uint64_t{0}),
                                     asked.value("seed", std::uint64_t{1}))
                         : of_text(text, asked["name"], asked.value("place", std::uint64_t{1}));
  const Graph& graph = given.graph;
  Json seconds = {{"read", lap()}};
  const Algorithm& algorithm = algorithm_for(asked.value("algorithm", ""), graph);
  const Settings options =
      complete_options(algorithm, parse_settings(std::string_view(asked.value("options", ""))));
  try {
    shown_drawing = draw(algorithm, graph, options);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", given.where, error.what()));
  }
  if (!given.names.empty()) {
    shown_drawing->names = std::make_shared<const std::vector<std::string>>(given.names);
  }
  seconds["draw"] = lap();
  const PageVerdict verdict = page_verdict(*shown_drawing, &algorithm, &graph);
  seconds["judge"] = lap();
  const EdgeRoles roles = edge_roles(*shown_drawing);
  const PageEntry entry =
      page_facts(asked["title"], *shown_drawing, roles, &algorithm.guarantee, verdict);
  answer_bytes = geometry_numbers(*shown_drawing, roles, entry.low);
  const Json answer = {{"hash", drawing_hash(*shown_drawing)},
                       {"options", settings_text(options)},
                       {"line", short_line(graph)},
                       {"graphs", given.count},
                       {"format", given.format},
                       {"note", given.note},
                       {"seconds", seconds}};
  return fmt::format("{{\"about\":{},{}", entry.about, answer.dump().substr(1));
}

std::string save(const Json& asked) {
  if (!shown_drawing) throw InputError("there is no drawing to save");
  const std::string path = "/drawing";
  write_drawing(drawing_format(asked["format"].get<std::string>(), path), *shown_drawing,
                "<stdin>:1", path);
  std::ifstream file(path, std::ios::binary);
  answer_bytes.assign(std::istreambuf_iterator<char>(file), {});
  return "{}";
}

/// The names to choose from.
std::string catalogue() {
  Json list = {
      {"algorithms", Json::array()}, {"families", Json::array()}, {"named", Json::array()}};
  for (const Algorithm& row : algorithms()) {
    const auto effort = std::ranges::find(row.options, "effort", &SettingSpec::name);
    const Guarantee& promised = row.guarantee;
    list["algorithms"].push_back(
        {{"name", row.name},
         {"summary", row.summary},
         {"degree", promised.max_degree},
         {"bends", promised.max_bends},
         {"exactly", promised.angle_rule == AngleRule::exactly},
         {"cosine", double(promised.cosine.numerator) / promised.cosine.denominator},
         {"efforts", effort == row.options.end() ? 0 : effort->high}});
  }
  for (const Family& row : families()) {
    if (row.name == "named") continue;
    list["families"].push_back({{"name", row.name},
                                {"summary", row.summary},
                                {"degree", row.max_degree},
                                {"random", row.is_random}});
  }
  for (const NamedGraph& row : named_graphs()) {
    list["named"].push_back({{"name", row.name}, {"summary", row.summary}});
  }
  return list.dump();
}

std::string answer_to(std::string_view request) {
  const std::size_t end = request.find('\n');
  const Json asked = Json::parse(request.substr(0, end));
  const std::string what = asked["do"];
  if (what == "draw") return draw_and_judge(asked, request.substr(end + 1));
  return what == "save" ? save(asked) : catalogue();
}

}  // namespace
}  // namespace ar3d

extern "C" {

/// Answers a request: a line of JSON and, behind it, the text of a graph. @return JSON, valid until the next call;
/// {"error": …} holds the line that the program would print. Numbers of a drawing (geometry_numbers)
/// and bytes of a file are in ar3d_bytes().
const char* ar3d_answer(const char* request, std::size_t size) {
  using namespace ar3d;
  answer_bytes.clear();
  try {
    answer_text = answer_to({request, size});
  } catch (const std::bad_alloc&) {
    answer_text = R"({"error":"not enough memory"})";
  } catch (const std::exception& error) {
    answer_text = Json{{"error", error.what()}}.dump(-1, ' ', true, Json::error_handler_t::replace);
  }
  return answer_text.c_str();
}

const char* ar3d_bytes() { return ar3d::answer_bytes.data(); }
std::size_t ar3d_size() { return ar3d::answer_bytes.size(); }
}
