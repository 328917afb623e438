// LD_PRELOAD library: the program under test meets a death or a full disk at a chosen call. It
// counts the calls that change files and acts as the environment says:
//   AR3D_FAULT=before:K   SIGKILL instead of the K-th call
//   AR3D_FAULT=half:K     the K-th call, if it writes, writes half of its bytes; then SIGKILL
//   AR3D_FAULT=after:K    SIGKILL just after the K-th call
//   AR3D_FAULT=full:B     the disk has room for B more bytes
//   AR3D_FAULT=list:K     from the K-th time on, no folder can be listed
//   AR3D_FAULT=read:K     from the K-th time on, no *.journal can be opened for reading
//   AR3D_FAULT=errno:K    the K-th call on a file below AR3D_FAULT_IN fails with EMFILE or EIO;
//                         says so on standard error
//   AR3D_FAULT=unlink:K   SIGKILL instead of the K-th removal of a *.journal
//   AR3D_FAULT=late:MS    every write to a *.journal comes so many milliseconds late
//   AR3D_FAULT=fork:K     from the K-th on, no process can be forked
//   AR3D_FAULT=thread:K   from the K-th on, no thread can be started
//   AR3D_FAULT=lie:K      forked processes tell lie K (lie_in)
//   AR3D_FAULT=change:K   before the folder AR3D_FAULT_IN is opened for the K-th time, the file
//                         AR3D_FAULT_FROM becomes AR3D_FAULT_TO
//   AR3D_FAULT=nolock:1   locks are granted to everybody (NFS mounted with nolock)
//   AR3D_FAULT=nolink:L   no hard links and no files without a name; L = 2: nor a rename that
//                         replaces nothing
// AR3D_ACKNOWLEDGED names a file; into it goes, after every completed write to a *.journal, how
// long that journal is: the witness of what was acknowledged.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

struct Fault {
  Fault() {
    const char* text = std::getenv("AR3D_FAULT");
    if (text == nullptr || std::sscanf(text, "%7[a-z]:%ld", kind, &count) != 2) kind[0] = '\0';
    if (const char* path = std::getenv("AR3D_ACKNOWLEDGED")) {
      const int file =
          static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CREAT, 0600));
      if (file >= 0 && syscall(SYS_ftruncate, file, sizeof(long)) == 0) {
        void* place = mmap(nullptr, sizeof(long), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (place != MAP_FAILED) acknowledged = static_cast<std::atomic<long>*>(place);
      }
      if (file >= 0) syscall(SYS_close, file);
    }
  }
  bool is(const char* name) const { return std::strcmp(kind, name) == 0; }

  char kind[8] = {};  // the longest is "before"
  long count = 0;
  const long process = syscall(SYS_getpid);
  std::atomic<long> calls = 0;
  std::atomic<long> bytes = 0;
  std::atomic<long>* acknowledged = nullptr;
};

Fault& fault() {
  static Fault instance;
  return instance;
}

void die() { syscall(SYS_kill, syscall(SYS_getpid), SIGKILL); }

// Counts a call; true if it is the one.
bool begins() {
  Fault& f = fault();
  if (f.is("errno") || f.is("unlink") || f.is("change"))
    return false;  // which count for themselves
  const bool hit = ++f.calls == f.count;
  if (hit && f.is("before")) die();
  return hit;
}

template <class Result>
Result ends(bool hit, Result result) {
  if (hit && (fault().is("after") || fault().is("half"))) die();
  return result;
}

bool is_regular(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

bool is_journal(const char* path, std::size_t size) {
  return size >= 8 && std::memcmp(path + size - 8, ".journal", 8) == 0;
}

void witness(int file) {
  if (fault().acknowledged == nullptr && !fault().is("late")) return;
  char link[64];
  char path[4096];
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  const ssize_t size = readlink(link, path, sizeof(path) - 1);
  if (size < 0 || !is_journal(path, static_cast<std::size_t>(size))) return;
  if (fault().is("late")) {
    usleep(static_cast<unsigned>(1000 * fault().count));
    return;
  }
  *fault().acknowledged = static_cast<long>(lseek(file, 0, SEEK_CUR));
}

// Counts a call on a file below the folder that is looked at; true if it is to fail.
bool is_refused(const char* path, int reason) {
  static const char* const folder = std::getenv("AR3D_FAULT_IN");
  if (!fault().is("errno") || folder == nullptr || path == nullptr ||
      std::strstr(path, folder) == nullptr || ++fault().calls != fault().count) {
    return false;
  }
  constexpr char kSaid[] = "fault of call\n";
  if (syscall(SYS_write, 2, kSaid, sizeof(kSaid) - 1) < 0) return false;
  errno = reason;
  return true;
}

bool is_refused(int file) {
  if (!fault().is("errno")) return false;
  char link[64];
  char path[4096] = {};
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  return readlink(link, path, sizeof(path) - 1) > 0 && is_refused(path, EIO);
}

ssize_t real_write(int file, const void* from, std::size_t count) {
  return syscall(SYS_write, file, from, count);
}

// Another process renames a file while the program is at work.
void change_folder(const char* path) {
  static const char* const folder = std::getenv("AR3D_FAULT_IN");
  if (!fault().is("change") || folder == nullptr || path == nullptr ||
      std::strcmp(path, folder) != 0 || ++fault().calls != fault().count) {
    return;
  }
  syscall(SYS_renameat2, AT_FDCWD, std::getenv("AR3D_FAULT_FROM"), AT_FDCWD,
          std::getenv("AR3D_FAULT_TO"), 0);
}

void put_number(void* at, unsigned long number) { std::memcpy(at, &number, sizeof(number)); }

// A reader process says, twice: bytes to come and 1 (or 0, for a message), those bytes. The first
// ones begin with an 8 and the number of rows, the next ones are rows.
// @return how much of it is sent.
std::size_t lie_in(char* said, std::size_t size, long call) {
  const long lie = fault().count;
  if (lie == 1 && call == 2) put_number(said + 8, 5000);  // rows
  if (lie == 2 && call == 2) put_number(said + 8, 1UL << 62);
  if (lie == 3 && call == 1) put_number(said, 1UL << 63);  // bytes
  if (lie == 4 && call <= 2) return call == 1 ? (put_number(said, 0), size) : 0;
  if (lie == 5 && call == 2) put_number(said, 1UL << 63);
  if (lie == 6 && call == 1) put_number(said + 8, 0);  // a message, then
  if (lie == 7 && call == 2) std::memset(said, 0xff, size);
  if (lie == 8 && call == 4) std::memset(said, 0, size);
  if (lie == 9 && call == 4) std::memset(said, 0xff, size);
  if (lie == 11 || (lie == 12 && call == 2)) {
    for (;;) pause();
  }
  if (lie == 13) return std::min<std::size_t>(size, 1);  // a byte a call, which comes late
  if (lie == 14 && call == 2) return size / 2;           // the rest never comes
  if (lie == 15 && call == 1) put_number(said, 1UL << 30);
  if (lie == 10 && call >= 3 && call <= 4) return call == 3 ? (put_number(said, 0), size) : 0;
  return size;
}

}  // namespace

extern "C" {

pid_t fork() noexcept {
  static const auto real = reinterpret_cast<pid_t (*)()>(dlsym(RTLD_NEXT, "fork"));
  if (!fault().is("fork") || ++fault().calls < fault().count) return real();
  errno = EAGAIN;
  return -1;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*begin)(void*),
                   void* argument) noexcept {
  static const auto real =
      reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  if (fault().is("thread") && ++fault().calls >= fault().count) return EAGAIN;
  return real(thread, attributes, begin, argument);
}

ssize_t send(int socket, const void* from, std::size_t count, int flags) {
  if (!fault().is("lie") || syscall(SYS_getpid) == fault().process) {
    return syscall(SYS_sendto, socket, from, count, flags, nullptr, 0);
  }
  std::string said(static_cast<const char*>(from), count);
  said.resize(lie_in(said.data(), count, ++fault().calls));
  if (fault().count == 13) usleep(200000);
  const auto sent = syscall(SYS_sendto, socket, said.data(), said.size(), flags, nullptr, 0);
  if (fault().count == 13) return sent;
  return sent == static_cast<long>(said.size()) ? static_cast<ssize_t>(count) : sent;
}

ssize_t write(int file, const void* from, std::size_t count) {
  if (is_refused(file)) return -1;
  if (!is_regular(file)) return real_write(file, from, count);
  const bool hit = begins();
  if (hit && fault().is("half")) {
    real_write(file, from, count / 2);
    die();
  }
  if (fault().is("full")) {
    const long left = fault().count - fault().bytes;
    if (left <= 0 && count > 0) {
      errno = ENOSPC;
      return -1;
    }
    if (static_cast<long>(count) > left) count = static_cast<std::size_t>(left);
  }
  const ssize_t written = real_write(file, from, count);
  if (written > 0) fault().bytes += written;
  witness(file);
  return ends(hit, written);
}

ssize_t pread(int file, void* to, std::size_t count, off_t at) {
  if (is_refused(file)) return -1;
  return syscall(SYS_pread64, file, to, count, at);
}

int fsync(int file) {
  if (is_refused(file)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_fsync, file)));
}

int fdatasync(int file) {
  if (is_refused(file)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_fdatasync, file)));
}

int ftruncate(int file, off_t size) noexcept {
  if (is_refused(file)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_ftruncate, file, size)));
}

int rename(const char* from, const char* to) noexcept {
  if (is_refused(from, EIO)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0)));
}

int link(const char* from, const char* to) noexcept {
  if (is_refused(from, EIO)) return -1;
  if (fault().is("nolink")) {
    errno = EPERM;
    return -1;
  }
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0)));
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  if (is_refused(to, EIO)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_linkat, from_folder, from, to_folder, to, flags)));
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  if (fault().is("nolink") && fault().count >= 2 && flags != 0) {
    errno = EINVAL;
    return -1;
  }
  const bool hit = begins();
  return ends(hit,
              static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags)));
}

DIR* opendir(const char* path) {
  change_folder(path);
  if (is_refused(path, EMFILE)) return nullptr;
  static const auto real = reinterpret_cast<DIR* (*)(const char*)>(dlsym(RTLD_NEXT, "opendir"));
  if (fault().is("list") && ++fault().calls >= fault().count) {
    errno = EACCES;
    return nullptr;
  }
  return real(path);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const int mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(arguments, int) : 0;
  va_end(arguments);
  if ((flags & O_DIRECTORY) != 0) change_folder(path);
  return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const bool is_nameless = (flags & O_TMPFILE) == O_TMPFILE;
  const int mode = (flags & O_CREAT) != 0 || is_nameless ? va_arg(arguments, int) : 0;
  va_end(arguments);
  if (is_refused(path, EMFILE)) return -1;
  if (fault().is("nolink") && is_nameless) {
    errno = EOPNOTSUPP;
    return -1;
  }
  if (fault().is("read") && is_journal(path, std::strlen(path)) &&
      (flags & O_ACCMODE) == O_RDONLY && ++fault().calls >= fault().count) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int fcntl(int file, int command, ...) {
  va_list arguments;
  va_start(arguments, command);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  if (fault().is("nolock") && command == F_OFD_SETLK) return 0;
  return static_cast<int>(syscall(SYS_fcntl, file, command, argument));
}

int remove(const char* path) noexcept {
  Fault& f = fault();
  if (f.is("unlink") && is_journal(path, std::strlen(path)) && ++f.calls == f.count) die();
  const int removed = static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0));
  if (removed == 0 || errno != EISDIR) return removed;
  return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, AT_REMOVEDIR));
}

int unlink(const char* path) noexcept {
  if (is_refused(path, EIO)) return -1;
  const bool hit = begins();
  return ends(hit, static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0)));
}

}  // extern "C"
