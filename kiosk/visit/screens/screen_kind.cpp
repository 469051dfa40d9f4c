#include "kiosk/visit/screens/screen_kind.h"

#include "kiosk/visit/screens/attract_screen.h"
#include "kiosk/visit/screens/choose_screen.h"
#include "kiosk/visit/screens/clay_screen.h"
#include "kiosk/visit/screens/decorate_screen.h"
#include "kiosk/visit/screens/fault_screen.h"
#include "kiosk/visit/screens/keepsake_screen.h"
#include "kiosk/visit/screens/kiln_screen.h"
#include "kiosk/visit/screens/result_screen.h"
#include "kiosk/visit/screens/throwing_screen.h"

namespace onggi::screens {
namespace {

constexpr ScreenKind kKinds[] = {
    {.id = ScreenId::attract, .name = "attract", .make = make_attract},
    {.id = ScreenId::clay, .name = "clay", .make = make_clay},
    {.id = ScreenId::choose, .name = "choose", .make = make_choose},
    {.id = ScreenId::throwing, .name = "throw", .make = make_throwing},
    {.id = ScreenId::result, .name = "result", .make = make_result, .reads_long = true},
    {.id = ScreenId::decorate, .name = "decorate", .make = make_decorate, .reads_long = true},
    {.id = ScreenId::kiln, .name = "kiln", .make = make_kiln, .reads_long = true, .fires = true},
    {.id = ScreenId::keepsake, .name = "keepsake", .make = make_keepsake, .reads_long = true},
    {.id = ScreenId::fault, .name = "fault", .make = make_fault},
};

}  // namespace

std::span<const ScreenKind> screen_kinds() noexcept { return kKinds; }

const ScreenKind& kind_of(ScreenId id) noexcept { return kKinds[static_cast<std::size_t>(id)]; }

}  // namespace onggi::screens
