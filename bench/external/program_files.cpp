#include "ar3d/bench/external/program_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "ar3d/store/study_identity.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

/// The hash of a regular file's bytes; nothing if it is none or cannot be read.
std::optional<std::string> hash_of_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || error) return {};
  std::ifstream file(path, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  if (!file) return {};
  return content_hash(bytes.str());
}

/// As execvp looks it up.
std::optional<std::string> hash_of_executable(const std::string& name) {
  if (name.find('/') != std::string::npos) return hash_of_file(name);
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable == nullptr ? "/bin:/usr/bin" : variable);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (auto hash = hash_of_file(fs::path(folder) / name)) return hash;
  }
  return {};
}

}  // namespace

std::string program_hash(const ExternalAlgorithm& program) {
  const std::optional<std::string> executable = hash_of_executable(program.command.front());
  if (!executable) return kAbsentProgram;
  std::string all = *executable;
  for (std::size_t i = 1; i < program.command.size(); ++i) {
    if (const auto hash = hash_of_file(program.command[i])) all += " " + *hash;
  }
  return content_hash(all);
}

}  // namespace ar3d
