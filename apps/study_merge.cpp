#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <memory>

#include "ar3d/base/error.h"
#include "ar3d/bench/keep/merge_study.h"
#include "commands.h"
#include "outputs.h"
#include "study.h"

namespace ar3d {
namespace {

struct MergeArguments {
  std::vector<std::string> parts;
  std::string output;
  bool force = false;
};

int merge(const MergeArguments& arguments) {
  refuse_unsafe_outputs({.inputs = arguments.parts,
                         .outputs = {arguments.output},
                         .force = arguments.force,
                         .streams = false});
  const StudyOutcome outcome = merge_study(arguments.parts, arguments.output);
  if (outcome.complete()) {
    fmt::print("{} rows of {} files are in {}\n", outcome.rows, arguments.parts.size(),
               arguments.output);
    return kPass;
  }
  fmt::print(stderr, "ar3d: {} rows are missing, row {} for one{}; nothing was written\n",
             outcome.missing, outcome.first_missing,
             outcome.missing_shards.empty()
                 ? ""
                 : fmt::format(" (no file of shard {})", outcome.missing_shards));
  return kIncomplete;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = std::from_chars(slash ? index.ptr + 1 : end, end, shard.count);
  if (!slash || count.ec != std::errc() || count.ptr != end || !is_shard(shard)) {
    throw InputError(fmt::format("'{}' is no shard: i/N with 1 <= i <= N <= 1000000", text));
  }
  return shard;
}

void add_study_merge(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("merge", "Makes one results file of a study's shards");
  const auto arguments = std::make_shared<MergeArguments>();
  verb->add_option("PART", arguments->parts, "results files or journals, in any order")->required();
  verb->add_option("-o,--output", arguments->output, "results file")->required();
  add_force(*verb, arguments->force);
  verb->footer(
      "Exit code 2 if the parts do not belong together, 5 if rows are missing; then nothing is "
      "written.\nExample: ar3d study merge ar3d-quick.shard-*.h5 -o quick.h5");
  verb->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace ar3d
