#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "ar3d/analysis/check.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

class RowCollection;
class RowsInHand;

/// Represents the rows of a study, wherever they are: in its results file or, while it is not
/// finished, in its journals. `study run`, `resume` and `status`, `check` and `report` judge these
/// rows and no others, with judge(), so that they agree.
class StudyRows {
 public:
  /// @param file  the study's results file or a journal of it.
  /// @throws InputError naming the file if neither is there, or if what is there cannot be read, is
  /// damaged, or is no results file or journal.
  explicit StudyRows(const std::string& file);
  /// @param rows  that were made just now, of that results file.
  StudyRows(std::shared_ptr<const RowsInHand> rows, const std::string& results);
  ~StudyRows();

  /// Returns the rows; they stay valid while this lives. Memory: a few hundred rows; of
  /// journals about 60 bytes per row.
  const RowView& view() const { return view_; }

 private:
  void view_results(const std::string& results);
  void view_journals(const std::string& file, const std::string& results);

  std::unique_ptr<RunReader> reader_;
  std::unique_ptr<RowCollection> journals_;
  std::shared_ptr<const RowsInHand> in_hand_;
  RowView view_;
};

/// Returns a line that says how many files of collections were left out; empty if none was.
std::string left_out_text(const StudyIdentity& identity);

/// Returns a verdict as `ar3d check --json` prints it.
nlohmann::ordered_json verdict_json(const CheckVerdict& verdict, const StudyIdentity& identity);

/// Returns the one verdict on a study. @param file  for messages.
/// @throws InputError if the rows cannot be of one study.
CheckVerdict judge(const RowView& rows, const std::string& file);

}  // namespace ar3d
