#include "kiosk/collection/archives/unpack.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include <array>
#include <cerrno>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "kiosk/collection/archives/archive_directory.h"
#include "kiosk/collection/archives/entry_names.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/free_space.h"

namespace onggi::archives {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = 65536;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
  void operator()(zip_file_t* file) const { static_cast<void>(zip_fclose(file)); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

/// An entry that was looked at and may be unpacked.
struct Entry {
  zip_uint64_t index = 0;
  std::string name;  // with '/' at its end: a folder
  std::uint64_t bytes = 0;
};

std::string megabytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

tl::unexpected<Problem> damaged(const std::string& where, const std::string& why) {
  return problem(where, "this is damaged: " + why + '.',
                 "Make the archive again, and copy all of it.");
}

Result<Archive> opened(const fs::path& file) {
  int code = 0;
  if (zip_t* archive = zip_open(file.c_str(), ZIP_RDONLY, &code)) return Archive(archive);
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  return damaged(file.string(), why);
}

/// A Problem for an entry that is neither a file nor a folder. The upper half of the attributes has
/// the mode where a Unix made the archive, and zeros elsewhere.
Result<void> check_kind(zip_t* archive, zip_uint64_t index, const std::string& where, bool folder) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) != 0)
    return damaged(where, "its attributes cannot be read");
  const mode_t kind = (attributes >> 16) & S_IFMT;
  if (kind == 0 || kind == (folder ? S_IFDIR : S_IFREG)) return {};
  return problem(where, "this is a link or a special file.",
                 "Put the file itself into the folder, and make the archive again.");
}

Result<void> check_packing(const zip_stat_t& info, const std::string& where) {
  constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_CRC;
  if ((info.valid & kNeeded) != kNeeded) return damaged(where, "its size is not said");
  if ((info.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && info.encryption_method != ZIP_EM_NONE)
    return problem(where, "this is locked with a password.",
                   "Make the archive again without a password.");
  if (info.comp_method != ZIP_CM_STORE && info.comp_method != ZIP_CM_DEFLATE)
    return problem(where, "this is packed in a way that the kiosk does not read.",
                   "Make the archive again with this computer's own zip program.");
  return {};
}

/// All entries to unpack, looked at one by one and together, before anything is written.
class Look {
 public:
  Look(zip_t* archive, std::string name, const UnpackLimits& limits)
      : archive_(archive),
        name_(std::move(name)),
        limits_(limits),
        names_(name_, limits.depth),
        left_(limits.bytes) {}

  Result<std::vector<Entry>> all() {
    const zip_int64_t count = zip_get_num_entries(archive_, 0);
    for (zip_int64_t n = 0; n < count; ++n)
      if (auto good = one(static_cast<zip_uint64_t>(n)); !good) return tl::unexpected(good.error());
    return std::move(entries_);
  }
  std::uint64_t bytes() const { return limits_.bytes - left_; }

 private:
  Result<void> one(zip_uint64_t index) {
    const char* name = zip_get_name(archive_, index, ZIP_FL_ENC_RAW);
    zip_stat_t info;
    if (name == nullptr || zip_stat_index(archive_, index, 0, &info) != 0)
      return damaged(name_, "its directory cannot be read");
    if (auto good = names_.check(name); !good) return good;
    if (is_litter(name)) return {};
    const std::string where = names_.where(name);
    const bool folder = std::string_view(name).ends_with('/');
    if (auto good = check_kind(archive_, index, where, folder); !good) return good;
    if (auto good = check_packing(info, where); !good) return good;
    if (auto good = names_.add(name); !good) return good;
    if (info.size > left_)
      return problem(name_,
                     "unpacked, this archive has more than " + megabytes(limits_.bytes) + ".",
                     "Make an archive of the scan's own files alone.");
    left_ -= info.size;
    entries_.push_back({index, name, info.size});
    return {};
  }

  zip_t* archive_;
  std::string name_;
  UnpackLimits limits_;
  EntryNames names_;
  std::uint64_t left_;
  std::vector<Entry> entries_;
};

/// A folder that goes again, unless it is kept.
class FreshFolder {
 public:
  explicit FreshFolder(fs::path path) : path_(std::move(path)) {}
  ~FreshFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  FreshFolder(const FreshFolder&) = delete;
  FreshFolder& operator=(const FreshFolder&) = delete;
  void keep() { path_.clear(); }

 private:
  fs::path path_;
};

/// The bytes of an entry, as many as it claims and no more.
Result<void> copy(zip_file_t* from, const Entry& entry, int to, const fs::path& path,
                  const std::string& where) {
  std::array<std::byte, kPiece> piece;
  std::uint64_t written = 0;
  for (;;) {
    const zip_int64_t n = zip_fread(from, piece.data(), piece.size());
    if (n < 0) return damaged(where, zip_error_strerror(zip_file_get_error(from)));
    // libzip has compared the size and the checksum when it says that this is the end.
    if (n == 0) return {};
    // A bomb: a few bytes that claim to be little and become a full disk.
    if (static_cast<std::uint64_t>(n) > entry.bytes - written)
      return damaged(where, "it has more bytes than it claims");
    written += static_cast<std::uint64_t>(n);
    if (!files::write_all(to, std::span(piece).first(static_cast<std::size_t>(n))))
      return tl::unexpected(files::disk_problem(path, "write", errno));
  }
}

Result<void> write(zip_t* archive, const Entry& entry, const fs::path& folder,
                   const std::string& where) {
  const fs::path path = folder / entry.name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) return tl::unexpected(files::disk_problem(path, "make", error.value()));
  if (entry.name.ends_with('/')) return {};
  const std::unique_ptr<zip_file_t, Close> from(zip_fopen_index(archive, entry.index, 0));
  if (!from) return damaged(where, zip_error_strerror(zip_get_error(archive)));
  files::Descriptor to(
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!to.open()) return tl::unexpected(files::disk_problem(path, "write", errno));
  if (auto good = copy(from.get(), entry, to.get(), path, where); !good) return good;
  if (!to.close()) return tl::unexpected(files::disk_problem(path, "write", errno));
  return {};
}

Result<void> check_room(const fs::path& folder, std::uint64_t bytes, const UnpackLimits& limits) {
  const std::uint64_t free = files::free_bytes(folder);
  if (free >= limits.reserve && bytes <= free - limits.reserve) return {};
  return problem(
      folder.string(),
      "Unpacked, this archive has " + megabytes(bytes) + ", and the disk has not that much room.",
      "Free some space on this disk.", 1);
}

}  // namespace

bool is_archive_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".zip";
}

Result<void> unpack(const fs::path& file, const fs::path& folder, const UnpackLimits& limits) {
  if (auto good = check_directory(file, limits.entries); !good) return good;
  const auto archive = opened(file);
  if (!archive) return tl::unexpected(archive.error());
  Look look(archive->get(), file.string(), limits);
  const auto entries = look.all();
  if (!entries) return tl::unexpected(entries.error());
  if (::mkdir(folder.c_str(), 0755) != 0)
    return tl::unexpected(files::disk_problem(folder, "make", errno));
  FreshFolder fresh(folder);
  if (auto good = check_room(folder, look.bytes(), limits); !good) return good;
  const EntryNames names(file.string(), limits.depth);
  for (const Entry& entry : *entries)
    if (auto good = write(archive->get(), entry, folder, names.where(entry.name)); !good)
      return good;
  fresh.keep();
  return {};
}

}  // namespace onggi::archives
