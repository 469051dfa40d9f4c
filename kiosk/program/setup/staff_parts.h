#pragma once

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

// The kinds of steps that the staff's page needs: see Step::Kind. Problem, exit 1: the disk, the
// network or another program refuses.

/// Kind::file. One that setup wrote before is written over.
Result<Change> put_file(const Step& step, const System& system, bool dry);
/// Kind::mask. A unit file of the museum's own there stays.
Result<Change> mask(const Step& step, const System& system, bool dry);
/// Kind::package. Needs a network where the package is missing.
Result<Change> install(const Step& step, const System& system, bool dry);
/// Kind::certificate. Self-signed, for kCertificateDays. One that setup made before is made anew
/// for other names, and when fewer than kRenewDays are left; another stays. The key is for root and
/// the web server's group.
Result<Change> make_certificate(const Step& step, const System& system, bool dry);

/// Some browsers refuse a certificate of more than 825 days.
inline constexpr int kCertificateDays = 820, kRenewDays = 90;

/// Prints the fingerprint of a certificate, which its browser shows too.
Result<void> tell_fingerprint(const std::filesystem::path& certificate);

/// Takes back put_file() and make_certificate().
Result<Change> remove_made(const Step& step, const System& system, bool dry);
/// Takes back mask(). The unit does not start with the machine, if it is there by now.
Result<Change> unmask(const Step& step, const System& system, bool dry);

}  // namespace onggi::setup
