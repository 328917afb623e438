#pragma once

#include <string>
#include <vector>

namespace ar3d {

/// Whether finished results may be replaced.
enum class Force {
  not_offered,  ///< the verb has no such option
  not_given,    ///< it has, and it was not given
  given         ///< --force
};

/// The files of a verb, looked at before it does any work. An empty path stands for an option that
/// was left out, "-" for a standard stream: both are no file.
struct VerbFiles {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;  ///< every one that will be written
  Force force = Force::not_offered;
};

/// Refuses to write what somebody still needs:
/// - an output that is an input of the same verb, or another of its outputs, under whatever name
///   (links and `..` are followed);
/// - a journal, or the results file of a study that is not finished;
/// - unless --force is given, a results file that exists.
/// Other files that exist may be replaced, as long as they are regular files.
/// @throws InputError naming the file and what it is.
void refuse_unsafe_outputs(const VerbFiles& files);

/// For a report whose name the user has not given, since it follows from that of the results: what
/// stands there may be replaced only if it is a report of ar3d. @throws InputError naming the file.
void refuse_foreign_page(const std::string& page, const std::string& results);

}  // namespace ar3d
