#include "kiosk/keepsake/souvenir/pass.h"

#include <sys/random.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <span>
#include <sstream>
#include <system_error>
#include <vector>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/keepsake/souvenir/fetch_note.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {

namespace {

constexpr std::string_view kLetters = "abcdefghijkmnpqrstuvwxyz23456789";
constexpr std::size_t kMostOfAPass = 1024;
constexpr std::size_t kMostOfAKeepsake = 256u << 20;
constexpr std::size_t kLongestCode = 16;
constexpr const char* kServed = ".served";
constexpr std::int64_t kClockBack = 24 * 3600;  // s

bool is_token(std::string_view text) {
  return text.size() == Passes::kTokenLetters &&
         text.find_first_not_of(kLetters) == std::string_view::npos;
}

/// Compares every letter, wherever the first difference is.
bool same(std::string_view token, std::string_view asked, std::size_t& looked_at) {
  unsigned differ = token.size() == asked.size() ? 0u : 1u;
  for (std::size_t n = 0; n < token.size(); ++n, ++looked_at) {
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

/// True for a language code; anything else is not passed on.
bool is_code(const std::string& text) {
  return text.size() <= kLongestCode &&
         text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
             std::string::npos;
}

}  // namespace

Result<std::string> Passes::new_token() {
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

Result<Pass> Passes::give(const std::string& visit, std::int64_t now, double hours,
                          const std::string& language, std::string token) const {
  if (!is_visit_name(visit) || visit_name(visit) != visit)
    return problem(visit, "This is not a visit's folder.",
                   "Name a folder inside the keepsake folder.");
  if (token.empty()) {
    auto made = new_token();
    if (!made) return tl::unexpected(made.error());
    token = std::move(*made);
  }
  if (!is_token(token))
    return problem(token, "This is not a valid token.", "Let the program make the token.");
  Pass pass{token, visit, now, now + static_cast<std::int64_t>(hours * 3600.0),
            is_code(language) ? language : std::string()};
  // Count a keepsake once, whichever of its passes is used.
  for (const std::string& other : tokens_in(folder()))
    if (const auto given = read(other); given && given->visit == visit) {
      pass.counted = given->counted;
      if (pass.language.empty()) pass.language = given->language;
    }
  if (pass.counted.empty()) {
    auto made = new_token();
    if (!made) return tl::unexpected(made.error());
    pass.counted = std::move(*made);
  }
  if (auto made = files::make_folder(folder()); !made) return tl::unexpected(made.error());
  const std::string text = pass.visit + '\n' + std::to_string(pass.from) + '\n' +
                           std::to_string(pass.until) + '\n' + pass.language + '\n' + pass.counted +
                           '\n';
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
  // Files of an older onggi end here.
  std::string rest;
  std::getline(in, rest);
  if (!std::getline(in, pass.language) || !is_code(pass.language)) pass.language.clear();
  if (!std::getline(in, pass.counted) || !is_token(pass.counted)) pass.counted.clear();
  if (!is_visit_name(pass.visit) || visit_name(pass.visit) != pass.visit) return {};
  return pass;
}

std::optional<Pass> Passes::find(std::string_view token, std::int64_t now, Work* work) const {
  const std::vector<std::string> all = tokens_in(folder());
  Work done;
  // For a wrong token, read some pass, as for an expired one. It is always the same pass for the
  // same token, so that a second request finds it equally warm.
  const std::size_t other = all.empty() ? 0 : std::hash<std::string_view>{}(token) % all.size();
  std::string found = all.empty() ? std::string() : all[other];
  bool right = false;
  for (const std::string& each : all)
    if (same(each, token, done.letters)) {
      found = each;
      right = true;
    }
  auto pass = read(found);
  done.files = all.empty() ? 0 : 1;
  std::error_code error;
  const fs::path visit = keepsakes_ / (pass ? pass->visit : kServed);
  const bool whole = fs::is_directory(visit, error);
  const bool some = fs::is_directory(fs::path(visit) += kPartial, error);
  if (work != nullptr) *work = done;
  const bool good =
      right && pass && (whole || some) && now < pass->until && now > pass->from - kClockBack;
  if (!good) return {};
  pass->whole = whole;
  return pass;
}

std::optional<std::string> Passes::file_of(const Pass& pass, const char* name) const {
  const auto bytes = files::read_beneath(keepsakes_ / pass.visit, name, kMostOfAKeepsake);
  if (!bytes) return {};
  return std::string(bytes->begin(), bytes->end());
}

bool Passes::has_file(const Pass& pass, const char* name) const {
  std::error_code error;
  return fs::symlink_status(keepsakes_ / pass.visit / name, error).type() == fs::file_type::regular;
}

Result<void> Passes::remove_all_of(const Pass& pass) const {
  const fs::path visit = keepsakes_ / pass.visit;
  std::error_code error;
  // Rename first, so that a power cut leaves a leftover for tidying and not half a visit.
  fs::path going = visit;
  going += kPartial;
  if (fs::is_directory(going, error)) fs::remove_all(going, error);
  fs::rename(visit, going, error);
  if (!error || error == std::errc::no_such_file_or_directory) fs::remove_all(going, error);
  if (error)
    return problem(visit.string(),
                   "A visitor's keepsake could not be removed: " + error.message() + ".",
                   "Remove it, and make the folder writable.", 1);
  // Remove the passes last: until everything is gone the visitor can ask again.
  for (const std::string& token : tokens_in(folder())) {
    const auto other = read(token);
    if (other && other->visit == pass.visit) fs::remove(folder() / token, error);
  }
  return {};
}

void Passes::take_back(const Pass& pass) const {
  std::error_code error;
  if (is_token(pass.token)) fs::remove(folder() / pass.token, error);
}

void Passes::note_fetched(const Pass& pass, std::int64_t now) const {
  if (pass.counted.empty()) return;
  // If the disk refuses the note, the page is not counted, but the visitor has it.
  static_cast<void>(leave_fetch_note(
      fetched(), {pass.counted, files::local_time(static_cast<std::time_t>(now), files::kDay)}));
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
