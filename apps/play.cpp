// `ar3d play`: the page that draws and proves in a browser (apps/play), which tools/playground makes and the package installs.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

/// Returns where it is installed or built. @throws InputError that says how to get it.
std::filesystem::path installed_page() {
  std::error_code error;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* candidate : {"../share/ar3d/play.html", "../../playground/play.html"}) {
    auto page = (folder / candidate).lexically_normal();
    if (std::filesystem::is_regular_file(page, error)) return page;
  }
  throw InputError(
      "there is no play.html: Debian's package ar3d has it, and in a checkout `tools/playground "
      "play.html` makes it");
}

/// Hands this process over to the desktop's opener of pages, if there is a desktop.
void open_in_browser(const std::string& page) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::fflush(stdout);
  ::execlp("xdg-open", "xdg-open", page.c_str(), static_cast<char*>(nullptr));
}

/// @param files  with the page to write, if it is to be written.
int play(VerbFiles files) {
  const std::string page = installed_page().string();
  if (files.page.empty()) {
    print("file://{}\n", page);
    open_in_browser(page);
    return kPass;
  }
  files.inputs = {page};
  files.page_is = "<meta name=\"generator\" content=\"ar3d play\">";
  files.streams = false;
  refuse_unsafe_outputs(files);
  std::ifstream in(page, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  write_file_atomically(files.page, text);
  log(stdout, "wrote {}\n", files.page);
  return kPass;
}

}  // namespace

void add_play(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "play", "Names and opens the page that draws and proves graphs in a browser, or writes it");
  const auto files = std::make_shared<VerbFiles>();
  verb->add_option("-o,--output", files->page, "write the page to this file instead of opening it");
  add_force(*verb, files->force);
  verb->footer(
      "The page is one file. It works from disk, without a network, and sends nothing.\n"
      "Example: ar3d play -o play.html");
  verb->callback([files, &exit_code] { exit_code = play(*files); });
}

}  // namespace ar3d
