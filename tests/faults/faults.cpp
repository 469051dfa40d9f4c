// A disk that fails, for LD_PRELOAD. Counts what a program does to the files below a folder
// (making, writing, syncing, cutting, renaming, removing), and at the k-th does what ONGGI_FAULTS
// asks:
//   EIO:k  ENOSPC:k     that one fails            EIO:k+ ENOSPC:k+ EROFS:k+   so do all after it
//   short:k             the k-th write takes half, and what is left of it finds the disk full
//   kill:k  killed:k    the program is killed before it, after it
//   gone:k              the folder and all in it is removed before it
//   clock:k:S           from it on the clock on the wall is S seconds off
// ONGGI_FAULTS_UNDER names the folder; ONGGI_FAULTS_LOG a file that gets one line each: "k name
// file". Only what goes through the C library's own functions is seen: that is all of ours, and
// SQLite.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

namespace {

enum class Kind { none, fails, is_short, kill, killed, gone, clock };

struct Plan {
  Kind kind = Kind::none;
  int error = 0;
  long at = 0;      // the k-th, from 1
  bool on = false;  // and all after it
  long seconds = 0;
  std::string under;
  int log = -1;
};

long after(const char* text, char sign, long none) {
  const char* found = std::strchr(text, sign);
  return found != nullptr ? std::atol(found + 1) : none;
}

Plan read_plan() {
  Plan plan;
  const char* under = std::getenv("ONGGI_FAULTS_UNDER");
  const char* what = std::getenv("ONGGI_FAULTS");
  const char* log = std::getenv("ONGGI_FAULTS_LOG");
  if (under == nullptr) return plan;
  plan.under = under;
  if (log != nullptr)
    plan.log = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (what == nullptr) return plan;
  const std::string kind(what, std::strcspn(what, ":"));
  plan.at = after(what, ':', 0);
  plan.on = std::strchr(what, '+') != nullptr;
  if (kind == "EIO" || kind == "ENOSPC" || kind == "EROFS") {
    plan.kind = Kind::fails;
    plan.error = kind == "EIO" ? EIO : kind == "ENOSPC" ? ENOSPC : EROFS;
  } else if (kind == "short") {
    plan.kind = Kind::is_short;
  } else if (kind == "kill") {
    plan.kind = Kind::kill;
  } else if (kind == "killed") {
    plan.kind = Kind::killed;
  } else if (kind == "gone") {
    plan.kind = Kind::gone;
  } else if (kind == "clock") {
    plan.kind = Kind::clock;
    plan.seconds = after(std::strchr(what, ':') + 1, ':', 0);
  }
  return plan;
}

const Plan& plan() {
  static const Plan read = read_plan();
  return read;
}

std::atomic<long> done{0};
std::atomic<bool> wrong_clock{false};
thread_local bool inside = false;  // what we do ourselves is not counted

template <class F>
F real(const char* name) {
  return reinterpret_cast<F>(::dlsym(RTLD_NEXT, name));
}

std::string path_of(int fd) {
  std::array<char, PATH_MAX> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(fd);
  const ssize_t size = ::readlink(link.c_str(), path.data(), path.size() - 1);
  return size > 0 ? std::string(path.data(), static_cast<std::size_t>(size)) : std::string();
}

bool is_under(const std::string& path) {
  return !plan().under.empty() && path.compare(0, plan().under.size(), plan().under) == 0;
}

void remove_all(const std::string& folder) {
  const std::string command = "rm -rf -- '" + folder + "'";
  ::unsetenv("LD_PRELOAD");
  (void)!std::system(command.c_str());
}

// What becomes of this one: 0, or the error that it fails with. `half` where a write takes half.
struct Fate {
  int error = 0;
  bool half = false, kill_after = false;
};
Fate fate_of(const char* name, const std::string& path) {
  if (inside || !is_under(path)) return {};
  inside = true;
  const Plan& p = plan();
  const long k = ++done;
  if (p.log >= 0) {
    const std::string line =
        std::to_string(k) + " " + name + " " + path.substr(p.under.size()) + "\n";
    (void)!::syscall(SYS_write, p.log, line.data(), line.size());
  }
  Fate fate;
  const bool now = p.kind != Kind::none && p.at > 0 && (k == p.at || (p.on && k > p.at));
  static std::atomic<bool> full{false};
  if (now) {
    if (p.kind == Kind::fails) fate.error = p.error;
    if (p.kind == Kind::is_short) fate.half = true;
    if (p.kind == Kind::kill) ::kill(::getpid(), SIGKILL);
    if (p.kind == Kind::killed) fate.kill_after = true;
    if (p.kind == Kind::gone) remove_all(p.under);
    if (p.kind == Kind::clock) wrong_clock = true;
  }
  // Half of a write is taken, and the rest finds no room; then there is room again.
  if (full.exchange(fate.half) && !fate.half) fate.error = ENOSPC;
  inside = false;
  return fate;
}

template <class Result, class Do>
Result with_fate(const char* name, const std::string& path, Do&& go) {
  const Fate fate = fate_of(name, path);
  if (fate.error != 0) {
    errno = fate.error;
    return static_cast<Result>(-1);
  }
  const Result result = go(fate.half);
  if (fate.kill_after) ::kill(::getpid(), SIGKILL);
  return result;
}

// Where a path is relative, as the kernel would take it.
std::string whole(int folder, const char* path) {
  if (path == nullptr || path[0] == '/') return path == nullptr ? "" : path;
  std::array<char, PATH_MAX> here{};
  const std::string base = folder == AT_FDCWD
                               ? (::getcwd(here.data(), here.size()) != nullptr ? here.data() : "")
                               : path_of(folder);
  return base + "/" + path;
}

template <class Open>
int opened(const char* name, int folder, const char* path, int flags, Open&& go) {
  if ((flags & O_CREAT) == 0) return go();
  return with_fate<int>(name, whole(folder, path), [&](bool) { return go(); });
}

mode_t mode_of(int flags, va_list& rest) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
}

}  // namespace

extern "C" {

#define ONGGI_OPEN(NAME)                                                                 \
  int NAME(const char* path, int flags, ...) {                                           \
    va_list rest;                                                                        \
    va_start(rest, flags);                                                               \
    const mode_t mode = mode_of(flags, rest);                                            \
    va_end(rest);                                                                        \
    static const auto go = real<int (*)(const char*, int, mode_t)>(#NAME);               \
    return opened("open", AT_FDCWD, path, flags, [&] { return go(path, flags, mode); }); \
  }
ONGGI_OPEN(open)
ONGGI_OPEN(open64)

#define ONGGI_OPENAT(NAME)                                                                     \
  int NAME(int folder, const char* path, int flags, ...) {                                     \
    va_list rest;                                                                              \
    va_start(rest, flags);                                                                     \
    const mode_t mode = mode_of(flags, rest);                                                  \
    va_end(rest);                                                                              \
    static const auto go = real<int (*)(int, const char*, int, mode_t)>(#NAME);                \
    return opened("open", folder, path, flags, [&] { return go(folder, path, flags, mode); }); \
  }
ONGGI_OPENAT(openat)
ONGGI_OPENAT(openat64)

ssize_t write(int fd, const void* bytes, size_t size) {
  static const auto go = real<ssize_t (*)(int, const void*, size_t)>("write");
  if (inside || plan().under.empty()) return go(fd, bytes, size);
  return with_fate<ssize_t>("write", path_of(fd), [&](bool half) {
    return go(fd, bytes, half && size > 1 ? size / 2 : size);
  });
}

#define ONGGI_PWRITE(NAME, OFFSET)                                                     \
  ssize_t NAME(int fd, const void* bytes, size_t size, OFFSET at) {                    \
    static const auto go = real<ssize_t (*)(int, const void*, size_t, OFFSET)>(#NAME); \
    return with_fate<ssize_t>("write", path_of(fd), [&](bool half) {                   \
      return go(fd, bytes, half && size > 1 ? size / 2 : size, at);                    \
    });                                                                                \
  }
ONGGI_PWRITE(pwrite, off_t)
ONGGI_PWRITE(pwrite64, off64_t)

#define ONGGI_FD(NAME)                                                        \
  int NAME(int fd) {                                                          \
    static const auto go = real<int (*)(int)>(#NAME);                         \
    return with_fate<int>("sync", path_of(fd), [&](bool) { return go(fd); }); \
  }
ONGGI_FD(fsync)
ONGGI_FD(fdatasync)

#define ONGGI_CUT(NAME, SIZE)                                                      \
  int NAME(int fd, SIZE size) {                                                    \
    static const auto go = real<int (*)(int, SIZE)>(#NAME);                        \
    return with_fate<int>("cut", path_of(fd), [&](bool) { return go(fd, size); }); \
  }
ONGGI_CUT(ftruncate, off_t)
ONGGI_CUT(ftruncate64, off64_t)

int rename(const char* from, const char* to) {
  static const auto go = real<int (*)(const char*, const char*)>("rename");
  return with_fate<int>("rename", whole(AT_FDCWD, to), [&](bool) { return go(from, to); });
}
int mkdir(const char* path, mode_t mode) {
  static const auto go = real<int (*)(const char*, mode_t)>("mkdir");
  return with_fate<int>("mkdir", whole(AT_FDCWD, path), [&](bool) { return go(path, mode); });
}
int unlink(const char* path) {
  static const auto go = real<int (*)(const char*)>("unlink");
  return with_fate<int>("remove", whole(AT_FDCWD, path), [&](bool) { return go(path); });
}
int unlinkat(int folder, const char* path, int flags) {
  static const auto go = real<int (*)(int, const char*, int)>("unlinkat");
  return with_fate<int>("remove", whole(folder, path),
                        [&](bool) { return go(folder, path, flags); });
}
int remove(const char* path) {
  static const auto go = real<int (*)(const char*)>("remove");
  return with_fate<int>("remove", whole(AT_FDCWD, path), [&](bool) { return go(path); });
}

int clock_gettime(clockid_t which, timespec* now) {
  const int result = static_cast<int>(::syscall(SYS_clock_gettime, which, now));
  if (result == 0 && which == CLOCK_REALTIME && wrong_clock) now->tv_sec += plan().seconds;
  return result;
}
time_t time(time_t* out) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}
int gettimeofday(timeval* now, void*) noexcept {
  timespec exact{};
  clock_gettime(CLOCK_REALTIME, &exact);
  now->tv_sec = exact.tv_sec;
  now->tv_usec = exact.tv_nsec / 1000;
  return 0;
}

}  // extern "C"
