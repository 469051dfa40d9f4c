#include "kiosk/keepsake/phone/probes.h"

#include <algorithm>
#include <iterator>

namespace onggi::phone {

namespace {

constexpr std::string_view kApple =
    "<HTML><HEAD><TITLE>Success</TITLE></HEAD><BODY>Success</BODY></HTML>";
constexpr std::string_view kFirefox =
    "<meta http-equiv=\"refresh\" "
    "content=\"0;url=https://support.mozilla.org/kb/captive-portal\"/>";

constexpr Probe kProbes[] = {
    {"/hotspot-detect.html", 200, "text/html", kApple},                 // iOS, macOS
    {"/library/test/success.html", 200, "text/html", kApple},           // before iOS 7
    {"/generate_204", 204, "", ""},                                     // Android, ChromeOS
    {"/gen_204", 204, "", ""},                                          // Android, second try
    {"/connecttest.txt", 200, "text/plain", "Microsoft Connect Test"},  // Windows 10 and 11
    {"/ncsi.txt", 200, "text/plain", "Microsoft NCSI"},                 // Windows 7 and 8
    {"/success.txt", 200, "text/plain", "success\n"},                   // Firefox
    {"/canonical.html", 200, "text/html", kFirefox},                    // Firefox since 89
    {"/nm", 200, "text/plain", "NetworkManager is online\n"},           // Debian
    {"/check_network_status.txt", 200, "text/plain", "NetworkManager is online\n"}};

}  // namespace

const Probe* probe_of(std::string_view target) {
  const std::string_view path = target.substr(0, target.find('?'));
  const auto* found = std::find_if(std::begin(kProbes), std::end(kProbes),
                                   [&](const Probe& probe) { return probe.path == path; });
  return found == std::end(kProbes) ? nullptr : found;
}

}  // namespace onggi::phone
