// Options that several verbs have. CLI11's own validators take "-5" for 2^64 - 5, and name no
// nearest word.
#include "options.h"

#include <fmt/ranges.h>
#include <omp.h>

#include "ar3d/base/nearest_name.h"
#include "ar3d/base/number.h"

namespace ar3d {
namespace {

CLI::Validator number_that(std::function<bool(double)> fits, std::string range) {
  return {[fits = std::move(fits), range = std::move(range)](std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && fits(value))
              return {};
            return fmt::format("'{}' is not a number{}", text, range);
          },
          "NUMBER"};
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  return {[low, high](std::string& text) -> std::string {
            const auto value = integer_of<std::uint64_t>(text);
            if (value && *value >= low && *value <= high) return {};
            return fmt::format("'{}' is not a whole number from {} to {}", text, low, high);
          },
          "NUMBER"};
}

CLI::Validator finite_number(bool positive) {
  return number_that([positive](double value) { return value > 0 || !positive; },
                     positive ? " above 0" : "");
}

CLI::Validator number_between(double low, double high) {
  return number_that([low, high](double value) { return value >= low && value <= high; },
                     fmt::format(" from {} to {}", low, high));
}

CLI::Validator one_of(std::vector<std::string> known) {
  std::string shown = fmt::format("{{{}}}", fmt::join(known, ","));
  return {[known = std::move(known)](std::string& word) -> std::string {
            if (std::ranges::find(known, word) != known.end()) return {};
            return fmt::format("'{}' is none of {}{}", word, fmt::join(known, ", "),
                               did_you_mean(word, {known.begin(), known.end()}));
          },
          std::move(shown)};
}

CLI::Option* add_repeated(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                          const std::string& what) {
  return verb.add_option(name, values, what)->type_size(1)->allow_extra_args(false);
}

void add_threads_option(CLI::App& verb) {
  verb.add_option_function<int>(
          "--threads", [](int threads) { omp_set_num_threads(threads); },
          "drawings worked on at the same time, or threads for a single large one; as many as "
          "cores if left out; what comes out is the same")
      ->check(whole_number(1, 1024));
}

CLI::Option* add_json(CLI::App& verb) {
  return verb.add_flag("--json", is_json_output, "print one JSON object instead of text");
}

void print_json(const nlohmann::ordered_json& json) {
  print("{}\n", json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

void log_notes(const std::vector<std::string>& notes) {
  for (const std::string& text : notes) log(stderr, "ar3d: note: {}\n", printable(text));
}

void add_edge_list_options(CLI::App& verb, ReadOptions& options) {
  verb.add_option(
          "--base", options.base,
          "smallest vertex id of edge and adjacency lists: 0 or 1; as the list tells if left out")
      ->check(whole_number(0, 1));
  verb.add_option_function<std::string>(
          "--first-line",
          [&options](const std::string& word) {
            if (word == "edge") options.first_line = FirstLine::edge;
            if (word == "header") options.first_line = FirstLine::header;
          },
          "what a first line 'a b' of an edge list is where that is open: edge, or header "
          "(numbers of vertices and edges)")
      ->default_str("automatic")
      ->check(one_of({"automatic", "edge", "header"}));
  verb.add_flag_callback(
      "--undirected", [&options] { options.undirected = options.simplify = true; },
      "read arcs of directed graphs as edges; loops and parallel ones are dropped then");
}

void add_graph_input_options(CLI::App& verb, ReadOptions& options) {
  verb.add_option("--from", options.format,
                  "format of the graphs that are read; detected by content if left out");
  add_edge_list_options(verb, options);
  verb.add_flag_callback(
      "--trust-sizes", [&options] { options.free_vertices = std::numeric_limits<Vertex>::max(); },
      "believe a file's number of vertices, however few bytes stand behind it");
}

}  // namespace ar3d
