// A hash of the whole file stands behind its HDF5 part, where HDF5 does not look. It is checked
// before HDF5 sees the file.
#include <sys/stat.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "ar3d/base/system_calls.h"
#include "ar3d/store/hdf5/results_file.h"

namespace ar3d {
namespace {

static_assert(std::endian::native == std::endian::little, "the length is little endian");

constexpr char kMagic[] = "ar3d-checksum 1\n";
constexpr std::size_t kMagicSize = sizeof(kMagic) - 1;
constexpr std::size_t kHashedEnd = kMagicSize + sizeof(std::uint64_t);
constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;
using Ending = std::array<char, kChecksumSize>;
static_assert(kHashedEnd + sizeof(XXH128_canonical_t) == kChecksumSize);

// The last bytes of a file of `size` bytes before, all but the hash.
Ending ending_of(std::uint64_t size) {
  Ending ending{};
  std::memcpy(ending.data(), kMagic, kMagicSize);
  std::memcpy(ending.data() + kMagicSize, &size, sizeof(size));
  return ending;
}

// Where HDF5 says that a program has the file open for writing (superblocks of version 0).
constexpr std::size_t kOpenFlag = 20;

// Puts the hash of the first `size` bytes, without the flag, and of the ending before it into the
// ending, and the flag into `is_open`. False, with errno, if the bytes cannot be read.
bool put_hash(int file, std::uint64_t size, Ending& ending, bool& is_open) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       XXH3_freeState);
  XXH3_128bits_reset(state.get());
  std::vector<char> block(kReadAtOnce);
  for (std::uint64_t at = 0; at < size;) {
    const std::size_t count = std::min<std::uint64_t>(block.size(), size - at);
    if (read_whole(file, {block.data(), count}, at) < count) {
      if (errno == 0) errno = EIO;  // what a file that has shrunk is
      return false;
    }
    if (at == 0 && count > kOpenFlag) is_open = std::exchange(block[kOpenFlag], '\0') != '\0';
    XXH3_128bits_update(state.get(), block.data(), count);
    at += count;
  }
  XXH3_128bits_update(state.get(), ending.data(), kHashedEnd);
  XXH128_canonical_t hash;
  XXH128_canonicalFromHash(&hash, XXH3_128bits_digest(state.get()));
  std::memcpy(ending.data() + kHashedEnd, &hash, sizeof(hash));
  return true;
}

}  // namespace

int append_checksum(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return errno;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  Ending ending = ending_of(size);
  bool is_open = false;
  if (!put_hash(descriptor, size, ending, is_open)) return errno;
  return write_whole(descriptor, ending, size) < ending.size() ? errno : 0;
}

bool has_checksum(int descriptor, const std::string& path) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) refuse_reading(path, errno);
  const bool has_room = status.st_size >= static_cast<off_t>(kChecksumSize);
  const std::uint64_t size =
      has_room ? static_cast<std::uint64_t>(status.st_size) - kChecksumSize : 0;
  Ending found{};
  if (has_room && read_whole(descriptor, found, size) < found.size() && errno != 0)
    refuse_reading(path, errno);
  if (std::memcmp(found.data(), kMagic, kMagicSize) != 0) return false;
  Ending computed = ending_of(size);
  bool is_open = false;
  if (!put_hash(descriptor, size, computed, is_open)) refuse_reading(path, errno);
  if (found == computed) return !is_open;
  throw InputError(path + " is damaged: its bytes are not those that its checksum was made of");
}

}  // namespace ar3d
