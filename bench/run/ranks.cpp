// Steps that several ranks do together: what one of them fails at, all have failed at.
#include "ar3d/bench/run/ranks.h"

#include "ar3d/store/journal/journal_writer.h"

namespace ar3d {

void together(Ranks& ranks, const std::function<void()>& step) {
  if (ranks.size() == 1) {
    step();
    return ranks.barrier();
  }
  StepResult result = StepResult::done;
  std::string why;
  try {
    step();
  } catch (const JournalFull& error) {
    result = StepResult::journal_full;
    why = error.what();
  } catch (const InputError& error) {
    result = StepResult::failed;
    why = error.what();
  }
  result = ranks.agree(result, why);
  if (result != StepResult::done) throw FailedTogether(why, result == StepResult::journal_full);
}

}  // namespace ar3d
