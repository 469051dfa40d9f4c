#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::console {

/// What somebody may do: all of the desk's, or everything on the page.
enum class Role : std::uint8_t { desk, editor };
const char* name_of(Role role);  ///< "desk", "editor"
std::optional<Role> role_of(const std::string& name);

/// Somebody of the staff.
struct Person {
  std::string name;  ///< is_person_name()
  Role role = Role::desk;
  std::string hash;  ///< Argon2id of their passphrase, in libsodium's own form.
};

/// 1 to 40 letters a-z, digits, '.', '-' and '_', the first a letter: it is typed, and stands in
/// files.
bool is_person_name(const std::string& name);

/// The staff of one exhibit and their passphrases, in the file `people` of the program's state
/// folder, which nobody else may read: never in the exhibit's, which museums copy and mail. Written
/// durably, and read anew when another program has written it. One thread; a passphrase takes a
/// fifth of a second and 64 MiB (Argon2id, libsodium's "interactive").
class People {
 public:
  static constexpr std::size_t kShortest = 12, kLongest = 128;  ///< Letters of a passphrase.

  /// Makes `state` if it is missing. Problem, exit 1: it cannot be used, or others may write there.
  static Result<People> open(const std::filesystem::path& state);

  /// By name. Problem, exit 1: the file cannot be read.
  Result<std::vector<Person>> all();
  /// The role of who has this passphrase. As slow for a name that there is not.
  Result<std::optional<Role>> role_with(const std::string& name, const std::string& passphrase);
  /// The role of somebody; absent: nobody is called so (any more), or the file cannot be read.
  std::optional<Role> role_now(const std::string& name);
  /// Adds somebody, or gives them another role or passphrase (empty: it stays). Problem, exit 2: a
  /// name or passphrase that cannot be; 1: the disk.
  Result<void> set(const std::string& name, Role role, const std::string& passphrase);
  /// Problem, exit 2: nobody is called so.
  Result<void> remove(const std::string& name);

 private:
  explicit People(std::filesystem::path file) : file_(std::move(file)) {}
  Result<void> write(const std::vector<Person>& people) const;
  std::filesystem::path file_;
  std::string no_one_;  ///< A hash that no passphrase has, so that a wrong name takes as long.
};

}  // namespace onggi::console
