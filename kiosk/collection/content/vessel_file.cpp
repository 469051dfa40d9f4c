#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

using Kind = files::ReadFault::Kind;

std::string mib(std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

/// The Problem of a file that was opened but is wrong.
Problem not_read(const std::string& name, const files::ReadFault& fault, std::size_t most,
                 const std::string& key = "file_mb") {
  if (fault.kind == Kind::too_large)
    return beyond_limit(name, "it has " + mib(fault.size), mib(most), key);
  if (fault.kind == Kind::unreadable)
    return {name, "it cannot be read: " + fault.reason + ".",
            "Check the disk and the file's permissions."};
  return {name, "it is not a regular file.", "Name a file, not a folder or a device."};
}

}  // namespace

Problem beyond_limit(const std::string& where, const std::string& what, const std::string& limit,
                     const std::string& key, const std::string& smaller) {
  return {where, what + ", but the limit is " + limit + ".",
          smaller + ", or raise " + key + " in the exhibit's [reader]."};
}

Result<files::Bytes> read_vessel_file(const std::filesystem::path& file, std::size_t most,
                                      const std::string& key) {
  auto bytes = files::read_file(file, most);
  if (bytes) return std::move(*bytes);
  if (bytes.error().kind == Kind::missing || bytes.error().kind == Kind::closed)
    return problem(file.string(), "it cannot be opened: " + bytes.error().reason + ".",
                   "Check the name, and check that the kiosk can read it.");
  return tl::unexpected(not_read(file.string(), bytes.error(), most, key));
}

namespace {

Problem not_read_beneath(const std::string& name, const std::string& uri,
                         const files::ReadFault& fault, std::size_t most) {
  const std::string shown = uri.substr(0, 80);
  switch (fault.kind) {
    case Kind::outside:
      return {name, "it asks for \"" + shown + "\", which is outside its own folder.",
              "Put every file of the vessel into its folder, or export it as one GLB."};
    case Kind::link:
      return {name, "it asks for \"" + shown + "\", which goes through a symbolic link.",
              "Put the file itself into the vessel's folder."};
    case Kind::missing:
    case Kind::closed:
      return {name, "its file \"" + shown + "\" is missing: " + fault.reason + ".",
              "Put the file beside it, or export the vessel as one GLB."};
    default:
      return not_read(name + ", file \"" + shown + "\"", fault, most);
  }
}

}  // namespace

Result<files::Bytes> read_vessel_file_beneath(const std::filesystem::path& folder,
                                              const std::string& uri, std::size_t most,
                                              const std::string& name) {
  auto bytes = files::read_beneath(folder, uri, most);
  if (bytes) return std::move(*bytes);
  return tl::unexpected(not_read_beneath(name, uri, bytes.error(), most));
}

Result<std::filesystem::path> find_vessel_file_beneath(const std::filesystem::path& folder,
                                                       const std::string& uri,
                                                       const std::string& name) {
  auto found = files::find_beneath(folder, uri);
  if (found) return std::move(*found);
  return tl::unexpected(not_read_beneath(name, uri, found.error(), 0));
}

}  // namespace onggi::content
