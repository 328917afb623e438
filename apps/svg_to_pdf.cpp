#include "svg_to_pdf.h"

#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>

#include "ar3d/base/error.h"

namespace ar3d {

void convert_svg_to_pdf(const std::string& svg_path, const std::string& pdf_path) {
  setenv("SOURCE_DATE_EPOCH", "0", 0);  // else the PDF holds the time of day
  std::array<std::string, 6> words = {"rsvg-convert", "--format=pdf", "-o",
                                      pdf_path,       "--",           svg_path};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, "rsvg-convert", nullptr, nullptr, arguments.data(), environ);
  if (error != 0) {
    throw InputError(fmt::format("cannot run rsvg-convert ({}); it is in Debian's librsvg2-bin",
                                 std::strerror(error)));
  }
  int status = 0;
  if (waitpid(process, &status, 0) != process || status != 0) {
    throw InputError(fmt::format("rsvg-convert cannot write {}", pdf_path));
  }
}

}  // namespace ar3d
