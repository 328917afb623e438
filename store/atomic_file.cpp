#include "ar3d/store/atomic_file.h"

#include "ar3d/base/new_file.h"

namespace ar3d {

void write_file_atomically(const std::string& path, std::span<const char> bytes) {
  NewFile file(path);
  file.write_all(bytes);
  file.become_target();
}

bool create_file_atomically(const std::string& path, std::span<const char> bytes) {
  NewFile file(path);
  file.write_all(bytes);
  return file.become_new_target();
}

void require_writable(const std::string& path) { const NewFile probe(path); }

}  // namespace ar3d
