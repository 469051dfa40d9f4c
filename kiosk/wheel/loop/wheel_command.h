#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "engine/force/leather_hand.h"
#include "engine/scene/hands.h"
#include "engine/script/ring_plan.h"
#include "engine/script/script.h"
#include "kiosk/wheel/device/hand_device.h"
#include "kiosk/wheel/loop/in_hand.h"

namespace onggi::loop {

struct Pot;

/// The main thread's requests to the loop, one type a kind. A pot, script or wall belongs to the
/// holder of its command; devices stay the host's.
namespace command {
struct Put {  ///< Puts a pot on the wheel; the old one is returned.
  Pot* pot = nullptr;
};
struct GiveBack {};
struct Play {  ///< nullptr: the visitor's hands again.
  Script* script = nullptr;
};
struct Attach {
  device::HandDevice* device = nullptr;
  int hand = 0;
};
struct Detach {
  device::HandDevice* device = nullptr;
};
struct Lead {
  int hand = 0;
  HandInput target;
};
struct Take {
  int hand = 0;
  std::uint8_t tool = 0;
};
struct Hold {
  InHand what = InHand::tool;
};
struct Swing {
  script::Swings swings;
};
struct TurnWheel {
  double rad_per_s = 0.0;
};
struct Water {
  bool held = false;
};
struct Fire {  ///< Charcoal hangs inside the pot.
  bool hangs = false;
};
struct Renew {};
struct Restore {};
struct Pause {
  bool on = false;
};
struct Show {};  ///< The pot is only shown: no visitor's device works on it.
struct Harden {  ///< nullptr: the clay is soft again. The old wall is returned.
  force::LeatherOutline* wall = nullptr;
};
struct Decorate {
  force::DecoratingTool tool;
  force::LeatherTurn turn;
};
struct ClearFaults {
  std::uint32_t which = 0;
};
}  // namespace command

using Command =
    std::variant<command::GiveBack, command::Put, command::Play, command::Attach, command::Detach,
                 command::Lead, command::Take, command::Hold, command::Swing, command::TurnWheel,
                 command::Water, command::Fire, command::Renew, command::Restore, command::Pause,
                 command::Show, command::Harden, command::Decorate, command::ClearFaults>;
static_assert(std::is_trivially_copyable_v<Command>, "the queue moves it without a thought");

}  // namespace onggi::loop
