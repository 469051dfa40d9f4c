#include "kiosk/program/console/people.h"

#include <fcntl.h>
#include <sodium.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <span>
#include <sstream>
#include <utility>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOfPeople = 1u << 20;
constexpr std::size_t kMostPeople = 200;
constexpr std::array kRoles{"desk", "editor"};

/// Of UTF-8: its bytes without those that continue a letter.
std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Held while the file is read and written: another program may change it too.
files::Descriptor locked(const fs::path& file) {
  files::Descriptor lock(
      ::open((file.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
  // Where there is no lock to be had, writing fails too, and says why.
  if (lock.open()) static_cast<void>(::flock(lock.get(), LOCK_EX));
  return lock;
}

Result<std::string> hash_of(const std::string& passphrase) {
  std::array<char, crypto_pwhash_STRBYTES> text{};
  if (::crypto_pwhash_str_alg(
          text.data(), passphrase.data(), passphrase.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
          crypto_pwhash_MEMLIMIT_INTERACTIVE, crypto_pwhash_ALG_ARGON2ID13) != 0)
    return problem("passphrase", "There is no memory to keep it safely.", "Free 64 MiB.", 1);
  return std::string(text.data());
}

}  // namespace

const char* name_of(Role role) { return kRoles[static_cast<std::size_t>(role)]; }

std::optional<Role> role_of(const std::string& name) {
  for (std::size_t n = 0; n < kRoles.size(); ++n)
    if (name == kRoles[n]) return static_cast<Role>(n);
  return std::nullopt;
}

bool is_person_name(const std::string& name) {
  constexpr std::size_t kMost = 40;
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= kMost && letter(name.front()) &&
         std::ranges::all_of(name, [&](char c) {
           return letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
         });
}

Result<People> People::open(const fs::path& state) {
  if (::sodium_init() < 0)
    return problem("libsodium", "It gives no random numbers.", "Restart the machine.", 1);
  if (auto made = files::make_folder(state); !made) return tl::unexpected(made.error());
  struct stat info {};
  if (::stat(state.c_str(), &info) != 0 || !S_ISDIR(info.st_mode))
    return tl::unexpected(files::disk_problem(state, "read", errno));
  // Who can write here makes himself an editor.
  if (info.st_uid != ::geteuid() && ::geteuid() != 0)
    return problem(state.string(), "This folder belongs to another user.",
                   "Run onggi-console as that user, or name another folder with --state.", 1);
  if ((info.st_mode & 077) != 0 && ::chmod(state.c_str(), 0700) != 0)
    return problem(state.string(), "Others may read or write in this folder.",
                   "Type: chmod 700 " + state.string(), 1);
  // What a power cut left of a file that was being written holds hashes too.
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(state, error))
    if (const std::string name = entry.path().filename().string();
        name.starts_with(".people.") && name.ends_with(".part"))
      fs::remove(entry.path(), error);
  People people(state / "people");
  auto nothing = hash_of("");
  if (!nothing) return tl::unexpected(nothing.error());
  people.no_one_ = std::move(*nothing);
  if (const auto read = people.all(); !read) return tl::unexpected(read.error());
  return people;
}

Result<std::vector<Person>> People::all() {
  std::vector<Person> people;
  const auto bytes = files::read_file(file_, kMostOfPeople);
  if (!bytes && bytes.error().kind == files::ReadFault::Kind::missing) return people;
  if (!bytes)
    return problem(file_.string(), "The names of the staff cannot be read. " + bytes.error().reason,
                   "Let this program's user read it.", 1);
  std::istringstream lines(std::string(bytes->begin(), bytes->end()));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream words(line);
    std::string name, role, hash, more;
    words >> name >> role >> hash;
    const auto is = role_of(role);
    if (!is_person_name(name) || !is || hash.empty() || words >> more)
      return problem(file_.string() + ":" + std::to_string(number), "This is nobody of the staff.",
                     "Remove this line. Everybody else keeps their passphrase.", 1);
    people.push_back({name, *is, hash});
  }
  return people;
}

Result<void> People::write(const std::vector<Person>& people) const {
  std::string text;
  for (const Person& one : people)
    text += one.name + ' ' + name_of(one.role) + ' ' + one.hash + '\n';
  return files::write_durably(file_, std::as_bytes(std::span(text)));
}

Result<std::optional<Role>> People::role_with(const std::string& name,
                                              const std::string& passphrase) {
  const auto people = all();
  if (!people) return tl::unexpected(people.error());
  const auto found = std::ranges::find(*people, name, &Person::name);
  const std::string& hash = found == people->end() ? no_one_ : found->hash;
  // Longer ones are nobody's, and cost time.
  const bool same =
      letters_of(passphrase) <= kLongest &&
      ::crypto_pwhash_str_verify(hash.c_str(), passphrase.data(), passphrase.size()) == 0;
  return same && found != people->end() ? std::optional(found->role) : std::nullopt;
}

std::optional<Role> People::role_now(const std::string& name) {
  const auto people = all();
  if (!people) return std::nullopt;
  const auto found = std::ranges::find(*people, name, &Person::name);
  return found != people->end() ? std::optional(found->role) : std::nullopt;
}

Result<void> People::set(const std::string& name, Role role, const std::string& passphrase) {
  if (!is_person_name(name))
    return problem(name, "This cannot be a name here.",
                   "Take 1 to 40 small letters, digits, '.', '-' or '_', a letter first: maria.k");
  std::string hash;
  const std::size_t letters = letters_of(passphrase);
  static_assert(kShortest == 12 && kLongest == 128, "said below, and in each language of the page");
  if (letters >= kShortest && letters <= kLongest) {
    auto made = hash_of(passphrase);
    if (!made) return tl::unexpected(made.error());
    hash = std::move(*made);
  }
  const files::Descriptor lock = locked(file_);
  auto people = all();
  if (!people) return tl::unexpected(people.error());
  auto found = std::ranges::find(*people, name, &Person::name);
  const bool fresh = found == people->end();
  if ((fresh || !passphrase.empty()) && letters < kShortest)
    return problem("passphrase", "It is too short.",
                   "Take 12 letters or more: a few words are good.");
  if (letters > kLongest)
    return problem("passphrase", "It is too long.", "Take 128 letters at the most.");
  if (fresh && people->size() >= kMostPeople)
    return problem(name, "There are " + std::to_string(kMostPeople) + " people already.",
                   "Remove who has left.");
  if (fresh)
    found = people->insert(std::ranges::lower_bound(*people, name, {}, &Person::name),
                           {name, role, ""});
  found->role = role;
  if (!hash.empty()) found->hash = std::move(hash);
  return write(*people);
}

Result<void> People::remove(const std::string& name) {
  const files::Descriptor lock = locked(file_);
  auto people = all();
  if (!people) return tl::unexpected(people.error());
  if (std::erase_if(*people, [&](const Person& one) { return one.name == name; }) == 0)
    return problem(name, "Nobody here is called so.", "Look at the list again.");
  return write(*people);
}

}  // namespace onggi::console
