#include "kiosk/keepsake/souvenir/pass.h"

#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <span>
#include <system_error>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/shared_folder.h"
#include "kiosk/keepsake/souvenir/pass_ages.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {
namespace {

constexpr std::int64_t kFirstGiven = 1'767'225'600;  // 2026: an earlier clock is surely wrong

/// True if the clock was ahead by over a year when the pass was given. Where it is less, or the
/// clock is known to be back, it is the clock that is not believed.
bool is_from_a_wrong_future(const Pass& pass, std::int64_t now) {
  return now >= kFirstGiven && pass.from - now > files::kJump;
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
    for (bits += 8; bits >= 5; bits -= 5) token += kTokenAlphabet[held >> (bits - 5) & 31u];
    held &= 31u;
  }
  token += kTokenAlphabet[held << (5 - bits) & 31u];
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
            is_language_code(language) ? language : std::string()};
  // Count a keepsake once, whichever of its passes is used.
  for (const std::string& other : tokens_of(keepsakes_))
    if (const auto given = read_pass(keepsakes_, other);
        given && *given && (*given)->visit == visit) {
      pass.counted = (*given)->counted;
      if (pass.language.empty()) pass.language = (*given)->language;
    }
  if (pass.counted.empty()) {
    auto made = new_token();
    if (!made) return tl::unexpected(made.error());
    pass.counted = std::move(*made);
  }
  if (auto made = files::make_folder(folder()); !made) return tl::unexpected(made.error());
  // Root at the desk may be the first: the kiosk's user writes here too.
  struct stat of {};
  if (::geteuid() == 0 && ::stat(keepsakes_.c_str(), &of) == 0)
    static_cast<void>(::lchown(folder().c_str(), of.st_uid, of.st_gid));
  files::share_as_above(folder());
  const std::string text = text_of(pass);
  if (auto written = files::write_durably(folder() / pass.token, std::as_bytes(std::span(text)));
      !written)
    return tl::unexpected(written.error());
  return pass;
}

Result<Pass> Passes::give_at_the_desk(const fs::path& visit, std::int64_t now, double hours) {
  // A shell completes a folder's name with a slash, and "." is a folder too.
  std::error_code error;
  fs::path folder = fs::absolute(visit, error).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  const std::string name = folder.filename().string();
  const auto kind = fs::symlink_status(folder, error).type();
  if (is_visit_name(name) && kind == fs::file_type::symlink)
    return problem(visit.string(), "This is a link, and links to visits are not followed.",
                   "Name the visit's own folder.");
  if (is_visit_name(name) && kind != fs::file_type::directory)
    return problem(visit.string(), "This visit's folder does not exist.",
                   "Name a folder inside the keepsake folder; it may have been deleted.");
  if (!is_visit_name(name) || visit_name(name) != name)
    return problem(visit.string(), "This is not a visit's folder.",
                   "Name a folder inside the keepsake folder.");
  return Passes(folder.parent_path()).give(name, now, hours);
}

void Passes::take_back(const Pass& pass) const {
  std::error_code error;
  if (is_token(pass.token)) fs::remove(folder() / pass.token, error);
}

void Passes::take_back_all(const std::string& visit) const {
  for (const std::string& token : tokens_of(keepsakes_))
    if (const auto pass = read_pass(keepsakes_, token); pass && *pass && (*pass)->visit == visit)
      take_back(**pass);
}

std::set<std::string> Passes::promised(std::int64_t now) const {
  std::vector<Pass> passes;
  std::vector<std::int64_t> given;
  for (const std::string& token : tokens_of(keepsakes_))
    if (auto pass = read_pass(keepsakes_, token); pass && *pass) {
      given.push_back((*pass)->from);
      passes.push_back(std::move(**pass));
    }
  const PassAges ages(std::move(given));
  std::set<std::string> visits;
  for (Pass& pass : passes)
    if (!ages.over(pass, now) && !is_from_a_wrong_future(pass, now))
      visits.insert(std::move(pass.visit));
  return visits;
}

bool Passes::served(std::int64_t now) const {
  struct stat said {};
  if (::stat((folder() / kServed).c_str(), &said) != 0) return false;
  const std::int64_t ago = now - said.st_mtime;
  return ago < kSilent && ago > -kSilent;
}

}  // namespace onggi::souvenir
