#include "ar3d/bench/run/describe_study.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/results/sha256.h"

namespace ar3d {

std::string now_with_zone() {
  using namespace std::chrono;
  const auto now = system_clock::now().time_since_epoch();
  const auto seconds = duration_cast<std::chrono::seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:06}+00:00",
                     fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     duration_cast<microseconds>(now - seconds).count());
}

Results describe_study(const StudySpec& spec, int workers) {
  Results results;
  results.study_id = spec.name;
  results.spec = spec.text;
  results.spec_sha256 = sha256(spec.text);
  results.source_hash = source_hash();
  results.dirty = source_is_dirty();
  results.dirty_hash = dirty_hash();
  results.created = now_with_zone();
  results.environment = capture_environment(workers);
  return results;
}

}  // namespace ar3d
