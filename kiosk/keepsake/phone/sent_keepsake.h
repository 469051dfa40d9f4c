#pragma once

#include "kiosk/ground/web/message.h"
#include "kiosk/keepsake/souvenir/open_passes.h"

namespace onggi::phone {

/// `opened`, as it is sent: its own bytes, or an STL that is made of them.
web::SentFile sent(souvenir::KeepsakeFile opened);

}  // namespace onggi::phone
