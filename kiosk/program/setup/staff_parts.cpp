#include "kiosk/program/setup/staff_parts.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <span>
#include <string>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/setup/programs.h"

namespace fs = std::filesystem;

namespace onggi::setup {

namespace {

constexpr std::size_t kMostOfAText = 1u << 20;
constexpr auto kForAPackage = std::chrono::minutes(10);
constexpr auto kForOpenssl = std::chrono::seconds(60);

std::string text_in(const fs::path& file) {
  const auto bytes = files::read_file(file, kMostOfAText);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

Result<void> remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) return tl::unexpected(files::disk_problem(file, "remove", error.value()));
  return {};
}

Result<void> put(const fs::path& file, const std::string& text) {
  if (auto made = files::make_folder(file.parent_path()); !made) return made;
  return files::write_durably(file, std::as_bytes(std::span(text)));
}

/// The first line of a certificate that setup made for `names`.
std::string line_for(const std::string& names) {
  return std::string(kMadeLine) + " for " + names + '\n';
}

/// Root's, and readable by the web server: nobody else may pretend to be the kiosk.
Result<void> give_key(const fs::path& key, const System& system) {
  const auto group = group_of(system, kWebUser);
  if (!group) return tl::unexpected(group.error());
  // In this order: the group that it has now is given no right.
  if (::chmod(key.c_str(), 0600) != 0 || ::chown(key.c_str(), ::geteuid(), *group) != 0 ||
      ::chmod(key.c_str(), 0640) != 0)
    return tl::unexpected(files::disk_problem(key, "give to its group", errno));
  return {};
}

/// What openssl reads instead of the machine's own settings.
std::string openssl_settings(const std::string& names) {
  const std::string first = names.substr(names.find(':') + 1);
  return "[req]\nprompt = no\ndistinguished_name = name\nx509_extensions = page\n[name]\nCN = " +
         first.substr(0, first.find(',')) + "\nO = Onggi\n[page]\nsubjectAltName = " + names +
         "\nbasicConstraints = critical, CA:FALSE\nkeyUsage = critical, digitalSignature\n"
         "extendedKeyUsage = serverAuth\nsubjectKeyIdentifier = hash\n";
}

Result<void> openssl(const std::vector<std::string>& words, const fs::path& certificate,
                     int out = -1) {
  const auto status = run_program("openssl", words, kForOpenssl, out);
  if (!status) return tl::unexpected(status.error());
  if (*status == 0) return {};
  return problem(certificate.string(), "openssl made no certificate.",
                 "See what it says above, and try again.", 1);
}

}  // namespace

Result<Change> put_file(const Step& step, const System& system, bool dry) {
  const fs::path file = system.at(step.to);
  const std::string told = step.to.string() + ": " + step.why;
  const std::string now = text_in(file);
  if (now == step.text) return Change{false, told};
  if (is_there(file) && !now.starts_with(kMadeLine))
    return Change{false, step.to.string() + ": stays as it is, the machine's own"};
  if (!dry)
    if (auto written = put(file, step.text); !written) return tl::unexpected(written.error());
  return Change{true, told};
}

Result<Change> mask(const Step& step, const System& system, bool dry) {
  const fs::path link = system.at(step.to);
  const std::string unit = step.to.filename().string(), told = unit + ": " + step.why;
  std::error_code error;
  if (fs::read_symlink(link, error) == "/dev/null") return Change{false, told};
  if (is_there(link)) return Change{false, unit + ": stays as it is, the machine's own"};
  if (dry) return Change{true, told};
  if (auto made = files::make_folder(link.parent_path()); !made)
    return tl::unexpected(made.error());
  fs::create_symlink("/dev/null", link, error);
  if (error) return tl::unexpected(files::disk_problem(link, "make", error.value()));
  // Else a running systemd does not know yet.
  if (system.runs()) static_cast<void>(systemctl(system, {"daemon-reload"}));
  return Change{true, told};
}

Result<Change> install(const Step& step, const System& system, bool dry) {
  const std::string name = step.from.string();
  if (is_there(system.at(step.to))) return Change{false, name + ": " + step.why};
  const Change change{true, name + ": installed, " + step.why};
  if (dry) return change;
  const Problem missing{name, "It is missing, and could not be installed.",
                        "Connect the machine to the web for this command, or install it from "
                        "elsewhere: sudo apt install " +
                            name,
                        1};
  if (system.root != "/") return tl::unexpected(missing);
  const std::vector<std::string> quiet{"DEBIAN_FRONTEND=noninteractive", "apt-get", "-q"};
  const auto apt = [&quiet](const std::vector<std::string>& words) {
    std::vector<std::string> all = quiet;
    all.insert(all.end(), words.begin(), words.end());
    const auto status = run_program("env", all, kForAPackage);
    return status && *status == 0;
  };
  const std::vector<std::string> words{"install", "-y", "--no-install-recommends", name};
  // On a fresh machine the list of packages may be missing, or old.
  if (!apt(words) && !(apt({"update"}) && apt(words))) return tl::unexpected(missing);
  return change;
}

Result<Change> make_certificate(const Step& step, const System& system, bool dry) {
  const fs::path certificate = system.at(step.to), key = system.at(step.from);
  const std::string told = step.to.string() + ": " + step.why, now = text_in(certificate);
  if (is_there(certificate) && !now.starts_with(kMadeLine))
    return Change{false, step.to.string() + ": stays as it is, the machine's own"};
  const int soon = kRenewDays * 24 * 3600;
  if (now.starts_with(line_for(step.text)) && is_there(key))
    if (const auto good = run_program(
            "openssl",
            {"x509", "-noout", "-checkend", std::to_string(soon), "-in", certificate.string()},
            kForOpenssl, -1);
        good && *good == 0)
      return Change{false, told};
  if (dry) return Change{true, told};
  const fs::path folder = certificate.parent_path(), settings = folder / "openssl.part",
                 new_key = folder / "key.part", made = folder / "certificate.part";
  const auto all = [&]() -> Result<void> {
    if (auto good = put(settings, openssl_settings(step.text)); !good) return good;
    if (auto good = openssl({"genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256",
                             "-out", new_key.string()},
                            certificate);
        !good)
      return good;
    if (auto good =
            openssl({"req", "-x509", "-sha256", "-days", std::to_string(kCertificateDays),
                     "-config", settings.string(), "-key", new_key.string(), "-out", made.string()},
                    certificate);
        !good)
      return good;
    if (auto good = give_key(new_key, system); !good) return good;
    // After a power cut a certificate never stands beside another's key.
    if (auto good = remove_file(certificate); !good) return good;
    if (auto good = files::rename_durably(new_key, key); !good) return good;
    return put(certificate, line_for(step.text) + text_in(made));
  }();
  std::error_code ignored;
  for (const fs::path& part : {settings, new_key, made}) fs::remove(part, ignored);
  if (!all) return tl::unexpected(all.error());
  return Change{true, told};
}

Result<void> tell_fingerprint(const fs::path& certificate) {
  return openssl({"x509", "-noout", "-fingerprint", "-sha256", "-in", certificate.string()},
                 certificate, 1);
}

Result<Change> remove_made(const Step& step, const System& system, bool dry) {
  const fs::path file = system.at(step.to);
  if (!text_in(file).starts_with(kMadeLine))
    return Change{false, step.to.string() + ": stays, because it is no longer as setup made it"};
  if (!dry) {
    if (auto gone = remove_file(file); !gone) return tl::unexpected(gone.error());
    if (!step.from.empty())
      if (auto gone = remove_file(system.at(step.from)); !gone) return tl::unexpected(gone.error());
    // Folders that are empty now.
    std::error_code ignored;
    for (fs::path folder = step.to.parent_path();
         folder.string().starts_with("/etc/onggi") && fs::remove(system.at(folder), ignored);
         folder = folder.parent_path()) {
    }
  }
  return Change{true, step.to.string() + ": removed"};
}

Result<Change> unmask(const Step& step, const System& system, bool dry) {
  const fs::path link = system.at(step.to);
  const std::string unit = step.to.filename().string();
  std::error_code error;
  if (fs::read_symlink(link, error) != "/dev/null")
    return Change{false, unit + ": stays, because it is no longer as setup made it"};
  const bool installed = is_there(system.at("/usr/lib/systemd/system/" + unit)) ||
                         is_there(system.at("/lib/systemd/system/" + unit));
  const Change change{true, unit + (installed ? ": may start again, but not with the machine"
                                              : ": may start again")};
  if (dry) return change;
  if (auto gone = remove_file(link); !gone) return tl::unexpected(gone.error());
  // Its package wanted it to start; before setup it was not there.
  if (installed) static_cast<void>(systemctl(system, {"--quiet", "disable", unit}));
  return change;
}

}  // namespace onggi::setup
