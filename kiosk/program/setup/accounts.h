#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// The users and groups that the package creates (package/system/sysusers.conf).
inline constexpr const char* kKioskUser = "onggi";
/// Who is of it may delete what the kiosk kept.
inline constexpr const char* kKeepsakesGroup = "onggi-keepsakes";
/// Who is of it may change the exhibit.
inline constexpr const char* kSiteGroup = "onggi-site";
/// The user and group of the program that serves the staff's page by HTTPS.
inline constexpr const char* kWebUser = "onggi-staff-web";

struct Owner {
  uid_t user;
  gid_t group;
};

/// The ids of the user `name`, from the target system's list, which may not be this machine's. A
/// line without numbers is ignored. Problem, exit 1: there is no such user.
Result<Owner> user_of(const System& system, const std::string& name);
/// The same for a group.
Result<gid_t> group_of(const System& system, const std::string& name);

}  // namespace onggi::setup
