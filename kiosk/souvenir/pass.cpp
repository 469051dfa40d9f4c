#include "kiosk/souvenir/pass.h"

#include <sys/random.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <sstream>
#include <system_error>
#include <vector>

#include "kiosk/files/durable_file.h"
#include "kiosk/files/read_file.h"
#include "kiosk/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {

namespace {

constexpr std::string_view kLetters = "abcdefghijkmnpqrstuvwxyz23456789";
constexpr std::size_t kMostOfAPass = 1024;
constexpr std::size_t kMostOfAKeepsake = 256u << 20;
constexpr const char* kServed = ".served";
constexpr std::int64_t kClockBack = 24 * 3600;  // s

Result<std::string> new_token() {
  std::array<unsigned char, 16> random{};
  if (getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    return problem("getrandom", "The system gave no randomness.", "Try again.", 1);
  std::string token;
  unsigned held = 0, bits = 0;
  for (const unsigned char byte : random) {
    held = held << 8 | byte;
    for (bits += 8; bits >= 5; bits -= 5) token += kLetters[held >> (bits - 5) & 31u];
    held &= 31u;
  }
  token += kLetters[held << (5 - bits) & 31u];
  return token;
}

bool is_token(std::string_view text) {
  return text.size() == Passes::kTokenLetters &&
         text.find_first_not_of(kLetters) == std::string_view::npos;
}

/// Every letter is looked at, whichever the first wrong one is.
bool same(std::string_view token, std::string_view asked) {
  unsigned differ = token.size() == asked.size() ? 0u : 1u;
  for (std::size_t n = 0; n < token.size(); ++n) {
    const char other = n < asked.size() ? asked[n] : '\0';
    differ |= static_cast<unsigned>(static_cast<unsigned char>(token[n]) ^
                                    static_cast<unsigned char>(other));
  }
  return differ == 0;
}

std::vector<std::string> tokens_in(const fs::path& folder) {
  std::vector<std::string> tokens;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (is_token(name)) tokens.push_back(name);
  }
  return tokens;
}

}  // namespace

Result<Pass> Passes::give(const std::string& visit, std::int64_t now, double hours) const {
  if (!is_visit_name(visit) || visit_name(visit) != visit)
    return problem(visit, "That is no visit's folder.", "Name one of the folder of keepsakes.");
  const auto token = new_token();
  if (!token) return tl::unexpected(token.error());
  Pass pass{*token, visit, now, now + static_cast<std::int64_t>(hours * 3600.0)};
  if (auto made = files::make_folder(folder()); !made) return tl::unexpected(made.error());
  const std::string text =
      pass.visit + '\n' + std::to_string(pass.from) + '\n' + std::to_string(pass.until) + '\n';
  if (auto written = files::write_durably(folder() / pass.token, std::as_bytes(std::span(text)));
      !written)
    return tl::unexpected(written.error());
  return pass;
}

std::optional<Pass> Passes::read(const std::string& token) const {
  const auto bytes = files::read_beneath(folder(), token, kMostOfAPass);
  if (!bytes) return {};
  std::istringstream in(std::string(bytes->begin(), bytes->end()));
  Pass pass;
  pass.token = token;
  if (!std::getline(in, pass.visit) || !(in >> pass.from >> pass.until)) return {};
  if (!is_visit_name(pass.visit) || visit_name(pass.visit) != pass.visit) return {};
  return pass;
}

std::optional<Pass> Passes::find(std::string_view token, std::int64_t now) const {
  std::string found;
  for (const std::string& each : tokens_in(folder()))
    if (same(each, token)) found = each;
  const auto pass = read(found);
  std::error_code error;
  const bool good = pass && now < pass->until && now > pass->from - kClockBack &&
                    fs::is_directory(keepsakes_ / pass->visit, error);
  return good ? pass : std::nullopt;
}

std::optional<std::string> Passes::file_of(const Pass& pass, const char* name) const {
  const auto bytes = files::read_beneath(keepsakes_ / pass.visit, name, kMostOfAKeepsake);
  if (!bytes) return {};
  return std::string(bytes->begin(), bytes->end());
}

Result<void> Passes::remove_all_of(const Pass& pass) const {
  const fs::path visit = keepsakes_ / pass.visit;
  std::error_code error;
  // Renamed first, so that a power cut leaves a leftover that tidying removes, and no half visit.
  fs::path going = visit;
  going += kPartial;
  fs::rename(visit, going, error);
  if (!error) fs::remove_all(going, error);
  if (error && error != std::errc::no_such_file_or_directory)
    return problem(visit.string(),
                   "A visitor's keepsake could not be removed: " + error.message() + ".",
                   "Remove it, and make the folder writable.", 1);
  // The passes go last: until all is gone the visitor can ask again.
  for (const std::string& token : tokens_in(folder())) {
    const auto other = read(token);
    if (other && other->visit == pass.visit) fs::remove(folder() / token, error);
  }
  return {};
}

void Passes::serve() const {
  const std::string text = "onggi-console answers phones\n";
  if (files::make_folder(folder()))
    static_cast<void>(files::write_durably(folder() / kServed, std::as_bytes(std::span(text))));
}

void Passes::end_serving() const {
  std::error_code error;
  fs::remove(folder() / kServed, error);
}

bool Passes::served(std::int64_t now) const {
  struct stat said {};
  if (::stat((folder() / kServed).c_str(), &said) != 0) return false;
  const std::int64_t ago = now - said.st_mtime;
  return ago < kSilent && ago > -kSilent;
}

void Passes::forget(std::int64_t now) const {
  for (const std::string& token : tokens_in(folder())) {
    std::error_code error;
    if (!find(token, now)) fs::remove(folder() / token, error);
  }
}

}  // namespace onggi::souvenir
