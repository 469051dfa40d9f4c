#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/program/setup/addresses.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// What the staff's page by HTTPS needs on a machine: nginx's address and certificate, and where
/// the console listens. The programs' units read these files.
inline constexpr const char* kStaffWeb = "/etc/onggi/staff-web";
/// The museum's own certificate and key, where it put them.
inline constexpr const char* kOwnCertificate = "/etc/onggi/staff-web/certificate.pem";
inline constexpr const char* kOwnKey = "/etc/onggi/staff-web/key.pem";
/// Those that setup makes.
inline constexpr const char* kMadeCertificate = "/etc/onggi/staff-web/self-signed.pem";
inline constexpr const char* kMadeKey = "/etc/onggi/staff-web/self-signed-key.pem";
/// The socket by which nginx asks the console.
inline constexpr const char* kStaffSocket = "/run/onggi-console/page.sock";

/// The steps from a kiosk to its staff's page at `at` by HTTPS: rights in the exhibit, Debian's own
/// page kept from starting, nginx and openssl, certificate, addresses, units. Where nginx is the
/// museum's own, it is left alone.
std::vector<Step> staff_web_steps(const StaffAddress& at, const System& system);

/// The museum put its own certificate and key there.
bool has_own_certificate(const System& system);

/// The pages' addresses that setup wrote, "https://192.168.1.20" first. Empty: none.
std::vector<std::string> staff_pages(const System& system);

/// Starts the page on a running system, or starts it again with other addresses. Problem, exit 1.
Result<void> start_console(const System& system);

/// What whoever ran setup should know: nginx is the museum's own. Empty: nothing.
std::string staff_web_remark(const System& system);

}  // namespace onggi::setup
